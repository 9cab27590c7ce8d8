//! What the channels of an animation move: a property of a node, named by the node or by a pointer into the document.
//!
//! Source: glTF 2.0, section 3.11, *Animations*; `KHR_animation_pointer`; the glTF 2.0 Asset Object Model.

use gltf::json::Value;

use super::visibility::VISIBILITY;

/// A property of a node that animations move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Property {
    Translation,
    Rotation,
    Scale,
    Weights,
    Visible,
}

/// What a channel moves.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Target {
    /// This property of the node with this number in the file.
    Node(usize, Property),
    /// Something that changes no shadow: here is the pointer to it.
    Elsewhere(String),
    /// Nothing, for this reason.
    Nothing(String),
}

/// What the member `target` of a channel names, in a file of so many nodes.
pub(super) fn of(target: Option<&Value>, nodes: usize) -> Target {
    let Some(target) = target else {
        return Target::Nothing("it has no target".to_owned());
    };
    let path = target.get("path").and_then(Value::as_str).unwrap_or_default();
    if path == "pointer" {
        let pointer = target.pointer("/extensions/KHR_animation_pointer/pointer").and_then(Value::as_str);
        return pointer.map_or_else(
            || Target::Nothing("its target has no pointer".to_owned()),
            |pointer| pointed_at(pointer, nodes),
        );
    }
    let Some(property) = property(path) else {
        return Target::Nothing(format!("its path is {path:?}, need a property of nodes"));
    };
    match target.get("node").map(Value::as_u64) {
        Some(Some(node)) => checked(node, property, nodes),
        Some(None) | None => Target::Nothing("its target names no node".to_owned()),
    }
}

fn property(path: &str) -> Option<Property> {
    match path {
        "translation" => Some(Property::Translation),
        "rotation" => Some(Property::Rotation),
        "scale" => Some(Property::Scale),
        "weights" => Some(Property::Weights),
        _ => None,
    }
}

fn checked(node: u64, property: Property, nodes: usize) -> Target {
    match usize::try_from(node) {
        Ok(node) if node < nodes => Target::Node(node, property),
        Ok(_) | Err(_) => Target::Nothing(format!("node {node} of {nodes} is not there")),
    }
}

fn pointed_at(pointer: &str, nodes: usize) -> Target {
    let elsewhere = || Target::Elsewhere(pointer.to_owned());
    let Some((node, path)) = pointer.strip_prefix("/nodes/").and_then(|rest| rest.split_once('/')) else {
        return elsewhere();
    };
    let is_visibility = path
        .strip_prefix("extensions/")
        .and_then(|path| path.strip_suffix("/visible"))
        .is_some_and(|extension| extension == VISIBILITY);
    let property = if is_visibility { Some(Property::Visible) } else { property(path) };
    match (node.parse(), property) {
        (Ok(node), Some(property)) => checked(node, property, nodes),
        (Ok(_) | Err(_), None) => elsewhere(),
        (Err(_), Some(_)) => Target::Nothing(format!("its pointer is {pointer:?}, need a node's number")),
    }
}

#[cfg(test)]
mod tests {
    use gltf::json::deserialize;

    use super::*;

    fn target(text: &str) -> Target {
        of(Some(&deserialize::from_str(text).unwrap()), 3)
    }

    fn pointer(to: &str) -> Target {
        target(&format!(
            r#"{{"path": "pointer", "extensions": {{"KHR_animation_pointer": {{"pointer": "{to}"}}}}}}"#
        ))
    }

    #[test]
    fn nodes_are_named_by_number_or_by_pointer() {
        assert_eq!(target(r#"{"node": 2, "path": "scale"}"#), Target::Node(2, Property::Scale));
        assert_eq!(pointer("/nodes/1/rotation"), Target::Node(1, Property::Rotation));
        let visible = "/nodes/0/extensions/KHR_node_visibility/visible";
        assert_eq!(pointer(visible), Target::Node(0, Property::Visible));
    }

    #[test]
    fn pointers_to_what_changes_no_shadow_are_told_from_those_to_nothing() {
        for to in
            ["/materials/0/alphaCutoff", "/nodes/1/weights/0", "/nodes/1", "", "/extensions/x/lights/0/color"]
        {
            assert_eq!(pointer(to), Target::Elsewhere(to.to_owned()));
        }
        for to in ["/nodes/3/translation", "/nodes/-1/scale", "/nodes/99999999999999999999/scale"] {
            assert!(matches!(pointer(to), Target::Nothing(_)), "{to}");
        }
        for text in [
            "{}",
            "3",
            r#"{"path": "pointer"}"#,
            r#"{"path": "translation"}"#,
            r#"{"path": "translation", "node": -1}"#,
            r#"{"path": "translation", "node": 3}"#,
            r#"{"path": "colour", "node": 0}"#,
        ] {
            assert!(matches!(target(text), Target::Nothing(_)), "{text}");
        }
        assert!(matches!(of(None, 3), Target::Nothing(_)), "no target");
    }
}
