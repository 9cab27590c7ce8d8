//! The six chessmen after Staunton's pattern, 75 to 160 m tall; all but the knight are mostly turned on a lathe.

use glam::Vec3;

use crate::paint::Paint;
use crate::shape::{Model, Solid, bevelled, bevelled_prism, curve, lathe, sphere};

const SEGMENTS: u32 = 24;

/// Rook, knight, bishop, queen, king, pawn of one colour, with names.
pub(crate) fn all(paint: Paint) -> [(&'static str, Model); 6] {
    [
        ("rook", rook()),
        ("knight", knight()),
        ("bishop", bishop()),
        ("queen", queen()),
        ("king", king()),
        ("pawn", pawn()),
    ]
    .map(|(name, solid)| {
        let mut model = Model::default();
        model.add(paint, solid);
        (name, model)
    })
}

/// The foot that all share, then a stem that curves through (radius, height) keys.
fn turned(foot: f32, stem: &[[f32; 2]], steps: usize) -> Solid {
    let mut profile: Vec<[f32; 2]> = [[1.0, 0.0], [1.0, 0.16], [0.92, 0.26], [0.8, 0.34], [0.8, 0.42]]
        .map(|[r, y]| [r * foot, y * foot])
        .to_vec();
    profile.extend(curve(stem, steps));
    lathe(&profile, SEGMENTS)
}

/// A collar: a flat double cone.
fn collar(radius: f32, height: f32) -> Solid {
    let thick = radius * 0.16;
    lathe(&[[radius * 0.6, height - thick], [radius, height], [radius * 0.6, height + thick]], SEGMENTS)
}

fn pawn() -> Solid {
    turned(24.0, &[[17.0, 11.0], [11.0, 22.0], [8.0, 40.0], [7.5, 50.0]], 3)
        .and(collar(15.0, 50.0))
        .and(sphere(13.0, SEGMENTS, 12).moved(0.0, 62.0, 0.0))
}

fn rook() -> Solid {
    let body = turned(28.0, &[[20.0, 13.0], [15.0, 30.0], [13.5, 55.0], [15.0, 70.0], [20.0, 76.0]], 3);
    let crown = lathe(&[[20.0, 75.0], [22.0, 78.0], [22.0, 84.0], [0.0, 84.0]], SEGMENTS);
    let merlon = bevelled(10.5, 12.0, 6.0, 0.6).moved(0.0, 88.0, 18.6);
    body.and(crown).and(collar(19.5, 72.0)).and(merlon.around(6))
}

fn bishop() -> Solid {
    let mitre = curve(&[[8.0, 78.0], [13.5, 88.0], [12.0, 100.0], [5.0, 112.0], [0.0, 117.0]], 4);
    turned(27.0, &[[19.0, 13.0], [12.0, 28.0], [8.5, 55.0], [8.0, 78.0]], 3)
        .and(collar(18.0, 72.0))
        .and(collar(14.0, 79.0))
        .and(lathe(&mitre, SEGMENTS))
        .and(sphere(4.2, 14, 8).moved(0.0, 119.0, 0.0))
}

fn queen() -> Solid {
    let head = curve(&[[10.0, 98.0], [12.0, 112.0], [19.0, 128.0]], 4);
    let point = lathe(&[[4.6, 0.0], [4.0, 4.0], [0.0, 11.0]], 8).moved(0.0, 125.0, 16.5);
    turned(31.0, &[[22.0, 15.0], [14.0, 34.0], [10.0, 66.0], [9.5, 98.0]], 4)
        .and(collar(21.0, 90.0))
        .and(collar(17.0, 98.0))
        .and(lathe(&head, SEGMENTS))
        .and(point.around(9))
        .and(lathe(&curve(&[[14.0, 127.0], [10.0, 134.0], [0.0, 137.0]], 3), SEGMENTS))
        .and(sphere(5.5, 16, 8).moved(0.0, 141.0, 0.0))
}

fn king() -> Solid {
    let head = curve(&[[10.5, 106.0], [13.0, 120.0], [20.0, 134.0]], 4);
    let arm = [
        [-2.2, 0.0],
        [2.2, 0.0],
        [2.8, 6.5],
        [8.0, 5.5],
        [8.0, 12.0],
        [2.8, 11.0],
        [2.6, 18.0],
        [-2.6, 18.0],
        [-2.8, 11.0],
        [-8.0, 12.0],
        [-8.0, 5.5],
        [-2.8, 6.5],
    ];
    turned(33.0, &[[23.0, 16.0], [15.0, 36.0], [11.0, 70.0], [10.0, 106.0]], 4)
        .and(collar(22.5, 97.0))
        .and(collar(18.5, 106.0))
        .and(lathe(&head, SEGMENTS))
        .and(lathe(&curve(&[[20.0, 134.0], [14.0, 140.0], [3.0, 144.0]], 3), SEGMENTS))
        .and(bevelled_prism(&arm, 4.5, 0.7).moved(0.0, 143.0, 0.0))
}

/// A horse's head on the shared foot: an outline in the plane of symmetry, bevelled so that cheeks and neck round off.
fn knight() -> Solid {
    /// Seen from the right side, muzzle to the right; from the chest round the muzzle and ears, down the mane.
    const HEAD: [[f32; 2]; 24] = [
        [17.0, 12.0],
        [15.0, 24.0],
        [9.0, 36.0],
        [7.0, 47.0],
        [10.0, 54.0],
        [17.0, 53.0],
        [23.0, 48.0],
        [27.0, 45.0],
        [32.0, 47.0],
        [35.0, 52.0],
        [34.0, 58.0],
        [28.0, 68.0],
        [21.0, 79.0],
        [14.0, 87.0],
        [10.0, 91.0],
        [8.0, 102.0],
        [3.0, 94.0],
        [-4.0, 92.0],
        [-12.0, 86.0],
        [-18.0, 75.0],
        [-21.0, 60.0],
        [-21.0, 42.0],
        [-19.0, 26.0],
        [-19.0, 12.0],
    ];
    let head = bevelled_prism(&HEAD, 21.0, 2.6)
        .bent(|p| {
            // Wide at the chest, slim at the muzzle.
            let slim = 1.15 - 0.35 * (p.y / 100.0) - 0.25 * (p.x / 35.0).max(0.0);
            Vec3::new(p.x, p.y, p.z * slim)
        })
        .turned(0.0, -std::f32::consts::FRAC_PI_2, 0.0);
    let ear = lathe(&[[3.4, 0.0], [2.6, 5.0], [0.0, 13.0]], 10).moved(5.0, 90.0, 7.0).both_sides();
    let eye = sphere(2.4, 10, 6).moved(7.3, 73.0, 16.0).both_sides();
    let mane = (0..7).map(|i| {
        let t = i as f32 / 6.0;
        let place = Vec3::new(0.0, 90.0 - 52.0 * t, -7.0 - 14.0 * (t * 2.4).min(1.0));
        bevelled(6.0, 9.5, 7.0, 1.2).turned(-0.5, 0.0, 0.0).moved(place.x, place.y, place.z)
    });
    turned(28.0, &[[21.0, 13.0], [20.0, 14.0]], 1)
        .and(head)
        .and(ear)
        .and(eye)
        .and(mane.fold(Solid::default(), Solid::and))
}
