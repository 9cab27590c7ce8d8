//! What `umbrage report` leaves in a folder, from which documents are put together: results and verdicts as JSON, tables
//! as Markdown, plots as SVG.

use std::path::{Path, PathBuf};

use anyhow::Context as _;
use serde_json::Value;

use crate::command::{root, umbrage};

/// Where reports are written, seen from the repository's root.
const FOLDER: &str = "target/report";

/// The reports of some experiments.
pub struct Reports {
    folder: PathBuf,
}

impl Reports {
    /// Runs experiments, named without their folder and ending, unless `pages` is a folder that has their reports already.
    pub fn of(experiments: &[&str], adapter: Option<&str>, pages: Option<&Path>) -> anyhow::Result<Self> {
        if pages.is_none() {
            for name in experiments {
                let experiment = format!("experiments/{name}.toml");
                let mut args = vec!["report", &experiment, "-o", FOLDER];
                args.extend(adapter.iter().flat_map(|adapter| ["--adapter", adapter]));
                umbrage(&args)?;
            }
        }
        Ok(Self { folder: root().join(pages.unwrap_or(Path::new(FOLDER))) })
    }

    /// Everything that was measured for an experiment.
    pub fn results(&self, experiment: &str) -> anyhow::Result<Value> {
        Ok(serde_json::from_str(&self.read(&format!("{experiment}.json"))?)?)
    }

    /// What was found of an experiment's claims.
    pub fn verdicts(&self, experiment: &str) -> anyhow::Result<Value> {
        Ok(serde_json::from_str(&self.read(&format!("{experiment}/verdicts.json"))?)?)
    }

    /// A table of an experiment, as Markdown.
    pub fn table(&self, experiment: &str, table: &str) -> anyhow::Result<String> {
        self.read(&format!("{experiment}/tables/{table}.md"))
    }

    /// Copies the first plots of an experiment, in its order, to files in `docs/pictures`.
    pub fn copy_plots<'f>(
        &self,
        experiment: &str,
        files: impl IntoIterator<Item = &'f str>,
    ) -> anyhow::Result<()> {
        files
            .into_iter()
            .enumerate()
            .try_for_each(|(i, file)| self.copy_picture(&format!("{experiment}/plots/{}.svg", i + 1), file))
    }

    /// Copies a picture of a report to a file in `docs/pictures`.
    pub fn copy_picture(&self, picture: &str, file: &str) -> anyhow::Result<()> {
        let to = root().join("docs/pictures").join(file);
        std::fs::copy(self.folder.join(picture), to).with_context(|| self.missing(picture))?;
        Ok(())
    }

    fn read(&self, file: &str) -> anyhow::Result<String> {
        std::fs::read_to_string(self.folder.join(file)).with_context(|| self.missing(file))
    }

    fn missing(&self, file: &str) -> String {
        format!("no {file} in {}", self.folder.display())
    }
}
