//! Results that are kept, so that nothing is measured twice.
//!
//! A result lies in `runs/<hash>.json` below the store's folder, its pictures beside it as `.jpg`, `.png` (where it is wrong) and `.jpeg` (exact); the hash is that of the run,
//! so of all inputs. Each result carries a checksum of itself and of its pictures: what was cut off, changed or
//! confused with another is as if it were not there, and is made again.
//!
//! This file does not: remove what is no longer asked for, or lock out a second program. Two that write the same
//! result write the same file, each as a whole.

use std::fs;
use std::path::{Path, PathBuf};

use serde::ser::Error as _;
use serde::{Deserialize, Serialize};

use crate::files::{self, hash, make_folder};
use crate::{LabError, Machine, Measurement, Outcome, Pictures, Program, Run};

/// A store is a folder of outcomes that are kept, and who makes them.
#[derive(Clone, Debug)]
pub struct Store {
    runs: PathBuf,
    program: Program,
}

/// What a result's file holds.
#[derive(PartialEq, Serialize, Deserialize)]
struct Stored {
    run: Run,
    machine: Machine,
    measurement: Measurement,
    pictures: Option<PictureHashes>,
}

#[derive(PartialEq, Serialize, Deserialize)]
struct PictureHashes {
    shaded: String,
    error: String,
    exact: String,
}

impl Store {
    /// Opens the store in a folder, which is made where it is not there. `program` is whoever measures.
    ///
    /// # Errors
    /// When the folder cannot be made or written to, so that this is known before anything is measured.
    pub fn open(folder: &Path, program: &Program) -> Result<Self, LabError> {
        make_folder(folder)?;
        let store = Self::at(folder, program);
        files::check_writable(if store.runs.exists() { &store.runs } else { folder })?;
        Ok(store)
    }

    /// The store in a folder that is only read from.
    pub(crate) fn at(folder: &Path, program: &Program) -> Self {
        Self { runs: folder.join("runs"), program: program.clone() }
    }

    /// Returns whoever measures.
    pub fn program(&self) -> &Program {
        &self.program
    }

    /// Lists the runs that have an outcome here, whoever made it, without a look at their pictures.
    pub(crate) fn runs(&self) -> Vec<Run> {
        let files = fs::read_dir(&self.runs).into_iter().flatten().flatten().map(|file| file.path());
        let results = files.filter(|path| path.extension().is_some_and(|extension| extension == "json"));
        results.filter_map(|path| Some(read(&path)?.run)).collect()
    }

    /// Returns the outcome of a run; `None` where there is none, or it is not as it was when it was put there.
    pub fn get(&self, run: &Run) -> Option<Outcome> {
        let key = key(run).ok()?;
        let Stored { run: stored, machine, measurement, pictures } = read(&self.path(&key, "json"))?;
        if stored != *run {
            return None;
        }
        let picture = |extension: &str, wanted: &str| {
            fs::read(self.path(&key, extension)).ok().filter(|bytes| hash(bytes) == wanted)
        };
        let pictures = match pictures {
            None => None,
            Some(PictureHashes { shaded, error, exact }) => Some(Pictures {
                shaded: picture("jpg", &shaded)?,
                error: picture("png", &error)?,
                exact: picture("jpeg", &exact)?,
            }),
        };
        Some(Outcome { machine, measurement, pictures })
    }

    /// Keeps the outcome of a run. Pictures are written first: an outcome counts once its JSON is there.
    ///
    /// # Errors
    /// When a file cannot be written, or the outcome holds a number that JSON does not have: NaN or infinity.
    pub fn put(&self, run: &Run, outcome: &Outcome) -> Result<(), LabError> {
        let Outcome { machine, measurement, pictures } = outcome;
        let key = key(run)?;
        let stored = Stored {
            run: run.clone(),
            machine: machine.clone(),
            measurement: measurement.clone(),
            pictures: pictures.as_ref().map(|Pictures { shaded, error, exact }| PictureHashes {
                shaded: hash(shaded),
                error: hash(error),
                exact: hash(exact),
            }),
        };
        let body = serde_json::to_string(&stored)?;
        // JSON turns numbers that are not finite into null; such a result would be made again and again.
        if !serde_json::from_str::<Stored>(&body).is_ok_and(|read| read == stored) {
            let why = "it holds a number that is not finite";
            return Err(LabError::Json(serde_json::Error::custom(why)));
        }
        make_folder(&self.runs)?;
        if let Some(Pictures { shaded, error, exact }) = pictures {
            files::write(&self.path(&key, "jpg"), shaded)?;
            files::write(&self.path(&key, "png"), error)?;
            files::write(&self.path(&key, "jpeg"), exact)?;
        }
        files::write(&self.path(&key, "json"), sealed(&body).as_bytes())
    }

    fn path(&self, key: &str, extension: &str) -> PathBuf {
        self.runs.join(format!("{key}.{extension}"))
    }
}

/// What a result's file holds; `None` where it is not as it was when it was put there.
fn read(path: &Path) -> Option<Stored> {
    serde_json::from_str(opened(&fs::read_to_string(path).ok()?)?).ok()
}

/// The hash of all that a run holds. Fields are written in the order they are declared in, and there are no maps.
pub(crate) fn key(run: &Run) -> Result<String, LabError> {
    Ok(hash(serde_json::to_string(run)?.as_bytes()))
}

/// A result with its checksum before it. The checksum is of the very bytes, so that it holds for all of them.
fn sealed(body: &str) -> String {
    format!("{{\"sha256\":\"{}\",\"result\":{body}}}\n", hash(body.as_bytes()))
}

/// The result in a sealed text; `None` where the seal is broken.
fn opened(text: &str) -> Option<&str> {
    let (checksum, rest) = text.strip_prefix("{\"sha256\":\"")?.split_once('"')?;
    let body = rest.strip_prefix(",\"result\":")?.strip_suffix("}\n")?;
    (hash(body.as_bytes()) == checksum).then_some(body)
}
