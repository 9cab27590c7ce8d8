//! Umbrage as a module of Python: `umbrage._umbrage`, which the Python files beside it make comfortable.
//!
//! A call is a command: it takes the words of the command line, and gives what the command prints, so that both have the same
//! options, the same checks and the same JSON (`docs/decisions/0050-python-speaks-the-commands-words.md`). Pictures come as
//! arrays. Python goes on beside every call.
//!
//! This crate does not: know an option. `python/umbrage` makes words of Python's values.

use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};

use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyByteArray;
use umbrage_cli::library::{self, Shadows};
use umbrage_cli::{Failure, Outcome};
use umbrage_lab::Program;

/// A world that is held in memory.
#[pyclass(frozen, module = "umbrage._umbrage")]
struct Scene {
    scene: Arc<umbrage_scene::Scene>,
    /// What its importer warned of.
    #[pyo3(get)]
    warnings: Vec<String>,
}

#[pymethods]
impl Scene {
    /// Reads a binary glTF file that is held in memory.
    #[staticmethod]
    fn from_glb(py: Python<'_>, glb: &[u8], name: &str) -> PyResult<Self> {
        let imported = py.detach(|| umbrage_scene::load_glb_bytes(glb, name));
        let umbrage_scene::Imported { scene, warnings } =
            imported.map_err(|why| PyValueError::new_err(why.to_string()))?;
        Ok(Self { scene: Arc::new(scene), warnings })
    }

    /// Returns the number of triangles; those of an instance count each time it is placed.
    #[getter]
    fn triangles(&self) -> usize {
        self.scene.triangles()
    }

    /// Returns the names of the cameras.
    #[getter]
    fn cameras(&self) -> Vec<String> {
        self.scene.cameras.iter().map(|camera| camera.name.clone()).collect()
    }
}

/// Does what takes long while Python goes on. A signal that came meanwhile, as Ctrl+C, is heard in the end.
fn beside<T: Send>(py: Python<'_>, work: impl FnOnce() -> Outcome<T> + Send) -> PyResult<T> {
    let done = py.detach(work);
    py.check_signals()?;
    done.map_err(|failure| match &failure {
        Failure::Usage(_) => PyValueError::new_err(failure.to_string()),
        Failure::Work(_) => PyRuntimeError::new_err(failure.to_string()),
    })
}

fn held(scene: Option<&Bound<'_, Scene>>) -> Option<Arc<umbrage_scene::Scene>> {
    scene.map(|scene| Arc::clone(&scene.get().scene))
}

#[pyfunction]
#[pyo3(signature = (words, scene=None))]
fn plan(py: Python<'_>, words: Vec<String>, scene: Option<&Bound<'_, Scene>>) -> PyResult<String> {
    let scene = held(scene);
    beside(py, || library::plan(&words, scene))
}

#[pyfunction]
#[pyo3(signature = (words, scene=None))]
fn measure(py: Python<'_>, words: Vec<String>, scene: Option<&Bound<'_, Scene>>) -> PyResult<String> {
    let scene = held(scene);
    beside(py, || library::measure(&words, scene))
}

/// Returns the number of lights, the height and the width, and then the visibility that was drawn and the true one: the bytes of
/// as many numbers of 32 bits. The true one is NaN where no pixel is judged.
#[pyfunction]
#[pyo3(signature = (words, scene=None))]
fn pictures<'py>(
    py: Python<'py>,
    words: Vec<String>,
    scene: Option<&Bound<'_, Scene>>,
) -> PyResult<([usize; 3], Bound<'py, PyByteArray>, Bound<'py, PyByteArray>)> {
    let scene = held(scene);
    let Shadows { lights, height, width, visibility, truth } =
        beside(py, || library::pictures(&words, scene))?;
    Ok(([lights, height, width], bytes_of(py, &visibility)?, bytes_of(py, &truth)?))
}

fn bytes_of<'py>(py: Python<'py>, numbers: &[f32]) -> PyResult<Bound<'py, PyByteArray>> {
    PyByteArray::new_with(py, size_of_val(numbers), |bytes| {
        for (bytes, number) in bytes.as_chunks_mut().0.iter_mut().zip(numbers) {
            *bytes = number.to_ne_bytes();
        }
        Ok(())
    })
}

/// Makes a report; between two runs it hears Ctrl+C. `own_file` is the file of this module.
#[pyfunction]
fn report(py: Python<'_>, words: Vec<String>, own_file: PathBuf) -> PyResult<String> {
    let interrupt = Mutex::new(None);
    let go_on = || match Python::attach(|py| py.check_signals()) {
        Ok(()) => true,
        Err(why) => {
            *interrupt.lock().unwrap_or_else(PoisonError::into_inner) = Some(why);
            false
        }
    };
    let report = beside(py, || library::report(&words, &Program::of_file(&own_file)?, &go_on));
    match interrupt.into_inner().unwrap_or_else(PoisonError::into_inner) {
        Some(interrupt) => Err(interrupt),
        None => report,
    }
}

#[pyfunction]
fn wgsl(py: Python<'_>, words: Vec<String>) -> PyResult<String> {
    beside(py, || library::wgsl(&words))
}

#[pyfunction]
fn worlds(py: Python<'_>) -> PyResult<String> {
    beside(py, library::worlds)
}

#[pyfunction]
fn settings(py: Python<'_>) -> PyResult<String> {
    beside(py, library::settings)
}

#[pymodule]
fn _umbrage(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", umbrage_lab::VERSION)?;
    module.add_class::<Scene>()?;
    module.add_function(wrap_pyfunction!(plan, module)?)?;
    module.add_function(wrap_pyfunction!(measure, module)?)?;
    module.add_function(wrap_pyfunction!(pictures, module)?)?;
    module.add_function(wrap_pyfunction!(report, module)?)?;
    module.add_function(wrap_pyfunction!(wgsl, module)?)?;
    module.add_function(wrap_pyfunction!(worlds, module)?)?;
    module.add_function(wrap_pyfunction!(settings, module)?)
}
