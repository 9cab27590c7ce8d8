//! Every combination of keys is valid WGSL, and binds what its bindings say.

use naga::valid::{Capabilities, ValidationFlags, Validator};
use umbrage_core::{
    Bias, Contact, DepthLayer, Disc, Exact, Exponential, ExponentialVariance, Filter, Footprint, FourMoments,
    MomentPrecision, NoiseSource, Pcss, Precision, Prefilter, Select, Settings, SoftMoments, SummedVariance,
    Variance, Warp,
};

use crate::binding::{Binding, BindingKind, Dimension, SampleType, SamplerKind};
use crate::*;

pub(super) fn module(what: &str, text: &str) -> naga::Module {
    let module =
        naga::front::wgsl::parse_str(text).unwrap_or_else(|e| panic!("{what}: {}", e.emit_to_string(text)));
    let capabilities = Capabilities::STORAGE_TEXTURE_16BIT_NORM_FORMATS;
    let result = Validator::new(ValidationFlags::all(), capabilities).validate(&module);
    result.unwrap_or_else(|e| panic!("{what}: {}", e.emit_to_string(text)));
    module
}

/// What a text binds in a group is what its bindings say; `all` where it uses each of them.
fn binds(what: &str, text: &str, group: u32, bindings: &[Binding], all: bool) {
    let module = module(what, text);
    let mut found = 0;
    for (_, variable) in module.global_variables.iter() {
        let Some(at) = variable.binding.as_ref().filter(|at| at.group == group) else { continue };
        let name = variable.name.as_deref().unwrap();
        let wanted = bindings.iter().find(|b| (b.binding, b.name) == (at.binding, name));
        let Some(wanted) = wanted else {
            // Another entry point's.
            assert!(!all, "{what}: nothing says that {name} is binding {}", at.binding);
            continue;
        };
        let ty = &module.types[variable.ty].inner;
        assert!(is_kind(wanted.kind, variable.space, ty), "{what}: {name} is {ty:?}, not {:?}", wanted.kind);
        found += 1;
    }
    assert!(!all || found == bindings.len(), "{what}: {found} of {bindings:?}");
}

fn is_kind(kind: BindingKind, space: naga::AddressSpace, ty: &naga::TypeInner) -> bool {
    use naga::{ImageClass, ImageDimension, ScalarKind, TypeInner};
    match (kind, ty) {
        (BindingKind::WrittenStorage, _) => {
            let access = naga::StorageAccess::LOAD | naga::StorageAccess::STORE;
            space == naga::AddressSpace::Storage { access }
        }
        (BindingKind::Storage, _) => matches!(space, naga::AddressSpace::Storage { .. }),
        (BindingKind::Uniform { .. }, _) => space == naga::AddressSpace::Uniform,
        (BindingKind::Sampler(kind), TypeInner::Sampler { comparison }) => {
            *comparison == (kind == SamplerKind::Comparison)
        }
        (BindingKind::Texture { sample, dimension }, TypeInner::Image { dim, arrayed, class }) => {
            let is_multisampled = matches!(class, ImageClass::Sampled { multi: true, .. });
            let of = match class {
                ImageClass::Depth { .. } => sample == SampleType::Depth,
                ImageClass::Sampled { kind: ScalarKind::Uint, .. } => sample == SampleType::Uint,
                ImageClass::Sampled { .. } => {
                    matches!(sample, SampleType::Float | SampleType::FilterableFloat)
                }
                _ => false,
            };
            of && is_multisampled == (dimension == Dimension::D2Multisampled)
                && *dim == ImageDimension::D2
                && *arrayed == (dimension == Dimension::D2Array)
        }
        (BindingKind::StorageTexture { format }, TypeInner::Image { class, .. }) => {
            let wanted = format!("{format:?}");
            matches!(class, ImageClass::Storage { format, .. } if format!("{format:?}") == wanted)
        }
        _ => false,
    }
}

/// Every kind of filter, with every choice that one can ask for.
pub(super) fn filters() -> Vec<Filter> {
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
        let half = ExponentialVariance { precision: Precision::F16, ..evsm };
        let msm = FourMoments { prefilter, ..FourMoments::default() };
        [
            Filter::Vsm(Variance { prefilter, ..Variance::default() }),
            Filter::Esm(Exponential { prefilter, ..Exponential::default() }),
            Filter::Evsm2(evsm),
            Filter::Evsm4(evsm),
            Filter::Evsm2(half),
            Filter::Evsm4(half),
            Filter::Msm(msm),
            Filter::Msm(FourMoments { precision: MomentPrecision::U16, ..msm }),
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

/// What devices can do that have a filter.
fn supports(filter: &Filter) -> Vec<TextureSupport> {
    let opengl = TextureSupport { loads_depth: false, ..TextureSupport::WEBGPU };
    let mut supports = vec![TextureSupport::ALL, TextureSupport::WEBGPU];
    supports.extend((!filter.reads_depth_values()).then_some(opengl));
    supports
}

pub(super) fn keys() -> Vec<(String, ShaderKey)> {
    let mut keys = Vec::new();
    for filter in filters() {
        for select in [Select::Depth, Select::ClipDepth, Select::Map] {
            for (receiver_plane, blend, warp) in [
                (false, 0.0, Warp::None),
                (true, 0.0, Warp::None),
                (false, 0.1, Warp::Tsm),
                (true, 0.1, Warp::Psm),
            ] {
                let bias = Bias { receiver_plane, ..Bias::default() };
                let settings = Settings { filter, select, bias, blend, warp, ..Settings::default() };
                for support in supports(&filter) {
                    keys.push((format!("{settings:?}, {support:?}"), ShaderKey::new(&settings, support)));
                }
            }
        }
        if ["hard", "optimised", "poisson", "footprint", "pcss", "savsm", "msm"].contains(&filter.kind()) {
            keys.extend(traced(filter));
        }
    }
    keys
}

/// The keys of texts that trace, with a filter.
fn traced(filter: Filter) -> Vec<(String, ShaderKey)> {
    let mut keys = Vec::new();
    for exact in [Exact::Undecided, Exact::Always] {
        for (covers, left_to_maps) in [(false, false), (false, true), (true, false), (true, true)] {
            for (receiver_plane, select, support) in
                [(true, Select::Map, TextureSupport::ALL), (false, Select::Depth, TextureSupport::WEBGPU)]
            {
                let bias = Bias { receiver_plane, ..Bias::default() };
                let settings = Settings { filter, exact, select, bias, blend: 0.1, ..Settings::default() };
                let occluders = Some(OccluderTraits { covers, left_to_maps });
                let key = ShaderKey::with_occluders(&settings, support, occluders);
                keys.push((format!("{settings:?}, {occluders:?}, {support:?}"), key));
            }
        }
    }
    keys
}

#[test]
fn every_combination_of_modules_is_valid_wgsl_and_binds_what_it_says() {
    for (what, key) in keys() {
        let behind = |binding: Binding| Binding { binding: binding.binding + 7, ..binding };
        let bindings: Vec<_> = receiver_bindings(&key).into_iter().map(behind).collect();
        binds(&what, &receiver(&key, Slot { group: 3, first_binding: 7 }), 3, &bindings, true);
    }
}

#[test]
fn what_answers_for_a_whole_picture_is_valid_wgsl_and_binds_what_it_says() {
    binds("left", &left(), 0, &left_bindings(), true);
    let mut count = 0;
    for (what, key) in keys() {
        assert_eq!(resolve(&key).is_some(), key.traces(), "{what}");
        let Some(text) = resolve(&key) else { continue };
        binds(&what, &text, 0, &receiver_bindings(&key), true);
        binds(&what, &text, 1, &resolve_bindings(), true);
        count += 1;
    }
    assert!(count > 100, "{count} texts trace");
}

#[test]
fn every_step_is_valid_wgsl_and_binds_what_it_says() {
    for filter in filters() {
        for support in [TextureSupport::ALL, TextureSupport::WEBGPU] {
            let key = ShaderKey::new(&Settings { filter, ..Settings::default() }, support);
            let moments = key.moment_steps();
            let sums = key.sum_steps();
            let steps = moments.into_iter().flat_map(|s| [s.convert, s.across, s.down, s.halve]);
            for step in steps.chain(sums.into_iter().flat_map(|s| [s.rows, s.columns])) {
                let what = format!("{filter:?}, {}", step.entry_point);
                binds(&what, &step.text, 0, &step.bindings, false);
                let module = module(&what, &step.text);
                assert!(module.entry_points.iter().any(|e| e.name == step.entry_point), "{what}");
            }
        }
    }
}

#[test]
fn the_other_texts_are_valid_wgsl_and_bind_what_they_say() {
    binds("caster", &caster(2), 2, &caster_bindings(), true);
    binds("second caster", &second_caster(3), 3, &peel_bindings(), true);
    binds("peel", &peel(), 0, &peel_bindings(), true);
    binds("restore", &restore(), 0, &restore_bindings(), true);
    binds("clear", &clear(), 0, &[], true);
    binds("samples", &samples(), 0, &samples_bindings(), true);
    binds("refit", &refit(), 0, &refit_bindings(), true);
    binds("map", &map(), 0, &[Binding::frame(Stages::Fragment)], true);
    for layer in [DepthLayer::Second, DepthLayer::Midpoint, DepthLayer::Dual] {
        binds("join", &join(layer).expect("two layers"), 0, &join_bindings(), true);
    }
    assert_eq!(join(DepthLayer::First), None);
}

#[test]
fn the_march_is_valid_wgsl_from_its_shortest_to_its_longest() {
    let receiver = receiver(&ShaderKey::new(&Settings::default(), TextureSupport::ALL), 1);
    for of in [
        Contact::default(),
        Contact { length: 1e-30, steps: 1, thickness: 1e-30 },
        Contact { length: 100.0, steps: Contact::MAX_STEPS, thickness: 100.0 },
    ] {
        for (forward, multisampled) in [(false, false), (true, false), (false, true), (true, true)] {
            let depth = ContactDepth { forward, multisampled };
            let text = receiver.clone() + &contact_in(&of, depth, 3);
            binds(&format!("{of:?} {depth:?}"), &text, 3, &contact_bindings_in(depth), true);
        }
    }
}

#[test]
fn equal_keys_give_equal_texts_and_what_is_in_the_frame_is_not_in_the_key() {
    let key = |settings: Settings| ShaderKey::new(&settings, TextureSupport::ALL);
    let default = key(Settings::default());
    let other = Settings {
        lambda: 0.1,
        distance: Some(30.0),
        bias: Bias { constant: 0.5, slope: 0.5, normal: 0.25, terminator: 0.3, ..Bias::default() },
        shade: umbrage_core::Shade::Colour { shadow_colour: [0.0, 0.0, 0.2, 0.5], darkness: 0.5 },
        ..Settings::default()
    };
    assert_eq!(key(other.clone()), default);
    assert_eq!(receiver(&key(other), 1), receiver(&default, 1));
    let narrow = key(Settings { blend: 0.1, ..Settings::default() });
    assert_eq!(key(Settings { blend: 0.2, ..Settings::default() }), narrow);
    assert_ne!(narrow, default);
}
