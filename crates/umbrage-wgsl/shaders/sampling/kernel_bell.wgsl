// The bells that Castaño's lookups make (The Witness, 2013): 1 2 1, 1 3 4 3 1 and 1 5 12 16 12 5 1.

import constants::UMBRAGE_KERNEL_SIZE;

/// What lookup `i` of a row weighs, 0 in the middle.
fn umbrage_kernel(i: i32) -> f32 {
    let narrow = select(1.0, 2.0, i == 0);
    let middle = select(select(1.0, 3.0, abs(i) == 1), 4.0, i == 0);
    let wide = select(select(select(1.0, 5.0, abs(i) == 2), 12.0, abs(i) == 1), 16.0, i == 0);
    let bell = select(select(wide, middle, UMBRAGE_KERNEL_SIZE == 5), narrow, UMBRAGE_KERNEL_SIZE == 3);
    return select(0.0, bell, abs(i) <= UMBRAGE_KERNEL_SIZE / 2);
}

const UMBRAGE_KERNEL_SUM: f32 =
    select(select(52.0, 12.0, UMBRAGE_KERNEL_SIZE == 5), 4.0, UMBRAGE_KERNEL_SIZE == 3);
