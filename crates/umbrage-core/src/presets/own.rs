//! This project's own: nine ways to have shadows, each in three sizes of memory.

use super::preset::Preset;
use crate::filter::{Filter, Footprint, Pcss};
use crate::fit::Fit;
use crate::settings::{DepthFormat, Exact, Settings};

/// A way in maps of 16, 4 and 64 MiB. Where `how` is `within`, there are three maps, which fill no more than three quarters of
/// that.
macro_rules! in_three_sizes {
    ($name:literal, $how:literal, $says:literal, $settings:expr) => {
        [
            Preset {
                name: $name,
                source: concat!("this project: ", $says),
                settings: || sized(16, $settings),
            },
            Preset {
                name: concat!($name, "-4mib"),
                source: concat!("this project: the same ", $how, " 4 MiB"),
                settings: || sized(4, $settings),
            },
            Preset {
                name: concat!($name, "-64mib"),
                source: concat!("this project: the same ", $how, " 64 MiB"),
                settings: || sized(64, $settings),
            },
        ]
    };
}

/// The presets of this project, the default first.
pub(super) const OWN: [[Preset; 3]; 9] = [
    in_three_sizes!("default", "in", "four maps in 16 MiB, a bell of 3 × 3 lookups", Settings::default()),
    in_three_sizes!("fast", "within", "three maps within 16 MiB, one lookup of the sampler's size", fast()),
    in_three_sizes!(
        "best",
        "in",
        "four maps in 16 MiB, all that the pixel covers, the least error against its area",
        best()
    ),
    in_three_sizes!(
        "soft",
        "in",
        "penumbrae of a sun of 0.53°, four maps in 16 MiB, 16 points",
        soft(16, 16)
    ),
    in_three_sizes!(
        "soft-fast",
        "within",
        "penumbrae of a sun of 0.53°, three maps within 16 MiB, 8 points",
        Settings { splits: 3, ..soft(8, 8) }
    ),
    in_three_sizes!(
        "soft-best",
        "in",
        "penumbrae of a sun of 0.53°, four maps in 16 MiB, 64 points",
        soft(32, 64)
    ),
    in_three_sizes!(
        "sdsm",
        "in",
        "four maps in 16 MiB, fitted to what is seen, with logarithmic splits (Lauritzen et al. 2011)",
        sampled()
    ),
    in_three_sizes!(
        "exact",
        "in",
        "four maps in 16 MiB, and rays where they are not sure (Hertel et al. 2009)",
        Settings { exact: Exact::Undecided, ..Settings::default() }
    ),
    in_three_sizes!(
        "soft-exact",
        "in",
        "penumbrae of a sun of 0.53°, four maps in 16 MiB, and 16 rays where they are not sure",
        Settings { exact: Exact::Undecided, ..soft(32, 16) }
    ),
];

/// Maps four of which fill so many MiB: 1448² of 16 bits, or 1024² of 32. A soft filter reaches over a 32nd of them.
fn sized(mib: u64, settings: Settings) -> Settings {
    let resolution = ((mib << 20) / (4 * settings.depth.bytes())).isqrt() as u32;
    let filter = match settings.filter {
        Filter::Pcss(pcss) => Filter::Pcss(Pcss { max_texels: resolution as f32 / 32.0, ..pcss }),
        other => other,
    };
    Settings { resolution, filter, ..settings }
}

fn fast() -> Settings {
    Settings { splits: 3, filter: Filter::Bilinear {}, ..Settings::default() }
}

fn best() -> Settings {
    Settings { filter: Filter::Footprint(Footprint::default()), ..Settings::default() }
}

/// Where splits begin and end with what is seen, logarithmic ones leave the least error.
fn sampled() -> Settings {
    Settings { fit: Fit::Sample, lambda: 1.0, ..Settings::default() }
}

/// The sun's own size, and so many points to search and to compare. How far a blocker is must not be flattened, so that maps
/// hold all of the world's depth: 16 bits would be too few.
fn soft(blockers: u32, taps: u32) -> Settings {
    let filter = Filter::Pcss(Pcss { blockers, taps, ..Pcss::default() });
    Settings { depth: DepthFormat::F32, filter, ..Settings::default() }
}
