//! What surfaces look like: metal, roughness, normals, occlusion, emission, colours of vertices, and what is around.

mod common;

use common::{PIXELS, from_above, gpu, plate};
use glam::{Affine2, Vec2, Vec3, Vec4};
use umbrage_render::umbrage::Settings;
use umbrage_render::{Exposure, Frame, Gpu, Mark, Renderer, Show};
use umbrage_scene::{Environment, Light, Map, Maps, Material, Scene, Texture};

fn of(material: Material) -> Scene {
    Scene { materials: vec![material], ..plate() }
}

fn plain() -> Material {
    Material::plain("plain", 0.4, 0.2, 0.1)
}

/// The same with one picture of one pixel.
fn with_picture(rgb: [u8; 3], material: Material) -> Scene {
    let [red, green, blue] = rgb;
    let texture =
        Texture { name: "pixel".to_owned(), width: 1, height: 1, rgba: vec![red, green, blue, 255] };
    Scene { textures: vec![texture], ..of(material) }
}

const PICTURE: Map = Map { texture: 0, picture_from_uv: Affine2::IDENTITY };

/// The middle of the ground, exposed for 4 lux, under a sun of 3.
fn pixel(gpu: &Gpu, scene: &Scene) -> [u8; 3] {
    pixel_under(gpu, scene, Vec3::NEG_Y)
}

fn pixel_under(gpu: &Gpu, scene: &Scene, sun: Vec3) -> [u8; 3] {
    let frame = from_above(&Light::sun(sun, 3.0), Show::Unshadowed);
    let exposure = Exposure { stops: 0.0, lux: Some(4.0) };
    let rgba = picture(gpu, scene, &Frame { haze: false, exposure, ..frame });
    let at = 4 * (PIXELS * PIXELS / 2 + PIXELS / 2) as usize;
    [rgba[at], rgba[at + 1], rgba[at + 2]]
}

fn picture(gpu: &Gpu, scene: &Scene, frame: &Frame) -> Vec<u8> {
    let mut renderer = Renderer::new(gpu, scene, Settings::default()).expect("a renderer");
    renderer.render(frame).expect("a frame").drawn.picture().expect("a picture").rgba
}

fn sum(pixel: [u8; 3]) -> i32 {
    pixel.iter().map(|level| i32::from(*level)).sum()
}

#[test]
fn a_surface_that_only_scatters_looks_the_same_beside_one_that_shines() {
    let gpu = gpu();
    let alone = of(plain());
    let beside = Scene { materials: vec![plain(), Material { emission: Vec3::X, ..plain() }], ..of(plain()) };
    for sun in [Vec3::NEG_Y, Vec3::new(1.0, -0.6, 0.3)] {
        let (alone, beside) = (pixel_under(&gpu, &alone, sun), pixel_under(&gpu, &beside, sun));
        assert!(alone.iter().zip(beside).all(|(a, b)| a.abs_diff(b) <= 1), "{alone:?} and {beside:?}");
    }
}

#[test]
fn a_smooth_surface_mirrors_the_sun_and_a_rough_one_spreads_it() {
    let gpu = gpu();
    let shiny = |roughness| of(Material { specular: 1.0, roughness, ..plain() });
    let metal = |roughness| of(Material { metallic: 1.0, roughness, ..plain() });
    // The sun stands behind the eye: its mirror image is in the middle of the picture.
    let (smooth, rough) = (pixel(&gpu, &shiny(0.1)), pixel(&gpu, &shiny(1.0)));
    assert!(sum(smooth) > sum(rough) + 100, "{smooth:?} and {rough:?}");
    // Far from the mirror's direction a smooth metal shows the sky alone, and a rough one the sun too.
    let aside = Vec3::new(1.0, -0.5, 0.0);
    let (smooth, rough) = (pixel_under(&gpu, &metal(0.1), aside), pixel_under(&gpu, &metal(1.0), aside));
    assert!(sum(smooth) < sum(rough), "{smooth:?} and {rough:?}");
}

#[test]
fn a_rough_metal_sends_back_a_fourth_of_what_a_matte_surface_does_head_on() {
    // D = 1/π and V = 1/4 for roughness 1, seen and lit head-on: a fourth of Lambert's 1/π.
    let gpu = gpu();
    let scene = |material| {
        // Black all around, so that the sky adds nothing.
        let light = vec![[0.0; 3]; 32];
        let environment = Some(Environment { name: String::new(), width: 8, height: 4, light });
        Scene { environment, ..of(material) }
    };
    let metal = Material { metallic: 1.0, ..Material::plain("metal", 1.0, 1.0, 1.0) };
    let grey = Material::plain("grey", 0.25, 0.25, 0.25);
    let (metal, grey) = (pixel(&gpu, &scene(metal)), pixel(&gpu, &scene(grey)));
    assert!(metal.iter().zip(grey).all(|(a, b)| a.abs_diff(b) <= 2), "{metal:?} and {grey:?}");
}

#[test]
fn pictures_of_roughness_metal_occlusion_and_emission_are_factors() {
    let gpu = gpu();
    // 128 of 255 where numbers are plain, and a fifth of the light where they are sRGB.
    let half = 128.0 / 255.0;
    let rough = Material { metallic: 1.0, roughness: 0.8, ..plain() };
    let maps = Maps { metallic_roughness: Some(PICTURE), ..Maps::default() };
    let pairs = [
        (
            with_picture([9, 128, 128], Material { maps, ..rough.clone() }),
            of(Material { metallic: half, roughness: 0.8 * half, ..rough }),
        ),
        (
            with_picture(
                [128; 3],
                Material {
                    emission: Vec3::ONE,
                    maps: Maps { emission: Some(PICTURE), ..Maps::default() },
                    ..plain()
                },
            ),
            of(Material { emission: Vec3::splat(0.2159), ..plain() }),
        ),
    ];
    for (i, (by_picture, by_number)) in pairs.iter().enumerate() {
        let (a, b) = (pixel(&gpu, by_picture), pixel(&gpu, by_number));
        assert!(a.iter().zip(b).all(|(a, b)| a.abs_diff(b) <= 1), "pair {i}: {a:?} and {b:?}");
    }
    let closed = |strength| Maps { occlusion: Some((PICTURE, strength)), ..Maps::default() };
    let open = with_picture([0, 255, 255], Material { maps: closed(0.0), ..plain() });
    let shut = with_picture([0, 255, 255], Material { maps: closed(1.0), ..plain() });
    let (open, shut, none) = (pixel(&gpu, &open), pixel(&gpu, &shut), pixel(&gpu, &of(plain())));
    assert!(open.iter().zip(none).all(|(a, b)| a.abs_diff(b) <= 1), "{open:?} and {none:?}");
    assert!(sum(shut) < sum(open) && shut[0] > 20, "only what comes from around is shut out: {shut:?}");
}

#[test]
fn a_normal_map_leans_toward_its_colours() {
    let gpu = gpu();
    // The plate's texture coordinates are all 0, and without them there is no frame: give it some, u along x and v along z.
    let mapped = |rgb| {
        let maps = Maps { normal: Some((PICTURE, 1.0)), ..Maps::default() };
        let mut scene = with_picture(rgb, Material { maps, ..plain() });
        for mesh in &mut scene.meshes {
            mesh.uvs = mesh.positions.iter().map(|p| Vec2::new(p.x, p.z)).collect();
        }
        scene
    };
    // Seen from above, u to the right and v down as on a picture: red leans to +x, green to −z.
    let suns = [
        Vec3::new(-1.0, -1.0, 0.0),
        Vec3::new(1.0, -1.0, 0.0),
        Vec3::new(0.0, -1.0, 1.0),
        Vec3::new(0.0, -1.0, -1.0),
    ];
    let brightest = |rgb| {
        let scene = mapped(rgb);
        let sums = suns.map(|sun| sum(pixel_under(&gpu, &scene, sun)));
        (0..4).max_by_key(|i| sums[*i]).map(|i| (i, sums))
    };
    let toward = |rgb, want: usize| {
        let (found, sums) = brightest(rgb).expect("four suns");
        assert_eq!(found, want, "{rgb:?}: {sums:?}");
    };
    toward([210, 128, 210], 0);
    toward([46, 128, 210], 1);
    toward([128, 210, 210], 2);
    toward([128, 46, 210], 3);
    let (flat, none) = (pixel(&gpu, &mapped([128, 128, 255])), pixel(&gpu, &of(plain())));
    assert!(flat.iter().zip(none).all(|(a, b)| a.abs_diff(b) <= 1), "{flat:?} and {none:?}");
}

#[test]
fn colours_of_vertices_are_factors_in_every_shaded_picture() {
    let gpu = gpu();
    let mut coloured = of(Material::plain("white", 0.8, 0.8, 0.8));
    for mesh in &mut coloured.meshes {
        mesh.colours = vec![Vec4::new(0.5, 0.25, 0.125, 1.0); mesh.positions.len()];
    }
    let plain = of(plain());
    let sun = Light::sun(Vec3::NEG_Y, 3.0);
    for show in [Show::World, Show::Unshadowed, Show::Marked(Mark::Splits), Show::Marked(Mark::Texels)] {
        let frame = from_above(&sun, show.clone());
        let (a, b) = (picture(&gpu, &coloured, &frame), picture(&gpu, &plain, &frame));
        assert!(a.iter().zip(&b).all(|(a, b)| a.abs_diff(*b) <= 1), "{show:?}");
    }
}

#[test]
fn an_unlit_surface_shows_its_colour_whatever_shines() {
    let gpu = gpu();
    let scene = of(Material { unlit: true, ..plain() });
    // sRGB of 0.4, 0.2 and 0.1.
    for sun in [Vec3::NEG_Y, Vec3::Y] {
        assert_eq!(pixel_under(&gpu, &scene, sun), [170, 124, 89]);
    }
}

#[test]
fn visibility_is_the_same_whatever_surfaces_and_surroundings_are() {
    let gpu = gpu();
    let mut coloured = of(Material { metallic: 1.0, ..plain() });
    for mesh in &mut coloured.meshes {
        mesh.colours = vec![Vec4::ZERO; mesh.positions.len()];
    }
    let light = vec![[1.0; 3]; 32];
    coloured.environment = Some(Environment { name: String::new(), width: 8, height: 4, light });
    let sun = Light::sun(Vec3::new(0.1, -1.0, 0.1), 3.0);
    let frame = from_above(&sun, Show::Visibility(0));
    let extents = from_above(&sun, Show::Marked(Mark::Extents));
    for frame in [frame, extents] {
        assert!(picture(&gpu, &coloured, &frame) == picture(&gpu, &of(plain()), &frame), "{:?}", frame.show);
    }
}

#[test]
fn an_environment_lights_from_where_it_is_bright() {
    let gpu = gpu();
    // A red right (+X), a blue left; the ground looks up and gets both; a mirror that leans to +X shows red.
    let light = (0..64 * 32).map(|i| if i % 64 >= 32 { [4.0, 0.0, 0.0] } else { [0.0, 0.0, 4.0] }).collect();
    let environment = Some(Environment { name: String::new(), width: 64, height: 32, light });
    let off = |material| Scene { environment: environment.clone(), ..of(material) };
    let sun = Light::sun(Vec3::NEG_Y, 0.0);
    let seen = |scene: &Scene, direction: Vec3| {
        let frame = from_above(&sun, Show::World);
        let eye = Vec3::new(0.0, 3.0, 0.0);
        let camera = umbrage_scene::Camera::looking("c", eye, eye + direction, 0.5, 0.5, 100.0);
        let camera = umbrage_render::camera(&camera, 1.0).expect("a camera");
        // A luminance of 4 is 0.6 for the tone map, which keeps its colour.
        let exposure = Exposure { stops: 0.0, lux: Some(4.0 * 1.2 * std::f32::consts::PI / 0.6) };
        let rgba = picture(&gpu, scene, &Frame { camera, exposure, ..frame });
        let at = 4 * (PIXELS * PIXELS / 2 + PIXELS / 2) as usize;
        [rgba[at], rgba[at + 1], rgba[at + 2]]
    };
    let white = off(Material::plain("white", 0.8, 0.8, 0.8));
    let (right, left) = (seen(&white, Vec3::new(1.0, 0.3, 0.1)), seen(&white, Vec3::new(-1.0, 0.3, 0.1)));
    assert!(right[0] > 150 && right[2] < 100, "the sky to the right: {right:?}");
    assert!(left[2] > 150 && left[0] < 100, "the sky to the left: {left:?}");
    let [red, _, blue] = seen(&white, Vec3::new(0.01, -1.0, 0.0));
    assert!(red.abs_diff(blue) <= 3 && red > 60, "the ground gets as much of both: {red} and {blue}");
    let mirror = off(Material { metallic: 1.0, roughness: 0.05, ..Material::plain("mirror", 0.9, 0.9, 0.9) });
    let (right, left) = (seen(&mirror, Vec3::new(1.0, -0.6, 0.1)), seen(&mirror, Vec3::new(-1.0, -0.6, 0.1)));
    assert!(right[0] > 150 && right[2] < 100, "mirrored to the right: {right:?}");
    assert!(left[2] > 150 && left[0] < 100, "mirrored to the left: {left:?}");
}
