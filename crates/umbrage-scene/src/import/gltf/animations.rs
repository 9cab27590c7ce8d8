//! The animations of a file. Channels that cannot be read, or move what casts no shadow, are left out one by one.
//!
//! Source: glTF 2.0, section 3.11, *Animations*.

use gltf::json::{Value, deserialize};

use super::accessors::Data;
use super::document::Document;
use super::targets::{self, Target};
use super::tracks::{self, Sampler};
use crate::error::Fault;
use crate::extras;
use crate::import::budget::Budget;
use crate::import::warnings::Warnings;
use crate::rig::{Animation, Channel};

/// Reads all animations that move something, in the file's order. The nodes of their channels are those of the file.
pub(super) fn read(
    document: &Document,
    data: &Data<'_>,
    budget: &mut Budget,
    warnings: &mut Warnings,
) -> Vec<Animation> {
    let mut animations = Vec::new();
    for (i, raw) in document.animations.iter().enumerate() {
        data.progress.step("animations", i, document.animations.len());
        let animation: Value = match deserialize::from_str(raw.get()) {
            Ok(animation) => animation,
            Err(why) => {
                let why = super::members::plain(&why);
                warnings.note("animations that cannot be read are ignored", &format!("animation {i}, {why}"));
                continue;
            }
        };
        let name = animation.get("name").and_then(Value::as_str).unwrap_or_default().to_owned();
        let label = if name.is_empty() { format!("animation {i}") } else { format!("animation {name:?}") };
        let mut channels = Vec::new();
        let listed = animation.get("channels").and_then(Value::as_array).map_or(&[][..], Vec::as_slice);
        for (k, channel) in listed.iter().enumerate() {
            let read = match targets::of(channel.get("target"), document.root.nodes.len()) {
                Target::Node(node, property) => {
                    let sampler = Sampler::of(animation.get("samplers"), channel.get("sampler"));
                    let targets = morph_targets(document, node);
                    sampler
                        .and_then(|sampler| tracks::read(data, sampler, property, targets, budget))
                        .map(|track| Channel { node, track })
                }
                Target::Elsewhere(pointer) => {
                    warnings.note("animated pointers that are not about what casts are ignored", &pointer);
                    continue;
                }
                Target::Nothing(why) => Err(Fault(why)),
            };
            match read {
                Ok(channel) => channels.push(channel),
                Err(Fault(why)) => {
                    let what = "channels of animations that cannot be read are ignored";
                    warnings.note(what, &format!("channel {k} of {label}, {why}"));
                }
            }
        }
        if !channels.is_empty() {
            let seconds = seconds(&animation, &channels);
            animations.push(Animation { name, seconds, channels });
        }
    }
    animations
}

/// The time of the last key, unless [`crate::to_glb`] wrote another.
fn seconds(animation: &Value, channels: &[Channel]) -> f32 {
    let last =
        channels.iter().filter_map(|channel| channel.track.times().last().copied()).fold(0.0, f32::max);
    extras::seconds_of(animation).unwrap_or(last)
}

/// How many morph targets a node's mesh has, as its primitives say.
pub(super) fn morph_targets(document: &Document, node: usize) -> usize {
    let root = &document.root;
    let mesh = root.nodes.get(node).and_then(|node| node.mesh).and_then(|mesh| root.meshes.get(mesh.value()));
    mesh.map_or(0, targets_of)
}

/// How many morph targets the primitives of a mesh have; where they differ, the most.
pub(super) fn targets_of(mesh: &gltf::json::Mesh) -> usize {
    mesh.primitives.iter().map(|primitive| primitive.targets.as_ref().map_or(0, Vec::len)).max().unwrap_or(0)
}
