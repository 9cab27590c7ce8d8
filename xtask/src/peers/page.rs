//! The page of the figures.

use std::fmt::Write as _;

use serde_json::Value;

use super::program::Peer;

/// What stands above the tables.
const HEAD: &str = include_str!("head.md");

/// The page; `None` where a key is missing.
pub fn page(figures: &Value) -> Option<String> {
    let rows = figures["rows"].as_array()?;
    let mut text = format!(
        "{HEAD}\nMachine: {}.\nCommit: {}.\nCommand: `{}`.\nPictures of {} pixels; {} rounds of {} frames of each kind.\n\n{}",
        figures["machine"].as_str()?,
        figures["commit"].as_str()?,
        figures["command"].as_str()?,
        figures["size"].as_str()?,
        figures["rounds"],
        figures["frames"],
        versions(rows),
    );
    text += "\n## Frames\n\nMilliseconds.\n\n| world, camera | triangles | program | without | with | cost of shadows | with / without |\n|---|---:|---|---:|---:|---:|---:|\n";
    each(rows, |row, peer, found| {
        let cells =
            [found.spread(WITHOUT), found.spread(WITH), found.cost().map(of), found.ratio_of(WITH, WITHOUT)];
        let cells = cells.map(Option::unwrap_or_default).join(" | ");
        writeln!(text, "| {} | {} | {peer} | {cells} |", place(row)?, row["triangles"]).ok()
    })?;
    text += "\n## Umbrage against Bevy\n\nBoth on one driver. *Kept* is Umbrage's frame where tiles are kept; milliseconds of its passes, each frame waited for.\n\n| world, camera | cost / Bevy's cost | with / Bevy's with | with / Bevy's without | without / Bevy's without | kept / Bevy's with | casters, ms | shading with, without, ms |\n|---|---:|---:|---:|---:|---:|---:|---:|\n";
    let mut costs = Vec::new();
    for row in rows {
        let (Some(ours), Some(bevy)) = (Found::of(row, Peer::Umbrage), Found::of(row, Peer::Bevy)) else {
            continue;
        };
        costs.extend(divided(ours.cost()?, bevy.cost()?).map(median));
        let against = |our: &str, their: &str| divided(ours.times(our)?, bevy.times(their)?).map(of);
        let cells = [
            divided(ours.cost()?, bevy.cost()?).map(of),
            against(WITH, WITH),
            against(WITH, WITHOUT),
            against(WITHOUT, WITHOUT),
            against("kept", WITH),
            ours.spread("casters"),
            Some(format!("{}, {}", ours.spread("shading")?, ours.spread("shading_without")?)),
        ];
        writeln!(text, "| {} | {} |", place(row)?, cells.map(Option::unwrap_or_default).join(" | ")).ok()?;
    }
    if !costs.is_empty() {
        let mean = costs.iter().sum::<f64>() / costs.len() as f64;
        write!(text, "\nThe mean of the costs' medians: {mean:.2} of Bevy's.\n").ok()?;
    }
    text += &errors(rows)?;
    text += &not_measured(figures, rows)?;
    Some(text)
}

pub const WITH: &str = "shadows";
const WITHOUT: &str = "no_shadows";

/// How wrong each is, by the judge.
fn errors(rows: &[Value]) -> Option<String> {
    let mut text = "\n## How wrong\n\nBy exact rays (`umbrage measure --pictures`): the share of wrong pixels, and the mean error of visibility, 0 to 1.\nOthers' visibility is taken from three pictures, (S − A) / (U − A) in linear light: with shadows, without, and by ambient light alone.\nPixels where the last two are nearly alike are left out, most of them seen aslant by the sun; *ours there* has Umbrage's figures over the same pixels.\n\n| world, camera | program | pixels | of those judged | mis-shadowed | mean error | ours there | mis-shadowed, ours / theirs |\n|---|---|---:|---:|---:|---:|---:|---:|\n".to_owned();
    each(rows, |row, peer, found| {
        let judged = &found.0["judged"];
        let Some(wrong) = judged["error"]["mis_shadowed"].as_f64() else { return Some(()) };
        let share = 100.0 * judged["share"].as_f64()?;
        let both = |of: &Value| {
            Some(format!("{:.3} %, {:.4}", 100.0 * of["mis_shadowed"].as_f64()?, of["mae"].as_f64()?))
        };
        let ours = both(&judged["ours"]).unwrap_or_default();
        let ratio = judged["ours"]["mis_shadowed"].as_f64().filter(|_| wrong > 0.0).map(|ours| ours / wrong);
        let ratio = ratio.map_or_else(String::new, |ratio| format!("{ratio:.2}"));
        let mae = judged["error"]["mae"].as_f64()?;
        writeln!(
            text,
            "| {} | {peer} | {} | {share:.1} % | {:.3} % | {mae:.4} | {ours} | {ratio} |",
            place(row)?,
            judged["pixels"],
            100.0 * wrong
        )
        .ok()
    })?;
    Some(text)
}

/// What is missing in the tables, and what to do.
fn not_measured(figures: &Value, rows: &[Value]) -> Option<String> {
    let mut lost = Vec::new();
    for missing in figures["not_there"].as_array()? {
        lost.push(format!("* {}: {}.", missing["peer"].as_str()?, missing["todo"].as_str()?));
    }
    for row in rows {
        for peer in Peer::ALL {
            let found = &row["peers"][peer.name()];
            let why = [&found["failed"], &found["judged"]["failed"]].into_iter().find_map(Value::as_str);
            lost.extend(
                why.map(|why| format!("* {} in {}: {why}.", peer.name(), place(row).unwrap_or_default())),
            );
            let (theirs, ours) = (found["triangles"].as_u64(), row["triangles"].as_u64());
            let counts = theirs.zip(ours).filter(|(theirs, ours)| theirs != ours);
            lost.extend(counts.map(|(theirs, ours)| {
                let place = place(row).unwrap_or_default();
                format!("* {} in {place} has {theirs} triangles of {ours}.", peer.name())
            }));
        }
    }
    (!lost.is_empty())
        .then(|| format!("\n## Not measured\n\n{}\n", lost.join("\n")))
        .or_else(|| Some(String::new()))
}

/// What drew, in which version, on which adapter.
fn versions(rows: &[Value]) -> String {
    let of = |peer: Peer| {
        let found = rows.iter().find_map(|row| Found::of(row, peer))?.0;
        let word = |key: &str| found[key].as_str().unwrap_or_default();
        Some(format!("* {} {}, on {}.\n", word("peer"), word("version"), word("adapter").trim()))
    };
    Peer::ALL.into_iter().filter_map(of).collect()
}

/// Does something for what each program found in each row.
fn each(rows: &[Value], mut then: impl FnMut(&Value, &str, &Found<'_>) -> Option<()>) -> Option<()> {
    for row in rows {
        for peer in Peer::ALL {
            if let Some(found) = Found::of(row, peer) {
                then(row, found.0["peer"].as_str()?, &found)?;
            }
        }
    }
    Some(())
}

fn place(row: &Value) -> Option<String> {
    Some(format!("{}, {}", row["world"].as_str()?, row["camera"].as_str()?))
}

/// What a program found of a view.
struct Found<'a>(&'a Value);

impl<'a> Found<'a> {
    /// `None` where it was not measured.
    fn of(row: &'a Value, peer: Peer) -> Option<Self> {
        let found = &row["peers"][peer.name()];
        (found.is_object() && found["failed"].is_null()).then_some(Self(found))
    }

    /// Times of a kind, a round each.
    fn times(&self, kind: &str) -> Option<Vec<f64>> {
        self.0["milliseconds"][kind].as_array()?.iter().map(Value::as_f64).collect()
    }

    fn spread(&self, kind: &str) -> Option<String> {
        self.times(kind).filter(|times| !times.is_empty()).map(of)
    }

    fn ratio_of(&self, kind: &str, other: &str) -> Option<String> {
        divided(self.times(kind)?, self.times(other)?).map(of)
    }

    /// What shadows cost, a round each.
    fn cost(&self) -> Option<Vec<f64>> {
        let (with, without) = (self.times(WITH)?, self.times(WITHOUT)?);
        Some(with.iter().zip(without).map(|(with, without)| with - without).collect())
    }
}

/// Round by round; `None` without any.
pub fn divided(these: Vec<f64>, those: Vec<f64>) -> Option<Vec<f64>> {
    let ratios: Vec<f64> = these.iter().zip(those).map(|(this, that)| this / that).collect();
    (!ratios.is_empty()).then_some(ratios)
}

/// The median, and the least and greatest.
pub fn of(mut values: Vec<f64>) -> String {
    values.sort_by(f64::total_cmp);
    let [low, high] = [values.first(), values.last()].map(|value| value.copied().unwrap_or_default());
    let digits = if high.abs() < 10.0 { 2 } else { 0 };
    format!("{:.digits$} ({low:.digits$} to {high:.digits$})", median(values))
}

pub fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    let middle = values.len() / 2;
    match values.len() {
        0 => 0.0,
        even if even % 2 == 0 => 0.5 * (values[middle - 1] + values[middle]),
        _ => values[middle],
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn figures() -> Value {
        let times = |without: [f64; 2], with: [f64; 2]| json!({ "no_shadows": without, "shadows": with });
        let mut ours = times([50.0, 60.0], [80.0, 100.0]);
        for kind in ["kept", "casters", "shading", "shading_without"] {
            ours[kind] = json!([10.0, 10.0]);
        }
        json!({
            "machine": "m", "commit": "c", "command": "cargo xtask peers", "size": "640x360", "rounds": 2, "frames": 14,
            "not_there": [{ "peer": "three", "todo": "`npm ci` in bench/peers/web" }],
            "rows": [{
                "world": "w", "camera": "main", "triangles": 12, "peers": {
                    "umbrage": { "peer": "Umbrage", "version": "1", "adapter": "a", "triangles": 12, "milliseconds": ours,
                        "judged": { "pixels": 100, "share": 1.0, "error": { "mis_shadowed": 0.01, "mae": 0.02 } } },
                    "bevy": { "peer": "Bevy", "version": "2", "adapter": "b", "triangles": 11,
                        "milliseconds": times([100.0, 100.0], [160.0, 140.0]),
                        "judged": { "pixels": 80, "share": 0.8, "error": { "mis_shadowed": 0.04, "mae": 0.05 },
                            "ours": { "mis_shadowed": 0.01, "mae": 0.01 } } },
                    "babylon": { "failed": "no context" },
                },
            }],
        })
    }

    #[test]
    fn ratios_are_of_what_stood_in_one_round() {
        let page = page(&figures()).expect("a page");
        // 30 / 60 and 40 / 40.
        assert!(page.contains("| w, main | 0.75 (0.50 to 1.00) | 0.61 (0.50 to 0.71) |"), "{page}");
        assert!(page.contains("The mean of the costs' medians: 0.75 of Bevy's."), "{page}");
        assert!(
            page.contains("| w, main | Bevy | 80 | 80.0 % | 4.000 % | 0.0500 | 1.000 %, 0.0100 | 0.25 |"),
            "{page}"
        );
    }

    #[test]
    fn nothing_is_left_out_without_a_word() {
        let page = page(&figures()).expect("a page");
        for said in [
            "three: `npm ci` in bench/peers/web.",
            "babylon in w, main: no context.",
            "bevy in w, main has 11 triangles of 12.",
        ] {
            assert!(page.contains(said), "{said} in {page}");
        }
    }
}
