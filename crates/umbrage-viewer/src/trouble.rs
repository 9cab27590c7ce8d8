//! What the device says went wrong, kept until the window can say it.

use std::sync::{Arc, Mutex, PoisonError};

use eframe::{egui, wgpu};

/// What went wrong on a device since it was last asked.
#[derive(Clone, Debug, Default)]
pub struct Trouble {
    said: Arc<Mutex<Said>>,
}

#[derive(Debug, Default)]
struct Said {
    errors: Vec<String>,
    lost: Option<String>,
}

impl Trouble {
    /// Listens to a device. Without a listener wgpu ends the program.
    pub fn of(device: &wgpu::Device, context: &egui::Context) -> Self {
        let trouble = Self::default();
        let (said, ctx) = (Arc::clone(&trouble.said), context.clone());
        device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| {
            lock(&said).errors.push(first_line(&error.to_string()));
            ctx.request_repaint();
        }));
        let (said, ctx) = (Arc::clone(&trouble.said), context.clone());
        device.set_device_lost_callback(move |_, reason| {
            lock(&said).lost =
                Some(if reason.is_empty() { "no reason given".to_owned() } else { first_line(&reason) });
            ctx.request_repaint();
        });
        #[cfg(not(target_arch = "wasm32"))]
        context.add_plugin(Guard { device: device.clone(), trouble: trouble.clone() });
        trouble
    }

    /// Errors since the last call.
    pub fn errors(&self) -> Vec<String> {
        std::mem::take(&mut lock(&self.said).errors)
    }

    /// Why the device was lost, where it was.
    pub fn lost(&self) -> Option<String> {
        lock(&self.said).lost.clone()
    }
}

/// Keeps egui from painting on a device that was lost while a frame was made: it would end the program. Browsers let it.
#[cfg(not(target_arch = "wasm32"))]
struct Guard {
    device: wgpu::Device,
    trouble: Trouble,
}

#[cfg(not(target_arch = "wasm32"))]
impl egui::Plugin for Guard {
    fn debug_name(&self) -> &'static str {
        "umbrage::guard"
    }

    fn output_hook(&mut self, _context: &egui::Context, output: &mut egui::FullOutput) {
        // What matters is what it says while it is asked.
        let _ = self.device.poll(wgpu::PollType::Poll);
        if self.trouble.lost().is_some() {
            output.shapes.clear();
            output.textures_delta.clear();
        }
    }
}

fn lock(said: &Mutex<Said>) -> std::sync::MutexGuard<'_, Said> {
    // Whoever died while it wrote left a whole list.
    said.lock().unwrap_or_else(PoisonError::into_inner)
}

/// wgpu's errors tell a story; a window has room for a line.
fn first_line(text: &str) -> String {
    let lines: Vec<&str> = text.lines().map(str::trim).filter(|line| !line.is_empty()).collect();
    lines.iter().rev().take(1).chain(lines.first()).copied().collect::<Vec<_>>().join(": ")
}
