//! Are texels as large as another program found them (V29)? The maps are made here from the numbers that it printed.
//!
//! Space: the light's, as in algorithms, §4: its origin is the eye, and up is along the view.

use glam::{DMat4, DVec2, DVec3, DVec4, Vec3};

use super::{TexelExtent, texel_extent};

/// Rows to a matrix.
pub(super) fn from_rows(rows: [DVec4; 4]) -> DMat4 {
    let [x, y, z, w] = rows;
    DMat4::from_cols(x, y, z, w).transpose()
}

/// A map of a box in the space of V29's light, whose origin is the eye (algorithms, §4).
pub(super) fn light_from_world(eye: DVec3, view: DVec3, along: DVec3) -> DMat4 {
    let up = (view - along * view.dot(along)).normalize_or_zero();
    let row = |axis: DVec3| axis.extend(-axis.dot(eye));
    from_rows([row(along.cross(up)), row(up), row(along), DVec4::W])
}

/// The box from `min` to `max` to clip x, y −1…1 and depth 0…1.
pub(super) fn clip_from_box(min: DVec3, max: DVec3) -> DMat4 {
    let unit = DMat4::from_translation(DVec3::new(-1.0, -1.0, 1.0))
        * DMat4::from_scale(DVec3::new(2.0, 2.0, -1.0) / (max - min));
    unit * DMat4::from_translation(-min)
}

/// The maps of V29, from its printed boxes: uniform, and LiSPSM by algorithms, §4.2.
fn v29_maps() -> [DMat4; 2] {
    let view = DVec3::new(0.0, -0.2, -1.0).normalize_or_zero();
    let along = DVec3::new(0.3, -1.0, -0.4).normalize_or_zero();
    let light = light_from_world(DVec3::new(0.0, 10.0, 0.0), view, along);
    let uniform = clip_from_box(
        DVec3::new(-46.564242006, 0.434210816, -3.950690991),
        DVec3::new(56.728168544, 104.707292111, 58.130751625),
    );
    let (depth, near, first) = (104.273081, 12.311900, 0.434210816);
    let moved = DMat4::from_translation(DVec3::new(0.0, near - first, 0.0));
    let warp = from_rows([
        DVec4::X * near,
        DVec4::new(0.0, (2.0 * near + depth) / depth, 0.0, -2.0 * near * (near + depth) / depth),
        DVec4::Z * near,
        DVec4::Y,
    ]);
    let warped =
        clip_from_box(DVec3::new(-7.46418836, -1.0, -1.055006256), DVec3::new(9.88350617, 1.0, 11.016559787));
    [uniform * light, warped * warp * moved * light]
}

#[test]
fn texels_on_the_ground_are_as_large_as_in_v29() {
    let camera = super::tests::perspective(Vec3::new(0.0, 10.0, 0.0), Vec3::new(0.0, 9.8, -1.0));
    // Depth; m, m_min, area; u and v, which points up there.
    let uniform = [
        (15.0, [3.2942, 2.0320, 6.6936], [0.42983078, 0.098906426]),
        (20.0, [2.5409, 1.2155, 3.0885], [0.432826415, 0.143585096]),
        (30.0, [1.7452, 0.5751, 1.0036], [0.438817685, 0.232942436]),
        (50.0, [1.0735, 0.2179, 0.2339], [0.450800226, 0.411657116]),
        (80.0, [0.6807, 0.0876, 0.0596], [0.468774037, 0.679729137]),
        (99.0, [0.5526, 0.0578, 0.0319], [0.48015745, 0.849508083]),
    ];
    let warped = [
        (15.0, [1.0295, 0.7157, 0.7367], [0.362326453, 0.509653621]),
        (20.0, [0.9600, 0.6209, 0.5961], [0.381976727, 0.61354237]),
        (30.0, [0.8864, 0.5276, 0.4677], [0.406270301, 0.741979716]),
        (50.0, [0.8241, 0.4546, 0.3746], [0.43026976, 0.868862106]),
        (80.0, [0.7876, 0.4143, 0.3263], [0.446108628, 0.95260039]),
        (99.0, [0.7757, 0.4016, 0.3115], [0.451600546, 0.98163553]),
    ];
    for (map, table) in v29_maps().iter().zip([uniform, warped]) {
        for (z, printed, uv) in table {
            let position = DVec3::new(0.0, 0.0, -z);
            let got_uv = 0.5 * map.project_point3(position).truncate() + 0.5;
            assert!((got_uv - DVec2::from(uv)).length() < 1e-6, "z {z}: at {got_uv} of the map, not {uv:?}");
            let got = texel_extent(&camera, 800, 600, map, 1024.0, position, DVec3::Y);
            let TexelExtent { largest, smallest, area } = got.expect("an extent");
            for (got, wanted) in [largest, smallest, area].into_iter().zip(printed) {
                // Four decimals are printed.
                assert!((got - wanted).abs() < 5.1e-5, "z {z}: {got}, not {wanted}");
            }
        }
    }
}
