//! Visibility as numbers, from the grey of a picture.

use crate::target::Picture;

impl Picture {
    /// The visibility that a picture of [`Show::Visibility`](crate::Show::Visibility) shows of each pixel: 0 in shadow to 1
    /// lit, row by row from the top, in steps of 1/255.
    pub fn visibility(&self) -> Vec<f32> {
        self.rgba.iter().step_by(4).map(|grey| f32::from(*grey) / 255.0).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn visibility_is_the_first_channel_of_each_pixel() {
        let picture = Picture { width: 3, height: 1, rgba: vec![0, 9, 9, 9, 51, 9, 9, 9, 255, 9, 9, 9] };
        assert_eq!(picture.visibility(), [0.0, 0.2, 1.0]);
    }
}
