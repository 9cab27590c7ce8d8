//! How far lookups reach from their receiver: on the map, and toward the light.
//!
//! A view's map is larger than its receivers, and deeper, by what this says; so no lookup leaves it.

/// The reach of lookups with some filter and bias, as numbers: fits know neither of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Reach {
    /// How far from its receiver a lookup may end on the map, in texels: the offset and the corner of the kernel.
    pub lookup_texels: f64,
    /// How far along the light a receiver's plane may lie from the receiver within its lookups' reach, in texels.
    pub plane_depth_texels: f64,
    /// How far along its normal a receiver is moved at most, in texels.
    pub offset_texels: f64,
    /// How far toward the light it is moved always, metres.
    pub constant: f64,
    /// How far toward the light it is moved times the tangent of the angle between normal and light, in texels.
    pub slope: f64,
    /// The largest such tangent.
    pub slope_limit: f64,
    /// How far toward the light a comparison at the end of its reach is moved over the cosine of that angle, in texels.
    pub bend: f64,
    /// How far toward the light rounded corners may move what is stored, in texels.
    pub raster_texels: f64,
}

impl Reach {
    /// How many times larger than its receivers a map of `resolution` texels a side must be: by the lookups' reach and
    /// a texel on every side, which are at most a quarter of it.
    pub fn padding(&self, resolution: u32) -> f64 {
        let texels = f64::from(resolution);
        let pad = self.pad_texels().min(texels / 4.0);
        texels / (texels - 2.0 * pad)
    }

    /// Whether a map of `resolution` texels a side is padded by all of the lookups' reach: then it holds the footprints of
    /// all of its slice's receivers.
    pub fn is_held_by(&self, resolution: u32) -> bool {
        self.pad_texels() <= f64::from(resolution) / 4.0
    }

    fn pad_texels(&self) -> f64 {
        self.lookup_texels + 1.0
    }

    /// How far toward the light what is compared may lie from its receiver, at most, in metres.
    pub fn toward_light_metres(&self, texel_metres: f64) -> f64 {
        std::f64::consts::SQRT_2 * self.offset_texels * texel_metres
            + self.constant
            + self.slope * texel_metres * self.slope_limit
            + std::f64::consts::SQRT_2 * self.bend * texel_metres * (1.0 + self.slope_limit)
            + self.plane_depth_texels * texel_metres
            + self.raster_texels * texel_metres
    }
}
