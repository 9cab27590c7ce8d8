//! What is done with the window, step by step, and what is seen after each.

use std::cell::RefCell;
use std::collections::{BTreeMap, VecDeque};
use std::rc::Rc;
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use eframe::egui::{self, ColorImage, Event, PointerButton, Pos2, Rect, ViewportCommand};
use umbrage_viewer::Viewer;
use umbrage_viewer::load::Source;
use umbrage_viewer::probe::Probe;
use umbrage_viewer::view_state::ViewState;

/// One thing that is done.
#[derive(Clone, Debug)]
pub enum Step {
    /// The pointer clicks on a widget.
    Click(&'static str),
    /// The pointer drags from a share of a widget's width to another.
    Drag(&'static str, f32, f32),
    /// A key is pressed.
    Key(egui::Key),
    /// What is on the screen is kept under a name, with the state of the view.
    Look(&'static str),
    /// Another world is asked for.
    World(&'static str),
    /// A file is opened.
    Open(&'static str, &'static [u8]),
    /// The window is told something.
    Window(ViewportCommand),
    /// So many frames go by.
    Wait(u32),
    /// The device is destroyed.
    LoseDevice,
    /// The memory that the program has is kept.
    Memory,
}

/// What was on the screen, and what the program was at then.
#[derive(Clone, Debug)]
pub struct Seen {
    pub screen: Arc<ColorImage>,
    /// Where the picture is, points.
    pub picture: Rect,
    pub view: ViewState,
    pub world: String,
    pub messages: Vec<String>,
    pub mis_shadowed: Option<f64>,
    pub judged: usize,
}

/// All that was seen.
#[derive(Debug, Default)]
pub struct Log {
    pub seen: BTreeMap<&'static str, Seen>,
    /// Bytes of resident memory, in order.
    pub memory: Vec<u64>,
    /// How many windows there were.
    pub windows: usize,
    pub finished: bool,
}

/// How often worlds are changed; 200 where `UMBRAGE_MOVES` says so.
fn moves() -> usize {
    std::env::var("UMBRAGE_MOVES").ok().and_then(|moves| moves.parse().ok()).unwrap_or(12)
}

pub fn steps() -> VecDeque<Step> {
    use Step::*;
    let mut steps = VecDeque::from(vec![
        Look("first"),
        Drag("λ", 0.5, 0.02),
        Look("lambda"),
        Drag("splits", 0.35, 0.02),
        Look("splits"),
        Click("reset"),
        Look("reset"),
        Click("kind"),
        Wait(4),
        Click("hard"),
        Look("filter"),
        Click("reset"),
        Click("warp"),
        Wait(4),
        Click("LiSPSM"),
        Look("warp"),
        Click("reset"),
        Click("show errors"),
        Wait(2),
        Look("truth"),
        Click("compare two settings"),
        Click("right"),
        Drag("splits", 0.35, 0.02),
        Wait(2),
        Look("compared"),
        Click("compare two settings"),
        Click("show errors"),
        Click("splits tint"),
        Look("tinted"),
        Click("texels"),
        Look("texels"),
        Click("pixels per texel"),
        Look("extents"),
        Click("shaded"),
        Click("shadow maps"),
        Wait(4),
        Look("maps"),
        Key(egui::Key::M),
        Click("freeze the planned camera"),
        Click("frusta"),
        Click("caster volumes"),
        Drag("the picture", 0.5, 0.6),
        Key(egui::Key::Num2),
        Wait(2),
        Look("frozen"),
        Key(egui::Key::F),
        Click("frusta"),
        Click("caster volumes"),
        Key(egui::Key::Num1),
        Key(egui::Key::H),
        Wait(4),
        Look("alone"),
        Key(egui::Key::H),
        Open("not-a-scene.glb", b"glTF, it says"),
        Wait(4),
        Open("newer.toml", b"[shadows]\nsplits = 3\nvirtual_pages = 4096\n"),
        Wait(4),
        Look("refused"),
        Window(ViewportCommand::InnerSize(egui::vec2(700.0, 500.0))),
        Wait(6),
        Look("smaller"),
        Window(ViewportCommand::Minimized(true)),
        Wait(6),
        Window(ViewportCommand::Minimized(false)),
        Window(ViewportCommand::InnerSize(egui::vec2(1180.0, 760.0))),
        Wait(6),
        World("orbit"),
        Look("orbit"),
        LoseDevice,
        Wait(6),
        Look("after"),
    ]);
    for i in 0..moves() {
        steps.push_back(World(["primitives", "orbit", "tutorial-room", "bunny"][i % 4]));
        steps.push_back(Wait(2));
        if i % 4 == 3 {
            steps.push_back(Memory);
        }
    }
    steps.push_back(Window(ViewportCommand::Close));
    steps
}

/// A viewer, and who drives it.
pub struct Scripted {
    viewer: Rc<RefCell<Viewer>>,
    steps: Rc<RefCell<VecDeque<Step>>>,
    log: Rc<RefCell<Log>>,
    probe: Option<Probe>,
    events: VecDeque<Event>,
    screen: Arc<Mutex<Option<Arc<ColorImage>>>>,
    looking: Option<&'static str>,
    /// Frames to let go by.
    waits: u32,
    /// When the last step was taken.
    since: Instant,
}

impl Scripted {
    pub fn new(
        viewer: Rc<RefCell<Viewer>>,
        steps: Rc<RefCell<VecDeque<Step>>>,
        log: Rc<RefCell<Log>>,
    ) -> Self {
        log.borrow_mut().windows += 1;
        Self {
            viewer,
            steps,
            log,
            probe: None,
            events: VecDeque::new(),
            screen: Arc::default(),
            looking: None,
            waits: 4,
            since: Instant::now(),
        }
    }

    fn take_step(&mut self, context: &egui::Context) {
        let Some(step) = self.steps.borrow_mut().pop_front() else {
            self.log.borrow_mut().finished = true;
            return;
        };
        self.waits = 3;
        self.since = Instant::now();
        let mut viewer = self.viewer.borrow_mut();
        match step {
            Step::Click(name) => {
                let at = self.find(name).center();
                self.events.extend(press(at, true).into_iter().chain(press(at, false)));
                self.events.push_back(Event::PointerMoved(ASIDE));
            }
            Step::Drag(name, from, to) => {
                let rect = self.find(name);
                let at = |share: f32| Pos2::new(rect.left() + rect.width() * share, rect.center().y);
                self.events.extend(press(at(from), true));
                self.events.extend([Event::PointerMoved(at(0.5 * (from + to))), Event::PointerMoved(at(to))]);
                self.events.extend(press(at(to), false));
                self.events.push_back(Event::PointerMoved(ASIDE));
            }
            Step::Key(key) => {
                let event = |pressed| Event::Key {
                    key,
                    physical_key: None,
                    pressed,
                    repeat: false,
                    modifiers: egui::Modifiers::NONE,
                };
                self.events.extend([event(true), event(false)]);
            }
            Step::Look(name) => {
                self.looking = Some(name);
                let screen = Arc::clone(&self.screen);
                let keep = egui::ScreenshotCallback::new(move |image| {
                    *screen.lock().expect("whole") = Some(image);
                });
                context.send_viewport_cmd(ViewportCommand::Screenshot(keep));
            }
            Step::World(name) => viewer.load(context, Source::Named(name.to_owned())),
            Step::Open(name, bytes) => viewer.open(context, name, bytes.to_vec()),
            Step::Window(command) => context.send_viewport_cmd(command),
            Step::Wait(frames) => self.waits = frames,
            Step::LoseDevice => viewer.gpu().device.destroy(),
            Step::Memory => self.log.borrow_mut().memory.push(resident()),
        }
    }

    fn find(&self, name: &str) -> Rect {
        let probe = self.probe.as_ref().expect("a probe");
        probe.widget(name).unwrap_or_else(|| {
            panic!(
                "no widget is called `{name}`; there are {:?}",
                probe.widgets().into_keys().collect::<Vec<_>>()
            )
        })
    }

    fn keep(&mut self) {
        let Some(screen) = self.screen.lock().expect("whole").take() else { return };
        let Some(name) = self.looking.take() else { return };
        let mut viewer = self.viewer.borrow_mut();
        let figures = viewer.figures(0).cloned();
        let seen = Seen {
            screen,
            picture: self.find("the picture"),
            view: viewer.view().expect("a world is shown").clone(),
            world: viewer.world_name().to_owned(),
            messages: viewer.messages().to_vec(),
            mis_shadowed: figures.as_ref().map(|figures| figures.tally.mis_shadowed()),
            judged: figures.map_or(0, |figures| figures.tally.judged),
        };
        super::checks::save(name, &seen);
        self.log.borrow_mut().seen.insert(name, seen);
    }
}

/// Where nothing explains itself.
const ASIDE: Pos2 = Pos2::new(4.0, 720.0);

/// The pointer comes, and its button goes down or up.
fn press(at: Pos2, pressed: bool) -> [Event; 2] {
    let modifiers = egui::Modifiers::NONE;
    [
        Event::PointerMoved(at),
        Event::PointerButton { pos: at, button: PointerButton::Primary, pressed, modifiers },
    ]
}

/// Bytes of this program that are in memory.
fn resident() -> u64 {
    let statm = std::fs::read_to_string("/proc/self/statm").expect("Linux");
    statm.split(' ').nth(1).and_then(|pages| pages.parse::<u64>().ok()).expect("a number") * 4096
}

impl eframe::App for Scripted {
    fn clear_color(&self, visuals: &egui::Visuals) -> [f32; 4] {
        self.viewer.borrow().clear_color(visuals)
    }

    fn raw_input_hook(&mut self, _context: &egui::Context, input: &mut egui::RawInput) {
        // A person's pointer does one thing a frame.
        input.events.retain(|event| {
            !matches!(event, Event::PointerMoved(_) | Event::PointerGone | Event::MouseMoved(_))
        });
        input.events.extend(self.events.pop_front());
        // Things are to look the same whichever window has the focus.
        input.focused = true;
    }

    fn logic(&mut self, context: &egui::Context, frame: &mut eframe::Frame) {
        self.viewer.borrow_mut().logic(context, frame);
    }

    fn ui(&mut self, ui: &mut egui::Ui, frame: &mut eframe::Frame) {
        let probe = self.probe.get_or_insert_with(|| Probe::of(ui.ctx()));
        let is_known = !probe.widgets().is_empty();
        self.viewer.borrow_mut().ui(ui, frame);
        ui.ctx().request_repaint();
        self.keep();
        let is_at_rest =
            self.viewer.borrow().is_at_rest() && self.events.is_empty() && self.looking.is_none();
        if is_known && is_at_rest {
            match self.waits.checked_sub(1) {
                Some(waits) => self.waits = waits,
                None => self.take_step(ui.ctx()),
            }
        }
        assert!(
            self.since.elapsed() < Duration::from_secs(120),
            "the window is stuck before {:?}",
            self.steps.borrow().front()
        );
    }
}
