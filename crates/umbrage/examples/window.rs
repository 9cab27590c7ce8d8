//! A window: columns under a sun that goes around. What is in it is drawn by `scene`, planned anew in every frame.
//! `cargo run --release -p umbrage --example window`; `-- --frames N` closes it after so many.

#[expect(dead_code, reason = "what other programs need")]
pub(crate) mod off_screen;
pub(crate) mod scene;
#[expect(dead_code, reason = "what other programs need")]
mod world;

use std::sync::Arc;
use std::time::Instant;

use off_screen::Result;
use scene::Scene;
use umbrage::{Capabilities, wgpu};
use winit::application::ApplicationHandler;
use winit::event::WindowEvent;
use winit::event_loop::{ActiveEventLoop, EventLoop};
use winit::window::{Window, WindowId};

fn main() -> Result<()> {
    let frames = std::env::args().skip_while(|arg| arg != "--frames").nth(1);
    let frames = frames.map(|frames| frames.parse()).transpose()?;
    let mut program = Program { frames, drawn: 0, start: Instant::now(), open: None, failed: None };
    EventLoop::new()?.run_app(&mut program)?;
    program.failed.map_or(Ok(()), Err)
}

/// The program: a window once there is one, and why it had to end.
struct Program {
    frames: Option<u32>,
    drawn: u32,
    start: Instant,
    open: Option<Open>,
    failed: Option<Box<dyn std::error::Error>>,
}

/// A window, and what is drawn in it.
struct Open {
    window: Arc<Window>,
    surface: wgpu::Surface<'static>,
    config: wgpu::SurfaceConfiguration,
    scene: Scene,
}

impl ApplicationHandler for Program {
    fn resumed(&mut self, events: &ActiveEventLoop) {
        if self.open.is_none() {
            match Open::new(events) {
                Ok(open) => self.open = Some(open),
                Err(error) => self.end(events, Some(error)),
            }
        }
    }

    fn window_event(&mut self, events: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        let Some(open) = &mut self.open else { return };
        match event {
            WindowEvent::CloseRequested => self.end(events, None),
            WindowEvent::Resized(size) => open.resize([size.width, size.height]),
            WindowEvent::Occluded(false) => open.window.request_redraw(),
            WindowEvent::RedrawRequested => match open.draw(self.start.elapsed().as_secs_f32()) {
                Ok(is_drawn) => {
                    self.drawn += u32::from(is_drawn);
                    if self.frames.is_some_and(|frames| self.drawn >= frames) {
                        self.end(events, None);
                    }
                }
                Err(error) => self.end(events, Some(error)),
            },
            _ => {}
        }
    }
}

impl Program {
    fn end(&mut self, events: &ActiveEventLoop, why: Option<Box<dyn std::error::Error>>) {
        self.failed = why;
        events.exit();
    }
}

impl Open {
    fn new(events: &ActiveEventLoop) -> Result<Self> {
        let window = Arc::new(events.create_window(Window::default_attributes().with_title("umbrage"))?);
        let display = Box::new(events.owned_display_handle());
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_with_display_handle(display));
        let surface = instance.create_surface(window.clone())?;
        let adapter = pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions {
            compatible_surface: Some(&surface),
            ..Default::default()
        }))?;
        let required_features = Capabilities::wanted_features(&adapter);
        let descriptor = wgpu::DeviceDescriptor { required_features, ..Default::default() };
        let (device, queue) = pollster::block_on(adapter.request_device(&descriptor))?;
        let size = window.inner_size();
        let config = surface.get_default_config(&adapter, size.width.max(1), size.height.max(1));
        let config = config.ok_or("the adapter cannot show pictures in this window")?;
        surface.configure(&device, &config);
        Ok(Self { window, surface, scene: Scene::new(device, queue, config.format)?, config })
    }

    fn resize(&mut self, size: [u32; 2]) {
        [self.config.width, self.config.height] = size.map(|side| side.max(1));
        self.surface.configure(&self.scene.device, &self.config);
        self.window.request_redraw();
    }

    /// Draws a frame; whether there was something to draw into.
    fn draw(&mut self, seconds: f32) -> Result<bool> {
        let texture = match self.surface.get_current_texture() {
            wgpu::CurrentSurfaceTexture::Success(texture)
            | wgpu::CurrentSurfaceTexture::Suboptimal(texture) => texture,
            wgpu::CurrentSurfaceTexture::Outdated | wgpu::CurrentSurfaceTexture::Lost => {
                self.resize([self.config.width, self.config.height]);
                return Ok(false);
            }
            wgpu::CurrentSurfaceTexture::Timeout => {
                self.window.request_redraw();
                return Ok(false);
            }
            _ => return Ok(false), // the window is hidden, and says so when it no longer is
        };
        let encoder = self.scene.draw(&texture.texture, seconds)?;
        self.scene.queue.submit([encoder.finish()]);
        self.window.pre_present_notify();
        self.scene.queue.present(texture);
        self.window.request_redraw();
        Ok(true)
    }
}
