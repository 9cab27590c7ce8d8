//! Six pictures of everything around, a skybox, as the one picture that an environment is.
//!
//! Faces are those of cube textures, in OpenGL's order and orientation: +X, −X, +Y, −Y, +Z, −Z, the first row on top. The space
//! of such a texture is left-handed: its +Z lies ahead, +X to the right and +Y above. So the face +Z lies along the world's
//! −Z, the way a camera without a rotation looks, all others where that puts them, and pictures are not mirrored.
//!
//! Source: the OpenGL 4.6 specification, table 8.19, *Selection of cube map images*; the KTX File Format Specification 2.0,
//! 3.6, *faceCount*.

use std::fs;
use std::path::Path;

use glam::Vec3;

use super::{Environment, MOST_WIDTH, linear, picture};
use crate::Texture;
use crate::error::{Fault, SceneError};
use crate::import::cube_faces;

/// What the pictures of a folder may be called, in the order of faces.
const NAMES: [[&str; 6]; 3] = [
    ["px", "nx", "py", "ny", "pz", "nz"],
    ["posx", "negx", "posy", "negy", "posz", "negz"],
    ["right", "left", "top", "bottom", "front", "back"],
];

/// The faces of a cube, each as wide and as high as the others, in the order of [`NAMES`].
#[derive(Debug)]
struct Cube {
    faces: [Environment; 6],
}

/// Reads the six pictures of a folder.
pub(super) fn of_folder(folder: &Path, name: String) -> Result<Environment, SceneError> {
    let fault = |fault: Fault| fault.in_file(folder.display());
    let listed = fs::read_dir(folder).map_err(|why| SceneError::read(why, folder))?;
    let mut files: Vec<String> = Vec::new();
    for file in listed {
        let file = file.map_err(|why| SceneError::read(why, folder))?;
        if !file.path().is_dir() {
            files.extend(file.file_name().into_string());
        }
    }
    files.sort();
    let mut faces: Vec<Environment> = Vec::new();
    let mut side = 0;
    for file in faces_of(&files).map_err(fault)? {
        let path = folder.join(&file);
        let bytes = fs::read(&path).map_err(|why| SceneError::read(why, &path))?;
        let face = picture(&bytes, file).map_err(fault)?;
        let first = faces.first().map(|first| (first.name.as_str(), side));
        check_size(&face.name, [face.width, face.height], first).map_err(fault)?;
        side = face.width;
        faces.push(reduced(face));
    }
    let faces = faces.try_into().map_err(|_| fault(Fault("need six faces".to_owned())))?;
    Ok(Cube { faces }.unrolled(name))
}

/// Reads the six faces of a KTX2 file.
pub(super) fn of_ktx2(bytes: &[u8], name: String) -> Result<Environment, Fault> {
    let faces = cube_faces(bytes, &name)?;
    check_size(&name, [faces[0].width, faces[0].height], None)?;
    let faces = faces.map(|Texture { name, width, height, rgba }| {
        let channel = |byte: u8| linear(f32::from(byte) / 255.0);
        let light =
            rgba.as_chunks().0.iter().map(|[r, g, b, _]: &[u8; 4]| [*r, *g, *b].map(channel)).collect();
        reduced(Environment { name, width, height, light })
    });
    Ok(Cube { faces }.unrolled(name))
}

/// Which of a folder's files is which face.
fn faces_of(files: &[String]) -> Result<[String; 6], Fault> {
    let is_called = |file: &str, name: &str| {
        let stem = Path::new(file).file_stem().map(|stem| stem.to_string_lossy().to_lowercase());
        let last = stem.as_deref().and_then(|stem| stem.rsplit(|c: char| !c.is_alphanumeric()).next());
        last == Some(name)
    };
    let called = |name: &str| files.iter().filter(|file| is_called(file, name)).collect::<Vec<_>>();
    let there = |names: &&[&str; 6]| names.iter().filter(|name| !called(name).is_empty()).count();
    // Of those that fit alike, the first.
    let names = NAMES.iter().rev().max_by_key(there).unwrap_or(&NAMES[0]);
    if there(&names) == 0 {
        let sets = NAMES.map(|names| names.join(", ")).join("; or ");
        let all = "the folder holds no face of a cube, need six square pictures whose names end in";
        return Err(Fault(format!("{all} {sets}")));
    }
    let face = |name: &str| match &called(name)[..] {
        [file] => Ok((*file).clone()),
        [] => Err(Fault(format!(
            "the cube has no face {name:?}, need a picture whose name ends so, beside {}",
            names.iter().filter(|other| **other != name).copied().collect::<Vec<_>>().join(", ")
        ))),
        [one, other, ..] => {
            Err(Fault(format!("the cube has two faces {name:?}, {one:?} and {other:?}, need one of them")))
        }
    };
    let [px, nx, py, ny, pz, nz] = *names;
    Ok([face(px)?, face(nx)?, face(py)?, face(ny)?, face(pz)?, face(nz)?])
}

/// Refuses what is no square, or of another size than the first face, of which name and side are given.
fn check_size(name: &str, [width, height]: [u32; 2], first: Option<(&str, u32)>) -> Result<(), Fault> {
    if width != height {
        return Err(Fault(format!(
            "the face {name:?} has {width} by {height} pixels, need as many rows as columns"
        )));
    }
    match first {
        Some((other, side)) if side != width => Err(Fault(format!(
            "the face {name:?} has {width} by {height} pixels and {other:?} has {side} by {side}, need six of one size"
        ))),
        Some(_) | None => Ok(()),
    }
}

/// A face no finer than the picture that is made of it can show.
fn reduced(mut face: Environment) -> Environment {
    while 4 * face.width > 2 * MOST_WIDTH {
        face = face.halved();
    }
    face
}

impl Cube {
    /// The picture of all around: once around as wide as the four faces there.
    fn unrolled(&self, name: String) -> Environment {
        let width = (4 * self.side()).clamp(2, MOST_WIDTH);
        let height = width / 2;
        let share = |pixel: u32, quarter: f32, of: u32| (pixel as f32 + quarter) / of as f32;
        let pixel = |x: u32, y: u32| {
            let mut sum = Vec3::ZERO;
            for (dx, dy) in [(0.25, 0.25), (0.75, 0.25), (0.25, 0.75), (0.75, 0.75)] {
                let [x, y, z] = Environment::direction(share(x, dx, width), share(y, dy, height)).to_array();
                sum += self.light(Vec3::new(x, y, -z));
            }
            (0.25 * sum).to_array()
        };
        let light = (0..height).flat_map(|y| (0..width).map(move |x| (x, y))).map(|(x, y)| pixel(x, y));
        Environment { name, width, height, light: light.collect() }
    }

    fn side(&self) -> u32 {
        self.faces[0].width
    }

    /// The light from a direction of the cube's own space, between the four texels around it.
    fn light(&self, direction: Vec3) -> Vec3 {
        let (face, [s, t]) = place(direction);
        let at = |share: f32| share * self.side() as f32 - 0.5;
        let (x, y) = (at(s), at(t));
        let (left, top) = (x.floor(), y.floor());
        let row = |y: f32| {
            let [left, right] = [left, left + 1.0].map(|x| self.texel(face, x, y));
            left.lerp(right, x - x.floor())
        };
        row(top).lerp(row(top + 1.0), y - top)
    }

    /// A texel by its column and row; one beyond an edge is the nearest of the face there.
    fn texel(&self, face: usize, x: f32, y: f32) -> Vec3 {
        let side = self.side();
        let inside = 0.0..side as f32;
        let (face, x, y) = if inside.contains(&x) && inside.contains(&y) {
            (face, x, y)
        } else {
            let share = |texel: f32| (texel + 0.5) / side as f32;
            let (face, [s, t]) = place(direction(face, [share(x), share(y)]));
            (face, s * side as f32, t * side as f32)
        };
        let number = |texel: f32| (texel as u32).min(side - 1);
        Vec3::from_array(self.faces[face].light[(number(y) * side + number(x)) as usize])
    }
}

/// The axes of each face in the cube's own space: where its middle lies, where its columns go and where its rows go.
const AXES: [[Vec3; 3]; 6] = [
    [Vec3::X, Vec3::NEG_Z, Vec3::NEG_Y],
    [Vec3::NEG_X, Vec3::Z, Vec3::NEG_Y],
    [Vec3::Y, Vec3::X, Vec3::Z],
    [Vec3::NEG_Y, Vec3::X, Vec3::NEG_Z],
    [Vec3::Z, Vec3::X, Vec3::NEG_Y],
    [Vec3::NEG_Z, Vec3::NEG_X, Vec3::NEG_Y],
];

/// The face that shows a direction, and where on it: shares of its columns and rows.
fn place(direction: Vec3) -> (usize, [f32; 2]) {
    let size = direction.abs();
    let axis = if size.x >= size.y && size.x >= size.z {
        0
    } else if size.y >= size.z {
        1
    } else {
        2
    };
    let face = 2 * axis + usize::from(direction[axis] < 0.0);
    let [_, across, down] = AXES[face];
    let share = |along: Vec3| 0.5 + 0.5 * along.dot(direction) / size[axis].max(f32::MIN_POSITIVE);
    (face, [share(across), share(down)])
}

/// The direction, of any length, of a place on a face or beside it.
fn direction(face: usize, [s, t]: [f32; 2]) -> Vec3 {
    let [middle, across, down] = AXES[face];
    middle + across * (2.0 * s - 1.0) + down * (2.0 * t - 1.0)
}

#[cfg(test)]
mod tests;
