//! The rectangle of every widget by its accessible name, for scripts that drive the program with a pointer. It comes from
//! AccessKit's tree, so a widget without a name cannot be found.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use eframe::egui::accesskit::{Node, NodeId, Role};
use eframe::egui::{self, Rect, pos2};

/// The widgets of the last frame.
#[derive(Clone, Debug, Default)]
pub struct Probe {
    widgets: Arc<Mutex<BTreeMap<String, Rect>>>,
}

impl Probe {
    /// Observes every frame of a context from now on.
    pub fn of(context: &egui::Context) -> Self {
        let probe = Self::default();
        context.enable_accesskit();
        context.add_plugin(Observer(probe.clone()));
        probe
    }

    /// Returns the rectangle of the widget of a name, points; of several the first.
    pub fn widget(&self, name: &str) -> Option<Rect> {
        self.lock().get(name).copied()
    }

    /// Returns the rectangles of all widgets by their names.
    pub fn widgets(&self) -> BTreeMap<String, Rect> {
        self.lock().clone()
    }

    fn lock(&self) -> std::sync::MutexGuard<'_, BTreeMap<String, Rect>> {
        // A thread that died while it wrote left a whole map.
        self.widgets.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

struct Observer(Probe);

impl egui::Plugin for Observer {
    fn debug_name(&self) -> &'static str {
        "umbrage::probe"
    }

    fn output_hook(&mut self, _context: &egui::Context, output: &mut egui::FullOutput) {
        let Some(update) = &output.platform_output.accesskit_update else { return };
        let nodes: BTreeMap<NodeId, &Node> = update.nodes.iter().map(|(id, node)| (*id, node)).collect();
        let mut widgets = BTreeMap::new();
        for node in nodes.values().filter(|node| !matches!(node.role(), Role::Label | Role::GenericContainer))
        {
            if let (Some(name), Some(bounds)) = (name(node, &nodes), node.bounds()) {
                let place = Rect::from_min_max(
                    pos2(bounds.x0 as f32, bounds.y0 as f32),
                    pos2(bounds.x1 as f32, bounds.y1 as f32),
                );
                widgets.entry(name).or_insert(place);
            }
        }
        *self.0.lock() = widgets;
    }
}

/// A node's own label, or that of the node that labels it.
fn name(node: &Node, nodes: &BTreeMap<NodeId, &Node>) -> Option<String> {
    let own = |node: &Node| node.label().or(node.value()).map(str::to_owned);
    let by = || node.labelled_by().first().and_then(|id| nodes.get(id)).and_then(|node| own(node));
    by().or_else(|| node.label().map(str::to_owned)).filter(|name| !name.is_empty())
}
