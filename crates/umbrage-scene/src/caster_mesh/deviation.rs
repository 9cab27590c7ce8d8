//! How far the vertices of a mesh lie from a level of it, at most.
//!
//! The level's triangles lie in a grid of cells. Most vertices have a triangle nearby that is no farther than what was found
//! before, and one look suffices; for others the cells around them are searched in shells, outward.

use glam::{IVec3, Vec3};

use super::place;
use crate::Aabb;

/// Looks that a vertex may take in the mean, before a level counts as too wild to be measured.
const MOST_LOOKS: usize = 256;
/// Cells that a triangle may touch in the mean, and cells for each triangle: with more, they are made larger.
const MOST_TOUCHED: usize = 8;
const MOST_CELLS: usize = 16;

/// Returns how far any of some points lies from triangles of `positions`, at least `known`. `None` where it would take too
/// long to tell, or some are no numbers.
pub(super) fn deviation(
    points: &[[f32; 3]],
    positions: &[[f32; 3]],
    level: &[[u32; 3]],
    known: f32,
) -> Option<f32> {
    let triangles = corners(positions, level);
    let grid = Grid::new(&triangles)?;
    let mut looks = MOST_LOOKS * points.len();
    let mut farthest = known.max(0.0);
    for point in points {
        farthest = grid.at_least(Vec3::from_array(*point), farthest, &mut looks)?;
    }
    farthest.is_finite().then_some(farthest)
}

/// Returns the numbers of those vertices that lie farther than `limit` from a level of them, with the same exceptions.
pub(super) fn beyond(positions: &[[f32; 3]], level: &[[u32; 3]], limit: f32) -> Option<Vec<usize>> {
    let triangles = corners(positions, level);
    let grid = Grid::new(&triangles)?;
    let mut is_kept = vec![false; positions.len()];
    level.as_flattened().iter().for_each(|vertex| is_kept[*vertex as usize] = true);
    let mut looks = MOST_LOOKS * positions.len();
    let mut beyond = Vec::new();
    for (number, (point, _)) in positions.iter().zip(is_kept).enumerate().filter(|(_, (_, is_kept))| !is_kept)
    {
        if grid.at_least(Vec3::from_array(*point), limit, &mut looks)? > limit {
            beyond.push(number);
        }
    }
    Some(beyond)
}

fn corners(positions: &[[f32; 3]], level: &[[u32; 3]]) -> Vec<[Vec3; 3]> {
    level.iter().map(|triangle| triangle.map(|vertex| place(positions, vertex))).collect()
}

/// Triangles by the cells that their boxes touch.
struct Grid<'a> {
    triangles: &'a [[Vec3; 3]],
    cells: Cells,
    /// Where the triangles of each cell begin in `numbers`; one more than cells.
    starts: Vec<u32>,
    numbers: Vec<u32>,
}

/// Cubes that fill a box.
#[derive(Clone, Copy)]
struct Cells {
    bounds: Aabb,
    side: f32,
    count: IVec3,
}

impl Cells {
    /// Those that are as small as triangles are, without being too many; `None` of a box that is not finite.
    fn of(triangles: &[[Vec3; 3]]) -> Option<Self> {
        let bounds = Aabb::of_points(triangles.iter().flatten().copied());
        let longest = bounds.size().max_element().max(f32::MIN_POSITIVE);
        if !longest.is_finite() || !bounds.size().is_finite() {
            return None;
        }
        // A surface of n triangles is some √(n / 2) of them wide.
        let mut across = (0.5 * triangles.len() as f32).sqrt().clamp(1.0, 1024.0);
        loop {
            let side = longest / across;
            let count = (bounds.size() / side).ceil().as_ivec3().max(IVec3::ONE);
            let cells = Self { bounds, side, count };
            let touched: usize = triangles.iter().map(|triangle| cells.touched(triangle).len()).sum();
            let is_small =
                cells.len() <= MOST_CELLS * triangles.len() && touched <= MOST_TOUCHED * triangles.len();
            if is_small || across <= 1.0 {
                return Some(cells);
            }
            across = (0.7 * across).max(1.0);
        }
    }

    fn len(&self) -> usize {
        self.count.to_array().iter().map(|n| *n as usize).product()
    }

    /// The cell that a point lies in, or the one that is nearest to it.
    fn at(&self, point: Vec3) -> IVec3 {
        ((point - self.bounds.min) / self.side).as_ivec3().clamp(IVec3::ZERO, self.count - 1)
    }

    fn number(&self, cell: IVec3) -> usize {
        let [x, y, z] = cell.to_array().map(|n| n as usize);
        let [across, down, _] = self.count.to_array().map(|n| n as usize);
        (z * down + y) * across + x
    }

    fn touched(&self, triangle: &[Vec3; 3]) -> Block {
        let bounds = Aabb::of_points(triangle.iter().copied());
        Block { low: self.at(bounds.min), high: self.at(bounds.max) }
    }
}

/// Cells from one to another, both included.
#[derive(Clone, Copy)]
struct Block {
    low: IVec3,
    high: IVec3,
}

impl Block {
    fn len(&self) -> usize {
        (self.high - self.low + 1).to_array().iter().map(|n| *n as usize).product()
    }

    fn cells(self) -> impl Iterator<Item = IVec3> {
        let Self { low, high } = self;
        (low.z..=high.z).flat_map(move |z| {
            (low.y..=high.y).flat_map(move |y| (low.x..=high.x).map(move |x| IVec3::new(x, y, z)))
        })
    }
}

impl<'a> Grid<'a> {
    fn new(triangles: &'a [[Vec3; 3]]) -> Option<Self> {
        let cells = Cells::of(triangles)?;
        let mut starts = vec![0u32; cells.len() + 1];
        for triangle in triangles {
            cells.touched(triangle).cells().for_each(|cell| starts[cells.number(cell) + 1] += 1);
        }
        for i in 1..starts.len() {
            starts[i] += starts[i - 1];
        }
        let mut numbers = vec![0; starts[cells.len()] as usize];
        let mut next = starts.clone();
        for (triangle, number) in triangles.iter().zip(0..) {
            for cell in cells.touched(triangle).cells() {
                let slot = &mut next[cells.number(cell)];
                numbers[*slot as usize] = number;
                *slot += 1;
            }
        }
        Some(Self { triangles, cells, starts, numbers })
    }

    /// The distance of a point from the triangles, or `known` where it is no farther.
    fn at_least(&self, point: Vec3, known: f32, looks: &mut usize) -> Option<f32> {
        let middle = self.cells.at(point);
        let mut nearest = f32::INFINITY;
        // Whatever lies in the shell is at least as far as the shells within are wide.
        for shell in (0..).take_while(|shell| *shell <= self.cells.count.max_element()) {
            if (shell - 1) as f32 * self.cells.side > nearest {
                break;
            }
            for cell in self.shell(middle, shell) {
                let number = self.cells.number(cell);
                let inside = &self.numbers[self.starts[number] as usize..self.starts[number + 1] as usize];
                *looks = looks.checked_sub(1 + inside.len())?;
                for triangle in inside {
                    nearest = nearest.min(distance(point, self.triangles[*triangle as usize]));
                    if nearest <= known {
                        return Some(known);
                    }
                }
            }
        }
        Some(nearest)
    }

    /// The cells that are so many steps from the middle one.
    fn shell(&self, middle: IVec3, steps: i32) -> impl Iterator<Item = IVec3> {
        let block = Block {
            low: (middle - steps).max(IVec3::ZERO),
            high: (middle + steps).min(self.cells.count - 1),
        };
        block.cells().filter(move |cell| (cell - middle).abs().max_element() == steps)
    }
}

/// The distance of a point from a triangle (Ericson, *Real-Time Collision Detection*, §5.1.5); NaN from one without an inside.
fn distance(p: Vec3, [a, b, c]: [Vec3; 3]) -> f32 {
    let (ab, ac) = (b - a, c - a);
    let [(d1, d2), (d3, d4), (d5, d6)] = [p - a, p - b, p - c].map(|from| (ab.dot(from), ac.dot(from)));
    let (va, vb, vc) = (d3 * d6 - d5 * d4, d5 * d2 - d1 * d6, d1 * d4 - d3 * d2);
    let nearest = if d1 <= 0.0 && d2 <= 0.0 {
        a
    } else if d3 >= 0.0 && d4 <= d3 {
        b
    } else if d6 >= 0.0 && d5 <= d6 {
        c
    } else if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        a + ab * (d1 / (d1 - d3))
    } else if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        a + ac * (d2 / (d2 - d6))
    } else if va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0 {
        b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)))
    } else {
        a + (ab * vb + ac * vc) / (va + vb + vc)
    };
    p.distance(nearest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_from_a_triangle_are_those_from_its_inside_its_edges_and_its_corners() {
        let triangle = [Vec3::ZERO, Vec3::X, Vec3::Y];
        for (point, wanted) in [
            (Vec3::new(0.25, 0.25, 2.0), 2.0),
            (Vec3::new(0.5, -3.0, 0.0), 3.0),
            (Vec3::new(-3.0, 0.5, 4.0), 5.0),
            (Vec3::new(1.0, 1.0, 0.0), 0.5f32.sqrt()),
            (Vec3::new(5.0, 0.0, 3.0), 5.0),
            (Vec3::new(0.0, 4.0, 4.0), 5.0),
            (Vec3::new(-3.0, -4.0, 0.0), 5.0),
        ] {
            let got = distance(point, triangle);
            assert!((got - wanted).abs() < 1e-6, "{point}: {got}, not {wanted}");
        }
    }

    #[test]
    fn a_vertex_far_from_everything_is_as_far_as_it_is() {
        let positions = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.2, 0.2, -70.0]];
        assert_eq!(deviation(&positions, &positions, &[[0, 1, 2]], 0.0), Some(70.0));
        assert_eq!(deviation(&positions, &positions, &[[0, 1, 2]], 80.0), Some(80.0), "what is known counts");
        let unbounded = [[0.0; 3], [f32::NAN, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0; 3]];
        assert_eq!(deviation(&unbounded, &unbounded, &[[0, 1, 2]], 0.0), None);
    }
}
