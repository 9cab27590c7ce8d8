//! A second tracer, which shares nothing with the judge: it asks every triangle of a scene, by another test of its own, and
//! reads alpha by another sampler.
//!
//! Sources: Möller and Trumbore, *Fast, Minimum Storage Ray/Triangle Intersection*, 1997; bilinear interpolation as a sum of
//! tents over all pixels near.

use glam::{DVec2, DVec3};
use umbrage_judge::Light;
use umbrage_scene::{Alpha, Pose, Scene, Texture};

/// A triangle as the scene has it, in world space.
struct Triangle {
    corners: [DVec3; 3],
    uvs: [DVec2; 3],
    alphas: [f64; 3],
    instance: usize,
    material: usize,
    casts: bool,
}

/// A place where a ray meets a triangle.
#[derive(Clone, Copy, Debug)]
struct Meeting {
    distance: f64,
    coverage: f64,
    /// The instance and the material.
    surface: (usize, usize),
    normal: DVec3,
    casts: bool,
}

/// All triangles of a scene.
pub struct SecondTracer<'a> {
    scene: &'a Scene,
    triangles: Vec<Triangle>,
}

/// What the second tracer says of a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Seen {
    Sky,
    TurnedAway,
    /// The share of the light that reaches it.
    Reached(f64),
}

impl<'a> SecondTracer<'a> {
    pub fn new(scene: &'a Scene, pose: &Pose) -> Self {
        let mut triangles = Vec::new();
        for (number, instance) in scene.instances.iter().enumerate() {
            let mesh = &scene.meshes[instance.mesh];
            let world_from_mesh = instance.world_from_mesh_in(pose).as_dmat4();
            for part in &mesh.parts {
                for indices in mesh.indices[part.indices.start as usize..part.indices.end as usize].chunks(3)
                {
                    let indices = [0, 1, 2].map(|i| indices[i] as usize);
                    triangles.push(Triangle {
                        corners: indices
                            .map(|i| world_from_mesh.transform_point3(mesh.positions[i].as_dvec3())),
                        uvs: indices.map(|i| mesh.uvs[i].as_dvec2()),
                        alphas: indices
                            .map(|i| mesh.colours.get(i).map_or(1.0, |colour| f64::from(colour.w))),
                        instance: number,
                        material: part.material,
                        casts: instance.casts && scene.materials[part.material].casts,
                    });
                }
            }
        }
        Self { scene, triangles }
    }

    /// What is true of what a ray of the eye sees between two distances, by a light, and where that is.
    pub fn look(&self, origin: DVec3, direction: DVec3, [near, far]: [f64; 2], light: &Light) -> Seen {
        let meetings = self.meetings(origin, direction);
        let is_seen = |m: &&Meeting| m.distance >= near && m.distance < far && m.coverage >= 0.5;
        let Some(first) = meetings.iter().find(is_seen) else {
            return Seen::Sky;
        };
        let normal = if first.normal.dot(direction) > 0.0 { -first.normal } else { first.normal };
        let point = origin + direction * first.distance;
        let to_light = match *light {
            Light::Sun { to_light } => to_light * 1e6,
            Light::Spot { position, .. } | Light::Point { position, .. } => position - point,
        };
        if normal.dot(to_light) <= 0.0 {
            return Seen::TurnedAway;
        }
        Seen::Reached(self.reached(point + normal * 1e-5, to_light))
    }

    /// The share of light that comes along a whole vector.
    fn reached(&self, origin: DVec3, to_light: DVec3) -> f64 {
        let length = to_light.length();
        let mut counted: Vec<Meeting> = Vec::new();
        for meeting in self.meetings(origin, to_light) {
            let is_same = |other: &Meeting| {
                other.surface == meeting.surface && (other.distance - meeting.distance).abs() * length < 1e-9
            };
            if meeting.casts && meeting.distance < 1.0 && !counted.iter().any(is_same) {
                counted.push(meeting);
            }
        }
        counted.iter().map(|meeting| 1.0 - meeting.coverage).product()
    }

    /// All that a ray meets, the nearest first.
    fn meetings(&self, origin: DVec3, direction: DVec3) -> Vec<Meeting> {
        let mut meetings: Vec<Meeting> =
            self.triangles.iter().filter_map(|triangle| self.meet(triangle, origin, direction)).collect();
        meetings.sort_by(|a, b| a.distance.total_cmp(&b.distance));
        meetings
    }

    fn meet(&self, triangle: &Triangle, origin: DVec3, direction: DVec3) -> Option<Meeting> {
        let [a, b, c] = triangle.corners;
        let (ab, ac) = (b - a, c - a);
        let across = direction.cross(ac);
        let determinant = ab.dot(across);
        if determinant == 0.0 {
            return None;
        }
        let from_a = origin - a;
        let of_b = from_a.dot(across) / determinant;
        let up = from_a.cross(ab);
        let of_c = direction.dot(up) / determinant;
        let distance = ac.dot(up) / determinant;
        if of_b < 0.0 || of_c < 0.0 || of_b + of_c > 1.0 || distance < 0.0 {
            return None;
        }
        Some(Meeting {
            distance,
            coverage: self.coverage(triangle, of_b, of_c),
            surface: (triangle.instance, triangle.material),
            normal: ab.cross(ac).normalize_or_zero(),
            casts: triangle.casts,
        })
    }

    fn coverage(&self, triangle: &Triangle, of_b: f64, of_c: f64) -> f64 {
        let material = &self.scene.materials[triangle.material];
        let [a, b, c] = triangle.uvs;
        let uv = a + (b - a) * of_b + (c - a) * of_c;
        let [a, b, c] = triangle.alphas;
        let of_vertices = a + (b - a) * of_b + (c - a) * of_c;
        let of_picture = material.texture.map_or(1.0, |texture| tents(&self.scene.textures[texture], uv));
        let alpha = f64::from(material.base_colour.w) * of_vertices * of_picture;
        let covered = match material.alpha {
            Alpha::Opaque => 1.0,
            Alpha::Mask { cutoff } if alpha < f64::from(cutoff) => 0.0,
            Alpha::Mask { .. } => 1.0,
            Alpha::Blend => alpha.clamp(0.0, 1.0),
        };
        covered * (1.0 - f64::from(material.transmission))
    }
}

/// The alpha of a texture: every pixel counts by how near its centre is, on both axes.
fn tents(texture: &Texture, uv: DVec2) -> f64 {
    let tent = |centre: i64, at: f64| (1.0 - (at - (centre as f64 + 0.5)).abs()).max(0.0);
    let (x, y) = (uv.x * f64::from(texture.width), uv.y * f64::from(texture.height));
    let near = |at: f64| at as i64 - 3..at as i64 + 4;
    let mut sum = 0.0;
    for j in near(y) {
        for i in near(x) {
            let column = i.rem_euclid(i64::from(texture.width)) as usize;
            let row = j.rem_euclid(i64::from(texture.height)) as usize;
            let alpha = texture.rgba[4 * (row * texture.width as usize + column) + 3];
            sum += tent(i, x) * tent(j, y) * f64::from(alpha) / 255.0;
        }
    }
    sum
}
