//! A shadow map of a light from straight above must have some error, or take so many texels to have none.
//!
//! Source: the terms m_s and m_t and the storage factor are those of Lloyd et al., *Warping and Partitioning for Low
//! Error Shadow Maps*, EGSR 2006. The closed forms, and those of parallel splits (which Zhang et al. 2006 leave for
//! later), are derived. n is `depths.start`, f `depths.end`, n' `warp_near`, z `at`.
//!
//! The camera looks horizontally, θ is half its field of view, and the map lies flat over depths n to f of the frustum.
//! It is warped by a perspective along the view whose near plane is n' before the start: t = f'/(f' − n') · (1 − n'/z')
//! with z' = z − n + n' and f' = f − n + n'. n' = ∞ is a uniform map, n' = n a perspective shadow map.
//!
//! Space: view depth, metres.

use std::ops::Range;

/// The extent of a texel in pixels, without the receiver's tilt, where the map has as many texels a side as the picture
/// has pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PerspectiveError {
    /// The extent across the view: m_s.
    pub across: f64,
    /// The extent along the view: m_t times 2 tan θ.
    pub along: f64,
}

impl PerspectiveError {
    /// Returns how many times the picture's pixels a map needs as texels, so that neither of these errors is more than 1; times
    /// 2 tan θ.
    pub fn storage_factor(self) -> f64 {
        self.across * self.along
    }
}

/// Returns the error at view depth `at` of one map over `depths`: m_s = (z'/f') (f/z), m_t · 2 tan θ = (f − n) z'² / (n' f' z).
///
/// It holds for 0 < n < f, and `warp_near` is at least n: infinity is a uniform map. With less, the near end would be the wider one.
pub fn perspective_error(depths: Range<f64>, warp_near: f64, at: f64) -> PerspectiveError {
    let Range { start: near, end: far } = depths;
    // z'/n' and f'/n', which stay finite for a uniform map.
    let stretch = 1.0 + (at - near) / warp_near;
    let whole = 1.0 + (far - near) / warp_near;
    PerspectiveError {
        across: stretch / whole * far / at,
        along: (far - near) * stretch * stretch / (whole * at),
    }
}

/// Returns the largest error across and the largest along, over all `depths`; at its ends, for both are convex over depth.
pub fn largest_perspective_error(depths: Range<f64>, warp_near: f64) -> PerspectiveError {
    let first = perspective_error(depths.clone(), warp_near, depths.start);
    let last = perspective_error(depths.clone(), warp_near, depths.end);
    PerspectiveError { across: first.across.max(last.across), along: first.along.max(last.along) }
}

/// Returns the n' whose errors along the view are the same at both ends, and the least: n + √(n f), that of LiSPSM
/// (Wimmer et al. 2004), metres.
pub fn balanced_warp_near(depths: Range<f64>) -> f64 {
    depths.start + (depths.start * depths.end).sqrt()
}

/// Returns how many times the picture's pixels the maps over C_0 … C_m need as texels, so that no error is more than 1; times
/// 2 tan θ. The maps have equally many texels, so that the worst part decides: m times the largest r (r − 1), with
/// r = C_{i+1} / C_i.
///
/// `warped` maps need the largest r − 1, for any n' from n to [`balanced_warp_near`]. `splits` rise from more than zero;
/// without a part there is nothing to store.
pub fn storage_factor(splits: &[f64], warped: bool) -> f64 {
    let of_part = |part: &[f64]| {
        let warp_near = if warped { part[0] } else { f64::INFINITY };
        largest_perspective_error(part[0]..part[1], warp_near).storage_factor()
    };
    let parts = splits.windows(2);
    parts.len() as f64 * parts.map(of_part).fold(0.0, f64::max)
}

/// Returns the least that any map can do, and what [`storage_factor`] comes to with ever more logarithmic splits: ln(f / n),
/// times 2 tan θ as there. Reached by texels whose size grows in proportion to depth.
pub fn ideal_storage_factor(depths: Range<f64>) -> f64 {
    (depths.end / depths.start).ln()
}

#[cfg(test)]
mod tests {
    use glam::{DMat4, DVec3, DVec4, Vec3};

    use super::*;
    use crate::aliasing::{perspective_texel_extent, texel_extent};
    use crate::{Camera, Projection, Settings, split_distances};

    /// 2 tan 30°, of V3.
    fn field() -> f64 {
        2.0 / 3.0f64.sqrt()
    }

    /// `got` rounds to `wanted`, which has `decimals`; give or take f32 splits.
    fn is_printed(got: f64, wanted: f64, decimals: i32) -> bool {
        (got - wanted).abs() <= 0.501 * 10.0f64.powi(-decimals) + 1e-6 * wanted
    }

    #[test]
    fn errors_of_one_map_are_those_of_v3() {
        // n, f; then by warp: max m_s, max m_t, S, m_t at near and at far; then the ideal m_t.
        // The warps are PSM, halfway from there to LiSPSM, LiSPSM, twice that, and all but uniform.
        type Row = [f64; 5];
        let tables: [(Range<f64>, [Row; 5], f64); 4] = [
            (
                1.0..100.0,
                [
                    [1.0000, 85.7365, 85.7365, 0.8574, 85.7365],
                    [5.7143, 15.0039, 85.7365, 4.8992, 15.0039],
                    [10.0000, 8.5737, 85.7365, 8.5737, 8.5737],
                    [18.1818, 15.5885, 283.4265, 15.5885, 4.7155],
                    [100.0000, 85.7365, 8573.6498, 85.7365, 0.8574],
                ],
                3.9882,
            ),
            (
                1.0..800.0,
                [
                    [1.0000, 691.9543, 691.9543, 0.8649, 691.9543],
                    [14.8791, 46.5051, 691.9543, 12.8696, 46.5051],
                    [28.2843, 24.4643, 691.9543, 24.4643, 24.4643],
                    [54.6368, 47.2577, 2582.0137, 47.2577, 12.6646],
                    [799.9994, 691.9537, 553562.5535, 691.9537, 0.8649],
                ],
                5.7890,
            ),
            (
                1.0..1000.0,
                [
                    [1.0000, 865.1594, 865.1594, 0.8652, 865.1594],
                    [16.5497, 52.2764, 865.1594, 14.3181, 52.2764],
                    [31.6228, 27.3587, 865.1594, 27.3587, 27.3587],
                    [61.3069, 53.0402, 3251.7284, 53.0402, 14.1120],
                    [999.9990, 865.1585, 865157.6498, 865.1585, 0.8652],
                ],
                5.9823,
            ),
            (
                0.1..100.0,
                [
                    [1.0000, 865.1594, 865.1594, 0.8652, 865.1594],
                    [16.5497, 52.2764, 865.1594, 14.3181, 52.2764],
                    [31.6228, 27.3587, 865.1594, 27.3587, 27.3587],
                    [61.3069, 53.0402, 3251.7284, 53.0402, 14.1120],
                    [999.9999, 865.1593, 865159.2055, 865.1593, 0.8652],
                ],
                5.9823,
            ),
        ];
        for (depths, rows, ideal) in tables {
            let (psm, lispsm) = (depths.start, balanced_warp_near(depths.clone()));
            let warps = [psm, 0.5 * (psm + lispsm), lispsm, 2.0 * lispsm, 1e9];
            for (warp_near, wanted) in warps.into_iter().zip(rows) {
                let worst = largest_perspective_error(depths.clone(), warp_near);
                let along = |at| perspective_error(depths.clone(), warp_near, at).along / field();
                let got = [
                    worst.across,
                    worst.along / field(),
                    worst.storage_factor() / field(),
                    along(depths.start),
                    along(depths.end),
                ];
                let same = got.iter().zip(wanted).all(|(&got, wanted)| (got - wanted).abs() < 5.1e-5);
                assert!(same, "{depths:?}, n' {warp_near}: {got:?}, not {wanted:?}");
            }
            let got = ideal_storage_factor(depths.clone()) / field();
            assert!(is_printed(got, ideal, 4), "{depths:?}: {got}, not {ideal}");
        }
    }

    #[test]
    fn an_infinite_warp_near_is_a_uniform_map() {
        for at in [1.0, 5.0, 100.0] {
            let wanted = PerspectiveError { across: 100.0 / at, along: 99.0 / at };
            assert_eq!(perspective_error(1.0..100.0, f64::INFINITY, at), wanted);
        }
    }

    #[test]
    fn storage_factors_of_logarithmic_splits_are_those_of_v3b() {
        // f/n; then for so many splits uniform and warped.
        let parts = [1, 2, 3, 4, 5, 6, 8, 16, 64];
        for (ratio, uniform, warped) in [
            (
                100.0f64,
                [9900.00, 180.00, 50.71, 27.35, 18.99, 14.92, 11.07, 7.12, 5.13],
                [99.00, 18.00, 10.92, 8.65, 7.56, 6.93, 6.23, 5.34, 4.77],
            ),
            (
                800.0,
                [639200.00, 1543.43, 230.68, 91.86, 53.44, 37.42, 24.10, 12.60, 7.82],
                [799.00, 54.57, 24.85, 17.27, 14.04, 12.28, 10.45, 8.30, 7.05],
            ),
            (
                1000.0,
                [999000.00, 1936.75, 270.00, 104.00, 59.34, 41.03, 26.02, 13.30, 8.13],
                [999.00, 61.25, 27.00, 18.49, 14.91, 12.97, 10.97, 8.64, 7.29],
            ),
            (
                10000.0,
                [99990000.00, 19800.00, 1327.84, 360.00, 167.51, 101.42, 54.70, 22.14, 11.44],
                [9999.00, 198.00, 61.63, 36.00, 26.55, 21.85, 17.30, 12.45, 9.91],
            ),
        ] {
            for (i, count) in parts.into_iter().enumerate() {
                let cut = |i| ratio.powf(f64::from(i) / f64::from(count));
                let splits: Vec<f64> = (0..=count).map(cut).collect();
                for (is_warped, wanted) in [(false, uniform[i]), (true, warped[i])] {
                    let got = storage_factor(&splits, is_warped);
                    assert!(is_printed(got, wanted, 2), "f/n {ratio}, {count} splits: {got}, not {wanted}");
                    assert!(got >= ideal_storage_factor(1.0..ratio), "nothing beats the ideal: {got}");
                }
            }
        }
    }

    #[test]
    fn storage_factors_of_practical_splits_are_those_of_v3c() {
        // f, λ; r (r − 1) by part; the storage factor; dp/ds where each part starts.
        type Row = (f32, f32, &'static [f64], f64, &'static [f64]);
        let table: [Row; 15] = [
            (800.0, 0.0, &[71199.78, 1.99, 0.75], 213599.33, &[266.333, 0.996, 0.499]),
            (800.0, 0.5, &[18990.87, 2.78, 4.08], 56972.6, &[137.308, 1.241, 1.581]),
            (800.0, 0.75, &[5372.01, 4.52, 12.28], 16116.04, &[72.796, 1.684, 3.039]),
            (800.0, 0.9, &[1196.09, 10.19, 31.23], 3588.28, &[34.088, 2.731, 5.11]),
            (800.0, 1.0, &[76.89, 76.89, 76.89], 230.68, &[8.283, 8.283, 8.283]),
            (800.0, 0.0, &[40099.81, 1.99, 0.75, 0.44], 160399.25, &[199.75, 0.995, 0.499, 0.333]),
            (800.0, 0.5, &[10513.0, 2.25, 1.31, 2.41], 42052.01, &[102.034, 1.081, 0.751, 1.131]),
            (800.0, 0.75, &[2880.89, 2.78, 2.53, 6.22], 11523.55, &[53.176, 1.24, 1.167, 2.043]),
            (800.0, 0.9, &[593.23, 4.31, 5.92, 12.67], 2372.92, &[23.861, 1.635, 1.983, 3.094]),
            (800.0, 1.0, &[22.97, 22.97, 22.97, 22.97], 91.86, &[4.318, 4.318, 4.318, 4.318]),
            (1000.0, 0.0, &[62624.81, 1.99, 0.75, 0.44], 250499.25, &[249.75, 0.996, 0.499, 0.333]),
            (1000.0, 0.5, &[16303.65, 2.23, 1.3, 2.49], 65214.58, &[127.187, 1.076, 0.744, 1.155]),
            (1000.0, 0.75, &[4409.38, 2.72, 2.49, 6.59], 17637.53, &[65.905, 1.225, 1.156, 2.116]),
            (1000.0, 0.9, &[878.05, 4.18, 5.97, 13.84], 3512.19, &[29.136, 1.605, 1.994, 3.254]),
            (1000.0, 1.0, &[26.0, 26.0, 26.0, 26.0], 104.0, &[4.623, 4.623, 4.623, 4.623]),
        ];
        for (far, lambda, parts, wanted, starts) in table {
            let settings = Settings { splits: parts.len() as u32, lambda, ..Settings::default() };
            let splits = split_distances(1.0..far, &settings);
            for ((part, &wanted), &start) in splits.windows(2).zip(parts).zip(starts) {
                let got = storage_factor(part, false);
                assert!(is_printed(got, wanted, 2), "far {far}, λ {lambda}, {part:?}: {got}, not {wanted}");
                // Zhang's dp/ds counts in near planes, and n is 1 here.
                let got = perspective_error(part[0]..part[1], f64::INFINITY, part[0]).along;
                assert!(is_printed(got, start, 3), "far {far}, λ {lambda}, {part:?}: {got}, not {start}");
            }
            let got = storage_factor(&splits, false);
            assert!(is_printed(got, wanted, 2), "far {far}, λ {lambda}: {got}, not {wanted}");
        }
    }

    #[test]
    fn without_a_part_there_is_nothing_to_store() {
        assert_eq!((storage_factor(&[], false), storage_factor(&[1.0], true)), (0.0, 0.0));
    }

    /// The map of a light from straight above on a frustum that looks along −z from the origin: x / z' across, and t
    /// along, whose W is z' / n'; so that n' = ∞ is the uniform map.
    fn map_from_above(depths: Range<f64>, warp_near: f64, half_width_at_far: f64) -> DMat4 {
        let Range { start: near, end: far } = depths;
        let whole = 1.0 + (far - near) / warp_near;
        // t = f'/(f' − n') · (z' − n')/z' = f'/n' · (z − n)/(f − n) / (z'/n'), and clip y is 2 t − 1.
        let w = DVec4::new(0.0, 0.0, -1.0 / warp_near, 1.0 - near / warp_near);
        let t = DVec4::new(0.0, 0.0, -1.0, -near) * (whole / (far - near));
        let across = DVec4::X * (whole / half_width_at_far);
        let depth = DVec4::new(0.0, -0.01, 0.0, 0.0);
        DMat4::from_cols(across, 2.0 * t - w, depth, w).transpose()
    }

    #[test]
    fn measured_texels_have_the_errors_of_the_theory() {
        // 60° either way, 1024² pixels and texels. The ground is 2 m below the eye.
        let (near, far, height) = (1.0f64, 100.0, 2.0);
        let projection = Projection::Perspective { fov_y: std::f32::consts::FRAC_PI_3, aspect: 1.0 };
        let camera = Camera::looking(Vec3::ZERO, Vec3::NEG_Z, Vec3::Y, projection, near as f32, far as f32)
            .expect("a camera");
        let sorted = |a: f64, b: f64| if a > b { (a, b) } else { (b, a) };
        let is_near = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-5;
        for warp_near in [near, 3.0, balanced_warp_near(near..far), 40.0, f64::INFINITY] {
            let map = map_from_above(near..far, warp_near, 0.5 * field() * far);
            for z in [4.0, 5.0, 10.0, 20.0, 50.0, 99.0] {
                let ground = DVec3::new(0.0, -height, -z);
                let theory = perspective_error(near..far, warp_near, z);
                let (m_s, m_t) = (theory.across, theory.along / field());

                // The eye's plane is parallel to the picture, the light's is the ground's.
                let flat =
                    perspective_texel_extent(&camera, 1024, 1024, &map, 1024.0, ground).expect("an extent");
                let (largest, smallest) = sorted(m_s, m_t);
                assert!(
                    is_near(flat.largest, largest) && is_near(flat.smallest, smallest),
                    "n' {warp_near}, z {z}: {flat:?}, not {m_s} and {m_t}"
                );

                // On the ground itself, a ray that falls by h over z has cos φ / cos θ = h / z.
                let tilted =
                    texel_extent(&camera, 1024, 1024, &map, 1024.0, ground, DVec3::Y).expect("an extent");
                let (largest, smallest) = sorted(m_s, m_t * height / z);
                assert!(
                    is_near(tilted.largest, largest) && is_near(tilted.smallest, smallest),
                    "on the ground, n' {warp_near}, z {z}: {tilted:?}, not {m_s} and {m_t} · h / z"
                );
            }
        }
    }
}
