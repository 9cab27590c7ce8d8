// When a surface that rays decide of is turned away from a light.

/// Surfaces are dark whose normal has no larger cosine to the direction of a light. Where rays decide, a normal that is known no
/// better than this does not.
const UMBRAGE_TURNED_AWAY: f32 = -5e-4;
