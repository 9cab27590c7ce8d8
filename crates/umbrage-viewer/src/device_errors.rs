//! Errors that the device reports, kept until the window shows them.

use std::sync::{Arc, Mutex, PoisonError};

use eframe::{egui, wgpu};

/// Errors of a device since they were last taken, and why it was lost.
#[derive(Clone, Debug, Default)]
pub struct DeviceErrors {
    reported: Arc<Mutex<Reported>>,
}

#[derive(Debug, Default)]
struct Reported {
    errors: Vec<String>,
    lost: Option<String>,
}

impl DeviceErrors {
    /// Listens to a device, and asks `context` to repaint on each error. Without a listener wgpu ends the program.
    pub fn of(device: &wgpu::Device, context: &egui::Context) -> Self {
        let errors = Self::default();
        let (reported, ctx) = (Arc::clone(&errors.reported), context.clone());
        device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| {
            lock(&reported).errors.push(first_line(&error.to_string()));
            ctx.request_repaint();
        }));
        let (reported, ctx) = (Arc::clone(&errors.reported), context.clone());
        device.set_device_lost_callback(move |_, reason| {
            lock(&reported).lost =
                Some(if reason.is_empty() { "no reason given".to_owned() } else { first_line(&reason) });
            ctx.request_repaint();
        });
        #[cfg(not(target_arch = "wasm32"))]
        context.add_plugin(Guard { device: device.clone(), errors: errors.clone() });
        errors
    }

    /// Takes the errors since the last call, each in one line.
    pub fn take(&self) -> Vec<String> {
        std::mem::take(&mut lock(&self.reported).errors)
    }

    /// Returns why the device was lost; `None` while it works.
    pub fn lost(&self) -> Option<String> {
        lock(&self.reported).lost.clone()
    }
}

/// Keeps egui from painting on a device that was lost while a frame was made: it would end the program. Browsers let it.
#[cfg(not(target_arch = "wasm32"))]
struct Guard {
    device: wgpu::Device,
    errors: DeviceErrors,
}

#[cfg(not(target_arch = "wasm32"))]
impl egui::Plugin for Guard {
    fn debug_name(&self) -> &'static str {
        "umbrage::guard"
    }

    fn output_hook(&mut self, _context: &egui::Context, output: &mut egui::FullOutput) {
        // Polling runs the callback of a lost device.
        let _ = self.device.poll(wgpu::PollType::Poll);
        if self.errors.lost().is_some() {
            output.shapes.clear();
            output.textures_delta.clear();
        }
    }
}

fn lock(reported: &Mutex<Reported>) -> std::sync::MutexGuard<'_, Reported> {
    // A thread that died while it wrote left a whole list.
    reported.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The last and the first line of an error of wgpu, which has many: what is wrong, and of what.
fn first_line(text: &str) -> String {
    let lines: Vec<&str> = text.lines().map(str::trim).filter(|line| !line.is_empty()).collect();
    lines.iter().rev().take(1).chain(lines.first()).copied().collect::<Vec<_>>().join(": ")
}
