//! What the source says that can be checked, and whether it holds here.

use crate::figures::Figure;
use crate::page::escape::{escaped, minus};
use crate::page::verdict::{Check, Verdict, checks};
use crate::tabulate::{Group, motion_text};
use crate::{Claim, Experiment};

/// The section; empty where nothing is claimed.
pub(super) fn section(experiment: &Experiment, groups: &[Group]) -> String {
    if experiment.claims.is_empty() {
        return String::new();
    }
    let claims: Vec<(&Claim, Vec<Check>)> =
        experiment.claims.iter().map(|claim| (claim, checks(experiment, claim, groups))).collect();
    let holding = claims.iter().filter(|(_, checks)| tally(checks).holds_everywhere()).count();
    let all = claims.len();
    let is_single = claims.iter().flat_map(|(_, checks)| checks).any(|check| check.ratios.samples.len() == 1);
    let articles: String = claims.iter().map(|(claim, checks)| article(claim, checks)).collect();
    format!(
        "<section id=\"claims\">\n<h2>Does it hold here?</h2>\n\
         <p><strong>{holding} of {all} {}</strong> wherever {} checked. \
         A claim holds where the whole 95&#8239;% interval of the ratio is at most what is claimed, and does not where \
         all of it is above; repeats are paired.{} One verdict in twenty may be chance.</p>\n<div class=\"claims\">\n{articles}</div>\n</section>\n",
        if all == 1 { "claim holds" } else { "claims hold" },
        if all == 1 { "it was" } else { "they were" },
        if is_single { " Where there is one sample, its ratio alone decides." } else { "" },
    )
}

fn article(claim: &Claim, checks: &[Check]) -> String {
    let tally = tally(checks);
    let (class, badge) = tally.badge();
    let figure = Figure::named(&claim.figure);
    let body = match figure {
        None => format!("<p class=\"none\">No figure is called {}.</p>\n", escaped(&claim.figure)),
        Some(_) if checks.is_empty() => {
            "<p class=\"none\">Nothing was measured that it speaks of.</p>\n".to_owned()
        }
        Some(figure) => table(claim, figure, checks),
    };
    format!(
        "<article class=\"claim\">\n<h3><span class=\"badge {class}\">{badge}</span> {}</h3>\n\
         <p class=\"meta\">{}: {} ≤ {} × {}. {}</p>\n{body}</article>\n",
        escaped(&claim.says),
        escaped(&figure.map_or_else(|| claim.figure.clone(), Figure::heading)),
        escaped(&claim.way),
        claim.times,
        escaped(&claim.than),
        tally.text(),
    )
}

fn table(claim: &Claim, figure: &Figure, checks: &[Check]) -> String {
    let has_motion = checks.iter().any(|check| check.motion.is_some());
    let rows: String = checks.iter().map(|check| row(figure, check, has_motion)).collect();
    let head = |name: &str| format!("<th class=\"number\">{}</th>", escaped(name));
    format!(
        "<div class=\"wide\"><table>\n<thead><tr><th>world</th><th>camera</th>{}{}{}<th class=\"number\">ratio</th>\
         <th>verdict</th></tr></thead>\n<tbody>\n{rows}</tbody></table></div>\n",
        if has_motion { "<th>motion</th>" } else { "" },
        head(&claim.way),
        head(&claim.than),
    )
}

fn row(figure: &Figure, check: &Check, has_motion: bool) -> String {
    let motion = check.motion.map_or("", motion_text);
    let motion = if has_motion { format!("<td>{motion}</td>") } else { String::new() };
    let value = |i: usize, swept: &Option<String>| {
        let value =
            check.means.map_or_else(|| "–".to_owned(), |means| minus(&figure.format.number(means[i])));
        let swept = swept.as_ref().map(|at| format!(" <small>at {}</small>", escaped(at)));
        format!("<td class=\"number\">{value}{}</td>", swept.unwrap_or_default())
    };
    let (class, verdict) = check.verdict.words();
    let one = if check.ratios.samples.len() == 1 { " <small>one sample</small>" } else { "" };
    format!(
        "<tr><td>{}</td><td>{}</td>{motion}{}{}<td class=\"number\">{}</td>\
         <td><span class=\"{class}\">{verdict}</span>{one}</td></tr>\n",
        escaped(check.world),
        escaped(check.camera),
        value(0, &check.swept),
        value(1, &check.than_swept),
        ratio_text(check),
    )
}

fn ratio_text(check: &Check) -> String {
    let ratios = &check.ratios;
    if ratios.samples.is_empty() {
        return check.missing.to_owned();
    }
    match (ratios.mean().is_finite(), ratios.samples.len()) {
        (false, _) => "∞".to_owned(),
        (true, 1) => format!("{:.3}", ratios.mean()),
        (true, _) => format!("{:.3} <small>± {:.3}</small>", ratios.mean(), ratios.half_width()),
    }
}

impl Verdict {
    /// Its class in the style sheet, and what the page says.
    fn words(self) -> (&'static str, &'static str) {
        match self {
            Self::Holds => ("holds", "holds"),
            Self::DoesNotHold => ("fails", "does not hold"),
            Self::NotDecided => ("open", "not decided"),
        }
    }
}

/// How many checks came to which verdict.
#[derive(Clone, Copy, Default)]
struct Tally {
    holds: usize,
    fails: usize,
    open: usize,
    /// Without any ratio: nothing to judge there, or nothing measured.
    missing: usize,
}

fn tally(checks: &[Check]) -> Tally {
    let mut tally = Tally::default();
    for check in checks {
        match check.verdict {
            Verdict::Holds => tally.holds += 1,
            Verdict::DoesNotHold => tally.fails += 1,
            Verdict::NotDecided if check.ratios.samples.is_empty() => tally.missing += 1,
            Verdict::NotDecided => tally.open += 1,
        }
    }
    tally
}

impl Tally {
    fn holds_everywhere(self) -> bool {
        self.holds > 0 && self.fails == 0 && self.open == 0
    }

    fn badge(self) -> (&'static str, &'static str) {
        match (self.holds, self.fails) {
            (_, 0) if self.holds_everywhere() => ("holds", "holds"),
            (0, 1..) => ("fails", "does not hold"),
            (1.., 1..) => ("fails", "holds in part"),
            (1.., 0) => ("open", "holds in part"),
            (0, 0) => ("open", "not decided"),
        }
    }

    fn text(self) -> String {
        let Self { holds, fails, open, missing } = self;
        let all = holds + fails + open;
        let parts = [(holds, "holds"), (fails, "does not hold"), (open, "is not decided")];
        let parts: Vec<String> = parts
            .iter()
            .filter(|(count, _)| *count > 0)
            .map(|(count, words)| format!("{words} in {count} of {all}"))
            .collect();
        let verdicts = if parts.is_empty() { String::new() } else { format!("It {}.", parts.join(", ")) };
        let without = if missing == 0 { String::new() } else { format!(" No ratio in {missing}.") };
        verdicts + &without
    }
}
