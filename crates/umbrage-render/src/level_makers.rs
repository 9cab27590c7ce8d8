//! Who makes levels of detail: threads beside the one that draws, or where there are none, as in a browser, that one, a mesh a
//! frame.

use umbrage_scene::{CasterMesh, Mesh};

/// A mesh by its number in the scene, and which of its parts are wanted.
pub(crate) type Job = (usize, Mesh, Vec<bool>);

/// What has come of it.
#[derive(Debug)]
pub(crate) enum Made {
    /// The levels of the mesh of this number.
    Levels(usize, CasterMesh),
    NotYet,
    /// No more will come.
    Nothing,
}

fn levels((number, mesh, wanted): &Job) -> (usize, CasterMesh) {
    (*number, CasterMesh::with_levels(mesh, |part| wanted.get(part).copied().unwrap_or(false)))
}

#[cfg(not(target_arch = "wasm32"))]
pub(crate) use threads::LevelMakers;

#[cfg(not(target_arch = "wasm32"))]
mod threads {
    use std::sync::atomic::{AtomicUsize, Ordering};
    use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
    use std::sync::{Arc, Mutex, PoisonError};

    use umbrage_scene::CasterMesh;
    use web_time::Instant;

    use super::{Job, Made, levels};

    /// More threads would leave none for what draws meanwhile.
    const MOST: usize = 4;

    /// Threads at work; they end when nobody waits for them.
    #[derive(Debug)]
    pub(crate) struct LevelMakers(Mutex<Receiver<(usize, CasterMesh)>>);

    impl LevelMakers {
        /// The largest meshes are begun first.
        pub fn begin(mut jobs: Vec<Job>) -> Self {
            jobs.sort_by_key(|(_, mesh, _)| std::cmp::Reverse(mesh.triangles()));
            let threads = std::thread::available_parallelism().map_or(1, usize::from).min(MOST);
            let (jobs, next) = (Arc::new(jobs), Arc::new(AtomicUsize::new(0)));
            let (sender, receiver) = channel();
            for _ in 0..threads {
                let (jobs, next, sender) = (Arc::clone(&jobs), Arc::clone(&next), sender.clone());
                // Where no thread can be had, nothing is sent, and meshes cast as they are.
                let _detached = std::thread::Builder::new().name("levels".to_owned()).spawn(move || {
                    while let Some(job) = jobs.get(next.fetch_add(1, Ordering::Relaxed)) {
                        if sender.send(levels(job)).is_err() {
                            break;
                        }
                    }
                });
            }
            Self(Mutex::new(receiver))
        }

        /// What comes next, until some time; whenever it comes where that is never.
        pub fn next(&mut self, deadline: Option<Instant>) -> Made {
            let receiver = self.0.get_mut().unwrap_or_else(PoisonError::into_inner);
            let left = deadline.map(|deadline| deadline.saturating_duration_since(Instant::now()));
            let made = match left {
                Some(left) => receiver.recv_timeout(left),
                None => receiver.recv().map_err(|_| RecvTimeoutError::Disconnected),
            };
            match made {
                Ok((mesh, levels)) => Made::Levels(mesh, levels),
                Err(RecvTimeoutError::Timeout) => Made::NotYet,
                Err(RecvTimeoutError::Disconnected) => Made::Nothing,
            }
        }
    }
}

#[cfg(target_arch = "wasm32")]
pub(crate) use turns::LevelMakers;

#[cfg(target_arch = "wasm32")]
mod turns {
    use web_time::Instant;

    use super::{Job, Made, levels};

    /// What is left to do.
    #[derive(Debug)]
    pub(crate) struct LevelMakers {
        jobs: Vec<Job>,
        is_late: bool,
    }

    impl LevelMakers {
        pub fn begin(jobs: Vec<Job>) -> Self {
            Self { jobs, is_late: false }
        }

        /// What comes next, until some time; whoever has less gets one each time.
        pub fn next(&mut self, deadline: Option<Instant>) -> Made {
            self.is_late = !self.is_late && deadline.is_some_and(|deadline| Instant::now() >= deadline);
            if self.is_late {
                return Made::NotYet;
            }
            self.jobs.pop().map_or(Made::Nothing, |job| {
                let (mesh, levels) = levels(&job);
                Made::Levels(mesh, levels)
            })
        }
    }
}
