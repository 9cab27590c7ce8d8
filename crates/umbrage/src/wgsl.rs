//! Assembles the shader text that goes in front of yours: plain files, one after another, no preprocessor.

use std::fmt::Write as _;

use umbrage_core::{
    Filter, Footing, RASTER_STEP_TEXELS, Reference, Select, Settings, Shade, kernel_half_width_texels,
};

const FRAME: &str = include_str!("../shaders/frame.wgsl");
const CASTER: &str = include_str!("../shaders/caster.wgsl");
const FOOTING: &str = include_str!("../shaders/footing.wgsl");
const RECEIVER: &str = include_str!("../shaders/receiver.wgsl");

const FADE: &str = include_str!("../shaders/blend/fade.wgsl");

/// WGSL for a caster's vertex shader: `umbrage_caster_position(world_position) -> vec4f`. Its bindings are group 0 of
/// the pipeline; yours start at 1.
pub fn caster_wgsl() -> String {
    [FRAME, CASTER].join("\n")
}

/// WGSL for a receiver's fragment shader: `umbrage_visibility(world_position, world_normal, pixel) -> f32`,
/// `umbrage_light_visibility(light, …)`, `umbrage_shade(ambient, lit, visibility) -> vec3f`. Its bindings are group
/// `group` of the pipeline. The text depends on `select`, `blend`, `filter`, `warp`, `bias.receiver_plane`
/// and `shade` of the settings.
pub fn receiver_wgsl(settings: &Settings, group: u32) -> String {
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
    let reference = match settings.reference() {
        Reference::Plane => include_str!("../shaders/reference/plane.wgsl"),
        Reference::Facing => include_str!("../shaders/reference/facing.wgsl"),
        Reference::Own => include_str!("../shaders/reference/own.wgsl"),
    };
    let filter = match (settings.filter, settings.reference()) {
        (Filter::Hard {}, _) => include_str!("../shaders/filter/hard.wgsl"),
        (Filter::Bilinear {}, Reference::Own) => include_str!("../shaders/filter/bilinear.wgsl"),
        (Filter::Pcf { .. }, Reference::Own) => include_str!("../shaders/filter/pcf.wgsl"),
        (Filter::Bilinear {} | Filter::Pcf { .. }, Reference::Plane | Reference::Facing) => {
            include_str!("../shaders/filter/each.wgsl")
        }
    };
    let shade = match settings.shade {
        Shade::Absence { .. } => include_str!("../shaders/shade/absence.wgsl"),
        Shade::Colour { .. } => include_str!("../shaders/shade/colour.wgsl"),
    };
    [FRAME, &constants(settings), FOOTING, RECEIVER, select, reference, filter, blend[0], blend[1], shade]
        .join("\n")
        .replace("@group(0)", &format!("@group({group})"))
}

/// The numbers that a pipeline fixes.
fn constants(settings: &Settings) -> String {
    let half_width = kernel_half_width_texels(settings.filter);
    // Writing to a string cannot fail.
    let mut text = format!("const UMBRAGE_KERNEL_HALF_WIDTH: f32 = {half_width:?};\n");
    let _ = writeln!(text, "const UMBRAGE_STEEPEST_PLANE: f32 = {:?};", Footing::STEEPEST_PLANE);
    let _ = writeln!(text, "const UMBRAGE_RASTER_STEP: f32 = {RASTER_STEP_TEXELS:?};");
    if settings.blend > 0.0 {
        let _ = writeln!(text, "const UMBRAGE_BLEND: f32 = {:?};", settings.blend);
    }
    let pcf_size = match settings.filter {
        Filter::Hard {} => None,
        Filter::Bilinear {} => Some(1),
        Filter::Pcf { size } => Some(size),
    };
    if let Some(size) = pcf_size {
        let _ = writeln!(text, "const UMBRAGE_PCF_SIZE: i32 = {size};");
    }
    text
}

#[cfg(test)]
mod tests {
    use umbrage_core::{Bias, Warp};

    use super::*;

    fn validate(what: &str, text: &str) {
        let module = naga::front::wgsl::parse_str(text)
            .unwrap_or_else(|e| panic!("{what}: {}", e.emit_to_string(text)));
        let capabilities = naga::valid::Capabilities::empty();
        let mut validator = naga::valid::Validator::new(naga::valid::ValidationFlags::all(), capabilities);
        validator.validate(&module).unwrap_or_else(|e| panic!("{what}: {}", e.emit_to_string(text)));
    }

    #[test]
    fn every_combination_of_files_is_valid_wgsl() {
        validate("caster", &caster_wgsl());
        let filters = [Filter::Hard {}, Filter::Bilinear {}]
            .into_iter()
            .chain([1, 3, 5, 7, 9].map(|size| Filter::Pcf { size }));
        for filter in filters {
            for select in [Select::Depth, Select::ClipDepth, Select::Map] {
                for shade in [
                    Shade::Absence { darkness: 1.0 },
                    Shade::Colour { shadow_colour: [0.0, 0.0, 0.0, 0.5], darkness: 1.0 },
                ] {
                    for (receiver_plane, blend, warp) in [
                        (false, 0.0, Warp::None),
                        (true, 0.0, Warp::None),
                        (false, 0.1, Warp::Tsm),
                        (true, 0.1, Warp::Psm),
                    ] {
                        let bias = Bias { receiver_plane, ..Bias::default() };
                        let settings =
                            Settings { filter, select, shade, bias, blend, warp, ..Settings::default() };
                        validate(&format!("{settings:?}"), &receiver_wgsl(&settings, 3));
                    }
                }
            }
        }
    }

    #[test]
    fn the_group_is_the_one_asked_for() {
        let text = receiver_wgsl(&Settings::default(), 2);
        assert_eq!(text.matches("@group(2)").count(), 3);
        assert_eq!(text.matches("@group(").count(), 3);
    }
}
