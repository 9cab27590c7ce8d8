//! Whether a result is right about a pixel, as far as the pixel's truth is known, and how often it is wrong so far.

use crate::Pixel;

/// Whether a visibility, 0 to 1, stands for shadow: where it is below one half. NaN stands for light.
pub(crate) fn is_shadow(visibility: f32) -> bool {
    visibility < 0.5
}

/// A verdict says how a result compares with the truth at one pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The truth of the pixel is not traced yet.
    NotTraced,
    /// The pixel is left out: it shows sky or a surface turned away, or its truth depends on rounding.
    NotJudged,
    /// The result agrees with the truth.
    Right,
    /// The result shadows the pixel, and the truth lights it, at least by half more.
    FalseShadow,
    /// The result lights the pixel, and the truth shadows it, at least by half more.
    FalseLight,
}

impl Verdict {
    /// Compares a result's visibility, 0 to 1, with the truth, which is `None` where it is not traced. A visibility below
    /// one half is a shadow. Where a share of the light truly reaches the pixel, a visibility is wrong that is more than one
    /// half away from the share.
    pub fn new(truth: Option<Pixel>, visibility: f32) -> Self {
        match (truth, is_shadow(visibility)) {
            (None, _) => Self::NotTraced,
            (Some(Pixel::Lit), true) => Self::FalseShadow,
            (Some(Pixel::Shadowed), false) => Self::FalseLight,
            (Some(Pixel::Lit), false) | (Some(Pixel::Shadowed), true) => Self::Right,
            (Some(Pixel::Partial(share)), _) => Self::of_share(share, visibility),
            (
                Some(Pixel::Sky | Pixel::Unreached | Pixel::TurnedAway | Pixel::Beyond | Pixel::Ambiguous),
                _,
            ) => Self::NotJudged,
        }
    }

    fn of_share(share: f32, visibility: f32) -> Self {
        // NaN stands for light.
        let visibility = if visibility.is_nan() { 1.0 } else { visibility };
        match visibility - share {
            more if more > 0.5 => Self::FalseLight,
            less if less < -0.5 => Self::FalseShadow,
            _ => Self::Right,
        }
    }

    /// Joins the verdicts of several lights on one pixel: the first that is wrong counts, or else [`Self::Right`] where
    /// any light is right, or else the first. Without any light the pixel is not judged.
    pub fn of_lights(lights: impl Iterator<Item = Self> + Clone) -> Self {
        lights
            .clone()
            .find(|verdict| verdict.is_wrong())
            .or_else(|| lights.clone().find(|verdict| *verdict == Self::Right))
            .or_else(|| lights.clone().next())
            .unwrap_or(Self::NotJudged)
    }

    /// Whether the result is wrong, in either direction.
    pub fn is_wrong(self) -> bool {
        matches!(self, Self::FalseShadow | Self::FalseLight)
    }
}

/// A tally counts verdicts of the pixels that are traced and judged so far.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Tally {
    /// Number of judged pixels.
    pub judged: usize,
    /// Number of pixels that the result shadows and the truth lights.
    pub false_shadow: usize,
    /// Number of pixels that the result lights and the truth shadows.
    pub false_light: usize,
    /// The sum of all misses of visibility, each 0 to 1, as [`Pixel::miss`] has them.
    pub missed: f64,
}

impl Tally {
    /// Counts one more pixel, as [`Verdict::new`] has it. Pixels that are not traced or not judged are left out.
    pub fn count(&mut self, truth: Option<Pixel>, visibility: f32) {
        match Verdict::new(truth, visibility) {
            Verdict::NotTraced | Verdict::NotJudged => return,
            Verdict::Right => {}
            Verdict::FalseShadow => self.false_shadow += 1,
            Verdict::FalseLight => self.false_light += 1,
        }
        self.judged += 1;
        self.missed += truth.and_then(|truth| truth.miss(visibility)).unwrap_or_default();
    }

    /// Returns the mean absolute error of visibility over judged pixels, 0 to 1; 0 where none is judged.
    pub fn mae(&self) -> f64 {
        self.missed / self.judged.max(1) as f64
    }

    /// Returns the share of judged pixels that are wrong in either direction, 0 to 1; 0 where none is judged.
    pub fn mis_shadowed(&self) -> f64 {
        self.share(self.false_shadow + self.false_light)
    }

    /// Returns the share of judged pixels that are falsely shadowed, 0 to 1; 0 where none is judged.
    pub fn false_shadow_share(&self) -> f64 {
        self.share(self.false_shadow)
    }

    /// Returns the share of judged pixels that are falsely lit, 0 to 1; 0 where none is judged.
    pub fn false_light_share(&self) -> f64 {
        self.share(self.false_light)
    }

    fn share(&self, count: usize) -> f64 {
        count as f64 / self.judged.max(1) as f64
    }
}

impl std::ops::AddAssign for Tally {
    fn add_assign(&mut self, Self { judged, false_shadow, false_light, missed }: Self) {
        self.missed += missed;
        self.judged += judged;
        self.false_shadow += false_shadow;
        self.false_light += false_light;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_visible_stands_for_light_and_the_least_less_for_shadow() {
        let less = 0.5f32.next_down();
        let cases = [
            (None, 0.0, Verdict::NotTraced),
            (Some(Pixel::Sky), 0.0, Verdict::NotJudged),
            (Some(Pixel::Ambiguous), 1.0, Verdict::NotJudged),
            (Some(Pixel::Lit), 0.5, Verdict::Right),
            (Some(Pixel::Lit), less, Verdict::FalseShadow),
            (Some(Pixel::Shadowed), less, Verdict::Right),
            (Some(Pixel::Shadowed), 0.5, Verdict::FalseLight),
        ];
        let mut tally = Tally::default();
        for (truth, visibility, verdict) in cases {
            assert_eq!(Verdict::new(truth, visibility), verdict, "{truth:?}, {visibility}");
            tally.count(truth, visibility);
        }
        // Halves, but for what is too little in one and too much in another.
        let missed = 2.0;
        assert_eq!(tally, Tally { judged: 4, false_shadow: 1, false_light: 1, missed });
        assert_eq!(tally.mae(), 0.5, "also of those that are right by one half");
        let shares = [tally.mis_shadowed(), tally.false_shadow_share(), tally.false_light_share()];
        assert_eq!(shares, [0.5, 0.25, 0.25]);
        assert_eq!(Tally::default().mis_shadowed(), 0.0, "nothing is judged yet");
    }

    #[test]
    fn where_a_share_of_the_light_comes_through_more_than_a_half_away_is_wrong() {
        for (share, visibility, verdict) in [
            (0.9, 0.5, Verdict::Right),
            (0.9, 0.25, Verdict::FalseShadow),
            (0.75, 0.25, Verdict::Right),
            (0.25, 0.75, Verdict::Right),
            (0.25, 0.8, Verdict::FalseLight),
            (0.5, 0.0, Verdict::Right),
            (0.5, 1.0, Verdict::Right),
            (0.25, f32::NAN, Verdict::FalseLight),
        ] {
            assert_eq!(
                Verdict::new(Some(Pixel::Partial(share)), visibility),
                verdict,
                "{share}, {visibility}"
            );
        }
        let mut tally = Tally::default();
        tally.count(Some(Pixel::Partial(0.75)), 0.5);
        assert_eq!((tally.judged, tally.mae()), (1, 0.25));
    }

    #[test]
    fn of_several_lights_the_first_wrong_one_counts_and_else_one_that_is_right() {
        use Verdict::{FalseLight, FalseShadow, NotJudged, NotTraced, Right};
        for (lights, joined) in [
            (&[NotJudged, Right, FalseLight, FalseShadow][..], FalseLight),
            (&[NotJudged, Right], Right),
            (&[NotTraced, NotJudged], NotTraced),
            (&[], NotJudged),
        ] {
            assert_eq!(Verdict::of_lights(lights.iter().copied()), joined, "{lights:?}");
        }
    }
}
