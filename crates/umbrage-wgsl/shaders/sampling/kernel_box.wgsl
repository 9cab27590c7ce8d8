// All lookups of a row weigh the same.

import constants::UMBRAGE_KERNEL_SIZE;

/// What lookup `i` of a row weighs, 0 in the middle.
fn umbrage_kernel(i: i32) -> f32 {
    return select(0.0, 1.0, abs(i) <= UMBRAGE_KERNEL_SIZE / 2);
}

const UMBRAGE_KERNEL_SUM: f32 = f32(UMBRAGE_KERNEL_SIZE);
