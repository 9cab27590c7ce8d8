//! Results for other programs: every row with every figure, as CSV and as JSON.

use serde_json::{Value, json};

use crate::figures::{self, ALL};
use crate::tabulate::value_text;
use crate::{Experiment, LabError, Row};

/// What comes before the figures of a line.
const BEFORE: [&str; 7] = ["variant", "swept_key", "swept_value", "world", "camera", "motion", "repeat"];

/// What comes after them.
const AFTER: [&str; 7] = ["width", "height", "adapter", "timestamps", "system", "cores", "commit"];

/// Writes one line for each row, after a line of headings. Figures are raw: shares of 1, bytes, milliseconds; a field is
/// empty where there is no such figure. Fields are quoted as RFC 4180 has it.
pub fn csv(experiment: &Experiment, rows: &[Row]) -> String {
    let keys = ALL.iter().map(|figure| figure.key);
    let heading = BEFORE.into_iter().chain(keys).chain(AFTER).map(str::to_owned);
    let mut text = line(heading);
    for row in rows {
        let figures = figures::values(&row.outcome.measurement);
        let figure = |key| figures.iter().find(|(figure, _)| figure.key == key);
        let values =
            ALL.iter().map(|f| figure(f.key).map_or_else(String::new, |(_, value)| value.to_string()));
        text += &line(before(experiment, row).into_iter().chain(values).chain(after(row)));
    }
    text
}

fn before(experiment: &Experiment, row: &Row) -> [String; 7] {
    let variant = experiment.variants.get(row.variant);
    let run = &row.run;
    let motion = run.motion.and_then(|motion| serde_json::to_value(motion).ok());
    [
        variant.map(|variant| variant.name.clone()).unwrap_or_default(),
        variant.and_then(|variant| variant.sweep.as_ref()).map(|sweep| sweep.key.clone()).unwrap_or_default(),
        row.swept.as_ref().map(value_text).unwrap_or_default(),
        run.world.clone(),
        run.camera.clone(),
        motion.as_ref().and_then(Value::as_str).unwrap_or_default().to_owned(),
        run.repeat.to_string(),
    ]
}

fn after(row: &Row) -> [String; 7] {
    let measurement = &row.outcome.measurement;
    let machine = &row.outcome.machine;
    [
        measurement.width.to_string(),
        measurement.height.to_string(),
        machine.adapter.clone(),
        machine.timestamps.to_string(),
        machine.system.clone(),
        machine.cores.to_string(),
        machine.commit.clone(),
    ]
}

fn line(fields: impl Iterator<Item = String>) -> String {
    fields.map(|field| quoted(&field)).collect::<Vec<_>>().join(",") + "\n"
}

/// A field, in quotation marks where it would break the line otherwise.
fn quoted(field: &str) -> String {
    if field.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", field.replace('"', "\"\""))
    } else {
        field.to_owned()
    }
}

/// Writes the experiment, and for each row its inputs, its machine and everything that was measured.
///
/// # Errors
/// When a value has no form in JSON.
pub fn json(experiment: &Experiment, rows: &[Row]) -> Result<Value, LabError> {
    let rows = rows
        .iter()
        .map(|row| {
            Ok(json!({
                "variant": experiment.variants.get(row.variant).map(|variant| &variant.name),
                "swept": serde_json::to_value(&row.swept)?,
                "run": serde_json::to_value(&row.run)?,
                "machine": serde_json::to_value(&row.outcome.machine)?,
                "measurement": serde_json::to_value(&row.outcome.measurement)?,
            }))
        })
        .collect::<Result<Vec<_>, LabError>>()?;
    Ok(json!({ "experiment": serde_json::to_value(experiment)?, "rows": rows }))
}
