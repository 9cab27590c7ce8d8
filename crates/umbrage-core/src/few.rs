//! A short list that lives where its owner lives, so that replanning a frame allocates nothing.

use std::ops::Deref;

/// At most `N` values, in order. Reads as a slice.
#[derive(Clone, Copy)]
pub struct ArrayVec<T, const N: usize> {
    values: [T; N],
    len: usize,
}

impl<T: Copy + Default, const N: usize> ArrayVec<T, N> {
    /// Appends, or returns `false` and leaves the list alone when it is full.
    #[must_use = "a full list refuses"]
    pub fn push(&mut self, value: T) -> bool {
        let Some(slot) = self.values.get_mut(self.len) else { return false };
        *slot = value;
        self.len += 1;
        true
    }
}

impl<T: Copy + Default, const N: usize> Default for ArrayVec<T, N> {
    fn default() -> Self {
        Self { values: [T::default(); N], len: 0 }
    }
}

impl<T, const N: usize> Deref for ArrayVec<T, N> {
    type Target = [T];

    fn deref(&self) -> &[T] {
        &self.values[..self.len]
    }
}

impl<T: PartialEq, const N: usize> PartialEq for ArrayVec<T, N> {
    fn eq(&self, other: &Self) -> bool {
        **self == **other
    }
}

impl<T: std::fmt::Debug, const N: usize> std::fmt::Debug for ArrayVec<T, N> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_list().entries(self.iter()).finish()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_full_list_refuses_and_keeps_what_it_had() {
        let mut few = ArrayVec::<u8, 2>::default();
        assert!(few.push(1) && few.push(2), "there is room for two");
        assert!(!few.push(3), "there is no room for three");
        assert_eq!(*few, [1, 2]);
    }
}
