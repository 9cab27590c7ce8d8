//! Assembles the shader text that goes in front of yours: plain files, one after another, no preprocessor.

use std::fmt::Write as _;

use umbrage_core::{Bias, Filter, Select, Settings, Shade, kernel_half_width_texels};

const FRAME: &str = include_str!("../shaders/frame.wgsl");
const CASTER: &str = include_str!("../shaders/caster.wgsl");
const RECEIVER: &str = include_str!("../shaders/receiver.wgsl");

/// WGSL for a caster's vertex shader: `umbrage_caster_position(world_position) -> vec4f`. Its bindings are group 0 of
/// the pipeline; yours start at 1.
pub fn caster_wgsl() -> String {
    [FRAME, CASTER].join("\n")
}

/// WGSL for a receiver's fragment shader: `umbrage_visibility(world_position, world_normal, pixel) -> f32`,
/// `umbrage_light_visibility(light, …)`, `umbrage_shade(ambient, lit, visibility) -> vec3f`. Its bindings are group
/// `group` of the pipeline. The text depends on `select`, `filter`, `bias.receiver_plane` and `shade` of the settings.
pub fn receiver_wgsl(settings: &Settings, group: u32) -> String {
    let select = match settings.select {
        Select::Depth => include_str!("../shaders/select/depth.wgsl"),
        Select::ClipDepth => include_str!("../shaders/select/clip_depth.wgsl"),
        Select::Map => include_str!("../shaders/select/map.wgsl"),
    };
    let receiver_plane = settings.bias.receiver_plane;
    let reference = if receiver_plane {
        include_str!("../shaders/reference/plane.wgsl")
    } else {
        include_str!("../shaders/reference/point.wgsl")
    };
    let filter = match settings.filter {
        Filter::Hard {} => include_str!("../shaders/filter/hard.wgsl"),
        Filter::Bilinear {} | Filter::Pcf { .. } if receiver_plane => {
            include_str!("../shaders/filter/plane.wgsl")
        }
        Filter::Bilinear {} => include_str!("../shaders/filter/bilinear.wgsl"),
        Filter::Pcf { .. } => include_str!("../shaders/filter/pcf.wgsl"),
    };
    let shade = match settings.shade {
        Shade::Absence { .. } => include_str!("../shaders/shade/absence.wgsl"),
        Shade::Colour { .. } => include_str!("../shaders/shade/colour.wgsl"),
    };
    [FRAME, &constants(settings), RECEIVER, select, reference, filter, shade]
        .join("\n")
        .replace("@group(0)", &format!("@group({group})"))
}

/// The numbers that a pipeline fixes.
fn constants(settings: &Settings) -> String {
    let half_width = kernel_half_width_texels(settings.filter);
    // Writing to a string cannot fail.
    let mut text = format!("const UMBRAGE_KERNEL_HALF_WIDTH: f32 = {half_width:?};\n");
    if settings.bias.receiver_plane {
        let _ = writeln!(text, "const UMBRAGE_STEEPEST_PLANE: f32 = {:?};", Bias::STEEPEST_PLANE);
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
                    for receiver_plane in [false, true] {
                        let bias = Bias { receiver_plane, ..Bias::default() };
                        let settings = Settings { filter, select, shade, bias, ..Settings::default() };
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
