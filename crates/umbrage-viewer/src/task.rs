//! Work that the window does not wait for: on a thread of its own; in a page on the page's own time, after the message that
//! says so was shown.

use std::sync::mpsc::{Receiver, TryRecvError, channel};

use eframe::egui;

/// Work under way.
#[derive(Debug)]
pub struct Task<T> {
    /// What it does, in words for people: "loading knights".
    pub what: String,
    result: Receiver<T>,
}

impl<T: Send + 'static> Task<T> {
    /// Starts work. `context` is asked to repaint when it is done.
    pub fn run(
        what: impl Into<String>,
        context: &egui::Context,
        work: impl FnOnce() -> T + Send + 'static,
    ) -> Self {
        Self::wait_for(what, context, async move {
            #[cfg(target_arch = "wasm32")]
            crate::browser::next_moment().await;
            work()
        })
    }

    /// Waits for something that happens elsewhere, such as a dialog.
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
    /// Waits for something that happens elsewhere, such as a dialog or a file of the browser.
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

impl<T> Task<T> {
    /// Returns the result, once; `None` while the work goes on. Work that died is an error.
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
