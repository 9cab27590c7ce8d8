//! What can be wrong with shader modules.

/// Why modules could not be joined into one text. Umbrage's own modules always can; a module that stands in for one of them may
/// not fit.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ImportError {
    /// A module imports from one that does not exist.
    #[error("shader module `{by}` imports from `{module}`, which does not exist")]
    Module {
        /// The module that is not there.
        module: String,
        /// Who imports from it.
        by: String,
    },
    /// A module imports a name that is not declared.
    #[error("shader module `{by}` imports `{name}` from `{from}`, which does not declare it")]
    Name {
        /// The name.
        name: String,
        /// Where it should be declared.
        from: String,
        /// Who imports it.
        by: String,
    },
    /// Modules import from each other in a circle.
    #[error(
        "shader modules import each other in a circle: `{by}` imports from `{module}`, which needs `{by}`"
    )]
    Circle {
        /// The module that closes the circle.
        module: String,
        /// Who imports from it.
        by: String,
    },
    /// A line begins as an import and is none.
    #[error("shader module `{by}` has a line that is no import: `{line}`")]
    Malformed {
        /// The line.
        line: String,
        /// The module.
        by: String,
    },
    /// A line binds something in group 0, and not in the one way in which it can be moved to another place.
    #[error(
        "a shader module has a binding that cannot be moved: `{line}`; write it as `@group(0) @binding(7)`, on one line"
    )]
    Binding {
        /// The line.
        line: String,
    },
}
