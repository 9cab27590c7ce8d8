//! A pixel that someone asks why of. Its visibility and its maps are read back, its rays are traced, and then there is an
//! answer. A question belongs to one picture, and is dropped with it.

use std::sync::Arc;

use eframe::egui;
use umbrage::{MapTexels, Settings, ShadowPlan};
use umbrage_judge::{Eye, World};
use umbrage_render::{Frame, RenderError};
use umbrage_scene::{Camera, Light};

use crate::drawing::{Coming, Drawing};
use crate::why::{Question, Why};

/// A pixel of a picture, and what is known of it.
pub struct Pick {
    /// The pixel, from the picture's upper left corner.
    pub pixel: [u32; 2],
    /// The side of the picture: 0 is the left one, 1 the right one.
    pub side: usize,
    /// The number of the light that is asked about.
    pub light: usize,
    /// The picture that the pixel belongs to; absent until it is drawn.
    of: Option<(Frame, Settings, bool)>,
    coming: Option<Coming>,
    read: Option<Read>,
    answer: Option<Answer>,
}

/// What was read back.
struct Read {
    plan: ShadowPlan,
    shown: f32,
    maps: Option<MapTexels>,
}

/// The answer of a pixel.
#[derive(Clone, Debug, PartialEq)]
pub enum Answer {
    /// The pixel shows no surface.
    Sky,
    /// The picture has no shadows of the light.
    NoShadows,
    /// The pixel's shadow, explained.
    Why(Box<Why>),
}

/// Says the answer in a sentence or two.
impl std::fmt::Display for Answer {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Sky => f.write_str("This pixel shows the sky."),
            Self::NoShadows => f.write_str("The picture has no shadows of this light."),
            Self::Why(why) => why.cause.fmt(f),
        }
    }
}

impl std::fmt::Debug for Pick {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Pick")
            .field("pixel", &self.pixel)
            .field("answer", &self.answer)
            .finish_non_exhaustive()
    }
}

/// What a picture was drawn from, as rays need it.
#[derive(Clone, Copy, Debug)]
pub struct Picture<'a> {
    /// What was drawn.
    pub frame: &'a Frame,
    /// The settings of each side.
    pub settings: &'a [Settings],
    /// The camera.
    pub camera: &'a Camera,
    /// The lights that shine.
    pub lights: &'a [Light],
    /// Whether rays are traced where the settings ask for some.
    pub traces: bool,
}

impl Pick {
    /// Asks about a pixel.
    pub fn new(pixel: [u32; 2], side: usize, light: usize) -> Self {
        Self { pixel, side, light, of: None, coming: None, read: None, answer: None }
    }

    /// Returns the same question about another light.
    #[must_use]
    pub fn of_light(&self, light: usize) -> Self {
        Self::new(self.pixel, self.side, light)
    }

    /// Returns the answer; `None` while it is sought.
    pub fn answer(&self) -> Option<&Answer> {
        self.answer.as_ref()
    }

    /// Whether the pixel belongs to this picture.
    pub fn is_of(&self, picture: &Picture<'_>) -> bool {
        let settings = picture.settings.get(self.side);
        let is_same = |(frame, of, traces): &(Frame, Settings, bool)| {
            frame == picture.frame && Some(of) == settings && *traces == picture.traces
        };
        settings.is_some() && self.of.as_ref().is_none_or(is_same)
    }

    /// Goes on: reads back what is needed, and answers where the BVH of the world's triangles is there, too.
    ///
    /// # Errors
    /// When the picture or its maps cannot be read back.
    pub fn advance(
        &mut self,
        drawing: &mut Drawing,
        picture: &Picture<'_>,
        bvh: impl FnOnce() -> Result<Option<Arc<World>>, RenderError>,
    ) -> Result<(), RenderError> {
        if self.answer.is_some() {
            return Ok(());
        }
        if self.of.is_none() {
            self.of = Some((picture.frame.clone(), picture.settings[self.side].clone(), picture.traces));
        }
        if self.read.is_none() {
            self.read(drawing, picture)?;
        }
        if let (Some(read), Some(world)) = (&self.read, bvh()?) {
            self.answer = Some(self.answered(read, picture, &world));
        }
        Ok(())
    }

    /// Asks for what must come from the device, or takes it.
    fn read(&mut self, drawing: &mut Drawing, picture: &Picture<'_>) -> Result<(), RenderError> {
        if picture.frame.lights.len() <= self.light {
            self.answer = Some(Answer::NoShadows);
            return Ok(());
        }
        let Some(coming) = &mut self.coming else {
            self.coming = drawing.ask(self.side, self.light)?;
            return Ok(());
        };
        drawing.poll();
        if let Some((visibility, maps)) = coming.take() {
            let [x, y] = self.pixel.map(|place| place as usize);
            let shown = visibility?.visibility().get(y * picture.frame.width as usize + x).copied();
            let (plan, shown) = (coming.plan.clone(), shown.unwrap_or(1.0));
            self.read = Some(Read { plan, shown, maps: maps.transpose()? });
        }
        Ok(())
    }

    fn answered(&self, read: &Read, picture: &Picture<'_>, world: &World) -> Answer {
        let Picture { frame, settings, camera, lights, traces: _ } = *picture;
        let eye = Eye::new(camera, frame.width, frame.height);
        let Some(light) = lights.get(self.light) else { return Answer::NoShadows };
        let rays = umbrage_judge::Light::at(light, &frame.pose);
        let Some(inspected) = world.inspect(&eye, &rays, self.pixel) else { return Answer::Sky };
        let question = Question {
            plan: &read.plan,
            settings: &settings[self.side],
            maps: read.maps.as_ref(),
            world,
            light: self.light,
            rays: &rays,
            inspected,
            shown: read.shown,
        };
        Answer::Why(Box::new(question.answer()))
    }
}

/// The pixel of a picture of `size` pixels that a place on the screen lies on.
pub fn pixel_at(place: egui::Pos2, rect: egui::Rect, size: [u32; 2]) -> [u32; 2] {
    let share = (place - rect.min) / rect.size();
    let pixel = |share: f32, size: u32| ((share * size as f32) as u32).min(size.saturating_sub(1));
    [pixel(share.x, size[0]), pixel(share.y, size[1])]
}

/// The middle of a pixel on the screen.
pub fn place_of([x, y]: [u32; 2], rect: egui::Rect, [width, height]: [u32; 2]) -> egui::Pos2 {
    let share = egui::vec2((x as f32 + 0.5) / width as f32, (y as f32 + 0.5) / height as f32);
    rect.min + rect.size() * share
}
