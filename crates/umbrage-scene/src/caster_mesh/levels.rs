//! Coarser and coarser levels of a welded mesh, until nothing is gained.
//!
//! Each is made of the one before, so that all of them take little more than twice as long as the first. Vertices are kept
//! where they are or dropped. The simplifier's own error is a mean over areas, beyond which single vertices may stick out
//! far; these are kept, and their neighbourhood is simplified once more.

use meshoptimizer::{SIMPLIFY_ERROR_ABSOLUTE, SIMPLIFY_VERTEX_LOCK, simplify_with_attributes};

use super::deviation::{beyond, deviation};
use super::welded::Welded;
use super::{CasterMesh, Coarser, Piece, place};
use crate::{Aabb, Part};

/// The simplifier's error of each level is at least so many times that of the one before; else it is what halves the triangles.
const STEP: f32 = 1.25;
/// A level that keeps more than this share of the one before is not worth its memory. The next is tried so many times farther
/// off, and so often in all.
const LEAST_GAIN: f32 = 0.75;
const LEAP: f32 = 2.0;
const LEAPS: usize = 3;
/// The simplifier's error of the first level is this share of what halves the triangles, and at least this share of the mesh's
/// size.
const FIRST: f32 = 0.5;
const SMALLEST_ERROR: f32 = 1e-5;
/// A level whose error is more than this share of the mesh's size shows nothing of it any more.
const LARGEST_ERROR: f32 = 0.25;
/// A vertex that lies farther from a level than so many times the simplifier's error sticks out.
const STICKS_OUT: f32 = 2.0;
/// A patch is simplified so often at most: what sticks out grows fewer each time.
const TURNS: usize = 8;
/// The triangles of a patch, whose border stays: so many that borders are few, and so few that simplifying one again is quick.
const PATCH: usize = 1 << 14;
/// Where patches are cut, level by level in turn, so that no border stays for good.
const CUTS: [f32; 2] = [0.5, 0.4];
/// Levels are measured against the one so many before them, whose own error is added.
const BEFORE: usize = 3;

/// The coarser levels, finest first.
pub(super) fn coarser(welded: &Welded) -> Vec<Coarser> {
    let mut levels: Vec<Coarser> = Vec::new();
    let mut now: Vec<[u32; 3]> = welded.pieces.iter().flat_map(|piece| &piece.triangles).copied().collect();
    // The vertices that each level keeps, from the full geometry on.
    let mut kept: Vec<Vec<[f32; 3]>> = vec![welded.positions.clone()];
    let size = welded.size();
    if now.len() < CasterMesh::MIN_TRIANGLES || !size.is_finite() {
        return levels;
    }
    let mut aim = (FIRST * halving_error(welded, &now)).max(SMALLEST_ERROR * size);
    let mut leaps = 0;
    while now.len() >= CasterMesh::MIN_TRIANGLES && aim <= LARGEST_ERROR * size {
        let number = levels.len();
        let next = simplified(welded, &now, CUTS[number % CUTS.len()], aim);
        if next.len() as f32 > LEAST_GAIN * now.len() as f32 {
            leaps += 1;
            aim *= LEAP;
            if leaps > LEAPS {
                break;
            }
            continue;
        }
        let from = (number + 1).saturating_sub(BEFORE);
        let before = from.checked_sub(1).map_or(0.0, |level| levels[level].error);
        let known = levels.last().map_or(0.0, |level| level.error).max(aim) - before;
        let farthest = (!next.is_empty()).then(|| deviation(&kept[from], &welded.positions, &next, known));
        let Some(error) = farthest.flatten().map(|farthest| before + farthest) else { break };
        if error > LARGEST_ERROR * size {
            break;
        }
        now = next;
        kept.push(vertices(welded, &now));
        let cut = cut(&welded.positions, now.clone(), Part::MAX_TRIANGLES, 0.5);
        let pieces = cut.into_iter().map(|triangles| Piece::of(&welded.positions, triangles)).collect();
        levels.push(Coarser { error, pieces });
        aim = (STEP * aim).max(halving_error(welded, &now));
    }
    levels
}

/// The simplifier's error where half of the triangles go, in the mean: of the patches in the middle and at the ends.
fn halving_error(welded: &Welded, triangles: &[[u32; 3]]) -> f32 {
    let patches = cut(&welded.positions, triangles.to_vec(), PATCH, CUTS[0]);
    let locks = vec![0; welded.positions.len()];
    let some = [0, patches.len() / 2, patches.len() - 1];
    let errors = some.map(|number| {
        let local = Local::of(welded, &locks, &patches[number]);
        local.once(&local.locks, f32::MAX, local.triangles.len() / 2).map_or(0.0, |(_, moved)| moved)
    });
    errors.iter().sum::<f32>() / some.len() as f32
}

/// The places of the vertices of triangles.
fn vertices(welded: &Welded, triangles: &[[u32; 3]]) -> Vec<[f32; 3]> {
    let mut is_kept = vec![false; welded.positions.len()];
    triangles.as_flattened().iter().for_each(|vertex| is_kept[*vertex as usize] = true);
    welded.positions.iter().zip(is_kept).filter(|(_, is_kept)| *is_kept).map(|(place, _)| *place).collect()
}

/// As few of these triangles as the simplifier can do with without moving them farther than it may.
fn simplified(welded: &Welded, triangles: &[[u32; 3]], at: f32, may_move: f32) -> Vec<[u32; 3]> {
    let patches = cut(&welded.positions, triangles.to_vec(), PATCH, at);
    let mut locks: Vec<u8> =
        welded.shared.iter().map(|shared| if *shared { SIMPLIFY_VERTEX_LOCK } else { 0 }).collect();
    let mut patch_of = vec![u32::MAX; welded.positions.len()];
    for (patch, number) in patches.iter().zip(0..) {
        for &vertex in patch.as_flattened() {
            let of = &mut patch_of[vertex as usize];
            if *of != u32::MAX && *of != number {
                locks[vertex as usize] = SIMPLIFY_VERTEX_LOCK;
            }
            *of = number;
        }
    }
    let of_patch = |patch: &Vec<[u32; 3]>| {
        let local = Local::of(welded, &locks, patch);
        let mut left = local.simplified(may_move);
        left.iter_mut().flatten().for_each(|vertex| *vertex = local.numbers[*vertex as usize]);
        left
    };
    patches.iter().flat_map(of_patch).collect()
}

/// A patch with vertices of its own.
struct Local {
    /// The mesh's numbers of its vertices.
    numbers: Vec<u32>,
    positions: Vec<[f32; 3]>,
    locks: Vec<u8>,
    triangles: Vec<[u32; 3]>,
}

impl Local {
    fn of(welded: &Welded, locks: &[u8], patch: &[[u32; 3]]) -> Self {
        let mut numbers = patch.as_flattened().to_vec();
        numbers.sort_unstable();
        numbers.dedup();
        let local = |vertex: u32| numbers.binary_search(&vertex).unwrap_or_default() as u32;
        Self {
            positions: numbers.iter().map(|vertex| welded.positions[*vertex as usize]).collect(),
            locks: numbers.iter().map(|vertex| locks[*vertex as usize]).collect(),
            triangles: patch.iter().map(|triangle| triangle.map(local)).collect(),
            numbers,
        }
    }

    /// Fewer triangles, from which no vertex sticks out as far as that can be had; or all, where the simplifier refuses them.
    fn simplified(&self, may_move: f32) -> Vec<[u32; 3]> {
        let mut locks = self.locks.clone();
        let mut best = self.triangles.clone();
        for turn in 1..=TURNS {
            let Some((left, _)) = self.once(&locks, may_move, 0) else { break };
            best = left;
            let measured = (turn < TURNS).then(|| beyond(&self.positions, &best, STICKS_OUT * may_move));
            let Some(sticking_out) = measured.flatten().filter(|vertices| !vertices.is_empty()) else {
                break;
            };
            sticking_out.into_iter().for_each(|vertex| locks[vertex] = SIMPLIFY_VERTEX_LOCK);
        }
        best
    }

    /// What the simplifier leaves, and its error.
    fn once(&self, locks: &[u8], may_move: f32, at_least: usize) -> Option<(Vec<[u32; 3]>, f32)> {
        let mut left = self.triangles.clone();
        let mut moved = 0.0;
        let count = simplify_with_attributes(
            left.as_flattened_mut(),
            self.triangles.as_flattened(),
            3 * self.triangles.len(),
            self.positions.as_flattened(),
            self.positions.len(),
            12,
            &[],
            0,
            &[],
            0,
            Some(locks),
            3 * at_least,
            may_move,
            SIMPLIFY_ERROR_ABSOLUTE,
            Some(&mut moved),
        );
        left.truncate(count.ok()? / 3);
        moved.is_finite().then_some((left, moved))
    }
}

/// Cuts triangles into pieces of at most so many, at a share of the longest side's centroids.
fn cut(positions: &[[f32; 3]], triangles: Vec<[u32; 3]>, most: usize, at: f32) -> Vec<Vec<[u32; 3]>> {
    let centre = |t: &[u32; 3]| t.iter().map(|vertex| place(positions, *vertex)).sum::<glam::Vec3>();
    let mut done = Vec::new();
    let mut left = vec![triangles];
    while let Some(mut triangles) = left.pop() {
        if triangles.len() <= most {
            done.push(triangles);
            continue;
        }
        let axis = Aabb::of_points(triangles.iter().map(centre)).size().max_position();
        let middle = (triangles.len() as f32 * at) as usize;
        triangles.select_nth_unstable_by(middle, |a, b| {
            centre(a)[axis].total_cmp(&centre(b)[axis]).then(a.cmp(b))
        });
        left.push(triangles.split_off(middle));
        left.push(triangles);
    }
    done
}
