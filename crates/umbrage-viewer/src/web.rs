//! The page: the same program on a canvas, in a browser that supports WebGPU.

use std::cell::RefCell;
use std::rc::Rc;
use std::sync::Arc;

use eframe::wasm_bindgen::JsCast as _;
use eframe::{egui, egui_wgpu, wgpu};
use umbrage_render::Gpu;
use wasm_bindgen::JsValue;
use web_sys::js_sys;

use crate::browser::{dispatch, pause};
use crate::link::Link;
use crate::probe::Probe;
use crate::viewer::{Start, Viewer};

/// Runs the viewer on the canvas with the id `umbrage`. The page's address may be a [`Link`], as
/// `?world=knights&preset=soft&set=splits=3`; with `probe` beside it, scripts learn where widgets are.
///
/// # Errors
/// When there is no such canvas, or no WebGPU.
pub async fn start() -> Result<(), JsValue> {
    std::panic::set_hook(Box::new(|panic| dispatch("umbrage-failed", &panic.to_string())));
    let window = web_sys::window().ok_or("no window")?;
    let document = window.document().ok_or("no document")?;
    let canvas = document.get_element_by_id("umbrage").ok_or("no canvas with the id `umbrage`")?;
    let canvas: web_sys::HtmlCanvasElement = canvas.dyn_into()?;
    let query = window.location().search()? + &window.location().hash()?;
    let (link, messages) = Link::parse(&query);
    let mut start = Start { messages, keeps: true, ..Start::of_link(link) };
    let probes = query.split(['?', '&', '#']).any(|part| part == "probe" || part.starts_with("probe="));
    loop {
        let runner = eframe::WebRunner::new();
        let held: Rc<RefCell<Option<Rc<RefCell<Viewer>>>>> = Rc::default();
        let (made, from) = (Rc::clone(&held), start.clone());
        let create: eframe::AppCreator<'static> = Box::new(move |creation| {
            let viewer = Rc::new(RefCell::new(Viewer::new(creation, from)?));
            *made.borrow_mut() = Some(Rc::clone(&viewer));
            let probe = probes.then(|| Probe::of(&creation.egui_ctx));
            Ok(Box::new(Page(viewer, probe)))
        });
        runner.start(canvas.clone(), options(), create).await?;
        dispatch("umbrage-started", "");
        // A page runs until it is left, unless its device is lost.
        let why = loop {
            pause(250).await;
            let lost = held.borrow().as_ref().and_then(|viewer| viewer.borrow().lost());
            if let Some(why) = lost {
                break why;
            }
        };
        let viewer = held.borrow_mut().take();
        let message = format!("the graphics device was lost ({why}); this is another one");
        if let Some(viewer) = viewer {
            start = Start { messages: vec![message], ..viewer.borrow().restart() };
        }
        runner.destroy();
        pause(500).await;
    }
}

fn options() -> eframe::WebOptions {
    let mut setup = egui_wgpu::WgpuSetupCreateNew::without_display_handle();
    setup.instance_descriptor.backends = wgpu::Backends::BROWSER_WEBGPU;
    setup.device_descriptor = Arc::new(Gpu::wanted_device);
    let wgpu_options = egui_wgpu::WgpuConfiguration {
        wgpu_setup: egui_wgpu::WgpuSetup::CreateNew(setup),
        ..Default::default()
    };
    eframe::WebOptions { wgpu_options, ..Default::default() }
}

/// The viewer, and for scripts that drive the page the places of its widgets.
struct Page(Rc<RefCell<Viewer>>, Option<Probe>);

impl eframe::App for Page {
    fn clear_color(&self, visuals: &egui::Visuals) -> [f32; 4] {
        self.0.borrow().clear_color(visuals)
    }

    fn logic(&mut self, context: &egui::Context, frame: &mut eframe::Frame) {
        self.0.borrow_mut().logic(context, frame);
    }

    fn ui(&mut self, ui: &mut egui::Ui, frame: &mut eframe::Frame) {
        self.0.borrow_mut().ui(ui, frame);
        publish(&self.0.borrow(), self.1.as_ref());
    }
}

/// Sets the page's global `umbrage` for scripts: world, settings, whether the viewer is at rest, what is loaded and how
/// far it is, messages, figures of the comparison with ground truth, why the pixel is as it is that someone asks about; and the widgets' rectangles, where the page's address
/// has `probe`.
fn publish(viewer: &Viewer, probe: Option<&Probe>) {
    let state = js_sys::Object::new();
    let set = |key: &str, value: JsValue| {
        // An object of our own takes any key.
        let _ = js_sys::Reflect::set(&state, &key.into(), &value);
    };
    set("world", viewer.world_name().into());
    set("atRest", viewer.is_at_rest().into());
    if let Some(loading) = viewer.loading() {
        set("loading", loading.into());
    }
    let messages: js_sys::Array =
        viewer.messages().iter().map(|message| JsValue::from_str(message)).collect();
    set("messages", messages.into());
    if let Some(settings) = viewer.settings().and_then(|settings| crate::edit::file(settings).ok()) {
        set("settings", settings.into());
    }
    if let Some(figures) = viewer.figures(0) {
        set("judged", (figures.tally.judged as f64).into());
        set("misShadowed", figures.tally.mis_shadowed().into());
        set("meanError", figures.tally.mae().into());
    }
    if let Some(answer) = viewer.answer() {
        set("why", answer.to_string().into());
    }
    let widgets = js_sys::Object::new();
    for (name, rect) in probe.map(Probe::widgets).unwrap_or_default() {
        let place = [rect.left(), rect.top(), rect.right(), rect.bottom()];
        let place: js_sys::Array = place.into_iter().map(JsValue::from).collect();
        let _ = js_sys::Reflect::set(&widgets, &JsValue::from_str(&name), &place);
    }
    set("widgets", widgets.into());
    if let Some(window) = web_sys::window() {
        let _ = js_sys::Reflect::set(&window, &"umbrage".into(), &state);
    }
}
