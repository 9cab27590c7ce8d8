//! A frame, planned: what moves is moved, views are planned and named, and all that is drawn is listed.

use std::sync::{Arc, OnceLock};

use umbrage::Shadows;
use web_time::Instant;

use super::Renderer;
use crate::buffers::Growing;
use crate::drawn::{MapsId, Planned};
use crate::draws::{Draw, DrawLists};
use crate::error::RenderError;
use crate::exposure::Exposure;
use crate::frame::Frame;
use crate::keys;
use crate::timing::ViewLoad;

impl Renderer {
    /// Moves what moves, plans, lists what is drawn into which view, and uploads all of it.
    pub(super) fn plan(&mut self, frame: &Frame) -> Result<Arc<Planned>, RenderError> {
        let start = Instant::now();
        let (cull_parts, keep_tiles, hold_plans) = (self.cull_parts, self.keep_tiles, self.hold_plans);
        self.take_levels();
        let Self { gpu, scene, parts, shadows, lights, timer, plans, .. } = self;
        let origin = frame.camera.local_origin();
        scene.move_to(gpu, timer, origin, &frame.pose)?;
        parts.hold_reaches(hold_plans);
        parts.move_to(&scene.placement.instances, &frame.pose);
        let planned_for = frame.planned_for.as_ref().unwrap_or(&frame.camera);
        let make = |shadows: &mut Shadows| {
            Ok(Planned {
                plan: shadows.plan(planned_for, lights, parts.bounds())?,
                chosen: OnceLock::new(),
                camera: frame.camera,
                origin,
                lights: Vec::new(),
                pose: Arc::clone(&frame.pose),
                size: [0, 0],
                samples: 1,
                exposure: Exposure::default(),
                haze: true,
                lists: DrawLists::default(),
                numbers: Growing::new(gpu, "instance numbers", wgpu::BufferUsages::VERTEX)?,
                loads: Vec::new(),
                milliseconds: 0.0,
                maps: MapsId::new(),
            })
        };
        let fill = |shadows: &mut Shadows, planned: &mut Planned| {
            shadows.replan(&mut planned.plan, planned_for, lights, parts.bounds())?;
            planned.chosen = OnceLock::new();
            (planned.camera, planned.origin) = (frame.camera, origin);
            planned.lights.clone_from(&frame.lights);
            planned.pose = Arc::clone(&frame.pose);
            (planned.size, planned.samples) = ([frame.width, frame.height], frame.samples);
            (planned.exposure, planned.haze) = (frame.exposure, frame.haze);
            parts.list(&mut planned.lists, &mut planned.plan, &planned.camera, cull_parts);
            if keep_tiles {
                keys::name(&mut planned.plan, origin, &planned.lists, parts);
            }
            planned.numbers.write(gpu, bytemuck::cast_slice(planned.lists.instances()))?;
            planned.maps = MapsId::new();
            shadows.set_picture_size(frame.width, frame.height);
            shadows.set_origin(origin);
            shadows.upload(&gpu.queue, &planned.plan)?;
            load(planned, shadows);
            planned.milliseconds = start.elapsed().as_secs_f64() * 1e3;
            Ok(())
        };
        plans.filled(shadows, make, fill)
    }
}

/// Counts what must be drawn into each of a plan's views.
fn load(planned: &mut Planned, shadows: &Shadows) {
    planned.loads.clear();
    for (i, view) in planned.plan.views().iter().enumerate() {
        let mut load = ViewLoad { light: view.light, split: view.split, draws: 0, triangles: 0 };
        for draws in shadows.due(i).flat_map(|share| planned.casters(i, share)) {
            load.draws += draws.len();
            load.triangles += draws.iter().map(Draw::triangles).sum::<u64>();
        }
        planned.loads.push(load);
    }
}
