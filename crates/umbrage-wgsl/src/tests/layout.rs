//! CPU and shaders lay the same fields out alike, and mean the same by their numbers.

use encase::ShaderType;
use glam::{DVec3, Vec3};
use umbrage_core::{
    Bounds, Camera, Contact, Disc, Filter, Light, NoiseSource, Projection, Settings, TransparentCasters, plan,
};

use crate::shared::fields_in_shader;
use crate::*;

fn same(text: &str, name: &str, ours: &[(&str, u64)]) {
    let ours: Vec<_> = ours.iter().map(|(field, offset)| ((*field).to_owned(), *offset)).collect();
    assert_eq!(fields_in_shader(text, name), ours, "{name}");
}

#[test]
fn shader_and_rust_agree_where_every_field_lies() {
    same(&map(), "UmbrageView", &frame::View::fields());
    same(&map(), "UmbrageLight", &frame::FrameLight::fields());
    same(&map(), "UmbrageFrame", &frame::Frame::fields());
}

#[test]
fn shader_and_rust_agree_where_every_field_of_the_contact_camera_lies() {
    let receiver = receiver(&ShaderKey::new(&Settings::default(), TextureSupport::ALL), 1);
    let text = receiver + &contact(&Contact::default(), 3);
    same(&text, "UmbrageContactCamera", &contact_camera::Seen::fields());
    assert_eq!(contact_camera::Seen::min_size().get(), CONTACT_CAMERA_BYTES as u64);
}

#[test]
fn a_picture_is_as_high_wherever_in_it_the_direction_of_view_lies() {
    let from = |target| {
        Camera::looking(
            DVec3::new(3.0, 2.0, 1.0).as_vec3(),
            target,
            Vec3::Y,
            Projection::Perspective { fov_y: 1.2, aspect: 1.5 },
            0.5,
            80.0,
        )
        .unwrap()
    };
    let camera = from(Vec3::new(-4.0, 1.0, -9.0));
    let wanted = 2.0 * 0.6f32.tan();
    for centre in [[0.0, 0.0], [0.3, -0.7], [-0.9, 0.5]] {
        let bytes = contact_camera(&camera.with_centre(centre).unwrap());
        let field =
            contact_camera::Seen::fields().into_iter().find(|(name, _)| *name == "picture_height").unwrap();
        let at = field.1 as usize;
        let height = f32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
        assert!((height - wanted).abs() < 1e-5, "{height} m at {centre:?}, wanted {wanted} m");
    }
}

#[test]
fn shader_and_rust_agree_where_every_field_of_the_looks_lies() {
    same(&samples(), "UmbrageLook", &looks::Look::fields());
    same(&samples(), "UmbrageLooks", &looks::Looks::fields());
    same(&samples(), "UmbrageAxis", &looks::Axis::fields());
    same(&samples(), "UmbrageChoice", &looks::Choice::fields());
    same(&samples(), "UmbrageChoices", &looks::Choices::fields());
    assert_eq!(u64::from(constant(&samples(), "UMBRAGE_SEEN")), looks::SEEN);
    assert_eq!(constant(&samples(), "UMBRAGE_RUNGS_AN_OCTAVE"), umbrage_core::RUNGS_AN_OCTAVE);
}

/// The value of a constant of a text.
fn constant(text: &str, name: &str) -> u32 {
    let module = naga::front::wgsl::parse_str(text).unwrap();
    let (_, constant) = module.constants.iter().find(|(_, c)| c.name.as_deref() == Some(name)).unwrap();
    match module.global_expressions[constant.init] {
        naga::Expression::Literal(naga::Literal::U32(value)) => value,
        naga::Expression::Literal(naga::Literal::I32(value)) => value as u32,
        ref other => panic!("{name} is {other:?}"),
    }
}

#[test]
fn kinds_of_lights_shades_noises_and_casters_have_the_numbers_that_shaders_know_them_by() {
    let place = Vec3::ZERO;
    for (light, name) in [
        (Light::directional(Vec3::NEG_Y), "UMBRAGE_LIGHT_SUN"),
        (Light::spot(place, Vec3::NEG_Y, 0.5, 9.0), "UMBRAGE_LIGHT_SPOT"),
        (Light::point(place, 9.0), "UMBRAGE_LIGHT_POINT"),
    ] {
        assert_eq!(frame::kind_number(light.unwrap().kind()), constant(&map(), name), "{name}");
    }
    let key = |noise| {
        let filter = Filter::Vogel(Disc { noise, ..Disc::default() });
        ShaderKey::new(&Settings { filter, ..Settings::default() }, TextureSupport::ALL)
    };
    for (noise, name) in [
        (NoiseSource::Screen, "UMBRAGE_NOISE_SCREEN"),
        (NoiseSource::World, "UMBRAGE_NOISE_WORLD"),
        (NoiseSource::None, "UMBRAGE_NOISE_NONE"),
    ] {
        let text = receiver(&key(noise), 0);
        assert_eq!(constant(&text, "UMBRAGE_NOISE"), constant(&text, name), "{name}");
    }
    let text = receiver(&key(NoiseSource::None), 0);
    assert_eq!(frame::ABSENCE, constant(&text, "UMBRAGE_SHADE_ABSENCE"));
    assert_eq!(frame::COLOUR, constant(&text, "UMBRAGE_SHADE_COLOUR"));
    for (casters, name) in [
        (TransparentCasters::Dither, "UMBRAGE_TRANSPARENT_DITHER"),
        (TransparentCasters::Solid, "UMBRAGE_TRANSPARENT_SOLID"),
        (TransparentCasters::None, "UMBRAGE_TRANSPARENT_NONE"),
    ] {
        assert_eq!(frame::transparent_number(casters), constant(&caster(0), name), "{name}");
    }
}

#[test]
fn frames_after_the_first_are_written_into_the_bytes_of_the_first() {
    let settings = Settings::default();
    let projection = Projection::Perspective { fov_y: 1.0, aspect: 1.5 };
    let camera = Camera::looking(Vec3::ONE, Vec3::ZERO, Vec3::Y, projection, 0.5, 60.0).unwrap();
    let bounds = Bounds::of_world(Vec3::splat(-9.0), Vec3::splat(9.0));
    let lights = [Light::directional(Vec3::new(0.1, -1.0, 0.2)).unwrap()];
    let plan = plan(&camera, &lights, &bounds, &settings).unwrap();
    let mut bytes = FrameBytes::default();
    let mut write = || {
        let surroundings =
            Surroundings { map_size: [1024; 2], picture_size: [640, 360], origin: DVec3::ZERO };
        let written = bytes.write(&plan, &settings, &surroundings);
        (written.as_ptr(), written.len())
    };
    let first = write();
    assert_eq!(first.1 as u64, FrameBytes::size(4));
    assert_eq!([write(), write()], [first; 2]);
}
