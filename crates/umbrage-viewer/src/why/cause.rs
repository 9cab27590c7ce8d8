//! The cause of a wrong pixel, each decided by figures that were measured there.

use std::fmt;

use umbrage_judge::{Pixel, Verdict};

use super::around::Around;
use super::{MapSays, Question, Read, linear};

/// How far beyond the filter's reach an edge is looked for, texels: the map's own edge may be a texel off.
const BESIDE: f32 = 1.5;

/// No edge is looked for farther away than this, texels, however wide the filter is.
const FARTHEST: f32 = 16.0;

/// Why a pixel is right or wrong.
#[derive(Clone, Debug, PartialEq)]
pub enum Cause {
    /// The picture agrees with the truth.
    Right,
    /// The truth is not judged there.
    NotJudged(&'static str),
    /// The place lies beyond the distance at which shadows end.
    BeyondDistance {
        /// The place's view depth, metres.
        depth: f64,
        /// The depth at which shadows end, metres.
        end: f64,
    },
    /// No map covers the place.
    OutsideMaps,
    /// Where the map lies was chosen on the device, and is not known here.
    ChosenOnDevice,
    /// What casts the shadow lies outside of what the view holds.
    CasterOutside {
        /// The caster's distance, metres.
        blocker: f64,
    },
    /// The bias is larger than the distance to what casts the shadow.
    BiasOverContact {
        /// The bias in all, metres toward the light.
        bias: f32,
        /// The distance to the caster along the map's axis, metres.
        contact: f32,
    },
    /// What casts the shadow, or what lets light through, is narrower than a texel, and lies between texel centres.
    Thin {
        /// Its width, texels.
        texels: f32,
        /// The longer side of a texel, metres.
        texel_metres: f32,
    },
    /// A true edge is so near that the texels or the filter blur it.
    NearEdge {
        /// The distance to the edge, texels.
        texels: f32,
        /// The longer side of a texel, metres.
        texel_metres: f32,
    },
    /// The surface shadows itself.
    Acne {
        /// The bias in all, metres toward the light.
        bias: f32,
        /// How far in front of the surface the texel stores it, metres.
        stored: f32,
    },
    /// The map holds the blocker, and the filter lets light through.
    FilterLeak {
        /// The distance of the blocker in the map, metres.
        blocker: f32,
        /// The visibility that the filter makes of it.
        shown: f32,
    },
    /// None of these.
    Unknown,
}

impl Question<'_> {
    /// Decides on the cause.
    pub(super) fn cause(&self, verdict: Verdict, read: Option<&Read<'_>>, map: Option<&MapSays>) -> Cause {
        match verdict {
            Verdict::Right => Cause::Right,
            Verdict::NotTraced | Verdict::NotJudged => Cause::NotJudged(reason(self.inspected.truth)),
            Verdict::FalseShadow | Verdict::FalseLight => self.cause_of_wrong(verdict, read, map),
        }
    }

    fn cause_of_wrong(&self, verdict: Verdict, read: Option<&Read<'_>>, map: Option<&MapSays>) -> Cause {
        let depth = self.inspected.receiver.depth;
        let (Some(read), Some(map)) = (read, map) else {
            let views = self.plan.views().iter().filter(|view| view.light == self.light);
            let end = views.map(|view| f64::from(view.depths.end)).reduce(f64::max);
            return match end.filter(|end| depth > *end) {
                Some(end) => Cause::BeyondDistance { depth, end },
                None => Cause::OutsideMaps,
            };
        };
        if read.view.samples.is_some() {
            return Cause::ChosenOnDevice;
        }
        let Some(stored) = map.stored else { return Cause::OutsideMaps };
        let is_lit = verdict == Verdict::FalseShadow;
        let reach = (self.settings.filter.reach_texels() + BESIDE).min(FARTHEST);
        let around = Around::of(self, read, is_lit, reach);
        if is_lit {
            self.false_shadow(map, around)
        } else {
            self.false_light(read, map, around, stored > map.compare)
        }
    }

    fn false_shadow(&self, map: &MapSays, around: Around) -> Cause {
        match (around.edge, map.blocker) {
            (None, Some(stored)) => Cause::Acne { bias: map.bias, stored },
            (None, None) => Cause::Unknown,
            (Some(texels), _) => narrow(around, map).unwrap_or_else(|| near_edge(texels, map)),
        }
    }

    fn false_light(&self, read: &Read<'_>, map: &MapSays, around: Around, is_blocked: bool) -> Cause {
        let Some(blocker) = self.inspected.blocker else { return Cause::Unknown };
        let receiver = &self.inspected.receiver;
        let Some(toward) = self.rays.toward(receiver.position) else { return Cause::Unknown };
        let caster = receiver.position + toward.direction * blocker;
        if !read.view.covers(caster, 1e-4) {
            return Cause::CasterOutside { blocker };
        }
        let contact =
            linear(read.view, caster).map(|caster| (read.surface - caster) * read.view.depth_metres);
        if let Some(contact) = contact.filter(|contact| *contact <= map.bias) {
            return Cause::BiasOverContact { bias: map.bias, contact };
        }
        let edge = || around.edge.map(|texels| near_edge(texels, map));
        let leak = || {
            let blocker = map.blocker.filter(|_| is_blocked)?;
            Some(Cause::FilterLeak { blocker, shown: self.shown })
        };
        narrow(around, map).or_else(edge).or_else(leak).unwrap_or(Cause::Unknown)
    }
}

/// Returns the cause where what is at the pixel is narrower than a texel.
fn narrow(around: Around, map: &MapSays) -> Option<Cause> {
    let texels = around.width.filter(|texels| *texels <= 1.0)?;
    Some(Cause::Thin { texels, texel_metres: map.texel_metres.max_element() })
}

fn near_edge(texels: f32, map: &MapSays) -> Cause {
    Cause::NearEdge { texels, texel_metres: map.texel_metres.max_element() }
}

/// Why the truth of a pixel is not judged.
fn reason(truth: Pixel) -> &'static str {
    match truth {
        Pixel::Sky => "it shows the sky",
        Pixel::Unreached => "the light does not shine there",
        Pixel::TurnedAway => "the surface is turned away from the light, and dark whatever its shadow",
        Pixel::Beyond => "it is too far away",
        Pixel::Ambiguous | Pixel::Lit | Pixel::Shadowed | Pixel::Partial(_) => {
            "it depends on rounding whether the light reaches it"
        }
    }
}

/// Says the cause in a sentence or two, with what can be done.
impl fmt::Display for Cause {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Right => f.write_str("Right: the picture agrees with the truth."),
            Self::NotJudged(why) => write!(f, "Not judged: {why}."),
            Self::BeyondDistance { depth, end } => write!(
                f,
                "Outside of the shadow distance: this place is {depth:.2} m away, and shadows end at {end:.2} m. A larger `distance` reaches it."
            ),
            Self::OutsideMaps => f.write_str(
                "No map holds this place, so it counts as lit. Another `fit`, `select` or `light_box` may cover it.",
            ),
            Self::ChosenOnDevice => f.write_str(
                "Where the map lies was chosen on the graphics device (`fit` is `sample`), and is not read back. Choose the fit `scene` to look closer.",
            ),
            Self::CasterOutside { blocker } => write!(
                f,
                "The view does not hold the caster, which is {blocker:.2} m away toward the light. A larger `light_box`, or another `fit`, holds it."
            ),
            Self::BiasOverContact { bias, contact } => write!(
                f,
                "Light leak: the bias of {bias:.4} m is larger than the contact distance of {contact:.4} m. Less bias, or smaller texels, close the gap."
            ),
            Self::Thin { texels, texel_metres } => write!(
                f,
                "Too thin for the map: what is here is {texels:.2} texels wide, and texel centres, {texel_metres:.3} m apart, miss it. Smaller texels hold it."
            ),
            Self::NearEdge { texels, texel_metres } => write!(
                f,
                "Near an edge: the true edge is {texels:.2} texels away, and a texel is {texel_metres:.3} m. Smaller texels, or a narrower filter, move the drawn edge closer to it."
            ),
            Self::Acne { bias, stored } => write!(
                f,
                "Shadow acne: the texel stores the surface itself, {stored:.4} m in front of this place, and the bias is {bias:.4} m. More bias, or `bias.receiver_plane`, lifts the lookup off it."
            ),
            Self::FilterLeak { blocker, shown } => write!(
                f,
                "Light leak of the filter: the map holds a blocker {blocker:.2} m in front, and the filter lets {:.0} % of the light through.",
                shown * 100.0
            ),
            Self::Unknown => f.write_str("None of the known causes."),
        }
    }
}
