//! Shading a frame: the camera's depth where that pays or contact shadows want it, receivers, then the sky; pipelines made when
//! they are first needed, and kept by what they depend on.

use umbrage::{Resolve, Shadows};

use crate::cover::Cover;
use crate::drawn::Planned;
use crate::draws::Draw;
use crate::error::RenderError;
use crate::frame::Show;
use crate::gpu::Gpu;
use crate::light::FrameLight;
use crate::passes::contact_depth::{self, ContactDepth};
use crate::passes::given::Given;
use crate::passes::prepass::{Prepass, PrepassKind};
use crate::passes::receivers::Receivers;
use crate::passes::resolving::Resolving;
use crate::passes::sky::Sky;
use crate::scene_buffers::SceneBuffers;
use crate::scene_uniform::{Exposed, SceneUniform, View};
use crate::shaders::{Look, Visibility};
use crate::surroundings::Surroundings;
use crate::target::{DepthBefore, Encoding, Target};
use crate::timing::{PassTimer, SHADE};

/// What a pipeline that draws into targets depends on beside its shader.
type Kind = (Encoding, u32);

/// What is done before receivers are shaded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Before {
    /// Whether the depth of what is seen is drawn.
    depth: bool,
    /// Whether visibility is found for the whole picture.
    resolved: bool,
}

/// How a picture is drawn.
#[derive(Clone, Copy, Debug)]
struct How {
    /// How receivers look; `None` where there are none.
    look: Option<Look>,
    /// Where their visibility comes from.
    visibility: Option<Visibility>,
    before: Before,
    /// Whether the target has the depth of what is seen already.
    has_depth: bool,
}

/// The passes that make a picture of a scene whose shadow maps are drawn.
#[derive(Debug)]
pub(crate) struct Shading {
    uniform: SceneUniform,
    /// They depend on whether the depth comes first, and on the settings of shadows too.
    receivers: Vec<((Look, Kind, Before), Receivers)>,
    skies: Vec<(Kind, Sky)>,
    prepasses: Vec<Prepass>,
    contact: Option<ContactDepth>,
    /// The depth that shadows are fitted to where a target has none of one sample a pixel, with its size.
    seen: Option<([u32; 2], wgpu::TextureView)>,
    given: Option<Given>,
    /// It depends on the settings of shadows too.
    resolving: Option<Resolving>,
    /// Whether the last picture's visibility was found before it was shaded.
    resolved: bool,
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
            seen: None,
            given: None,
            resolving: None,
            resolved: false,
            metered: Metered::default(),
        })
    }

    /// Forgets what depends on the shaders' text and on the bind group of shadows.
    pub fn forget_receivers(&mut self) {
        self.receivers.clear();
        self.resolving = None;
        self.resolved = false;
    }

    /// How many receivers were traced for the last picture, one for each of its lights; `None` where they were traced while it was
    /// shaded, or none were.
    pub fn traced(&self, gpu: &Gpu) -> Result<Option<u32>, RenderError> {
        let resolving = self.resolving.as_ref().filter(|_| self.resolved);
        resolving.map_or(Ok(None), |resolving| resolving.traced(gpu))
    }

    /// Makes what a picture needs and there is not yet.
    fn make_ready(
        &mut self,
        Inputs { gpu, scene, shadows }: Inputs<'_>,
        show: &Show,
        target: &Target,
        before: Before,
    ) -> Result<(), RenderError> {
        let kind = (target.shape.encoding, target.shape.samples);
        if !self.skies.iter().any(|(of, _)| *of == kind) {
            let around = scene.surroundings.around;
            self.skies.push((kind, Sky::new(gpu, &self.uniform, around, kind.0, kind.1)));
        }
        let Some(look) = Look::of(show) else { return Ok(()) };
        if before.depth {
            let kind = PrepassKind { samples: kind.1, places: before.resolved };
            make_prepass(&mut self.prepasses, gpu, (&self.uniform, scene), kind);
        }
        let extra = match look.visibility(shadows.settings().contact.is_some(), before.resolved) {
            Visibility::Unused | Visibility::Full | Visibility::Maps => None,
            Visibility::Given => Some(match &mut self.given {
                Some(given) => &given.layout,
                none => &none.insert(Given::new(gpu)?).layout,
            }),
            Visibility::MapsAndContact => {
                make_prepass(&mut self.prepasses, gpu, (&self.uniform, scene), DEPTH_ALONE);
                let contact = self.contact.get_or_insert_with(|| ContactDepth::new(gpu));
                contact.make_ready(gpu, target);
                Some(contact.layout())
            }
            Visibility::Resolved => self.resolving.as_ref().map(|resolving| &resolving.layout),
        };
        let of = (look, kind, before);
        if !self.receivers.iter().any(|(made_for, _)| *made_for == of) {
            let bound = (&self.uniform, scene, shadows);
            self.receivers
                .push((of, Receivers::new(gpu, look, kind, (before.depth, before.resolved), bound, extra)));
        }
        Ok(())
    }

    /// Draws what a picture sees, one sample a pixel, before its shadows are drawn, and returns where: in the target, if that can
    /// hold it; then [`Self::record`] need not draw it again.
    pub fn see(
        &mut self,
        Inputs { gpu, scene, shadows: _ }: Inputs<'_>,
        encoder: &mut wgpu::CommandEncoder,
        timer: &PassTimer,
        planned: &Planned,
        show: &Show,
        target: &Target,
    ) -> Result<wgpu::TextureView, RenderError> {
        make_prepass(&mut self.prepasses, gpu, (&self.uniform, scene), DEPTH_ALONE);
        self.upload(gpu, scene, planned, show, target)?;
        let depth = if sees_in(target, planned) {
            target.depth.clone()
        } else {
            let (size, seen) = (planned.size, self.seen.take());
            let seen = seen.filter(|(of, _)| *of == size);
            self.seen.insert(seen.unwrap_or_else(|| (size, contact_depth::depth(gpu, size)))).1.clone()
        };
        let draws = with_depth(planned, Look::of(show));
        if let Some(prepass) = self.prepasses.iter().find(|prepass| prepass.kind == DEPTH_ALONE) {
            timer.pass(SHADE, encoder, |encoder, timestamps| {
                let bound = (&self.uniform, scene);
                prepass.record(encoder, (&depth, None), timestamps, bound, &planned.numbers.buffer, draws);
            });
        }
        Ok(depth)
    }

    /// Draws a picture into a target. `is_seen` says that [`Self::see`] was just called for the same.
    pub fn record(
        &mut self,
        inputs: Inputs<'_>,
        encoder: &mut wgpu::CommandEncoder,
        timer: &PassTimer,
        planned: &Planned,
        (show, is_seen): (&Show, bool),
        target: &Target,
    ) -> Result<(), RenderError> {
        let look = Look::of(show);
        let resolved = self.resolves(inputs, look, planned, target);
        self.resolved = resolved;
        let has_contact = inputs.shadows.settings().contact.is_some();
        let visibility = look.map(|look| look.visibility(has_contact, resolved));
        let has_depth = is_seen && look.is_some() && sees_in(target, planned) && !resolved;
        let depth = resolved || has_depth || comes_depth_first(planned, visibility, target);
        let how = How { look, visibility, before: Before { depth, resolved }, has_depth };
        self.make_ready(inputs, show, target, how.before)?;
        self.upload(inputs.gpu, inputs.scene, planned, show, target)?;
        self.record_before(inputs, encoder, timer, planned, how, target);
        self.record_shading(inputs, encoder, timer, planned, how, target);
        Ok(())
    }

    /// Draws what a picture is shaded after: the depth of what is seen, how much of each light reaches it where that is found for
    /// the whole picture, and the depth that contact shadows march through.
    fn record_before(
        &mut self,
        Inputs { gpu, scene, shadows }: Inputs<'_>,
        encoder: &mut wgpu::CommandEncoder,
        timer: &PassTimer,
        planned: &Planned,
        How { look, visibility, before, has_depth }: How,
        target: &Target,
    ) {
        let Self { uniform, prepasses, resolving, contact, .. } = self;
        let mut draw = |into: (&wgpu::TextureView, Option<&wgpu::TextureView>), kind: PrepassKind| {
            let Some(prepass) = prepasses.iter().find(|prepass| prepass.kind == kind) else { return };
            timer.pass(SHADE, encoder, |encoder, timestamps| {
                let (bound, numbers) = ((&*uniform, scene), &planned.numbers.buffer);
                prepass.record(encoder, into, timestamps, bound, numbers, with_depth(planned, look));
            });
        };
        let samples = target.shape.samples;
        let resolving = resolving.as_mut().filter(|_| before.resolved);
        if let Some(contact) = contact.as_ref().filter(|_| visibility == Some(Visibility::MapsAndContact)) {
            contact.upload(gpu, &planned.camera.relative_to(planned.origin));
            if samples > 1 {
                draw((contact.depth(target), None), DEPTH_ALONE);
            }
        }
        if let Some(resolving) = resolving {
            let places = resolving.places(gpu, target.shape.size);
            draw((&target.depth, Some(places)), PrepassKind { samples, places: true });
            let lights = planned.plan.lights().len();
            timer.compute_pass(SHADE, encoder, |encoder, timestamps| {
                resolving.record(gpu, encoder, shadows, lights, timestamps);
            });
        } else if before.depth && !has_depth {
            draw((&target.depth, None), PrepassKind { samples, places: false });
        }
    }

    /// Draws receivers, the sky, and veils over both.
    fn record_shading(
        &self,
        Inputs { gpu: _, scene, shadows }: Inputs<'_>,
        encoder: &mut wgpu::CommandEncoder,
        timer: &PassTimer,
        planned: &Planned,
        How { look, visibility, before, .. }: How,
        target: &Target,
    ) {
        let (draws, veils): (&[Draw], &[Draw]) =
            if look.is_some() { (planned.receivers(), planned.veils()) } else { (&[], &[]) };
        let extra = match visibility {
            None | Some(Visibility::Unused | Visibility::Full | Visibility::Maps) => None,
            Some(Visibility::Resolved) => self.resolving.as_ref().and_then(Resolving::group),
            Some(Visibility::Given) => self.given.as_ref().map(|given| &given.group),
            Some(Visibility::MapsAndContact) => {
                self.contact.as_ref().and_then(|contact| contact.group(target))
            }
        };
        let samples = target.shape.samples;
        let depth_before = match (before.depth, samples) {
            (false, _) => DepthBefore::Nothing,
            (true, 1) => DepthBefore::All,
            (true, _) => DepthBefore::Some,
        };
        let kind = (target.shape.encoding, samples);
        timer.pass(SHADE, encoder, |encoder, timestamps| {
            let mut pass = target.begin(encoder, depth_before, timestamps);
            let of = look.map(|look| (look, kind, before));
            let receivers = self.receivers.iter().find(|(made_for, _)| Some(*made_for) == of);
            let record = |pass: &mut wgpu::RenderPass<'_>, draws: &[Draw]| {
                if let Some((_, receivers)) = receivers {
                    let bound = (&self.uniform, scene, shadows);
                    receivers.record(pass, bound, extra, &planned.numbers.buffer, draws);
                }
            };
            record(&mut pass, draws);
            if let Some((_, sky)) = self.skies.iter().find(|(of, _)| *of == kind) {
                sky.record(&mut pass, &self.uniform);
            }
            record(&mut pass, veils);
        });
    }

    /// Whether visibility is found for the whole picture before it is shaded: where some receivers are traced, a pixel is one
    /// receiver, and each surface hides what is behind it. Makes the steps for that.
    fn resolves(
        &mut self,
        Inputs { gpu, scene, shadows }: Inputs<'_>,
        look: Option<Look>,
        planned: &Planned,
        target: &Target,
    ) -> bool {
        let traces = shadows.key().traces() && shadows.settings().contact.is_none();
        let asks = look.is_some_and(|look| look.visibility(false, false) == Visibility::Maps);
        let is_whole = target.shape.samples == 1
            && (!scene.covers.contains(&Cover::Veil) || look.is_some_and(|look| !look.blends()));
        let lights = planned.plan.lights().len();
        let has_room = Resolve::has_room(&gpu.device, target.shape.size, lights);
        let wanted = traces && asks && is_whole && lights > 0 && has_room;
        if wanted && self.resolving.is_none() {
            self.resolving = Resolving::new(gpu, shadows);
        }
        wanted && self.resolving.is_some()
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

/// What the depth of a frame holds: what is seen, and the veils where a look cuts them out, so that they are as solid.
fn with_depth(planned: &Planned, look: Option<Look>) -> [&[Draw]; 2] {
    [planned.receivers(), if look.is_some_and(Look::blends) { &[] } else { planned.veils() }]
}

/// The depth of one sample a pixel, and nothing beside it.
const DEPTH_ALONE: PrepassKind = PrepassKind { samples: 1, places: false };

/// Makes the pipelines of a kind where there are none.
fn make_prepass(
    prepasses: &mut Vec<Prepass>,
    gpu: &Gpu,
    bound: (&SceneUniform, &SceneBuffers),
    kind: PrepassKind,
) {
    if prepasses.iter().all(|prepass| prepass.kind != kind) {
        prepasses.push(Prepass::new(gpu, bound, kind));
    }
}

/// Whether a target can hold the depth that shadows are fitted to.
fn sees_in(target: &Target, planned: &Planned) -> bool {
    target.shape.samples == 1 && target.shape.size == planned.size
}

/// Whether the depth of what is seen is drawn before it is shaded. Contact shadows read it; and it pays where the triangles
/// that are drawn twice are fewer than the fragments that may be hidden, of which each asks for the visibility of all lights.
fn comes_depth_first(planned: &Planned, visibility: Option<Visibility>, target: &Target) -> bool {
    let lookups = match visibility {
        None => return false,
        Some(Visibility::MapsAndContact) if target.shape.samples == 1 => return true,
        Some(Visibility::MapsAndContact | Visibility::Maps) => planned.plan.lights().len() as u64,
        Some(Visibility::Unused | Visibility::Full | Visibility::Given | Visibility::Resolved) => 0,
    };
    let pixels = u64::from(target.shape.size[0]) * u64::from(target.shape.size[1]);
    let triangles: u64 = planned.receivers().iter().map(Draw::triangles).sum();
    2 * triangles <= pixels * (1 + 2 * lookups)
}
