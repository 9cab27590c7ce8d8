//! A few of a convex shape's planes: those that cut a box, and so may cut what lies in it.

/// A set of planes, by their numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct PlaneSet(u32);

impl PlaneSet {
    /// A shape has at most so many planes.
    pub const MOST: usize = u32::BITS as usize;

    /// The first `count` of a shape's planes.
    pub fn first(count: usize) -> Self {
        Self(((1u64 << count.min(Self::MOST)) - 1) as u32)
    }

    pub fn is_empty(self) -> bool {
        self.0 == 0
    }

    pub fn remove(&mut self, plane: usize) {
        self.0 &= !(1 << plane);
    }

    /// The numbers of its planes, in order.
    pub fn iter(self) -> impl Iterator<Item = usize> {
        let mut left = self.0;
        std::iter::from_fn(move || {
            let first = left.trailing_zeros() as usize;
            left &= left.wrapping_sub(1);
            (first < Self::MOST).then_some(first)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_set_has_what_was_not_removed() {
        let mut set = PlaneSet::first(4);
        set.remove(1);
        assert_eq!(set.iter().collect::<Vec<_>>(), [0, 2, 3]);
        [0, 2, 3].into_iter().for_each(|plane| set.remove(plane));
        assert!(set.is_empty() && set.iter().next().is_none());
        assert_eq!(PlaneSet::first(32).iter().count(), 32);
        assert!(PlaneSet::first(0).is_empty());
    }
}
