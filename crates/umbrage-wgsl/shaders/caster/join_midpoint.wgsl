/// Half-way between the two (Woo 1992).
fn umbrage_joined(first: f32, second: f32, limit: f32) -> f32 {
    return 0.5 * (first + second);
}
