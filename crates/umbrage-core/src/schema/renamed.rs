//! What is a setting called now that had another name?

/// Names that settings had before, and those that they have.
const RENAMED: &[(&str, &str)] = &[
    ("filter.bail", "filter.early_out"),
    ("filter.seed", "filter.noise"),
    ("filter.bleed", "filter.light_bleed_reduction"),
    ("filter.least_deviation", "filter.min_standard_deviation"),
    ("filter.most_texels", "filter.max_texels"),
    ("filter.prefilter.shrink", "filter.prefilter.downsample"),
    ("filter.prefilter.levels", "filter.prefilter.mip_levels"),
    ("filter.light.lamp_metres", "filter.light.punctual_metres"),
    ("bias.layer", "bias.depth_layer"),
    ("bias.layer_limit", "bias.depth_layer_limit"),
];

/// The name of the setting that was called `old` before; `None` where none was. Who refuses a settings file can say it.
pub fn renamed(old: &str) -> Option<&'static str> {
    RENAMED.iter().find(|(name, _)| *name == old).map(|(_, now)| *now)
}

#[cfg(test)]
mod tests {
    use super::RENAMED;
    use crate::schema::key;

    #[test]
    fn every_new_name_is_a_setting_and_no_old_one_is() {
        for (old, now) in RENAMED {
            assert!(key(now).is_some() && key(old).is_none(), "{old}, {now}");
        }
    }
}
