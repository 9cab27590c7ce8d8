//! Bakes every light, band by band: from a file where it was baked before, otherwise by rays, and then into a file.

use std::path::Path;

use umbrage_judge::Light;

use super::gutter::filled;
use super::rays::Still;
use super::store::{Key, Store, hash};
use super::texels::{Band, bands};
use super::unwrap::Unwrapped;
use super::{BakeProgress, BakeStep, Tell};
use crate::error::RivalError;

/// What was baked.
#[derive(Debug)]
pub(super) struct Baked {
    /// Visibility in 255ths, page by page, and row by row; the pages of the first light, then of the next.
    pub texels: Vec<u8>,
    /// The number of rays whose answers count, of those that were traced now.
    pub rays: u64,
}

/// Bakes lights, and keeps what is baked in a folder, if there is one.
pub(super) fn bake(
    still: &Still<'_>,
    unwrapped: &Unwrapped,
    lights: &[Light],
    folder: Option<&Path>,
    tell: &Tell<'_>,
) -> Result<Baked, RivalError> {
    let store = folder.map(Store::open).transpose()?;
    let world = if store.is_some() { key(still, unwrapped) } else { Key::default() };
    let bands = bands(unwrapped);
    let [width, height] = unwrapped.size;
    let mut baked = Baked { texels: Vec::new(), rays: 0 };
    let mut done = 0;
    for light in lights {
        let key = hash(&[&world, format!("{light:?}").as_bytes()]);
        let mut texels = Vec::with_capacity(width as usize * height as usize * unwrapped.pages as usize);
        for band in bands.iter().enumerate() {
            let total = Some(bands.len() * lights.len());
            if !tell(BakeProgress { step: BakeStep::Trace, done, total, rays: baked.rays }) {
                return Err(RivalError::Cancelled);
            }
            let (band, rays) =
                kept_or_traced(still, light, band, store.as_ref().map(|store| (store, &key)), width)?;
            texels.extend(band);
            baked.rays += rays;
            done += 1;
        }
        for page in texels.chunks(width as usize * height as usize) {
            baked.texels.extend(filled(page.to_vec(), width as usize));
        }
    }
    Ok(baked)
}

/// A band's texels, and the number of rays that they took now.
fn kept_or_traced(
    still: &Still<'_>,
    light: &Light,
    band: (usize, &Band),
    kept: Option<(&Store<'_>, &Key)>,
    width: u32,
) -> Result<(Vec<u8>, u64), RivalError> {
    let Some((store, key)) = kept else { return Ok(still.trace(light, band)) };
    if let Some(texels) = store.get(key, band, width) {
        return Ok((texels, 0));
    }
    let (texels, rays) = still.trace(light, band);
    store.put(key, band, width, &texels)?;
    Ok((texels, rays))
}

/// The hash of all that bands depend on beside their light.
fn key(still: &Still<'_>, unwrapped: &Unwrapped) -> Key {
    let Unwrapped { size, pages, texels_per_metre: _, charts: _, shapes } = unwrapped;
    let mut layout: Vec<u8> = size.iter().chain([pages]).flat_map(|number| number.to_le_bytes()).collect();
    for shape in shapes {
        for placed in &shape.placed {
            let numbers = [placed.instance as u64, u64::from(placed.page)];
            layout.extend(numbers.iter().flat_map(|number| number.to_le_bytes()));
            let corners = [placed.min, placed.size];
            layout.extend(corners.iter().flat_map(|corner| corner.to_array()).flat_map(f32::to_le_bytes));
        }
        layout.extend(shape.indices.iter().flat_map(|index| index.to_le_bytes()));
        layout.extend(shape.vertices.iter().flat_map(|(_, uv)| *uv).flat_map(u16::to_le_bytes));
    }
    hash(&[&still.bytes(), &layout, &still.rays().to_le_bytes()])
}
