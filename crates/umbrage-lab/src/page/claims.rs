//! What the source says that can be checked, and whether it holds here.

use maud::{Markup, html};
use serde_json::{Value, json};

use super::escape::{Text, minus};
use super::table::{Field, Group, Kind, Part, Table};
use super::tally::{Tally, tally};
use super::verdict::{Check, checks};
use crate::figures::Figure;
use crate::tabulate::{self, motion_text};
use crate::{Claim, Experiment};

/// A claim with all that was found of it.
pub(super) struct Checked<'a> {
    claim: &'a Claim,
    checks: Vec<Check<'a>>,
    /// The figures it was checked by; `None` where it speaks of nothing that was measured.
    pub table: Option<Table>,
}

/// Every claim of an experiment, checked.
pub(super) fn checked<'a>(experiment: &'a Experiment, groups: &[tabulate::Group<'a>]) -> Vec<Checked<'a>> {
    let checked = |claim| {
        let checks = checks(experiment, claim, groups);
        let figure = Figure::named(&claim.figure).filter(|_| !checks.is_empty());
        let table = figure.map(|figure| table(claim, figure, &checks));
        Checked { claim, checks, table }
    };
    experiment.claims.iter().map(checked).collect()
}

/// The section; empty where nothing is claimed.
pub(super) fn section(claims: &[Checked]) -> Markup {
    if claims.is_empty() {
        return html! {};
    }
    let holding = claims.iter().filter(|claim| tally(&claim.checks).holds_everywhere()).count();
    let all = claims.len();
    let is_single =
        claims.iter().flat_map(|claim| &claim.checks).any(|check| check.ratios.samples.len() == 1);
    let (hold, was) = if all == 1 { ("claim holds", "it was") } else { ("claims hold", "they were") };
    html! {
        section id="claims" { "\n"
            h2 { "Does it hold here?" } "\n"
            p {
                strong { (holding) " of " (all) " " (hold) } " wherever " (was) " checked. "
                "A claim holds where the whole 95\u{202f}% interval of the ratio is at most what is claimed, and does \
                 not where all of it is above; repeats are paired."
                @if is_single { " Where there is one sample, its ratio alone decides." }
                " One verdict in twenty may be chance."
            } "\n"
            div.claims { "\n" @for claim in claims { (article(claim)) "\n" } } "\n"
        }
    }
}

fn article(Checked { claim, checks, table }: &Checked) -> Markup {
    let tally = tally(checks);
    let (class, badge) = tally.badge();
    let figure = Figure::named(&claim.figure);
    let heading = figure.map_or_else(|| claim.figure.clone(), Figure::heading);
    html! {
        article.claim { "\n"
            h3 { span class={ "badge " (class) } { (badge) } " " (Text(&claim.says)) } "\n"
            p.meta {
                (Text(&heading)) ": " (Text(&claim.variant)) " ≤ " (claim.times) " × " (Text(&claim.than)) ". "
                (tally.text())
            } "\n"
            @match (figure, table) {
                (_, Some(table)) => (table.html()),
                (None, None) => p.none { "No figure is called " (Text(&claim.figure)) "." },
                (Some(_), None) => p.none { "Nothing was measured that it speaks of." },
            }
        }
    }
}

fn table(claim: &Claim, figure: &Figure, checks: &[Check]) -> Table {
    let has_motion = checks.iter().any(|check| check.motion.is_some());
    let mut heads = vec![Field::plain(Kind::Words, "world"), Field::plain(Kind::Words, "camera")];
    heads.extend(has_motion.then(|| Field::plain(Kind::Words, "motion")));
    heads.extend([&claim.variant, &claim.than].map(|name| Field::plain(Kind::Number, name)));
    heads.extend([Field::plain(Kind::Number, "ratio"), Field::plain(Kind::Words, "verdict")]);
    let rows = checks.iter().map(|check| row(figure, check, has_motion)).collect();
    Table { heads, groups: vec![Group { title: None, rows }] }
}

fn row(figure: &Figure, check: &Check, has_motion: bool) -> Vec<Field> {
    let value = |i: usize, swept: &Option<String>| {
        let number = |means: [f64; 2]| minus(&figure.format.number(means[i]));
        let mut parts = vec![Part::Plain(check.means.map_or_else(|| "–".to_owned(), number))];
        parts.extend(swept.as_ref().map(|at| Part::Small(format!("at {at}"))));
        let beside = figure.companion().zip(check.beside);
        parts.extend(
            beside.map(|(of, means)| Part::Small(format!("{} {}", of.label, minus(&of.text(means[i]))))),
        );
        Field::new(Kind::Number, parts)
    };
    let (class, words) = check.verdict.words();
    let mut verdict = vec![Part::Verdict(class, words)];
    if check.ratios.samples.len() == 1 {
        verdict.push(Part::Small("one sample".to_owned()));
    }
    let mut fields = vec![Field::plain(Kind::Words, check.world), Field::plain(Kind::Words, check.camera)];
    fields.extend(has_motion.then(|| Field::plain(Kind::Words, check.motion.map_or("", motion_text))));
    fields.extend([
        value(0, &check.swept),
        value(1, &check.than_swept),
        Field::new(Kind::Number, ratio(check)),
        Field::new(Kind::Words, verdict),
    ]);
    fields
}

fn ratio(check: &Check) -> Vec<Part> {
    let ratios = &check.ratios;
    if ratios.samples.is_empty() {
        return vec![Part::Plain(check.missing.to_owned())];
    }
    match (ratios.mean().is_finite(), ratios.samples.len()) {
        (false, _) => vec![Part::Plain("∞".to_owned())],
        (true, 1) => vec![Part::Plain(format!("{:.3}", ratios.mean()))],
        (true, _) => vec![
            Part::Plain(format!("{:.3}", ratios.mean())),
            Part::Small(format!("± {:.3}", ratios.half_width())),
        ],
    }
}

/// Everything that was found of the claims, for other programs. Ratios against 0 are not finite, and null.
pub(super) fn json(claims: &[Checked]) -> Value {
    claims.iter().enumerate().map(|(i, claim)| claim_json(i, claim)).collect()
}

fn claim_json(index: usize, Checked { claim, checks, table }: &Checked) -> Value {
    let tally @ Tally { holds, fails, open, missing } = tally(checks);
    let (_, verdict) = tally.badge();
    let Claim { says, figure, variant, than, times, worlds: _, cameras: _ } = claim;
    json!({
        "says": says,
        "figure": figure,
        "variant": variant,
        "than": than,
        "times": times,
        "verdict": verdict,
        "counts": { "holds": holds, "does_not_hold": fails, "not_decided": open, "no_ratio": missing },
        "table": table.as_ref().map(|_| table_name(index)),
        "checks": checks.iter().map(check_json).collect::<Value>(),
    })
}

/// What the table of a claim is called, where tables are files.
pub(super) fn table_name(index: usize) -> String {
    format!("claim-{}", index + 1)
}

fn check_json(check: &Check) -> Value {
    let Check { world, camera, motion, swept, than_swept, means, beside, ratios, verdict, missing } = check;
    let is_measured = !ratios.samples.is_empty();
    json!({
        "world": world,
        "camera": camera,
        "motion": motion,
        "swept": swept,
        "than_swept": than_swept,
        "means": means,
        "beside": beside,
        "ratios": ratios.samples,
        "ratio": is_measured.then(|| ratios.mean()),
        "half_width": is_measured.then(|| ratios.half_width()),
        "verdict": verdict.words().1,
        "missing": (!missing.is_empty()).then_some(missing),
    })
}
