//! Which filters have most in common?

/// Filters that read a map in the same manner. Each has a module of its name below `filter`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// Comparisons on a grid of texels around the receiver: hard, bilinear, PCF, optimised PCF.
    Grid,
    /// Comparisons at points of a disc: Poisson, stratified, rotated, Vogel.
    Disc,
    /// Comparisons all over what the pixel covers of the map.
    Footprint,
    /// A search for blockers, and comparisons on a disc as wide as their penumbra.
    Pcss,
    /// Moments that are blurred before they are read: VSM, ESM, EVSM, MSM.
    Prefiltered,
    /// Boxes of any size out of a summed-area table of moments: SAVSM, soft MSM.
    Summed,
}
