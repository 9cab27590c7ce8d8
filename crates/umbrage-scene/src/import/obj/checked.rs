//! The text of an OBJ or MTL file, made safe for `tobj` 4.0, which
//!
//! - takes a polyline of three points for a triangle: lines and points are dropped;
//! - wants all vertices coloured or none: colours are dropped;
//! - multiplies face indices before it checks them: every index is checked here;
//! - panics on a colour of fewer than three numbers: that is a fault here;
//! - ends at bytes that are not UTF-8: they are replaced, since they are mostly in names and comments.

use crate::error::Fault;

/// What `tobj` calls an object before the first name. One of this name in a file is called after the file, too.
pub(super) const NO_NAME: &str = "unnamed_object";

/// An OBJ file that `tobj` can be given.
#[derive(Debug, Default)]
pub(super) struct Text {
    pub text: String,
    /// Names of the material libraries it refers to, each once.
    pub libraries: Vec<String>,
    /// Corners of all triangles.
    pub corners: usize,
}

/// Checks an OBJ file.
pub(super) fn object(bytes: &[u8]) -> Result<Text, Fault> {
    let source = String::from_utf8_lossy(bytes);
    // A line that ends in a backslash goes on in the next.
    let source = if source.contains('\\') {
        source.replace("\\\r\n", " ").replace("\\\n", " ").into()
    } else {
        source
    };
    let lines = || source.lines().zip(1..).map(|(line, number)| (line.trim(), number));
    let keyword = |line: &str| line.split_whitespace().next().map_or(0, str::len);
    // Positions, texture coordinates, normals: first all of them, since a face may refer to later ones.
    let mut all = [0; 3];
    let kind = |word: &str| ["v", "vt", "vn"].iter().position(|&kind| kind == word);
    for (line, _) in lines() {
        if let Some(kind) = kind(&line[..keyword(line)]) {
            all[kind] += 1;
        }
    }
    let mut checked = Text { text: String::with_capacity(source.len()), ..Text::default() };
    let mut so_far = [0; 3];
    for (line, number) in lines() {
        let (word, rest) = line.split_at(keyword(line));
        match word {
            "v" | "vt" | "vn" => so_far[kind(word).unwrap_or_default()] += 1,
            "f" => {
                let corners =
                    face(rest, so_far, all).map_err(|why| Fault(format!("{why}, line {number}")))?;
                checked.corners = checked.corners.saturating_add(corners);
            }
            "mtllib" => {
                let name = rest.trim().to_owned();
                if !checked.libraries.contains(&name) {
                    checked.libraries.push(name);
                }
            }
            "o" | "g" | "usemtl" => {}
            _ => continue,
        }
        // One space after the word: `tobj` splits names off at the first space.
        checked.text.push_str(word);
        if word == "v" && rest.split_whitespace().count() == 6 {
            for coordinate in rest.split_whitespace().take(3) {
                checked.text.push(' ');
                checked.text.push_str(coordinate);
            }
        } else {
            checked.text.push(' ');
            checked.text.push_str(rest.trim_start());
        }
        checked.text.push('\n');
    }
    Ok(checked)
}

/// How many corners a face has after it is cut into triangles.
fn face(corners: &str, so_far: [i64; 3], all: [i64; 3]) -> Result<usize, String> {
    let mut count = 0usize;
    for corner in corners.split_whitespace() {
        count += 1;
        for (kind, index) in corner.split('/').enumerate() {
            let (Some(&before), Some(&all)) = (so_far.get(kind), all.get(kind)) else {
                return Err(format!("a corner {corner:?} of more than three indices"));
            };
            if index.is_empty() && kind > 0 {
                continue;
            }
            let number: i64 =
                index.parse().map_err(|_| format!("a corner {corner:?} that is not an index"))?;
            if !(1..=all).contains(&number) && !(-before..=-1).contains(&number) {
                let what = ["vertices", "texture coordinates", "normals"][kind];
                return Err(format!("index {number} of {all} {what}"));
            }
        }
    }
    match count {
        0..3 => Err(format!("a face of {count} corners")),
        _ => Ok(3 * (count - 2)),
    }
}

/// Checks a material library; only colours, shininess and pictures of the diffuse light are kept.
pub(super) fn library(bytes: &[u8]) -> Result<String, Fault> {
    let mut checked = String::new();
    for (line, number) in String::from_utf8_lossy(bytes).lines().zip(1..) {
        let mut words = line.split_whitespace();
        let first = words.next();
        let numbers = words.clone().map_while(|word| word.parse::<f32>().ok()).count();
        // What the program can do without is dropped where it is malformed.
        let wanted = match first {
            Some("Ks" | "Ke") => 3,
            Some("Ns") => 1,
            Some(_) | None => 0,
        };
        match first {
            Some("Kd") if numbers < 3 => {
                return Err(Fault(format!("a diffuse colour that is not 3 numbers, line {number}")));
            }
            Some("newmtl" | "map_Kd") if words.clone().next().is_none() => {
                return Err(Fault(format!("a material or picture without a name, line {number}")));
            }
            Some("map_Kd") if words.clone().any(|word| word.starts_with('-')) => {
                // Options come before the name, which then is the last word.
                checked.push_str("map_Kd ");
                checked.push_str(words.next_back().unwrap_or_default());
                checked.push('\n');
            }
            Some("newmtl" | "Kd" | "map_Kd" | "Ks" | "Ke" | "Ns") if numbers >= wanted => {
                checked.push_str(line.trim());
                checked.push('\n');
            }
            Some(_) | None => {}
        }
    }
    Ok(checked)
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

    fn with(line: &str) -> Result<Text, Fault> {
        object(format!("{SQUARE}{line}\n").as_bytes())
    }

    #[test]
    fn faces_may_count_from_either_end() {
        assert_eq!(with("f 1 2 3 4").unwrap().corners, 6);
        assert_eq!(with("f -4 -3 -2").unwrap().corners, 3);
        assert_eq!(with("f 1 2 \\\n3").unwrap().corners, 3);
    }

    #[test]
    fn indices_that_nothing_answers_to_are_faults_with_their_line() {
        let fault = with("f 1 2 5").unwrap_err().0;
        assert_eq!(fault, "index 5 of 4 vertices, line 5");
        for face in ["f 0 1 2", "f -5 1 2", "f 1/1 2/1 3/1", "f 1//9223372036854775807 2 3", "f 1/2/3/4 1 2"]
        {
            with(face).unwrap_err();
        }
        for face in ["f", "f 1", "f 1 2", "f a b c", "f 1 2 99999999999999999999", "f / / /"] {
            with(face).unwrap_err();
        }
    }

    #[test]
    fn polylines_are_dropped() {
        assert!(!with("l 1 2 3").unwrap().text.contains('l'));
    }

    #[test]
    fn colours_that_tobj_would_panic_on_are_faults() {
        library(b"newmtl a\nKd 1 1\n").unwrap_err();
        assert_eq!(library(b"newmtl a\nKs 1\nmap_Kd -s 2 2 b.png\n").unwrap(), "newmtl a\nmap_Kd b.png\n");
    }
}
