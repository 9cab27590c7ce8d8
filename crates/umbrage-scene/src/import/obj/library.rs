//! The text of a material library, made safe for `tobj` 4.0, which panics on a colour of fewer than three numbers. Only
//! colours, shininess and pictures of the diffuse light are kept; a line that cannot be read loses itself.

use super::super::warnings::Warnings;

/// Checks a material library called `name`.
pub(super) fn library(bytes: &[u8], name: &str, warnings: &mut Warnings) -> String {
    let mut checked = String::new();
    // Before the first name, and after a name that is none, there is nothing to say anything of.
    let mut material = None;
    for (line, number) in String::from_utf8_lossy(bytes).lines().zip(1..) {
        let mut words = line.split_whitespace();
        let mut broken = |what: &str| {
            let subject = format!("{what}, line {number} of {name:?}");
            warnings.note("lines of material libraries that cannot be read are ignored", &subject);
        };
        let word = words.next().unwrap_or_default();
        let arguments: Vec<&str> = words.collect();
        let numbers =
            || arguments.iter().map_while(|word| word.parse::<f32>().ok().filter(|x| x.is_finite()));
        match word {
            "newmtl" if arguments.is_empty() => {
                material = None;
                broken("a material without a name");
            }
            "newmtl" => {
                material = Some(arguments.join(" "));
                keep(&mut checked, line);
            }
            "Kd" if numbers().count() < 3 => broken("a diffuse colour that is not 3 numbers"),
            "map_Kd" if arguments.is_empty() => broken("a picture without a name"),
            "Kd" | "map_Kd" if material.is_none() => broken("a colour or picture of no material"),
            "map_Kd" if arguments.iter().any(|word| word.starts_with('-')) => {
                // Options come before the name, which then is the last word.
                keep(&mut checked, &format!("map_Kd {}", arguments.last().unwrap_or(&"")));
            }
            "Kd" | "map_Kd" => keep(&mut checked, line),
            // The program can do without these, and without a word.
            "Ks" | "Ke" if numbers().count() >= 3 && material.is_some() => keep(&mut checked, line),
            "Ns" if numbers().count() >= 1 && material.is_some() => keep(&mut checked, line),
            "d" | "Tr" | "map_d" => {
                let share = numbers().next();
                let is_clear = match word {
                    "d" => share.is_some_and(|share| share < 1.0),
                    "Tr" => share.is_some_and(|share| share > 0.0),
                    _ => !arguments.is_empty(),
                };
                if is_clear {
                    let name = material.as_deref().unwrap_or(name);
                    warnings.note("transparent materials are drawn as opaque", name);
                }
            }
            _ => {}
        }
    }
    checked
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
    fn options_of_pictures_are_dropped() {
        assert_eq!(read("newmtl a\nmap_Kd -s 2 2 b.png\n"), ("newmtl a\nmap_Kd b.png\n".to_owned(), 0));
    }

    #[test]
    fn materials_that_let_light_through_are_told() {
        for clear in ["d 0.5", "Tr 0.1", "map_d leaf.png"] {
            assert_eq!(read(&format!("newmtl a\n{clear}\n")).1, 1, "{clear}");
        }
        for opaque in ["d 1", "d 1.0", "Tr 0", "Tr 0.0", "map_d"] {
            assert_eq!(read(&format!("newmtl a\n{opaque}\n")).1, 0, "{opaque}");
        }
    }
}
