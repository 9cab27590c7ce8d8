//! The judge is judged by laws that any shadow map obeys.
//!
//! A map that is read at its nearest texel moves a straight edge by up to half a texel. If the edge lies anywhere with
//! respect to the texels, then in the mean it is moved by 1/4 of a texel where it is parallel to them, and by √2/6
//! (0.2357) where it is diagonal; and between two maps whose texels lie independently, 1/3 of a texel of every unit of
//! its length flips (7√2/30, 0.33, where it is diagonal). Whatever the judge says of a real map drawn on a real device
//! must be that.

use std::sync::Arc;

use glam::{DVec2, DVec3, Mat4, Vec3};
use umbrage::{Bias, Filter, Fit, Lookup, Settings, ShadowPlan};
use umbrage_judge::temporal::{Anchor, AnchorResult, Flicker};
use umbrage_judge::{Edges, Error, Eye, Light, ShadowResult, Truth, World};
use umbrage_lab::{Laboratory, Motion, Shot, Watch};
use umbrage_render::{Drawn, Frame, Gpu, Renderer, Show};
use umbrage_scene::{Camera, Instance, Lens, Light as Lamp, Material, Mesh, Pose, Primitive, Scene, worlds};

/// Side of the picture, pixels, and of what it shows, metres.
const PIXELS: u32 = 128;
const METRES: f32 = 12.8;

/// Light that falls straight down on a ground, and a half-plane above it whose edge runs at an angle to the x axis, so far
/// from the origin.
fn half_plane(degrees: f32, distance: f32) -> Scene {
    let (sine, cosine) = degrees.to_radians().sin_cos();
    let (along, away) = (Vec3::new(cosine, 0.0, sine), Vec3::new(-sine, 0.0, cosine));
    let quad = |corners: [Vec3; 4]| Primitive {
        positions: corners.to_vec(),
        normals: vec![Vec3::Y; 4],
        uvs: vec![glam::Vec2::ZERO; 4],
        indices: vec![0, 1, 2, 0, 2, 3],
        material: 0,
        ..Primitive::default()
    };
    let ground =
        [(-1.0, -1.0), (-1.0, 1.0), (1.0, 1.0), (1.0, -1.0)].map(|(x, z)| Vec3::new(x, 0.0, z) * 30.0);
    let caster = [(-1.0, 0.0), (-1.0, 1.0), (1.0, 1.0), (1.0, 0.0)]
        .map(|(a, b)| along * (a * 30.0) + away * (b * 30.0 + distance) + Vec3::Y * 4.0);
    Scene {
        name: "half-plane".to_owned(),
        meshes: vec![Mesh::new("ground", &[quad(ground)]), Mesh::new("caster", &[quad(caster)])],
        instances: (0..2).map(|mesh| Instance::still(mesh, Mat4::IDENTITY)).collect(),
        materials: vec![Material::plain("grey", 0.5, 0.5, 0.5)],
        lights: vec![Lamp::sun(Vec3::NEG_Y, 1.0)],
        ..Scene::default()
    }
}

/// Looks straight down on the ground from under the half-plane.
fn camera(offset: DVec2) -> Camera {
    let eye = Vec3::new(offset.x as f32, 2.0, offset.y as f32);
    let lens = Lens::Orthographic { half_height: 0.5 * METRES };
    Camera { lens, ..Camera::looking("down", eye, eye - Vec3::Y, 1.0, 0.5, 3.0) }
}

/// A nearest lookup in one map whose texels are about `m` pixels large, without any bias but against rounding.
fn settings(m: u32) -> Settings {
    Settings {
        splits: 1,
        resolution: PIXELS / m,
        fit: Fit::View,
        filter: Filter::Hard {},
        bias: Bias { constant: 1e-3, ..Bias::NONE },
        ..Settings::default()
    }
}

fn frame(camera: &Camera, width: u32) -> Frame {
    let sun = Lamp::sun(Vec3::NEG_Y, 1.0);
    Frame::of(camera, &[sun], &Default::default(), [width, width], Show::Visibility(0))
        .expect("a good camera and sun")
}

/// The angle of the map's texels to the x axis, degrees, and their size.
fn texels(plan: &ShadowPlan) -> (f32, f32) {
    let view = &plan.views()[0];
    let right = view.clip_from_world.row(0).truncate().as_vec3();
    (right.z.atan2(right.x).to_degrees().rem_euclid(90.0), view.texel_metres)
}

/// One map whose texels stay where they are in the world, about `m` pixels large.
fn stable(m: u32) -> Settings {
    Settings { fit: Fit::Stable, resolution: 192 / m, ..settings(m) }
}

#[test]
fn a_nearest_lookup_displaces_edges_by_a_quarter_of_a_texel() {
    /// Places of the edge in a texel, and of the pixels over the texels: both spread evenly. The smaller texels are, the
    /// more it matters where pixels lie.
    const EDGES: u32 = 8;
    const CAMERAS: usize = 144;
    let gpu = Gpu::new(None).expect("an adapter: run scripts/setup");
    let mut off_by_more = Vec::new();
    for m in [1, 2, 4, 8] {
        for (diagonal, law) in [(0.0, 0.25), (45.0, 2f64.sqrt() / 6.0)] {
            let probe = half_plane(0.0, 0.0);
            let mut renderer = Renderer::new(&gpu, &probe, stable(m)).expect("a renderer");
            let drawn = renderer.render(&frame(&camera(DVec2::ZERO), 8)).expect("a frame").drawn;
            let (angle, texel) = texels(drawn.plan());
            let texel_px = f64::from(texel) / f64::from(METRES) * f64::from(PIXELS);
            let (mut wrong, mut length) = (0.0, 0.0);
            for edge in 0..EDGES {
                let scene = half_plane(angle + diagonal, (edge as f32 + 0.5) / EDGES as f32 * texel);
                let mut renderer = Renderer::new(&gpu, &scene, stable(m)).expect("a renderer");
                let world = World::new(&scene, &Pose::default());
                for i in 0..CAMERAS / m as usize {
                    let pixel = f64::from(METRES) / f64::from(PIXELS);
                    let share = |step: f64| (0.5 + step * i as f64).fract();
                    let place = DVec2::new(share(0.754_877_666_246_693), share(0.569_840_290_998_053));
                    let camera = camera(place * pixel);
                    let drawn = renderer.render(&frame(&camera, PIXELS)).expect("a frame").drawn;
                    assert_eq!(texels(drawn.plan()).1, texel, "texels keep their size");
                    let (truth, edges, error) = judged(&world, &camera, &drawn, texel);
                    wrong += error.mis_shadowed * truth.judged() as f64;
                    length += edges.length();
                }
            }
            let ratio = wrong / length / texel_px / law;
            println!(
                "a texel of {texel_px:.3} px, edge at {diagonal}°: {ratio:.4} of the law's displacement"
            );
            off_by_more.extend(((ratio - 1.0).abs() > 0.03).then_some((m, diagonal, ratio)));
        }
    }
    assert!(off_by_more.is_empty(), "{off_by_more:?}");
}

/// What is true of a picture, and how wrong it is.
fn judged(world: &World, camera: &Camera, drawn: &Drawn, texel: f32) -> (Truth, Edges, Error) {
    let visibility = drawn.picture().expect("a picture").visibility();
    let truth = Truth::new(world, &Eye::new(camera, PIXELS, PIXELS), &Light::sun(Vec3::NEG_Y), 100.0);
    let edges = Edges::new(&truth);
    let result = ShadowResult { visibility: &visibility, texel_metres: &vec![texel; visibility.len()] };
    let error = Error::new(world, &truth, &edges, None, &result).expect("all is judged");
    (truth, edges, error)
}

#[test]
fn a_third_of_a_texel_flips_between_maps_that_lie_independently() {
    let gpu = Gpu::new(None).expect("an adapter: run scripts/setup");
    for (diagonal, law) in [(0.0, 1.0 / 3.0), (45.0, 7.0 * 2f64.sqrt() / 30.0)] {
        let settings = settings(4);
        let probe = half_plane(0.0, 0.0);
        let mut renderer = Renderer::new(&gpu, &probe, settings.clone()).expect("a renderer");
        let probed = renderer.render(&frame(&camera(DVec2::ZERO), 8)).expect("a frame").drawn;
        let (angle, texel) = texels(probed.plan());
        let degrees = angle + diagonal;
        let scene = half_plane(degrees, 0.0);
        let mut renderer = Renderer::new(&gpu, &scene, settings.clone()).expect("a renderer");
        // Points in a band of a texel on both sides of the edge, 6 m long.
        let (sine, cosine) = f64::from(degrees).to_radians().sin_cos();
        let (across, along) = (DVec3::new(-sine, 0.0, cosine), DVec3::new(cosine, 0.0, sine));
        let share = |i: usize, step: f64| (0.5 + step * i as f64).fract() - 0.5;
        let band = 2.0 * f64::from(texel);
        let anchors: Vec<Anchor> = (0..4000)
            .map(|i| {
                across * (share(i, 0.618_033_988_749_895) * band)
                    + along * (share(i, 0.754_877_666_246_693) * 6.0)
            })
            .map(|position| Anchor { position, normal: DVec3::Y, lift: 0.0 })
            .collect();
        // Any two steps of this sequence are as good as independent.
        let phases = (0..640)
            .map(|i| DVec2::new(share(i * i, 0.618_033_988_749_895), share(i * i, 0.414_213_562_373_095)));
        let result: Vec<Vec<AnchorResult>> = phases
            .map(|phase| {
                let camera = camera(phase * f64::from(8.0 * texel));
                let drawn = renderer.render(&frame(&camera, 1)).expect("a frame").drawn;
                let maps = renderer.maps(&drawn).expect("maps");
                let lookup = Lookup { plan: drawn.plan(), settings: &settings, maps: &maps };
                let ask = |a: &Anchor| AnchorResult {
                    visibility: lookup.visibility(0, a.position.as_vec3(), a.normal.as_vec3()),
                    map: 0,
                };
                anchors.iter().map(ask).collect()
            })
            .collect();
        let world = World::new(&scene, &Pose::default());
        let truth = umbrage_judge::temporal::visibility(&world, &Light::sun(Vec3::NEG_Y), &anchors);
        let flicker = Flicker::new(&result, &vec![truth; result.len()]);
        let ratio = flicker.flip_rate * band / f64::from(texel) / law;
        println!("edge at {diagonal}°: {ratio:.4} of the law's flips");
        assert!((ratio - 1.0).abs() < 0.05, "{diagonal}°: {ratio} of the law's flips");
    }
}

/// A point that comes to be served by another map may flip: its texels are others.
#[test]
fn stable_maps_never_flip_however_the_camera_moves() {
    let gpu = Gpu::new(None).expect("an adapter: run scripts/setup");
    let scene = worlds::build("primitives", 0).expect("a built-in world");
    let shot = Shot {
        camera: scene.cameras[0].clone(),
        lights: scene.lights.clone(),
        pose: Arc::default(),
        width: 640,
        height: 360,
    };
    let mut laboratory = Laboratory::new(&gpu, &scene).expect("a laboratory");
    let watch = Watch { frames: 20, points: 10_000 };
    let mut flips = |fit, motion| {
        let settings = Settings { fit, resolution: 512, filter: Filter::Hard {}, ..Settings::default() };
        let flicker = laboratory.flicker(&shot, &settings, motion, watch).expect("a path");
        assert!(flicker.points > 4000 && flicker.frames == 20, "{flicker:?}");
        flicker.flips - flicker.flips_between_maps
    };
    for motion in [Motion::Translate, Motion::Yaw, Motion::Walk, Motion::Fast] {
        assert_eq!(flips(Fit::Stable, motion), 0, "{motion:?}");
        assert!(
            flips(Fit::View, motion) > 20,
            "{motion:?}: a map that moves with the camera flips, so this test can fail"
        );
    }
}
