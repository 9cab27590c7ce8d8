//! Pictures with holes, made in code: what leaves, wires, lace and glass are cut from.
//!
//! Space: texture coordinates, 0 to 1 to the right and down. Every drawn shape has an edge of some texels on which alpha
//! passes one half, so that a mask with that cut-off has smooth edges between texels.

use glam::{Vec2, Vec3, Vec4};

use super::picture::srgb_table;
use crate::Texture;

/// The texels over which alpha goes from 0 to 1.
const EDGE_TEXELS: f32 = 3.0;

/// A square picture under construction.
#[derive(Debug)]
pub(super) struct Canvas {
    size_px: u32,
    /// Linear RGB, and alpha.
    pixels: Vec<Vec4>,
}

/// What is drawn covers what was there, or cuts a hole.
#[derive(Clone, Copy, Debug)]
pub(super) enum Ink {
    /// A surface of so much linear RGB.
    Colour(Vec3),
    /// Nothing, through which one looks.
    Hole,
}

impl Canvas {
    /// Makes an empty picture. Its invisible colour is `around`, so that edges of what is drawn have no fringe of another.
    pub fn new(size_px: u32, around: Vec3) -> Self {
        Self { size_px, pixels: vec![around.extend(0.0); (size_px * size_px) as usize] }
    }

    /// Draws a shape within a box: `inside` says how far a place is inside of it, in shares of the picture's side, or
    /// outside where it is negative.
    pub fn draw(&mut self, low: Vec2, high: Vec2, ink: Ink, inside: impl Fn(Vec2) -> f32) {
        let size = self.size_px as f32;
        let border = EDGE_TEXELS / size;
        let pixel = |share: f32| (share * size).clamp(0.0, size) as u32;
        let (left, right) = (pixel(low.x - border), pixel(high.x + border + 1.0 / size));
        for row in pixel(low.y - border)..pixel(high.y + border + 1.0 / size) {
            for column in left..right {
                let at = Vec2::new(column as f32 + 0.5, row as f32 + 0.5) / size;
                let cover = (0.5 + inside(at) * size / EDGE_TEXELS).clamp(0.0, 1.0);
                let pixel = &mut self.pixels[(row * self.size_px + column) as usize];
                *pixel = match ink {
                    Ink::Colour(_) if cover <= 0.0 => *pixel,
                    Ink::Colour(colour) => {
                        let share = if pixel.w > 0.0 { cover } else { 1.0 };
                        pixel.truncate().lerp(colour, share).extend(pixel.w.max(cover))
                    }
                    Ink::Hole => pixel.truncate().extend(pixel.w.min(1.0 - cover)),
                };
            }
        }
    }

    /// Draws a shape that may be anywhere on the picture.
    pub fn fill(&mut self, ink: Ink, inside: impl Fn(Vec2) -> f32) {
        self.draw(Vec2::ZERO, Vec2::ONE, ink, inside);
    }

    /// Draws a leaf from its stem at `root` along `along`, `width` wide.
    pub fn leaf(&mut self, root: Vec2, along: Vec2, width: f32, ink: Ink) {
        let (length, ahead) = (along.length(), along.normalize_or(Vec2::NEG_Y));
        let (tip, reach) = (root + along, Vec2::splat(width * 0.5));
        self.draw(root.min(tip) - reach, root.max(tip) + reach, ink, |at| {
            let from_root = at - root;
            let (share, aside) = (from_root.dot(ahead) / length, from_root.perp_dot(ahead).abs());
            // Widest before the middle, pointed at the tip.
            let outline = (share.clamp(0.0, 1.0).powf(0.8) * std::f32::consts::PI).sin();
            (0.5 * width * outline - aside).min((0.5 - (share - 0.5).abs()) * length)
        });
    }

    /// Draws a disc.
    pub fn disc(&mut self, middle: Vec2, radius: f32, ink: Ink) {
        let reach = Vec2::splat(radius);
        self.draw(middle - reach, middle + reach, ink, |at| radius - at.distance(middle));
    }

    /// Draws a line with round ends that tapers from one width to another.
    pub fn line(&mut self, from: (Vec2, f32), to: (Vec2, f32), ink: Ink) {
        let ((a, from_width), (b, to_width)) = (from, to);
        let reach = Vec2::splat(0.5 * from_width.max(to_width));
        self.draw(a.min(b) - reach, a.max(b) + reach, ink, |at| {
            let share = ((at - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
            0.5 * (from_width + (to_width - from_width) * share) - at.distance(a.lerp(b, share))
        });
    }

    /// Returns the picture.
    pub fn texture(self, name: &str) -> Texture {
        let table = srgb_table();
        let level = |linear: f32| table[(linear.clamp(0.0, 1.0) * (table.len() - 1) as f32).round() as usize];
        let alpha = |alpha: f32| (alpha * 255.0).round() as u8;
        let pixels = self.pixels.into_iter().flat_map(|p| [level(p.x), level(p.y), level(p.z), alpha(p.w)]);
        Texture { name: name.to_owned(), width: self.size_px, height: self.size_px, rgba: pixels.collect() }
    }
}

/// The share of a picture that a mask with the cut-off ½ covers.
#[cfg(test)]
pub(super) fn covered(texture: &Texture) -> f32 {
    let covered = texture.rgba.as_chunks::<4>().0.iter().filter(|pixel| pixel[3] >= 128).count();
    covered as f32 / (texture.width * texture.height) as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    const HALF: Vec2 = Vec2::splat(0.5);

    #[test]
    fn a_disc_covers_its_area_and_a_hole_in_it_takes_some_away() {
        let mut canvas = Canvas::new(128, Vec3::ONE);
        canvas.disc(HALF, 0.4, Ink::Colour(Vec3::X));
        let whole = covered(&Canvas { size_px: 128, pixels: canvas.pixels.clone() }.texture("whole"));
        assert!((whole - 0.16 * std::f32::consts::PI).abs() < 0.002, "{whole}");
        canvas.disc(HALF, 0.2, Ink::Hole);
        let ring = covered(&canvas.texture("ring"));
        assert!((ring - 0.12 * std::f32::consts::PI).abs() < 0.002, "{ring}");
    }

    #[test]
    fn what_is_outside_has_the_colour_around_and_alpha_passes_one_half_at_the_edge() {
        let mut canvas = Canvas::new(64, Vec3::Y);
        canvas.fill(Ink::Colour(Vec3::X), |at| at.x - 0.5);
        let texture = canvas.texture("half");
        let pixel = |column: usize| &texture.rgba[4 * column..4 * column + 4];
        assert_eq!((pixel(0), pixel(63)), (&[0, 255, 0, 0][..], &[255, 0, 0, 255][..]));
        assert!(pixel(31)[3] < 128 && pixel(32)[3] >= 128, "{:?} and {:?}", pixel(31), pixel(32));
    }
}
