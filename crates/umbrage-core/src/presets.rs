//! Named settings: what the sources measured, as data.
//!
//! The sources' polygon offsets and biases were tuned to their machines' depth formats, so all their presets have the same
//! bias, the one that is exact for a flat receiver: what differs between two presets is what their source compared.

use crate::settings::{Bias, Filter, Fit, Select, Settings, Warp};

/// Settings with a name and a source.
#[derive(Clone, Copy, Debug)]
pub struct Preset {
    /// What the command line calls it.
    pub name: &'static str,
    /// Where it comes from.
    pub source: &'static str,
    /// Makes the settings.
    pub settings: fn() -> Settings,
}

impl Preset {
    /// The preset called `name`.
    pub fn named(name: &str) -> Option<&'static Self> {
        PRESETS.iter().find(|preset| preset.name == name)
    }
}

/// Every preset, the default first.
pub const PRESETS: &[Preset] = &[
    Preset {
        name: "default",
        source: "this project: four splits of 1024², the least error over its worlds",
        settings: Settings::default,
    },
    Preset {
        name: "ferko-sm-1024",
        source: "Ferko 2010, table 5.1: one map of 1024²",
        settings: || ferko(1, 1024),
    },
    Preset {
        name: "ferko-sm-2048",
        source: "Ferko 2010, table 5.1: one map of 2048²",
        settings: || ferko(1, 2048),
    },
    Preset {
        name: "ferko-pssm-3x512",
        source: "Ferko 2010, table 5.2: three maps of 512², λ = 0.5",
        settings: || ferko(3, 512),
    },
    Preset {
        name: "ferko-pssm-3x1024",
        source: "Ferko 2010, table 5.2: three maps of 1024², λ = 0.5",
        settings: || ferko(3, 1024),
    },
    Preset {
        name: "zhang-ssm-1024",
        source: "Zhang et al. 2006, §4: one map of 1024²",
        settings: || zhang(1, 1024),
    },
    Preset {
        name: "zhang-psm-1024",
        source: "Zhang et al. 2006, §4: one map of 1024², PSM",
        settings: || Settings { warp: Warp::Psm, ..zhang(1, 1024) },
    },
    Preset {
        name: "zhang-lispsm-1024",
        source: "Zhang et al. 2006, §4: one map of 1024², LiSPSM",
        settings: || Settings { warp: Warp::Lispsm, ..zhang(1, 1024) },
    },
    Preset {
        name: "zhang-tsm-1024",
        source: "Zhang et al. 2006, §4: one map of 1024², TSM",
        settings: || Settings { warp: Warp::Tsm, ..zhang(1, 1024) },
    },
    Preset {
        name: "zhang-pssm2-512",
        source: "Zhang et al. 2006, table 1: PSSM(2; 512²)",
        settings: || zhang(2, 512),
    },
    Preset {
        name: "zhang-pssm3-512",
        source: "Zhang et al. 2006, table 1: PSSM(3; 512²)",
        settings: || zhang(3, 512),
    },
    Preset {
        name: "zhang-pssm4-512",
        source: "Zhang et al. 2006, table 1: PSSM(4; 512²)",
        settings: || zhang(4, 512),
    },
];

/// The thesis: practical splits with λ = 0.5, boxes around the slices' objects, one comparison a pixel.
fn ferko(splits: u32, resolution: u32) -> Settings {
    Settings { splits, resolution, lambda: 0.5, fit: Fit::Scene, ..source() }
}

/// The paper: practical splits (eq. 6), boxes around the slices, one comparison a pixel.
fn zhang(splits: u32, resolution: u32) -> Settings {
    Settings { splits, resolution, lambda: 0.5, fit: Fit::View, ..source() }
}

/// What every source has: a view by depth, one comparison a pixel, and an offset along the normal.
fn source() -> Settings {
    Settings {
        select: Select::Depth,
        filter: Filter::Hard {},
        bias: Bias { normal: 1.0, receiver_plane: false, ..Bias::default() },
        ..Settings::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_preset_is_valid_and_its_name_says_its_maps() {
        for preset in PRESETS {
            let settings = (preset.settings)();
            assert_eq!(settings.validate(), Ok(()), "{}", preset.name);
            let texels: Vec<u32> =
                preset.name.split(|c: char| !c.is_ascii_digit()).filter_map(|n| n.parse().ok()).collect();
            match texels[..] {
                [] => assert_eq!(preset.name, "default"),
                [resolution] => {
                    assert_eq!((settings.splits, settings.resolution), (1, resolution), "{}", preset.name);
                }
                [splits, resolution] => {
                    assert_eq!(
                        (settings.splits, settings.resolution),
                        (splits, resolution),
                        "{}",
                        preset.name
                    );
                }
                _ => panic!("{} has too many numbers", preset.name),
            }
        }
    }

    #[test]
    fn preset_names_are_unique() {
        for (i, preset) in PRESETS.iter().enumerate() {
            assert!(PRESETS[..i].iter().all(|other| other.name != preset.name), "{}", preset.name);
            assert_eq!(Preset::named(preset.name).map(|p| p.name), Some(preset.name));
        }
    }
}
