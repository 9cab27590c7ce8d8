//! A frame that was drawn: its picture, its plan, and whether the shadow maps are still its own.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use glam::DVec3;
use umbrage::{Camera, ShadowPlan, Share};
use umbrage_scene::Pose;

use crate::buffers::Growing;
use crate::draws::{Draw, DrawLists};
use crate::error::RenderError;
use crate::exposure::Exposure;
use crate::gpu::Gpu;
use crate::light::FrameLight;
use crate::picture::{ComingPicture, Picture};
use crate::target::Target;
use crate::timing::{FrameTimes, ViewLoad};

/// A frame that was handed to the device.
///
/// It owns its picture: no later frame is drawn into that while a `Drawn`, or a clone of it, is held. Release it, and a
/// later frame uses the texture again. The shadow maps are the renderer's, and a later frame is drawn into the same: what
/// reads maps ([`Renderer::query`](crate::Renderer::query), [`map_picture`](crate::Renderer::map_picture),
/// [`maps`](crate::Renderer::maps), [`show`](crate::Renderer::show)) takes the `Drawn`, and is refused with
/// [`RenderError::MapsGone`] when they are not its own any more.
#[derive(Clone, Debug)]
pub struct Drawn {
    gpu: Gpu,
    pub(crate) target: Arc<Target>,
    pub(crate) planned: Arc<Planned>,
}

/// A frame that was drawn and waited for.
#[derive(Clone, Debug)]
pub struct Rendered {
    /// The frame.
    pub drawn: Drawn,
    /// How long it took.
    pub times: FrameTimes,
}

/// A frame whose shadow maps are drawn, apart from the pictures of it.
#[derive(Debug)]
pub(crate) struct Planned {
    pub plan: ShadowPlan,
    pub camera: Camera,
    /// What positions on the device are relative to, in world space.
    pub origin: DVec3,
    pub lights: Vec<FrameLight>,
    pub pose: Arc<Pose>,
    pub size: [u32; 2],
    pub samples: u32,
    pub exposure: Exposure,
    pub haze: bool,
    /// Two lists for each of the plan's views, of what stands and of what moves; then one for the camera, and one of the veils
    /// before what that sees.
    pub lists: DrawLists,
    pub numbers: Growing,
    pub loads: Vec<ViewLoad>,
    /// How long planning, culling and upload took on the CPU.
    pub milliseconds: f64,
    /// What the maps are known by.
    pub maps: MapsId,
}

/// Tells one drawing of shadow maps from all others, of any renderer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct MapsId(u64);

impl MapsId {
    /// One that there was not before.
    pub fn new() -> Self {
        static NEXT: AtomicU64 = AtomicU64::new(0);
        Self(NEXT.fetch_add(1, Ordering::Relaxed))
    }
}

/// What stands among the casters of a view.
pub(crate) fn still(lists: &DrawLists, view: usize) -> &[Draw] {
    lists.view(2 * view)
}

/// What moves among the casters of a view.
pub(crate) fn moving(lists: &DrawLists, view: usize) -> &[Draw] {
    lists.view(2 * view + 1)
}

impl Planned {
    /// The casters of a share of a view, as two lists.
    pub fn casters(&self, view: usize, share: Share) -> [&[Draw]; 2] {
        match share {
            Share::All => [still(&self.lists, view), moving(&self.lists, view)],
            Share::Still => [still(&self.lists, view), &[]],
            Share::Moving => [&[], moving(&self.lists, view)],
        }
    }

    /// What the camera sees, but for veils.
    pub fn receivers(&self) -> &[Draw] {
        self.lists.view(2 * self.plan.views().len())
    }

    /// The veils before what the camera sees, the deepest first.
    pub fn veils(&self) -> &[Draw] {
        self.lists.view(2 * self.plan.views().len() + 1)
    }

    /// Whether there are shadows of a light.
    pub fn has_shadows_of(&self, light: usize) -> Result<(), RenderError> {
        let lights = self.plan.lights().len();
        if light < lights { Ok(()) } else { Err(RenderError::NoSuchLight { light, lights }) }
    }
}

impl Drawn {
    pub(crate) fn new(gpu: &Gpu, target: Arc<Target>, planned: Arc<Planned>) -> Self {
        Self { gpu: gpu.clone(), target, planned }
    }

    /// Returns the plan that it was drawn with; it has no views where there are no shadows.
    pub fn plan(&self) -> &ShadowPlan {
        &self.planned.plan
    }

    /// Returns what was drawn into each of the plan's views.
    pub fn loads(&self) -> &[ViewLoad] {
        &self.planned.loads
    }

    /// Returns how long planning, culling and upload took on the CPU, milliseconds.
    pub fn plan_milliseconds(&self) -> f64 {
        self.planned.milliseconds
    }

    /// Copies the picture to the CPU, and waits for it.
    ///
    /// # Errors
    /// When the picture exceeds the adapter's buffers, or the device fails.
    pub fn picture(&self) -> Result<Picture, RenderError> {
        self.target.read(&self.gpu)
    }

    /// Starts to copy the picture to the CPU without waiting: [`ComingPicture::take`] has it when it has come.
    ///
    /// # Errors
    /// When the picture exceeds the adapter's buffers.
    pub fn coming_picture(&self) -> Result<ComingPicture, RenderError> {
        self.target.request(&self.gpu)
    }

    /// Returns the picture as a window shows it: a texture of sRGB bytes, to be read as they are. Hold the `Drawn` as long
    /// as the texture is shown: without it a later frame may be drawn into the texture.
    ///
    /// # Errors
    /// When the adapter cannot show a picture so (GL).
    pub fn shown(&self) -> Result<wgpu::TextureView, RenderError> {
        let adapter = || self.gpu.adapter.name.clone();
        self.target.shown.clone().ok_or_else(|| RenderError::NoWindow { adapter: adapter() })
    }
}
