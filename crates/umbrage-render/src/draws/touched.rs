//! What a volume touches, put in order without sorting: a bit for each number.

/// Numbers below some count, in room that is used again. It is empty but while a list is made.
#[derive(Clone, Debug, Default)]
pub(super) struct Touched {
    words: Vec<u64>,
}

impl Touched {
    /// Makes room for numbers below `count`.
    pub fn make_room(&mut self, count: usize) {
        let words = count.div_ceil(u64::BITS as usize).max(self.words.len());
        self.words.resize(words, 0);
    }

    pub fn insert(&mut self, number: u32) {
        self.words[(number / u64::BITS) as usize] |= 1 << (number % u64::BITS);
    }

    /// Gives all numbers in order, and removes them.
    pub fn drain(&mut self, mut each: impl FnMut(u32)) {
        for (first, word) in (0..).step_by(u64::BITS as usize).zip(&mut self.words) {
            let mut left = std::mem::take(word);
            while left != 0 {
                each(first + left.trailing_zeros());
                left &= left - 1;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_come_in_order_and_once() {
        let mut touched = Touched::default();
        touched.make_room(200);
        [199, 0, 64, 63, 64, 128].into_iter().for_each(|number| touched.insert(number));
        let mut all = || {
            let mut all: Vec<u32> = Vec::new();
            touched.drain(|number| all.push(number));
            all
        };
        assert_eq!(all(), [0, 63, 64, 128, 199]);
        assert!(all().is_empty());
    }
}
