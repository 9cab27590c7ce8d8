//! Structs that the CPU writes and shaders read: declared once, with the names of their fields.

/// Declares a struct that a shader has too. `fields()` says what its fields are called, and at which byte each begins.
macro_rules! shared_with_shaders {
    ($(#[$about:meta])* struct $name:ident { $($(#[$about_field:meta])* $field:ident: $kind:ty,)* }) => {
        $(#[$about])*
        #[derive(Clone, Debug, Default, encase::ShaderType)]
        pub(crate) struct $name {
            $($(#[$about_field])* pub $field: $kind,)*
        }

        impl $name {
            #[cfg(test)]
            pub fn fields() -> Vec<(&'static str, u64)> {
                let names = [$(stringify!($field)),*];
                names.into_iter().enumerate().map(|(i, name)| (name, <Self as encase::ShaderType>::METADATA.offset(i))).collect()
            }
        }
    };
}

pub(crate) use shared_with_shaders;

/// Where naga puts the members of a struct of a shader text.
#[cfg(test)]
pub(crate) fn fields_in_shader(text: &str, name: &str) -> Vec<(String, u64)> {
    let module = naga::front::wgsl::parse_str(text).unwrap_or_else(|e| panic!("{}", e.emit_to_string(text)));
    let (_, found) = module.types.iter().find(|(_, t)| t.name.as_deref() == Some(name)).unwrap();
    let naga::TypeInner::Struct { members, .. } = &found.inner else { panic!("{name} is a struct") };
    members.iter().map(|m| (m.name.clone().unwrap(), u64::from(m.offset))).collect()
}
