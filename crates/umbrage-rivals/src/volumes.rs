//! Shadow volumes: what a light does not reach is a body behind each caster, and a pixel is in shadow where it lies in one.
//!
//! Sources: F. Crow, *Shadow Algorithms for Computer Graphics*, SIGGRAPH 1977; counting behind what is seen (z-fail), which is
//! right wherever the camera stands, J. Carmack, 2000; C. Everitt, M. Kilgard, *Practical and Robust Stenciled Shadow Volumes
//! for Hardware-Accelerated Rendering*, 2002: with the far plane at infinity and caps no case is left.
//!
//! The body of a caster is the sum of the prisms behind its triangles that face away from the light. Whether one does is found
//! once, as a bit, so that caps and sides agree and the body is watertight. Triangles that face the light are in no cap: so no
//! lit surface lies on the border of a body, and none needs a bias to stay lit. A place is in as many prisms as triangles that face away
//! lie before it, and as the mesh is closed it is in shadow where that is one or more. A stencil of eight bits would count
//! 256 as none, so counts are summed in a texture of floats: they are exact up to 2²⁴, and where the device cannot blend floats of 32
//! bits ([`FLOAT32_BLENDABLE`](wgpu::Features::FLOAT32_BLENDABLE)) up to 2048.
//!
//! Parallel rays of a camera all end at one point at infinity, and do not say which volumes hold it. So for such a camera volumes end
//! beyond the box that it sees, and what lies before its nearest depth or beyond its farthest counts as lying there.
//!
//! A caster must be closed and rigid; of one that is solid in part, that part must be closed. Of a caster near a lamp, triangles that
//! lie within the lamp's near distance cast nothing; what lies within it in part casts whole.

mod passes;
mod placed;

use umbrage_render::Gpu;
use umbrage_scene::Scene;
use web_time::Instant;

use crate::buffers::Held;
use crate::by_light::{self, ByLight, OfLight, milliseconds_since};
use crate::canvas::{Canvas, Painter};
use crate::casters::Casters;
use crate::error::RivalError;
use crate::eye::Eye;
use crate::left::Left;
use crate::receivers::Receivers;
use crate::rival::{Rival, Seen, View};
use crate::shining::Shining;
use crate::shot::Shot;
use crate::stopwatch::Stopwatch;
use passes::Passes;

/// The shadow volumes of a scene.
#[derive(Debug)]
pub(crate) struct Volumes {
    gpu: Gpu,
    left: Vec<Left>,
    held: Held,
    receivers: Receivers,
    painter: Painter,
    canvas: Option<Canvas>,
    passes: Passes,
    stopwatch: Stopwatch,
}

impl Volumes {
    /// Makes the volumes of a scene ready.
    pub fn new(gpu: &Gpu, scene: &Scene) -> Result<Self, RivalError> {
        let mut held = Held::new(gpu);
        let casters = Casters::of(scene, |shell| (!shell.closed).then_some("its mesh is open"));
        let painter = Painter::new(gpu);
        let left = casters.left.clone();
        let passes = Passes::new(gpu, &mut held, casters, &painter.shot)?;
        Ok(Self {
            gpu: gpu.clone(),
            left,
            held,
            receivers: Receivers::new(gpu, scene)?,
            painter,
            canvas: None,
            passes,
            stopwatch: Stopwatch::new(gpu),
        })
    }
}

impl ByLight for Volumes {
    fn parts(&mut self) -> (&Gpu, &mut Receivers) {
        (&self.gpu, &mut self.receivers)
    }

    fn light(
        &mut self,
        eye: &Eye,
        light: &Shining,
        view: &View<'_>,
        seen: &wgpu::TextureView,
    ) -> Result<OfLight, RivalError> {
        let start = Instant::now();
        let Self { gpu, painter, canvas, passes, stopwatch, .. } = self;
        let canvas = match canvas.take().filter(|canvas| canvas.size == view.size) {
            Some(same) => canvas.insert(same),
            None => canvas.insert(painter.canvas(gpu, view.size)?),
        };
        Shot::new(eye, light).write(gpu, &painter.shot);
        passes.place(gpu, eye, light, view.pose);
        let descriptor = wgpu::CommandEncoderDescriptor { label: Some("Volumes::light") };
        let mut encoder = gpu.device.create_command_encoder(&descriptor);
        passes.find(&mut encoder, stopwatch.starts());
        passes.draw(&mut painter.count(gpu, &mut encoder, canvas, seen, None), eye);
        painter.shadow(gpu, &mut encoder, canvas, seen, stopwatch.stops());
        let times = stopwatch.resolve(gpu, &mut encoder);
        let copy = canvas.copy(gpu, &mut encoder)?;
        gpu.queue.submit([encoder.finish()]);
        let listing = milliseconds_since(start);
        let visibility = canvas.read(gpu, copy)?.into_iter().map(Some).collect();
        let on_device = times.map(|times| Stopwatch::read(gpu, times)).transpose()?;
        Ok(OfLight { visibility, listing, on_device })
    }
}

impl Rival for Volumes {
    fn left(&self) -> &[Left] {
        &self.left
    }

    fn bytes(&self) -> u64 {
        self.held.bytes() + self.canvas.as_ref().map_or(0, Canvas::bytes)
    }

    fn see(&mut self, view: &View<'_>) -> Result<Seen, RivalError> {
        let eye = Eye::new(view.camera, view.size)?;
        by_light::see(self, &eye, view)
    }
}
