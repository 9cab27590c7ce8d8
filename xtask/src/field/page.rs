//! The page of the figures: tables by distance, by scale and by both, before and after.

use std::fmt::Write as _;

use serde_json::Value;

use super::{DISTANCES, LIGHTS, SCALES};

/// What stands above the tables, what they mean, and what the files by others are.
const HEAD: &str = include_str!("head.md");
const MEANING: &str = include_str!("meaning.md");
const FILES: &str = include_str!("files.md");

/// Each placement: its name, its heading, and what it is.
const PLACED: [(&str, &str, &str); 3] = [
    ("node", "Far by a node", "Vertices are small numbers, and one node moves casters, camera and light."),
    (
        "wide",
        "Far by a node, in a wide world",
        "The same, and another court stands near the origin, out of sight, so that no choice of an origin is near to everything.",
    ),
    (
        "baked",
        "Far by their vertices",
        "Vertices hold the distance themselves. At 1000 km an f32 counts in steps of 6 cm, so there the file itself is coarse, and small scenes are flat or gone.",
    ),
];

pub fn page(before: Option<&Value>, now: &Value) -> Option<String> {
    let pages = Pages { before, now };
    let mut text = format!(
        "{HEAD}\nAdapter: {}.\nPictures of {} pixels.\n",
        now["adapter"].as_str()?,
        now["size"].as_str()?
    );
    text += match before {
        Some(_) => "A cell says before → after.\n",
        None => "",
    };
    for (placement, heading, what) in PLACED {
        write!(text, "\n## {heading}\n\n{what}\n\n").ok()?;
        text += "At scale 1, by the distance from the origin:\n\n";
        text += &pages.lights("distance, m", &DISTANCES, |distance| (placement, 1.0, distance))?;
        if placement == "node" {
            text += "\nAt the origin, by scale:\n\n";
            text += &pages.lights("metres a unit", &SCALES, |scale| (placement, scale, 0.0))?;
        }
        for (_, light) in LIGHTS {
            write!(text, "\nThe {light} at every distance (down) and scale (across), mis-shadowed:\n\n")
                .ok()?;
            text += &pages.grid(placement, light)?;
        }
    }
    write!(text, "\n{MEANING}\n{FILES}").ok()?;
    Some(text)
}

/// The figures to show.
struct Pages<'a> {
    before: Option<&'a Value>,
    now: &'a Value,
}

impl Pages<'_> {
    /// A table with a row for each value and both figures of each light.
    fn lights(
        &self,
        title: &str,
        values: &[f64],
        row: impl Fn(f64) -> (&'static str, f64, f64),
    ) -> Option<String> {
        let mut text = format!("| {title} |");
        let mut rule = "|---:|".to_owned();
        for (_, light) in LIGHTS {
            write!(text, " {light}, mis-shadowed | {light}, mae |").ok()?;
            rule += "---:|---:|";
        }
        text = format!("{text}\n{rule}\n");
        for value in values {
            let (placement, scale, distance) = row(*value);
            write!(text, "| {value} |").ok()?;
            for (_, light) in LIGHTS {
                for figure in ["mis_shadowed", "mae"] {
                    write!(text, " {} |", self.cell(placement, light, scale, distance, figure)?).ok()?;
                }
            }
            text += "\n";
        }
        Some(text)
    }

    /// A table of all distances and scales.
    fn grid(&self, placement: &str, light: &str) -> Option<String> {
        let mut text = "| |".to_owned();
        SCALES.iter().for_each(|scale| text += &format!(" {scale} |"));
        text += "\n|---:|";
        SCALES.iter().for_each(|_| text += "---:|");
        text += "\n";
        for distance in DISTANCES {
            write!(text, "| {distance} |").ok()?;
            for scale in SCALES {
                write!(text, " {} |", self.cell(placement, light, scale, distance, "mis_shadowed")?).ok()?;
            }
            text += "\n";
        }
        Some(text)
    }

    fn cell(&self, placement: &str, light: &str, scale: f64, distance: f64, figure: &str) -> Option<String> {
        let of = |figures: &Value| -> Option<String> {
            let row = row(figures, placement, light, scale, distance)?;
            let Some(share) = row[figure].as_f64() else {
                return Some(if row["refused"].is_string() { "refused" } else { "none" }.to_owned());
            };
            // Seen from afar as at the origin, or not.
            let same = is_same_picture(row, self::row(figures, placement, light, scale, 0.0)?)?;
            Some(format!("{}{}", percent(share), if same { "" } else { "*" }))
        };
        let now = of(self.now)?;
        match self.before {
            Some(before) => Some(format!("{} → {now}", of(before)?)),
            None => Some(now),
        }
    }
}

fn row<'a>(figures: &'a Value, placement: &str, light: &str, scale: f64, distance: f64) -> Option<&'a Value> {
    figures["rows"].as_array()?.iter().find(|row| {
        row["placement"] == placement
            && row["light"] == light
            && row["scale"].as_f64() == Some(scale)
            && row["distance"].as_f64() == Some(distance)
    })
}

/// Whether exact shadows are where they are at the origin, as far as counts of pixels tell: within 2 % of them.
fn is_same_picture(row: &Value, at_origin: &Value) -> Option<bool> {
    let near = |key: &str| -> Option<bool> {
        let (here, there) = (row[key].as_f64()?, at_origin[key].as_f64()?);
        Some((here - there).abs() <= 0.02 * there)
    };
    Some(near("pixels")? && near("shadowed")?)
}

/// A share as per cent: three digits, and no more than two behind the point.
fn percent(share: f64) -> String {
    let percent = 100.0 * share;
    if percent < 9.995 { format!("{percent:.2} %") } else { format!("{percent:.1} %") }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    /// Figures that are `share` everywhere, but for one court that is refused.
    fn figures(share: f64) -> Value {
        let mut rows = Vec::new();
        for (placement, ..) in PLACED {
            for (_, light) in LIGHTS {
                for (scale, distance) in SCALES.iter().flat_map(|s| DISTANCES.iter().map(move |d| (*s, *d))) {
                    let mut row = json!({ "placement": placement, "light": light, "scale": scale, "distance": distance });
                    if (placement, light, scale, distance) == ("baked", "sun", 1e-3, 1e6) {
                        row["refused"] = "error: nothing to see".into();
                    } else {
                        row["mis_shadowed"] = share.into();
                        row["mae"] = (2.0 * share).into();
                        row["pixels"] = 1000.into();
                        row["shadowed"] = if distance > 1e5 { 150.into() } else { 100.into() };
                    }
                    rows.push(row);
                }
            }
        }
        json!({ "adapter": "a device", "size": "240x135", "rows": rows })
    }

    #[test]
    fn a_cell_says_both_figures_where_there_are_two_and_what_was_refused() {
        let (before, now) = (figures(0.5), figures(0.001));
        let page = page(Some(&before), &now).expect("a page");
        assert!(page.contains("| 1000 | 50.0 % → 0.10 % | 100.0 % → 0.20 % |"), "{page}");
        assert!(page.contains("| 1000000 | refused → refused |"), "{page}");
        assert!(page.contains("| 1000000 | 50.0 %* → 0.10 %* |"), "another picture is marked: {page}");
    }

    #[test]
    fn figures_alone_stand_alone_and_a_missing_row_is_no_page() {
        let mut now = figures(0.25);
        assert!(page(None, &now).expect("a page").contains("| 0 | 25.0 % | 50.0 % | 25.0 %"), "alone");
        now["rows"].as_array_mut().expect("rows").pop();
        assert!(page(None, &now).is_none(), "a row is missing");
    }
}
