//! Leaves are cut out of pictures, and far trees are drawn into few texels: does the shadow of a tree cover as much ground as
//! it should, however far it stands?
//!
//! One kind of tree stands 10, 100 and 400 m from the main camera of `grove`. Of the ground whose rays to the sun pass
//! through a tree's crown, the drawn shadow covers a share, and the true one another; both are sums over pixels.

use std::sync::Arc;

use glam::{DVec2, DVec3};
use umbrage::Settings;
use umbrage_judge::{Eye, Light, Receiver, Truth, World};
use umbrage_lab::Shot;
use umbrage_render::{Gpu, Renderer, Show};
use umbrage_scene::{Scene, worlds};

/// The size of the picture: the farthest shadow has some hundred pixels.
const SIZE: (u32, u32) = (1920, 1080);
/// The radius of a crown and the height of a tree of size 1, metres, with some ground around their shadow.
const CROWN: f64 = 5.0;
const TALL: f64 = 12.0;

/// A tree's foot and size.
#[derive(Clone, Copy, Debug)]
struct Tree {
    foot: DVec3,
    size: f64,
}

/// The trees that the main camera was placed for: trunks whose boughs sway, nearest first.
fn trees(scene: &Scene) -> Vec<Tree> {
    let trunks = scene.instances.iter().filter(|instance| scene.meshes[instance.mesh].name == "trunk");
    let tree = |trunk: &umbrage_scene::Instance| {
        let (scale, _, foot) = trunk.world_from_mesh.to_scale_rotation_translation();
        Tree { foot: foot.as_dvec3(), size: f64::from(scale.y) }
    };
    let eye = scene.cameras[0].eye().as_dvec3();
    let away = |tree: &Tree, wanted: f64| (tree.foot.distance(eye) / wanted - 1.0).abs();
    let all: Vec<Tree> = trunks.map(tree).collect();
    let nearest_to =
        |wanted: f64| all.iter().min_by(|a, b| away(a, wanted).total_cmp(&away(b, wanted))).copied();
    [10.0, 100.0, 400.0].iter().filter_map(|wanted| nearest_to(*wanted)).collect()
}

/// Whether a receiver is ground in or beside the shadow of a tree's crown.
fn is_in_shade(receiver: &Receiver, tree: Tree, to_sun: DVec3) -> bool {
    let Tree { foot, size } = tree;
    let from_foot = receiver.position - foot;
    let level = DVec2::new(from_foot.x, from_foot.z);
    // The slope is nowhere steeper than one in four. Leaves are higher.
    let is_ground = from_foot.y < 0.25 * level.length() + 0.1;
    let sunward = DVec2::new(to_sun.x, to_sun.z);
    let nearest = -level.dot(sunward) / sunward.length_squared();
    let height = from_foot.y + to_sun.y * nearest;
    let aside = (level + sunward * nearest).length();
    is_ground && nearest > 0.0 && aside < CROWN * size && (0.0..TALL * size).contains(&height)
}

#[test]
fn a_trees_shadow_covers_what_it_should_at_10_100_and_400_m() {
    let gpu = Gpu::new(None).expect("an adapter: run scripts/setup");
    let scene = worlds::build("grove", 0).expect("a world");
    let mut renderer = Renderer::new(&gpu, &scene, Settings::default()).expect("a renderer");
    // In a calm, and in a gust.
    for seconds in [0.0, 4.3] {
        assert_covered(&mut renderer, &scene, seconds);
    }
}

/// Draws and traces the main camera's picture, and compares shadows tree by tree.
fn assert_covered(renderer: &mut Renderer, scene: &Scene, seconds: f32) {
    let (width, height) = SIZE;
    let (camera, lights) = (scene.cameras[0].clone(), scene.lights.clone());
    let shot = Shot { camera, lights, pose: Arc::new(scene.pose(seconds)), width, height };
    let frame = shot.frame(Show::Visibility(0)).expect("a good camera and light");
    let drawn = renderer.render(&frame).expect("a frame").drawn.picture().expect("a picture").visibility();
    let eye = Eye::new(&shot.camera, width, height);
    let world = World::new(scene, &shot.pose);
    let truth = Truth::new(&world, &eye, &Light::of(&scene.lights[0]), f64::from(shot.camera.far));
    let to_sun = -scene.lights[0].direction().as_dvec3();
    for (tree, metres) in trees(scene).into_iter().zip([10, 100, 400]) {
        let (mut pixels, mut covers, mut should) = (0, 0.0, 0.0);
        for ((receiver, pixel), drawn) in truth.receivers.iter().zip(&truth.pixels).zip(&drawn) {
            let shade = receiver.as_ref().filter(|receiver| is_in_shade(receiver, tree, to_sun));
            if let (Some(_), Some(true_visibility)) = (shade, pixel.visibility()) {
                pixels += 1;
                covers += 1.0 - f64::from(*drawn);
                should += 1.0 - f64::from(true_visibility);
            }
        }
        println!(
            "{metres} m, {seconds} s: {covers:.1} of {pixels} pixels in shadow, {should:.1} by the truth"
        );
        assert!(should > 20.0, "at {metres} m the shadow has {should} pixels");
        assert!(
            (covers / should - 1.0).abs() < 0.05,
            "at {metres} m, {seconds} s: {covers} pixels instead of {should}"
        );
    }
}
