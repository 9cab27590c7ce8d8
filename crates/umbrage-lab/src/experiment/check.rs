//! Whether everything that an experiment names exists, before anything runs.

use std::ops::RangeInclusive;
use std::path::Path;

use toml::Value;
use umbrage_render::RenderError;

use super::source::{Source, Step, Step::Item, Step::Key};
use super::{Claim, Experiment, Plot, Sweep, Variant};
use crate::LabError;
use crate::figures::{self, Figure};
use crate::path::{Motion, Watch};
use crate::run::AreaLight;
use crate::settings::WrongSettings;

/// The longest side of a picture, pixels: the largest texture that adapters commonly have.
const MAX_SIDE_PX: u32 = 16_384;

/// As `umbrage bench`.
const MAX_FRAMES: u32 = 100_000;

/// More jittered cameras than any interval needs; a slip of the keyboard should not fill the memory.
const MAX_REPEATS: u32 = 1_000;

/// A minute of frames at a fair rate, and a point for every pixel of a good screen: a slip of the keyboard should not take
/// a year.
const MAX_WATCHED: Watch = Watch { frames: 10_000, points: 2_000_000 };

/// Points of a light, as `umbrage measure` takes them.
const LIGHT_POINTS: RangeInclusive<u32> = 8..=65_536;

type Checked = Result<(), LabError>;

/// Names the first thing that is wrong. `cameras` gives the names of a world's cameras; it is asked last, for it takes
/// the most time.
pub fn check(
    source: &Source<'_>,
    experiment: &Experiment,
    cameras: impl FnMut(&str, u64) -> Result<Vec<String>, LabError>,
) -> Checked {
    let Experiment {
        title: _,
        source: _,
        reported: _,
        worlds,
        cameras: _,
        variants,
        seed: _,
        size,
        repeats,
        frames,
        pictures: _,
        enlarged,
        motions,
        watch,
        truths,
        light_points,
        columns,
        plots,
        claims,
    } = experiment;
    check_lists(source, experiment)?;
    check_worlds(source, worlds)?;
    check_numbers(source, *size, *repeats, *frames)?;
    for (world, part) in enlarged {
        check_enlarged(source, world, *part, experiment)?;
    }
    unique(source, &[Key("motions")], motions)?;
    check_watch(source, *watch)?;
    unique(source, &[Key("truths")], truths)?;
    if !LIGHT_POINTS.contains(light_points) {
        let (min, max) = (LIGHT_POINTS.start(), LIGHT_POINTS.end());
        let wrong = format!("wanted from {min} to {max} points of each light, got {light_points}");
        return Err(source.refusal(&[Key("light_points")], wrong));
    }
    for (i, variant) in variants.iter().enumerate() {
        check_area(source, i, variant.area, motions)?;
        check_family(source, i, variant, motions)?;
        check_variant(source, i, variant, worlds)?;
    }
    for (i, column) in columns.iter().enumerate() {
        check_figure(source, &[Key("columns"), Item(i)], column)?;
    }
    for (i, plot) in plots.iter().enumerate() {
        check_plot(source, i, plot, variants)?;
    }
    for (i, claim) in claims.iter().enumerate() {
        check_claim(source, i, claim, experiment)?;
    }
    check_cameras(source, experiment, cameras)
}

fn check_enlarged(
    source: &Source<'_>,
    world: &str,
    [left, top, width, height]: [u32; 4],
    experiment: &Experiment,
) -> Checked {
    let at = [Key("enlarged"), Key(world)];
    let [picture_width, picture_height] = experiment.size;
    if !experiment.worlds.iter().any(|known| known == world) {
        return Err(source.refusal(&at, format!("`{world}` is none of the experiment's worlds")));
    }
    let is_inside =
        |from: u32, size: u32, whole: u32| size > 0 && from.checked_add(size).is_some_and(|to| to <= whole);
    if !is_inside(left, width, picture_width) || !is_inside(top, height, picture_height) {
        let wanted = format!("wanted a part of a picture of {picture_width} x {picture_height} pixels");
        return Err(source.refusal(&at, wanted));
    }
    Ok(())
}

fn check_lists(source: &Source<'_>, experiment: &Experiment) -> Checked {
    let Experiment { worlds, cameras, variants, columns, .. } = experiment;
    let names: Vec<&str> = variants.iter().map(|variant| variant.name.as_str()).collect();
    for (key, count) in [
        ("worlds", worlds.len()),
        ("cameras", cameras.len()),
        ("variants", variants.len()),
        ("columns", columns.len()),
    ] {
        if count == 0 {
            return Err(source.refusal(&[Key(key)], "wanted at least one, got an empty list"));
        }
    }
    for (i, name) in names.iter().enumerate() {
        let at = [Key("variants"), Item(i), Key("name")];
        if name.trim().is_empty() {
            return Err(source.refusal(&at, "wanted a name, got an empty one"));
        }
        if names[..i].contains(name) {
            return Err(source.refusal(&at, format!("two variants are called `{name}`")));
        }
    }
    unique(source, &[Key("worlds")], worlds)?;
    unique(source, &[Key("cameras")], cameras)?;
    unique(source, &[Key("columns")], columns)
}

fn unique<T: PartialEq>(source: &Source<'_>, at: &[Step<'_>], items: &[T]) -> Checked {
    match (0..items.len()).find(|i| items[..*i].contains(&items[*i])) {
        Some(i) => Err(source.refusal(&[at, &[Item(i)]].concat(), "it is there twice")),
        None => Ok(()),
    }
}

fn check_worlds(source: &Source<'_>, worlds: &[String]) -> Checked {
    for (i, world) in worlds.iter().enumerate() {
        let is_built_in = umbrage_scene::worlds::ALL.iter().any(|known| known.name == *world);
        if !is_built_in && !Path::new(world).is_file() {
            let wrong = LabError::World { name: world.clone() };
            return Err(source.refusal(&[Key("worlds"), Item(i)], wrong));
        }
    }
    Ok(())
}

fn check_numbers(source: &Source<'_>, size: [u32; 2], repeats: u32, frames: u32) -> Checked {
    for (i, side) in size.into_iter().enumerate() {
        if !(1..=MAX_SIDE_PX).contains(&side) {
            let wrong = format!("wanted from 1 to {MAX_SIDE_PX} pixels each way, got {side}");
            return Err(source.refusal(&[Key("size"), Item(i)], wrong));
        }
    }
    if !(1..=MAX_REPEATS).contains(&repeats) {
        let wrong = format!("wanted from 1 to {MAX_REPEATS} repeats, got {repeats}");
        return Err(source.refusal(&[Key("repeats")], wrong));
    }
    if frames > MAX_FRAMES {
        let wrong = format!("wanted from 0 to {MAX_FRAMES} frames, got {frames}");
        return Err(source.refusal(&[Key("frames")], wrong));
    }
    Ok(())
}

/// Two changes make a tremble, so three frames.
fn check_watch(source: &Source<'_>, Watch { frames, points }: Watch) -> Checked {
    for (key, got, min, max) in
        [("frames", frames, 3, MAX_WATCHED.frames), ("points", points, 1, MAX_WATCHED.points)]
    {
        if !(min..=max).contains(&got) {
            let wrong = format!("wanted from {min} to {max} {key}, got {got}");
            return Err(source.refusal(&[Key("watch"), Key(key)], wrong));
        }
    }
    Ok(())
}

fn check_area(source: &Source<'_>, i: usize, area: Option<AreaLight>, motions: &[Motion]) -> Checked {
    let Some(area) = area else { return Ok(()) };
    let at = [Key("variants"), Item(i), Key("area")];
    if !motions.is_empty() {
        let wrong = "an area light is not watched along a path: leave out `area` or `motions`";
        return Err(source.refusal(&at, wrong));
    }
    area.area().map(|_| ()).map_err(|wrong| match wrong {
        RenderError::AreaSamples { .. } => source.refusal(&[&at[..], &[Key("samples")]].concat(), wrong),
        wrong => source.refusal(&[&at[..], &[Key("degrees")]].concat(), wrong),
    })
}

fn check_family(source: &Source<'_>, i: usize, variant: &Variant, motions: &[Motion]) -> Checked {
    let refusal = |other: &str| {
        let wrong = format!("another family of shadows has no {other}: leave out `family` or `{other}`");
        Err(source.refusal(&[Key("variants"), Item(i), Key("family")], wrong))
    };
    match variant.family {
        Some(_) if variant.area.is_some() => refusal("area"),
        Some(_) if !motions.is_empty() => refusal("motions"),
        Some(family) => family
            .validate()
            .map_err(|wrong| source.refusal(&[Key("variants"), Item(i), Key("family")], wrong)),
        None => Ok(()),
    }
}

fn check_variant(source: &Source<'_>, i: usize, variant: &Variant, worlds: &[String]) -> Checked {
    let Variant { name: _, preset: _, set: _, area: _, family: _, sweep, reported } = variant;
    for world in reported.keys() {
        known(source, &[Key("variants"), Item(i), Key("reported"), Key(world)], "world", world, worlds)?;
    }
    let Some(Sweep { key: _, values }) = sweep else {
        return variant
            .settings_at(None)
            .map(|_| ())
            .map_err(|wrong| refuse_settings(source, i, variant, None, &wrong));
    };
    let at = [Key("variants"), Item(i), Key("sweep"), Key("values")];
    if values.is_empty() {
        return Err(source.refusal(&at, "wanted at least one, got an empty list"));
    }
    for (j, value) in values.iter().enumerate() {
        variant
            .settings_at(Some(value))
            .map_err(|wrong| refuse_settings(source, i, variant, Some(j), &wrong))?;
        let falls =
            j > 0 && number(value).zip(number(&values[j - 1])).is_some_and(|(this, last)| this <= last);
        if falls || values[..j].contains(value) {
            let wrong =
                format!("wanted different values in rising order, got {value} after {}", values[j - 1]);
            return Err(source.refusal(&[&at[..], &[Item(j)]].concat(), wrong));
        }
    }
    Ok(())
}

fn number(value: &Value) -> Option<f64> {
    value.as_float().or_else(|| value.as_integer().map(|integer| integer as f64))
}

/// The variant's settings are wrong, or those with its `swept`-th value: finds who said so.
fn refuse_settings(
    source: &Source<'_>,
    i: usize,
    variant: &Variant,
    swept: Option<usize>,
    wrong: &WrongSettings,
) -> LabError {
    let variant_at = [Key("variants"), Item(i)];
    let names: Vec<Step<'_>> = wrong.key().split('.').map(Key).collect();
    let in_set = [&variant_at[..], &[Key("set")], &names].concat();
    let reason = match wrong {
        WrongSettings::Value { key: _, wrong } => wrong.clone(),
        WrongSettings::Preset(_)
        | WrongSettings::Words(_)
        | WrongSettings::Key(_)
        | WrongSettings::Renamed { .. }
        | WrongSettings::Range(_)
        | WrongSettings::File { .. } => wrong.to_string(),
    };
    let inside = |outer: &str, inner: &str| inner == outer || inner.starts_with(&format!("{outer}."));
    let sets = wrong.key().split('.').next().is_some_and(|first| variant.set.contains_key(first));
    match (wrong, &variant.sweep, swept) {
        (WrongSettings::Preset(_), ..) => {
            source.refusal(&[&variant_at[..], &[Key("preset")]].concat(), reason)
        }
        (_, Some(sweep), Some(j))
            if inside(&sweep.key, wrong.key()) || inside(wrong.key(), &sweep.key) || !sets =>
        {
            let at = [&variant_at[..], &[Key("sweep")]].concat();
            let no_such_key = matches!(wrong, WrongSettings::Key(_)) || reason.starts_with("unknown field");
            if no_such_key && wrong.key() == sweep.key {
                source.refusal(&[&at[..], &[Key("key")]].concat(), reason)
            } else {
                source.refusal(&[&at[..], &[Key("values"), Item(j)]].concat(), reason)
            }
        }
        _ => source.refusal(&in_set, reason),
    }
}

fn check_figure(source: &Source<'_>, at: &[Step<'_>], figure: &str) -> Checked {
    if Figure::named(figure).is_some() {
        return Ok(());
    }
    let keys: Vec<_> = figures::ALL.iter().map(|figure| figure.key).collect();
    Err(source.refusal(at, format!("no figure is called `{figure}`; there are {}", keys.join(", "))))
}

fn check_plot(source: &Source<'_>, i: usize, plot: &Plot, variants: &[Variant]) -> Checked {
    let Plot { x, y, log_x, pareto, by_world, variants: shown } = plot;
    let at = |key| [Key("plots"), Item(i), Key(key)];
    match x.as_str() {
        "sweep" if variants.iter().all(|variant| variant.sweep.is_none()) => {
            return Err(source.refusal(&at("x"), "wanted a variant that sweeps, but none does"));
        }
        "sweep" => {}
        "world" => {
            let asked = [("log_x", log_x), ("pareto", pareto), ("by_world", by_world)];
            if let Some((key, _)) = asked.into_iter().find(|(_, is_asked)| **is_asked) {
                let wrong =
                    format!("bars over worlds have no `{key}`: leave it out, or name a figure as `x`");
                return Err(source.refusal(&at(key), wrong));
            }
            let sweeps = variants.iter().find(|variant| variant.sweep.is_some() && plot.shows(variant));
            if let Some(Variant { name, .. }) = sweeps {
                let wrong =
                    format!("`{name}` sweeps, and a bar has one value: name other `variants` of the plot");
                return Err(source.refusal(&at("x"), wrong));
            }
        }
        _ => check_figure(source, &at("x"), x)?,
    }
    check_figure(source, &at("y"), y)?;
    let names: Vec<String> = variants.iter().map(|variant| variant.name.clone()).collect();
    for (j, name) in shown.iter().enumerate() {
        known(source, &[&at("variants")[..], &[Item(j)]].concat(), "variant", name, &names)?;
    }
    unique(source, &at("variants"), shown)
}

fn check_claim(source: &Source<'_>, i: usize, claim: &Claim, experiment: &Experiment) -> Checked {
    let Claim { says: _, figure, variant, than, times, worlds, cameras } = claim;
    let at = |key| [Key("claims"), Item(i), Key(key)];
    check_figure(source, &at("figure"), figure)?;
    let names: Vec<String> = experiment.variants.iter().map(|variant| variant.name.clone()).collect();
    known(source, &at("variant"), "variant", variant, &names)?;
    known(source, &at("than"), "variant", than, &names)?;
    if !(*times > 0.0 && times.is_finite()) {
        return Err(source.refusal(&at("times"), format!("wanted a positive number, got {times}")));
    }
    for (j, world) in worlds.iter().enumerate() {
        known(source, &[&at("worlds")[..], &[Item(j)]].concat(), "world", world, &experiment.worlds)?;
    }
    for (j, camera) in cameras.iter().enumerate() {
        known(source, &[&at("cameras")[..], &[Item(j)]].concat(), "camera", camera, &experiment.cameras)?;
    }
    Ok(())
}

/// Whether a name is one of those that the experiment has.
fn known(source: &Source<'_>, at: &[Step<'_>], what: &str, name: &str, names: &[String]) -> Checked {
    if names.iter().any(|known| known == name) {
        return Ok(());
    }
    let list = names.join(", ");
    Err(source.refusal(at, format!("no {what} of this experiment is called `{name}`; there are {list}")))
}

fn check_cameras(
    source: &Source<'_>,
    experiment: &Experiment,
    mut cameras: impl FnMut(&str, u64) -> Result<Vec<String>, LabError>,
) -> Checked {
    for (i, world) in experiment.worlds.iter().enumerate() {
        let names =
            cameras(world, experiment.seed).map_err(|why| source.refusal(&[Key("worlds"), Item(i)], why))?;
        for (j, camera) in experiment.cameras.iter().enumerate() {
            if !names.contains(camera) {
                let list = names.join(", ");
                let wrong = format!("the world `{world}` has no camera `{camera}`; it has {list}");
                return Err(source.refusal(&[Key("cameras"), Item(j)], wrong));
            }
        }
    }
    Ok(())
}
