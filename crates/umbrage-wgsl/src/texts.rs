//! The texts of receivers and casters, each with what it binds.

use umbrage_core::{Contact, DepthLayer, ShaderNumber, ShaderValue};

use crate::binding::{Binding, BindingKind, Dimension, SampleType, SamplerKind, Stages};
use crate::constants::lines;
use crate::contact_camera::ContactDepth;
use crate::error::ImportError;
use crate::key::{Read, ShaderKey, StoredLayout, Traced};
use crate::link::{Recipe, link};
use crate::slot::Slot;

/// Modules that every receiver's text holds: [`contact`] goes behind it.
const IN_EVERY_RECEIVER: &[&str] = &["frame", "light", "sampling/gradient_noise"];

/// What else a receiver's text is made of.
const RECEIVER: &[&str] = &["receiver/footprint", "receiver/shade", "receiver/by_maps", "receiver/receiver"];

/// WGSL to put in front of a receiver's shader: `umbrage_visibility(world_position, world_normal, pixel) -> f32`,
/// `umbrage_light_visibility(light, …)`, `umbrage_shade(ambient, lit, visibility) -> vec3f`, and for several lights
/// `umbrage_shading(ambient)`, `umbrage_add_light(shading, lit, visibility)` and `umbrage_shaded(shading) -> vec3f`. Its bindings
/// are [`receiver_bindings`], at `slot`: the number of a group of its own, or a [`Slot`] behind bindings of the host's.
pub fn receiver(key: &ShaderKey, slot: impl Into<Slot>) -> String {
    said(receiver_with(key, slot, &[]))
}

/// As [`receiver`], with modules that stand in for ours: `("storage/map", text)` says where matrices, tiles and texels come from
/// in a host that keeps its maps in its own way.
///
/// # Errors
/// When a module lacks a name that others import from it, imports what is not there, or declares a binding otherwise than as
/// `@group(0) @binding(7)`.
pub fn receiver_with(
    key: &ShaderKey,
    slot: impl Into<Slot>,
    replaced: &[(&str, &str)],
) -> Result<String, ImportError> {
    let roots = [IN_EVERY_RECEIVER, RECEIVER].concat();
    let (choices, constants) = (key.choices(), key.constants());
    let recipe =
        Recipe { roots: &roots, choices: &choices, constants: &constants, replaced, ..Recipe::default() };
    slot.into().move_bindings(&link(recipe)?)
}

/// What [`receiver`] binds.
pub fn receiver_bindings(key: &ShaderKey) -> Vec<Binding> {
    let stages = Stages::FragmentAndCompute;
    let sampler = |binding, name, kind| Binding { binding, name, kind: BindingKind::Sampler(kind), stages };
    let array_of = |name, sample| {
        let kind = BindingKind::Texture { sample, dimension: Dimension::D2Array };
        Binding { binding: 3, name, kind, stages }
    };
    let mut bindings = vec![Binding::frame(stages), Binding::depth_maps(1, "umbrage_map", stages)];
    match key.read {
        Read::Compared | Read::ComparedByTexel => {
            bindings.push(sampler(2, "umbrage_compare", SamplerKind::Comparison));
        }
        Read::Moments | Read::Loaded | Read::Gathered => {}
    }
    match key.stored.map(|stored| stored.layout) {
        None => {}
        Some(StoredLayout::Sums { .. }) => bindings.push(array_of("umbrage_sums", SampleType::Uint)),
        Some(StoredLayout::Moments { format, .. }) if format.is_filterable => bindings.extend([
            array_of("umbrage_moments", SampleType::FilterableFloat),
            sampler(4, "umbrage_smooth", SamplerKind::Filtering),
        ]),
        Some(StoredLayout::Moments { .. }) => bindings.push(array_of("umbrage_moments", SampleType::Float)),
    }
    if key.gathers() {
        bindings.push(sampler(5, "umbrage_nearest", SamplerKind::NonFiltering));
    }
    bindings.extend(key.traced.iter().flat_map(occluder_bindings));
    bindings
}

/// What a text binds that traces: see `umbrage-occluders`.
fn occluder_bindings(traced: &Traced) -> Vec<Binding> {
    let count = if traced.occluders.covers { 5 } else { 4 };
    let names =
        ["umbrage_nodes", "umbrage_placed", "umbrage_triangles", "umbrage_corners", "umbrage_coverage"];
    let binding = |(i, name)| Binding {
        binding: FIRST_OCCLUDER_BINDING + i,
        name,
        kind: BindingKind::Storage,
        stages: Stages::FragmentAndCompute,
    };
    (0..).zip(names).take(count).map(binding).collect()
}

/// The number of the first binding of what is traced. They follow each other: nodes, instances, triangles, corners, and
/// coverage where some triangles are not solid.
pub const FIRST_OCCLUDER_BINDING: u32 = 6;

/// WGSL of a compute shader `refit`, which makes hierarchies fit meshes that were bent, in workgroups of one mesh each:
/// see `umbrage-occluders`.
pub fn refit() -> String {
    said(link(Recipe { roots: &["exact/refit"], ..Recipe::default() }))
}

/// What [`refit`] binds: the meshes to refit, eight words each; their lists; the positions of the host's vertices; triangles,
/// corners and nodes as [`receiver`] reads them.
pub fn refit_bindings() -> Vec<Binding> {
    let (read, written) = (BindingKind::Storage, BindingKind::WrittenStorage);
    let kinds = [
        ("umbrage_refits", read),
        ("umbrage_refit_lists", read),
        ("umbrage_bent_positions", read),
        ("umbrage_bent_triangles", read),
        ("umbrage_bent_corners", written),
        ("umbrage_bent_nodes", written),
    ];
    let binding = |(binding, (name, kind))| Binding { binding, name, kind, stages: Stages::Compute };
    (0..).zip(kinds).map(binding).collect()
}

/// WGSL to put in front of a caster's shaders: `umbrage_caster_position(world_position) -> vec4f` for the vertex shader; for a
/// fragment shader, where casters have holes, `umbrage_caster_fragment(position)`, which does nothing here, and
/// `umbrage_caster_covers(position, id, coverage) -> bool`, whether what covers in part is drawn in this texel. Its bindings are
/// [`caster_bindings`], at `slot`: the number of a group of its own, or a [`Slot`] behind bindings of the host's.
pub fn caster(slot: impl Into<Slot>) -> String {
    caster_with("caster/first", slot.into())
}

/// WGSL that declares what [`caster`] does, for the second surface that the light meets: `umbrage_caster_fragment(position)` leaves
/// out the first, by discard, so every fragment shader calls it. Its bindings are [`peel_bindings`].
pub fn second_caster(slot: impl Into<Slot>) -> String {
    caster_with("caster/second", slot.into())
}

fn caster_with(surface: &str, slot: Slot) -> String {
    let roots = &["caster/caster", surface, "caster/covers"];
    said(link(Recipe { roots, ..Recipe::default() }).and_then(|text| slot.move_bindings(&text)))
}

/// What [`caster`] binds.
pub fn caster_bindings() -> Vec<Binding> {
    let stages = Stages::VertexAndFragment;
    vec![Binding::frame(stages), Binding::current_view(stages)]
}

/// WGSL of a vertex shader `clear`: a triangle that empties a whole tile. It binds nothing.
pub fn clear() -> String {
    said(link(Recipe { roots: &["caster/clear"], ..Recipe::default() }))
}

/// WGSL of a fragment shader `peel`, for a caster's vertex shader: it leaves out the first surface that the light meets.
pub fn peel() -> String {
    said(link(Recipe { roots: &["caster/peel"], ..Recipe::default() }))
}

/// What [`second_caster`] binds, and [`caster`] and [`peel`] bind together.
pub fn peel_bindings() -> Vec<Binding> {
    vec![
        Binding::frame(Stages::VertexAndFragment),
        Binding::current_view(Stages::VertexAndFragment),
        Binding::depth_maps(2, "umbrage_first", Stages::Fragment),
    ]
}

/// WGSL of a vertex shader `everywhere` and a fragment shader `join`, which make one depth of the first two surfaces; `None` where
/// only the first is stored.
pub fn join(layer: DepthLayer) -> Option<String> {
    let joined = match layer {
        DepthLayer::First => return None,
        DepthLayer::Second => "caster/join_second",
        DepthLayer::Midpoint => "caster/join_midpoint",
        DepthLayer::Dual => "caster/join_dual",
    };
    let choices = &[("umbrage_joined", joined)];
    Some(said(link(Recipe { roots: &["caster/join"], choices, ..Recipe::default() })))
}

/// What [`join`] binds.
pub fn join_bindings() -> Vec<Binding> {
    vec![
        Binding::frame(Stages::Fragment),
        Binding::current_view(Stages::Fragment),
        Binding::depth_maps(2, "umbrage_first", Stages::Fragment),
        Binding::depth_maps(3, "umbrage_second", Stages::Fragment),
    ]
}

/// WGSL of a vertex shader `everywhere` and a fragment shader `restore`, which fill a whole tile from the maps of what stands.
pub fn restore() -> String {
    said(link(Recipe { roots: &["caster/restore"], ..Recipe::default() }))
}

/// What [`restore`] binds.
pub fn restore_bindings() -> Vec<Binding> {
    vec![
        Binding::frame(Stages::Fragment),
        Binding::current_view(Stages::Fragment),
        Binding::depth_maps(2, "umbrage_still", Stages::Fragment),
    ]
}

/// WGSL of two compute steps that fit views to what the camera's depth shows, under [`Fit::Sample`](umbrage_core::Fit::Sample): `reduce`, in
/// workgroups of 64 × 64 pixels and one for each view, and then `choose`, in workgroups of 64 views, which writes the views of the
/// frame.
pub fn samples() -> String {
    let roots = &["samples/reduce", "samples/choose"];
    let text = said(link(Recipe { roots, ..Recipe::default() }));
    text.replace("var<storage, read> umbrage_frame", "var<storage, read_write> umbrage_frame")
}

/// What [`samples`] binds: the frame; what [`crate::LookBytes`] writes; [`crate::seen_size`] bytes that are 0 before each
/// frame; what is chosen, which stays from frame to frame; and the camera's depth.
pub fn samples_bindings() -> Vec<Binding> {
    let stages = Stages::Compute;
    let buffer = |binding, name, kind| Binding { binding, name, kind, stages };
    let depth = BindingKind::Texture { sample: SampleType::Float, dimension: Dimension::D2 };
    vec![
        buffer(0, "umbrage_frame", BindingKind::WrittenStorage),
        buffer(1, "umbrage_looks", BindingKind::Storage),
        buffer(2, "umbrage_seen", BindingKind::WrittenStorage),
        buffer(3, "umbrage_choices", BindingKind::WrittenStorage),
        Binding { binding: 4, name: "umbrage_seen_depth", kind: depth, stages },
    ]
}

/// WGSL for a shader of your own that looks into the maps: the views and the lights, in `umbrage_frame` (binding 0 of
/// group 0), and `umbrage_linear_depth(view_index, texel, stored) -> f32`, what a stored depth is worth.
pub fn map() -> String {
    said(link(Recipe { roots: &["linear_depth"], ..Recipe::default() }))
}

/// WGSL to put behind that of [`receiver`]: `umbrage_contact(light, world_position, world_normal, pixel) -> f32`, 1 for lit. Its
/// bindings are [`contact_bindings`], at `slot`. The text depends on all of `contact`. The camera's depth is reversed, and has one sample
/// a pixel: [`contact_in`] takes others.
pub fn contact(contact: &Contact, slot: impl Into<Slot>) -> String {
    contact_in(contact, ContactDepth::default(), slot)
}

/// As [`contact`], in a depth of another convention or kind. Its bindings are [`contact_bindings_in`].
pub fn contact_in(contact: &Contact, depth: ContactDepth, slot: impl Into<Slot>) -> String {
    let Contact { length, steps, thickness } = *contact;
    let far = if depth.forward { 1.0 } else { 0.0 };
    let constants = lines(&[
        ShaderNumber { name: "UMBRAGE_CONTACT_FAR", value: ShaderValue::F32(far) },
        ShaderNumber { name: "UMBRAGE_CONTACT_LENGTH", value: ShaderValue::F32(length) },
        ShaderNumber { name: "UMBRAGE_CONTACT_STEPS", value: ShaderValue::U32(steps) },
        ShaderNumber { name: "UMBRAGE_CONTACT_THICKNESS", value: ShaderValue::F32(thickness) },
    ]);
    let texture = match depth.multisampled {
        true => "receiver/contact_depth_multisampled",
        false => "receiver/contact_depth_single",
    };
    let (roots, choices, in_front) =
        (&["receiver/contact"], &[("umbrage_contact_depth", texture)], IN_EVERY_RECEIVER);
    let text = link(Recipe { roots, choices, constants: &constants, in_front, ..Recipe::default() });
    said(text.and_then(|text| slot.into().move_bindings(&text)))
}

/// What [`contact`] binds: the camera of [`crate::contact_camera`], and the depth that it sees.
pub fn contact_bindings() -> Vec<Binding> {
    contact_bindings_in(ContactDepth::default())
}

/// What [`contact_in`] binds.
pub fn contact_bindings_in(depth: ContactDepth) -> Vec<Binding> {
    let stages = Stages::FragmentAndCompute;
    let uniform = BindingKind::Uniform { has_dynamic_offset: false };
    let dimension = if depth.multisampled { Dimension::D2Multisampled } else { Dimension::D2 };
    let depth = BindingKind::Texture { sample: SampleType::Float, dimension };
    vec![
        Binding { binding: 0, name: "umbrage_contact_camera", kind: uniform, stages },
        Binding { binding: 1, name: "umbrage_contact_depth", kind: depth, stages },
    ]
}

/// WGSL of two compute steps that answer for a whole picture where some receivers are traced: `decide`, in workgroups of 8 × 8 pixels,
/// and then `trace`, in as many workgroups as [`left`] says. What [`receiver`] binds is group 0, what [`resolve_bindings`] says group
/// 1. `None` where none are traced.
pub fn resolve(key: &ShaderKey) -> Option<String> {
    key.traced?;
    let roots = [IN_EVERY_RECEIVER, RECEIVER, &["exact/resolve"]].concat();
    let (choices, constants) = (key.choices(), key.constants());
    Some(said(link(Recipe { roots: &roots, choices: &choices, constants: &constants, ..Recipe::default() })))
}

/// What [`resolve`] binds: what each pixel sees; how much of each light reaches it; and the list of what is left to rays, which begins
/// with its length, 0 before each frame.
pub fn resolve_bindings() -> Vec<Binding> {
    let stages = Stages::Compute;
    let buffer = |binding, name| Binding { binding, name, kind: BindingKind::WrittenStorage, stages };
    let receivers = BindingKind::Texture { sample: SampleType::Uint, dimension: Dimension::D2 };
    vec![
        Binding { binding: 0, name: "umbrage_receivers", kind: receivers, stages },
        buffer(1, "umbrage_resolved"),
        buffer(2, "umbrage_left"),
    ]
}

/// WGSL of a compute step `count`, one invocation, that says how many workgroups `trace` of [`resolve`] takes.
pub fn left() -> String {
    said(link(Recipe { roots: &["exact/left"], ..Recipe::default() }))
}

/// What [`left`] binds: the list, and the arguments of an indirect dispatch.
pub fn left_bindings() -> Vec<Binding> {
    let stages = Stages::Compute;
    vec![
        Binding { binding: 0, name: "umbrage_left_count", kind: BindingKind::Storage, stages },
        Binding { binding: 1, name: "umbrage_workgroups", kind: BindingKind::WrittenStorage, stages },
    ]
}

/// Umbrage's own modules always join, as a test holds. What could not be joined is a text that says why, and that no WGSL compiler
/// takes.
pub(crate) fn said(text: Result<String, ImportError>) -> String {
    text.unwrap_or_else(|error| format!("{error}\n"))
}
