//! Samplers to tracks: the times of keys, their values, and what lies between them, checked.
//!
//! Source: glTF 2.0, section 3.11, *Animations*, and appendix C, *Animation Sampler Interpolation Modes*.

use glam::{Quat, Vec3};
use gltf::json::{Accessor, Index, Value};

use super::accessors::Data;
use super::targets::Property;
use crate::curve::{Between, Curve, Keys};
use crate::error::Fault;
use crate::import::budget::Budget;
use crate::import::settle::FARTHEST;
use crate::rig::Track;

/// A rotation shorter than this has no direction.
const MIN_QUATERNION: f32 = 1e-6;

/// How far from unit length a rotation may be that f32 has rounded.
const UNIT_TOLERANCE: f32 = 1e-6;

/// What lies between two keys.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Mode {
    Step,
    Linear,
    Cubic,
}

/// A sampler's accessors and mode.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sampler {
    input: Index<Accessor>,
    output: Index<Accessor>,
    mode: Mode,
}

impl Sampler {
    /// Reads one of an animation's samplers.
    pub fn of(samplers: Option<&Value>, index: Option<&Value>) -> Result<Self, Fault> {
        let place = index.and_then(Value::as_u64).and_then(|index| usize::try_from(index).ok());
        let Some(sampler) = place.and_then(|place| samplers?.get(place)) else {
            return Err(Fault("its sampler is not there".to_owned()));
        };
        let accessor = |name: &str| {
            let index = sampler.get(name).and_then(Value::as_u64).and_then(|i| u32::try_from(i).ok());
            index.map(Index::new).ok_or_else(|| Fault(format!("its sampler has no {name}")))
        };
        let mode = match sampler.get("interpolation").map(|mode| mode.as_str().unwrap_or_default()) {
            None | Some("LINEAR") => Mode::Linear,
            Some("STEP") => Mode::Step,
            Some("CUBICSPLINE") => Mode::Cubic,
            Some(mode) => {
                return Err(Fault(format!(
                    "its interpolation is {mode:?}, need STEP, LINEAR or CUBICSPLINE"
                )));
            }
        };
        Ok(Self { input: accessor("input")?, output: accessor("output")?, mode })
    }
}

/// Reads how a property moves; `targets` is how many morph targets its node's mesh has.
pub(super) fn read(
    data: &Data<'_>,
    sampler: Sampler,
    property: Property,
    targets: usize,
    budget: &mut Budget,
) -> Result<Track, Fault> {
    if property == Property::Weights && targets == 0 {
        return Err(Fault("its node has no morph targets".to_owned()));
    }
    let width = match property {
        Property::Translation | Property::Scale => 3,
        Property::Rotation => 4,
        Property::Weights | Property::Visible => 1,
    };
    budget.keys(data.said(sampler.input).saturating_add(data.said(sampler.output).saturating_mul(width)))?;
    let times = times(data, sampler.input)?;
    match property {
        Property::Translation => vectors(data, sampler, times).map(Track::Translation),
        Property::Scale => vectors(data, sampler, times).map(Track::Scale),
        Property::Rotation => rotations(data, sampler, times).map(Track::Rotation),
        Property::Weights => weights(data, sampler, times, targets).map(Track::Weights),
        Property::Visible => visible(data, sampler, times).map(Track::Visible),
    }
}

/// The times of the keys, which only grow: those that are equal follow each other at once.
fn times(data: &Data<'_>, input: Index<Accessor>) -> Result<Vec<f32>, Fault> {
    let read: Vec<f32> = data.vectors::<1>(input)?.into_iter().map(|[time]| time).collect();
    let mut times: Vec<f32> = Vec::with_capacity(read.len());
    for (key, time) in read.iter().enumerate() {
        if !time.is_finite() {
            return Err(Fault(format!("the time of key {key} is {time} s, need finite times")));
        }
        let before = key.checked_sub(1).map(|before| read[before]);
        if let Some(before) = before.filter(|before| time < before) {
            return Err(Fault(format!("times go back at key {key}, from {before} s to {time} s")));
        }
        let earliest = times.last().map_or(f32::NEG_INFINITY, |last| last.next_up());
        times.push(time.max(earliest));
    }
    Ok(times)
}

fn vectors(data: &Data<'_>, sampler: Sampler, times: Vec<f32>) -> Result<Curve<Vec3>, Fault> {
    let rows: Vec<Vec3> = data.vectors::<3>(sampler.output)?.into_iter().map(Vec3::from).collect();
    if let Some(key) = rows.iter().position(|row| !row.abs().cmple(Vec3::splat(FARTHEST as f32)).all()) {
        return Err(Fault(format!("its values reach {}, need at most {FARTHEST:e}", rows[key])));
    }
    curve(times, sampler.mode, rows)
}

fn rotations(data: &Data<'_>, sampler: Sampler, times: Vec<f32>) -> Result<Curve<Quat>, Fault> {
    let mut rows: Vec<Quat> = data.vectors::<4>(sampler.output)?.into_iter().map(Quat::from_array).collect();
    for (i, row) in rows.iter_mut().enumerate() {
        if !row.is_finite() {
            return Err(Fault(format!("value {i} is {row}, need finite numbers")));
        }
        if sampler.mode == Mode::Cubic && i % 3 != 1 {
            // A tangent.
            continue;
        }
        if row.length() < MIN_QUATERNION {
            return Err(Fault(format!("rotation {i} is {row}, need unit quaternions")));
        }
        if (row.length() - 1.0).abs() > UNIT_TOLERANCE {
            *row = row.normalize();
        }
    }
    curve(times, sampler.mode, rows)
}

fn weights(
    data: &Data<'_>,
    sampler: Sampler,
    times: Vec<f32>,
    targets: usize,
) -> Result<Curve<Vec<f32>>, Fault> {
    let rows: Vec<f32> = data.vectors::<1>(sampler.output)?.into_iter().map(|[weight]| weight).collect();
    let is_usable = |weight: &&f32| weight.abs() <= FARTHEST as f32;
    if let Some(weight) = rows.iter().find(|weight| !is_usable(weight)) {
        return Err(Fault(format!("a weight is {weight}, need at most {FARTHEST:e}")));
    }
    if !rows.len().is_multiple_of(targets) {
        return Err(Fault(format!("{} weights for {targets} morph targets", rows.len())));
    }
    curve(times, sampler.mode, rows.chunks(targets).map(<[f32]>::to_vec).collect())
}

/// Whatever the file says, there is nothing between seen and hidden.
fn visible(data: &Data<'_>, sampler: Sampler, times: Vec<f32>) -> Result<Curve<bool>, Fault> {
    let rows = data.vectors::<1>(sampler.output)?.into_iter().map(|[visible]| visible != 0.0).collect();
    curve(times, Mode::Step, rows)
}

fn curve<T: Between>(times: Vec<f32>, mode: Mode, rows: Vec<T>) -> Result<Curve<T>, Fault> {
    let need = if mode == Mode::Cubic { 3 * times.len() } else { times.len() };
    if times.is_empty() || rows.len() != need {
        return Err(Fault(format!("{} times and {} values, need {need}", times.len(), rows.len())));
    }
    let keys = match mode {
        Mode::Step => Keys::Step(rows),
        Mode::Linear => Keys::Linear(rows),
        Mode::Cubic => {
            let mut rows = rows.into_iter();
            let key = || Some([rows.next()?, rows.next()?, rows.next()?]);
            Keys::Cubic(std::iter::from_fn(key).collect())
        }
    };
    Curve::new(times, keys).ok_or_else(|| Fault("its keys make no curve".to_owned()))
}
