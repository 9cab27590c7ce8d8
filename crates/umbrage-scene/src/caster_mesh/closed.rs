//! Whether triangles enclose something: then the first that a ray from outside meets faces it, and those that face away need
//! not be drawn into the map of a sun.

use glam::DVec3;

/// The least volume of a piece, as a share of that of a cube of its area's root: a sheet that was folded onto itself has none but what
/// rounding makes.
const LEAST_VOLUME: f64 = 1e-9;

/// Whether every edge has as many triangles on one side as on the other, and each piece that hangs together is the right way
/// out: the volume that it encloses is positive (by the divergence theorem).
pub(super) fn is_closed(positions: &[[f32; 3]], triangles: &[[u32; 3]]) -> bool {
    !triangles.is_empty() && edges_meet(triangles) && all_face_outward(positions, triangles)
}

fn edges_meet(triangles: &[[u32; 3]]) -> bool {
    let edges = |turned: bool| {
        let of = |[a, b, c]: &[u32; 3]| {
            [[*a, *b], [*b, *c], [*c, *a]].map(|[from, to]| if turned { [to, from] } else { [from, to] })
        };
        let mut edges: Vec<[u32; 2]> = triangles.iter().flat_map(of).collect();
        edges.sort_unstable();
        edges
    };
    edges(false) == edges(true)
}

fn all_face_outward(positions: &[[f32; 3]], triangles: &[[u32; 3]]) -> bool {
    let mut pieces = Pieces((0..positions.len() as u32).collect());
    for [a, b, c] in triangles {
        pieces.join(*a, *b);
        pieces.join(*b, *c);
    }
    let place = |vertex: u32| DVec3::from(positions[vertex as usize].map(f64::from));
    // The volume and the area of each piece, by its first vertex.
    let mut sizes = vec![(0.0, 0.0); positions.len()];
    for [a, b, c] in triangles {
        let piece = pieces.of(*a);
        let from = place(piece);
        let [a, b, c] = [a, b, c].map(|vertex| place(*vertex) - from);
        let (volume, area) = &mut sizes[piece as usize];
        *volume += a.dot(b.cross(c)) / 6.0;
        *area += (b - a).cross(c - a).length() / 2.0;
    }
    let encloses = |(volume, area): (f64, f64)| volume > LEAST_VOLUME * area.powf(1.5);
    triangles.iter().all(|[a, ..]| encloses(sizes[pieces.of(*a) as usize]))
}

/// Vertices by the piece that they belong to: each names another of its piece, and the first names itself.
struct Pieces(Vec<u32>);

impl Pieces {
    fn of(&mut self, vertex: u32) -> u32 {
        let mut at = vertex;
        while self.0[at as usize] != at {
            let next = self.0[at as usize];
            self.0[at as usize] = self.0[next as usize];
            at = next;
        }
        at
    }

    fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.of(a), self.of(b));
        self.0[a.max(b) as usize] = a.min(b);
    }
}
