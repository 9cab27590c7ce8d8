//! `umbrage wgsl`: a shader's text, for any WGSL compiler.

use clap::ValueEnum as _;
use umbrage_interchange::{Stage, Stages};

use crate::args::WgslArgs;
use crate::failure::{Failure, Outcome};
use crate::output::print;
use crate::settings;

pub fn run(args: &WgslArgs) -> Outcome {
    Ok(print(&text(args)?)?)
}

/// The text that is asked for.
pub fn text(args: &WgslArgs) -> Outcome<String> {
    let settings = settings::resolve(&args.shadows)?;
    let stages = Stages::new(&settings, args.textures);
    stages.text(args.stage, args.group).ok_or_else(|| {
        let has = |stage: &&Stage| stages.text(**stage, 0).is_some();
        let names: Vec<String> = Stage::ALL.iter().filter(has).map(name).collect();
        Failure::usage(format!(
            "these settings have no stage `{}`; they have {}",
            name(&args.stage),
            names.join(", ")
        ))
    })
}

fn name(stage: &Stage) -> String {
    stage.to_possible_value().map_or_else(String::new, |value| value.get_name().to_owned())
}
