//! Do the cameras of worlds with spot and point lights see both light and shadow? Answered by brute force: a grid of
//! rays from the eye, and a ray from every light to what they hit.

use super::*;
use crate::{Aabb, Camera};

/// Rays across and down a picture of 16:9.
const GRID: [u16; 2] = [48, 27];

/// The worlds that spot and point lights light.
pub(super) const SUNLESS: [&str; 4] = ["orbit", "tutorial-room", "closed-room", "night-chessboard"];

/// The triangles of one part of one instance, in world space, in their box.
struct Piece {
    bounds: Aabb,
    triangles: Vec<[Vec3; 3]>,
}

/// Where a ray hits: the share of it, and the triangle's unit normal.
struct Hit {
    share: f32,
    normal: Vec3,
}

fn pieces(scene: &Scene) -> Vec<Piece> {
    let mut pieces = Vec::new();
    for instance in &scene.instances {
        let (mesh, at) = (&scene.meshes[instance.mesh], instance.world_from_mesh);
        for part in &mesh.parts {
            let indices = &mesh.indices[part.indices.start as usize..part.indices.end as usize];
            let corner = |i: u32| at.transform_point3(mesh.positions[i as usize]);
            let triangles: Vec<[Vec3; 3]> =
                indices.as_chunks().0.iter().map(|t: &[u32; 3]| t.map(corner)).collect();
            pieces.push(Piece { bounds: Aabb::of_points(triangles.iter().flatten().copied()), triangles });
        }
    }
    pieces
}

/// Whether the way from `from` along `way` (shares 0 to 1) meets the box.
fn meets(bounds: Aabb, from: Vec3, way: Vec3) -> bool {
    let (a, b) = ((bounds.min - from) / way, (bounds.max - from) / way);
    let (enter, leave) = (a.min(b).max_element(), a.max(b).min_element());
    enter.max(0.0) <= leave.min(1.0)
}

/// Möller and Trumbore, both sides.
fn hit([a, b, c]: [Vec3; 3], from: Vec3, way: Vec3) -> Option<Hit> {
    let (e, f) = (b - a, c - a);
    let p = way.cross(f);
    let scale = e.dot(p).recip();
    let (t, q) = (from - a, (from - a).cross(e));
    let (u, v, share) = (t.dot(p) * scale, way.dot(q) * scale, f.dot(q) * scale);
    let inside = u >= 0.0 && v >= 0.0 && u + v <= 1.0 && (0.0..=1.0).contains(&share);
    inside.then(|| Hit { share, normal: e.cross(f).normalize_or_zero() })
}

fn hits(pieces: &[Piece], from: Vec3, way: Vec3) -> impl Iterator<Item = Hit> {
    let near = pieces.iter().filter(move |piece| meets(piece.bounds, from, way));
    near.flat_map(move |piece| piece.triangles.iter().filter_map(move |t| hit(*t, from, way)))
}

fn first_hit(pieces: &[Piece], from: Vec3, way: Vec3) -> Option<Hit> {
    hits(pieces, from, way).min_by(|a, b| a.share.total_cmp(&b.share))
}

/// What a camera sees, as shares of all pixels, and how bright it is there.
#[derive(Debug, Default)]
struct Sight {
    /// At least one light gets there.
    lit: f32,
    /// At least one light would get there, if nothing stood in its way; what faces away from it does not count.
    shadowed: f32,
    /// candela / distance² of each light at each pixel that it gets to, sorted.
    lux: Vec<f32>,
}

fn sight(scene: &Scene, pieces: &[Piece], camera: &Camera) -> Sight {
    let mut sight = Sight::default();
    let share = f32::from(GRID[0] * GRID[1]).recip();
    for pixel in (0..GRID[1]).flat_map(|row| (0..GRID[0]).map(move |column| [column, row])) {
        let Some((place, normal)) = seen(pieces, camera, pixel) else { continue };
        let facing = |light: &&Light| shines_along(light, place).is_some_and(|along| along.dot(normal) < 0.0);
        let (lit, shadowed): (Vec<&Light>, Vec<&Light>) = scene
            .lights
            .iter()
            .filter(facing)
            .partition(|light| hits(pieces, place, light.position() - place).next().is_none());
        sight.lit += if lit.is_empty() { 0.0 } else { share };
        sight.shadowed += if shadowed.is_empty() { 0.0 } else { share };
        sight.lux.extend(lit.iter().map(|light| light.intensity / light.position().distance_squared(place)));
    }
    sight.lux.sort_by(f32::total_cmp);
    sight
}

/// The place behind a pixel, just above the surface, and the normal there that looks at the camera.
fn seen(pieces: &[Piece], camera: &Camera, pixel: [u16; 2]) -> Option<(Vec3, Vec3)> {
    let Lens::Perspective { fov_y } = camera.lens else { panic!("{} has perspective", camera.name) };
    let half = (fov_y * 0.5).tan();
    let [x, y] = [0, 1].map(|i| (f32::from(pixel[i]) + 0.5) / f32::from(GRID[i]) * 2.0 - 1.0);
    let ray = Vec3::new(x * half * 16.0 / 9.0, -y * half, -1.0) * camera.far;
    let way = camera.world_from_camera.transform_vector3(ray);
    let Hit { share, normal } = first_hit(pieces, camera.eye(), way)?;
    let normal = if normal.dot(way) < 0.0 { normal } else { -normal };
    // A ten-thousandth of the distance is beyond the rounding of f32.
    Some((camera.eye() + way * share + normal * (share * way.length() * 1e-4), normal))
}

fn sunless() -> impl Iterator<Item = (Scene, Vec<Piece>)> {
    SUNLESS.iter().filter_map(|name| build(name, 0)).map(|scene| {
        let pieces = pieces(&scene);
        (scene, pieces)
    })
}

#[test]
fn every_camera_of_a_world_without_sun_sees_light_and_shadow() {
    for (scene, pieces) in sunless() {
        for camera in &scene.cameras {
            let Sight { lit, shadowed, lux } = sight(&scene, &pieces, camera);
            let view = format!("{} from {}", scene.name, camera.name);
            assert!(lit >= 0.05 && shadowed >= 0.05, "{view}: {lit} lit, {shadowed} shadowed");
            let median = lux[lux.len() / 2];
            assert!((0.8..=3.5).contains(&median), "{view}: {median} lux");
        }
    }
}

#[test]
fn eyes_and_lights_of_worlds_without_sun_are_in_the_air() {
    for (scene, pieces) in sunless() {
        let reach = scene.bounds_in(&scene.pose(0.0)).size().length();
        let on_path = (0..=255).filter_map(|i: u8| scene.path.world_from_camera(f32::from(i) / 255.0));
        let eyes = scene.cameras.iter().map(|camera| camera.world_from_camera).chain(on_path);
        let lights = scene.lights.iter().map(|light| light.world_from_light);
        for place in eyes.chain(lights).map(|pose| pose.w_axis.truncate()) {
            for towards in [Vec3::new(0.1, 1.0, 0.2), Vec3::new(1.0, 0.1, -0.2), Vec3::new(-0.3, 0.2, 1.0)] {
                let inside =
                    first_hit(&pieces, place, towards * reach).is_some_and(|h| h.normal.dot(towards) > 0.0);
                assert!(!inside, "{}: {place} is inside of something", scene.name);
            }
        }
    }
}

#[test]
fn the_closed_room_is_closed() {
    let scene = closed_room::build(0);
    let (pieces, light) = (pieces(&scene), &scene.lights[0]);
    let LightKind::Point { range } = light.kind else { panic!("{light:?}") };
    for (a, b) in (0..60).flat_map(|a| (0..30).map(move |b| (a as f32 * 0.105, b as f32 * 0.105))) {
        let way = Vec3::new(a.sin() * b.sin(), b.cos(), a.cos() * b.sin()) * range;
        assert!(hits(&pieces, light.position(), way).next().is_some(), "a ray leaves along {way}");
    }
}
