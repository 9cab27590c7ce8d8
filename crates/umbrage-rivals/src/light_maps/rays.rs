//! How much of a light reaches what each texel shows, by the judge's rays past everything that stands still.
//!
//! A texel is the mean of the points that it shows, or of the first four where these are alike. Those that the light does not shine
//! at do not count, and neither do those of a closed mesh that are turned away from it: nobody sees them from the side that is lit,
//! and their darkness would reach over the terminator into what is lit. Nor do those inside of another body that casts: what stands
//! on a ground would darken the ground around it.

use glam::DVec2;
use rayon::prelude::*;
use umbrage_judge::{Light, Triangles, World};
use umbrage_scene::{Mesh, Pose, Scene};

use super::bodies::bodies;
use super::texels::{Band, Face, Shown, Texels, faces, pattern};
use super::unwrap::Unwrapped;

/// A texel that shows nothing. Others are their visibility in 254ths, and one.
pub(super) const EMPTY: u8 = 0;

/// The number of points that a texel is the mean of where they are alike.
const FIRST: u64 = 4;

/// The number of a texel that shows so much visibility.
fn texel(visibility: f64) -> u8 {
    1 + (254.0 * visibility).round() as u8
}

/// What stands still in a scene, ready to be baked.
#[derive(Debug)]
pub(super) struct Still<'a> {
    unwrapped: &'a Unwrapped,
    triangles: Triangles,
    world: World,
    /// What is solid of it: bodies that cast, whose triangles face outward.
    bodies: World,
    /// Whether each of `triangles` is one of those.
    is_body: Vec<bool>,
    /// Where each instance's triangles begin in `triangles`.
    first: Vec<usize>,
    /// The side of each instance's triangles that is outside: 1 or −1 times their normals; 0 where its mesh is open.
    outside: Vec<f64>,
    faces: Vec<Vec<Face>>,
    pattern: Vec<DVec2>,
}

impl<'a> Still<'a> {
    /// Builds the BVH of what stands still.
    pub fn new(scene: &Scene, unwrapped: &'a Unwrapped, rays: u32) -> Self {
        let triangles = Triangles::of(scene, &Pose::default()).standing();
        let closed: Vec<bool> = scene.meshes.par_iter().map(Mesh::is_closed).collect();
        let mut count = 0;
        let (first, outside) = scene
            .instances
            .iter()
            .map(|instance| {
                let first = count;
                if !instance.is_dynamic() {
                    count += scene.meshes[instance.mesh].triangles();
                }
                let side = f64::from(instance.world_from_mesh.determinant()).signum();
                (first, if closed[instance.mesh] { side } else { 0.0 })
            })
            .unzip();
        let is_body = bodies(scene, &closed);
        Self {
            unwrapped,
            world: World::build(triangles.clone()),
            bodies: World::build(triangles.only(|i| is_body[i])),
            is_body,
            triangles,
            first,
            outside,
            faces: faces(scene, unwrapped),
            pattern: pattern(rays),
        }
    }

    /// Everything that is traced, as bytes: equal where it is the same.
    pub fn bytes(&self) -> Vec<u8> {
        let mut bytes = self.triangles.to_bytes();
        bytes.extend(self.is_body.iter().map(|is_body| u8::from(*is_body)));
        bytes
    }

    /// The rays a texel.
    pub fn rays(&self) -> u64 {
        self.pattern.len() as u64
    }

    /// Traces a band, of this number: its texels row by row, and the number of rays that count.
    pub fn trace(&self, light: &Light, (number, band): (usize, &Band)) -> (Vec<u8>, u64) {
        let texels = Texels::new(self.unwrapped, &self.faces[number], band, &self.pattern);
        let count = self.unwrapped.size[0] as usize * band.rows.len();
        let traced = (0..count).into_par_iter().with_min_len(256).map(|i| self.texel(light, texels.shown(i)));
        let (bytes, rays): (Vec<u8>, Vec<u64>) = traced.unzip();
        (bytes, rays.iter().sum())
    }

    /// The mean of what a texel shows: of all of it only where the first few points differ.
    fn texel(&self, light: &Light, shown: impl Iterator<Item = Shown>) -> (u8, u64) {
        let (mut sum, mut count) = (0.0, 0u64);
        let (mut least, mut most) = (1f64, 0f64);
        for visibility in shown.filter_map(|shown| self.visibility(light, shown)) {
            (least, most) = (least.min(visibility), most.max(visibility));
            sum += visibility;
            count += 1;
            if count == FIRST && least == most {
                break;
            }
        }
        (if count > 0 { texel(sum / count as f64) } else { EMPTY }, count)
    }

    /// How much of the light reaches a point; `None` where that is nothing to go by.
    fn visibility(&self, light: &Light, (face, weights): Shown) -> Option<f64> {
        let instance = face.placed(self.unwrapped).instance;
        let point = self.triangles.point(self.first[instance] + face.triangle as usize, weights);
        let facing = point.normal.dot(light.toward(point.position)?.direction);
        let is_nothing = point.normal.length_squared() < 0.5 || !point.position.is_finite();
        if is_nothing || facing * self.outside[instance] < 0.0 {
            return None;
        }
        let share = self.world.visibility(light, &point)?;
        (share >= 1.0 || !self.bodies.encloses(light, &point)).then_some(share)
    }
}
