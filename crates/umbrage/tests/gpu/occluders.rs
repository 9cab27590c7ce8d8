//! Casters for rays on the device: what does not fit is refused by name, and nothing is made of it.

use glam::{DVec3, Mat4, Vec3};
use umbrage::casters::{Geometry, Mesh, Part, Placed, Shape, TopLevel};
use umbrage::{OccluderRoom, Occluders, ShadowError};

use crate::common::device_with;

/// So many triangles of one mesh.
fn geometry(triangles: u32) -> Geometry {
    let place = |i: u32| Vec3::new((i % 3) as f32, (i / 3) as f32, (i % 2) as f32);
    let positions: Vec<Vec3> = (0..3 * triangles).map(place).collect();
    let indices: Vec<u32> = (0..3 * triangles).collect();
    Geometry::build(
        &[Mesh { positions: &positions, parts: vec![Part { indices: &indices, cover: None }], bends: false }],
        &[],
    )
}

fn room(instances: usize) -> OccluderRoom {
    OccluderRoom { instances, left_to_maps: false }
}

#[test]
fn what_a_device_has_no_room_for_is_refused_by_name_with_its_bytes() {
    let most = 1 << 16;
    let (device, queue) = device_with(wgpu::Backends::VULKAN, |limits| {
        limits.max_storage_buffer_binding_size = most;
    });
    let made = |triangles, instances| Occluders::new(&device, &queue, &geometry(triangles), room(instances));
    assert!(made(100, 100).is_ok_and(|occluders| occluders.bytes() > 0));
    for (triangles, instances) in [(5000, 1), (1, 5000), (1, 1_000_000)] {
        match made(triangles, instances) {
            Err(ShadowError::OccludersTooLarge { bytes, max, .. }) => {
                assert!(bytes > max && max == most, "{bytes} of {max}");
            }
            other => panic!("{triangles} triangles, {instances} instances: {other:?}"),
        }
    }
    let (device, queue) = device_with(wgpu::Backends::VULKAN, |limits| {
        limits.max_storage_buffers_per_shader_stage = 4;
    });
    let refused = Occluders::new(&device, &queue, &geometry(1), room(1)).expect_err("too few bindings");
    assert!(matches!(refused, ShadowError::OccluderBindings { max: 4, .. }), "{refused}");
    assert!(refused.to_string().contains("set `exact` to \"off\""), "{refused}");
}

#[test]
fn a_million_instances_have_room_on_a_device_with_the_limits_of_a_browser() {
    let (device, queue) = device_with(wgpu::Backends::VULKAN, |limits| {
        let of_browsers = wgpu::Limits::default();
        limits.max_storage_buffer_binding_size = of_browsers.max_storage_buffer_binding_size;
        limits.max_buffer_size = of_browsers.max_buffer_size;
    });
    let geometry = geometry(1);
    let occluders = Occluders::new(&device, &queue, &geometry, room(1_000_000)).expect("there is room");
    let at = |i: u32| {
        Placed::rigid(0, Mat4::from_translation(Vec3::new((i % 1000) as f32, 0.0, (i / 1000) as f32)))
    };
    let top = TopLevel::build(&geometry.meshes, (0..1_000_000).map(at), DVec3::ZERO);
    occluders.place(&queue, &top).expect("all of them");
    println!("a million instances: {} MiB", occluders.bytes() >> 20);
    assert!(occluders.bytes() < 160 << 20, "{} bytes", occluders.bytes());
}

#[test]
fn more_instances_than_there_is_room_for_and_bent_ones_are_refused() {
    let (device, queue) = device_with(wgpu::Backends::VULKAN, |_| ());
    let geometry = geometry(2);
    let occluders = Occluders::new(&device, &queue, &geometry, room(3)).expect("there is room");
    let placed = |count, shape| {
        let one = Placed { shape, ..Placed::rigid(0, Mat4::IDENTITY) };
        occluders.place(&queue, &TopLevel::build(&geometry.meshes, vec![one; count], DVec3::ZERO))
    };
    assert!((0..=3).all(|count| placed(count, Shape::Rigid).is_ok()), "none to three");
    let refused = placed(4, Shape::Rigid).expect_err("one too many");
    assert!(matches!(refused, ShadowError::OccluderRoom { got: 4, max: 3 }), "{refused}");
    let refused =
        placed(1, Shape::LeftToMaps([Vec3::ZERO, Vec3::ONE])).expect_err("none was to be left to maps");
    assert!(matches!(refused, ShadowError::OccluderLeftToMaps), "{refused}");
    assert!(refused.to_string().contains("`left_to_maps: true`"), "{refused}");
}

#[test]
fn nothing_at_all_has_buffers_that_can_be_bound() {
    let (device, queue) = device_with(wgpu::Backends::VULKAN, |_| ());
    let occluders = Occluders::new(&device, &queue, &Geometry::default(), room(0)).expect("there is room");
    occluders.place(&queue, &TopLevel::build(&[], [], DVec3::ZERO)).expect("nothing stands anywhere");
    assert!(occluders.bytes() > 0);
}
