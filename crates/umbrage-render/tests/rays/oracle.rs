//! What comes through all triangles of a scene, one after the other, in f64. It shares nothing with what it judges but the scene.

use glam::{DMat4, DVec2, DVec3, DVec4, Vec4Swizzles as _};
use umbrage_scene::{Alpha, Light, LightKind, Material, Scene, Texture};

/// Rays that pass nearer to an edge than so many metres are left out.
const UNSURE_EDGE: f64 = 2e-4;

/// So are those that a triangle holds whose receiver or lamp is nearer to its plane than so many metres: rays take no triangle
/// that rounding may have moved past them, which is four parts in a million of the way from the frame's origin, and more where an
/// instance is stretched.
const UNSURE_PLANE: f64 = 3e-3;

/// Alpha that is so near to a mask's cut-off leaves it open whether the mask covers.
const UNSURE_ALPHA: f64 = 0.01;

/// A corner: its place in the world, where on the picture it is, and its alpha.
#[derive(Clone, Copy)]
struct Corner {
    place: DVec3,
    uv: DVec2,
    alpha: f64,
}

/// All triangles of a scene that cast.
pub struct World<'a> {
    triangles: Vec<([Corner; 3], &'a Material, Option<&'a Texture>)>,
}

/// The unit direction to a light, and the way to where nothing casts any more.
pub fn to_light(light: &Light, place: DVec3) -> (DVec3, f64) {
    match light.kind {
        LightKind::Directional => (-light.direction().as_dvec3().normalize_or(DVec3::Y), f64::INFINITY),
        LightKind::Spot { .. } | LightKind::Point { .. } => {
            let way = light.position().as_dvec3() - place;
            let toward = way.normalize_or(DVec3::Y);
            // The near distance of a point light bounds a cube; spots have none here.
            (toward, way.length() - f64::from(light.near) / toward.abs().max_element())
        }
    }
}

/// Whether a light shines on a place: where it does not, nobody asks for its shadows.
pub fn shines_on(light: &Light, place: DVec3) -> bool {
    let LightKind::Spot { outer, .. } = light.kind else { return true };
    let (toward, _) = to_light(light, place);
    -toward.dot(light.direction().as_dvec3().normalize_or(DVec3::Y)) > f64::from(outer).cos()
}

impl<'a> World<'a> {
    pub fn of(scene: &'a Scene) -> Self {
        let mut triangles = Vec::new();
        for instance in scene.instances.iter().filter(|instance| instance.casts) {
            let mesh = &scene.meshes[instance.mesh];
            let world_from_mesh =
                DMat4::from_cols_array(&instance.world_from_mesh.to_cols_array().map(f64::from));
            let corner = |index: &u32| {
                let i = *index as usize;
                let place: DVec4 = world_from_mesh * mesh.positions[i].as_dvec3().extend(1.0);
                let alpha = mesh.colours.get(i).map_or(1.0, |colour| f64::from(colour.w));
                Corner { place: place.xyz(), uv: mesh.uvs[i].as_dvec2(), alpha }
            };
            for part in &mesh.parts {
                let material = &scene.materials[part.material];
                let texture = material.texture.map(|texture| &scene.textures[texture]);
                let indices = &mesh.indices[part.indices.start as usize..part.indices.end as usize];
                let corners =
                    indices.chunks_exact(3).map(|of| [corner(&of[0]), corner(&of[1]), corner(&of[2])]);
                triangles.extend(corners.map(|corners| (corners, material, texture)));
            }
        }
        Self { triangles }
    }

    /// The share of a light that comes to a place; `None` where rounding may decide.
    pub fn share(&self, light: &Light, place: DVec3) -> Option<f64> {
        let (toward, end) = to_light(light, place);
        let mut share = 1.0;
        for (corners, material, texture) in &self.triangles {
            share *= 1.0 - covered(corners, material, *texture, (place, toward, end))?;
        }
        Some(share)
    }
}

/// How much of a ray one triangle takes; `None` where rounding may decide.
fn covered(
    corners: &[Corner; 3],
    material: &Material,
    texture: Option<&Texture>,
    (origin, toward, end): (DVec3, DVec3, f64),
) -> Option<f64> {
    let right = toward.any_orthonormal_vector();
    let up = toward.cross(right);
    let [a, b, c] = corners.map(|corner| corner.place - origin);
    let across = |of: DVec3| DVec2::new(of.dot(right), of.dot(up));
    let (p, q, r) = (across(a), across(b), across(c));
    let from_edges = [(p, q), (q, r), (r, p)].map(|(from, to)| distance_to_segment(from, to));
    let normal = (b - a).cross(c - a).normalize_or(DVec3::Y);
    if from_edges.into_iter().any(|metres| metres < UNSURE_EDGE) {
        // Behind the receiver and beyond the lamp it does not matter.
        let along = [a, b, c].map(|of| of.dot(toward));
        let is_between =
            along.iter().any(|d| *d > -UNSURE_PLANE) && along.iter().any(|d| *d < end + UNSURE_PLANE);
        return if is_between { None } else { Some(0.0) };
    }
    let area = p.perp_dot(q) + q.perp_dot(r) + r.perp_dot(p);
    let weights = [q.perp_dot(r) / area, r.perp_dot(p) / area, p.perp_dot(q) / area];
    if weights.iter().any(|weight| *weight < 0.0) {
        return Some(0.0);
    }
    let way = a.dot(normal) / toward.dot(normal);
    let off_plane = [way, way - end].map(|metres| metres * toward.dot(normal));
    if off_plane.into_iter().any(|metres: f64| metres.abs() < UNSURE_PLANE) {
        return None;
    }
    if way < 0.0 || way > end {
        return Some(0.0);
    }
    let mean = |of: fn(&Corner) -> DVec2| -> DVec2 { (0..3).map(|i| weights[i] * of(&corners[i])).sum() };
    let alpha: f64 = (0..3).map(|i| weights[i] * corners[i].alpha).sum();
    let pixel = texture.map_or(1.0, |texture| bilinear(texture, mean(|corner| corner.uv)));
    let alpha = f64::from(material.base_colour.w) * pixel * alpha;
    let covers = match material.alpha {
        Alpha::Opaque => 1.0,
        Alpha::Blend => alpha.clamp(0.0, 1.0),
        Alpha::Mask { cutoff } if (alpha - f64::from(cutoff)).abs() < UNSURE_ALPHA => return None,
        Alpha::Mask { cutoff } => f64::from(u8::from(alpha >= f64::from(cutoff))),
    };
    Some(covers * (1.0 - f64::from(material.transmission)))
}

/// How far a piece of a line is from the origin.
fn distance_to_segment(from: DVec2, to: DVec2) -> f64 {
    let along = to - from;
    let share = (-from.dot(along) / along.length_squared()).clamp(0.0, 1.0);
    (from + share * along).length()
}

/// The alpha of a picture that repeats, between the four pixels around a place.
fn bilinear(texture: &Texture, uv: DVec2) -> f64 {
    let (width, height) = (i64::from(texture.width), i64::from(texture.height));
    let (x, y) = (uv.x * width as f64 - 0.5, uv.y * height as f64 - 0.5);
    let alpha = |x: i64, y: i64| {
        let pixel = y.rem_euclid(height) * width + x.rem_euclid(width);
        f64::from(texture.rgba[4 * pixel as usize + 3]) / 255.0
    };
    let (left, above, right, below) = (x.floor(), y.floor(), x - x.floor(), y - y.floor());
    let row = |y: i64| alpha(left as i64, y) * (1.0 - right) + alpha(left as i64 + 1, y) * right;
    row(above as i64) * (1.0 - below) + row(above as i64 + 1) * below
}
