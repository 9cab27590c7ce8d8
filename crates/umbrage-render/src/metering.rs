//! Which illuminance a picture of a scene is exposed for: what its lights give to the surfaces that its first camera sees.
//!
//! Some thousand points are spread over the scene's surfaces once, more of them where the camera is near. Each gets its
//! brightest light: a sun's full illuminance, since a sun is not to be dimmed for surfaces that lie askew, and a lamp's as
//! it falls on the surface. A fifth of the points, weighted by how large and somewhat by how bright they look, are
//! brighter than the answer. Shadows are not asked for, so the answer is the same whatever settings they have; and
//! neither is the camera that looks, so pictures of a scene from many sides are exposed alike.
//!
//! Space: world space, metres.

use glam::{Mat4, Vec3};
use umbrage::LightKind;
use umbrage_scene::{Camera, Instance, Lens, Mesh, Part, Pose, Scene};

use crate::exposure::WHITE;
use crate::light::FrameLight;

/// How many points there are.
const SAMPLES: usize = 4096;

/// The share of points, by weight, that are brighter than the answer: bulbs, and what is close to lamps.
const BRIGHTER: f64 = 0.2;

/// How much more a bright point weighs, as a power: 1 would be dazzled by the bulb around a lamp, and 0 would find a lamp on
/// a wide plain too dark to see.
const BRIGHTNESS_POWER: f32 = 0.4;

/// How much less a point weighs that the camera does not see.
const OUT_OF_VIEW: f32 = 0.02;

/// The camera counts as no nearer than this share of the world's size, so that what it nearly touches is not all.
const NEAREST: f32 = 0.02;

/// Red, green and blue to luminance (ITU-R BT.709).
pub(crate) const LUMINANCE: Vec3 = Vec3::new(0.2126, 0.7152, 0.0722);

/// What is exposed for where nothing shines, lux: as bright as the sun of the built-in worlds.
const NOTHING_SHINES: f32 = 3.0;

/// Points on a scene's surfaces.
#[derive(Debug)]
pub(crate) struct Meter {
    samples: Vec<Sample>,
}

#[derive(Clone, Copy, Debug)]
struct Sample {
    position: Vec3,
    /// Unit.
    normal: Vec3,
    /// How large what it stands for looks.
    weight: f32,
    /// As an illuminance that would be shown as bright, lux.
    emission: f32,
}

/// Returns the illuminance that pictures of a scene are exposed for under these lights, lux, where nothing else is asked for:
/// its own, or else what is metered.
pub fn metered_lux(scene: &Scene, lights: &[FrameLight]) -> f32 {
    let around = scene.environment.as_ref().map_or(0.0, crate::environment::lux);
    scene.exposed_for.unwrap_or_else(|| Meter::new(scene).illuminance(lights, around))
}

impl Meter {
    /// Spreads points over a scene as it is at the start.
    pub fn new(scene: &Scene) -> Self {
        let size = scene.bounds_in(&scene.pose(0.0)).size().length();
        let eye = scene.cameras.first().map(|camera| Eye::new(camera, NEAREST * size));
        let pieces = pieces(scene, eye.as_ref());
        let total: f64 = pieces.iter().map(|piece| f64::from(piece.weight)).sum();
        let mut samples = Vec::with_capacity(SAMPLES);
        let (mut piece, mut before) = (0, 0.0);
        for i in 0..SAMPLES {
            let wanted = (i as f64 + 0.5) / SAMPLES as f64 * total;
            while piece + 1 < pieces.len() && before + f64::from(pieces[piece].weight) <= wanted {
                before += f64::from(pieces[piece].weight);
                piece += 1;
            }
            if let Some(piece) = pieces.get(piece) {
                samples.extend(
                    sample(scene, piece, eye.as_ref(), i)
                        .map(|sample| Sample { weight: sample.weight / piece.weight, ..sample }),
                );
            }
        }
        Self { samples }
    }

    /// The illuminance to expose for under these lights, lux; `around` is what the whole surroundings give.
    pub fn illuminance(&self, lights: &[FrameLight], around: f32) -> f32 {
        let lux = |sample: &Sample| {
            let of_lights = lights.iter().map(|light| illuminance(light, sample)).fold(0.0, f32::max);
            of_lights.max(sample.emission).max(around)
        };
        let seen = |sample: &Sample| {
            let lux = lux(sample);
            (lux, f64::from(sample.weight) * f64::from(lux.powf(BRIGHTNESS_POWER)))
        };
        let mut seen: Vec<(f32, f64)> = self.samples.iter().map(seen).collect();
        seen.sort_unstable_by(|a, b| b.0.total_cmp(&a.0));
        let mut left = BRIGHTER * seen.iter().map(|(_, weight)| weight).sum::<f64>();
        let found = seen.iter().find(|(_, weight)| {
            left -= weight;
            left < 0.0
        });
        found.map(|(lux, _)| *lux).filter(|lux| lux.is_finite() && *lux > 0.0).unwrap_or(NOTHING_SHINES)
    }
}

/// A part of an instance, with how large it looks.
struct Piece<'a> {
    mesh: &'a Mesh,
    part: &'a Part,
    world_from_mesh: Mat4,
    weight: f32,
}

/// Every part of every instance that is seen at the start.
fn pieces<'a>(scene: &'a Scene, eye: Option<&Eye>) -> Vec<Piece<'a>> {
    let (mut pieces, pose) = (Vec::new(), scene.pose(0.0));
    for instance in scene.instances.iter().filter(|instance| instance.is_visible_in(&pose)) {
        let (mesh, world_from_mesh) = (&scene.meshes[instance.mesh], world_from_mesh(scene, instance, &pose));
        for part in &mesh.parts {
            let aabb = part.bounds.transformed(&world_from_mesh);
            let [x, y, z] = aabb.size().to_array();
            let nearest = |eye: &Eye| eye.looks(eye.position.clamp(aabb.min, aabb.max), false);
            let weight = (x * y + y * z + z * x) * eye.map_or(1.0, nearest);
            if weight.is_finite() && weight > 0.0 {
                pieces.push(Piece { mesh, part, world_from_mesh, weight });
            }
        }
    }
    pieces
}

/// Where an instance stands; one that joints bend as its first joint alone would have it, which is near enough.
fn world_from_mesh(scene: &Scene, instance: &Instance, pose: &Pose) -> Mat4 {
    let first = instance.skin.and_then(|skin| pose.joints(&scene.rig, skin).next());
    instance.world_from_mesh_in(pose) * first.unwrap_or(Mat4::IDENTITY)
}

/// A point on a part, the `i`-th of all; `None` where it lands on a triangle of no size.
fn sample(scene: &Scene, piece: &Piece<'_>, eye: Option<&Eye>, i: usize) -> Option<Sample> {
    let Piece { mesh, part, world_from_mesh, weight: _ } = piece;
    // Steps of the R3 sequence (Roberts 2018): points of neighbouring numbers lie apart.
    let step = |of: f64| ((i + 1) as f64 * of).fract();
    let triangles = part.indices.len() / 3;
    let triangle =
        ((step(0.819_172_513_396_164_4) * triangles as f64) as usize).min(triangles.checked_sub(1)?);
    let first = part.indices.start as usize + 3 * triangle;
    let corner = |k: usize| {
        let position = mesh.positions[mesh.indices[first + k] as usize];
        world_from_mesh.transform_point3(position)
    };
    let [a, b, c] = [corner(0), corner(1), corner(2)];
    // Evenly over the triangle (Osada et al. 2002, eq. 1).
    let root = (step(0.671_043_606_703_789_2) as f32).sqrt();
    let along = step(0.549_700_477_901_970_4) as f32;
    let position = a * (1.0 - root) + b * (root * (1.0 - along)) + c * (root * along);
    let across = (b - a).cross(c - a);
    let area = 0.5 * across.length();
    let weight = area * triangles as f32 * eye.map_or(1.0, |eye| eye.looks(position, true));
    let normal = across.try_normalize()?;
    let emission =
        scene.materials.get(part.material).map_or(0.0, |material| material.emission.dot(LUMINANCE));
    let emission = emission * WHITE * std::f32::consts::PI;
    (weight.is_finite() && weight > 0.0).then_some(Sample { position, normal, weight, emission })
}

/// The brightest that a light is at a point, lux.
fn illuminance(light: &FrameLight, sample: &Sample) -> f32 {
    let FrameLight { light, colour, cone: [inner, outer] } = light;
    let strength = colour.dot(LUMINANCE);
    let lamp = |position: Vec3, range: f32| {
        let toward = position - sample.position;
        let square = toward.length_squared().max(f32::MIN_POSITIVE);
        let window = (1.0 - (square / (range * range)).powi(2)).clamp(0.0, 1.0);
        strength / square * window * sample.normal.dot(toward).abs() / square.sqrt()
    };
    let lux = match light.kind() {
        LightKind::Directional { .. } => strength,
        LightKind::Point { position, range } => lamp(position, range),
        LightKind::Spot { position, direction, range, .. } => {
            let cosine = (sample.position - position).normalize_or_zero().dot(direction);
            let fade = ((cosine - outer.cos()) / (inner.cos() - outer.cos()).max(1e-3)).clamp(0.0, 1.0);
            lamp(position, range) * fade * fade
        }
    };
    if lux.is_finite() { lux } else { 0.0 }
}

/// The camera that surfaces are looked at from.
#[derive(Debug)]
struct Eye {
    position: Vec3,
    camera_from_world: Mat4,
    /// Half the height of the picture at a depth of 1, or at any where rays are parallel.
    half_height: f32,
    is_perspective: bool,
    nearest: f32,
}

impl Eye {
    fn new(camera: &Camera, nearest: f32) -> Self {
        let (half_height, is_perspective) = match camera.lens {
            Lens::Perspective { fov_y } => ((0.5 * fov_y).tan(), true),
            Lens::Orthographic { half_height } => (half_height, false),
        };
        let camera_from_world = camera.world_from_camera.inverse();
        Self { position: camera.eye(), camera_from_world, half_height, is_perspective, nearest }
    }

    /// How large a square metre at a place looks, up to a factor; less where it is out of view and that matters.
    fn looks(&self, place: Vec3, view_matters: bool) -> f32 {
        let square = place.distance_squared(self.position).max(self.nearest * self.nearest);
        let size = if self.is_perspective { 1.0 / square.max(f32::MIN_POSITIVE) } else { 1.0 };
        let seen = self.camera_from_world.transform_point3(place);
        let half = self.half_height * if self.is_perspective { -seen.z } else { 1.0 };
        // Pictures are at most about twice as wide as high.
        let is_seen = seen.z < 0.0 && seen.y.abs() <= half && seen.x.abs() <= 2.0 * half;
        if is_seen || !view_matters { size } else { OUT_OF_VIEW * size }
    }
}
