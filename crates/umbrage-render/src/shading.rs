//! Shading a frame: the camera's depth where that pays or contact shadows want it, receivers, then the sky; pipelines made when
//! they are first needed, and kept by what they depend on.

use umbrage::Shadows;

use crate::drawn::Planned;
use crate::draws::Draw;
use crate::error::RenderError;
use crate::frame::Show;
use crate::gpu::Gpu;
use crate::light::FrameLight;
use crate::passes::contact_depth::ContactDepth;
use crate::passes::given::Given;
use crate::passes::prepass::Prepass;
use crate::passes::receivers::Receivers;
use crate::passes::sky::Sky;
use crate::scene_buffers::SceneBuffers;
use crate::scene_uniform::{Exposed, SceneUniform, View};
use crate::shaders::{Look, Visibility};
use crate::surroundings::Surroundings;
use crate::target::{DepthBefore, Encoding, Target};
use crate::timing::{PassTimer, SHADE};

/// What a pipeline that draws into targets depends on beside its shader.
type Kind = (Encoding, u32);

/// The passes that make a picture of a scene whose shadow maps are drawn.
#[derive(Debug)]
pub(crate) struct Shading {
    uniform: SceneUniform,
    /// They depend on whether the depth comes first, and on the settings of shadows too.
    receivers: Vec<((Look, Kind, bool), Receivers)>,
    skies: Vec<(Kind, Sky)>,
    prepasses: Vec<Prepass>,
    contact: Option<ContactDepth>,
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
            prepasses: Vec::new(),
            contact: None,
            given: None,
            metered: Metered::default(),
        })
    }

    /// Forgets what depends on the shaders' text and on the bind group of shadows.
    pub fn forget_receivers(&mut self) {
        self.receivers.clear();
    }

    /// Makes what a picture needs and there is not yet, whether its depth comes first or not.
    fn make_ready(
        &mut self,
        Inputs { gpu, scene, shadows }: Inputs<'_>,
        show: &Show,
        target: &Target,
        after_depth: bool,
    ) -> Result<(), RenderError> {
        let kind = (target.shape.encoding, target.shape.samples);
        if !self.skies.iter().any(|(of, _)| *of == kind) {
            let around = scene.surroundings.around;
            self.skies.push((kind, Sky::new(gpu, &self.uniform, around, kind.0, kind.1)));
        }
        let Some(look) = Look::of(show) else { return Ok(()) };
        let mut samples_of_depth = vec![];
        if after_depth {
            samples_of_depth.push(kind.1);
        }
        let extra = match look.visibility(shadows.settings().contact.is_some()) {
            Visibility::Unused | Visibility::Full | Visibility::Maps => None,
            Visibility::Given => Some(match &mut self.given {
                Some(given) => &given.layout,
                none => &none.insert(Given::new(gpu)?).layout,
            }),
            Visibility::MapsAndContact => {
                samples_of_depth.push(1);
                let contact = self.contact.get_or_insert_with(|| ContactDepth::new(gpu));
                contact.make_ready(gpu, target);
                Some(contact.layout())
            }
        };
        for samples in samples_of_depth {
            if self.prepasses.iter().all(|prepass| prepass.samples != samples) {
                self.prepasses.push(Prepass::new(gpu, (&self.uniform, scene), samples));
            }
        }
        let of = (look, kind, after_depth);
        if !self.receivers.iter().any(|(made_for, _)| *made_for == of) {
            let bound = (&self.uniform, scene, shadows);
            self.receivers.push((of, Receivers::new(gpu, look, kind, after_depth, bound, extra)));
        }
        Ok(())
    }

    /// Draws a picture into a target.
    pub fn record(
        &mut self,
        inputs: Inputs<'_>,
        encoder: &mut wgpu::CommandEncoder,
        timer: &PassTimer,
        planned: &Planned,
        show: &Show,
        target: &Target,
    ) -> Result<(), RenderError> {
        let Inputs { gpu, scene, shadows } = inputs;
        let look = Look::of(show);
        let visibility = look.map(|look| look.visibility(shadows.settings().contact.is_some()));
        let after_depth = comes_depth_first(planned, visibility, target);
        self.make_ready(inputs, show, target, after_depth)?;
        self.upload(gpu, scene, planned, show, target)?;
        let (draws, veils): (&[Draw], &[Draw]) =
            if look.is_some() { (planned.receivers(), planned.veils()) } else { (&[], &[]) };
        // Veils that a look cuts out are as solid as the rest.
        let cut_veils = if look.is_some_and(Look::blends) { &[] } else { veils };
        let numbers = &planned.numbers.buffer;
        let mut draw_depth = |depth: &wgpu::TextureView, samples: u32| {
            let Some(prepass) = self.prepasses.iter().find(|prepass| prepass.samples == samples) else {
                return;
            };
            timer.pass(SHADE, encoder, |encoder, timestamps| {
                let bound = (&self.uniform, scene);
                prepass.record(encoder, depth, timestamps, bound, numbers, [draws, cut_veils]);
            });
        };
        let samples = target.shape.samples;
        if after_depth {
            draw_depth(&target.depth, samples);
        }
        let extra = match visibility {
            None | Some(Visibility::Unused | Visibility::Full | Visibility::Maps) => None,
            Some(Visibility::Given) => self.given.as_ref().map(|given| &given.group),
            Some(Visibility::MapsAndContact) => self.contact.as_ref().and_then(|contact| {
                contact.upload(gpu, &planned.camera.relative_to(planned.origin));
                if samples > 1 {
                    draw_depth(contact.depth(target), 1);
                }
                contact.group(target)
            }),
        };
        let before = match (after_depth, samples) {
            (false, _) => DepthBefore::Nothing,
            (true, 1) => DepthBefore::All,
            (true, _) => DepthBefore::Some,
        };
        let kind = (target.shape.encoding, samples);
        timer.pass(SHADE, encoder, |encoder, timestamps| {
            let mut pass = target.begin(encoder, before, timestamps);
            let of = look.map(|look| (look, kind, after_depth));
            let receivers = self.receivers.iter().find(|(made_for, _)| Some(*made_for) == of);
            let record = |pass: &mut wgpu::RenderPass<'_>, draws: &[Draw]| {
                if let Some((_, receivers)) = receivers {
                    let bound = (&self.uniform, scene, shadows);
                    receivers.record(pass, bound, extra, numbers, draws);
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

    /// Tells the device what all passes over the scene read.
    fn upload(
        &mut self,
        gpu: &Gpu,
        scene: &SceneBuffers,
        planned: &Planned,
        show: &Show,
        target: &Target,
    ) -> Result<(), RenderError> {
        let Planned { camera, origin, lights, size, exposure, haze, .. } = planned;
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
        Ok(())
    }
}

/// Whether the depth of what is seen is drawn before it is shaded. Contact shadows read it; and it pays where the triangles
/// that are drawn twice are fewer than the fragments that may be hidden, of which each asks for the visibility of all lights.
fn comes_depth_first(planned: &Planned, visibility: Option<Visibility>, target: &Target) -> bool {
    let lookups = match visibility {
        None => return false,
        Some(Visibility::MapsAndContact) if target.shape.samples == 1 => return true,
        Some(Visibility::MapsAndContact | Visibility::Maps) => planned.plan.lights().len() as u64,
        Some(Visibility::Unused | Visibility::Full | Visibility::Given) => 0,
    };
    let pixels = u64::from(target.shape.size[0]) * u64::from(target.shape.size[1]);
    let triangles: u64 = planned.receivers().iter().map(Draw::triangles).sum();
    2 * triangles <= pixels * (1 + 2 * lookups)
}
