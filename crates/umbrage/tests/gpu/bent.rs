//! Rays through meshes that bend: what the device refits is what is built anew of the same positions, and what nobody refits is left
//! to the maps.

use glam::{DVec3, Mat4, Quat, Vec2, Vec3};
use umbrage::casters::{AlphaMode, AlphaPicture, Cover, Geometry, Mesh, Part, Placed, Shape, TopLevel};
use umbrage::{BentMesh, Exact, Light, OccluderRoom, Occluders, Settings, ShadowError, Shadows};

use crate::common::{Drawn, Query, bounds, buffer, camera, device, draw_again, queries, world};

/// A mask of holes in stripes.
struct Mask {
    uvs: Vec<Vec2>,
    picture: AlphaPicture,
}

impl Mask {
    fn of(vertices: usize) -> Self {
        let uvs = [Vec2::ZERO, Vec2::new(0.0, 3.0), Vec2::new(3.0, 3.0)];
        let picture = AlphaPicture { width: 2, height: 2, alpha: vec![255, 0, 255, 0] };
        Self { uvs: (0..vertices).map(|i| uvs[i % 3]).collect(), picture }
    }

    fn cover(&self) -> Cover<'_> {
        let mode = AlphaMode::Mask { cutoff: 0.5 };
        Cover { mode, transmission: 0.0, factor: 1.0, uvs: &self.uvs, alphas: &[], picture: Some(0) }
    }
}

/// A mesh of all of these triangles, the same for all positions that its vertices may have.
fn build(triangles: &[[Vec3; 3]], mask: Option<&Mask>, bends: bool) -> Geometry {
    let positions = triangles.as_flattened();
    let indices: Vec<u32> = (0..positions.len() as u32).collect();
    let parts = vec![Part { indices: &indices, cover: mask.map(Mask::cover) }];
    let pictures: Vec<AlphaPicture> = mask.iter().map(|mask| mask.picture.clone()).collect();
    Geometry::build(&[Mesh { positions, parts, bends }], &pictures)
}

/// A world twisted about the vertical, so much a metre.
fn twisted(world: &[[Vec3; 3]], by: f32) -> Vec<[Vec3; 3]> {
    let twist = |at: Vec3| Quat::from_rotation_y(by * at.y) * at + Vec3::X * (by * at.y);
    world.iter().map(|triangle| triangle.map(twist)).collect()
}

/// Boxes on a ground that bends.
struct Yard {
    drawn: Drawn,
    queries: Vec<Query>,
}

impl Yard {
    /// With maps of `world`, and questions about its places.
    fn of(world: &[[Vec3; 3]]) -> Self {
        let gpu = device(wgpu::Backends::VULKAN);
        let view = camera(Vec3::new(-30.0, 25.0, -40.0), Vec3::ZERO);
        let sun = Light::directional(Vec3::new(0.5, -1.0, 0.3)).expect("a sun");
        let settings = Settings { exact: Exact::Always, ..Settings::default() };
        let shadows = Shadows::new(&gpu.0, settings).expect("settings");
        let drawn = draw_again(gpu, shadows, &view, &[sun], world, &bounds(world));
        Self { drawn, queries: queries(world, &view, 6) }
    }

    /// How much of the sun reaches each place past casters that stand so.
    fn past(&mut self, occluders: Occluders, top: &TopLevel) -> Vec<f32> {
        let Drawn { device, queue, shadows, plan } = &mut self.drawn;
        occluders.place(queue, top).expect("room");
        let _ = shadows.set_occluders(device, Some(occluders)).expect("casters");
        shadows.upload(queue, plan).expect("its own plan");
        self.drawn.visibility(&self.queries)
    }

    /// The same past a mesh as it is.
    fn past_rigid(&mut self, geometry: &Geometry) -> Vec<f32> {
        let occluders = self.occluders(geometry, 1);
        self.past(occluders, &top(geometry, [Placed::rigid(0, Mat4::IDENTITY)]))
    }

    fn occluders(&self, geometry: &Geometry, instances: usize) -> Occluders {
        let room = OccluderRoom { instances, left_to_maps: false };
        Occluders::new(&self.drawn.device, &self.drawn.queue, geometry, room).expect("room on the device")
    }

    /// Casters whose meshes are refitted to these vertices.
    fn refitted(&self, geometry: &Geometry, bent: &[BentMesh], vertices: &[Vec3]) -> Occluders {
        let Drawn { device, queue, .. } = &self.drawn;
        let positions = buffer(device, queue, bytemuck::cast_slice(vertices), wgpu::BufferUsages::STORAGE);
        let occluders = self.occluders(geometry, bent.len());
        let occluders = occluders
            .with_bent(device, queue, geometry, bent, positions.as_entire_buffer_binding())
            .expect("they bend");
        let mut encoder = device.create_command_encoder(&Default::default());
        occluders.refit(&mut encoder.begin_compute_pass(&Default::default()));
        queue.submit([encoder.finish()]);
        occluders
    }
}

fn top(geometry: &Geometry, placed: impl IntoIterator<Item = Placed>) -> TopLevel {
    TopLevel::build(&geometry.meshes, placed, DVec3::ZERO)
}

fn refitted(mesh: usize, world_from_mesh: Mat4, around: &[[Vec3; 3]]) -> Placed {
    let corners = || around.as_flattened().iter().copied().filter(|corner| corner.is_finite());
    let low = corners().fold(Vec3::INFINITY, Vec3::min);
    let high = corners().fold(Vec3::NEG_INFINITY, Vec3::max);
    Placed { mesh, world_from_mesh, shape: Shape::Refitted([low, high]) }
}

fn shadowed(visibility: &[f32]) -> usize {
    visibility.iter().filter(|visible| **visible < 0.5).count()
}

#[test]
fn rays_through_a_refitted_mesh_are_those_through_one_that_is_made_anew() {
    let rest = world();
    for by in [0.0, 0.05, -0.7] {
        let bent = twisted(&rest, by);
        let mut yard = Yard::of(&bent);
        let mask = Mask::of(bent.len() * 3);
        for mask in [None, Some(&mask)] {
            let geometry = build(&rest, mask, true);
            let mesh = BentMesh { mesh: 0, first_vertex: 0 };
            let occluders = yard.refitted(&geometry, &[mesh], bent.as_flattened());
            let refitted = yard.past(occluders, &top(&geometry, [refitted(0, Mat4::IDENTITY, &bent)]));
            let anew = yard.past_rigid(&build(&bent, mask, false));
            let differing = refitted.iter().zip(&anew).filter(|(a, b)| a != b).count();
            let (dark, all) = (shadowed(&anew), anew.len());
            println!("twisted by {by}: {dark} of {all} places in shadow, {differing} differ");
            assert!(dark > all / 20 && dark < all, "{dark} of {all}");
            assert_eq!(differing, 0, "twisted by {by}, {}", mask.is_some());
        }
    }
}

#[test]
fn copies_of_a_mesh_bend_each_its_own_way() {
    let rest = world();
    let (ground, boxes) = rest.split_at(800);
    let poses = [twisted(boxes, 0.1), twisted(boxes, -0.3)];
    let places = [Mat4::from_translation(Vec3::X * 3.0), Mat4::from_scale(Vec3::new(0.5, 2.0, -0.7))];
    let stands = |pose: &[[Vec3; 3]], place: &Mat4| -> Vec<[Vec3; 3]> {
        pose.iter().map(|triangle| triangle.map(|corner| place.transform_point3(corner))).collect()
    };
    let all: Vec<_> = ground.iter().copied().chain(stands(&poses[0], &places[0])).collect();
    let mut yard = Yard::of(&all);
    let mask = Mask::of(boxes.len() * 3);
    let mut geometry = build(boxes, Some(&mask), true);
    let copy = geometry.copy(0).expect("it bends");
    // The copy's vertices come first, and some that are nobody's between.
    let nobody = vec![Vec3::splat(9.0); 5];
    let vertices = [poses[1].as_flattened(), &nobody, poses[0].as_flattened()].concat();
    let second = (boxes.len() * 3 + nobody.len()) as u32;
    let bent = [BentMesh { mesh: 0, first_vertex: second }, BentMesh { mesh: copy, first_vertex: 0 }];
    let occluders = yard.refitted(&geometry, &bent, &vertices);
    let placed = [refitted(0, places[0], &poses[0]), refitted(copy, places[1], &poses[1])];
    let both = yard.past(occluders, &top(&geometry, placed));
    let anew: Vec<Vec<f32>> = poses
        .iter()
        .zip(places)
        .map(|(pose, place)| {
            let geometry = build(pose, Some(&mask), false);
            let occluders = yard.occluders(&geometry, 1);
            yard.past(occluders, &top(&geometry, [Placed::rigid(0, place)]))
        })
        .collect();
    let of_both = anew[0].iter().zip(&anew[1]).map(|(a, b)| a * b);
    let differing = both.iter().zip(of_both).filter(|(a, b)| **a != *b).count();
    let dark = [&both, &anew[0], &anew[1]].map(|visibility| shadowed(visibility));
    assert!(dark[0] > dark[1] && dark[0] > dark[2] && dark[1] > 50 && dark[2] > 50, "{dark:?}");
    assert_eq!(differing, 0, "of {} places, {dark:?}", both.len());
}

#[test]
fn vertices_that_are_nowhere_take_only_their_own_triangles_away() {
    let rest = world();
    let mut yard = Yard::of(&rest);
    let geometry = build(&rest, None, true);
    for nowhere in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, 1e35] {
        let mut bent = twisted(&rest, 0.02);
        bent.iter_mut().skip(800).step_by(7).for_each(|triangle| triangle[1].y = nowhere);
        let mesh = BentMesh { mesh: 0, first_vertex: 0 };
        let occluders = yard.refitted(&geometry, &[mesh], bent.as_flattened());
        // The box is that of what is somewhere.
        let somewhere: Vec<_> = bent.iter().copied().filter(|t| t[1].y.abs() < 1e30).collect();
        let found = yard.past(occluders, &top(&geometry, [refitted(0, Mat4::IDENTITY, &somewhere)]));
        let wanted = yard.past_rigid(&build(&somewhere, None, false));
        assert!(shadowed(&wanted) > 100, "{}", shadowed(&wanted));
        assert_eq!(found, wanted, "{nowhere}");
    }
    let bent = vec![[Vec3::NAN; 3]; rest.len()];
    let mesh = BentMesh { mesh: 0, first_vertex: 0 };
    let occluders = yard.refitted(&geometry, &[mesh], bent.as_flattened());
    let found = yard.past(occluders, &top(&geometry, [refitted(0, Mat4::IDENTITY, &rest)]));
    let without = yard.past(yard.occluders(&geometry, 1), &top(&geometry, []));
    assert_eq!(found, without, "nothing is anywhere");
}

#[test]
fn what_is_left_to_maps_casts_as_in_the_maps() {
    let world = world();
    let mut yard = Yard::of(&world);
    let by_maps = {
        let Drawn { device, queue, shadows, plan } = &mut yard.drawn;
        let _ = shadows.set_occluders(device, None).expect("none");
        shadows.upload(queue, plan).expect("its own plan");
        yard.drawn.visibility(&yard.queries)
    };
    // The ground alone is known to rays.
    let geometry = build(&world[..800], None, false);
    let around = |x: f32| [Vec3::new(-60.0, 0.0, -60.0), Vec3::new(x, 12.0, 60.0)];
    let left =
        |x: f32| Placed { mesh: 0, world_from_mesh: Mat4::IDENTITY, shape: Shape::LeftToMaps(around(x)) };
    let room = OccluderRoom { instances: 2, left_to_maps: true };
    let mut with = |left: Option<Placed>| {
        let occluders = Occluders::new(&yard.drawn.device, &yard.drawn.queue, &geometry, room).expect("room");
        let placed = [Placed::rigid(0, Mat4::IDENTITY)].into_iter().chain(left);
        yard.past(occluders, &top(&geometry, placed))
    };
    let (all, half, none) = (with(Some(left(60.0))), with(Some(left(0.0))), with(None));
    let off = all.iter().zip(&by_maps).filter(|(a, b)| (**a - **b).abs() > 0.02).count();
    assert!(off == 0, "{off} of {} places", all.len());
    let dark = [&all, &half, &none].map(|visibility| shadowed(visibility));
    assert!(dark[0] > dark[1] && dark[1] > dark[2] + 50, "{dark:?}");
}

#[test]
fn what_cannot_be_refitted_is_refused_by_name() {
    let (world, gpu) = (world(), device(wgpu::Backends::VULKAN));
    let (device, queue) = &gpu;
    let positions = buffer(device, queue, &vec![0; world.len() * 36 - 4], wgpu::BufferUsages::STORAGE);
    let refused = |geometry: &Geometry, mesh: usize, first_vertex: u32| {
        let room = OccluderRoom { instances: 1, left_to_maps: false };
        let occluders = Occluders::new(device, queue, geometry, room).expect("room");
        let bent = [BentMesh { mesh, first_vertex }];
        let binding = positions.as_entire_buffer_binding();
        occluders.with_bent(device, queue, geometry, &bent, binding).map(|_| ())
    };
    let vertices = (world.len() * 3 - 1) as u64;
    let error = |mesh| Err(ShadowError::BentMesh { mesh, vertices });
    assert_eq!(refused(&build(&world, None, false), 0, 0), error(0), "it does not bend");
    assert_eq!(refused(&build(&world, None, true), 1, 0), error(1), "there is none");
    assert_eq!(refused(&build(&world, None, true), 0, 0), error(0), "one vertex is missing");
    assert_eq!(refused(&build(&world[1..], None, true), 0, 2), Ok(()));
    assert_eq!(refused(&build(&world[1..], None, true), 0, 3), error(0), "it begins too late");
    let bent = Placed { mesh: 0, world_from_mesh: Mat4::IDENTITY, shape: Shape::LeftToMaps([Vec3::ZERO; 2]) };
    let geometry = build(&world, None, true);
    let room = OccluderRoom { instances: 1, left_to_maps: false };
    let occluders = Occluders::new(device, queue, &geometry, room).expect("room");
    let placed = occluders.place(queue, &top(&geometry, [bent]));
    assert_eq!(placed, Err(ShadowError::OccluderLeftToMaps));
}
