//! Where shadows truly end in a picture: how long those edges are, and how far from one a pixel lies.
//!
//! An edge runs along every side shared by two judged pixels of which one is lit and one shadowed, by more than half where
//! glass lets a share of the light through. Sides are horizontal
//! or vertical, so a slanted edge has more of them than it is long: an edge with unit normal (x, y) has |x| + |y| of them
//! for each pixel of its length. The normal is estimated from the pixels around, and each side counts 1 / (|x| + |y|):
//! which is right in every direction, where counting sides and multiplying by π/4 (Cauchy-Crofton) is right only for
//! the mean of all directions.

use crate::verdict::is_shadow;
use crate::{Pixel, Truth};

/// The true shadow edges of a picture, pixel by pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct Edges {
    /// The length of edge at each pixel's right and lower side, in pixels.
    pub length_at: Vec<f32>,
    /// The distance of each pixel's centre from the nearest edge, in pixels; infinite where the picture has no edge.
    pub distance: Vec<f32>,
}

impl Edges {
    /// Finds the edges of a truth.
    pub fn new(truth: &Truth) -> Self {
        let (width, height) = (truth.eye.width as usize, truth.eye.height as usize);
        let mut length_at = vec![0.0; truth.pixels.len()];
        // Squared distances to the nearest pixel with an edge, pixels.
        let mut nearest = vec![f32::INFINITY; truth.pixels.len()];
        for y in 0..height {
            for x in 0..width {
                let here = y * width + x;
                for (dx, dy) in [(1, 0), (0, 1)] {
                    if x + dx >= width || y + dy >= height {
                        continue;
                    }
                    let there = here + dy * width + dx;
                    if is_edge(truth.pixels[here], truth.pixels[there]) {
                        length_at[here] += side_length(truth, x, y, (dx, dy));
                        nearest[here] = 0.0;
                        nearest[there] = 0.0;
                    }
                }
            }
        }
        let squared = distance_transform(nearest, width, height);
        // A pixel at an edge has its centre half a pixel from it.
        let distance = squared.into_iter().map(|d| d.sqrt() + 0.5).collect();
        Self { length_at, distance }
    }

    /// Returns the length of all edges of the picture, in pixels.
    pub fn length(&self) -> f64 {
        self.length_at.iter().map(|length| f64::from(*length)).sum()
    }
}

fn is_edge(a: Pixel, b: Pixel) -> bool {
    match (a.visibility(), b.visibility()) {
        (Some(a), Some(b)) => is_shadow(a) != is_shadow(b),
        (Some(_) | None, None) | (None, Some(_)) => false,
    }
}

/// How much edge one side stands for.
fn side_length(truth: &Truth, x: usize, y: usize, (dx, dy): (usize, usize)) -> f32 {
    /// Pixels around the side that its direction is estimated from, each way.
    const REACH: i64 = 4;
    let (width, height) = (i64::from(truth.eye.width), i64::from(truth.eye.height));
    let (centre_x, centre_y) = (x as f32 + 0.5 * dx as f32, y as f32 + 0.5 * dy as f32);
    let (mut sum, mut weights, mut moment) = (0.0, 0.0, glam::Vec2::ZERO);
    let mut mean_offset = glam::Vec2::ZERO;
    for j in (y as i64 - REACH).max(0)..=(y as i64 + REACH + dy as i64).min(height - 1) {
        for i in (x as i64 - REACH).max(0)..=(x as i64 + REACH + dx as i64).min(width - 1) {
            let Some(lit) = truth.pixels[(j * width + i) as usize].visibility() else {
                continue;
            };
            let offset = glam::Vec2::new(i as f32 - centre_x, j as f32 - centre_y);
            let weight = (-offset.length_squared() / 6.0).exp();
            sum += weight * lit;
            weights += weight;
            moment += offset * (weight * lit);
            mean_offset += offset * weight;
        }
    }
    // The slope of visibility, up to a factor: its covariance with position.
    let normal =
        (moment - mean_offset * (sum / weights)).abs().normalize_or(glam::Vec2::new(dx as f32, dy as f32));
    1.0 / (normal.x + normal.y)
}

/// Squared Euclidean distance of every entry to the nearest entry that is 0; other entries are ∞ (Felzenszwalb and
/// Huttenlocher, *Distance Transforms of Sampled Functions*, 2012).
fn distance_transform(mut squares: Vec<f32>, width: usize, height: usize) -> Vec<f32> {
    let mut line = Vec::new();
    for x in 0..width {
        line.clear();
        line.extend((0..height).map(|y| squares[y * width + x]));
        for (y, value) in lower_envelope(&line).into_iter().enumerate() {
            squares[y * width + x] = value;
        }
    }
    for row in squares.chunks_mut(width.max(1)) {
        let transformed = lower_envelope(row);
        row.copy_from_slice(&transformed);
    }
    squares
}

/// For every place p: the minimum of (p − q)² + values[q] over all q.
fn lower_envelope(values: &[f32]) -> Vec<f32> {
    // Parabolas of the envelope, and from where on each is the lowest.
    let mut parabolas: Vec<(usize, f64)> = Vec::new();
    for (q, value) in values.iter().enumerate().filter(|(_, value)| value.is_finite()) {
        let mut from = f64::NEG_INFINITY;
        while let Some(&(p, p_from)) = parabolas.last() {
            let height = |q: usize, value: f32| f64::from(value) + (q * q) as f64;
            from = (height(q, *value) - height(p, values[p])) / (2.0 * (q - p) as f64);
            if from > p_from {
                break;
            }
            parabolas.pop();
            from = f64::NEG_INFINITY;
        }
        parabolas.push((q, from));
    }
    let mut current = 0;
    (0..values.len())
        .map(|p| {
            while parabolas.get(current + 1).is_some_and(|(_, from)| *from <= p as f64) {
                current += 1;
            }
            parabolas.get(current).map_or(f32::INFINITY, |(q, _)| p.abs_diff(*q).pow(2) as f32 + values[*q])
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use umbrage_scene::Camera;

    use super::*;
    use crate::{Eye, Light};

    /// A truth made up from a rule.
    fn truth(width: u32, height: u32, is_lit: impl Fn(f64, f64) -> bool) -> Truth {
        let camera = Camera::looking("c", glam::Vec3::ZERO, glam::Vec3::NEG_Z, 1.0, 0.1, 10.0);
        let pixels = (0..width * height)
            .map(|i| is_lit(f64::from(i % width) + 0.5, f64::from(i / width) + 0.5))
            .map(|lit| if lit { Pixel::Lit } else { Pixel::Shadowed })
            .collect();
        let receivers = vec![None; (width * height) as usize];
        Truth {
            eye: Eye::new(&camera, width, height),
            light: Light::sun(glam::Vec3::NEG_Y),
            receivers,
            pixels,
        }
    }

    #[test]
    fn a_straight_edge_is_as_long_as_it_is_in_every_direction() {
        for degrees in (0..180).step_by(5) {
            let (sine, cosine) = f64::from(degrees).to_radians().sin_cos();
            // Half a disc, its edge through the middle: a chord of known length, inside a disc that nothing else cuts.
            let side = |x: f64, y: f64| (x - 100.3) * cosine + (y - 99.6) * sine > 0.0;
            let mut truth = truth(200, 200, side);
            for (i, pixel) in truth.pixels.iter_mut().enumerate() {
                let (x, y) = ((i % 200) as f64 + 0.5 - 100.3, (i / 200) as f64 + 0.5 - 99.6);
                if x * x + y * y > 90.0 * 90.0 {
                    *pixel = Pixel::Sky;
                }
            }
            let length = Edges::new(&truth).length();
            assert!((length / 180.0 - 1.0).abs() < 0.015, "{degrees}°: {length}, not 180");
        }
    }

    #[test]
    fn a_circle_is_as_long_as_it_is() {
        for radius in [10.0, 30.0, 80.0] {
            let edges = Edges::new(&truth(200, 200, |x, y| (x - 100.2).hypot(y - 99.7) > radius));
            let ratio = edges.length() / (std::f64::consts::TAU * radius);
            assert!((ratio - 1.0).abs() < 0.03, "radius {radius}: {ratio} times its length");
        }
    }

    #[test]
    fn nothing_but_lit_has_no_edge() {
        let edges = Edges::new(&truth(8, 8, |_, _| true));
        assert!(edges.length() == 0.0 && edges.distance.iter().all(|d| *d == f32::INFINITY), "{edges:?}");
    }

    proptest! {
        #[test]
        fn distances_are_those_of_a_search(seeds in prop::collection::vec(any::<bool>(), 12 * 9), rare in any::<bool>()) {
            let zero = |(i, seed): (usize, &bool)| if *seed && (!rare || i % 7 == 0) { 0.0 } else { f32::INFINITY };
            let squares: Vec<f32> = seeds.iter().enumerate().map(zero).collect();
            let got = distance_transform(squares.clone(), 12, 9);
            for (i, got) in got.into_iter().enumerate() {
                let to = |j: usize| ((i % 12).abs_diff(j % 12).pow(2) + (i / 12).abs_diff(j / 12).pow(2)) as f32;
                let nearest = (0..squares.len()).filter(|j| squares[*j] == 0.0).map(to).fold(f32::INFINITY, f32::min);
                prop_assert_eq!(got, nearest);
            }
        }
    }
}
