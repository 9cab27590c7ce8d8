//! The JSON of a glTF file as typed lists. An object that cannot be read is remembered with the reason, and whoever
//! needs it says so; what nobody needs stops nothing.
//!
//! After this, indices lead somewhere or are gone, except those of accessors and views, which are checked where they
//! are read.

use std::collections::BTreeMap;

use gltf::json::extensions::root::{KhrLightsPunctual, Root as RootExtensions};
use gltf::json::extras::RawValue;
use gltf::json::{Asset, Error, Index, Mesh, Root, Scene, deserialize};

use super::members::{self, Members, Raw, Salvaged, salvage};
use super::stand_in::StandIn;
use super::transforms::{self, Transform};
use super::{extensions, links};
use crate::error::Fault;
use crate::import::warnings::Warnings;

/// A document, and what could not be read of it.
#[derive(Debug)]
pub(super) struct Document {
    pub root: Root,
    /// Where each node stands in its parent, or why nobody knows.
    pub transforms: Vec<Result<Transform, String>>,
    /// The animations, unread.
    pub animations: Vec<Raw>,
    /// Why the object of this list at this index could not be read. A stand-in is in its place.
    pub broken: Broken,
}

/// Reasons by list and index.
pub(super) type Broken = BTreeMap<(&'static str, usize), String>;

/// A list's reader: it knows the list's name in the file, and notes what is lost.
struct Reader<'a> {
    broken: Broken,
    warnings: &'a mut Warnings,
}

/// Reads the JSON. Only text that is no JSON object at all, and another version of glTF, stop here.
pub(super) fn read(text: &[u8], warnings: &mut Warnings) -> Result<Document, Fault> {
    // Some editors begin a text with a mark of its byte order.
    let text = text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text);
    let text = std::str::from_utf8(text).map_err(|why| Fault(format!("not a glTF document, {why}")))?;
    let root: Members =
        deserialize::from_str(text).map_err(|why| Fault(format!("not a glTF document, {why}")))?;
    let mut reader = Reader { broken: Broken::new(), warnings };
    let asset = reader.asset(&root)?;
    let (nodes, transforms) = reader.nodes(&root);
    let mut document = Document {
        root: Root {
            asset,
            accessors: reader.list(&root, "accessors", |text| deserialize::from_str(text)),
            buffers: reader.list(&root, "buffers", |text| deserialize::from_str(text)),
            buffer_views: reader.list(&root, "bufferViews", |text| deserialize::from_str(text)),
            cameras: reader.list(&root, "cameras", |text| deserialize::from_str(text)),
            images: reader.list(&root, "images", |text| deserialize::from_str(text)),
            materials: reader.list(&root, "materials", |text| deserialize::from_str(text)),
            samplers: reader.list(&root, "samplers", |text| deserialize::from_str(text)),
            textures: reader.list(&root, "textures", |text| deserialize::from_str(text)),
            meshes: reader.meshes(&root),
            skins: reader.list(&root, "skins", |text| deserialize::from_str(text)),
            nodes,
            scene: root
                .get("scene")
                .and_then(|raw| deserialize::from_str::<u32>(raw.get()).ok())
                .map(Index::new),
            scenes: reader.scenes(&root),
            extensions: Some(reader.extensions(&root)),
            ..Root::default()
        },
        transforms,
        animations: reader.texts(&root, "animations"),
        broken: reader.broken,
    };
    let names = |member: &str| -> Vec<String> {
        root.get(member).and_then(|raw| deserialize::from_str(raw.get()).ok()).unwrap_or_default()
    };
    extensions::note(&names("extensionsUsed"), &names("extensionsRequired"), warnings);
    links::mend(&mut document.root, warnings);
    Ok(document)
}

impl Reader<'_> {
    fn asset(&mut self, root: &Members) -> Result<Asset, Fault> {
        let asset = root
            .get("asset")
            .and_then(|raw| members::of(raw.get()).ok())
            .and_then(|asset| salvage(&asset, |text| deserialize::from_str::<Asset>(text)).ok());
        let Some(Salvaged { object: asset, .. }) = asset else {
            self.warnings.note("the file does not say its version, 2.0 is assumed", "asset");
            return Ok(Asset::default());
        };
        if asset.version.starts_with("2.") {
            Ok(asset)
        } else {
            Err(Fault(format!("glTF version {:?}, need 2.0", asset.version)))
        }
    }

    /// Objects of a list, each read as far as it can be; an empty stand-in for those that cannot.
    fn list<T: StandIn>(
        &mut self,
        root: &Members,
        name: &'static str,
        parse: impl Fn(&str) -> Result<T, Error>,
    ) -> Vec<T> {
        let texts = self.texts(root, name);
        texts.iter().enumerate().map(|(i, raw)| self.object(name, i, raw, &parse)).collect()
    }

    fn texts(&mut self, root: &Members, name: &'static str) -> Vec<Raw> {
        members::list(root, name).unwrap_or_else(|why| {
            self.warnings.note("lists that cannot be read are ignored", &why);
            Vec::new()
        })
    }

    fn object<T: StandIn>(
        &mut self,
        list: &'static str,
        i: usize,
        raw: &Raw,
        parse: impl Fn(&str) -> Result<T, Error>,
    ) -> T {
        // Most objects are well formed, and read in one go.
        if let Ok(object) = parse(raw.get()) {
            return object;
        }
        match members::of(raw.get()).and_then(|members| salvage(&members, parse)) {
            Ok(Salvaged { object, lost }) => {
                for member in lost {
                    self.malformed(&format!("{member:?} of {list:?} {i}"));
                }
                object
            }
            Err(why) => {
                self.broken.insert((list, i), why);
                T::stand_in()
            }
        }
    }

    /// The members of an object; none, where it is no object.
    fn members(&mut self, raw: &Raw, label: &str) -> Members {
        members::of(raw.get()).unwrap_or_else(|why| {
            self.malformed(&format!("{label}, {why}"));
            Members::new()
        })
    }

    fn malformed(&mut self, subject: &str) {
        self.warnings.note("members that cannot be read are ignored", subject);
    }

    /// The nodes without their transforms, and the transforms.
    fn nodes(&mut self, root: &Members) -> (Vec<gltf::json::Node>, Vec<Result<Transform, String>>) {
        let texts = self.texts(root, "nodes");
        let mut read = |(i, raw): (usize, &Raw)| {
            let mut node = self.members(raw, &format!("node {i}"));
            let transform = transforms::take(&mut node);
            let node = salvage(&node, |text| deserialize::from_str(text));
            let Salvaged { object, lost } = node
                .unwrap_or_else(|_| Salvaged { object: StandIn::stand_in(), lost: vec!["node".to_owned()] });
            for member in lost {
                self.malformed(&format!("{member:?} of node {i}"));
            }
            (object, transform)
        };
        texts.iter().enumerate().map(&mut read).unzip()
    }

    /// The meshes, each without the primitives that cannot be read.
    fn meshes(&mut self, root: &Members) -> Vec<Mesh> {
        let texts = self.texts(root, "meshes");
        let mut meshes = Vec::with_capacity(texts.len());
        for (i, raw) in texts.iter().enumerate() {
            let mut mesh = self.members(raw, &format!("mesh {i}"));
            let primitives = members::list(&mesh, "primitives").unwrap_or_else(|why| {
                self.malformed(&format!("mesh {i}, {why}"));
                Vec::new()
            });
            mesh.insert("primitives".to_owned(), empty_list());
            let mut read: Mesh = match salvage(&mesh, |text| deserialize::from_str(text)) {
                Ok(Salvaged { object, lost }) => {
                    for member in lost {
                        self.malformed(&format!("{member:?} of mesh {i}"));
                    }
                    object
                }
                Err(_) => StandIn::stand_in(),
            };
            for (k, raw) in primitives.iter().enumerate() {
                let members = members::of(raw.get());
                match members.and_then(|members| salvage(&members, |text| deserialize::from_str(text))) {
                    Ok(Salvaged { object, lost }) => {
                        for member in lost {
                            self.malformed(&format!("{member:?} of primitive {k} of mesh {i}"));
                        }
                        read.primitives.push(object);
                    }
                    Err(why) => self.warnings.note(
                        "primitives that cannot be read are left out",
                        &format!("primitive {k} of mesh {i}, {why}"),
                    ),
                }
            }
            meshes.push(read);
        }
        meshes
    }

    /// The scenes; one without nodes is well formed.
    fn scenes(&mut self, root: &Members) -> Vec<Scene> {
        let texts = self.texts(root, "scenes");
        let read = |(i, raw): (usize, &Raw)| {
            let mut scene = self.members(raw, &format!("scene {i}"));
            scene.entry("nodes".to_owned()).or_insert_with(empty_list);
            let text = salvage(&scene, |text| deserialize::from_str(text));
            text.map_or_else(
                |why| {
                    self.malformed(&format!("scene {i}, {why}"));
                    StandIn::stand_in()
                },
                |Salvaged { object, .. }| object,
            )
        };
        texts.iter().enumerate().map(read).collect()
    }

    /// The lights, which hang on the document's own extensions.
    fn extensions(&mut self, root: &Members) -> RootExtensions {
        let inside = |members: &Members, name: &str| {
            members.get(name).and_then(|raw| members::of(raw.get()).ok()).unwrap_or_default()
        };
        let lights = inside(&inside(root, "extensions"), "KHR_lights_punctual");
        let lights = self.list(&lights, "lights", |text| deserialize::from_str(text));
        RootExtensions {
            khr_lights_punctual: Some(KhrLightsPunctual { lights }),
            ..RootExtensions::default()
        }
    }
}

fn empty_list() -> Raw {
    // The fallback, `null`, is never needed.
    RawValue::from_string("[]".to_owned()).unwrap_or_default()
}
