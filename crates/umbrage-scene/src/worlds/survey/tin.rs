//! The land as a triangulated irregular network: few large triangles where it is even, many where it is not or where
//! something is built.
//!
//! Right triangles are halved where leaving out a corner would be wrong by more than a tolerance (Evans, Kirkpatrick and
//! Townsend, *Right-Triangulated Irregular Networks*, Algorithmica 30, 2001); then each corner is moved to where a surveyor
//! may have set up the pole, by less than what would turn a triangle over.
//!
//! Columns and rows count the grid's corners from the south-west.

use std::collections::BTreeMap;

use glam::{Vec2, Vec3};

use super::land::{CELL, CELLS, Land, SIDE, corner};
use super::quarters::{self, ACROSS};
use crate::Primitive;
use crate::dice::Dice;

/// A corner moves by at most this share of the shortest leg at it, to each side. Apex and base of a right triangle
/// may come closer by 2 · √2 · 0.2 of the leg, and are 0.7 apart.
const STRAY: f32 = 0.2;
/// Cells along a quarter.
const QUARTER: usize = CELLS / ACROSS;

type Place = [usize; 2];

/// Triangles of grid corners, counter-clockwise from above.
struct Net<'a> {
    errors: &'a [f32],
    triangles: Vec<[Place; 3]>,
}

/// The land's triangles, one primitive a quarter; vertices are from the quarter's middle, and texture coordinates over the
/// whole land. `tolerance` is how wrong heights may be at a place, metres.
pub(super) fn primitives(land: &Land, dice: &mut Dice, tolerance: impl Fn(Vec2) -> f32) -> Vec<Primitive> {
    let errors = errors(land, tolerance);
    let mut net = Net { errors: &errors, triangles: Vec::new() };
    net.halve([0, 0], [CELLS, CELLS], [CELLS, 0]);
    net.halve([CELLS, CELLS], [0, 0], [0, CELLS]);
    let points = measured(land, dice, &net.triangles);
    let normals = normals(&points, &net.triangles);
    let mut quarters = vec![Primitive::default(); ACROSS * ACROSS];
    let mut numbers = vec![BTreeMap::<usize, u32>::new(); ACROSS * ACROSS];
    for triangle in &net.triangles {
        let [east, north] =
            [0, 1].map(|axis| triangle.iter().map(|p| p[axis]).sum::<usize>() / (3 * QUARTER));
        let quarter = north * ACROSS + east;
        let Primitive {
            positions,
            normals: normals_here,
            uvs,
            indices,
            material: _,
            colours: _,
            influences: _,
            targets: _,
        } = &mut quarters[quarter];
        for place in triangle {
            let key = index(*place);
            let number = *numbers[quarter].entry(key).or_insert_with(|| {
                let point = points[&key];
                positions.push(point - quarters::middle(quarter));
                normals_here.push(normals[&key].normalize_or(Vec3::Z));
                uvs.push(Vec2::new(point.x / SIDE + 0.5, 0.5 - point.y / SIDE));
                positions.len() as u32 - 1
            });
            indices.push(number);
        }
    }
    quarters
}

impl Net<'_> {
    /// Halves the triangle with the right angle at `apex` while the middle of its longest side is needed.
    fn halve(&mut self, a: Place, b: Place, apex: Place) {
        let middle = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
        let longest = a[0].abs_diff(b[0]).max(a[1].abs_diff(b[1]));
        if longest > QUARTER || longest > 1 && self.errors[index(middle)] > 1.0 {
            self.halve(apex, a, middle);
            self.halve(b, apex, middle);
        } else {
            self.triangles.push([a, apex, b]);
        }
    }
}

fn index([column, row]: Place) -> usize {
    row * (CELLS + 1) + column
}

/// For each corner, how wrong the land would be without it and all that depend on it, in tolerances.
///
/// A corner is the middle of a side of squares, or of a square. Halving a triangle at the middle of a square needs those of
/// the square's sides, and halving one at the middle of a side needs those of the squares of half the size beside it.
fn errors(land: &Land, tolerance: impl Fn(Vec2) -> f32) -> Vec<f32> {
    let mut errors = vec![0.0_f32; (CELLS + 1) * (CELLS + 1)];
    let own = |middle: Place, a: Place, b: Place| {
        let between = (land.height_of(index(a)) + land.height_of(index(b))) * 0.5;
        let wrong = (land.height_of(index(middle)) - between).abs() / tolerance(corner(middle[0], middle[1]));
        if land.is_kept(index(middle)) { f32::INFINITY } else { wrong }
    };
    let mut step = 1;
    while step < CELLS {
        for (middle, a, b) in sides(step) {
            let diagonal = [(1, 1), (1, -1), (-1, 1), (-1, -1)];
            let worst = worst_beside(&errors, middle, step / 2, diagonal);
            errors[index(middle)] = own(middle, a, b).max(worst);
        }
        for (middle, a, b) in squares(step) {
            let worst = worst_beside(&errors, middle, step, [(1, 0), (-1, 0), (0, 1), (0, -1)]);
            errors[index(middle)] = own(middle, a, b).max(worst);
        }
        step *= 2;
    }
    errors
}

/// The largest error at `step` from a place in four directions; 0 for no step.
fn worst_beside(errors: &[f32], [column, row]: Place, step: usize, directions: [(isize, isize); 4]) -> f32 {
    let along = |v: usize, by: isize| v.checked_add_signed(by * step as isize).filter(|v| *v <= CELLS);
    let error = |(east, north)| Some(errors[index([along(column, east)?, along(row, north)?])]);
    if step == 0 { 0.0 } else { directions.into_iter().filter_map(error).fold(0.0, f32::max) }
}

/// The middles of all sides of squares of two steps, with the ends of the side.
fn sides(step: usize) -> impl Iterator<Item = (Place, Place, Place)> {
    let level = move |row: usize| (row / step).is_multiple_of(2);
    let columns = move |row: usize| (if level(row) { step } else { 0 }..=CELLS).step_by(2 * step);
    let places = (0..=CELLS).step_by(step).flat_map(move |row| columns(row).map(move |column| [column, row]));
    places.map(move |[column, row]| {
        let [east, north] = if level(row) { [step, 0] } else { [0, step] };
        ([column, row], [column - east, row - north], [column + east, row + north])
    })
}

/// The middles of all squares of two steps, with the ends of the diagonal that triangles have: it goes through that corner
/// which is itself the middle of a larger square.
fn squares(step: usize) -> impl Iterator<Item = (Place, Place, Place)> {
    let middles = move || (step..CELLS).step_by(2 * step);
    let odd = move |v: usize| if (v - step) / step % 4 == 2 { v - step } else { v + step };
    middles().flat_map(move |row| middles().map(move |column| [column, row])).map(move |[column, row]| {
        let end = [odd(column), odd(row)];
        ([column, row], end, [2 * column - end[0], 2 * row - end[1]])
    })
}

/// Where each corner that triangles have was measured.
fn measured(land: &Land, dice: &mut Dice, triangles: &[[Place; 3]]) -> BTreeMap<usize, Vec3> {
    let mut shortest: BTreeMap<usize, usize> = BTreeMap::new();
    for [a, apex, b] in triangles {
        let leg = apex[0].abs_diff(a[0]).max(apex[1].abs_diff(a[1]));
        for place in [a, apex, b] {
            shortest.entry(index(*place)).and_modify(|s| *s = leg.min(*s)).or_insert(leg);
        }
    }
    let strayed = |(index, leg): (usize, usize)| {
        let (column, row) = (index % (CELLS + 1), index / (CELLS + 1));
        let stray = STRAY * leg as f32 * CELL;
        let moved = Vec2::new(dice.between(-stray, stray), dice.between(-stray, stray));
        // The borders of quarters stay straight.
        let inside = [column, row].map(|v| f32::from(u8::from(!v.is_multiple_of(QUARTER))));
        let place =
            quarters::to_the_centimetre((corner(column, row) + moved * inside[0] * inside[1]).extend(0.0));
        (index, quarters::to_the_centimetre(land.at(place.truncate())))
    };
    shortest.into_iter().map(strayed).collect()
}

/// The sums of the normals around each corner, weighted by area.
fn normals(points: &BTreeMap<usize, Vec3>, triangles: &[[Place; 3]]) -> BTreeMap<usize, Vec3> {
    let mut sums: BTreeMap<usize, Vec3> = BTreeMap::new();
    for triangle in triangles {
        let keys = triangle.map(index);
        let [a, b, c] = keys.map(|key| points[&key]);
        keys.iter().for_each(|key| *sums.entry(*key).or_default() += (b - a).cross(c - a));
    }
    sums
}
