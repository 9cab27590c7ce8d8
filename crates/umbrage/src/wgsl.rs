//! Assembles the shader text that goes in front of yours: plain files, one after another, no preprocessor.

use std::fmt::Write as _;

use glam::Vec4;
use umbrage_core::{
    CompareDepth, Disc, Filter, NoiseSource, RASTER_STEP_TEXELS, Select, Settings, Shade, ShaderNumber,
    ShaderValue, Stored,
};

use crate::capabilities::Capabilities;
use crate::moments::moments_files;
use crate::prefilter::MomentFormat;

pub(crate) const FRAME: &str = include_str!("../shaders/frame.wgsl");
pub(crate) const DEPTH: &str = include_str!("../shaders/linear_depth.wgsl");
const CASTER: &str = include_str!("../shaders/caster.wgsl");
const FOOTING: &str = include_str!("../shaders/texel_basis.wgsl");
const RECEIVER: &str = include_str!("../shaders/receiver.wgsl");
const FADE: &str = include_str!("../shaders/blend/fade.wgsl");
const PENUMBRA: &str = include_str!("../shaders/penumbra.wgsl");
const FOOTPRINT: &str = include_str!("../shaders/footprint.wgsl");
const PCG: &str = include_str!("../shaders/noise/pcg.wgsl");
const BOX: &str = include_str!("../shaders/sample/box.wgsl");

/// WGSL for a caster's vertex shader: `umbrage_caster_position(world_position) -> vec4f`. Its bindings are group 0 of
/// the pipeline; yours start at 1.
pub fn caster_wgsl() -> String {
    [FRAME, CASTER].join("\n")
}

/// WGSL for a shader of your own that looks into the maps: the views and the lights, in `umbrage_frame` (binding 0 of
/// group 0), and `umbrage_linear_depth(view_index, texel, stored) -> f32`, what a stored depth is worth.
pub fn map_wgsl() -> String {
    [FRAME, DEPTH].join("\n")
}

/// WGSL for a receiver's fragment shader: `umbrage_visibility(world_position, world_normal, pixel) -> f32`,
/// `umbrage_light_visibility(light, …)`, `umbrage_shade(ambient, lit, visibility) -> vec3f`. Its bindings are group
/// `group` of the pipeline. The text depends on `select`, `blend`, `filter`, `warp`, `bias.receiver_plane`
/// and `shade` of the settings, and on what the device can do.
pub fn receiver_wgsl(settings: &Settings, capabilities: Capabilities, group: u32) -> String {
    let select = match settings.select {
        Select::Depth => include_str!("../shaders/select/depth.wgsl"),
        Select::ClipDepth => include_str!("../shaders/select/clip_depth.wgsl"),
        Select::Map => include_str!("../shaders/select/map.wgsl"),
    };
    let blend = match settings.select {
        _ if settings.blend == 0.0 => [include_str!("../shaders/blend/none.wgsl"), ""],
        Select::Depth | Select::ClipDepth => [include_str!("../shaders/blend/depth.wgsl"), FADE],
        Select::Map => [include_str!("../shaders/blend/map.wgsl"), FADE],
    };
    let reference = match settings.compare_depth() {
        CompareDepth::Plane => include_str!("../shaders/compare_depth/plane.wgsl"),
        CompareDepth::Facing => include_str!("../shaders/compare_depth/facing.wgsl"),
        CompareDepth::Own => include_str!("../shaders/compare_depth/own.wgsl"),
    };
    let shade = match settings.shade {
        Shade::Absence { .. } => include_str!("../shaders/shade/absence.wgsl"),
        Shade::Colour { .. } => include_str!("../shaders/shade/colour.wgsl"),
    };
    let mut text = vec![FRAME.to_owned(), constants(settings)];
    text.extend(
        [FOOTING, RECEIVER, FOOTPRINT, select, reference, blend[0], blend[1], shade].map(str::to_owned),
    );
    text.extend(filter(settings, capabilities));
    text.join("\n").replace("@group(0)", &format!("@group({group})"))
}

/// The numbers that a pipeline fixes.
fn constants(settings: &Settings) -> String {
    let mut text = declared(&settings.filter.numbers());
    // Writing to a string cannot fail.
    let _ = writeln!(text, "const UMBRAGE_RASTER_STEP: f32 = {RASTER_STEP_TEXELS:?};");
    if settings.blend > 0.0 {
        let _ = writeln!(text, "const UMBRAGE_BLEND: f32 = {:?};", settings.blend);
    }
    text
}

/// A line for each number.
pub(crate) fn declared(numbers: &[ShaderNumber]) -> String {
    let line = |ShaderNumber { name, value }: &ShaderNumber| match value {
        ShaderValue::Bool(value) => format!("const {name}: bool = {value};\n"),
        ShaderValue::I32(value) => format!("const {name}: i32 = {value};\n"),
        ShaderValue::U32(value) => format!("const {name}: u32 = {value}u;\n"),
        ShaderValue::F32(value) => format!("const {name}: f32 = {value:?};\n"),
        ShaderValue::F32s(list) => array(name, "f32", list, |value| format!("{value:?}")),
        ShaderValue::Vec2s(list) => array(name, "vec2f", list, |p| format!("vec2f({:?}, {:?})", p.x, p.y)),
        ShaderValue::Vec4s(list) => array(name, "vec4f", list, |point| vector(*point)),
    };
    numbers.iter().map(line).collect()
}

fn array<T>(name: &str, kind: &str, list: &[T], text: impl Fn(&T) -> String) -> String {
    let values: Vec<String> = list.iter().map(text).collect();
    format!("const {name} = array<{kind}, {}>({});\n", list.len(), values.join(", "))
}

fn vector(point: Vec4) -> String {
    format!("vec4f({:?}, {:?}, {:?}, {:?})", point.x, point.y, point.z, point.w)
}

/// The files that define `umbrage_filter` and `umbrage_offset_reach`.
fn filter(settings: &Settings, capabilities: Capabilities) -> Vec<String> {
    let is_each = matches!(settings.compare_depth(), CompareDepth::Plane | CompareDepth::Facing);
    let tap = if is_each {
        include_str!("../shaders/tap/one.wgsl")
    } else {
        include_str!("../shaders/tap/four.wgsl")
    };
    let fixed = include_str!("../shaders/reach/fixed.wgsl");
    let files: Vec<&str> = match &settings.filter {
        Filter::Hard {} => vec![fixed, include_str!("../shaders/filter/hard.wgsl")],
        Filter::Bilinear {} => {
            kernel(is_each, tap, include_str!("../shaders/filter/bilinear.wgsl"), BOX_KERNEL)
        }
        Filter::Pcf { .. } => kernel(is_each, tap, include_str!("../shaders/filter/pcf.wgsl"), BOX_KERNEL),
        Filter::Optimised { .. } => {
            kernel(is_each, tap, include_str!("../shaders/filter/optimised.wgsl"), BELL_KERNEL)
        }
        Filter::Poisson(of) => disc(of, include_str!("../shaders/points/fixed.wgsl"), tap),
        Filter::Stratified(of) => disc(of, include_str!("../shaders/points/stratified.wgsl"), tap),
        Filter::Rotated(of) | Filter::Vogel(of) => {
            disc(of, include_str!("../shaders/points/rotated.wgsl"), tap)
        }
        Filter::Footprint(_) => vec![fixed, tap, include_str!("../shaders/filter/footprint.wgsl")],
        Filter::Pcss(of) => vec![
            fixed,
            PCG,
            noise(of.noise),
            include_str!("../shaders/points/rotated.wgsl"),
            tap,
            DEPTH,
            PENUMBRA,
            include_str!("../shaders/filter/pcss.wgsl"),
        ],
        Filter::Vsm(_) | Filter::Esm(_) | Filter::Evsm2(_) | Filter::Evsm4(_) | Filter::Msm(_) => {
            let sample = match MomentFormat::of(&settings.filter, capabilities) {
                Some(format) if !format.is_filterable => include_str!("../shaders/sample/loaded.wgsl"),
                Some(format) if format.levels == 1 => include_str!("../shaders/sample/level.wgsl"),
                _ => include_str!("../shaders/sample/footprint.wgsl"),
            };
            let inside = include_str!("../shaders/sample/inside.wgsl");
            vec![fixed, DEPTH, inside, sample, include_str!("../shaders/filter/moments.wgsl")]
        }
        Filter::Savsm(of) => {
            vec![fixed, radius(of.radius), DEPTH, BOX, include_str!("../shaders/filter/summed.wgsl")]
        }
        Filter::Mssm(_) => vec![
            fixed,
            include_str!("../shaders/moments/msm_blocker.wgsl"),
            DEPTH,
            PENUMBRA,
            BOX,
            include_str!("../shaders/filter/summed_soft.wgsl"),
        ],
    };
    let moments = match settings.filter.stores() {
        Stored::Depths => None,
        Stored::Prefiltered { texel, .. } | Stored::Summed { texel, .. } => {
            Some(moments_files(texel.moments))
        }
    };
    files.into_iter().map(str::to_owned).chain(moments).collect()
}

const BOX_KERNEL: &str = include_str!("../shaders/kernel/box.wgsl");
const BELL_KERNEL: &str = include_str!("../shaders/kernel/bell.wgsl");

/// A grid of lookups: `with_sampler` where one depth serves four texels.
fn kernel<'a>(is_each: bool, tap: &'a str, with_sampler: &'a str, weights: &'a str) -> Vec<&'a str> {
    let files =
        if is_each { [weights, include_str!("../shaders/filter/each.wgsl")] } else { [tap, with_sampler] };
    [include_str!("../shaders/reach/fixed.wgsl")].into_iter().chain(files).collect()
}

/// Points on a disc.
fn disc<'a>(disc: &Disc, place: &'a str, tap: &'a str) -> Vec<&'a str> {
    vec![
        radius(disc.radius),
        include_str!("../shaders/reach/disc.wgsl"),
        PCG,
        noise(disc.noise),
        place,
        tap,
        include_str!("../shaders/filter/disc.wgsl"),
    ]
}

fn noise(noise: NoiseSource) -> &'static str {
    match noise {
        NoiseSource::Screen => include_str!("../shaders/noise/screen.wgsl"),
        NoiseSource::World => include_str!("../shaders/noise/world.wgsl"),
        NoiseSource::None => include_str!("../shaders/noise/none.wgsl"),
    }
}

fn radius(metres: Option<f32>) -> &'static str {
    if metres.is_some() {
        include_str!("../shaders/radius/metres.wgsl")
    } else {
        include_str!("../shaders/radius/texels.wgsl")
    }
}

#[cfg(test)]
mod tests {
    use umbrage_core::{
        Bias, Exponential, ExponentialVariance, Footprint, FourMoments, Pcss, Prefilter, SoftMoments,
        SummedVariance, Variance, Warp,
    };

    use super::*;

    fn validate(what: &str, text: &str) {
        let module = naga::front::wgsl::parse_str(text)
            .unwrap_or_else(|e| panic!("{what}: {}", e.emit_to_string(text)));
        let capabilities = naga::valid::Capabilities::empty();
        let mut validator = naga::valid::Validator::new(naga::valid::ValidationFlags::all(), capabilities);
        validator.validate(&module).unwrap_or_else(|e| panic!("{what}: {}", e.emit_to_string(text)));
    }

    /// Every kind of filter, with every file that one can ask for.
    fn filters() -> Vec<Filter> {
        let sizes = [1, 3, 5, 7, 9].map(|size| Filter::Pcf { size });
        let bells = [3, 5, 7].map(|size| Filter::Optimised { size });
        let disc = Disc::default();
        let discs = [
            disc,
            Disc { radius: Some(0.1), noise: NoiseSource::World, early_out: true, ..disc },
            Disc { noise: NoiseSource::None, ..disc },
        ];
        let discs = discs.into_iter().flat_map(|disc| {
            [Filter::Poisson(disc), Filter::Stratified(disc), Filter::Rotated(disc), Filter::Vogel(disc)]
        });
        let prefilters =
            [Prefilter::default(), Prefilter { mip_levels: 4, anisotropy: 8, ..Prefilter::default() }];
        let moments = prefilters.into_iter().flat_map(|prefilter| {
            let evsm = ExponentialVariance { prefilter, ..ExponentialVariance::default() };
            [
                Filter::Vsm(Variance { prefilter, ..Variance::default() }),
                Filter::Esm(Exponential { prefilter, ..Exponential::default() }),
                Filter::Evsm2(evsm),
                Filter::Evsm4(evsm),
                Filter::Msm(FourMoments { prefilter, ..FourMoments::default() }),
            ]
        });
        let savsm = SummedVariance::default();
        let others = [
            Filter::Hard {},
            Filter::Bilinear {},
            Filter::Footprint(Footprint::default()),
            Filter::Pcss(Pcss::default()),
            Filter::Savsm(savsm),
            Filter::Savsm(SummedVariance { radius: Some(0.1), ..savsm }),
            Filter::Mssm(SoftMoments::default()),
        ];
        others.into_iter().chain(sizes).chain(bells).chain(discs).chain(moments).collect()
    }

    #[test]
    fn every_combination_of_files_is_valid_wgsl() {
        validate("caster", &caster_wgsl());
        for filter in filters() {
            for select in [Select::Depth, Select::ClipDepth, Select::Map] {
                for (receiver_plane, blend, warp, shade) in [
                    (false, 0.0, Warp::None, Shade::Absence { darkness: 1.0 }),
                    (true, 0.0, Warp::None, Shade::Absence { darkness: 1.0 }),
                    (
                        false,
                        0.1,
                        Warp::Tsm,
                        Shade::Colour { shadow_colour: [0.0, 0.0, 0.0, 0.5], darkness: 1.0 },
                    ),
                    (
                        true,
                        0.1,
                        Warp::Psm,
                        Shade::Colour { shadow_colour: [0.0, 0.0, 0.0, 0.5], darkness: 1.0 },
                    ),
                ] {
                    let bias = Bias { receiver_plane, ..Bias::default() };
                    let settings =
                        Settings { filter, select, shade, bias, blend, warp, ..Settings::default() };
                    for filters_float32 in [true, false] {
                        let capabilities = Capabilities { filters_float32, ..Capabilities::ALL };
                        validate(&format!("{settings:?}"), &receiver_wgsl(&settings, capabilities, 3));
                    }
                }
            }
        }
    }

    #[test]
    fn the_group_is_the_one_asked_for() {
        for (filter, bindings) in [(Filter::Bilinear {}, 3), (Filter::Vsm(Variance::default()), 5)] {
            let settings = Settings { filter, ..Settings::default() };
            let text = receiver_wgsl(&settings, Capabilities::ALL, 2);
            assert_eq!(text.matches("@group(2)").count(), bindings);
            assert_eq!(text.matches("@group(").count(), bindings);
        }
    }
}
