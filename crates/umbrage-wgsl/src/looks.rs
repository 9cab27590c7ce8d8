//! What the passes know that fit views to the camera's depth, as bytes, and what they chose: under
//! [`Fit::Sample`](umbrage_core::Fit::Sample). Mirrors `shaders/samples/looks.wgsl`.

use encase::{ShaderSize, ShaderType, StorageBuffer};
use glam::{DVec2, DVec3, Mat3, Mat4, UVec3, Vec3, Vec4};
use umbrage_core::{Camera, ChosenRectangle, RUNGS_AN_OCTAVE, SampleRegion, ShadowPlan, ShadowView};

use crate::contact_camera::picture_height;
use crate::shared::shared_with_shaders;

shared_with_shaders! {
    struct Look {
        rights: Mat3,
        ups: Mat3,
        bounds: [Vec4; 3],
        steps: UVec3,
        is_fitted: u32,
        depth_start: f32,
        depth_end: f32,
        padding: f32,
        min_side: f32,
    }
}

shared_with_shaders! {
    struct Looks {
        world_from_clip: Mat4,
        depth_row: Vec4,
        moved: Vec3,
        picture_height: f32,
        view_count: u32,
        #[shader(size(runtime))]
        views: Vec<Look>,
    }
}

shared_with_shaders! {
    #[derive(Copy)]
    struct Axis {
        rung: i32,
        index: i32,
        base: i32,
        phase: f32,
        late: u32,
        late_rung: i32,
    }
}

shared_with_shaders! {
    #[derive(Copy)]
    struct Choice {
        turn: u32,
        x: Axis,
        y: Axis,
    }
}

shared_with_shaders! {
    struct Choices {
        nearest: f32,
        farthest: f32,
        #[shader(size(runtime))]
        views: Vec<Choice>,
    }
}

/// Numbers that are seen of a view: `UMBRAGE_SEEN` of the shader.
pub(crate) const SEEN: u64 = 14;

/// Bytes of the buffer of what is seen of so many views.
pub fn seen_size(views: u32) -> u64 {
    4 * SEEN * u64::from(views.max(1))
}

/// Writes what the passes are told into bytes that are kept from one frame to the next.
#[derive(Clone, Debug, Default)]
pub struct LookBytes {
    looks: Looks,
    bytes: Vec<u8>,
}

impl LookBytes {
    /// Bytes of the storage buffer that holds what is told of so many views.
    pub fn size(views: u32) -> u64 {
        Looks::min_size().get() + u64::from(views.max(1) - 1) * Look::SHADER_SIZE.get()
    }

    /// Writes what a shader calls `umbrage_looks`, and returns its bytes. `camera` is the one whose depth is looked at, `origin` what
    /// positions are relative to, and `before` what they were relative to a frame ago.
    pub fn write(&mut self, plan: &ShadowPlan, camera: &Camera, origin: DVec3, before: DVec3) -> &[u8] {
        let seen = camera.relative_to(origin);
        let clip_from_world = seen.clip_from_world();
        let forward = seen.forward();
        let looks = &mut self.looks;
        looks.world_from_clip = clip_from_world.as_dmat4().inverse().as_mat4();
        looks.depth_row = forward.extend(-forward.dot(seen.eye()));
        looks.moved = (origin - before).as_vec3();
        looks.picture_height = picture_height(&seen);
        looks.view_count = plan.views().len() as u32;
        looks.views.clear();
        looks.views.extend(plan.views().iter().map(|view| look(view, origin)));
        let written = self.looks.size().get() as usize;
        match StorageBuffer::new(&mut self.bytes).write(&self.looks) {
            Ok(()) => &self.bytes[..written],
            // A vector grows as it is written, so there is no error to report.
            Err(error) => unreachable!("a growing buffer refused what is looked at: {error}"),
        }
    }
}

fn look(view: &ShadowView, origin: DVec3) -> Look {
    let Some(SampleRegion { depths, padding, min_side, turns }) = &view.samples else {
        return Look::default();
    };
    let axes = |axis: [DVec3; 3]| {
        let [x, y, z] = axis.map(|axis| axis.as_vec3());
        Mat3::from_cols(x, y, z)
    };
    let bounds = turns.map(|turn| {
        let from = DVec2::new(turn.right.dot(origin), turn.up.dot(origin));
        let (min, max) = ((turn.min - from).as_vec2(), (turn.max - from).as_vec2());
        Vec4::new(min.x, min.y, max.x, max.y)
    });
    Look {
        rights: axes(turns.map(|turn| turn.right)),
        ups: axes(turns.map(|turn| turn.up)),
        bounds,
        steps: UVec3::from_array(turns.map(|turn| turn.steps)),
        is_fitted: 1,
        depth_start: depths.start as f32,
        depth_end: depths.end as f32,
        padding: *padding as f32,
        min_side: *min_side as f32,
    }
}

/// What the passes chose for a frame, read back.
#[derive(Clone, Debug)]
pub struct ReadChoices(Choices);

impl ReadChoices {
    /// Bytes of the storage buffer that holds what is chosen for so many views. All zero says that nothing was.
    pub fn size(views: u32) -> u64 {
        Choices::min_size().get() + u64::from(views.max(1) - 1) * Choice::SHADER_SIZE.get()
    }

    /// Reads them from the bytes of such a buffer; `None` where there are too few.
    pub fn of(bytes: &[u8]) -> Option<Self> {
        StorageBuffer::new(bytes).create().ok().map(Self)
    }

    /// Returns the least and the greatest view depth that was seen of all views that are fitted, metres; `None` where nothing was.
    pub fn depths(&self) -> Option<[f32; 2]> {
        let Choices { nearest, farthest, .. } = self.0;
        (nearest > 0.0 && nearest <= farthest).then_some([nearest, farthest])
    }

    /// Returns what was chosen for a view of the plan that the passes were told of, with the origin of then; `None` where the view is as
    /// it was planned.
    pub fn rectangle(&self, view: &ShadowView, origin: DVec3) -> Option<ChosenRectangle> {
        let choice = self.0.views.get(view.index)?;
        let turns = &view.samples.as_ref()?.turns;
        let turn = turns.iter().find(|turn| choice.turn == turn.steps + 1)?;
        let side = |axis: &Axis| (f64::from(axis.rung) / f64::from(RUNGS_AN_OCTAVE)).exp2();
        let place = |axis: &Axis| {
            let texel = side(axis) / f64::from(view.tile.size);
            texel * (f64::from(axis.phase) + f64::from(axis.index))
        };
        let from = DVec2::new(turn.right.dot(origin), turn.up.dot(origin));
        Some(ChosenRectangle {
            right: turn.right,
            up: turn.up,
            centre: from + DVec2::new(place(&choice.x), place(&choice.y)),
            sides: DVec2::new(side(&choice.x), side(&choice.y)),
        })
    }
}
