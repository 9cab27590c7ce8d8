//! Work that a window does not wait for: on a thread of its own, or in a page on the page's own time, after what says that
//! it goes on was shown. Triangles are sorted on another thread in a page too.

use std::sync::mpsc::{Receiver, TryRecvError, channel};

use eframe::egui;
use umbrage_judge::{Triangles, World};

/// Work under way, and what it is in words.
#[derive(Debug)]
pub struct Task<T> {
    /// "loading knights": for people.
    pub what: String,
    result: Receiver<T>,
}

impl<T: Send + 'static> Task<T> {
    /// Starts it. `context` is told to paint when it is done.
    pub fn run(
        what: impl Into<String>,
        context: &egui::Context,
        work: impl FnOnce() -> T + Send + 'static,
    ) -> Self {
        Self::wait_for(what, context, async move {
            #[cfg(target_arch = "wasm32")]
            crate::web::next_moment().await;
            work()
        })
    }

    /// Waits for something elsewhere: a dialog, a file of the browser.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn wait_for(
        what: impl Into<String>,
        context: &egui::Context,
        future: impl Future<Output = T> + Send + 'static,
    ) -> Self {
        let (sender, result) = channel();
        let context = context.clone();
        std::thread::spawn(move || {
            // Nobody may want it any more.
            let _ = sender.send(pollster::block_on(future));
            context.request_repaint();
        });
        Self { what: what.into(), result }
    }
}

#[cfg(target_arch = "wasm32")]
impl<T: 'static> Task<T> {
    /// Waits for something elsewhere: a dialog, a file of the browser.
    pub fn wait_for(
        what: impl Into<String>,
        context: &egui::Context,
        future: impl Future<Output = T> + 'static,
    ) -> Self {
        let (sender, result) = channel();
        let context = context.clone();
        wasm_bindgen_futures::spawn_local(async move {
            // Nobody may want it any more.
            let _ = sender.send(future.await);
            context.request_repaint();
        });
        Self { what: what.into(), result }
    }
}

/// Triangles that are being sorted. It fails where what sorts dies of it.
pub type Sorting = Task<Result<World, String>>;

impl Sorting {
    /// Builds the tree over triangles: on a thread of its own, in a page too.
    pub fn sort(
        what: impl Into<String>,
        context: &egui::Context,
        triangles: impl Fn() -> Triangles + Send + 'static,
    ) -> Self {
        Self::wait_for(what, context, async move {
            #[cfg(target_arch = "wasm32")]
            {
                crate::web::next_moment().await;
                crate::web::sorted(triangles).await
            }
            #[cfg(not(target_arch = "wasm32"))]
            Ok(World::build(triangles()))
        })
    }
}

impl<T> Task<T> {
    /// What came of it: `None` while it goes on. Work that died is an error.
    pub fn poll(&self) -> Option<Result<T, String>> {
        match self.result.try_recv() {
            Ok(result) => Some(Ok(result)),
            Err(TryRecvError::Empty) => None,
            Err(TryRecvError::Disconnected) => {
                Some(Err(format!("{} failed, and did not say why", self.what)))
            }
        }
    }
}
