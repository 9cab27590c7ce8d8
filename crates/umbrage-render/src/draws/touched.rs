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

    /// Gives all numbers in order, and removes those that are taken: of which `takes` says so.
    pub fn take(&mut self, mut takes: impl FnMut(u32) -> bool) {
        for (first, word) in (0..).step_by(u64::BITS as usize).zip(&mut self.words) {
            let mut left = *word;
            while left != 0 {
                let bit = left.trailing_zeros();
                left &= left - 1;
                if takes(first + bit) {
                    *word &= !(1 << bit);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_come_in_order_until_they_are_taken() {
        let mut touched = Touched::default();
        touched.make_room(200);
        [199, 0, 64, 63, 64, 128].into_iter().for_each(|number| touched.insert(number));
        let mut all = |taken: fn(u32) -> bool| {
            let mut all: Vec<u32> = Vec::new();
            touched.take(|number| {
                all.push(number);
                taken(number)
            });
            all
        };
        assert_eq!(all(|number| number == 64), [0, 63, 64, 128, 199]);
        assert_eq!(all(|_| true), [0, 63, 128, 199]);
        assert!(all(|_| true).is_empty());
    }
}
