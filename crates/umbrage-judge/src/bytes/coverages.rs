//! What is known of triangles that are not solid, as bytes.

use bytemuck::{Pod, cast_slice, pod_collect_to_vec, pod_read_unaligned};
use glam::Vec2;
use umbrage_scene::Alpha;

use crate::coverage::alpha_picture::AlphaPicture;
use crate::coverage::{Coverages, SOLID, Surface};

/// The numbers of places, of triangles that are not solid, of surfaces and of pictures.
type Header = [u64; 4];

/// A surface: its kind, its cut-off, what it transmits and the alpha of its colour as bits, and its picture's number from 1.
type Words = [u32; 5];

/// The kinds of [`Alpha`].
const OPAQUE: u32 = 0;
const MASK: u32 = 1;
const BLEND: u32 = 2;

/// Appends them.
pub(super) fn join(bytes: &mut Vec<u8>, coverages: &Coverages) {
    let Coverages { places, uvs, alphas, surface_of, surfaces, pictures } = coverages;
    let header: Header = [places.len(), uvs.len(), surfaces.len(), pictures.len()].map(|count| count as u64);
    bytes.extend_from_slice(cast_slice(&header));
    bytes.extend_from_slice(cast_slice(places));
    bytes.extend_from_slice(cast_slice(uvs));
    bytes.extend_from_slice(cast_slice(alphas));
    bytes.extend_from_slice(cast_slice(surface_of));
    bytes.extend(surfaces.iter().flat_map(|surface| words(surface).map(u32::to_le_bytes)).flatten());
    bytes.extend(pictures.iter().flat_map(|p| [p.width, p.height].map(u32::to_le_bytes)).flatten());
    pictures.iter().for_each(|picture| bytes.extend_from_slice(&picture.alpha));
}

/// The inverse of [`join`], of so many triangles; `None` for any other bytes.
pub(super) fn part(mut bytes: &[u8], triangles: usize) -> Option<Coverages> {
    let [places, uvs, surfaces, pictures] =
        pod_read_unaligned::<Header>(take(&mut bytes, size_of::<Header>())?);
    let coverages = Coverages {
        places: list(&mut bytes, places)?,
        uvs: list::<[Vec2; 3]>(&mut bytes, uvs)?,
        alphas: list(&mut bytes, uvs)?,
        surface_of: list(&mut bytes, uvs)?,
        surfaces: list::<Words>(&mut bytes, surfaces)?.into_iter().map(surface).collect::<Option<_>>()?,
        pictures: {
            let sizes: Vec<[u32; 2]> = list(&mut bytes, pictures)?;
            sizes.into_iter().map(|size| picture(&mut bytes, size)).collect::<Option<_>>()?
        },
    };
    (bytes.is_empty() && is_whole(&coverages, triangles)).then_some(coverages)
}

/// Whether all that it points at is there.
fn is_whole(coverages: &Coverages, triangles: usize) -> bool {
    let Coverages { places, uvs, alphas: _, surface_of, surfaces, pictures } = coverages;
    places.len() <= triangles
        && places.iter().all(|place| *place == SOLID || (*place as usize) < uvs.len())
        && surface_of.iter().all(|surface| (*surface as usize) < surfaces.len())
        && surfaces.iter().all(|s| s.picture.is_none_or(|picture| (picture as usize) < pictures.len()))
}

fn take<'a>(bytes: &mut &'a [u8], count: usize) -> Option<&'a [u8]> {
    let (taken, rest) = bytes.split_at_checked(count)?;
    *bytes = rest;
    Some(taken)
}

fn list<T: Pod>(bytes: &mut &[u8], count: u64) -> Option<Vec<T>> {
    let length = usize::try_from(count).ok()?.checked_mul(size_of::<T>())?;
    take(bytes, length).map(pod_collect_to_vec)
}

fn picture(bytes: &mut &[u8], [width, height]: [u32; 2]) -> Option<AlphaPicture> {
    let length = usize::try_from(u64::from(width) * u64::from(height)).ok().filter(|length| *length > 0)?;
    Some(AlphaPicture { width, height, alpha: take(bytes, length)?.to_vec() })
}

fn words(Surface { alpha, transmission, factor, picture }: &Surface) -> Words {
    let (kind, cutoff) = match alpha {
        Alpha::Opaque => (OPAQUE, 0.0),
        Alpha::Mask { cutoff } => (MASK, *cutoff),
        Alpha::Blend => (BLEND, 0.0),
    };
    let picture = picture.map_or(0, |picture| picture + 1);
    [kind, cutoff.to_bits(), transmission.to_bits(), factor.to_bits(), picture]
}

fn surface([kind, cutoff, transmission, factor, picture]: Words) -> Option<Surface> {
    let alpha = match kind {
        OPAQUE => Alpha::Opaque,
        MASK => Alpha::Mask { cutoff: f32::from_bits(cutoff) },
        BLEND => Alpha::Blend,
        _ => return None,
    };
    let (transmission, factor) = (f32::from_bits(transmission), f32::from_bits(factor));
    Some(Surface { alpha, transmission, factor, picture: picture.checked_sub(1) })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn some() -> Coverages {
        let surface = |alpha, picture| Surface { alpha, transmission: 0.25, factor: 0.5, picture };
        Coverages {
            places: vec![SOLID, 0, 1],
            uvs: vec![[Vec2::X; 3], [Vec2::Y; 3]],
            alphas: vec![[0.0, 0.5, 1.0]; 2],
            surface_of: vec![2, 0],
            surfaces: vec![
                surface(Alpha::Mask { cutoff: -0.5 }, Some(1)),
                surface(Alpha::Opaque, None),
                surface(Alpha::Blend, Some(0)),
            ],
            pictures: vec![
                AlphaPicture { width: 2, height: 1, alpha: vec![0, 255] },
                AlphaPicture { width: 1, height: 1, alpha: vec![7] },
            ],
        }
    }

    #[test]
    fn they_come_back_as_they_were_and_nothing_else_does() {
        for coverages in [some(), Coverages::default()] {
            let mut bytes = Vec::new();
            join(&mut bytes, &coverages);
            assert_eq!(part(&bytes, 3), Some(coverages));
            for end in 0..bytes.len() {
                assert_eq!(part(&bytes[..end], 3), None, "cut at {end}");
            }
        }
    }

    #[test]
    fn what_points_at_nothing_is_refused() {
        let is_read = |coverages: &Coverages, triangles| {
            let mut bytes = Vec::new();
            join(&mut bytes, coverages);
            part(&bytes, triangles).is_some()
        };
        assert!(is_read(&some(), 3) && !is_read(&some(), 2), "more places than triangles");
        assert!(!is_read(&Coverages { places: vec![2], ..some() }, 3));
        assert!(!is_read(&Coverages { surface_of: vec![0, 3], ..some() }, 3));
        assert!(!is_read(&Coverages { pictures: some().pictures[1..].to_vec(), ..some() }, 3));
        let empty = AlphaPicture { width: 0, height: 9, alpha: Vec::new() };
        assert!(!is_read(&Coverages { pictures: vec![empty; 2], ..some() }, 3));
    }
}
