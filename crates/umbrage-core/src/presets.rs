//! Named settings: this project's own, and what the sources measured, as data.

mod own;
mod preset;
mod published;

use self::own::OWN;
use self::published::PUBLISHED;

pub use preset::Preset;

/// Every preset, the default first.
pub const PRESETS: &[Preset] = &all();

const fn all() -> [Preset; OWN.as_flattened().len() + PUBLISHED.len()] {
    let own = OWN.as_flattened();
    let mut all = [own[0]; OWN.as_flattened().len() + PUBLISHED.len()];
    let mut i = 0;
    while i < all.len() {
        all[i] = if i < own.len() { own[i] } else { PUBLISHED[i - own.len()] };
        i += 1;
    }
    all
}

impl Preset {
    /// The preset called `name`; `None` where none is.
    pub fn named(name: &str) -> Option<&'static Self> {
        PRESETS.iter().find(|preset| preset.name == name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Allocation, DepthFormat, Exact, Filter, Footprint, Pcss, Settings};

    #[test]
    fn every_preset_is_valid_and_its_name_says_its_maps() {
        for preset in PRESETS {
            let settings = (preset.settings)();
            assert_eq!(settings.validate(), Ok(()), "{}", preset.name);
            let numbers = preset.name.strip_prefix("ferko").or(preset.name.strip_prefix("zhang"));
            let Some(numbers) = numbers else { continue };
            let texels: Vec<u32> =
                numbers.split(|c: char| !c.is_ascii_digit()).filter_map(|n| n.parse().ok()).collect();
            let maps = (settings.splits, settings.resolution);
            match texels[..] {
                [resolution] => assert_eq!(maps, (1, resolution), "{}", preset.name),
                [splits, resolution] => assert_eq!(maps, (splits, resolution), "{}", preset.name),
                _ => panic!("{} should name its maps", preset.name),
            }
        }
    }

    #[test]
    fn our_own_are_nine_ways_in_three_sizes() {
        let pcss = |resolution: u32, blockers, taps| {
            Filter::Pcss(Pcss { blockers, taps, max_texels: resolution as f32 / 32.0, ..Pcss::default() })
        };
        let default = Settings::default();
        for (suffix, resolution, of_floats) in [("", 1448, 1024), ("-4mib", 724, 512), ("-64mib", 2896, 2048)]
        {
            for (name, splits, filter) in [
                ("default", 4, Filter::Optimised { size: 3 }),
                ("fast", 3, Filter::Bilinear {}),
                ("best", 4, Filter::Footprint(Footprint { taps: 32, max_texels: 8.0 })),
                ("soft", 4, pcss(of_floats, 16, 16)),
                ("soft-fast", 3, pcss(of_floats, 8, 8)),
                ("soft-best", 4, pcss(of_floats, 32, 64)),
            ] {
                let got = Preset::named(&format!("{name}{suffix}")).map(|preset| (preset.settings)());
                let (depth, resolution) = match filter {
                    Filter::Pcss(_) => (DepthFormat::F32, of_floats),
                    _ => (DepthFormat::U16, resolution),
                };
                let wanted = Settings { splits, resolution, depth, filter, ..default.clone() };
                assert_eq!(got, Some(wanted), "{name}{suffix}");
            }
            let sampled = Preset::named(&format!("sdsm{suffix}")).map(|preset| (preset.settings)());
            let wanted = Settings { resolution, fit: crate::Fit::Sample, lambda: 1.0, ..default.clone() };
            assert_eq!(sampled, Some(wanted), "{suffix}");
            for (name, maps) in [("exact", "default"), ("soft-exact", "soft")] {
                let of = |name| Preset::named(&format!("{name}{suffix}")).map(|preset| (preset.settings)());
                let (got, maps) = (of(name).unwrap_or_default(), of(maps).unwrap_or_default());
                assert_eq!(
                    (got.exact, got.resolution),
                    (Exact::Undecided, maps.resolution),
                    "{name}{suffix}"
                );
            }
        }
    }

    #[test]
    fn our_own_stay_within_the_memory_that_their_names_say() {
        let ours = PRESETS.iter().filter(|preset| preset.source.starts_with("this project"));
        assert_eq!(ours.clone().count(), 27, "five for hard light and four for soft, in three sizes");
        for preset in ours {
            let mib = match preset.name.rsplit_once('-') {
                Some((_, "4mib")) => 4,
                Some((_, "64mib")) => 64,
                _ => 16,
            };
            let bytes = Allocation::of_sun(&(preset.settings)()).layout().bytes();
            assert!(bytes <= mib << 20 && bytes > mib << 19, "{}: {bytes} bytes", preset.name);
        }
    }

    #[test]
    fn the_engines_maps_are_as_large_as_they_say() {
        // MiB of one sun's maps, and how far its shadows reach, metres.
        for (name, mib, reach) in [
            ("bevy", 64, 150.0),
            ("godot", 32, 100.0),
            ("filament", 4, 100.0),
            ("three", 48, f32::INFINITY),
            ("mjp", 64, 250.0),
        ] {
            let settings = Preset::named(name).map(|preset| (preset.settings)()).expect("a preset");
            assert_eq!(Allocation::of_sun(&settings).layout().bytes(), mib << 20, "{name}");
            assert_eq!(settings.distance.unwrap_or(f32::INFINITY), reach, "{name}");
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
