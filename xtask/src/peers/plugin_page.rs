//! The page of the plug-in's figures: a row for each way to draw, and the ratios that the plug-in is held to.

use std::fmt::Write as _;

use serde_json::Value;

use super::page::{WITH, divided, median, of};
use super::plugin::WAYS;

/// What stands above the tables.
const HEAD: &str = include_str!("bevy_head.md");
/// The plug-in is meant to leave no more than this share of the wrong pixels of stock Bevy's better way…
const MOST_WRONG: f64 = 0.5;
/// … in no more than this share of the time of its quicker way.
const MOST_TIME: f64 = 1.1;

/// The page; `None` where a key is missing.
pub fn page(figures: &Value) -> Option<String> {
    let rows = figures["rows"].as_array()?;
    let word = |key: &str| figures[key].as_str();
    let adapter = rows.first()?["ways"]["umbrage"]["adapter"].as_str()?;
    let mut text = format!(
        "{HEAD}\nMachine: {}; {adapter}. Other programs ran beside.\nCommit: {}.\nCommand: `{}`.\nPictures of {} pixels; {}.\n",
        word("machine")?,
        word("commit")?,
        word("command")?,
        word("size")?,
        rounds(figures),
    );
    text += "\n## The plug-in against stock Bevy\n\nAgainst the stock way that is wrong in fewer pixels, and against the one that is quicker.\n\n| world, camera | MiB | wrong pixels / stock's | frame / stock's |\n|---|---:|---:|---:|\n";
    let found = rows.iter().map(against_stock).collect::<Option<Vec<_>>>()?;
    for (row, (wrong, times)) in rows.iter().zip(&found) {
        let times = spread(times.clone());
        writeln!(text, "| {} | {} | {wrong:.2} | {times} |", place(row)?, mebibytes(row)?).ok()?;
    }
    text += &met(&found);
    text += "\n## Each way\n\nMilliseconds of a frame with shadows, the share of mis-shadowed pixels among those judged, and the mean error of visibility, 0 to 1.\n\n| world, camera | MiB | way | frame | pixels | mis-shadowed | mean error | cascades end at, m |\n|---|---:|---|---:|---:|---:|---:|---|\n";
    for row in rows {
        for (way, _) in WAYS {
            writeln!(text, "{}", line(row, way)?).ok()?;
        }
    }
    Some(text)
}

/// How frames were timed.
fn rounds(figures: &Value) -> String {
    match figures["rounds"].as_u64() {
        Some(0) => "frames were not timed, since the machine was too busy".to_owned(),
        _ => format!("{} rounds of {} frames of each kind", figures["rounds"], figures["frames"]),
    }
}

/// In how many rows the plug-in does what it is held to; where no frame was timed, the wrong pixels alone count.
fn met(found: &[(f64, Vec<f64>)]) -> String {
    let are_timed = found.iter().all(|(_, times)| !times.is_empty());
    let is_met = |(wrong, times): &&(f64, Vec<f64>)| {
        *wrong <= MOST_WRONG && (!are_timed || median(times.clone()) <= MOST_TIME)
    };
    let (met, count) = (found.iter().filter(is_met).count(), found.len());
    let time = if are_timed { format!(" in at most {MOST_TIME} of the time") } else { String::new() };
    format!("\nAt most {MOST_WRONG} of the wrong pixels{time}: {met} of {count}.\n")
}

/// The median with the least and the greatest, or that nothing was timed.
fn spread(times: Vec<f64>) -> String {
    if times.is_empty() { "not timed".to_owned() } else { of(times) }
}

/// One way of a row.
fn line(row: &Value, way: &str) -> Option<String> {
    let found = &row["ways"][way];
    let judged = &found["judged"];
    let ends = found["cascades"].as_array()?.iter().map(|end| end.as_f64().map(|end| format!("{end:.1}")));
    Some(format!(
        "| {} | {} | {way} | {} | {} | {:.3} % | {:.4} | {} |",
        place(row)?,
        mebibytes(row)?,
        spread(times(row, way)?),
        judged["pixels"],
        100.0 * wrong(row, way)?,
        judged["error"]["mae"].as_f64()?,
        ends.collect::<Option<Vec<_>>>()?.join(", "),
    ))
}

/// The share of stock's wrong pixels that the plug-in leaves, and the share of stock's time that it takes in each round; no
/// share where nothing was timed.
fn against_stock(row: &Value) -> Option<(f64, Vec<f64>)> {
    let stock: Vec<&str> = WAYS.iter().map(|way| way.0).filter(|way| *way != "umbrage").collect();
    let least_wrong = stock.iter().map(|way| wrong(row, way)).collect::<Option<Vec<_>>>()?;
    let least_wrong = least_wrong.into_iter().min_by(f64::total_cmp)?;
    let quicker = stock.iter().map(|way| times(row, way)).collect::<Option<Vec<_>>>()?;
    let quicker = quicker.into_iter().min_by(|a, b| median(a.clone()).total_cmp(&median(b.clone())))?;
    let ratios = divided(times(row, "umbrage")?, quicker).unwrap_or_default();
    Some((wrong(row, "umbrage")? / least_wrong, ratios))
}

fn wrong(row: &Value, way: &str) -> Option<f64> {
    row["ways"][way]["judged"]["error"]["mis_shadowed"].as_f64()
}

fn times(row: &Value, way: &str) -> Option<Vec<f64>> {
    row["ways"][way]["milliseconds"][WITH].as_array()?.iter().map(Value::as_f64).collect()
}

fn place(row: &Value) -> Option<String> {
    Some(format!("{}, {}", row["world"].as_str()?, row["camera"].as_str()?))
}

/// Of four maps in 32 bits.
fn mebibytes(row: &Value) -> Option<u64> {
    let side = row["resolution"].as_u64()?;
    Some(4 * 4 * side * side / (1 << 20))
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    /// Figures of a view that three ways drew in frames of these times.
    fn figures(rounds: u32, of_ways: [&[f64]; 3]) -> Value {
        let way = |times: &[f64], wrong: f64| {
            json!({
                "adapter": "a", "milliseconds": { "shadows": times }, "cascades": [3.0, 40.0],
                "judged": { "pixels": 100, "error": { "mis_shadowed": wrong, "mae": 0.01 } },
            })
        };
        let [gaussian, hardware, umbrage] = of_ways;
        json!({
            "machine": "m", "commit": "c", "command": "cargo xtask bevy", "size": "640x360", "rounds": rounds, "frames": 14,
            "rows": [{ "world": "w", "camera": "main", "resolution": 2048, "ways": {
                "gaussian": way(gaussian, 0.08), "hardware": way(hardware, 0.04), "umbrage": way(umbrage, 0.01),
            } }],
        })
    }

    #[test]
    fn the_plugin_is_set_against_the_better_and_the_quicker_of_stock() {
        let page = page(&figures(2, [&[200.0, 200.0], &[100.0, 100.0], &[105.0, 99.0]])).expect("a page");
        assert!(page.contains("| w, main | 64 | 0.25 | 1.02 (0.99 to 1.05) |"), "{page}");
        assert!(page.contains("in at most 1.1 of the time: 1 of 1."), "{page}");
        assert!(
            page.contains(
                "| w, main | 64 | hardware | 100 (100 to 100) | 100 | 4.000 % | 0.0100 | 3.0, 40.0 |"
            ),
            "{page}"
        );
    }

    #[test]
    fn frames_that_were_not_timed_are_said_to_be() {
        let page = page(&figures(0, [&[]; 3])).expect("a page");
        assert!(page.contains("frames were not timed"), "{page}");
        assert!(page.contains("| w, main | 64 | 0.25 | not timed |"), "{page}");
        assert!(page.contains("At most 0.5 of the wrong pixels: 1 of 1."), "{page}");
        assert!(
            page.contains("| w, main | 64 | umbrage | not timed | 100 | 1.000 % | 0.0100 | 3.0, 40.0 |"),
            "{page}"
        );
    }
}
