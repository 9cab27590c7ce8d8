//! Does every kind of moments give the visibility that another program found (V11)?

use glam::Vec2;

use super::v11::V11;
use super::{Esm, Evsm2, Evsm4, Exponent, Moments, Msm, Precision, Vsm};

/// In the order of V11's columns. The vectors do not name the exponents of EVSM: their values at 0.97 of the last set give
/// 42, and those at 0.5 give 5. Nor do they name the smallest variance, which is next to nothing here.
fn columns() -> [Moments; 6] {
    let positive = Exponent::new(42.0, Precision::F32).expect("a valid exponent");
    [
        Moments::Vsm(Vsm { min_variance: 0.0, ..Vsm::default() }),
        Moments::Esm(Esm { exponent: 80.0 }),
        Moments::Evsm2(Evsm2 { exponent: positive, ..Evsm2::default() }),
        Moments::Evsm4(Evsm4 { positive, ..Evsm4::default() }),
        Moments::Msm(Msm::F32),
        Moments::Msm(Msm::UNORM16),
    ]
}

#[test]
fn visibility_is_that_of_v11_for_every_kind() {
    for depths in V11 {
        for (column, moments) in columns().into_iter().enumerate() {
            let stored = depths.deltas.iter().fold(moments.none(), |sum, (weight, depth)| {
                moments.add(sum, moments.of_depth(*depth, Vec2::ZERO), *weight)
            });
            for row in &depths.rows {
                let (got, wanted) = (moments.visibility(stored, row.receiver), row.visibility[column]);
                let what = format!("{moments:?} of {:?} at {}", depths.deltas, row.receiver);
                assert!((got - wanted).abs() < 1e-3, "{what}: {got}, not {wanted}");
            }
        }
    }
}

#[test]
fn the_depths_of_v11_are_lit_as_it_says() {
    for depths in V11 {
        for row in &depths.rows {
            let beyond = depths.deltas.iter().filter(|(_, depth)| *depth >= row.receiver);
            let lit: f32 = beyond.map(|(weight, _)| weight).sum();
            assert!((lit - row.truly_lit).abs() < 1e-6, "{:?} at {}", depths.deltas, row.receiver);
        }
    }
}
