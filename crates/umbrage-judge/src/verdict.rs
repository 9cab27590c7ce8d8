//! Whether a claim about a pixel is right, as far as its truth is known, and how often claims are wrong so far.

use crate::Pixel;
use crate::error::{Wrong, wrong};

/// What a claim about a pixel is, against the truth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The truth is not traced yet.
    NotTraced,
    /// The pixel is left out: sky, a surface turned away, or a truth that depends on rounding.
    NotJudged,
    /// As it should be.
    Right,
    /// Shadowed, and should be lit.
    FalseShadow,
    /// Lit, and should be shadowed.
    FalseLight,
}

impl Verdict {
    /// Of a claimed visibility, 0 to 1, against the truth where that is traced.
    pub fn new(truth: Option<Pixel>, visibility: f32) -> Self {
        match truth {
            None => Self::NotTraced,
            Some(pixel) if !pixel.is_judged() => Self::NotJudged,
            Some(pixel) => match wrong(pixel, visibility) {
                None => Self::Right,
                Some(Wrong::FalseShadow) => Self::FalseShadow,
                Some(Wrong::FalseLight) => Self::FalseLight,
            },
        }
    }

    /// Whether it is one of the two kinds of wrong.
    pub fn is_wrong(self) -> bool {
        matches!(self, Self::FalseShadow | Self::FalseLight)
    }
}

/// How often claims are wrong, of the pixels that are traced and judged so far.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// How many are judged.
    pub judged: usize,
    /// How many are shadowed and should be lit.
    pub false_shadow: usize,
    /// How many are lit and should be shadowed.
    pub false_light: usize,
}

impl Tally {
    /// Adds a claim.
    pub fn count(&mut self, verdict: Verdict) {
        match verdict {
            Verdict::NotTraced | Verdict::NotJudged => return,
            Verdict::Right => {}
            Verdict::FalseShadow => self.false_shadow += 1,
            Verdict::FalseLight => self.false_light += 1,
        }
        self.judged += 1;
    }

    /// Share of judged pixels that are wrong, either way; 0 without any.
    pub fn mis_shadowed(&self) -> f64 {
        self.share(self.false_shadow + self.false_light)
    }

    /// Share of judged pixels that are shadowed and should be lit; 0 without any.
    pub fn false_shadow_share(&self) -> f64 {
        self.share(self.false_shadow)
    }

    /// Share of judged pixels that are lit and should be shadowed; 0 without any.
    pub fn false_light_share(&self) -> f64 {
        self.share(self.false_light)
    }

    fn share(&self, count: usize) -> f64 {
        count as f64 / self.judged.max(1) as f64
    }
}

impl std::ops::AddAssign for Tally {
    fn add_assign(&mut self, Self { judged, false_shadow, false_light }: Self) {
        self.judged += judged;
        self.false_shadow += false_shadow;
        self.false_light += false_light;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_visible_is_a_claim_of_light_and_the_least_less_one_of_shadow() {
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
            tally.count(verdict);
        }
        assert_eq!(tally, Tally { judged: 4, false_shadow: 1, false_light: 1 });
        let shares = [tally.mis_shadowed(), tally.false_shadow_share(), tally.false_light_share()];
        assert_eq!(shares, [0.5, 0.25, 0.25]);
        assert_eq!(Tally::default().mis_shadowed(), 0.0, "nothing is judged yet");
    }
}
