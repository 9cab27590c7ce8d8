//! Boxes on a ground, drawn off screen by Bevy with the plug-in and without, against rays through the same boxes.

mod bevy_off_screen;
mod boxes;

use bevy::light::CascadeShadowConfig;
use bevy::prelude::*;
use bevy_umbrage::{Fit, StockCascades, UmbragePlugin, UmbrageShadows};

use bevy_off_screen::Drawn;

/// The share of pixels whose shadow is not that of a ray.
fn wrong(drawn: &mut Drawn) -> f64 {
    let visibility = drawn.visibility();
    let judged = visibility.iter().zip(boxes::truth()).filter_map(|(got, truth)| got.zip(truth));
    let judged: Vec<bool> = judged.map(|(got, truth)| (got > 0.5) != truth).collect();
    assert!(judged.len() > visibility.len() / 2, "only {} pixels were judged", judged.len());
    judged.iter().filter(|wrong| **wrong).count() as f64 / judged.len() as f64
}

#[test]
fn the_plugin_leaves_less_than_half_of_stocks_wrong_pixels() {
    let stock = wrong(&mut Drawn::new(None));
    let shadows = |shadows| Some(UmbragePlugin { shadows });
    for fit in [Fit::Scene, Fit::View] {
        let ours = wrong(&mut Drawn::new(shadows(UmbrageShadows { fit, ..default() })));
        assert!(ours < 0.5 * stock && ours < 0.02, "{fit:?}: {ours} of {stock}");
    }
    let blended = wrong(&mut Drawn::new(shadows(UmbrageShadows { blend: 0.2, ..default() })));
    assert!(blended < 0.5 * stock && blended < 0.02, "blended: {blended} of {stock}");
}

#[test]
fn cascades_keep_their_number_and_end_and_follow_what_is_asked_anew() {
    let mut drawn = Drawn::new(Some(UmbragePlugin::default()));
    let stock = drawn.config.bounds.clone();
    let ours = drawn.bounds();
    assert_eq!((ours.len(), ours.last()), (stock.len(), stock.last()));
    assert!(ours.windows(2).all(|ends| ends[0] < ends[1]), "{ours:?}");
    assert_ne!(ours, stock, "they are cut elsewhere");
    drawn.edit(CascadeShadowConfig { bounds: vec![10.0, 40.0], ..drawn.config.clone() });
    let fewer = drawn.bounds();
    assert_eq!((fewer.len(), fewer.last()), (2, Some(&40.0)));
}

#[test]
fn a_fade_that_is_asked_for_while_the_program_runs_is_that_of_one_from_the_start() {
    let fades = UmbrageShadows { blend: 0.5, ..default() };
    let mut drawn = Drawn::new(Some(UmbragePlugin::default()));
    let before = drawn.visibility();
    drawn.choose(fades.clone());
    let faded = drawn.visibility();
    assert!(faded != before, "maps fade into each other");
    assert!(
        faded == Drawn::new(Some(UmbragePlugin { shadows: fades })).visibility(),
        "as they do from the start"
    );
    drawn.choose(UmbrageShadows::default());
    assert!(drawn.visibility() == before, "and no more");
}

#[test]
fn a_marked_light_keeps_bevys_cascades_and_is_read_all_the_same() {
    let mut drawn = Drawn::new(Some(UmbragePlugin::default()));
    drawn.mark(StockCascades);
    drawn.edit(drawn.config.clone());
    assert_eq!(drawn.bounds(), drawn.config.bounds);
    let (stock, read) = (wrong(&mut Drawn::new(None)), wrong(&mut drawn));
    assert!(read < stock, "{read} of {stock}");
}
