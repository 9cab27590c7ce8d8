//! Triangles and worlds as bytes: so that a program which shares no memory with this one, as a web page's worker, can build
//! the BVH. They are no file format: the program that reads them must be the one that wrote them.

mod coverages;

use bytemuck::pod_collect_to_vec;
use glam::DVec3;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::node::Bvh2Node;

use crate::triangles::Triangles;
use crate::unit_box::UnitBox;
use crate::world::World;

/// The numbers of triangles and of nodes that follow, and the depth of the BVH.
type Header = [u64; 3];

const HEADER: usize = size_of::<Header>();
const CORNERS: usize = size_of::<[DVec3; 3]>();
const ROUNDING: usize = size_of::<f32>();
const NODE: usize = size_of::<Bvh2Node>();

impl Triangles {
    /// Writes the value as bytes, for [`Self::from_bytes`] of the same program.
    pub fn to_bytes(&self) -> Vec<u8> {
        joined(self, None)
    }

    /// Reads what [`Self::to_bytes`] made; `None` for any other bytes.
    pub fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let (triangles, bvh) = parted(bytes)?;
        bvh.is_none().then_some(triangles)
    }
}

impl World {
    /// Writes the value as bytes, for [`Self::from_bytes`] of the same program.
    pub fn to_bytes(&self) -> Vec<u8> {
        joined(&self.triangles, self.bvh.as_ref())
    }

    /// Reads what [`Self::to_bytes`] made; `None` for any other bytes.
    pub fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let (triangles, bvh) = parted(bytes)?;
        let nodes = bvh.as_ref().map_or(&[][..], |bvh| &bvh.nodes);
        let is_inside = |node: &Bvh2Node| {
            let (count, all) =
                if node.is_leaf() { (node.prim_count, triangles.corners.len()) } else { (2, nodes.len()) };
            u64::from(node.first_index) + u64::from(count) <= all as u64
        };
        let is_whole = nodes.is_empty() == triangles.corners.is_empty() && nodes.iter().all(is_inside);
        let cube = UnitBox::around(triangles.corners.iter().flatten());
        is_whole.then_some(Self { triangles, bvh, cube })
    }
}

fn joined(triangles: &Triangles, bvh: Option<&Bvh2>) -> Vec<u8> {
    let Triangles { corners, rounding, still, casts, coverages } = triangles;
    let nodes = bvh.map_or(&[][..], |bvh| &bvh.nodes);
    let header: Header =
        [corners.len(), nodes.len(), bvh.map_or(0, |bvh| bvh.max_depth)].map(|count| count as u64);
    let mut bytes =
        Vec::with_capacity(HEADER + corners.len() * (CORNERS + ROUNDING + 2) + nodes.len() * NODE);
    bytes.extend_from_slice(bytemuck::bytes_of(&header));
    bytes.extend_from_slice(bytemuck::cast_slice(corners));
    bytes.extend_from_slice(bytemuck::cast_slice(rounding));
    bytes.extend(still.iter().chain(casts).map(|yes| u8::from(*yes)));
    bytes.extend_from_slice(bytemuck::cast_slice(nodes));
    coverages::join(&mut bytes, coverages);
    bytes
}

/// The inverse of [`joined`].
fn parted(bytes: &[u8]) -> Option<(Triangles, Option<Bvh2>)> {
    let (header, rest) = bytes.split_first_chunk::<HEADER>()?;
    let [triangles, nodes, max_depth] =
        bytemuck::pod_read_unaligned::<Header>(header).map(|count| usize::try_from(count).ok());
    let (triangles, nodes, max_depth) = (triangles?, nodes?, max_depth?);
    let (corners, rest) = rest.split_at_checked(triangles.checked_mul(CORNERS)?)?;
    let (rounding, rest) = rest.split_at_checked(triangles.checked_mul(ROUNDING)?)?;
    let (still, rest) = rest.split_at_checked(triangles)?;
    let (casts, rest) = rest.split_at_checked(triangles)?;
    let (nodes, rest) = rest.split_at_checked(nodes.checked_mul(NODE)?)?;
    let bvh =
        (!nodes.is_empty()).then(|| Bvh2 { nodes: pod_collect_to_vec(nodes), max_depth, ..Bvh2::default() });
    let flags = |bytes: &[u8]| bytes.iter().map(|yes| *yes != 0).collect();
    let triangles = Triangles {
        corners: pod_collect_to_vec(corners),
        rounding: pod_collect_to_vec(rounding),
        still: flags(still),
        casts: flags(casts),
        coverages: coverages::part(rest, triangles)?,
    };
    Some((triangles, bvh))
}

#[cfg(test)]
mod tests {
    use glam::Vec3;
    use umbrage_scene::worlds;

    use super::*;
    use crate::Ray;

    #[test]
    fn a_world_that_was_built_elsewhere_answers_as_one_that_was_built_here() {
        let scene = worlds::build("knights", 0).expect("a world");
        let here = World::new(&scene, &umbrage_scene::Pose::at(0.5));
        let triangles =
            Triangles::from_bytes(&Triangles::of(&scene, &umbrage_scene::Pose::at(0.5)).to_bytes())
                .expect("triangles");
        assert_eq!(triangles, Triangles::of(&scene, &umbrage_scene::Pose::at(0.5)));
        let there = World::from_bytes(&World::build(triangles).to_bytes()).expect("a world");
        assert_eq!(here.triangles().len(), there.triangles().len());
        let rays = (0..2000).map(|i| {
            let (sine, cosine) = f64::from(i).sin_cos();
            Ray::new(
                DVec3::new(40.0 * sine, 1.0 + f64::from(i % 7), 40.0 * cosine),
                DVec3::new(-sine, -0.02, -cosine),
            )
        });
        let answer = |world: &World, ray: &Ray| {
            let hit = world.first_hit(ray, 0.0, 1e3)?;
            Some((hit.distance, world.triangles()[hit.triangle], world.is_still(hit.triangle)))
        };
        let mut hits = 0;
        for ray in rays {
            assert_eq!(answer(&here, &ray), answer(&there, &ray));
            hits += usize::from(answer(&here, &ray).is_some());
        }
        assert!(hits > 500, "{hits} rays hit");
    }

    #[test]
    fn bytes_that_are_none_of_ours_are_refused() {
        let world = World::of_triangles(vec![[Vec3::ZERO, Vec3::X, Vec3::Y]; 9]);
        let bytes = world.to_bytes();
        assert!(World::from_bytes(&bytes).is_some());
        for end in 0..bytes.len() {
            assert!(World::from_bytes(&bytes[..end]).is_none(), "cut at {end}");
        }
        assert!(Triangles::from_bytes(&bytes).is_none(), "a world is not triangles");
        let triangles = Triangles::in_world(&[[Vec3::ZERO, Vec3::X, Vec3::Y]; 9]);
        assert!(World::from_bytes(&triangles.to_bytes()).is_none(), "triangles are no world");
        let mut lost = bytes;
        // All of the last node's bits set: it points anywhere. No coverages follow but their counts.
        let end = lost.len() - 4 * size_of::<u64>();
        lost[end - NODE..end].fill(0xff);
        assert!(World::from_bytes(&lost).is_none(), "a node that points outside");
        let nothing = World::of_triangles(Vec::new());
        assert!(World::from_bytes(&nothing.to_bytes()).is_some_and(|world| world.triangles().is_empty()));
    }
}
