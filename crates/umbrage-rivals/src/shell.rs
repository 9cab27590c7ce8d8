//! A mesh by its edges: each has a triangle on its left, and mostly one on its right.
//!
//! Where more than two triangles meet at an edge, as where two boxes share one, they are paired. Half of them have it on their
//! left where the mesh is closed, and any pairing gives the same shadows.

use glam::{DVec3, Vec3};
use umbrage_scene::{Aabb, WeldedMesh};

/// A mesh in one piece, with edges.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Shell {
    /// The positions of its vertices less its origin.
    pub positions: Vec<[f32; 3]>,
    /// The vertices of its triangles, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// The two vertices of each edge; the triangle left of the way from one to the other seen from outside, and the one right
    /// of it, or [`NOTHING`].
    pub edges: Vec<[u32; 4]>,
    /// What its positions are counted from, in mesh space.
    pub origin: [f32; 3],
    /// The box around it, counted from its origin.
    pub bounds: Aabb,
    /// Whether it encloses something, and faces outward.
    pub closed: bool,
}

/// Right of the edges where an open mesh ends.
pub(crate) const NOTHING: u32 = u32::MAX;

impl Shell {
    pub fn of(mesh: WeldedMesh) -> Self {
        let WeldedMesh { positions, triangles, closed } = mesh;
        let origin = origin(&positions);
        let relative = |place: &[f32; 3]| std::array::from_fn(|i| place[i] - origin[i]);
        let positions: Vec<[f32; 3]> = positions.iter().map(relative).collect();
        let bounds = Aabb::of_points(positions.iter().map(|place| Vec3::from(*place)));
        let edges = edges(&triangles);
        Self { positions, triangles, edges, origin, bounds, closed }
    }

    /// The distance of a point, counted from the origin, from the box around the shell; 0 inside.
    pub fn distance(&self, point: DVec3) -> f64 {
        point.distance(point.clamp(self.bounds.min.as_dvec3(), self.bounds.max.as_dvec3()))
    }

    /// The corners of the box around the shell, counted from the origin.
    pub fn corners(&self) -> [DVec3; 8] {
        let [min, max] = [self.bounds.min.as_dvec3(), self.bounds.max.as_dvec3()];
        let pick = |corner: usize, axis: usize| if corner >> axis & 1 == 1 { max[axis] } else { min[axis] };
        std::array::from_fn(|corner| DVec3::from_array(std::array::from_fn(|axis| pick(corner, axis))))
    }

    /// Whether a point, counted from the origin, is inside of a closed mesh: the triangles then fill the whole sphere around it.
    ///
    /// Source: A. Van Oosterom, J. Strackee, *The Solid Angle of a Plane Triangle*, IEEE Transactions on Biomedical
    /// Engineering 30(2), 1983, equation 8.
    pub fn holds(&self, point: DVec3) -> bool {
        if self.distance(point) > 0.0 {
            return false;
        }
        let from_point = |vertex: &u32| DVec3::from(self.positions[*vertex as usize].map(f64::from)) - point;
        let half_angle = |[a, b, c]: &[u32; 3]| {
            let [a, b, c] = [a, b, c].map(from_point);
            let [x, y, z] = [a, b, c].map(DVec3::length);
            a.dot(b.cross(c)).atan2(x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y)
        };
        // Half of 4π and of 0; whichever is nearer.
        self.triangles.iter().map(half_angle).sum::<f64>() > std::f64::consts::PI
    }
}

/// Where a mesh begins that lies far from the origin of its space, so that its numbers are small; the origin itself otherwise,
/// which keeps them exact.
fn origin(positions: &[[f32; 3]]) -> [f32; 3] {
    std::array::from_fn(|axis| {
        let values = || positions.iter().map(|place| place[axis]);
        let (low, high) =
            (values().fold(f32::INFINITY, f32::min), values().fold(f32::NEG_INFINITY, f32::max));
        let middle = 0.5 * (low + high);
        if middle.is_finite() && middle.abs() > 8.0 * (high - low) { middle } else { 0.0 }
    })
}

/// Every edge of a mesh, once.
fn edges(triangles: &[[u32; 3]]) -> Vec<[u32; 4]> {
    // Both directions of an edge lie together: first those from the smaller vertex to the larger.
    let mut halves: Vec<([u32; 2], bool, u32)> = Vec::with_capacity(3 * triangles.len());
    for (number, [a, b, c]) in (0..).zip(triangles) {
        for [from, to] in [[*a, *b], [*b, *c], [*c, *a]] {
            halves.push(([from.min(to), from.max(to)], from > to, number));
        }
    }
    halves.sort_unstable();
    let mut edges = Vec::with_capacity(halves.len() / 2);
    for edge in halves.chunk_by(|a, b| a.0 == b.0) {
        let ([from, to], ..) = edge[0];
        let (lefts, rights) = edge.split_at(edge.partition_point(|(_, is_right, _)| !is_right));
        let paired = lefts.len().min(rights.len());
        edges.extend(lefts.iter().zip(rights).map(|((.., left), (.., right))| [from, to, *left, *right]));
        edges.extend(lefts[paired..].iter().map(|(.., left)| [from, to, *left, NOTHING]));
        edges.extend(rights[paired..].iter().map(|(.., right)| [to, from, *right, NOTHING]));
    }
    edges
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A tetrahedron.
    const TRIANGLES: [[u32; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];

    fn mesh(closed: bool, shift: f32) -> WeldedMesh {
        let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let positions = corners.map(|corner| corner.map(|x: f32| x + shift)).to_vec();
        WeldedMesh { positions, triangles: TRIANGLES.to_vec(), closed }
    }

    #[test]
    fn a_tetrahedron_has_six_edges_each_with_the_triangles_that_have_it() {
        let shell = Shell::of(mesh(true, 0.0));
        assert_eq!(shell.edges.len(), 6);
        for [a, b, left, right] in shell.edges {
            let has = |triangle: u32, from: u32, to: u32| {
                let [x, y, z] = TRIANGLES[triangle as usize];
                [[x, y], [y, z], [z, x]].contains(&[from, to])
            };
            assert!(has(left, a, b) && has(right, b, a), "{a} {b} {left} {right}");
        }
    }

    #[test]
    fn what_is_inside_is_told_from_what_is_beside() {
        let shell = Shell::of(mesh(true, 0.0));
        assert!(shell.holds(DVec3::splat(0.2)));
        assert!(!shell.holds(DVec3::splat(0.5)), "in the box, and beyond the slope");
        assert!(!shell.holds(DVec3::splat(-0.1)));
    }

    #[test]
    fn an_open_mesh_has_nothing_right_of_its_rim() {
        let mut open = mesh(false, 0.0);
        open.triangles.pop();
        let shell = Shell::of(open);
        let rim: Vec<_> = shell
            .edges
            .iter()
            .filter(|[.., right]| *right == NOTHING)
            .map(|edge| edge[0] + edge[1])
            .collect();
        assert_eq!((shell.edges.len(), rim), (6, vec![2, 3, 5]), "edges of 0 and 2, 0 and 3, 2 and 3");
    }

    #[test]
    fn a_mesh_far_from_its_origin_has_small_numbers() {
        let shell = Shell::of(mesh(true, 4096.0));
        assert_eq!(shell.origin, [4096.5; 3]);
        assert!(shell.positions.iter().flatten().all(|x| x.abs() <= 0.5), "{:?}", shell.positions);
    }
}
