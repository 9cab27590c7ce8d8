//! What the viewer copies as Rust is Rust: these are its own words for every preset, compiled.

use umbrage::PRESETS;

/// Each preset's name, and what is copied for it.
#[rustfmt::skip] // a line a preset
fn copied() -> Vec<(&'static str, umbrage::Settings)> {
    vec![
        ("default", umbrage::Settings { ..umbrage::Settings::default() }),
        ("default-4mib", umbrage::Settings { resolution: 724, ..umbrage::Settings::default() }),
        ("default-64mib", umbrage::Settings { resolution: 2896, ..umbrage::Settings::default() }),
        ("fast", umbrage::Settings { splits: 3, filter: umbrage::Filter::Bilinear {}, ..umbrage::Settings::default() }),
        ("fast-4mib", umbrage::Settings { splits: 3, resolution: 724, filter: umbrage::Filter::Bilinear {}, ..umbrage::Settings::default() }),
        ("fast-64mib", umbrage::Settings { splits: 3, resolution: 2896, filter: umbrage::Filter::Bilinear {}, ..umbrage::Settings::default() }),
        ("best", umbrage::Settings { filter: umbrage::Filter::Footprint(umbrage::Footprint { taps: 32, max_texels: 8.0 }), ..umbrage::Settings::default() }),
        ("best-4mib", umbrage::Settings { resolution: 724, filter: umbrage::Filter::Footprint(umbrage::Footprint { taps: 32, max_texels: 8.0 }), ..umbrage::Settings::default() }),
        ("best-64mib", umbrage::Settings { resolution: 2896, filter: umbrage::Filter::Footprint(umbrage::Footprint { taps: 32, max_texels: 8.0 }), ..umbrage::Settings::default() }),
        ("soft", umbrage::Settings { resolution: 1024, depth: umbrage::DepthFormat::F32, filter: umbrage::Filter::Pcss(umbrage::Pcss { light: umbrage::LightSize { sun_degrees: 0.53, punctual_metres: 0.1 }, blockers: 16, taps: 16, max_texels: 32.0, noise: umbrage::NoiseSource::Screen }), ..umbrage::Settings::default() }),
        ("soft-4mib", umbrage::Settings { resolution: 512, depth: umbrage::DepthFormat::F32, filter: umbrage::Filter::Pcss(umbrage::Pcss { light: umbrage::LightSize { sun_degrees: 0.53, punctual_metres: 0.1 }, blockers: 16, taps: 16, max_texels: 16.0, noise: umbrage::NoiseSource::Screen }), ..umbrage::Settings::default() }),
        ("soft-64mib", umbrage::Settings { resolution: 2048, depth: umbrage::DepthFormat::F32, filter: umbrage::Filter::Pcss(umbrage::Pcss { light: umbrage::LightSize { sun_degrees: 0.53, punctual_metres: 0.1 }, blockers: 16, taps: 16, max_texels: 64.0, noise: umbrage::NoiseSource::Screen }), ..umbrage::Settings::default() }),
        ("soft-fast", umbrage::Settings { splits: 3, resolution: 1024, depth: umbrage::DepthFormat::F32, filter: umbrage::Filter::Pcss(umbrage::Pcss { light: umbrage::LightSize { sun_degrees: 0.53, punctual_metres: 0.1 }, blockers: 8, taps: 8, max_texels: 32.0, noise: umbrage::NoiseSource::Screen }), ..umbrage::Settings::default() }),
        ("soft-fast-4mib", umbrage::Settings { splits: 3, resolution: 512, depth: umbrage::DepthFormat::F32, filter: umbrage::Filter::Pcss(umbrage::Pcss { light: umbrage::LightSize { sun_degrees: 0.53, punctual_metres: 0.1 }, blockers: 8, taps: 8, max_texels: 16.0, noise: umbrage::NoiseSource::Screen }), ..umbrage::Settings::default() }),
        ("soft-fast-64mib", umbrage::Settings { splits: 3, resolution: 2048, depth: umbrage::DepthFormat::F32, filter: umbrage::Filter::Pcss(umbrage::Pcss { light: umbrage::LightSize { sun_degrees: 0.53, punctual_metres: 0.1 }, blockers: 8, taps: 8, max_texels: 64.0, noise: umbrage::NoiseSource::Screen }), ..umbrage::Settings::default() }),
        ("soft-best", umbrage::Settings { resolution: 1024, depth: umbrage::DepthFormat::F32, filter: umbrage::Filter::Pcss(umbrage::Pcss { light: umbrage::LightSize { sun_degrees: 0.53, punctual_metres: 0.1 }, blockers: 32, taps: 64, max_texels: 32.0, noise: umbrage::NoiseSource::Screen }), ..umbrage::Settings::default() }),
        ("soft-best-4mib", umbrage::Settings { resolution: 512, depth: umbrage::DepthFormat::F32, filter: umbrage::Filter::Pcss(umbrage::Pcss { light: umbrage::LightSize { sun_degrees: 0.53, punctual_metres: 0.1 }, blockers: 32, taps: 64, max_texels: 16.0, noise: umbrage::NoiseSource::Screen }), ..umbrage::Settings::default() }),
        ("soft-best-64mib", umbrage::Settings { resolution: 2048, depth: umbrage::DepthFormat::F32, filter: umbrage::Filter::Pcss(umbrage::Pcss { light: umbrage::LightSize { sun_degrees: 0.53, punctual_metres: 0.1 }, blockers: 32, taps: 64, max_texels: 64.0, noise: umbrage::NoiseSource::Screen }), ..umbrage::Settings::default() }),
        ("sdsm", umbrage::Settings { lambda: 1.0, fit: umbrage::Fit::Sample, ..umbrage::Settings::default() }),
        ("sdsm-4mib", umbrage::Settings { lambda: 1.0, resolution: 724, fit: umbrage::Fit::Sample, ..umbrage::Settings::default() }),
        ("sdsm-64mib", umbrage::Settings { lambda: 1.0, resolution: 2896, fit: umbrage::Fit::Sample, ..umbrage::Settings::default() }),
        ("ferko-sm-1024", umbrage::Settings { splits: 1, lambda: 0.5, resolution: 1024, depth: umbrage::DepthFormat::F32, caster_error: 0.0, select: umbrage::Select::Depth, filter: umbrage::Filter::Hard {}, bias: umbrage::Bias { constant: 0.002, slope_limit: 2.0, bend: 0.0, normal: 1.0, receiver_plane: false, ..umbrage::Bias::default() }, ..umbrage::Settings::default() }),
        ("ferko-sm-2048", umbrage::Settings { splits: 1, lambda: 0.5, resolution: 2048, depth: umbrage::DepthFormat::F32, caster_error: 0.0, select: umbrage::Select::Depth, filter: umbrage::Filter::Hard {}, bias: umbrage::Bias { constant: 0.002, slope_limit: 2.0, bend: 0.0, normal: 1.0, receiver_plane: false, ..umbrage::Bias::default() }, ..umbrage::Settings::default() }),
        ("ferko-pssm-3x512", umbrage::Settings { splits: 3, lambda: 0.5, resolution: 512, depth: umbrage::DepthFormat::F32, caster_error: 0.0, select: umbrage::Select::Depth, filter: umbrage::Filter::Hard {}, bias: umbrage::Bias { constant: 0.002, slope_limit: 2.0, bend: 0.0, normal: 1.0, receiver_plane: false, ..umbrage::Bias::default() }, ..umbrage::Settings::default() }),
        ("ferko-pssm-3x1024", umbrage::Settings { splits: 3, lambda: 0.5, resolution: 1024, depth: umbrage::DepthFormat::F32, caster_error: 0.0, select: umbrage::Select::Depth, filter: umbrage::Filter::Hard {}, bias: umbrage::Bias { constant: 0.002, slope_limit: 2.0, bend: 0.0, normal: 1.0, receiver_plane: false, ..umbrage::Bias::default() }, ..umbrage::Settings::default() }),
        ("zhang-ssm-1024", umbrage::Settings { splits: 1, lambda: 0.5, resolution: 1024, depth: umbrage::DepthFormat::F32, fit: umbrage::Fit::View, caster_error: 0.0, select: umbrage::Select::Depth, filter: umbrage::Filter::Hard {}, bias: umbrage::Bias { constant: 0.002, slope_limit: 2.0, bend: 0.0, normal: 1.0, receiver_plane: false, ..umbrage::Bias::default() }, ..umbrage::Settings::default() }),
        ("zhang-psm-1024", umbrage::Settings { splits: 1, lambda: 0.5, resolution: 1024, depth: umbrage::DepthFormat::F32, fit: umbrage::Fit::View, caster_error: 0.0, warp: umbrage::Warp::Psm, select: umbrage::Select::Depth, filter: umbrage::Filter::Hard {}, bias: umbrage::Bias { constant: 0.002, slope_limit: 2.0, bend: 0.0, normal: 1.0, receiver_plane: false, ..umbrage::Bias::default() }, ..umbrage::Settings::default() }),
        ("zhang-lispsm-1024", umbrage::Settings { splits: 1, lambda: 0.5, resolution: 1024, depth: umbrage::DepthFormat::F32, fit: umbrage::Fit::View, caster_error: 0.0, warp: umbrage::Warp::Lispsm, select: umbrage::Select::Depth, filter: umbrage::Filter::Hard {}, bias: umbrage::Bias { constant: 0.002, slope_limit: 2.0, bend: 0.0, normal: 1.0, receiver_plane: false, ..umbrage::Bias::default() }, ..umbrage::Settings::default() }),
        ("zhang-tsm-1024", umbrage::Settings { splits: 1, lambda: 0.5, resolution: 1024, depth: umbrage::DepthFormat::F32, fit: umbrage::Fit::View, caster_error: 0.0, warp: umbrage::Warp::Tsm, select: umbrage::Select::Depth, filter: umbrage::Filter::Hard {}, bias: umbrage::Bias { constant: 0.002, slope_limit: 2.0, bend: 0.0, normal: 1.0, receiver_plane: false, ..umbrage::Bias::default() }, ..umbrage::Settings::default() }),
        ("zhang-pssm2-512", umbrage::Settings { splits: 2, lambda: 0.5, resolution: 512, depth: umbrage::DepthFormat::F32, fit: umbrage::Fit::View, caster_error: 0.0, select: umbrage::Select::Depth, filter: umbrage::Filter::Hard {}, bias: umbrage::Bias { constant: 0.002, slope_limit: 2.0, bend: 0.0, normal: 1.0, receiver_plane: false, ..umbrage::Bias::default() }, ..umbrage::Settings::default() }),
        ("zhang-pssm3-512", umbrage::Settings { splits: 3, lambda: 0.5, resolution: 512, depth: umbrage::DepthFormat::F32, fit: umbrage::Fit::View, caster_error: 0.0, select: umbrage::Select::Depth, filter: umbrage::Filter::Hard {}, bias: umbrage::Bias { constant: 0.002, slope_limit: 2.0, bend: 0.0, normal: 1.0, receiver_plane: false, ..umbrage::Bias::default() }, ..umbrage::Settings::default() }),
        ("zhang-pssm4-512", umbrage::Settings { lambda: 0.5, resolution: 512, depth: umbrage::DepthFormat::F32, fit: umbrage::Fit::View, caster_error: 0.0, select: umbrage::Select::Depth, filter: umbrage::Filter::Hard {}, bias: umbrage::Bias { constant: 0.002, slope_limit: 2.0, bend: 0.0, normal: 1.0, receiver_plane: false, ..umbrage::Bias::default() }, ..umbrage::Settings::default() }),
        ("tutorial-16", umbrage::Settings { splits: 1, resolution: 1024, caster_error: 0.0, select: umbrage::Select::Depth, filter: umbrage::Filter::Stratified(umbrage::Disc { taps: 4, radius: None, radius_texels: 1.4628571, centred: false, noise: umbrage::NoiseSource::Screen, early_out: false }), bias: umbrage::Bias { slope: 7.6799994, slope_limit: 2.0, bend: 0.0, receiver_plane: false, ..umbrage::Bias::default() }, ..umbrage::Settings::default() }),
        ("bevy", umbrage::Settings { scheme: umbrage::Scheme::Manual, manual: vec![10.0, 24.66, 60.82], distance: Some(150.0), resolution: 2048, depth: umbrage::DepthFormat::F32, fit: umbrage::Fit::Stable, caster_error: 0.0, select: umbrage::Select::Depth, blend: 0.2, filter: umbrage::Filter::Optimised { size: 5 }, bias: umbrage::Bias { constant: 0.02, slope_limit: 2.0, bend: 0.0, normal: 0.6, receiver_plane: false, ..umbrage::Bias::default() }, ..umbrage::Settings::default() }),
        ("godot", umbrage::Settings { scheme: umbrage::Scheme::Manual, manual: vec![10.0, 20.0, 50.0], distance: Some(100.0), resolution: 2048, storage: umbrage::Storage::Atlas, fit: umbrage::Fit::Stable, caster_error: 0.0, select: umbrage::Select::Depth, filter: umbrage::Filter::Vogel(umbrage::Disc { taps: 8, radius: None, radius_texels: 1.5, centred: true, noise: umbrage::NoiseSource::Screen, early_out: false }), bias: umbrage::Bias { constant: 0.1, slope_limit: 2.0, bend: 0.0, normal: 0.8, receiver_plane: false, ..umbrage::Bias::default() }, ..umbrage::Settings::default() }),
        ("filament", umbrage::Settings { splits: 1, distance: Some(100.0), resolution: 1024, depth: umbrage::DepthFormat::F32, caster_error: 0.0, warp: umbrage::Warp::Lispsm, select: umbrage::Select::Depth, bias: umbrage::Bias { raster_constant: 2, raster_slope: 0.5, constant: 0.001, slope_limit: 2.0, bend: 0.0, normal: 0.5, receiver_plane: false, ..umbrage::Bias::default() }, ..umbrage::Settings::default() }),
        ("three", umbrage::Settings { splits: 3, lambda: 0.5, resolution: 2048, depth: umbrage::DepthFormat::F32, fit: umbrage::Fit::Stable, caster_error: 0.0, select: umbrage::Select::Depth, filter: umbrage::Filter::Vogel(umbrage::Disc { taps: 5, radius: None, radius_texels: 1.0, centred: true, noise: umbrage::NoiseSource::Screen, early_out: false }), bias: umbrage::Bias { slope_limit: 2.0, bend: 0.0, receiver_plane: false, casters: umbrage::CasterFaces::Back, ..umbrage::Bias::default() }, ..umbrage::Settings::default() }),
        ("mjp", umbrage::Settings { scheme: umbrage::Scheme::Manual, manual: vec![12.5, 37.5, 125.0], distance: Some(250.0), resolution: 2048, depth: umbrage::DepthFormat::F32, fit: umbrage::Fit::View, caster_error: 0.0, blend: 0.1, filter: umbrage::Filter::Pcf { size: 7 }, bias: umbrage::Bias { constant: 0.005, slope_limit: 2.0, bend: 0.0, ..umbrage::Bias::default() }, ..umbrage::Settings::default() }),
    ]
}

#[test]
fn what_is_copied_makes_the_settings_that_it_was_copied_from() {
    let copied = copied();
    assert_eq!(copied.len(), PRESETS.len());
    for (preset, (name, settings)) in PRESETS.iter().zip(copied) {
        assert_eq!((preset.name, (preset.settings)()), (name, settings));
    }
}

#[test]
fn these_are_the_viewers_own_words() {
    let bare = |text: &str| text.chars().filter(|c| !c.is_whitespace() && *c != ',').collect::<String>();
    let file = bare(include_str!("as_rust.rs"));
    for preset in PRESETS {
        let words = bare(&umbrage_viewer::rust_text::rust(&(preset.settings)()).expect("Rust"));
        assert!(file.contains(&format!("(\"{}\"{words}", preset.name)), "{}", preset.name);
    }
}
