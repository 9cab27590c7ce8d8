//! Where a text's bindings lie: in a group of their own, or behind a host's in one of its groups.

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
    /// A text whose bindings lie in group 0, from 0 on, with them here.
    pub(crate) fn move_bindings(self, text: &str) -> String {
        const BINDING: &str = "@group(0) @binding(";
        let mut parts = text.split(BINDING);
        let mut moved = parts.next().unwrap_or_default().to_owned();
        for part in parts {
            let (number, rest) = part.split_once(')').unwrap_or((part, ""));
            let number = number.parse().unwrap_or(0_u32).saturating_add(self.first_binding);
            moved += &format!("@group({}) @binding({number}){rest}", self.group);
        }
        moved
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bindings_move_and_nothing_else_does() {
        let text =
            "// @binding(9)\n@group(0) @binding(0) var a: b;\nfn f() {}\n@group(0) @binding(10) var c: d;\n";
        assert_eq!(Slot::default().move_bindings(text), text);
        let moved = Slot { group: 2, first_binding: 3 }.move_bindings(text);
        let wanted =
            "// @binding(9)\n@group(2) @binding(3) var a: b;\nfn f() {}\n@group(2) @binding(13) var c: d;\n";
        assert_eq!(moved, wanted);
        assert_eq!(Slot::from(1), Slot { group: 1, first_binding: 0 });
    }
}
