//! Which files make which shader: plain WGSL, one after another. Every way to look at a scene has a shader of its own, so
//! that none pays for another's branches.
//!
//! Texts of `umbrage` come as arguments: `receiver` is that of its receivers, whose bindings are group 1.

mod covering;

use std::fmt::Write as _;

use umbrage::{Contact, contact_wgsl};

pub(crate) use covering::{Covering, RECEIVER_ENTRY, casters, depth, places, vertex_entry};

use crate::frame::{Mark, Show};

const SCENE: &str = include_str!("../shaders/scene.wgsl");
const PICTURE: &str = include_str!("../shaders/picture.wgsl");
const RECEIVER: &str = include_str!("../shaders/receiver.wgsl");
const MATERIAL: &str = include_str!("../shaders/material.wgsl");
const SURFACE: &str = include_str!("../shaders/surface.wgsl");
const TONE: &str = include_str!("../shaders/tone.wgsl");
const SPLIT_COLOUR: &str = include_str!("../shaders/marks/split_colour.wgsl");
const FOOTPRINT: &str = include_str!("../shaders/marks/footprint.wgsl");

/// Colours that tell splits apart, linear red, green and blue, dark to light as print goes: after Okabe and Ito. More
/// splits than these begin with the first again.
pub const SPLIT_COLOURS: [[f32; 3]; 9] = [
    [0.80, 0.15, 0.05],
    [0.90, 0.55, 0.05],
    [0.05, 0.45, 0.25],
    [0.05, 0.30, 0.70],
    [0.55, 0.15, 0.50],
    [0.10, 0.60, 0.75],
    [0.75, 0.70, 0.10],
    [0.40, 0.25, 0.10],
    [0.50, 0.50, 0.50],
];

/// How receivers look; each has a shader of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Look {
    World,
    Unshadowed,
    Given,
    Marked(Mark),
    Visibility,
}

/// Where a fragment's visibility comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Visibility {
    /// The shader needs none.
    Unused,
    /// All light reaches everything.
    Full,
    /// A number a pixel and light, as group 3.
    Given,
    /// A number a pixel and light, as group 3, that was found for the whole picture.
    Resolved,
    /// The shadow maps, as group 1.
    Maps,
    /// The shadow maps, and the camera's depth, as group 3.
    MapsAndContact,
}

impl Look {
    /// How receivers look in a picture; `None` where it has none.
    pub fn of(show: &Show) -> Option<Self> {
        match show {
            Show::World => Some(Self::World),
            Show::Unshadowed => Some(Self::Unshadowed),
            Show::Given(_) => Some(Self::Given),
            Show::Marked(mark) => Some(Self::Marked(*mark)),
            Show::Visibility(_) => Some(Self::Visibility),
            Show::Nothing => None,
        }
    }

    /// Where its shader takes visibility from: with contact shadows or without, and where it is found for the whole picture.
    pub fn visibility(self, has_contact: bool, is_resolved: bool) -> Visibility {
        match self {
            Self::Unshadowed => Visibility::Full,
            Self::Given => Visibility::Given,
            Self::Marked(Mark::Extents) => Visibility::Unused,
            Self::World | Self::Marked(Mark::Splits | Mark::Texels) | Self::Visibility if is_resolved => {
                Visibility::Resolved
            }
            Self::World | Self::Marked(Mark::Splits | Mark::Texels) | Self::Visibility if has_contact => {
                Visibility::MapsAndContact
            }
            Self::World | Self::Marked(Mark::Splits | Mark::Texels) | Self::Visibility => Visibility::Maps,
        }
    }
}

/// Where in its pixel a fragment asks for visibility.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    /// At its centre.
    Centre,
    /// In the middle of the samples that the fragment covers.
    Covered,
}

impl Place {
    /// The place that suits pixels of so many samples. Maps stand off a place beside the triangle as they do off their own
    /// texels; rays do not.
    pub fn of(samples: u32, traces: bool) -> Self {
        if samples > 1 && traces { Self::Covered } else { Self::Centre }
    }

    fn text(self) -> &'static str {
        match self {
            Self::Centre => include_str!("../shaders/place/centre.wgsl"),
            Self::Covered => include_str!("../shaders/place/covered.wgsl"),
        }
    }
}

/// What lights surfaces from all around, and lies behind them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Around {
    /// A sky that is as bright as the sun asks for.
    Sky,
    /// A picture.
    Picture,
}

/// What the surfaces of a scene are like. Scenes that need less have shaders that do less.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Finish {
    /// All are matte.
    Matte,
    /// Some are not, or their vertices have colours.
    Glossy,
}

impl Look {
    /// Whether its shader reads materials.
    pub fn has_materials(self) -> bool {
        match self {
            Self::World | Self::Unshadowed | Self::Given | Self::Marked(Mark::Splits | Mark::Texels) => true,
            Self::Marked(Mark::Extents) | Self::Visibility => false,
        }
    }
}

/// Receivers: the vertex shader [`vertex_entry`], the fragment shader `shade`.
pub(crate) fn receivers(
    look: Look,
    finish: Finish,
    around: Around,
    covering: Covering,
    (receiver, place): (&str, Place),
    (contact, is_resolved): (Option<&Contact>, bool),
) -> String {
    let visibility = visibility(look.visibility(contact.is_some(), is_resolved), contact);
    let mut text = [receiver, SCENE, RECEIVER, place.text()].join("\n") + &visibility;
    if look.has_materials() {
        text += &surfaces(finish, around);
    } else if covering != Covering::Solid {
        text += MATERIAL;
    }
    let files: &[&str] = match look {
        Look::World | Look::Unshadowed | Look::Given => {
            &[include_str!("../shaders/marks/none.wgsl"), SURFACE]
        }
        Look::Marked(Mark::Splits) => {
            text += &split_colours();
            &[SPLIT_COLOUR, include_str!("../shaders/marks/split_tint.wgsl"), SURFACE]
        }
        Look::Marked(Mark::Texels) => {
            text += &split_colours();
            &[SPLIT_COLOUR, FOOTPRINT, include_str!("../shaders/marks/texel_chequer.wgsl"), SURFACE]
        }
        Look::Marked(Mark::Extents) => &[FOOTPRINT, include_str!("../shaders/marks/texel_extent.wgsl")],
        Look::Visibility => &[include_str!("../shaders/visibility.wgsl")],
    };
    text + &files.join("\n") + &covering::text(look, finish, covering)
}

/// All that shades surfaces.
fn surfaces(finish: Finish, around: Around) -> String {
    let lit = [
        PICTURE,
        MATERIAL,
        include_str!("../shaders/lights.wgsl"),
        around_text(around),
        include_str!("../shaders/haze.wgsl"),
        TONE,
    ];
    let finish: &[&str] = match finish {
        Finish::Matte => &[include_str!("../shaders/matte.wgsl")],
        Finish::Glossy => &[
            include_str!("../shaders/reflection.wgsl"),
            include_str!("../shaders/material_maps.wgsl"),
            include_str!("../shaders/glossy.wgsl"),
        ],
    };
    [lit.as_slice(), finish].concat().join("\n")
}

fn around_text(around: Around) -> &'static str {
    match around {
        Around::Sky => include_str!("../shaders/sky_light.wgsl"),
        Around::Picture => include_str!("../shaders/environment.wgsl"),
    }
}

/// The text of `visibility_at`.
fn visibility(from: Visibility, contact: Option<&Contact>) -> String {
    match from {
        Visibility::Unused => String::new(),
        Visibility::Full => include_str!("../shaders/visibility/full.wgsl").to_owned(),
        Visibility::Given | Visibility::Resolved => {
            include_str!("../shaders/visibility/given.wgsl").to_owned()
        }
        Visibility::Maps => include_str!("../shaders/visibility/maps.wgsl").to_owned(),
        Visibility::MapsAndContact => {
            let march = contact.map(|contact| contact_wgsl(contact, 3)).unwrap_or_default();
            march + include_str!("../shaders/visibility/maps_and_contact.wgsl")
        }
    }
}

/// [`SPLIT_COLOURS`] as the shaders have them.
fn split_colours() -> String {
    let colour = |[red, green, blue]: [f32; 3]| format!("vec3f({red:?}, {green:?}, {blue:?})");
    let (count, list) = (SPLIT_COLOURS.len(), SPLIT_COLOURS.map(colour).join(", "));
    let mut text = format!("const SPLIT_COLOURS = array<vec3f, {count}>({list});\n");
    // Writing to a string cannot fail.
    let _ = writeln!(text, "const SPLIT_COLOUR_COUNT: u32 = {count}u;");
    text
}

/// The sky: the vertex shader `sky`, the fragment shader `sky_shade`.
pub(crate) fn sky(around: Around) -> String {
    [SCENE, PICTURE, around_text(around), TONE, include_str!("../shaders/sky.wgsl")].join("\n")
}

/// The sky where visibility is shown: the vertex shader `sky`, the fragment shader `sky_visibility`.
pub(crate) fn lit_sky() -> String {
    include_str!("../shaders/sky_lit.wgsl").to_owned()
}

/// Queries of points: the compute shader `find_visibility`.
pub(crate) fn query(receiver: &str) -> String {
    [receiver, include_str!("../shaders/query.wgsl")].concat()
}

/// Maps as pictures: the compute shaders `find_range` and `paint`.
pub(crate) fn map_picture(map: &str) -> String {
    [map, include_str!("../shaders/map_picture.wgsl")].concat()
}

/// Bent meshes: the compute shader `deform`.
pub(crate) fn deform() -> String {
    include_str!("../shaders/deform.wgsl").to_owned()
}

/// Sums of pictures: the compute shader `add`.
pub(crate) fn area_sum() -> String {
    include_str!("../shaders/area_sum.wgsl").to_owned()
}

#[cfg(test)]
mod tests {
    use umbrage::{
        Capabilities, Filter, Select, Settings, caster_wgsl, map_wgsl, receiver_wgsl, second_caster_wgsl,
    };

    use super::covering::Edge;
    use super::*;
    use crate::cover::Cover;

    const LOOKS: [Look; 7] = [
        Look::World,
        Look::Unshadowed,
        Look::Given,
        Look::Marked(Mark::Splits),
        Look::Marked(Mark::Texels),
        Look::Marked(Mark::Extents),
        Look::Visibility,
    ];

    const FINISHES: [(Finish, Around); 4] = [
        (Finish::Matte, Around::Sky),
        (Finish::Glossy, Around::Sky),
        (Finish::Matte, Around::Picture),
        (Finish::Glossy, Around::Picture),
    ];

    const COVERINGS: [Covering; 4] =
        [Covering::Solid, Covering::Cut(Edge::Exact), Covering::Cut(Edge::Smooth), Covering::Veil];

    fn check(text: &str) {
        let module =
            naga::front::wgsl::parse_str(text).unwrap_or_else(|e| panic!("{}", e.emit_to_string(text)));
        let (flags, capabilities) = (naga::valid::ValidationFlags::all(), naga::valid::Capabilities::empty());
        let result = naga::valid::Validator::new(flags, capabilities).validate(&module);
        result.unwrap_or_else(|e| panic!("{}", e.emit_to_string(text)));
    }

    #[test]
    fn every_shader_of_the_renderer_is_valid_wgsl() {
        for cover in [Cover::Solid, Cover::Cut, Cover::Veil] {
            check(&casters(&caster_wgsl(0), cover));
            check(&casters(&second_caster_wgsl(0), cover));
        }
        [
            depth(Cover::Solid),
            depth(Cover::Cut),
            places(Cover::Solid),
            places(Cover::Cut),
            lit_sky(),
            area_sum(),
            deform(),
            map_picture(&map_wgsl()),
        ]
        .iter()
        .for_each(|text| check(text));
        [Around::Sky, Around::Picture].iter().for_each(|around| check(&sky(*around)));
        for select in [Select::Depth, Select::ClipDepth, Select::Map] {
            for filter in [Filter::Hard {}, Filter::Bilinear {}, Filter::Pcf { size: 5 }] {
                let settings = Settings { select, filter, ..Settings::default() };
                let shadows = receiver_wgsl(&settings, Capabilities::ALL, 1);
                check(&query(&shadows));
                for look in LOOKS {
                    for (finish, around) in FINISHES {
                        for covering in COVERINGS {
                            for place in [Place::Centre, Place::Covered] {
                                let receiver = (shadows.as_str(), place);
                                check(&receivers(look, finish, around, covering, receiver, (None, false)));
                                check(&receivers(look, finish, around, covering, receiver, (None, true)));
                                let contact = Some(&Contact::default());
                                check(&receivers(look, finish, around, covering, receiver, (contact, false)));
                            }
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn the_shader_of_the_plain_picture_holds_nothing_of_the_others() {
        let text = receivers(
            Look::World,
            Finish::Matte,
            Around::Sky,
            Covering::Solid,
            ("", Place::Centre),
            (None, false),
        );
        for word in [
            "split_colour",
            "footprint",
            "given",
            "shown_light,",
            "extent",
            "mark",
            "normal_texture",
            "fresnel",
            "discard",
        ] {
            assert!(!text.contains(word), "{word}");
        }
        println!("{} bytes of WGSL without the library's", text.len());
    }

    #[test]
    fn split_colours_are_the_same_in_the_shader() {
        let text = split_colours();
        assert!(text.contains("array<vec3f, 9>(vec3f(0.8, 0.15, 0.05), vec3f(0.9, 0.55, 0.05)"), "{text}");
    }
}
