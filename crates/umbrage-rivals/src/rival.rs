//! What every family of shadows answers, whatever it does for it.

use std::fmt::Debug;
use std::sync::Arc;

use umbrage_scene::{Camera, Light, Pose};

use crate::error::RivalError;
use crate::left::Left;

/// A view is a picture whose shadows are asked for.
#[derive(Clone, Debug)]
pub struct View<'a> {
    /// The camera.
    pub camera: &'a Camera,
    /// The lights whose shadows are asked for.
    pub lights: &'a [Light],
    /// How the scene stands.
    pub pose: &'a Arc<Pose>,
    /// The width and height of the picture, in pixels.
    pub size: [u32; 2],
}

/// What a rival says of a view.
#[derive(Clone, Debug, PartialEq)]
pub struct Seen {
    /// The visibility of every pixel, 0 to 1, rows from top to bottom, one list for each light; `None` where the family knows
    /// nothing of what the pixel shows. The sky is lit.
    pub visibility: Vec<Vec<Option<f32>>>,
    /// The time that the passes of a picture's shadows took, in milliseconds: on the device where it has timestamps.
    pub milliseconds: f64,
    /// The time before that on the CPU, in milliseconds: to place what casts, to list what is drawn, and to hand it over.
    pub listing_milliseconds: f64,
}

/// A rival is a family of shadows, ready for one scene.
pub trait Rival: Debug {
    /// The casters that the family cannot draw, in whole or in part; their shadows are missing in what it says.
    fn left(&self) -> &[Left];

    /// The bytes that the family holds on the device for the shadows of this scene.
    ///
    /// For every family all buffers and textures count that are there for shadows alone, those of the size of the last picture
    /// too: visibility, and the depth of what the picture shows. Not counted are what whoever draws the scene holds of it anyway,
    /// which is vertices and triangles as they are drawn, what lives for one picture only, as copies to read, uniforms of some
    /// hundred bytes, and what is in memory beside the device.
    fn bytes(&self) -> u64;

    /// Finds the visibility of a view's pixels.
    ///
    /// # Errors
    /// When the camera or a light cannot be used, or the device fails.
    fn see(&mut self, view: &View<'_>) -> Result<Seen, RivalError>;
}
