//! How far the CPU runs ahead of the device: two frames in flight, as a window has them, and when each was done.

use std::collections::VecDeque;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Instant;

use bevy::prelude::*;
use bevy::render::render_resource::PollType;
use bevy::render::renderer::{RenderDevice, RenderQueue};
use bevy::render::{Render, RenderApp, RenderSystems};
use wgpu::SubmissionIndex;

/// Frames that may be in flight when the next one is begun.
const AHEAD: usize = 1;

/// When frames were done, in order. A clone is the same list.
#[derive(Resource, Clone, Default)]
pub struct Done(Arc<Mutex<Vec<Instant>>>);

impl Done {
    /// Forgets what was before, and says how many there are from now on.
    pub fn clear(&self) {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).clear();
    }

    /// The times so far.
    pub fn times(&self) -> Vec<Instant> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }
}

/// Notes when each of the renderer's frames is done.
pub fn add(app: &mut App, done: &Done) {
    if let Some(render_app) = app.get_sub_app_mut(RenderApp) {
        render_app.insert_resource(done.clone());
        render_app.add_systems(Render, keep_pace.in_set(RenderSystems::Cleanup));
    }
}

/// Waits for the frame before the one that was just handed over.
fn keep_pace(
    mut in_flight: Local<VecDeque<SubmissionIndex>>,
    done: Res<Done>,
    device: Res<RenderDevice>,
    queue: Res<RenderQueue>,
) {
    // Nothing more is handed over: this asks for the number of what was.
    in_flight.push_back(queue.submit([]));
    while in_flight.len() > AHEAD {
        let submission_index = in_flight.pop_front();
        // A device that is lost is told by what is drawn next.
        let _ = device.poll(PollType::Wait { submission_index, timeout: None });
        done.0.lock().unwrap_or_else(PoisonError::into_inner).push(Instant::now());
    }
}
