//! A link: what the window shows, as text that another window or page shows again.
//!
//! A link is the query of an address, as `?world=knights&camera=1&set=filter.kind=pcf`. Its keys are the options of the
//! command line and the names of settings; what is left out is as it is by default. Whatever cannot be read is left out and
//! said, a message each, and the rest of the link holds.

mod query;
mod read;
mod shadows;
mod shot;
mod write;

use glam::Vec3;
use umbrage::Settings;
use umbrage_render::{Exposure, Mark};
use umbrage_scene::worlds;

use crate::lines::PlanLines;
use crate::load::Source;
use crate::moved_lights::MovedLights;
use crate::view_state::PictureMode;

pub(crate) use read::one_line;

/// What a link says.
#[derive(Clone, Debug, PartialEq)]
pub struct Link {
    /// The name of a built-in world; the one that is open, or the default one, where absent.
    pub world: Option<String>,
    /// The address of a world's file, which goes before `world`.
    pub load: Option<String>,
    /// One of the world's cameras, by number from 0 or by name; the first where absent.
    pub camera: Option<String>,
    /// The camera's eye and target, world space, metres; as `camera` has them where absent.
    pub place: Option<[Vec3; 2]>,
    /// Time of the animation, seconds from its start.
    pub seconds: f32,
    /// One of the world's animations, by name or by number from 0, or `none`; the first where absent.
    pub animation: Option<String>,
    /// The hour of the day that places the sun, local solar time; the world's own sun where absent.
    pub hour: Option<f32>,
    /// The lights that were moved, by their numbers in the world.
    pub lights: MovedLights,
    /// How bright the picture is.
    pub exposure: Exposure,
    /// Whether haze takes colour from what is far.
    pub haze: bool,
    /// Shadow settings of the left and of the right side; both are the same where nothing is compared.
    pub settings: [Settings; 2],
    /// Whether two sides are compared.
    pub compare: bool,
    /// Where the right side begins, as a share of the picture's width, 0.02 to 0.98.
    pub divider: f32,
    /// What the picture shows.
    pub mode: PictureMode,
    /// Which parts of the shadow plan are drawn as lines.
    pub lines: PlanLines,
    /// Whether the picture is compared with ray-traced ground truth.
    pub truth: bool,
    /// Whether the window of shadow maps is open.
    pub maps: bool,
}

impl Default for Link {
    fn default() -> Self {
        Self {
            world: None,
            load: None,
            camera: None,
            place: None,
            seconds: 0.0,
            animation: None,
            hour: None,
            lights: MovedLights::new(),
            exposure: Exposure::default(),
            haze: true,
            settings: [Settings::default(), Settings::default()],
            compare: false,
            divider: 0.5,
            mode: PictureMode::Shadows,
            lines: PlanLines::default(),
            truth: false,
            maps: false,
        }
    }
}

impl Link {
    /// Reads a link: a whole address, or its query alone. Returns what it says, and a message for each part that was left
    /// out.
    pub fn parse(text: &str) -> (Self, Vec<String>) {
        read::read(text)
    }

    /// Returns the same without its world and its camera, which belong together.
    #[must_use]
    pub fn of_any_world(self) -> Self {
        Self {
            world: None,
            load: None,
            camera: None,
            place: None,
            animation: None,
            lights: MovedLights::new(),
            ..self
        }
    }

    /// Returns what it says of the camera alone.
    #[must_use]
    pub fn of_camera(self) -> Self {
        Self { camera: self.camera, place: self.place, ..Self::default() }
    }

    /// Returns where its world comes from; `None` where it names none.
    pub fn source(&self) -> Option<Source> {
        let by_address = self.load.clone().map(Source::Address);
        by_address.or_else(|| self.world.clone().map(Source::Named))
    }
}

/// Writes the query of an address, from its question mark on.
impl std::fmt::Display for Link {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "?{}", query::join(&write::pairs(self)))
    }
}

/// The values of `show`.
const SHOWS: [(&str, PictureMode); 5] = [
    ("shadows", PictureMode::Shadows),
    ("unshadowed", PictureMode::Unshadowed),
    ("splits", PictureMode::Marked(Mark::Splits)),
    ("texels", PictureMode::Marked(Mark::Texels)),
    ("extents", PictureMode::Marked(Mark::Extents)),
];

/// The keys of a link, for the message about one that is none.
const KEYS: &str = "world, load, camera, eye, target, time, animation, hour, light.N.position, light.N.direction, exposure, exposed-for, no-haze, preset, set, right.preset, right.set, divider, show, lines, truth, maps";

/// Returns whether a world has this name, so that any program of this version can open it.
pub fn is_built_in(world: &str) -> bool {
    worlds::ALL.iter().any(|known| known.name == world)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use umbrage::schema::{self, Key, Values};
    use umbrage::{PRESETS, Preset};

    use super::*;
    use crate::edit;
    use crate::moved_lights::MovedLight;

    /// Some value of a key, from a number between 0 and 1.
    fn value(key: &Key, share: f64) -> Option<toml::Value> {
        Some(match key.values {
            Values::Whole { only, .. } if !only.is_empty() => {
                only[(share * (only.len() - 1) as f64) as usize].into()
            }
            Values::Whole { slide: [low, high], .. } => (low + (share * (high - low) as f64) as i64).into(),
            Values::Number { slide: [low, high], .. } => (low + share * (high - low)).into(),
            Values::Switch => (share < 0.5).into(),
            Values::Choice(choices) => choices[(share * (choices.len() - 1) as f64) as usize].name.into(),
            Values::Colour => toml::Value::Array([share, 0.25, 0.5, 1.0].map(toml::Value::from).to_vec()),
            Values::Distances | Values::Table => {
                let start = key.absent.as_ref()?.start;
                format!("v = {start}").parse::<toml::Table>().ok()?.remove("v")?
            }
        })
    }

    /// Settings as people make them: from a preset, key by key; what is refused stays as it was.
    fn settings() -> impl Strategy<Value = Settings> {
        let preset = (0..PRESETS.len()).prop_map(|i| (PRESETS[i].settings)());
        let edits = prop::collection::vec((any::<prop::sample::Index>(), 0.0..1.0f64), 0..6);
        (preset, edits).prop_map(|(settings, edits)| {
            edits.into_iter().fold(settings, |settings, (which, share)| {
                let keys: Vec<&Key> = schema::keys_of(&settings).collect();
                let key = keys[which.index(keys.len())];
                value(key, share).and_then(|v| edit::with(&settings, key, Some(v)).ok()).unwrap_or(settings)
            })
        })
    }

    fn text() -> impl Strategy<Value = String> {
        "[a-zA-Zäß0-9 &=#+%?/:._\"'{}\\[\\]-]{1,24}"
    }

    fn point() -> impl Strategy<Value = Vec3> {
        prop::array::uniform3(-1e6..1e6f32).prop_map(Vec3::from_array)
    }

    fn moved_light() -> impl Strategy<Value = MovedLight> {
        prop_oneof![
            point().prop_map(|at| MovedLight { position: Some(at), direction: None }),
            point().prop_map(|way| MovedLight { position: None, direction: Some(way + Vec3::splat(2e6)) }),
            (point(), point()).prop_map(|(at, way)| MovedLight {
                position: Some(at),
                direction: Some(way - Vec3::splat(2e6))
            }),
        ]
    }

    prop_compose! {
        fn links()(
            world in prop::option::of(0..worlds::ALL.len()),
            load in prop::option::of(text()),
            camera in prop::option::of(text()),
            place in prop::option::of([point(), point()]),
            animation in prop::option::of(text()),
            hour in prop::option::of(crate::sky::DAY[0]..crate::sky::DAY[1]),
            (seconds, stops) in (prop_oneof![Just(0.0), -1e3..1e6f32], prop_oneof![Just(0.0), -100.0..100.0f32]),
            lux in prop::option::of(1e-6..1e9f32),
            lights in prop::collection::btree_map(0..64usize, moved_light(), 0..3),
            (left, right) in (settings(), settings()),
            divider in 0.02..0.98f32,
            show in 0..SHOWS.len(),
            flags in prop::array::uniform7(any::<bool>()),
        ) -> Link {
            let [haze, compare, slices, maps_lines, casters, truth, maps] = flags;
            Link {
                world: world.map(|i| worlds::ALL[i].name.to_owned()),
                load,
                camera,
                place,
                seconds,
                animation,
                hour,
                lights,
                exposure: Exposure { stops, lux },
                haze,
                settings: [left.clone(), if compare { right } else { left }],
                compare,
                divider: if compare { divider } else { 0.5 },
                mode: SHOWS[show].1,
                lines: PlanLines { slices, maps: maps_lines, casters },
                truth,
                maps,
            }
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(200))]

        #[test]
        fn what_a_link_says_is_read_as_it_was_written(link in links()) {
            let text = link.to_string();
            let (read, messages) = Link::parse(&text);
            prop_assert_eq!(&messages, &Vec::<String>::new(), "{}", text);
            prop_assert_eq!(&read, &link, "{}", text);
            let address = format!("https://example.org/umbrage/{text}");
            prop_assert_eq!(Link::parse(&address).0, link, "an address");
            prop_assert!(text.is_ascii() && !text.contains([' ', '"', '#']), "{}", text);
        }

        #[test]
        fn no_text_is_too_wild_to_be_read(text in "\\PC{0,80}", pairs in "(&?[a-z.]{0,9}=[a-z0-9.=,%+-]{0,12}){0,6}") {
            for text in [text, pairs] {
                for message in Link::parse(&text).1 {
                    prop_assert!(!message.contains('\n') && !message.is_empty());
                }
            }
        }
    }

    #[test]
    fn the_table_of_the_page_on_links_has_the_keys_of_a_link() {
        let page = include_str!("../../../docs/links.md");
        let cells = page.lines().filter_map(|line| line.strip_prefix("| `")?.split_once(" |"));
        let keys: Vec<&str> =
            cells.flat_map(|(cell, _)| cell.split(", ")).map(|key| key.trim_matches('`')).collect();
        let mut wanted: Vec<&str> = KEYS.split(", ").collect();
        let mut listed = keys.clone();
        wanted.sort_unstable();
        listed.sort_unstable();
        assert_eq!(listed, wanted);
    }

    #[test]
    fn a_link_is_readable_and_says_no_more_than_it_must() {
        assert_eq!(Link::default().to_string(), "?");
        let preset = Preset::named("soft").expect("a preset");
        let soft = Settings { splits: 3, ..(preset.settings)() };
        let link = Link {
            world: Some("knights".to_owned()),
            place: Some([Vec3::new(1.5, 2.0, -3.0), Vec3::ZERO]),
            settings: [soft, Settings::default()],
            compare: true,
            truth: true,
            ..Link::default()
        };
        let wanted =
            "?world=knights&eye=1.5,2,-3&target=0,0,0&preset=soft&set=splits=3&right.preset=default&truth";
        assert_eq!(link.to_string(), wanted);
        let filter = umbrage::Filter::of_kind("pcf").expect("a filter");
        let settings = Settings { filter, ..Settings::default() };
        let link = Link { settings: [settings.clone(), settings], ..Link::default() };
        assert_eq!(link.to_string(), "?set=filter.kind=pcf");
    }

    #[test]
    fn the_command_lines_words_and_a_browsers_own_spelling_are_read() {
        let (link, messages) = Link::parse(
            "http://localhost:8000/?world=knights&preset=soft&set=splits%3D3&set=lambda=0.9#truth&camera=far+view",
        );
        assert_eq!(messages, [""; 0]);
        let preset = Preset::named("soft").expect("a preset");
        let settings = Settings { splits: 3, lambda: 0.9, ..(preset.settings)() };
        assert_eq!(link.settings, [settings.clone(), settings]);
        assert_eq!((link.truth, link.camera.as_deref()), (true, Some("far view")));
        for address in ["https://example.org/v=2/?world=knights", "/a=b/#world=knights"] {
            let (link, messages) = Link::parse(address);
            assert_eq!((link.world.as_deref(), messages), (Some("knights"), Vec::new()), "{address}");
        }
        for none in ["", "?", "#", "https://example.org/umbrage/", "https://example.org/?probe"] {
            assert_eq!(Link::parse(none), (Link::default(), Vec::new()), "{none}");
        }
    }

    #[test]
    fn what_is_wrong_is_left_out_with_a_message_that_names_it_and_the_rest_holds() {
        for (wrong, wanted) in [
            ("colour=red", "`colour=red` is left out: a link has world, load, camera"),
            ("world=atlantis", "`world=atlantis` is left out: there is no such world here; there are "),
            ("time=soon", "`time=soon` is left out: wanted seconds, from -1000000 to 1000000"),
            ("time=1e7", "`time=1e7` is left out: wanted seconds"),
            ("eye=1e20,0,0", "`eye=1e20,0,0` is left out: wanted three numbers in metres"),
            ("eye=0,0,0&target=1e-30,0,0", "`eye` and `target` are left out: they are the same point"),
            ("hour=30", "`hour=30` is left out: wanted an hour from "),
            ("exposure=101", "`exposure=101` is left out: wanted stops, from -100 to 100"),
            ("exposed-for=0", "`exposed-for=0` is left out: wanted lux, from 0.000001 to 1000000000"),
            (
                "light.x.position=1,2,3",
                "`light.x.position=1,2,3` is left out: wanted light.N.position or light.N.direction, with the number of a light from 0",
            ),
            (
                "light.0.direction=0,0,0",
                "`light.0.direction=0,0,0` is left out: wanted a direction, as 0.3,-1,0.2",
            ),
            ("divider=7", "`divider=7` is left out: wanted a share from 0.02 to 0.98"),
            ("show=ghosts", "`show=ghosts` is left out: wanted shadows, unshadowed, splits, texels, extents"),
            ("lines=hair", "`lines=hair` is left out: wanted slices, maps or casters, with commas between"),
            ("truth=perhaps", "`truth=perhaps` is left out: wanted on or off"),
            ("eye=1,2", "`eye=1,2` is left out: wanted three numbers in metres, as 1.5,2,-3"),
            ("eye=1,2,3", "`eye` is left out: it needs `target` beside it"),
            ("target=1,2,3", "`target` is left out: it needs `eye` beside it"),
            ("eye=1,2,3&target=1,2,3", "`eye` and `target` are left out: they are the same point"),
            ("preset=bevie", "`preset=bevie` is left out: no preset is called `bevie`"),
            ("set=splits", "`set=splits` is left out: wanted a setting and its value, as splits=3"),
            ("set=splits=0", "`set=splits=0` is left out: `splits` must be from 1 to 9, got 0"),
            (
                "set=virtual_pages=16",
                "`set=virtual_pages=16` is left out: this version has no setting `virtual_pages`",
            ),
            ("set=filter.taps=3", "`set=filter.taps=3` is left out: "),
            ("set=bias.layer=first", "`bias.layer` is now `bias.depth_layer`"),
            ("set=fit=stable&set=warp=lispsm", "excludes"),
            ("right.set=splits=99", "`right.set=splits=99` is left out: "),
        ] {
            let (link, messages) = Link::parse(&format!("?{wrong}&set=lambda=0.5&truth"));
            let [message] = &messages[..] else { panic!("{wrong}: {messages:?}") };
            assert!(message.contains(wanted) && !message.contains('\n'), "{wrong}: {message}");
            assert_eq!(
                (link.settings[0].lambda, link.truth || wrong.starts_with("truth")),
                (0.5, true),
                "{wrong}"
            );
        }
        let (link, messages) = Link::parse("?set=splits=0&set=lambda=7&set=resolution=512");
        assert_eq!((messages.len(), link.settings[0].resolution), (2, 512), "{messages:?}");
    }

    #[test]
    fn settings_that_need_each_other_are_read_in_any_order() {
        let (link, messages) = Link::parse("?set=scheme=manual&set=splits=3&set=manual=[5.0,20.0]");
        assert_eq!((messages, &link.settings[0].manual[..]), (Vec::new(), &[5.0, 20.0][..]));
        let many = "&set=splits=0".repeat(5000);
        let (_, messages) = Link::parse(&many);
        assert!(messages.iter().any(|m| m.contains("at most")), "{messages:?}");
        let unknown: String = (0..300).map(|i| format!("&k{i}=1")).collect();
        let (_, messages) = Link::parse(&unknown);
        let last = messages.last().map(String::as_str);
        assert_eq!((messages.len(), last), (21, Some("280 more parts of the link are left out")));
    }
}
