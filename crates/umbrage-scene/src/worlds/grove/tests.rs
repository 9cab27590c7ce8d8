//! Does the grove have what it was made for?

use super::*;
use crate::worlds::canvas::covered;
use crate::{Alpha, Motion};

#[test]
fn trees_stand_10_100_and_400_m_from_the_main_camera() {
    let scene = build(0);
    let eye = scene.cameras[0].eye();
    for (tree, wanted) in TREES.into_iter().zip([10.0, 100.0, 400.0]) {
        let trunk = scene.instances.iter().find(|instance| {
            let at = instance.world_from_mesh.w_axis;
            scene.meshes[instance.mesh].name == "trunk" && Vec2::new(at.x, at.z).distance(tree) < 0.01
        });
        let foot = trunk.expect("a tree").world_from_mesh.w_axis.truncate();
        let way = eye.distance(foot);
        assert!((way / wanted - 1.0).abs() < 0.02, "{way} m, not {wanted}");
    }
}

#[test]
fn what_grows_is_cut_out_of_pictures_with_holes() {
    let scene = build(0);
    let masks = scene.materials.iter().filter(|material| matches!(material.alpha, Alpha::Mask { .. }));
    let shares: Vec<(String, f32)> = masks
        .map(|material| {
            (material.name.clone(), covered(&scene.textures[material.texture.expect("a picture")]))
        })
        .collect();
    assert_eq!(shares.len(), 5, "{shares:?}");
    for (name, share) in shares {
        assert!((0.15..0.8).contains(&share), "{name} covers {share}");
    }
    let masked = |mesh: usize| {
        let parts = &scene.meshes[mesh].parts;
        parts.iter().any(|part| !scene.materials[part.material].is_solid())
    };
    let count = scene.instances.iter().filter(|instance| masked(instance.mesh)).count();
    assert!(count > 3000, "{count} instances with holes");
}

#[test]
fn boughs_sway_and_crowns_are_morphed() {
    let scene = build(0);
    let start = scene.pose(0.0);
    let gusts = [0.7, 1.4, 2.1].map(|seconds| scene.pose(seconds));
    let boughs: Vec<_> = scene.instances.iter().filter(|i| scene.meshes[i.mesh].name == "bough").collect();
    assert_eq!(boughs.len(), 8 * 17);
    for bough in &boughs {
        let tip = |pose| bough.world_from_mesh_in(pose).transform_point3(Vec3::Z * 3.0);
        let moved = gusts.iter().map(|gust| tip(gust).distance(tip(&start))).fold(0.0, f32::max);
        assert!((0.005..1.0).contains(&moved), "a tip moves by {moved} m");
        assert!(matches!(bough.motion, Motion::Node { .. }), "{bough:?}");
    }
    let morphed = scene.instances.iter().filter(|i| !scene.meshes[i.mesh].targets.is_empty());
    let mut count = 0;
    for instance in morphed {
        let node = instance.node.expect("a node");
        assert_ne!(start.weights(node), gusts[0].weights(node));
        count += 1;
    }
    assert_eq!(count, 3 + 5);
}

#[test]
fn links_leave_most_of_the_way_open_and_repeat() {
    let links = leaves::links();
    let share = covered(&links);
    assert!((share - (1.0 - (1.0 - 0.16 * 2.0_f32.sqrt()).powi(2))).abs() < 0.03, "{share}");
    let row = |row: usize| &links.rgba[row * 512..row * 512 + 512];
    assert_eq!(row(0), row(32), "four links across");
}
