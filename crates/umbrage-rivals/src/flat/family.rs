//! A family whose shadows are flat casters, drawn in one way or several, one after the other.

use umbrage_render::Gpu;
use umbrage_scene::Scene;
use web_time::Instant;

use super::draws::{Draws, Thing, Way};
use crate::buffers::Held;
use crate::by_light::{self, ByLight, OfLight, milliseconds_since};
use crate::casters::Casters;
use crate::error::RivalError;
use crate::eye::Eye;
use crate::floors::{Floor, Marker, Marks};
use crate::left::Left;
use crate::planes::{Plane, planes};
use crate::receivers::Receivers;
use crate::rival::{Rival, Seen, View};
use crate::shining::Shining;
use crate::shot::Shot;
use crate::stopwatch::Stopwatch;

/// The flat shadows of a scene.
#[derive(Debug)]
pub(crate) struct Flattened {
    gpu: Gpu,
    planes: Vec<Plane>,
    left: Vec<Left>,
    held: Held,
    receivers: Receivers,
    marker: Marker,
    marks: Option<Marks>,
    draws: Draws,
    ways: Vec<Way>,
    stopwatch: Stopwatch,
    /// Half the angle that a sun is seen under, in radians, and a lamp's radius, in metres; 0 where it counts for nothing.
    size: f32,
}

impl Flattened {
    pub fn new(
        gpu: &Gpu,
        scene: &Scene,
        thing: Thing,
        ways: Vec<Way>,
        size: f32,
    ) -> Result<Self, RivalError> {
        let mut held = Held::new(gpu);
        let casters = Casters::of(scene, |_| None);
        Ok(Self {
            gpu: gpu.clone(),
            planes: planes(scene),
            left: casters.left.clone(),
            draws: Draws::new(&mut held, casters, thing)?,
            held,
            receivers: Receivers::new(gpu, scene)?,
            marker: Marker::new(gpu),
            marks: None,
            ways,
            stopwatch: Stopwatch::new(gpu),
            size,
        })
    }
}

impl ByLight for Flattened {
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
        let Self { gpu, planes, held, marker, marks, draws, ways, stopwatch, size, .. } = self;
        let marks = match marks.take().filter(|marks| marks.size == view.size) {
            Some(same) => marks.insert(same),
            None => marks.insert(marker.marks(gpu, view.size)?),
        };
        let floors = Floor::of(planes, eye, light);
        let size = if light.is_sun() { size.tan() } else { *size };
        Shot::new(eye, light).with_size(size).write(gpu, &marker.shot);
        marker.upload(gpu, &floors);
        draws.list(gpu, held, (eye, light, view.pose), &floors)?;
        let descriptor = wgpu::CommandEncoderDescriptor { label: Some("Flattened::light") };
        let mut encoder = gpu.device.create_command_encoder(&descriptor);
        marker.mark(gpu, &mut encoder, marks, seen, stopwatch.starts_drawing());
        {
            let mut pass = marks.draw(&mut encoder, stopwatch.stops());
            for way in ways {
                draws.draw(gpu, &mut pass, way, (&marker.shot, seen, marks));
            }
        }
        let times = stopwatch.resolve(gpu, &mut encoder);
        let copies = marks.copy(gpu, &mut encoder)?;
        gpu.queue.submit([encoder.finish()]);
        let listing = milliseconds_since(start);
        let visibility = marks.read(gpu, copies)?;
        let on_device = times.map(|times| Stopwatch::read(gpu, times)).transpose()?;
        Ok(OfLight { visibility, listing, on_device })
    }
}

impl Rival for Flattened {
    fn left(&self) -> &[Left] {
        &self.left
    }

    fn bytes(&self) -> u64 {
        self.held.bytes() + self.marks.as_ref().map_or(0, Marks::bytes)
    }

    fn see(&mut self, view: &View<'_>) -> Result<Seen, RivalError> {
        let eye = Eye::new(view.camera, view.size)?;
        by_light::see(self, &eye, view)
    }
}
