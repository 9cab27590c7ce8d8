//! Commands for other programs: the words of a command line in, what the command prints out.
//!
//! A host that speaks another language has the command's options, checks and JSON, and none of its own to keep in step
//! (`docs/decisions/0050-python-speaks-the-commands-words.md`). Warnings and bars go to stderr, as those of the command do.

use std::sync::Arc;

use clap::{Args, Command};
use umbrage_lab::{Judged, Program};
use umbrage_scene::Scene;

use crate::args::{MeasureArgs, PlanArgs, ReportArgs, WgslArgs};
use crate::commands::{measure, plan, report, wgsl, worlds};
use crate::failure::{Failure, Outcome};
use crate::pages;

/// Returns what `umbrage plan WORDS --json -` prints. The world is `scene` where that is given; the words still name a world, and what is
/// printed calls it by the scene's own name. A `--json FILE` among the words writes nothing.
///
/// # Errors
/// Where the command fails, as it fails.
pub fn plan(words: &[String], scene: Option<Arc<Scene>>) -> Outcome<String> {
    let mut args: PlanArgs = parsed(words)?;
    args.world.scene = scene;
    plan::json(&args)
}

/// Returns what `umbrage measure WORDS --json -` prints. The world is `scene` where that is given, as in [`plan`]. Options that name a file
/// to write JSON into write nothing.
///
/// # Errors
/// Where the command fails, as it fails.
pub fn measure(words: &[String], scene: Option<Arc<Scene>>) -> Outcome<String> {
    let mut args: MeasureArgs = parsed(words)?;
    args.world.scene = scene;
    Ok(measure::measure(&args)?.of_some_pixels()?.json()?)
}

/// The visibility of a picture as it was drawn and as it should be, by light, row and column.
#[derive(Clone, Debug, PartialEq)]
pub struct Shadows {
    /// The number of lights.
    pub lights: usize,
    /// The height of the picture, in pixels.
    pub height: usize,
    /// The width of the picture, in pixels.
    pub width: usize,
    /// What was drawn, from 0 (shadowed) to 1 (lit).
    pub visibility: Vec<f32>,
    /// What is true; NaN where a pixel is not judged.
    pub truth: Vec<f32>,
}

/// Returns the visibility that `umbrage measure WORDS` judges, and what it is judged by. The world is `scene` where that is given.
///
/// # Errors
/// Where the command fails, as it fails; but a picture may have no pixel to judge.
pub fn pictures(words: &[String], scene: Option<Arc<Scene>>) -> Outcome<Shadows> {
    let mut args: MeasureArgs = parsed(words)?;
    args.world.scene = scene;
    args.frames = 0;
    let Judged { measurement, visibility, truth, .. } = measure::measure(&args)?.judged;
    let (width, height) = (measurement.width as usize, measurement.height as usize);
    let lights = visibility.len();
    Ok(Shadows { lights, height, width, visibility: visibility.concat(), truth: truth.concat() })
}

/// Does what `umbrage report WORDS` does, and returns its rows as CSV. `program` is the code that measures; before each run
/// `go_on` says whether to.
///
/// # Errors
/// Where the command fails, as it fails, and where `go_on` says no.
pub fn report(words: &[String], program: &Program, go_on: &dyn Fn() -> bool) -> Outcome<String> {
    let args: ReportArgs = parsed(words)?;
    report::make(&args, program, go_on)
}

/// Returns what `umbrage wgsl WORDS` prints.
///
/// # Errors
/// Where the command fails, as it fails.
pub fn wgsl(words: &[String]) -> Outcome<String> {
    let args: WgslArgs = parsed(words)?;
    wgsl::text(&args)
}

/// Returns what `umbrage worlds --json -` prints.
///
/// # Errors
/// Where the command fails, as it fails.
pub fn worlds() -> Outcome<String> {
    Ok(worlds::json()?)
}

/// Returns what `umbrage settings --json -` prints.
///
/// # Errors
/// Where the command fails, as it fails.
pub fn settings() -> Outcome<String> {
    Ok(pages::settings::json()?)
}

/// The arguments of a command. What is wrong with them is said in one line.
fn parsed<A: Args>(words: &[String]) -> Outcome<A> {
    let command = A::augment_args(Command::new("umbrage").no_binary_name(true).disable_help_flag(true));
    let arguments = command.try_get_matches_from(words).and_then(|matches| A::from_arg_matches(&matches));
    arguments.map_err(|why| {
        let text = why.to_string();
        let first = text.split("\n\n").next().unwrap_or_default();
        Failure::usage(first.trim_start_matches("error: ").split_whitespace().collect::<Vec<_>>().join(" "))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(text: &str) -> Vec<String> {
        text.split(' ').map(str::to_owned).collect()
    }

    #[test]
    fn a_scene_in_hand_is_planned_as_the_world_of_that_name_is() {
        let scene = umbrage_scene::worlds::build("primitives", 0).map(Arc::new);
        let named = plan(&words("--set=splits=2 primitives"), None).expect("a plan");
        assert_eq!(plan(&words("--set=splits=2 whatever"), scene).expect("a plan"), named);
    }

    #[test]
    fn wrong_words_are_one_line() {
        for (wrong, says) in [
            (
                "primitives --size=0x5",
                "--size <WxH>': a picture needs at least one pixel each way, got 0 x 5",
            ),
            ("primitives --siz=5x5", "unexpected argument '--siz' found"),
            ("--size=5x5", "required arguments were not provided: <WORLD>"),
            ("--help", "unexpected argument '--help' found"),
        ] {
            let failure = plan(&words(wrong), None).expect_err(wrong);
            assert!(matches!(failure, Failure::Usage(_)) && failure.to_string().contains(says), "{failure}");
        }
    }

    #[test]
    fn settings_and_worlds_are_json() {
        let read = |text: Outcome<String>| serde_json::from_str::<serde_json::Value>(&text.expect("JSON"));
        let (settings, worlds) = (read(settings()).expect("JSON"), read(worlds()).expect("JSON"));
        let of = |name: &str| settings.as_array().expect("a list").iter().find(|it| it["name"] == name);
        let (lambda, distance) = (of("lambda").expect("there"), of("distance").expect("there"));
        assert_eq!(lambda["default"].to_string(), "0.8", "as it is written, and not as the next f64");
        assert!(distance["default"].is_null() && distance["absent"].is_string(), "{distance}");
        assert!(of("filter.kind").expect("there")["choices"].as_array().is_some_and(|of| of.len() > 10));
        assert_eq!(worlds.as_array().map(Vec::len), Some(umbrage_scene::worlds::ALL.len()));
    }
}
