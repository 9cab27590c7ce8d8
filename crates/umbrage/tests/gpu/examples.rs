//! The example programs draw what they say, with filters that compare and filters of moments, with one surface and with two.

#![expect(clippy::duplicate_mod, reason = "each program loads what they share")]

use std::fmt::Debug;
use std::ops::Range;

use umbrage::{Bias, DepthLayer, ExponentialVariance, Filter, Settings};

#[expect(dead_code, reason = "a program's `main`, and what only that calls")]
#[path = "../../examples/alpha.rs"]
mod alpha;
#[expect(dead_code, reason = "a program's `main`, and what only that calls")]
#[path = "../../examples/own_pipeline.rs"]
mod own_pipeline;

/// The settings that pictures are drawn with, with their names.
fn all_settings() -> impl Iterator<Item = (String, Settings)> {
    let moments = Filter::Evsm4(ExponentialVariance::default());
    let filters = [Settings::default().filter, moments];
    let layers = [DepthLayer::First, DepthLayer::Dual];
    filters.into_iter().flat_map(move |filter| {
        layers.map(|depth_layer| {
            let bias = Bias { depth_layer, ..Bias::default() };
            (format!("{} {depth_layer:?}", filter.kind()), Settings { filter, bias, ..Settings::default() })
        })
    })
}

/// Pixels of the ground: how many are lit, and how many dark. Both have the ground's hue.
fn ground(rgb: &[u8]) -> [usize; 2] {
    let (mut lit, mut dark) = (0, 0);
    for [r, g, b] in rgb.as_chunks::<3>().0 {
        let [r, g, b] = [r, g, b].map(|c| f32::from(*c) / 255.0);
        let is_ground = r > g && g > b && g > 0.88 * r && b < 0.9 * g;
        lit += usize::from(is_ground && r > 0.75);
        dark += usize::from(is_ground && r < 0.5);
    }
    [lit, dark]
}

/// The mean difference of two pictures, of 255.
fn difference(a: &[u8], b: &[u8]) -> f64 {
    a.iter().zip(b).map(|(a, b)| f64::from(a.abs_diff(*b))).sum::<f64>() / a.len() as f64
}

/// Draws with all settings: the ground has shadow in such a part of it, and all pictures are alike.
fn draws<E: Debug>(name: &str, draw: impl Fn(Settings) -> Result<Vec<u8>, E>, shadow: Range<f64>) {
    let mut first: Option<Vec<u8>> = None;
    for (with, settings) in all_settings() {
        let picture = draw(settings).expect("a picture");
        let [lit, dark] = ground(&picture);
        let share = dark as f64 / (lit + dark) as f64;
        let differs = difference(first.get_or_insert_with(|| picture.clone()), &picture);
        println!("{name}, {with}: {lit} lit, {share:.4} dark; {differs:.3} of 255 from the first");
        assert!(shadow.contains(&share), "{name}, {with}: {share} of the ground is dark");
        assert!(differs < 2.0, "{name}, {with}: differs from the first by {differs} of 255");
    }
}

#[test]
fn leaves_cast_shadows_with_their_holes() {
    draws("alpha", alpha::draw, 0.06..0.085); // 0.103 of whole cards
}

#[test]
fn a_hosts_own_pipeline_casts_as_the_librarys_does() {
    draws("own_pipeline", own_pipeline::draw, 0.065..0.09);
}
