//! What must a filter say of itself? Each filter's file answers all of it, and nothing else tells filters apart.

use super::family::Family;
use super::light_size::LightSize;
use super::shader::ShaderNumber;
use super::stored::Stored;
use crate::error::SettingsError;
use crate::lookup::place::Query;
use crate::lookup::reader::Reader;
use crate::schema::kind::Kind;

/// One way to read a shadow map, with its numbers.
pub(crate) trait Technique {
    /// What the schema has of it.
    fn kind(&self) -> &'static Kind;

    /// The family that it stands in.
    fn family(&self) -> Family;

    /// Whether each of its numbers is in its range.
    fn validate(&self) -> Result<(), SettingsError>;

    /// How far a lookup may reach from its centre, texels: a nearest lookup half a texel, a bilinear one a whole.
    fn reach_texels(&self) -> f32;

    /// How much of that an offset along the normal must cover where a texel's side is `texel_metres`, texels. Penumbrae
    /// begin at nothing, and moments know the slope of what they hold.
    fn offset_reach_texels(&self, texel_metres: f32) -> f32;

    /// How far from a receiver its plane is followed, texels; 0 where it is not.
    fn plane_reach_texels(&self) -> f32;

    /// What lookups read instead of depths.
    fn stores(&self) -> Stored {
        Stored::Depths
    }

    /// How large it takes a light to be that has no size of its own; `None` where it does not ask.
    fn light_size(&self) -> Option<LightSize> {
        None
    }

    /// Whether one of its comparisons weighs four texels bilinearly, as a sampler does.
    fn is_bilinear(&self) -> bool {
        true
    }

    /// The numbers that its own shader text is compiled with.
    fn numbers(&self) -> Vec<ShaderNumber>;

    /// How much light it lets through, from 0 to 1: the twin of its shader.
    fn visibility(&self, reader: &Reader<'_>, query: &Query) -> f32;
}
