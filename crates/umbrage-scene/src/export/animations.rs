//! Animations as glTF writes them. The crate that writes the rest knows no pointers, so their JSON is made here.
//!
//! Source: glTF 2.0, section 3.11, *Animations*; `KHR_animation_pointer`.

use glam::{Quat, Vec3};
use gltf::json::accessor::{ComponentType, Type};
use gltf::json::{Accessor, Index, Node, Value};

use super::bytes::Document;
use super::rig::Tree;
use crate::curve::{Between, Curve, Keys};
use crate::error::Fault;
use crate::extras;
use crate::import::VISIBILITY;
use crate::rig::{Animation, Rig, Track};

const POINTER: &str = "KHR_animation_pointer";

/// Adds all animations of a rig, and returns their JSON; `None` for one that moves nothing.
pub(super) fn add(document: &mut Document, rig: &Rig, tree: &Tree<'_>) -> Result<Vec<Option<Value>>, Fault> {
    let of = |animation: &Animation| {
        let Animation { name, seconds, channels } = animation;
        let (mut samplers, mut listed, mut last) = (Vec::new(), Vec::new(), 0.0_f32);
        for channel in channels {
            let own = tree.node(channel.node)?;
            let moved: Vec<Index<Node>> = match &channel.track {
                // Weights are those of the nodes that carry meshes.
                Track::Weights(_) => {
                    let is_of = |morphed: &&(usize, Index<Node>)| morphed.0 == channel.node;
                    tree.morphed.iter().filter(is_of).map(|(_, node)| *node).collect()
                }
                Track::Translation(_) | Track::Rotation(_) | Track::Scale(_) | Track::Visible(_) => vec![own],
            };
            if moved.is_empty() {
                continue;
            }
            last = last.max(channel.track.times().last().copied().unwrap_or(0.0));
            let sampler = sampler(document, &channel.track)
                .map_err(|Fault(why)| Fault(format!("{why}, in animation {name:?}")))?;
            for node in moved {
                let channel = [
                    ("sampler", Value::from(samplers.len())),
                    ("target", target(document, &channel.track, node)),
                ];
                listed.push(channel.into_iter().collect::<Value>());
            }
            samplers.push(sampler);
        }
        if listed.is_empty() {
            return Ok(None);
        }
        let mut members = vec![("samplers", Value::from(samplers)), ("channels", Value::from(listed))];
        members.extend((!name.is_empty()).then(|| ("name", name.as_str().into())));
        if last != *seconds {
            members.push(("extras", extras::seconds(*seconds)?));
        }
        Ok(Some(members.into_iter().collect()))
    };
    rig.animations.iter().map(of).collect()
}

fn target(document: &mut Document, track: &Track, node: Index<Node>) -> Value {
    let path = match track {
        Track::Translation(_) => "translation",
        Track::Rotation(_) => "rotation",
        Track::Scale(_) => "scale",
        Track::Weights(_) => "weights",
        Track::Visible(_) => {
            document.declare(POINTER);
            let pointer = format!("/nodes/{node}/extensions/{VISIBILITY}/visible");
            let pointer: Value = [("pointer", pointer)].into_iter().collect();
            let extensions: Value = [(POINTER, pointer)].into_iter().collect();
            return [("path", "pointer".into()), ("extensions", extensions)].into_iter().collect();
        }
    };
    [("node", Value::from(node.value())), ("path", path.into())].into_iter().collect()
}

fn sampler(document: &mut Document, track: &Track) -> Result<Value, Fault> {
    let (output, mode) = match track {
        Track::Translation(curve) | Track::Scale(curve) => {
            floats(document, Type::Vec3, curve, |value: &Vec3, row| row.push(value.to_array()))?
        }
        Track::Rotation(curve) => {
            floats(document, Type::Vec4, curve, |value: &Quat, row| row.push(value.to_array()))?
        }
        Track::Weights(curve) => {
            let width = curve.at(f32::NEG_INFINITY).len();
            let is_even = |weights: &Vec<f32>| weights.len() == width && width > 0;
            if !values(curve.keys()).all(is_even) {
                return Err(Fault("keys of weights that are not equally many".to_owned()));
            }
            floats(document, Type::Scalar, curve, |value: &Vec<f32>, row| {
                row.extend(value.iter().map(|weight| [*weight]));
            })?
        }
        Track::Visible(curve) => {
            let bytes: Vec<u8> = values(curve.keys()).map(|visible| u8::from(*visible)).collect();
            let count = bytes.len();
            let view = document.view(bytes, None);
            (document.accessor(view, 0, count, ComponentType::U8, Type::Scalar), mode(curve.keys()))
        }
    };
    let times = track.times();
    let input = document.unbound_floats(Type::Scalar, times.iter().map(|time| [*time]));
    document.set_range(input, times[0], times[times.len() - 1]);
    let members = [
        ("input", Value::from(input.value())),
        ("output", output.value().into()),
        ("interpolation", mode.into()),
    ];
    Ok(members.into_iter().collect())
}

/// The values of keys in the order of the file.
fn values<T>(keys: &Keys<T>) -> Box<dyn Iterator<Item = &T> + '_> {
    match keys {
        Keys::Step(values) | Keys::Linear(values) => Box::new(values.iter()),
        Keys::Cubic(values) => Box::new(values.iter().flatten()),
    }
}

fn mode<T>(keys: &Keys<T>) -> &'static str {
    match keys {
        Keys::Step(_) => "STEP",
        Keys::Linear(_) => "LINEAR",
        Keys::Cubic(_) => "CUBICSPLINE",
    }
}

/// Adds the values of a curve; `add` adds the rows of one.
fn floats<T: Between, const N: usize>(
    document: &mut Document,
    kind: Type,
    curve: &Curve<T>,
    add: impl Fn(&T, &mut Vec<[f32; N]>),
) -> Result<(Index<Accessor>, &'static str), Fault> {
    let mut rows = Vec::new();
    values(curve.keys()).for_each(|value| add(value, &mut rows));
    if !rows.as_flattened().iter().all(|number| number.is_finite()) {
        return Err(Fault("keys that are not finite".to_owned()));
    }
    Ok((document.unbound_floats(kind, rows.into_iter()), mode(curve.keys())))
}
