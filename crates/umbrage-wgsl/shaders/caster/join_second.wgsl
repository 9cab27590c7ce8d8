/// The second surface (Wang & Molnar 1994).
fn umbrage_joined(first: f32, second: f32, limit: f32) -> f32 {
    return second;
}
