//! What is true of a shot: traced once, and kept while one variant after another is judged by it.

use std::sync::Arc;

use umbrage_judge::{Edges, Eye, Light, Smooth, Truth, World};

use crate::shot::Shot;
use crate::truth_kind::TruthKind;

/// What is true of one light, through pixels' centres.
#[derive(Debug)]
pub(crate) struct Traced {
    pub truth: Truth,
    pub edges: Edges,
}

/// Everything that was traced of the last shot.
#[derive(Debug, Default)]
pub(crate) struct Truths {
    last: Option<OfShot>,
}

#[derive(Debug)]
struct OfShot {
    shot: Shot,
    /// How deep pixels are judged, metres.
    distance: f64,
    hard: Arc<Vec<Traced>>,
    smooth: Vec<(TruthKind, Arc<Vec<Smooth>>)>,
}

impl Truths {
    /// The hard truth of a shot, light by light. `world` is the scene at the time of the shot.
    pub fn hard(&mut self, shot: &Shot, distance: f64, world: &World) -> Arc<Vec<Traced>> {
        Arc::clone(&self.of_shot(shot, distance, world).hard)
    }

    /// A truth between lit and shadowed, light by light. `None` for the hard truth, which has nothing between.
    pub fn smooth(
        &mut self,
        shot: &Shot,
        distance: f64,
        world: &World,
        kind: TruthKind,
    ) -> Option<Arc<Vec<Smooth>>> {
        let OfShot { hard, smooth, .. } = self.of_shot(shot, distance, world);
        if let Some((_, known)) = smooth.iter().find(|(of, _)| *of == kind) {
            return Some(Arc::clone(known));
        }
        let trace = |traced: &Traced| match kind {
            TruthKind::Hard => None,
            TruthKind::SubPixel(side) => Some(umbrage_judge::sub_pixel(world, &traced.truth, side)),
            TruthKind::Soft { samples, angle } => {
                Some(umbrage_judge::soft(world, &traced.truth, 0.5 * angle, samples))
            }
        };
        let traced = Arc::new(hard.iter().map(trace).collect::<Option<Vec<_>>>()?);
        smooth.push((kind, Arc::clone(&traced)));
        Some(traced)
    }

    fn of_shot(&mut self, shot: &Shot, distance: f64, world: &World) -> &mut OfShot {
        let known = self.last.take().filter(|last| last.shot == *shot && last.distance == distance);
        let last = known.unwrap_or_else(|| {
            let eye = Eye::new(&shot.camera, shot.width, shot.height);
            let trace = |light: &umbrage_scene::Light| {
                let truth = Truth::new(world, &eye, &Light::at(light, &shot.pose), distance);
                Traced { edges: Edges::new(&truth), truth }
            };
            let hard = Arc::new(shot.lights.iter().map(trace).collect());
            OfShot { shot: shot.clone(), distance, hard, smooth: Vec::new() }
        });
        self.last.insert(last)
    }
}
