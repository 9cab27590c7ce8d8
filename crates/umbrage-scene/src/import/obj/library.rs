//! The text of a material library, made safe for `tobj` 4.0, which panics on a colour of fewer than three numbers. Only
//! colours, shininess, coverage, and pictures of the diffuse light and of coverage are kept; a line that cannot be read
//! loses itself.
//!
//! Coverage is `d`, or 1 − `Tr` where there is no `d`: some write both, and mean the same by them. A picture of coverage is
//! written with its options, under a word that `tobj` does not know.

use super::super::warnings::Warnings;
use super::picture_options::Picture;

/// What pictures of coverage are called in the checked text.
pub(super) const DISSOLVE: &str = "umbrage_map_d";

/// Checks a material library called `name`.
pub(super) fn library(bytes: &[u8], name: &str, warnings: &mut Warnings) -> String {
    let mut checked = String::new();
    // Before the first name, and after a name that is none, there is nothing to say anything of.
    let mut material = None;
    let mut has_d = false;
    for (line, number) in String::from_utf8_lossy(bytes).lines().zip(1..) {
        let mut words = line.split_whitespace();
        let mut broken = |what: &str| {
            let subject = format!("{what}, line {number} of {name:?}");
            warnings.note("lines of material libraries that cannot be read are ignored", &subject);
        };
        let word = words.next().unwrap_or_default();
        let arguments: Vec<&str> = words.collect();
        let numbers = || arguments.iter().map_while(|word| finite(word));
        // With `-halo` it would fade toward edges.
        let coverage = arguments.iter().find(|word| **word != "-halo").and_then(|word| finite(word));
        let picture = Picture::read(rest(line));
        match word {
            "newmtl" if arguments.is_empty() => {
                material = None;
                broken("a material without a name");
            }
            "newmtl" => {
                material = Some(());
                has_d = false;
                keep(&mut checked, line);
            }
            "Kd" if numbers().count() < 3 => broken("a diffuse colour that is not 3 numbers"),
            "map_Kd" | "map_d" if picture.is_none() => broken("a picture without a name"),
            "Kd" | "map_Kd" | "map_d" | "d" | "Tr" if material.is_none() => {
                broken("a colour, picture or coverage of no material");
            }
            "Kd" => keep(&mut checked, line),
            "map_Kd" | "map_d" => {
                let Some(picture) = picture else { continue };
                if let Some(option) = &picture.ignored {
                    let subject = format!("{option}, line {number} of {name:?}");
                    warnings.note("options of pictures are ignored", &subject);
                }
                match word {
                    // Its options are for scalars.
                    "map_Kd" => keep(&mut checked, &format!("map_Kd {}", picture.name)),
                    _ => keep(&mut checked, &format!("{DISSOLVE} {}", rest(line))),
                }
            }
            "d" | "Tr" if coverage.is_none() => broken("a coverage that is not a number"),
            "d" | "Tr" => {
                let share = coverage.unwrap_or(1.0);
                // Whatever comes later, `d` counts.
                if word == "d" || !has_d {
                    keep(&mut checked, &format!("d {}", if word == "d" { share } else { 1.0 - share }));
                }
                has_d |= word == "d";
            }
            // The program can do without these, and without a word.
            "Ks" | "Ke" if numbers().count() >= 3 && material.is_some() => keep(&mut checked, line),
            "Ns" if numbers().count() >= 1 && material.is_some() => keep(&mut checked, line),
            _ => {}
        }
    }
    checked
}

/// What follows the first word.
fn rest(line: &str) -> &str {
    line.trim().split_once(char::is_whitespace).map_or("", |(_, rest)| rest.trim())
}

fn finite(word: &str) -> Option<f32> {
    word.parse().ok().filter(|x: &f32| x.is_finite())
}

fn keep(checked: &mut String, line: &str) {
    checked.push_str(line.trim());
    checked.push('\n');
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> (String, usize) {
        let mut warnings = Warnings::default();
        let text = library(text.as_bytes(), "a.mtl", &mut warnings);
        (text, warnings.into_lines().len())
    }

    #[test]
    fn lines_that_tobj_would_panic_on_are_left_out_alone() {
        for broken in ["Kd 1 1", "Kd x y z", "Kd nan 0 0", "map_Kd", "Kd"] {
            let (text, count) = read(&format!("newmtl a\n{broken}\nKs 1\nnewmtl b\nKd 1 0 0\n"));
            assert_eq!((text.as_str(), count), ("newmtl a\nnewmtl b\nKd 1 0 0\n", 1), "{broken}");
        }
        assert_eq!(read("newmtl\nKd 1 1 1\nnewmtl b\n"), ("newmtl b\n".to_owned(), 1));
    }

    #[test]
    fn what_shines_is_kept_where_it_is_numbers_of_a_material() {
        let whole = "newmtl a\nKs 1 1 1\nKe 0 2 0\nNs 30\n";
        assert_eq!(read(whole), (whole.to_owned(), 0));
        for broken in ["Ks 1", "Ke x y z", "Ns nan", "Ns", "Ke 0 1e39 0"] {
            assert_eq!(read(&format!("newmtl a\n{broken}\n")), ("newmtl a\n".to_owned(), 0), "{broken}");
        }
        assert_eq!(read("Ks 1 1 1\nKe 1 1 1\nNs 3\nnewmtl a\n"), ("newmtl a\n".to_owned(), 0));
    }

    #[test]
    fn options_of_pictures_are_dropped_and_those_that_would_show_are_told() {
        let kept = "newmtl a\nmap_Kd my b.png\n".to_owned();
        assert_eq!(read("newmtl a\nmap_Kd -s 1 1 -cc on my b.png\n"), (kept.clone(), 0));
        assert_eq!(read("newmtl a\nmap_Kd -s 2 2 my b.png\n"), (kept, 1));
    }

    #[test]
    fn coverage_is_d_or_what_tr_leaves() {
        for (lines, kept) in [
            ("d 0.25", "d 0.25\n"),
            ("Tr 0.25", "d 0.75\n"),
            ("d 1\nTr 1", "d 1\n"),
            ("Tr 1\nd 0.5", "d 0\nd 0.5\n"),
            ("d -halo 0.5", "d 0.5\n"),
            ("map_d -imfchan r  my leaf.png", "umbrage_map_d -imfchan r  my leaf.png\n"),
        ] {
            assert_eq!(read(&format!("newmtl a\n{lines}\n")), (format!("newmtl a\n{kept}"), 0), "{lines}");
        }
        let both = "newmtl a\nd 1\nnewmtl b\nTr 0.5\n";
        assert_eq!(read(both).0, "newmtl a\nd 1\nnewmtl b\nd 0.5\n", "each material by itself");
        for broken in ["d", "d x", "Tr nan", "map_d", "map_d -s 2 2", "d -halo"] {
            assert_eq!(read(&format!("newmtl a\n{broken}\n")), ("newmtl a\n".to_owned(), 1), "{broken}");
            assert_eq!(read(&format!("{broken}\n")).1, 1, "{broken}");
        }
    }
}
