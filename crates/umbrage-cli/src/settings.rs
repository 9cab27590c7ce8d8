//! Settings from a preset, a TOML file over it, and single keys over that.

use anyhow::Context as _;
use umbrage::Settings;
use umbrage_lab::settings::Layers;

use crate::args::ShadowArgs;
use crate::failure::{Failure, Outcome};

/// Makes the settings that the command line asks for, checked. What is wrong in a file is refused with its line.
pub fn resolve(args: &ShadowArgs) -> Outcome<Settings> {
    let mut layers = Layers::preset(&args.preset).map_err(Failure::usage)?;
    if let Some(path) = &args.shadows {
        let name = path.display().to_string();
        let text = std::fs::read_to_string(path).with_context(|| format!("cannot read {name}"))?;
        layers = layers.file(&name, &text).map_err(Failure::usage)?;
    }
    for words in &args.set {
        layers = layers.words(words).map_err(|why| Failure::usage(format!("--set {why}")))?;
    }
    layers.settings().map_err(Failure::usage)
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    fn with(preset: &str, shadows: Option<&Path>, set: &[&str]) -> Outcome<Settings> {
        let set = set.iter().map(|s| (*s).to_owned()).collect();
        resolve(&ShadowArgs { preset: preset.to_owned(), shadows: shadows.map(Path::to_owned), set })
    }

    #[test]
    fn a_file_goes_over_the_preset_and_single_keys_over_both() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.toml");
        std::fs::write(&path, "[shadows]\nsplits = 2\nlambda = 0.25\n").unwrap();
        let settings = with("ferko-pssm-3x512", Some(&path), &["lambda=0.75"]).unwrap();
        assert_eq!((settings.splits, settings.lambda, settings.resolution), (2, 0.75, 512));
    }

    #[test]
    fn an_old_name_in_a_file_or_on_the_command_line_is_refused_with_the_new_one() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("old.toml");
        for (old, now, value) in [
            ("filter.bail", "filter.early_out", "true"),
            ("filter.seed", "filter.noise", "\"world\""),
            ("filter.bleed", "filter.light_bleed_reduction", "0.3"),
            ("filter.least_deviation", "filter.min_standard_deviation", "0.02"),
            ("filter.most_texels", "filter.max_texels", "16.0"),
            ("filter.prefilter.shrink", "filter.prefilter.downsample", "2"),
            ("filter.prefilter.levels", "filter.prefilter.mip_levels", "4"),
            ("filter.light.lamp_metres", "filter.light.punctual_metres", "0.2"),
            ("bias.layer", "bias.depth_layer", "\"dual\""),
            ("bias.layer_limit", "bias.depth_layer_limit", "0.1"),
        ] {
            std::fs::write(&path, format!("[shadows]\nsplits = 2\n{old} = {value}\n")).unwrap();
            let refused = |shadows, set: &[&str]| {
                let failure = with("default", shadows, set).expect_err(old);
                assert!(matches!(failure, Failure::Usage(_)), "{old}: {failure:?}");
                failure.to_string()
            };
            let file = path.display();
            assert_eq!(refused(Some(&path), &[]), format!("line 3, `{old}` is now `{now}`, in {file}"));
            assert_eq!(refused(None, &[&format!("{old}={value}")]), format!("`{old}` is now `{now}`"));
        }
    }

    #[test]
    fn wrong_words_are_named_on_one_line() {
        for (set, wanted) in [
            ("splitz=3", "splitz"),
            ("splits=0", "`splits` must be from 1 to 9, got 0"),
            ("splits=three", "splits"),
            ("filter.kind=blur", "blur"),
            ("splits", "--set `splits` should be key=value"),
            (".=3", "empty key"),
        ] {
            let failure = with("default", None, &[set]).expect_err(set);
            let text = failure.to_string();
            assert!(text.contains(wanted) && !text.contains('\n'), "{set}: {text}");
            assert!(matches!(failure, Failure::Usage(_)), "{set}: {failure:?}");
        }
        let failure = with("bevie", None, &[]).expect_err("no such preset");
        assert!(
            matches!(failure, Failure::Usage(_)) && failure.to_string().contains("ferko-sm-1024"),
            "{failure}"
        );
    }
}
