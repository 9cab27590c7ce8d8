//! Where a text's bindings lie: in a group of their own, or behind a host's in one of its groups.

use crate::error::ImportError;

/// The group of a pipeline in which a text's bindings lie, and the number that its binding 0 has there.
///
/// A WebGPU device has four groups. A host that uses all of them gives Umbrage room in one of its own, behind its own bindings:
/// binding `n` of a list as [`receiver_bindings`](crate::receiver_bindings) is `first_binding + n` then. The number of a group
/// stands for a slot that begins at 0.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Slot {
    /// The index of the group.
    pub group: u32,
    /// The number of the first binding.
    pub first_binding: u32,
}

impl From<u32> for Slot {
    fn from(group: u32) -> Self {
        Self { group, first_binding: 0 }
    }
}

impl Slot {
    /// A text whose bindings lie in group 0, from 0 on, with them here. Those in other groups stay where they are.
    pub(crate) fn move_bindings(self, text: &str) -> Result<String, ImportError> {
        text.split_inclusive('\n').map(|line| self.move_line(line)).collect()
    }

    fn move_line(self, line: &str) -> Result<String, ImportError> {
        let (code, comment) = line.split_at(line.find("//").unwrap_or(line.len()));
        let moved: Option<String> =
            code.split_inclusive(';').map(|statement| self.moved(statement)).collect();
        let moved = moved.ok_or_else(|| ImportError::Binding { line: line.trim().to_owned() })?;
        Ok(moved + comment)
    }

    /// A statement with its binding here; `None` where it says otherwise than all others where that lies.
    fn moved(self, statement: &str) -> Option<String> {
        let Some((before, after)) = statement.split_once("@group(0) @binding(") else {
            return is_elsewhere(statement).then(|| statement.to_owned());
        };
        let (number, rest) = after.split_once(')')?;
        let number = number.parse::<u32>().ok()?.checked_add(self.first_binding)?;
        Some(format!("{before}@group({}) @binding({number}){rest}", self.group))
    }
}

/// Whether a statement binds nothing, or in another group than the first.
fn is_elsewhere(statement: &str) -> bool {
    let attributes = || statement.split('@').skip(1).map(str::trim_start);
    let group = attributes().find_map(|name| name.strip_prefix("group")?.trim_start().strip_prefix('('));
    match group {
        Some(group) => group.trim_start().starts_with(|digit: char| ('1'..='9').contains(&digit)),
        None => !attributes().any(|name| name.starts_with("group") || name.starts_with("binding")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bindings_move_and_nothing_else_does() {
        let text = "// @binding(9)\n@group(0) @binding(0) var a: b;\nfn f() {}\n@group(0) @binding(10) var c: d;\n@binding(PLACE) @group(3) var e: f;\n";
        assert_eq!(Slot::default().move_bindings(text).unwrap(), text);
        let moved = Slot { group: 2, first_binding: 3 }.move_bindings(text).unwrap();
        let wanted = "// @binding(9)\n@group(2) @binding(3) var a: b;\nfn f() {}\n@group(2) @binding(13) var c: d;\n@binding(PLACE) @group(3) var e: f;\n";
        assert_eq!(moved, wanted);
        assert_eq!(Slot::from(1), Slot { group: 1, first_binding: 0 });
    }

    #[test]
    fn bindings_that_are_written_otherwise_are_refused_with_how_to_write_them() {
        for otherwise in [
            "@group(0) @binding(1u) var a: b;",
            "@group(0) @binding(PLACE) var a: b;",
            "@group(0)@binding(1) var a: b;",
            "@binding(1) @group(0) var a: b;",
            "@group(0) @binding(1) var a: b; @group(0) @ binding(2) var c: d;",
            "@group(0)\n@binding(1) var a: b;",
            "@group(0) @binding(4294967296) var a: b;",
        ] {
            let error = Slot::from(2).move_bindings(otherwise).unwrap_err().to_string();
            assert!(error.contains(otherwise.lines().next().unwrap_or_default()), "{error}");
            assert!(error.contains("`@group(0) @binding(7)`"), "{error}");
        }
    }
}
