//! Worlds of closed meshes, drawn by a family of shadows and judged.

#![allow(dead_code, reason = "each test file uses its own share")]

pub mod site;

use std::sync::Arc;

use glam::{Mat4, Vec2, Vec3};
use umbrage_judge::{Eye, Light as Shining, Pixel, Tally, Truth, World};
use umbrage_render::Gpu;
use umbrage_rivals::{Family, Left, Seen, View};
use umbrage_scene::{Camera, Instance, Light, Material, Mesh, Pose, Primitive, Scene};

/// The size of the pictures, pixels.
pub const SIZE: [u32; 2] = [320, 180];

/// A device.
pub fn gpu() -> Gpu {
    Gpu::new(None).expect("an adapter")
}

/// A device that is less than the adapter can be.
pub fn small_gpu(change: impl FnOnce(&mut wgpu::DeviceDescriptor<'_>)) -> Gpu {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let adapter = pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default()));
    let adapter = adapter.expect("an adapter");
    let mut descriptor = Gpu::wanted_device(&adapter);
    change(&mut descriptor);
    let (device, queue) = pollster::block_on(adapter.request_device(&descriptor)).expect("a device");
    Gpu::of_device(&adapter, device, queue)
}

fn primitive(positions: Vec<Vec3>, indices: Vec<u32>) -> Primitive {
    let vertices = positions.len();
    Primitive {
        positions,
        normals: vec![Vec3::Y; vertices],
        uvs: vec![Vec2::ZERO; vertices],
        indices,
        ..Primitive::default()
    }
}

/// A cube from −1 to 1, each side of which has its own corners.
pub fn cube() -> Mesh {
    Mesh::new("cube", &[sides()])
}

/// The sides of that cube.
pub fn sides() -> Primitive {
    let (mut positions, mut normals, mut indices) = (Vec::new(), Vec::new(), Vec::new());
    for axis in [Vec3::X, Vec3::Y, Vec3::Z] {
        for out in [axis, -axis] {
            let right = Vec3::new(out.y, out.z, out.x);
            let up = out.cross(right);
            let first = positions.len() as u32;
            positions.extend([out - right - up, out + right - up, out + right + up, out - right + up]);
            normals.extend([out; 4]);
            indices.extend([0, 1, 2, 0, 2, 3].map(|i| first + i));
        }
    }
    Primitive { normals, ..primitive(positions, indices) }
}

/// A ring about the y axis, of radius 1, and 0.3 thick from its middle.
pub fn ring() -> Mesh {
    const AROUND: u32 = 48;
    const ACROSS: u32 = 24;
    let place = |i: u32, j: u32| {
        let (sine, cosine) = (i as f32 / AROUND as f32 * std::f32::consts::TAU).sin_cos();
        let (up, out) = (j as f32 / ACROSS as f32 * std::f32::consts::TAU).sin_cos();
        Vec3::new(cosine * (1.0 + 0.3 * out), 0.3 * up, sine * (1.0 + 0.3 * out))
    };
    let positions = (0..AROUND).flat_map(|i| (0..ACROSS).map(move |j| place(i, j))).collect();
    let vertex = |i: u32, j: u32| (i % AROUND) * ACROSS + j % ACROSS;
    let quad = |i: u32, j: u32| {
        let [a, b, c, d] = [vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1), vertex(i + 1, j)];
        [a, b, c, a, c, d]
    };
    let indices = (0..AROUND).flat_map(|i| (0..ACROSS).flat_map(move |j| quad(i, j))).collect();
    Mesh::new("ring", &[primitive(positions, indices)])
}

/// A ball of radius 1, but for its triangles.
pub fn ball() -> Mesh {
    const AROUND: u32 = 96;
    const DOWN: u32 = 48;
    let place = |i: u32, j: u32| {
        let (sine, cosine) = ((i % AROUND) as f32 / AROUND as f32 * std::f32::consts::TAU).sin_cos();
        let (out, up) = (j as f32 / DOWN as f32 * std::f32::consts::PI).sin_cos();
        Vec3::new(cosine * out, up, sine * out)
    };
    let vertex = |i: u32, j: u32| j * AROUND + i % AROUND;
    let positions = (0..=DOWN).flat_map(|j| (0..AROUND).map(move |i| place(i, j))).collect();
    let quad = |i: u32, j: u32| {
        let [a, b, c, d] = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
        [a, b, c, a, c, d]
    };
    let indices = (0..DOWN).flat_map(|j| (0..AROUND).flat_map(move |i| quad(i, j))).collect();
    Mesh::new("ball", &[primitive(positions, indices)])
}

/// A square from −1 to 1 in the xz plane, which faces up: an open mesh.
pub fn square() -> Mesh {
    Mesh::new("square", &[flat(0.0)])
}

/// Such a square at a height.
pub fn flat(height: f32) -> Primitive {
    let corners = [(-1.0, -1.0), (-1.0, 1.0), (1.0, 1.0), (1.0, -1.0)];
    let positions = corners.map(|(x, z)| Vec3::new(x, height, z)).to_vec();
    primitive(positions, vec![0, 1, 2, 0, 2, 3])
}

/// A world of some instances: of mesh 0, a cube, 1, a ring, 2, a square, and 3, a ball.
pub fn scene(instances: Vec<Instance>) -> Scene {
    Scene {
        name: "test".to_owned(),
        meshes: vec![cube(), ring(), square(), ball()],
        instances,
        materials: vec![Material::plain("grey", 0.5, 0.5, 0.5)],
        ..Scene::default()
    }
}

pub fn at(mesh: usize, x: f32, y: f32, z: f32) -> Instance {
    Instance::still(mesh, Mat4::from_translation(Vec3::new(x, y, z)))
}

/// A flat box of 20 m a side whose upper side is at height 0.
pub fn ground() -> Instance {
    let place = Mat4::from_translation(Vec3::new(0.0, -0.5, 0.0));
    Instance::still(0, place * Mat4::from_scale(Vec3::new(20.0, 0.5, 20.0)))
}

/// Some cubes and rings over a ground.
pub fn court() -> Scene {
    let leaning = Mat4::from_translation(Vec3::new(2.0, 2.5, -1.0)) * Mat4::from_rotation_x(0.7);
    scene(vec![
        ground(),
        at(0, -2.0, 1.5, 0.0),
        Instance::still(1, leaning),
        at(1, 0.0, 0.4, 3.0),
        at(0, 5.0, 1.0, -4.0),
    ])
}

pub fn camera(eye: Vec3, target: Vec3) -> Camera {
    Camera::looking("c", eye, target, 1.0, 0.1, 200.0)
}

pub fn above() -> Camera {
    camera(Vec3::new(4.0, 5.0, 9.0), Vec3::new(0.0, 0.5, 0.0))
}

pub fn sun() -> Light {
    Light::sun(Vec3::new(0.5, -1.0, -0.3), 1e5)
}

pub fn spot() -> Light {
    Light::spot("spot", Vec3::new(-3.0, 8.0, 4.0), Vec3::new(0.5, 0.0, 0.0), 0.4, 0.6, 40.0, 1e4)
}

pub fn point() -> Light {
    Light::point("point", Vec3::new(0.3, 4.5, 1.0), 60.0, 1e4)
}

/// What a family says of a scene, and what is true where only what it serves casts.
pub struct Judged {
    pub seen: Seen,
    pub left: Vec<Left>,
    pub truths: Vec<Truth>,
    pub pixels: Vec<Vec<Pixel>>,
}

/// Draws and judges.
pub fn judge(family: Family, scene: &Scene, camera: &Camera, lights: &[Light], seconds: f32) -> Judged {
    judge_on(&gpu(), family, scene, camera, lights, seconds)
}

/// Draws on a device, and judges.
pub fn judge_on(
    gpu: &Gpu,
    family: Family,
    scene: &Scene,
    camera: &Camera,
    lights: &[Light],
    seconds: f32,
) -> Judged {
    let mut rival = family.ready(gpu, scene).expect("a small scene");
    let pose = Arc::new(Pose::at(seconds));
    let seen = rival.see(&View { camera, lights, pose: &pose, size: SIZE }).expect("a good view");
    let truths: Vec<Truth> =
        lights.iter().map(|light| truth(scene, rival.left(), camera, light, &pose)).collect();
    let pixels = truths.iter().map(|truth| truth.pixels.clone()).collect();
    Judged { seen, left: rival.left().to_vec(), truths, pixels }
}

/// What is true of a light in a world in which what is left casts nothing.
pub fn truth(scene: &Scene, left: &[Left], camera: &Camera, light: &Light, pose: &Pose) -> Truth {
    let [served, _] = Left::split(scene, left);
    let eye = Eye::new(camera, SIZE[0], SIZE[1]);
    Truth::new(&World::new(&served, pose), &eye, &Shining::at(light, pose), f64::INFINITY)
}

/// How wrong what was seen of a light is where it is known.
pub fn tally(pixels: &[Pixel], seen: &[Option<f32>]) -> Tally {
    let mut tally = Tally::default();
    for (pixel, seen) in pixels.iter().zip(seen) {
        seen.iter().for_each(|seen| tally.count(Some(*pixel), *seen));
    }
    tally
}

/// The pixel at which a point of the world is seen, by the first light.
pub fn pixel_at(camera: &Camera, seen: &Seen, point: Vec3) -> Option<f32> {
    let (x, y, _) = Eye::new(camera, SIZE[0], SIZE[1]).project(point.as_dvec3()).expect("in sight");
    seen.visibility[0][y as usize * SIZE[0] as usize + x as usize]
}

/// The most pixels that may be wrong, of those that are judged.
pub const MOST: f64 = 2e-4;

impl Judged {
    /// The share of the judged pixels of a light of which something is said that are wrong, the number of those that are
    /// judged, and the share of these that are in shadow.
    pub fn wrong(&self, light: usize) -> (f64, usize, f64) {
        let (pixels, seen) = (&self.pixels[light], &self.seen.visibility[light]);
        let tally = tally(pixels, seen);
        let is_shadowed = |(pixel, seen): &(&Pixel, &Option<f32>)| {
            seen.is_some() && pixel.visibility().is_some_and(|visibility| visibility < 0.5)
        };
        let shadowed = pixels.iter().zip(seen).filter(is_shadowed).count();
        let share = shadowed as f64 / f64::from(tally.judged.max(1) as u32);
        (tally.mis_shadowed(), tally.judged, share)
    }

    /// Fails where more than [`MOST`] of a light's judged pixels are wrong, or too few are judged or in shadow to tell. With
    /// `PICTURES` set to a folder it leaves pictures there.
    pub fn agrees(&self, name: &str, lights: &[Light]) {
        for (number, light) in lights.iter().enumerate() {
            if let Ok(folder) = std::env::var("PICTURES") {
                self.save(number, &format!("{folder}/{}-{}.png", name.replace([' ', ','], "-"), light.name));
            }
            let (wrong, pixels, shadowed) = self.wrong(number);
            println!("{name}, {}: {wrong:.6} of {pixels} wrong, {shadowed:.3} in shadow", light.name);
            assert!(pixels > 1000, "{name}: only {pixels} judged");
            assert!(shadowed > 0.005, "{name}: {shadowed} in shadow");
            assert!(wrong <= MOST, "{name}, {}: {wrong} of {pixels} are wrong", light.name);
        }
    }

    /// The number of pixels of a light of which nothing is said.
    pub fn unknown(&self, light: usize) -> usize {
        self.seen.visibility[light].iter().filter(|seen| seen.is_none()).count()
    }

    /// Writes what was said as a picture, for eyes: unknown pixels are blue, wrong ones red.
    pub fn save(&self, light: usize, name: &str) {
        let mut picture = image::RgbImage::new(SIZE[0], SIZE[1]);
        let pixels = self.pixels[light].iter().zip(&self.seen.visibility[light]);
        for (pixel, (truth, seen)) in picture.pixels_mut().zip(pixels) {
            let grey = seen.map(|seen| (seen * 255.0) as u8);
            pixel.0 = match (grey, truth.visibility()) {
                (None, _) => [0, 0, 160],
                (Some(grey), Some(truth)) if (truth < 0.5) != (grey < 128) => [255, grey / 2, 0],
                (Some(grey), Some(_)) => [grey; 3],
                (Some(grey), None) => [grey / 2, grey / 2 + 60, grey / 2],
            };
        }
        picture.save(name).expect("a writable folder");
    }
}
