//! A scene at one time, as triangles that rays can be traced through.

use glam::{DVec3, Vec3, Vec3A};
use obvhs::BvhBuildParams;
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::leaf_collapser::collapse;
use obvhs::bvh2::reinsertion::ReinsertionOptimizer;
use obvhs::ploc::PlocBuilder;
use obvhs::ray::RayHit;
use umbrage_scene::{Pose, Scene};

use crate::Ray;
use crate::coverage::{SEEN, Seen};
use crate::passage::{Layer, Layers};
use crate::shadow_ray::{ShadowRay, loss};
use crate::triangles::{Triangles, normal};
use crate::unit_box::{MARGIN, UnitBox};

/// A world is all triangles of a scene at one time, in world space, with a BVH (bounding volume hierarchy) over them.
pub struct World {
    /// The triangles in the order of the BVH's leaves.
    pub(crate) triangles: Triangles,
    /// `None` where there are no triangles.
    pub(crate) bvh: Option<Bvh2>,
    /// The cube that the BVH is built in.
    pub(crate) cube: UnitBox,
}

impl std::fmt::Debug for World {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("World").field("triangles", &self.triangles().len()).finish_non_exhaustive()
    }
}

/// A hit is where a ray meets a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The distance along the ray, in multiples of its direction.
    pub distance: f64,
    /// The index of the triangle in [`World::triangles`].
    pub triangle: usize,
}

/// A leaf: a triangle, and the cube that it is seen in.
struct Leaf<'a> {
    triangle: &'a [DVec3; 3],
    cube: UnitBox,
}

impl obvhs::Boundable for Leaf<'_> {
    fn aabb(&self) -> Aabb {
        let [a, b, c] = self.triangle.map(|corner| self.cube.inside(corner));
        let margin = Vec3A::splat(MARGIN);
        Aabb { min: a.min(b).min(c) - margin, max: a.max(b).max(c) + margin }
    }
}

impl World {
    /// Makes the world of a scene in a pose, with the BVH built on all cores.
    pub fn new(scene: &Scene, pose: &Pose) -> Self {
        Self::build(Triangles::of(scene, pose))
    }

    /// Makes a world of triangles in world space that never move and cast shadows.
    pub fn of_triangles(triangles: Vec<[Vec3; 3]>) -> Self {
        Self::build(Triangles::in_world(&triangles))
    }

    /// Builds the BVH over triangles, on all cores. Triangles with coordinates that are not finite are left out.
    pub fn build(triangles: Triangles) -> Self {
        let triangles = triangles.finite();
        let cube = UnitBox::around(triangles.corners.iter().flatten());
        if triangles.corners.is_empty() {
            return Self { triangles, bvh: None, cube };
        }
        let leaves: Vec<Leaf<'_>> =
            triangles.corners.iter().map(|triangle| Leaf { triangle, cube }).collect();
        let mut bvh = bvh(&leaves);
        let order = std::mem::take(&mut bvh.primitive_indices);
        Self { triangles: triangles.in_order(order.iter().map(|i| *i as usize)), bvh: Some(bvh), cube }
    }

    /// Whether a triangle never moves.
    pub fn is_still(&self, triangle: usize) -> bool {
        self.triangles.still[triangle]
    }

    /// Whether a triangle casts shadows.
    pub fn casts(&self, triangle: usize) -> bool {
        self.triangles.casts[triangle]
    }

    /// Returns the corners of every triangle, in world space and metres.
    pub fn triangles(&self) -> &[[DVec3; 3]] {
        &self.triangles.corners
    }

    /// Finds the nearest triangle that a ray meets at a distance from `from` to below `to`, in multiples of its direction.
    pub fn first_hit(&self, ray: &Ray, from: f64, to: f64) -> Option<Hit> {
        self.first(ray, from, to, |_, _| true)
    }

    /// Whether a ray meets triangles that cast shadows and let no light through, at a distance from `from` to below `to`, in
    /// multiples of its direction.
    pub fn is_blocked(&self, ray: &Ray, from: f64, to: f64) -> bool {
        self.transmitted(ray, from, to) <= 0.0
    }

    /// Returns the share of light, 0 to 1, that triangles which cast shadows let through along a ray, at distances from `from`
    /// to below `to`, in multiples of its direction: the product of what each surface does not cover.
    pub fn transmitted(&self, ray: &Ray, from: f64, to: f64) -> f64 {
        self.past(ray, from, to, |triangle, _| self.triangles.casts[triangle])
    }

    /// The share of light that comes along a ray to a light past what casts a shadow there, from `from` metres on.
    pub(crate) fn reaching(&self, to_light: &ShadowRay, from: f64) -> f64 {
        self.past(&to_light.ray, from, to_light.end, |triangle, at| to_light.is_cast_by(self, triangle, at))
    }

    /// The nearest of what casts some shadow along a ray to a light.
    pub(crate) fn first_caster(&self, to_light: &ShadowRay) -> Option<Hit> {
        self.first(&to_light.ray, 0.0, to_light.end, |triangle, at| {
            to_light.is_cast_by(self, triangle, at) && self.coverage(&to_light.ray, triangle) > 0.0
        })
    }

    /// The nearest triangle along a ray that an eye may take for a surface, if rounding decides so.
    pub(crate) fn first_seen(&self, ray: &Ray, from: f64, to: f64) -> Option<Hit> {
        self.first(ray, from, to, |triangle, _| self.seen(ray, triangle).drawn[1] >= SEEN)
    }

    /// How much of its place a triangle covers where a ray of an eye meets it.
    pub(crate) fn seen(&self, ray: &Ray, triangle: usize) -> Seen {
        self.triangles.coverages.seen(triangle, || ray.weights(&self.triangles.corners[triangle]))
    }

    /// How much of its place a triangle covers where a ray of light meets it.
    fn coverage(&self, ray: &Ray, triangle: usize) -> f64 {
        self.triangles.coverages.at(triangle, || ray.weights(&self.triangles.corners[triangle]))
    }

    fn first(&self, ray: &Ray, from: f64, to: f64, counts: impl Fn(usize, f64) -> bool) -> Option<Hit> {
        let mut first: Option<Hit> = None;
        let walk = self.cube.walk(ray, from, to)?;
        self.bvh.as_ref()?.ray_traverse(walk.ray, &mut RayHit::none(), |_, triangle| {
            let end = first.map_or(to, |hit| hit.distance);
            let is_nearer = |d: &f64| *d >= from && *d < end && counts(triangle, *d);
            match ray.hit(&self.triangles.corners[triangle]).filter(is_nearer) {
                Some(distance) => {
                    first = Some(Hit { distance, triangle });
                    walk.walked(distance)
                }
                None => f32::INFINITY,
            }
        });
        first
    }

    /// The share that comes past all triangles that count.
    fn past(&self, ray: &Ray, from: f64, to: f64, counts: impl Fn(usize, f64) -> bool) -> f64 {
        let (Some(walk), Some(bvh)) = (self.cube.walk(ray, from, to), &self.bvh) else {
            return 1.0;
        };
        let mut layers = Layers::default();
        // The walk ends at the first triangle that covers all.
        let is_open = bvh.ray_traverse_miss(walk.ray, |_, triangle| {
            let hit = ray.hit(&self.triangles.corners[triangle]);
            match hit.filter(|distance| *distance >= from && *distance < to && counts(triangle, *distance)) {
                Some(distance) if self.is_open(ray, triangle, distance, &mut layers) => f32::INFINITY,
                Some(_) => 0.0,
                None => f32::INFINITY,
            }
        });
        if is_open { layers.share() } else { 0.0 }
    }

    /// Whether a triangle lets anything through where a ray meets it. One that lets a share through becomes one of the layers.
    fn is_open(&self, ray: &Ray, triangle: usize, distance: f64, layers: &mut Layers) -> bool {
        let Some(surface) = self.triangles.coverages.surface(triangle) else {
            return false;
        };
        let coverage = self.coverage(ray, triangle);
        if coverage <= 0.0 || coverage >= 1.0 {
            return coverage <= 0.0;
        }
        let off_plane = self.triangles.lift(triangle) + loss(self, ray.at(distance));
        let slack = off_plane / self.normal(triangle).dot(ray.direction).abs();
        layers.add(Layer { surface, distance, slack, coverage });
        true
    }

    /// Returns the unit normal of a triangle, by its winding; zero for one without area.
    pub fn normal(&self, triangle: usize) -> DVec3 {
        normal(&self.triangles.corners[triangle])
    }

    /// The largest of all coordinates, metres.
    pub(crate) fn reach(&self) -> f64 {
        self.cube.centre.abs().max_element() + self.cube.size
    }
}

/// As `obvhs::bvh2::builder::build_bvh2` does it, but for the clock that it reads: on wasm32 there is none.
fn bvh(leaves: &[Leaf<'_>]) -> Bvh2 {
    let params = BvhBuildParams::fast_build();
    let mut bvh = PlocBuilder::with_capacity(leaves.len()).build(
        params.ploc_search_distance,
        leaves,
        (0..leaves.len() as u32).collect(),
        params.sort_precision,
        params.search_depth_threshold,
    );
    ReinsertionOptimizer::default().run(&mut bvh, params.reinsertion_batch_ratio, None);
    collapse(&mut bvh, params.max_prims_per_leaf, params.collapse_traversal_cost);
    bvh
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// The oracle of the BVH: every triangle is asked.
    fn brute_force(world: &World, ray: &Ray, from: f64, to: f64) -> Option<f64> {
        let hits = world.triangles().iter().filter_map(|triangle| ray.hit(triangle));
        hits.filter(|d| *d >= from && *d < to).min_by(f64::total_cmp)
    }

    fn point(size: f32) -> impl Strategy<Value = Vec3> {
        prop::array::uniform3(-size..size).prop_map(Vec3::from_array)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(300))]

        #[test]
        fn the_bvh_answers_as_brute_force_does(
            corners in prop::collection::vec((point(1000.0), point(30.0), point(30.0)), 1..400),
            rays in prop::collection::vec((point(1500.0), point(1.0), 0.0f64..10.0), 40),
        ) {
            let world = World::of_triangles(corners.iter().map(|(a, b, c)| [*a, *a + *b, *a + *c]).collect());
            for (origin, direction, from) in rays {
                prop_assume!(direction.length() > 1e-3);
                // Half of the rays are aimed at a triangle, so that many hit.
                let aim = if from < 5.0 { direction } else { corners[0].0 - origin };
                let ray = Ray::new(origin.as_dvec3(), aim.as_dvec3());
                let by_force = brute_force(&world, &ray, from * 0.1, f64::INFINITY);
                let by_bvh = world.first_hit(&ray, from * 0.1, f64::INFINITY);
                prop_assert_eq!(by_bvh.map(|hit| hit.distance), by_force);
                prop_assert_eq!(world.is_blocked(&ray, from * 0.1, f64::INFINITY), by_force.is_some());
                // The end itself does not count, what is the least bit nearer does.
                if let Some(hit) = by_force {
                    prop_assert!(!world.is_blocked(&ray, from * 0.1, hit));
                    prop_assert!(world.is_blocked(&ray, from * 0.1, hit.next_up()));
                }
            }
        }

        #[test]
        fn the_bvh_answers_as_brute_force_does_on_the_way_to_a_point_light(
            corners in prop::collection::vec((point(20.0), point(10.0), point(10.0)), 1..40),
            light in point(25.0), origins in prop::collection::vec(point(25.0), 40),
        ) {
            let world = World::of_triangles(corners.iter().map(|(a, b, c)| [*a, *a + *b, *a + *c]).collect());
            // Half of the lights stand on a triangle.
            let (a, b, c) = corners[0];
            let position = if light.x < 0.0 { light } else { a + (b + c) / 3.0 };
            let light = crate::Light::Point { position: position.as_dvec3(), range: f64::INFINITY, near: 0.0 };
            for origin in origins {
                let to_light = ShadowRay::new(&light, origin.as_dvec3(), 1.0);
                let (ray, end) = (to_light.ray, to_light.end);
                let by_force = brute_force(&world, &ray, 0.0, end);
                prop_assert_eq!(world.first_hit(&ray, 0.0, end).map(|hit| hit.distance), by_force);
                prop_assert_eq!(world.is_blocked(&ray, 0.0, end), by_force.is_some());
                let all = 0..world.triangles().len();
                let hits = all.filter_map(|i| Some((i, ray.hit(&world.triangles()[i]).filter(|d| *d < end)?)));
                let casters = hits.filter(|(i, d)| to_light.is_cast_by(&world, *i, *d)).map(|(_, d)| d);
                let by_force = casters.min_by(f64::total_cmp);
                prop_assert_eq!(world.first_caster(&to_light).map(|hit| hit.distance), by_force);
                prop_assert_eq!(world.reaching(&to_light, 0.0) < 1.0, by_force.is_some());
            }
        }
    }

    #[test]
    fn rays_along_the_axes_graze_no_gap_in_a_flat_grid() {
        let mut triangles = Vec::new();
        for i in 0..100 {
            let (x, z) = ((i % 10) as f32 * 100.0, (i / 10) as f32 * 100.0);
            let [a, b, c, d] = [(x, z), (x + 100.0, z), (x + 100.0, z + 100.0), (x, z + 100.0)]
                .map(|(x, z)| Vec3::new(x, 0.0, z));
            triangles.extend([[a, b, c], [a, c, d]]);
        }
        let world = World::of_triangles(triangles);
        for x in 0..=1000 {
            for z in [0.0, 100.0, 250.0, 999.0, 1000.0] {
                let down = Ray::new(DVec3::new(f64::from(x), 700.0, z), DVec3::NEG_Y);
                assert_eq!(world.first_hit(&down, 0.0, 1e9).map(|hit| hit.distance), Some(700.0), "{x}, {z}");
            }
        }
    }

    #[test]
    fn an_empty_world_and_triangles_that_are_none_block_nothing() {
        let ray = Ray::new(DVec3::Y, DVec3::NEG_Y);
        for triangles in [vec![], vec![[Vec3::NAN; 3]], vec![[Vec3::ZERO; 3]]] {
            let world = World::of_triangles(triangles);
            assert!(
                !world.is_blocked(&ray, 0.0, f64::INFINITY) && world.first_hit(&ray, 0.0, 9.0).is_none(),
                "{world:?}"
            );
        }
    }
}
