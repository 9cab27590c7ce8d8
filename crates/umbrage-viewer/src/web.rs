//! The web page's side of the program: from a canvas to a running [`Viewer`].
//!
//! What goes wrong is told to the page as an event `umbrage-failed`, whose detail is the reason; `umbrage-started` says
//! that the first picture comes. The page (`web/index.html`) makes sentences of them.

use eframe::egui_wgpu::{WgpuConfiguration, WgpuSetup, WgpuSetupCreateNew};
use wasm_bindgen::JsValue;
use web_sys::{CustomEvent, CustomEventInit, HtmlCanvasElement};

use crate::Viewer;

/// Runs the program on a canvas, by WebGPU. Returns once it runs; panics before and after are told to the page.
pub async fn start(canvas: HtmlCanvasElement) {
    std::panic::set_hook(Box::new(|panic| tell("umbrage-failed", &panic.to_string())));
    let options = eframe::WebOptions {
        wgpu_options: WgpuConfiguration { wgpu_setup: WgpuSetup::CreateNew(setup()), ..Default::default() },
        ..Default::default()
    };
    let started =
        eframe::WebRunner::new().start(canvas, options, Box::new(|_| Ok(Box::new(Viewer::default())))).await;
    match started {
        Ok(()) => tell("umbrage-started", ""),
        Err(why) => tell("umbrage-failed", &why.as_string().unwrap_or_else(|| format!("{why:?}"))),
    }
}

/// A device with all the limits of its adapter: large worlds need more than the least that WebGPU promises.
fn setup() -> WgpuSetupCreateNew {
    let mut setup = WgpuSetupCreateNew::without_display_handle();
    setup.instance_descriptor.backends = wgpu::Backends::BROWSER_WEBGPU;
    setup.device_descriptor = std::sync::Arc::new(|adapter| wgpu::DeviceDescriptor {
        label: Some("Viewer::device"),
        required_features: adapter.features(),
        required_limits: adapter.limits(),
        ..Default::default()
    });
    setup
}

fn tell(name: &str, detail: &str) {
    let event = CustomEventInit::new();
    event.set_detail(&JsValue::from_str(detail));
    let event = CustomEvent::new_with_event_init_dict(name, &event);
    if let (Some(window), Ok(event)) = (web_sys::window(), event) {
        let _ = window.dispatch_event(&event);
    }
}
