//! The text of an OBJ file, made safe for `tobj` 4.0, which
//!
//! - keeps f32 of a coordinate: far vertices are moved to an origin of the scene's own, in f64, before;
//! - cuts polygons as fans: they are cut into triangles here;
//! - takes a polyline of three points for a triangle: lines and points are dropped;
//! - wants all vertices coloured or none: colours are dropped;
//! - multiplies face indices before it checks them, and knows only vertices that come before: every index is checked and
//!   counted from the first here, and all vertices come first;
//! - stops at the first line it does not understand: that line is left out here, with a warning;
//! - ends at bytes that are not UTF-8: they are replaced, since they are mostly in names and comments.

use std::fmt::Write as _;

use glam::DVec3;

use super::super::extent::Extent;
use super::super::settle::FARTHEST;
use super::super::warnings::Warnings;
use super::super::{polygon, recentre};

/// What `tobj` calls an object before the first name. One of this name in a file is called after the file, too.
pub(super) const NO_NAME: &str = "unnamed_object";

/// Neighbours in a file are neighbours in space: so many vertices are one box when the scene's middle is sought.
const VERTICES_A_BOX: usize = 64;

/// An OBJ file that `tobj` can be given.
#[derive(Debug, Default)]
pub(super) struct Text {
    pub text: String,
    /// Names of the material libraries it refers to, each once.
    pub libraries: Vec<String>,
    /// Corners of all triangles.
    pub corners: usize,
    /// Where in the file the text's origin is.
    pub origin: DVec3,
}

/// What stands on the lines of vertices; `None` where it cannot be drawn.
#[derive(Default)]
struct Vertices {
    positions: Vec<Option<DVec3>>,
    uvs: Vec<Option<[f64; 2]>>,
    normals: Vec<Option<[f64; 3]>>,
}

/// A corner of a face, as places in the lists of vertices, from 0.
#[derive(Clone, Copy)]
struct Corner {
    position: usize,
    uv: Option<usize>,
    normal: Option<usize>,
}

/// Checks an OBJ file.
pub(super) fn object(bytes: &[u8], warnings: &mut Warnings) -> Text {
    let source = String::from_utf8_lossy(bytes);
    // A line that ends in a backslash goes on in the next.
    let source = if source.contains('\\') {
        source.replace("\\\r\n", " ").replace("\\\n", " ").into()
    } else {
        source
    };
    let mut vertices = Vertices::read(&source, warnings);
    let mut checked = Text { origin: vertices.recentre(), ..Text::default() };
    vertices.write(&mut checked.text);
    let mut so_far = [0usize; 3];
    for (line, number) in lines(&source) {
        let (word, rest) = split(line);
        match word {
            "v" => so_far[0] += 1,
            "vt" => so_far[1] += 1,
            "vn" => so_far[2] += 1,
            "f" => {
                if let Err(why) = face(rest, so_far, &vertices, &mut checked, (number, warnings)) {
                    warnings.note("faces that cannot be read are left out", &format!("line {number}, {why}"));
                }
            }
            "mtllib" => {
                let name = rest.trim().to_owned();
                if !checked.libraries.contains(&name) {
                    checked.libraries.push(name);
                }
                name_line(&mut checked.text, word, rest);
            }
            "o" | "g" | "usemtl" => name_line(&mut checked.text, word, rest),
            _ => {}
        }
    }
    checked
}

/// The lines with their numbers, without space around them.
fn lines(source: &str) -> impl Iterator<Item = (&str, usize)> {
    source.lines().zip(1..).map(|(line, number)| (line.trim(), number))
}

/// The first word, and what follows it.
fn split(line: &str) -> (&str, &str) {
    line.split_at(line.find(char::is_whitespace).unwrap_or(line.len()))
}

/// One space after the word: `tobj` splits names off at the first space.
fn name_line(text: &mut String, word: &str, rest: &str) {
    text.push_str(word);
    text.push(' ');
    text.push_str(rest.trim_start());
    text.push('\n');
}

/// The first `N` numbers of a line, where they are finite.
fn numbers<const N: usize>(rest: &str) -> Option<[f64; N]> {
    let mut words = rest.split_whitespace();
    let mut numbers = [0.0; N];
    for number in &mut numbers {
        *number = words.next()?.parse().ok().filter(|x: &f64| x.is_finite())?;
    }
    Some(numbers)
}

impl Vertices {
    /// Reads the lines of vertices. What a broken one is needed for is said where it is needed.
    fn read(source: &str, warnings: &mut Warnings) -> Self {
        let mut read = Self::default();
        for (line, number) in lines(source) {
            let (word, rest) = split(line);
            let is_read = match word {
                "v" => {
                    let position = numbers(rest).map(DVec3::from);
                    read.positions.push(position);
                    position.is_some()
                }
                "vt" => {
                    // The second may be left out.
                    let uv = numbers(rest).or_else(|| numbers::<1>(rest).map(|[u]| [u, 0.0]));
                    read.uvs.push(uv);
                    uv.is_some()
                }
                "vn" => {
                    let normal = numbers(rest);
                    read.normals.push(normal);
                    normal.is_some()
                }
                _ => true,
            };
            if !is_read {
                warnings.note("vertices that are not finite numbers are left out", &format!("line {number}"));
            }
        }
        read
    }

    /// Moves all positions to an origin amid them, if they are far from the file's. Returns it.
    fn recentre(&mut self) -> DVec3 {
        let points = |some: &[Option<DVec3>]| {
            some.iter().flatten().fold(Extent::EMPTY, |sum, &p| sum.union(Extent { min: p, max: p }))
        };
        let boxes: Vec<Extent> =
            self.positions.chunks(VERTICES_A_BOX).map(points).filter(Extent::is_finite).collect();
        let origin = recentre::origin(&boxes);
        for position in &mut self.positions {
            *position = position.map(|p| p - origin).filter(|p| p.abs().max_element() <= FARTHEST);
        }
        origin
    }

    /// Writes all vertices, those that are broken as zeros; after the last of the file, one of zeros for indices that
    /// lead nowhere.
    fn write(&self, text: &mut String) {
        let zeros = |count: usize| std::iter::repeat_n(0.0, count);
        let mut line = |word: &str, numbers: &mut dyn Iterator<Item = f64>| {
            text.push_str(word);
            for number in numbers {
                // Writing to a string cannot fail.
                let _ = write!(text, " {}", number as f32);
            }
            text.push('\n');
        };
        for p in &self.positions {
            line("v", &mut p.unwrap_or_default().to_array().into_iter());
        }
        for uv in &self.uvs {
            line("vt", &mut uv.unwrap_or_default().into_iter());
        }
        line("vt", &mut zeros(2));
        for normal in &self.normals {
            line("vn", &mut normal.unwrap_or_default().into_iter());
        }
        line("vn", &mut zeros(3));
    }
}

/// Cuts a face into triangles and writes them.
fn face(
    rest: &str,
    so_far: [usize; 3],
    vertices: &Vertices,
    checked: &mut Text,
    (number, warnings): (usize, &mut Warnings),
) -> Result<(), String> {
    let mut corners = Vec::new();
    let mut positions = Vec::new();
    for word in rest.split_whitespace() {
        let corner = corner(word, so_far, vertices, (number, &mut *warnings))?;
        let position = vertices.positions[corner.position];
        positions.push(position.ok_or_else(|| {
            format!("vertex {} has no place, need finite numbers up to {FARTHEST:e}", corner.position + 1)
        })?);
        corners.push(corner);
    }
    if corners.len() < 3 {
        return Err(format!("a face of {} corners", corners.len()));
    }
    let cut = polygon::cut(&positions);
    if !cut.is_true {
        let what = "polygons whose edges cross are cut into triangles as well as it goes";
        warnings.note(what, &format!("line {number}"));
    }
    checked.corners = checked.corners.saturating_add(3 * cut.triangles.len());
    for triangle in cut.triangles {
        checked.text.push('f');
        for Corner { position, uv, normal } in triangle.map(|i| corners[i]) {
            let text = &mut checked.text;
            // Writing to a string cannot fail.
            let _ = match (uv, normal) {
                (None, None) => write!(text, " {}", position + 1),
                (Some(uv), None) => write!(text, " {}/{}", position + 1, uv + 1),
                (None, Some(normal)) => write!(text, " {}//{}", position + 1, normal + 1),
                (Some(uv), Some(normal)) => write!(text, " {}/{}/{}", position + 1, uv + 1, normal + 1),
            };
        }
        checked.text.push('\n');
    }
    Ok(())
}

/// A corner's places. An index that leads to no position is an error; one to nothing else leads to zeros instead.
fn corner(
    word: &str,
    so_far: [usize; 3],
    vertices: &Vertices,
    (number, warnings): (usize, &mut Warnings),
) -> Result<Corner, String> {
    let all = [vertices.positions.len(), vertices.uvs.len(), vertices.normals.len()];
    let mut places = [None; 3];
    for (kind, index) in word.split('/').enumerate() {
        let (Some(place), Some(&all), Some(&before)) =
            (places.get_mut(kind), all.get(kind), so_far.get(kind))
        else {
            return Err(format!("a corner {word:?} of more than three indices"));
        };
        if index.is_empty() && kind > 0 {
            continue;
        }
        let found: i64 = index.parse().map_err(|_| format!("a corner {word:?} that is not an index"))?;
        let from_first = if found < 0 { before as i64 + found } else { found - 1 };
        let is_there = (0..all as i64).contains(&from_first);
        if !is_there {
            let what = ["vertices", "texture coordinates", "normals"][kind];
            let why = format!("index {found} of {all} {what}");
            if kind == 0 {
                return Err(why);
            }
            let note = "texture coordinates and normals that are not in the file become 0 and flat";
            warnings.note(note, &format!("line {number}, {why}"));
        }
        *place = Some(if is_there { from_first as usize } else { all });
    }
    let [Some(position), uv, normal] = places else {
        return Err(format!("a corner {word:?} without a vertex"));
    };
    Ok(Corner { position, uv, normal })
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

    fn with(line: &str) -> (Text, Vec<String>) {
        let mut warnings = Warnings::default();
        let text = object(format!("{SQUARE}{line}\n").as_bytes(), &mut warnings);
        (text, warnings.into_lines())
    }

    #[test]
    fn faces_may_count_from_either_end() {
        for (line, corners) in [("f 1 2 3 4", 6), ("f -4 -3 -2", 3), ("f 1 2 \\\n3", 3)] {
            let (text, warnings) = with(line);
            assert_eq!((text.corners, warnings.len()), (corners, 0), "{line}");
        }
        assert!(with("f -4 -3 -2").0.text.ends_with("f 1 2 3\n"));
    }

    #[test]
    fn faces_may_come_before_their_vertices() {
        let mut warnings = Warnings::default();
        let text = object(format!("f 1 2 3\n{SQUARE}").as_bytes(), &mut warnings);
        assert_eq!((text.corners, warnings.into_lines().len()), (3, 0));
    }

    #[test]
    fn indices_that_nothing_answers_to_lose_their_face_with_its_line() {
        let (text, warnings) = with("f 1 2 5\nf 1 2 3");
        assert_eq!(text.corners, 3);
        assert_eq!(warnings, ["faces that cannot be read are left out: line 5, index 5 of 4 vertices"]);
        for face in [
            "f 0 1 2",
            "f -5 1 2",
            "f 1///4 1 2",
            "f",
            "f 1",
            "f 1 2",
            "f a b c",
            "f / / /",
            "f 1 2 99999999999999999999",
            "f -9223372036854775808 1 2",
        ] {
            let (text, warnings) = with(face);
            assert_eq!((text.corners, warnings.len()), (0, 1), "{face}");
        }
    }

    #[test]
    fn texture_coordinates_and_normals_that_are_not_there_lose_themselves() {
        for face in ["f 1/1 2/1 3/1", "f 1//9223372036854775807 2//1 3//-1"] {
            let (text, warnings) = with(face);
            assert_eq!((text.corners, warnings.len()), (3, 1), "{face}: {warnings:?}");
        }
    }

    #[test]
    fn polylines_are_dropped() {
        assert!(!with("l 1 2 3").0.text.contains('l'));
    }

    #[test]
    fn far_vertices_are_moved_before_they_are_rounded() {
        let mut warnings = Warnings::default();
        let far = "v 500000.125 0 0\nv 500001.0001 0 0\nv 500000 1 0\nf 1 2 3\n";
        let Text { text, origin, .. } = object(far.as_bytes(), &mut warnings);
        assert_eq!(origin, DVec3::new(500_000.5, 0.5, 0.0));
        assert!(text.starts_with("v -0.375 -0.5 0\nv 0.5001 "), "{text}");
    }
}
