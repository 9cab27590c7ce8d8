//! Measures a run of an experiment.

use std::io::Cursor;
use std::sync::Arc;

use image::codecs::jpeg::JpegEncoder;
use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder as _};
use umbrage_render::{Gpu, Picture};
use umbrage_scene::{Scene, Shining};

use crate::error::LabError;
use crate::laboratory::Laboratory;
use crate::measurement::{Machine, Outcome, Pictures};
use crate::run::{AreaLight, Run};
use crate::shot::Shot;
use crate::technique::Technique;
use crate::truth_kind::TruthKind;

impl Machine {
    /// Describes the machine that the program runs on, and the device that draws.
    pub fn here(gpu: &Gpu) -> Self {
        Self {
            adapter: gpu.adapter.to_string(),
            timestamps: gpu.adapter.timestamps,
            system: format!("{} on {}", std::env::consts::OS, std::env::consts::ARCH),
            cores: std::thread::available_parallelism().map_or(1, usize::from),
            commit: env!("UMBRAGE_COMMIT").to_owned(),
        }
    }
}

impl Laboratory<'_> {
    /// Measures a run. Its world must be this laboratory's.
    ///
    /// # Errors
    /// As [`Laboratory::judge`], and when the world has no such camera or no light.
    pub fn measure(&mut self, run: &Run) -> Result<Outcome, LabError> {
        let shot = shot(self.scene(), run)?;
        let mut area = run.area.as_ref().map(AreaLight::area).transpose()?;
        let mut family =
            run.family.map(|family| Ok::<_, LabError>((family, self.take_family(family)?))).transpose()?;
        let technique: Option<&mut dyn Technique> = match (&mut family, &mut area) {
            (Some((_, family)), _) => Some(family),
            (None, Some(area)) => Some(area),
            (None, None) => None,
        };
        let mut judged = self.judge(&shot, &run.settings, technique, TruthKind::Hard, run.frames)?;
        if let Some((family, ready)) = family {
            self.keep_family(family, ready);
        }
        for truth in &run.truths {
            let deviation = self.deviation(&shot, &judged, truth.kind(run.light_points));
            *judged.measurement.deviation_mut(*truth) = deviation;
        }
        if let Some(motion) = run.motion {
            judged.measurement.flicker = Some(self.flicker(&shot, &run.settings, motion, run.watch)?);
        }
        let pictures = run
            .pictures
            .then(|| Pictures::of(&judged.shaded, &judged.heat_map, &judged.true_picture))
            .transpose()?;
        Ok(Outcome { machine: Machine::here(self.gpu()), measurement: judged.measurement, pictures })
    }
}

/// The picture that a run wants taken.
fn shot(scene: &Scene, run: &Run) -> Result<Shot, LabError> {
    let Run { camera, repeat, size: [width, height], .. } = run;
    let missing = |what: String| LabError::Missing { what, world: scene.name.clone() };
    let named = scene.cameras.iter().find(|it| it.name == *camera);
    let camera = named.ok_or_else(|| missing(format!("camera called `{camera}`")))?;
    // The same for all repeats.
    let pose = Arc::new(scene.pose(0.0));
    let Shining { lights, warnings: _ } = Shining::choose(&scene.lights, camera, &pose, umbrage::MAX_LIGHTS);
    if lights.is_empty() {
        return Err(missing("light".to_owned()));
    }
    Ok(Shot {
        camera: umbrage_judge::jittered(camera, *repeat),
        lights,
        pose,
        width: *width,
        height: *height,
    })
}

impl Pictures {
    /// Encodes a shaded picture, its heat map, and the picture with exact shadows.
    fn of(shaded: &Picture, heat_map: &Picture, exact: &Picture) -> Result<Self, LabError> {
        let mut png = Cursor::new(Vec::new());
        PngEncoder::new(&mut png).write_image(
            &heat_map.rgba,
            heat_map.width,
            heat_map.height,
            ExtendedColorType::Rgba8,
        )?;
        Ok(Self { shaded: jpeg(shaded)?, error: png.into_inner(), exact: jpeg(exact)? })
    }
}

/// A picture as JPEG.
fn jpeg(picture: &Picture) -> Result<Vec<u8>, LabError> {
    /// Good enough to judge shadows by, and a tenth of a PNG's size.
    const QUALITY: u8 = 88;
    let mut file = Cursor::new(Vec::new());
    let rgb: Vec<u8> = picture.rgba.as_chunks::<4>().0.iter().flat_map(|p| [p[0], p[1], p[2]]).collect();
    JpegEncoder::new_with_quality(&mut file, QUALITY).write_image(
        &rgb,
        picture.width,
        picture.height,
        ExtendedColorType::Rgb8,
    )?;
    Ok(file.into_inner())
}
