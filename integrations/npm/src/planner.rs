//! The planner: boxes of the world are told once, and each frame is planned from a camera and lights.

use glam::{DVec3, Vec3};
use js_sys::{Reflect, Uint8Array};
use serde::Deserialize;
use umbrage_core::{Aabb, Bounds, Camera, Light, Settings, ShadowPlan, ShadowView};
use umbrage_interchange::{CameraData, LightData, PlanData};
use umbrage_wgsl::{FrameBytes, Surroundings};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::{JsValue, wasm_bindgen};

use crate::objects::{js_error, read, written};
use crate::settings_of;

/// Plans frames of one world.
#[wasm_bindgen]
#[derive(Debug)]
pub struct Planner {
    settings: Settings,
    bounds: Bounds,
    plan: Option<ShadowPlan>,
    frame: FrameBytes,
}

/// A frame to plan.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Frame {
    camera: CameraData,
    lights: Vec<LightData>,
    /// The size of the picture, pixels.
    picture: [u32; 2],
    /// The point of the world that the shaders' positions are relative to, metres.
    #[serde(default)]
    origin: [f64; 3],
}

#[wasm_bindgen]
impl Planner {
    /// Makes a planner of a world in which nothing is yet.
    ///
    /// # Errors
    /// When a setting is out of range.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "Settings")] settings: JsValue,
    ) -> Result<Self, JsError> {
        let settings = settings_of(settings)?;
        Ok(Self { settings, bounds: Bounds::new(Vec::new()), plan: None, frame: FrameBytes::default() })
    }

    /// Changes the settings, from the next plan on.
    ///
    /// # Errors
    /// When a setting is out of range.
    #[wasm_bindgen(js_name = setSettings)]
    pub fn set_settings(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Settings")] settings: JsValue,
    ) -> Result<(), JsError> {
        self.settings = settings_of(settings)?;
        Ok(())
    }

    /// Says what is in the world: six numbers a box, its smallest and then its largest x, y and z, metres. Everything that casts or
    /// receives lies in some box; one around all will do, and many make finer maps.
    ///
    /// # Errors
    /// When the numbers do not come in sixes.
    #[wasm_bindgen(js_name = setBoxes)]
    pub fn set_boxes(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Float32Array | number[]")] boxes: &[f32],
    ) -> Result<(), JsError> {
        let (sixes, rest) = boxes.as_chunks::<6>();
        if !rest.is_empty() {
            return Err(js_error(format!(
                "boxes should be six numbers each, the smallest and then the largest x, y and z: got {} numbers",
                boxes.len()
            )));
        }
        self.bounds = Bounds::new(sixes.iter().map(aabb).collect());
        Ok(())
    }

    /// Moves a box, by its number among those that were set.
    ///
    /// # Errors
    /// When there is no such box, or it is not six numbers.
    #[wasm_bindgen(js_name = moveBox)]
    pub fn move_box(
        &mut self,
        index: u32,
        #[wasm_bindgen(unchecked_param_type = "Float32Array | number[]")] corners: &[f32],
    ) -> Result<(), JsError> {
        let count = self.bounds.objects().len();
        if index as usize >= count {
            return Err(js_error(format!("there is no box {index}: {count} were set")));
        }
        let corners = corners.try_into().map_err(|_| {
            js_error(format!(
                "a box should be six numbers, its smallest and then its largest x, y and z: got {}",
                corners.len()
            ))
        })?;
        self.bounds.set([(index as usize, aabb(corners))]);
        Ok(())
    }

    /// Plans a frame: which maps there are, what each view shows, and the bytes of `umbrage_frame`.
    ///
    /// # Errors
    /// When a number is out of range, or a key is unknown.
    #[wasm_bindgen(unchecked_return_type = "Plan")]
    pub fn plan(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Frame")] frame: JsValue,
    ) -> Result<JsValue, JsError> {
        let Frame { camera, lights, picture, origin } = checked(read("frame", frame)?)?;
        let camera = Camera::try_from(&camera).map_err(js_error)?;
        let lights: Result<Vec<Light>, _> = lights.iter().map(Light::try_from).collect();
        self.replan(&camera, &lights.map_err(js_error)?)?;
        let plan = self.plan.as_ref().ok_or_else(nothing_planned)?;
        let object = written(&PlanData::new(plan, picture))?;
        let layout = plan.layout();
        let map_size = [layout.width, layout.height];
        let surroundings =
            Surroundings { map_size, picture_size: picture, origin: DVec3::from_array(origin) };
        let bytes = Uint8Array::from(self.frame.write(plan, &self.settings, &surroundings));
        // An object that was just made takes any key.
        let _ = Reflect::set(&object, &"frame".into(), &bytes);
        Ok(object)
    }

    /// Returns the numbers of the boxes that may cast into a view of the last plan, in no order.
    ///
    /// # Errors
    /// When nothing was planned, or the plan has no such view.
    pub fn casters(&self, view: u32) -> Result<Vec<u32>, JsError> {
        let views = self.plan.as_ref().ok_or_else(nothing_planned)?.views();
        let view: &ShadowView = views
            .get(view as usize)
            .ok_or_else(|| js_error(format!("there is no view {view}: the plan has {}", views.len())))?;
        let mut found = Vec::new();
        self.bounds.touching(&view.casters, |number| found.push(number));
        Ok(found)
    }
}

impl Planner {
    fn replan(&mut self, camera: &Camera, lights: &[Light]) -> Result<(), JsError> {
        let Self { settings, bounds, plan, .. } = self;
        match plan {
            Some(plan) => plan.replan(camera, lights, bounds, settings).map_err(js_error),
            None => {
                *plan = Some(umbrage_core::plan(camera, lights, bounds, settings).map_err(js_error)?);
                Ok(())
            }
        }
    }
}

fn nothing_planned() -> JsError {
    js_error("nothing is planned yet: call plan(…) first")
}

fn checked(frame: Frame) -> Result<Frame, JsError> {
    let Frame { picture: [width, height], origin, .. } = frame;
    if width == 0 || height == 0 {
        return Err(js_error(format!(
            "`picture` should be its size in pixels, 1 or more, got {width} × {height}"
        )));
    }
    if !origin.iter().all(|metres| metres.is_finite()) {
        return Err(js_error(format!("`origin` should be three finite coordinates, metres, got {origin:?}")));
    }
    Ok(frame)
}

fn aabb([x, y, z, to_x, to_y, to_z]: &[f32; 6]) -> Aabb {
    Aabb { min: Vec3::new(*x, *y, *z), max: Vec3::new(*to_x, *to_y, *to_z) }
}
