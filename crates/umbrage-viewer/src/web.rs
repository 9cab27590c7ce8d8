//! The page: the same program on a canvas, in a browser that knows WebGPU.

use std::cell::RefCell;
use std::rc::Rc;
use std::sync::Arc;

use eframe::wasm_bindgen::JsCast as _;
use eframe::{egui, egui_wgpu, wgpu};
use umbrage::Settings;
use umbrage_render::Gpu;
use umbrage_scene::worlds;
use wasm_bindgen::JsValue;
use wasm_bindgen_futures::JsFuture;
use web_sys::js_sys;

use crate::app::{Start, Viewer};
use crate::load::{Source, check_size};
use crate::probe::Probe;
use crate::task::Task;

mod worker;

pub use worker::sorted;

/// Runs on the canvas with the id `umbrage`. The page's address may name a world and settings:
/// `?world=knights&set=splits=3&set=lambda=0.9`.
///
/// # Errors
/// When there is no such canvas, or no WebGPU.
pub async fn start() -> Result<(), JsValue> {
    std::panic::set_hook(Box::new(|panic| tell("umbrage-failed", &panic.to_string())));
    let window = web_sys::window().ok_or("no window")?;
    let document = window.document().ok_or("no document")?;
    let canvas = document.get_element_by_id("umbrage").ok_or("no canvas with the id `umbrage`")?;
    let canvas: web_sys::HtmlCanvasElement = canvas.dyn_into()?;
    let asked = web_sys::UrlSearchParams::new_with_str(&window.location().search()?)?;
    let mut start = asked_for(&asked);
    let probes = asked.has("probe");
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
        tell("umbrage-started", "");
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
            start = Start { message: Some(message), ..viewer.borrow().go_on() };
        }
        runner.destroy();
        pause(500).await;
    }
}

/// What the page's address asks for.
fn asked_for(asked: &web_sys::UrlSearchParams) -> Start {
    let world = asked.get("world").unwrap_or_else(|| worlds::DEFAULT.to_owned());
    let sets = asked.get_all("set").iter().filter_map(|set| set.as_string()).collect::<Vec<_>>();
    let preset = asked.get("preset").unwrap_or_else(|| "default".to_owned());
    let (settings, message) = match umbrage_lab::settings::asked(&preset, &sets) {
        Ok(settings) => (settings, None),
        Err(why) => (Settings::default(), Some(why.to_string())),
    };
    Start { message, ..Start::new(Source::Named(world), settings) }
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

/// The viewer, and what scripts that drive the page may know of it.
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

/// Sets `window.umbrage`: the world, its settings, whether anything is under way, what was said, how wrong it is; and where
/// widgets are, where the page's address has `probe`.
fn publish(viewer: &Viewer, probe: Option<&Probe>) {
    let state = js_sys::Object::new();
    let set = |key: &str, value: JsValue| {
        // An object of our own takes any key.
        let _ = js_sys::Reflect::set(&state, &key.into(), &value);
    };
    set("world", viewer.world_name().into());
    set("atRest", viewer.is_at_rest().into());
    let messages: js_sys::Array =
        viewer.messages().iter().map(|message| JsValue::from_str(message)).collect();
    set("messages", messages.into());
    if let Some(settings) = viewer.settings().and_then(|settings| crate::edit::file(settings).ok()) {
        set("settings", settings.into());
    }
    if let Some(figures) = viewer.figures(0) {
        set("judged", (figures.tally.judged as f64).into());
        set("misShadowed", figures.tally.mis_shadowed().into());
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

/// Waits for some milliseconds, and lets the page go on.
pub async fn pause(milliseconds: i32) {
    let promise = js_sys::Promise::new(&mut |resolve, _| {
        if let Some(window) = web_sys::window() {
            // Where it cannot wait it goes on at once.
            let _ = window.set_timeout_with_callback_and_timeout_and_arguments_0(&resolve, milliseconds);
        }
    });
    let _ = JsFuture::from(promise).await;
}

/// Lets the page show what it is about to do.
pub async fn next_moment() {
    pause(40).await;
}

/// Reads a file that was dropped on the page. It goes nowhere else.
pub fn read(context: &egui::Context, file: egui::DroppedFileHandle) -> Task<Result<Option<Source>, String>> {
    Task::wait_for("reading the file", context, async move {
        let name = file.path().to_string_lossy().into_owned();
        let size = file.web_file().map_or(0.0, |file| file.size());
        check_size(&name, size as u64)?;
        let bytes = file.bytes_async().await.map_err(|why| format!("{why}: {name}"))?;
        Ok(Some(Source::Bytes { name, bytes }))
    })
}

/// Gives the browser a file to keep.
///
/// # Errors
/// When it does not take it.
pub fn download(name: &str, bytes: &[u8]) -> Result<(), String> {
    let failed = |why: JsValue| format!("the browser does not take the file: {why:?}");
    let parts = js_sys::Array::of1(&js_sys::Uint8Array::from(bytes));
    let blob = web_sys::Blob::new_with_u8_array_sequence(&parts).map_err(failed)?;
    let url = web_sys::Url::create_object_url_with_blob(&blob).map_err(failed)?;
    let document = web_sys::window().and_then(|window| window.document()).ok_or("there is no page")?;
    let link: web_sys::HtmlAnchorElement = document.create_element("a").map_err(failed)?.unchecked_into();
    link.set_href(&url);
    link.set_download(name);
    link.click();
    web_sys::Url::revoke_object_url(&url).map_err(failed)
}

/// Tells the page something: `umbrage-started`, or `umbrage-failed` with the reason. The page (`web/index.html`) makes
/// sentences of them.
pub fn tell(name: &str, detail: &str) {
    let event = web_sys::CustomEventInit::new();
    event.set_detail(&JsValue::from_str(detail));
    let event = web_sys::CustomEvent::new_with_event_init_dict(name, &event);
    if let (Some(window), Ok(event)) = (web_sys::window(), event) {
        // Who does not listen does not hear.
        let _ = window.dispatch_event(&event);
    }
}
