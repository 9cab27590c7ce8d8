//! Light in 32 bits: three mantissas of nine bits, and an exponent that they share.
//!
//! Source: OpenGL `EXT_texture_shared_exponent`, section 3.8.1: N = 9, B = 15, the largest number is
//! (2⁹ − 1) / 2⁹ · 2¹⁶.

/// The largest number that there is.
pub(super) const MOST: f32 = 65408.0;

/// Packs three numbers, from 0 to [`MOST`]; what is beyond becomes that.
pub(super) fn pack(light: [f32; 3]) -> u32 {
    let [red, green, blue] = light.map(|light| if light > 0.0 { light.min(MOST) } else { 0.0 });
    let most = red.max(green).max(blue);
    if most <= 0.0 {
        return 0;
    }
    let exponent_of = |most: f32| (most.log2().floor() as i32).max(-16) + 1 + 15;
    let step = |exponent: i32| f32::exp2((exponent - 15 - 9) as f32);
    let mut exponent = exponent_of(most);
    // The largest may round up to a bit more.
    if (most / step(exponent)).round() >= 512.0 {
        exponent += 1;
    }
    let mantissa = |light: f32| ((light / step(exponent)).round() as u32).min(511);
    mantissa(red) | mantissa(green) << 9 | mantissa(blue) << 18 | (exponent as u32) << 27
}

#[cfg(test)]
mod tests {
    use super::*;

    fn unpack(packed: u32) -> [f32; 3] {
        let step = f32::exp2((packed >> 27) as f32 - 24.0);
        [0, 9, 18].map(|shift| (packed >> shift & 511) as f32 * step)
    }

    #[test]
    fn numbers_come_back_to_nine_bits_of_the_largest() {
        for light in
            [[1.0, 0.5, 0.25], [0.0; 3], [MOST; 3], [1e-4, 3e-5, 0.0], [511.9, 1.0, 100.0], [0.999, 0.1, 0.3]]
        {
            let most = light.iter().fold(0.0, |most: f32, light| most.max(*light));
            for (got, want) in unpack(pack(light)).iter().zip(light) {
                assert!((got - want).abs() <= most / 500.0, "{light:?}: {got} instead of {want}");
            }
        }
        assert_eq!(unpack(pack([f32::INFINITY, f32::NAN, -1.0])), [MOST, 0.0, 0.0]);
    }
}
