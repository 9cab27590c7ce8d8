/// Half-way between the two, but no more than the limit behind the first (Weiskopf & Ertl 2003).
fn umbrage_joined(first: f32, second: f32, limit: f32) -> f32 {
    return first - min(0.5 * (first - second), limit);
}
