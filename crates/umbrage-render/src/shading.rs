//! Shading a frame: the camera's depth where contact shadows want it, receivers, then the sky; pipelines made when they are
//! first needed, and kept by what they depend on.

use umbrage::Shadows;

use crate::drawn::Planned;
use crate::draws::Draw;
use crate::error::RenderError;
use crate::frame::Show;
use crate::gpu::Gpu;
use crate::light::FrameLight;
use crate::passes::given::Given;
use crate::passes::prepass::Prepass;
use crate::passes::receivers::Receivers;
use crate::passes::sky::Sky;
use crate::scene_buffers::SceneBuffers;
use crate::scene_uniform::{Exposed, SceneUniform, View};
use crate::shaders::{Look, Visibility};
use crate::surroundings::Surroundings;
use crate::target::{Encoding, Target};
use crate::timing::{PassTimer, SHADE};

/// What a pipeline that draws into targets depends on beside its shader.
type Kind = (Encoding, u32);

/// The passes that make a picture of a scene whose shadow maps are drawn.
#[derive(Debug)]
pub(crate) struct Shading {
    uniform: SceneUniform,
    /// They depend on the settings of shadows too.
    receivers: Vec<(Look, Kind, Receivers)>,
    skies: Vec<(Kind, Sky)>,
    prepass: Option<Prepass>,
    given: Option<Given>,
    metered: Metered,
}

/// What was metered last: lights that stay are metered once.
#[derive(Debug, Default)]
struct Metered {
    lights: Vec<FrameLight>,
    lux: Option<f32>,
}

impl Metered {
    /// The illuminance to expose for under these lights, lux.
    fn of(&mut self, surroundings: &Surroundings, lights: &[FrameLight]) -> f32 {
        if let Some(lux) = self.lux.filter(|_| self.lights == lights) {
            return lux;
        }
        let lux = surroundings.asks_for(lights);
        self.lights.clear();
        self.lights.extend(lights);
        *self.lux.insert(lux)
    }
}

/// What is shaded, and with what.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Inputs<'a> {
    pub gpu: &'a Gpu,
    pub scene: &'a SceneBuffers,
    pub shadows: &'a Shadows,
}

impl Shading {
    pub fn new(gpu: &Gpu, scene: &SceneBuffers) -> Result<Self, RenderError> {
        let uniform = SceneUniform::new(gpu, &scene.placement, &scene.surroundings.environment)?;
        Ok(Self {
            uniform,
            receivers: Vec::new(),
            skies: Vec::new(),
            prepass: None,
            given: None,
            metered: Metered::default(),
        })
    }

    /// Forgets what depends on the shaders' text and on the bind group of shadows.
    pub fn forget_receivers(&mut self) {
        self.receivers.clear();
    }

    /// Makes what a picture needs and there is not yet.
    pub fn make_ready(
        &mut self,
        Inputs { gpu, scene, shadows }: Inputs<'_>,
        show: &Show,
        target: &Target,
        size: [u32; 2],
    ) -> Result<(), RenderError> {
        let kind = (target.shape.encoding, target.shape.samples);
        if !self.skies.iter().any(|(of, _)| *of == kind) {
            let around = scene.surroundings.around;
            self.skies.push((kind, Sky::new(gpu, &self.uniform, around, kind.0, kind.1)));
        }
        let Some(look) = Look::of(show) else { return Ok(()) };
        let extra = match look.visibility(shadows.settings().contact.is_some()) {
            Visibility::Unused | Visibility::Full | Visibility::Maps => None,
            Visibility::Given => Some(match &mut self.given {
                Some(given) => &given.layout,
                none => &none.insert(Given::new(gpu)?).layout,
            }),
            Visibility::MapsAndContact => {
                let make = || Prepass::new(gpu, (&self.uniform, scene), size);
                let prepass = self.prepass.get_or_insert_with(make);
                prepass.resize(gpu, size);
                Some(prepass.layout())
            }
        };
        if !self.receivers.iter().any(|(of, made_for, _)| (*of, *made_for) == (look, kind)) {
            let made = Receivers::new(gpu, look, kind, (&self.uniform, scene, shadows), extra);
            self.receivers.push((look, kind, made));
        }
        Ok(())
    }

    /// Draws a picture into a target, after [`Self::make_ready`] for the same.
    pub fn record(
        &mut self,
        Inputs { gpu, scene, shadows }: Inputs<'_>,
        encoder: &mut wgpu::CommandEncoder,
        timer: &PassTimer,
        planned: &Planned,
        show: &Show,
        target: &Target,
    ) -> Result<(), RenderError> {
        let Planned { camera, origin, lights, size, numbers, exposure, haze, .. } = planned;
        let shown_light = if let Show::Visibility(light) = show { *light } else { 0 };
        // Visibility is not exposed.
        let metered = match target.shape.encoding {
            Encoding::Srgb => self.metered.of(&scene.surroundings, lights),
            Encoding::Linear => 1.0,
        };
        let exposed = Exposed { metered, factor: exposure.factor(metered) };
        let haze = if *haze { scene.surroundings.haze } else { 0.0 };
        let environment = &scene.surroundings.environment;
        let view =
            View { camera, origin: *origin, lights, size: *size, shown_light, exposed, haze, environment };
        self.uniform.upload(gpu, &view)?;
        if let (Show::Given(visibility), Some(given)) = (show, &mut self.given) {
            given.upload(gpu, visibility)?;
        }
        let look = Look::of(show);
        let (draws, veils): (&[Draw], &[Draw]) =
            if look.is_some() { (planned.receivers(), planned.veils()) } else { (&[], &[]) };
        let visibility = look.map(|look| look.visibility(shadows.settings().contact.is_some()));
        let extra = match visibility {
            None | Some(Visibility::Unused | Visibility::Full | Visibility::Maps) => None,
            Some(Visibility::Given) => self.given.as_ref().map(|given| &given.group),
            Some(Visibility::MapsAndContact) => self.prepass.as_ref().map(|prepass| {
                prepass.upload(gpu, &camera.relative_to(*origin));
                timer.pass(SHADE, encoder, |encoder, timestamps| {
                    let draws = [draws, veils];
                    prepass.record(encoder, timestamps, &self.uniform, scene, &numbers.buffer, draws);
                });
                prepass.group()
            }),
        };
        let kind = (target.shape.encoding, target.shape.samples);
        timer.pass(SHADE, encoder, |encoder, timestamps| {
            let mut pass = target.begin(encoder, timestamps);
            let receivers =
                self.receivers.iter().find(|(of, made_for, _)| (Some(*of), *made_for) == (look, kind));
            let record = |pass: &mut wgpu::RenderPass<'_>, draws: &[Draw]| {
                if let Some((_, _, receivers)) = receivers {
                    let bound = (&self.uniform, scene, shadows);
                    receivers.record(pass, bound, extra, &numbers.buffer, draws);
                }
            };
            record(&mut pass, draws);
            if let Some((_, sky)) = self.skies.iter().find(|(of, _)| *of == kind) {
                sky.record(&mut pass, &self.uniform);
            }
            record(&mut pass, veils);
        });
        Ok(())
    }
}
