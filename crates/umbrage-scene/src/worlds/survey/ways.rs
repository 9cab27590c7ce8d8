//! Roads and the stream: strips of long triangles draped over the land, which is levelled under them.

use glam::{Vec2, Vec3};

use super::land::{Land, STREAM_HALF_WIDTH, stations, stream, water};
use super::quarters::Quarters;
use crate::paint::Paint;
use crate::shape::Solid;

/// Stations of a strip that are one piece.
const PIECE: usize = 12;
/// How far a road's shoulders reach out and down.
const SHOULDER: [f32; 2] = [1.8, 1.4];

/// A road: the middle of it, station by station.
#[derive(Clone, Debug)]
pub(super) struct Way {
    pub line: Vec<Vec3>,
    pub half_width: f32,
}

impl Way {
    /// Builds a road along `course`, whose height is the land's, smoothed `passes` times. Levels the land under it.
    pub fn build(land: &mut Land, course: &[Vec2], half_width: f32, passes: usize) -> Self {
        let mut line: Vec<Vec3> = course.iter().map(|p| land.at(*p)).collect();
        for _ in 0..passes {
            for i in 1..line.len().saturating_sub(1) {
                line[i].z = (line[i - 1].z + 2.0 * line[i].z + line[i + 1].z) * 0.25;
            }
        }
        land.grade(&line, half_width);
        Self { line, half_width }
    }

    /// Lays the strip, with shoulders that go down into the ground.
    pub fn lay(&self, paint: Paint, quarters: &mut Quarters) {
        let [out, down] = SHOULDER;
        let half = self.half_width;
        lay(
            &self.line,
            &[(-half - out, -down), (-half, 0.0), (half, 0.0), (half + out, -down)],
            paint,
            quarters,
        );
    }

    /// Paves a place of the way's whole width, a little below the streets around it.
    pub fn spread(&self, paint: Paint, quarters: &mut Quarters) {
        let half = self.half_width;
        lay(&self.line, &[(-half, -0.08), (0.0, -0.08), (half, -0.08)], paint, quarters);
    }
}

/// Lays the water of the stream from edge to edge, level across.
pub(super) fn lay_water(quarters: &mut Quarters) {
    let line: Vec<Vec3> = stations(stream).map(|p| p.extend(water(p.x))).collect();
    let reach = STREAM_HALF_WIDTH + 6.0;
    lay(&line, &[(-reach, 0.0), (reach, 0.0)], Paint::Glass, quarters);
}

/// Sweeps a profile of (right, up), listed from left to right, along a line.
fn lay(line: &[Vec3], profile: &[(f32, f32)], paint: Paint, quarters: &mut Quarters) {
    let count = profile.len() as u32;
    for start in (0..line.len() - 1).step_by(PIECE) {
        let end = (start + PIECE).min(line.len() - 1);
        let (mut piece, from) = (Solid::default(), line[start]);
        for i in start..=end {
            let ahead = (line[(i + 1).min(line.len() - 1)] - line[i.saturating_sub(1)]).truncate();
            let right = -ahead.normalize_or(Vec2::X).perp();
            let place = |&(x, z): &(f32, f32)| line[i] - from + (right * x).extend(z);
            piece.points.extend(profile.iter().map(place));
            for k in 0..if i > start { count - 1 } else { 0 } {
                let [a, b] = [(i - start) as u32 - 1, (i - start) as u32].map(|row| row * count + k);
                piece.triangles.extend([[a, a + 1, b + 1], [a, b + 1, b]]);
            }
        }
        quarters.add(paint, piece, from);
    }
}

/// A smooth course through places (a centripetal curve would do; these turn gently enough), a station every 10 m or so.
pub(super) fn course(through: &[Vec2]) -> Vec<Vec2> {
    let at = |i: usize| through[i.min(through.len() - 1)];
    let mut line = Vec::new();
    for i in 0..through.len() - 1 {
        let [a, b, c, d] = [at(i.saturating_sub(1)), at(i), at(i + 1), at(i + 2)];
        let steps = ((c - b).length() / 10.0).ceil().max(1.0);
        line.extend((0..steps as usize).map(|step| {
            let t = step as f32 / steps;
            let (t2, t3) = (t * t, t * t * t);
            0.5 * (2.0 * b
                + (c - a) * t
                + (2.0 * a - 5.0 * b + 4.0 * c - d) * t2
                + (3.0 * b - a - 3.0 * c + d) * t3)
        }));
    }
    line.push(at(through.len() - 1));
    line
}
