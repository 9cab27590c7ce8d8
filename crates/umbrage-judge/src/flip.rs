//! How different two pictures look: FLIP (Andersson et al., *FLIP: A Difference Evaluator for Alternating Images*, 2020),
//! by NVIDIA's own code.

/// Computes the mean FLIP error of two sRGB pictures of `width` × `height` pixels, four bytes each: 0 for equal pictures, 1
/// at most. The observer is as far away as FLIP's default, where a degree is 67 pixels wide. `None` where a size is 0 or
/// does not fit the bytes.
pub fn flip_mean(width: u32, height: u32, reference: &[u8], test: &[u8]) -> Option<f64> {
    let pixels = width as usize * height as usize;
    if pixels == 0 || reference.len() != 4 * pixels || test.len() != 4 * pixels {
        return None;
    }
    let image = |rgba: &[u8]| {
        let rgb: Vec<u8> = rgba.as_chunks::<4>().0.iter().flat_map(|p| [p[0], p[1], p[2]]).collect();
        nv_flip::FlipImageRgb8::with_data(width, height, &rgb)
    };
    let error = nv_flip::flip(image(reference), image(test), nv_flip::DEFAULT_PIXELS_PER_DEGREE);
    let errors = error.to_vec();
    Some(errors.iter().map(|e| f64::from(*e)).sum::<f64>() / pixels as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_picture_is_0_and_black_on_white_is_much() {
        let (black, white) = (vec![0; 32 * 32 * 4], vec![255; 32 * 32 * 4]);
        assert_eq!(flip_mean(32, 32, &white, &white), Some(0.0));
        let far = flip_mean(32, 32, &white, &black).unwrap();
        assert!(far > 0.9 && far <= 1.0, "{far}");
        assert_eq!(flip_mean(32, 32, &white, &black[..100]), None);
        assert_eq!(flip_mean(0, 0, &[], &[]), None);
    }
}
