//! The viewer in a window of the desktop.

use std::cell::RefCell;
use std::rc::Rc;
use std::sync::Arc;

use eframe::{egui, egui_wgpu, wgpu};
use umbrage_render::{Gpu, RenderError};

use crate::viewer::{Start, Viewer};

/// How the window is made.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Part of the name of the adapter to draw on; the first usable one where absent.
    pub adapter: Option<String>,
    /// Size of the window, points; 1280 × 800 where absent.
    pub size: Option<[f32; 2]>,
    /// Whether frames are shown at once, without waiting for the screen (no vertical synchronisation).
    pub unlimited: bool,
}

/// Makes the program that eframe runs of a viewer: the viewer itself, or in tests a script around it.
pub type Wrap<'a> = dyn Fn(Rc<RefCell<Viewer>>) -> Box<dyn eframe::App> + 'a;

/// Opens a window, and returns when it is closed. Where the device is lost another window takes its place, with all that
/// was chosen.
///
/// # Errors
/// In one line: when there is no display, or no adapter that can draw.
pub fn run(start: Start, options: &Options) -> Result<(), String> {
    run_wrapped(start, options, &|viewer| Box::new(Held(viewer)))
}

/// Does the same as [`run`] with a program around the viewer.
///
/// # Errors
/// As [`run`].
pub fn run_wrapped(start: Start, options: &Options, wrap: &Wrap<'_>) -> Result<(), String> {
    let mut start = start;
    loop {
        let held = Rc::new(RefCell::new(None));
        let (made, from) = (Rc::clone(&held), start.clone());
        let create = move |creation: &eframe::CreationContext<'_>| {
            let viewer = Rc::new(RefCell::new(Viewer::new(creation, from)?));
            *made.borrow_mut() = Some(Rc::clone(&viewer));
            Ok(wrap(viewer))
        };
        eframe::run_native("Umbrage", native_options(options), Box::new(create))
            .map_err(|why| remedy(&why))?;
        let Some(viewer) = held.borrow_mut().take() else { return Ok(()) };
        let viewer = viewer.borrow();
        let Some(why) = viewer.lost() else { return Ok(()) };
        let message = format!("the graphics device was lost ({why}); this is another one");
        start = Start { messages: vec![message], ..viewer.restart() };
    }
}

/// A viewer that others hold too.
struct Held(Rc<RefCell<Viewer>>);

impl eframe::App for Held {
    fn clear_color(&self, visuals: &egui::Visuals) -> [f32; 4] {
        self.0.borrow().clear_color(visuals)
    }

    fn logic(&mut self, context: &egui::Context, frame: &mut eframe::Frame) {
        self.0.borrow_mut().logic(context, frame);
    }

    fn ui(&mut self, ui: &mut egui::Ui, frame: &mut eframe::Frame) {
        self.0.borrow_mut().ui(ui, frame);
    }
}

fn native_options(options: &Options) -> eframe::NativeOptions {
    let size = options.size.unwrap_or([1280.0, 800.0]);
    let mut wgpu_options =
        egui_wgpu::WgpuConfiguration { wgpu_setup: setup(options.adapter.clone()), ..Default::default() };
    if options.unlimited {
        wgpu_options.surface.present_mode = wgpu::PresentMode::AutoNoVsync;
    }
    eframe::NativeOptions {
        viewport: egui::ViewportBuilder::default()
            .with_title("Umbrage")
            .with_inner_size(size)
            .with_min_inner_size([320.0, 200.0])
            .with_drag_and_drop(true),
        // The picture is eight bits already, and noise over it costs a software adapter dear.
        dithering: false,
        wgpu_options,
        ..Default::default()
    }
}

/// Returns the set-up of the device that shadows want, on the adapter whose name has `wanted` in it. OpenGL is left out: it
/// cannot show pictures here.
pub fn setup(wanted: Option<String>) -> egui_wgpu::WgpuSetup {
    let mut setup = egui_wgpu::WgpuSetupCreateNew::without_display_handle();
    setup.instance_descriptor.backends = wgpu::Backends::PRIMARY;
    setup.device_descriptor = Arc::new(Gpu::wanted_device);
    setup.native_adapter_selector =
        Some(Arc::new(move |adapters, surface| choose(adapters, surface, wanted.as_deref())));
    egui_wgpu::WgpuSetup::CreateNew(setup)
}

fn choose(
    adapters: &[wgpu::Adapter],
    surface: Option<&wgpu::Surface<'_>>,
    wanted: Option<&str>,
) -> Result<wgpu::Adapter, String> {
    let usable = adapters
        .iter()
        .filter(|adapter| surface.is_none_or(|surface| adapter.is_surface_supported(surface)))
        .cloned()
        .collect::<Vec<_>>();
    Gpu::choose(&usable, wanted).cloned().map_err(|why| why.to_string())
}

/// The error where there is no display, which says what to do.
pub const NO_DISPLAY: &str =
    "there is no display to open a window on; use `umbrage render` or `umbrage demo`, which need none";

/// Returns whether there is a display to open a window on.
pub fn has_display() -> bool {
    let is_set = |name| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    !cfg!(target_os = "linux") || is_set("DISPLAY") || is_set("WAYLAND_DISPLAY")
}

fn remedy(why: &eframe::Error) -> String {
    let text = why.to_string().replace('\n', " ");
    if !has_display() {
        return NO_DISPLAY.to_owned();
    }
    let is_of_display = matches!(why, eframe::Error::Winit(_) | eframe::Error::WinitEventLoop(_));
    let text = if is_of_display {
        // Before its last words winit says where in itself it failed.
        text.rsplit(": ").next().unwrap_or_default().to_owned()
    } else if text.contains("Failed to create surface") {
        RenderError::NoAdapter.to_string()
    } else {
        text
    };
    format!("the window cannot be opened: {text}")
}
