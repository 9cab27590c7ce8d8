// A ray in some space, made ready to be asked of boxes and triangles there.

struct UmbrageRay {
    origin: vec3f,
    /// As long in every space as in the world, so that distances along it are metres.
    direction: vec3f,
    /// One over each part of the direction; large where that is 0.
    inverse: vec3f,
    /// How far off its place rounding in world space may have moved the origin.
    slack: f32,
}

/// The share of all coordinates by which rounding may have moved a point.
const UMBRAGE_ROUNDING: f32 = 4e-6;

/// A ray from a point that rounding may have moved as far as `reach` lets it.
fn umbrage_ray(origin: vec3f, direction: vec3f, reach: f32) -> UmbrageRay {
    let safe = select(direction, vec3f(1e-30), abs(direction) < vec3f(1e-30));
    return UmbrageRay(origin, direction, 1.0 / safe, UMBRAGE_ROUNDING * reach);
}

/// Whether a ray meets a box between its origin and `end`, metres along it. Boxes that it only just misses may count.
fn umbrage_meets(ray: UmbrageRay, low: vec3f, high: vec3f, end: f32) -> bool {
    let a = (low - ray.origin) * ray.inverse;
    let b = (high - ray.origin) * ray.inverse;
    let nearer = min(a, b);
    let farther = max(a, b);
    let enters = max(max(nearer.x, nearer.y), max(nearer.z, 0.0));
    let leaves = min(min(farther.x, farther.y), min(farther.z, end));
    return enters <= leaves * 1.000001;
}
