//! A value of serde's as Rust.
//!
//! A struct says its name, and a unit variant its own and its enum's. An enum that is tagged by `kind` is a struct with that
//! field: of the variant's struct, or of the enum where the variant has fields of its own. The enum then is called as the
//! field that holds it.

use std::fmt::Debug;

use serde::Serialize;
use serde::ser::{Error, Impossible, SerializeSeq, SerializeStruct, SerializeTuple, Serializer};

use super::Rust;

/// The field that says which variant of an enum it is.
const TAG: &str = "kind";

/// Returns a value as Rust, with every type's path.
///
/// # Errors
/// When it holds something that is none of a setting's: a map, bytes, a tuple.
pub fn to_rust(value: &(impl Serialize + ?Sized)) -> Result<Rust, String> {
    value.serialize(ToRust).map_err(|why| why.to_string())
}

/// Why a value cannot be Rust: serde's own error, which is a text.
type NotRust = serde::de::value::Error;

type Written = Result<Rust, NotRust>;

fn unknown(what: &str) -> NotRust {
    Error::custom(format!("settings hold no {what}"))
}

fn word(value: impl Debug) -> Written {
    Ok(Rust::Word(format!("{value:?}")))
}

/// `clip_depth` as `ClipDepth`.
fn camel(snake: &str) -> String {
    let upper = |word: &str| word[..1].to_uppercase() + &word[1..];
    snake.split('_').filter(|word| word.is_ascii() && !word.is_empty()).map(upper).collect()
}

fn path(name: &str) -> String {
    format!("umbrage::{name}")
}

struct ToRust;

/// Methods that write a word, and methods that settings have no use for.
macro_rules! methods {
    (words: $($word:ident($of:ty)),*; unknown: $($unknown:ident($type:ty)),*) => {
        $(fn $word(self, value: $of) -> Written { word(value) })*
        $(fn $unknown(self, _: $type) -> Written { Err(unknown(stringify!($type))) })*
    };
}

impl Serializer for ToRust {
    type Ok = Rust;
    type Error = NotRust;
    type SerializeSeq = Items;
    type SerializeTuple = Items;
    type SerializeStruct = Fields;
    type SerializeTupleStruct = Impossible<Rust, NotRust>;
    type SerializeTupleVariant = Impossible<Rust, NotRust>;
    type SerializeMap = Impossible<Rust, NotRust>;
    type SerializeStructVariant = Impossible<Rust, NotRust>;

    methods!(
        words: serialize_bool(bool), serialize_i8(i8), serialize_i16(i16), serialize_i32(i32), serialize_i64(i64),
            serialize_u8(u8), serialize_u16(u16), serialize_u32(u32), serialize_u64(u64), serialize_f32(f32),
            serialize_f64(f64), serialize_char(char);
        unknown: serialize_bytes(&[u8]), serialize_unit_struct(&'static str)
    );

    fn serialize_str(self, value: &str) -> Written {
        Ok(Rust::Text(value.to_owned()))
    }

    fn serialize_none(self) -> Written {
        Ok(Rust::Word("None".to_owned()))
    }

    fn serialize_some<T: ?Sized + Serialize>(self, value: &T) -> Written {
        Ok(Rust::Given(Box::new(value.serialize(self)?)))
    }

    fn serialize_unit(self) -> Written {
        Err(unknown("unit"))
    }

    fn serialize_unit_variant(self, name: &'static str, _: u32, variant: &'static str) -> Written {
        Ok(Rust::Word(format!("{}::{}", path(name), camel(variant))))
    }

    fn serialize_newtype_struct<T: ?Sized + Serialize>(self, name: &'static str, value: &T) -> Written {
        Ok(Rust::Variant { path: path(name), inside: Box::new(value.serialize(self)?) })
    }

    fn serialize_newtype_variant<T: ?Sized + Serialize>(
        self,
        name: &'static str,
        _: u32,
        variant: &'static str,
        value: &T,
    ) -> Written {
        let path = format!("{}::{}", path(name), camel(variant));
        Ok(Rust::Variant { path, inside: Box::new(value.serialize(self)?) })
    }

    fn serialize_seq(self, _: Option<usize>) -> Result<Items, NotRust> {
        Ok(Items { is_array: false, items: Vec::new() })
    }

    fn serialize_tuple(self, _: usize) -> Result<Items, NotRust> {
        Ok(Items { is_array: true, items: Vec::new() })
    }

    fn serialize_struct(self, name: &'static str, _: usize) -> Result<Fields, NotRust> {
        Ok(Fields { name, fields: Vec::new() })
    }

    fn serialize_tuple_struct(
        self,
        _: &'static str,
        _: usize,
    ) -> Result<Self::SerializeTupleStruct, NotRust> {
        Err(unknown("tuple struct"))
    }

    fn serialize_tuple_variant(
        self,
        _: &'static str,
        _: u32,
        _: &'static str,
        _: usize,
    ) -> Result<Self::SerializeTupleVariant, NotRust> {
        Err(unknown("tuple variant"))
    }

    fn serialize_map(self, _: Option<usize>) -> Result<Self::SerializeMap, NotRust> {
        Err(unknown("map"))
    }

    fn serialize_struct_variant(
        self,
        _: &'static str,
        _: u32,
        _: &'static str,
        _: usize,
    ) -> Result<Self::SerializeStructVariant, NotRust> {
        Err(unknown("untagged variant"))
    }
}

/// A list under way.
struct Items {
    is_array: bool,
    items: Vec<Rust>,
}

impl SerializeSeq for Items {
    type Ok = Rust;
    type Error = NotRust;

    fn serialize_element<T: ?Sized + Serialize>(&mut self, value: &T) -> Result<(), NotRust> {
        self.items.push(value.serialize(ToRust)?);
        Ok(())
    }

    fn end(self) -> Written {
        Ok(if self.is_array { Rust::Array(self.items) } else { Rust::Vector(self.items) })
    }
}

impl SerializeTuple for Items {
    type Ok = Rust;
    type Error = NotRust;

    fn serialize_element<T: ?Sized + Serialize>(&mut self, value: &T) -> Result<(), NotRust> {
        SerializeSeq::serialize_element(self, value)
    }

    fn end(self) -> Written {
        SerializeSeq::end(self)
    }
}

/// A struct under way.
struct Fields {
    name: &'static str,
    fields: Vec<(&'static str, Rust)>,
}

impl SerializeStruct for Fields {
    type Ok = Rust;
    type Error = NotRust;

    fn serialize_field<T: ?Sized + Serialize>(
        &mut self,
        name: &'static str,
        value: &T,
    ) -> Result<(), NotRust> {
        self.fields.push((name, of_enum(name, value.serialize(ToRust)?)));
        Ok(())
    }

    /// A field that a file leaves out is `None`.
    fn skip_field(&mut self, name: &'static str) -> Result<(), NotRust> {
        self.fields.push((name, Rust::Word("None".to_owned())));
        Ok(())
    }

    fn end(self) -> Written {
        Ok(Rust::Struct { path: path(self.name), is_variant: false, fields: self.fields })
    }
}

/// The value of a field; a struct with a tag as the variant that it is.
fn of_enum(field: &str, value: Rust) -> Rust {
    let (own_path, mut fields) = match value {
        Rust::Struct { path, is_variant: false, fields } => (path, fields),
        other => return other,
    };
    let Some((TAG, Rust::Text(kind))) = fields.first() else {
        return Rust::Struct { path: own_path, is_variant: false, fields };
    };
    let enum_path = path(&camel(field));
    let variant = format!("{enum_path}::{}", camel(kind));
    fields.remove(0);
    if own_path == enum_path {
        return Rust::Struct { path: variant, is_variant: true, fields };
    }
    let inside = Rust::Struct { path: own_path, is_variant: false, fields };
    Rust::Variant { path: variant, inside: Box::new(inside) }
}
