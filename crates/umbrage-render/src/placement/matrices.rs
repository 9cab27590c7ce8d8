//! The matrices of all instances as they are in the buffer, and which runs of it are to be written when they move.

use glam::{DVec3, Mat4};
use umbrage_scene::{Instance, Pose};

/// The size of a matrix, bytes.
pub(super) const MATRIX_BYTES: u64 = size_of::<[f32; 16]>() as u64;

/// So many matrices that did not move are written again rather than beginning another write. Each has a staging buffer of its
/// own, which takes 4.6 µs whatever its size, by lavapipe; these 16 KiB take 0.3 µs more.
const WORTH_A_WRITE: usize = 256;

/// What is in the buffer.
#[derive(Debug)]
pub(super) struct Matrices {
    pose: Pose,
    origin: DVec3,
    /// The instances' matrices, relative to the origin.
    relative: Vec<[f32; 16]>,
    /// The numbers of those instances that a pose may move.
    dynamic: Vec<usize>,
}

impl Matrices {
    /// The matrices of instances as they are at the start, relative to the world's origin. There is one at least: no buffer
    /// is of no size.
    pub fn new(instances: &[Instance]) -> Self {
        let mut relative: Vec<[f32; 16]> =
            instances.iter().map(|instance| instance.world_from_mesh.to_cols_array()).collect();
        if relative.is_empty() {
            relative.push([0.0; 16]);
        }
        let dynamic = instances.iter().enumerate().filter(|(_, instance)| instance.is_dynamic());
        let dynamic = dynamic.map(|(number, _)| number).collect();
        Self { pose: Pose::default(), origin: DVec3::ZERO, relative, dynamic }
    }

    pub fn all(&self) -> &[[f32; 16]] {
        &self.relative
    }

    /// Moves instances to where they stand in a pose, relative to `origin`. Gives `write` the runs that hold what changed, each
    /// with the number of its first matrix: everything where the origin is another one, and nothing where all stand so.
    pub fn move_to(
        &mut self,
        instances: &[Instance],
        origin: DVec3,
        pose: &Pose,
        mut write: impl FnMut(u64, &[[f32; 16]]),
    ) {
        let Self { pose: now, origin: from, relative, dynamic } = self;
        let is_at_origin = *from == origin;
        if is_at_origin && now == pose {
            return;
        }
        *from = origin;
        now.clone_from(pose);
        let stands = |i: usize| relative_to(origin, instances[i].world_from_mesh_in(pose)).to_cols_array();
        if !is_at_origin {
            relative.iter_mut().zip(0..instances.len()).for_each(|(matrix, i)| *matrix = stands(i));
            write(0, relative);
            return;
        }
        let mut run = 0..0;
        for &i in dynamic.iter() {
            let matrix = stands(i);
            if matrix == relative[i] {
                continue;
            }
            relative[i] = matrix;
            if !run.is_empty() && i > run.end + WORTH_A_WRITE {
                write(run.start as u64, &relative[run.clone()]);
                run = i..i;
            }
            run = if run.is_empty() { i } else { run.start }..i + 1;
        }
        if !run.is_empty() {
            write(run.start as u64, &relative[run]);
        }
    }
}

/// The same placement relative to `origin`.
fn relative_to(origin: DVec3, world_from_mesh: Mat4) -> Mat4 {
    let place = world_from_mesh.w_axis.truncate().as_dvec3() - origin;
    Mat4 { w_axis: place.as_vec3().extend(1.0), ..world_from_mesh }
}

#[cfg(test)]
mod tests {
    use std::ops::Range;

    use glam::Vec3;
    use umbrage_scene::Motion;

    use super::*;

    /// So many instances in a row, of which some turn, at a radian a second or not at all.
    fn instances(count: usize, turning: &[(usize, f32)]) -> Vec<Instance> {
        let mut all = vec![Instance::still(0, Mat4::from_translation(Vec3::X)); count];
        for (i, radians_per_second) in turning {
            let centre = Vec3::ZERO;
            all[*i].motion =
                Motion::Rotation { centre, axis: Vec3::Y, radians_per_second: *radians_per_second };
        }
        all
    }

    /// A buffer, and the runs that were written into it.
    #[derive(Default)]
    struct Buffer {
        matrices: Vec<[f32; 16]>,
        runs: Vec<Range<usize>>,
    }

    impl Buffer {
        fn of(matrices: &Matrices) -> Self {
            Self { matrices: matrices.all().to_vec(), runs: Vec::new() }
        }

        /// The bytes that a move writes.
        fn bytes(&mut self, matrices: &mut Matrices, all: &[Instance], origin: DVec3, seconds: f32) -> u64 {
            self.runs.clear();
            matrices.move_to(all, origin, &Pose::at(seconds), |first, run| {
                let first = first as usize;
                self.runs.push(first..first + run.len());
                self.matrices[first..first + run.len()].copy_from_slice(run);
            });
            let stands = all.iter().map(|of| relative_to(origin, of.world_from_mesh_in(&Pose::at(seconds))));
            let wanted: Vec<[f32; 16]> = stands.map(|matrix| matrix.to_cols_array()).collect();
            assert_eq!(self.matrices, wanted, "what is in the buffer at {seconds} s");
            self.runs.iter().map(|run| run.len() as u64 * MATRIX_BYTES).sum()
        }
    }

    #[test]
    fn what_moved_is_written_in_runs_and_what_stands_is_not() {
        let far = 3 + WORTH_A_WRITE + 2;
        // The last turns by nothing.
        let all = instances(far + 9, &[(1, 1.0), (2, 1.0), (far, 1.0), (far + 8, 0.0)]);
        let mut matrices = Matrices::new(&all);
        let mut buffer = Buffer::of(&matrices);
        let origin = DVec3::ZERO;
        assert_eq!(buffer.bytes(&mut matrices, &all, origin, 0.0), 0, "all stand there");
        assert_eq!(buffer.bytes(&mut matrices, &all, origin, 1.0), 3 * MATRIX_BYTES);
        assert_eq!(buffer.runs, [1..3, far..far + 1]);
        assert_eq!(buffer.bytes(&mut matrices, &all, origin, 1.0), 0, "the same pose");
    }

    #[test]
    fn neighbours_that_are_not_far_apart_are_one_write() {
        let all = instances(9, &[(1, 1.0), (4, 1.0)]);
        let mut matrices = Matrices::new(&all);
        let mut buffer = Buffer::of(&matrices);
        assert_eq!(buffer.bytes(&mut matrices, &all, DVec3::ZERO, 1.0), 4 * MATRIX_BYTES);
        assert_eq!(buffer.runs, [1..5], "what lies between is written as it is");
    }

    #[test]
    fn everything_is_written_when_the_origin_changes_and_nothing_when_nothing_can_move() {
        let all = instances(5, &[]);
        let mut matrices = Matrices::new(&all);
        let mut buffer = Buffer::of(&matrices);
        let far = DVec3::X * 1024.0;
        assert_eq!(buffer.bytes(&mut matrices, &all, DVec3::ZERO, 1.0), 0, "time alone moves nothing");
        assert_eq!(buffer.bytes(&mut matrices, &all, far, 1.0), 5 * MATRIX_BYTES);
        assert_eq!(buffer.bytes(&mut matrices, &all, far, 2.0), 0);
        assert_eq!(buffer.bytes(&mut matrices, &all, DVec3::ZERO, 2.0), 5 * MATRIX_BYTES, "and back");
    }

    #[test]
    fn of_no_instances_there_is_a_buffer_all_the_same() {
        let mut matrices = Matrices::new(&[]);
        assert_eq!(matrices.all().len(), 1);
        matrices.move_to(&[], DVec3::X, &Pose::at(1.0), |first, run| assert_eq!((first, run.len()), (0, 1)));
    }
}
