//! The options of a picture in a material library, which come before its file's name.
//!
//! Source: *Alias|Wavefront MTL material format*, 1995, section *Options for texture map statements*. A name may hold
//! spaces; so it begins where no option and no argument of one is left.

/// What stands behind `map_Kd` or `map_d`.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Picture {
    pub name: String,
    /// The channel that a scalar is read from, `-imfchan`.
    pub channel: Channel,
    /// What is added to each value, and what each is multiplied with before, `-mm`.
    pub base: f32,
    pub gain: f32,
    /// The first option that is not followed, and would show.
    pub ignored: Option<String>,
}

/// Which numbers of a picture make a scalar.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub(super) enum Channel {
    /// The file does not say: alpha where the picture has some, luminance where not.
    #[default]
    Any,
    Red,
    Green,
    Blue,
    /// Alpha, which the format calls matte.
    Matte,
    Luminance,
}

impl Channel {
    /// `z` stands for a depth, which pictures here do not have.
    fn of(letter: &str) -> Option<Self> {
        match letter {
            "r" => Some(Self::Red),
            "g" => Some(Self::Green),
            "b" => Some(Self::Blue),
            "m" => Some(Self::Matte),
            "l" => Some(Self::Luminance),
            _ => None,
        }
    }
}

impl Picture {
    /// Reads what stands behind the keyword; `None` where no name is left.
    pub fn read(arguments: &str) -> Option<Self> {
        let mut picture =
            Self { name: String::new(), channel: Channel::Any, base: 0.0, gain: 1.0, ignored: None };
        let mut rest = arguments.trim();
        while rest.starts_with('-') {
            let (option, after) = word(rest);
            let (arguments, after) = taken(option, after);
            // What begins with a dash and is no option is a name.
            let Some(arguments) = arguments else { break };
            picture.follow(option, &arguments);
            rest = after;
        }
        picture.name = rest.to_owned();
        (!rest.is_empty()).then_some(picture)
    }

    fn follow(&mut self, option: &str, arguments: &[&str]) {
        let numbers: Vec<f32> =
            arguments.iter().filter_map(|word| word.parse().ok().filter(|x: &f32| x.is_finite())).collect();
        let is = |same: f32| numbers.len() == arguments.len() && numbers.iter().all(|x| *x == same);
        let is_followed = match option {
            "-imfchan" => {
                let channel = arguments.first().and_then(|letter| Channel::of(letter));
                self.channel = channel.unwrap_or_default();
                channel.is_some()
            }
            "-mm" => match numbers[..] {
                [base, gain] => {
                    (self.base, self.gain) = (base, gain);
                    true
                }
                _ => false,
            },
            "-o" | "-t" => is(0.0),
            "-s" => is(1.0),
            "-clamp" => arguments != ["on"],
            // They change how a picture is filtered, and not what it says.
            _ => true,
        };
        if !is_followed && self.ignored.is_none() {
            self.ignored = Some([&[option], arguments].concat().join(" "));
        }
    }
}

/// The first word, and what follows it.
fn word(text: &str) -> (&str, &str) {
    let (word, rest) = text.split_at(text.find(char::is_whitespace).unwrap_or(text.len()));
    (word, rest.trim_start())
}

/// The arguments of an option, and what follows them; `None` for what is no option.
fn taken<'a>(option: &str, mut rest: &'a str) -> (Option<Vec<&'a str>>, &'a str) {
    let (least, most) = match option {
        "-blendu" | "-blendv" | "-cc" | "-clamp" | "-texres" | "-imfchan" | "-bm" | "-boost" | "-type" => {
            (1, 1)
        }
        "-mm" => (2, 2),
        "-o" | "-s" | "-t" => (1, 3),
        _ => return (None, rest),
    };
    let mut arguments = Vec::new();
    while arguments.len() < most && !rest.is_empty() {
        let (next, after) = word(rest);
        // A name may follow after fewer numbers than there could be.
        if arguments.len() >= least && next.parse::<f32>().is_err() {
            break;
        }
        arguments.push(next);
        rest = after;
    }
    (Some(arguments), rest)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Picture {
        Picture::read(text).unwrap()
    }

    #[test]
    fn names_begin_after_the_options_and_may_hold_spaces() {
        for (text, name) in [
            ("b.png", "b.png"),
            (" my leaf.png ", "my leaf.png"),
            ("-s 2 2 b.png", "b.png"),
            ("-s 2 2 2 -o 0.5 my leaf.png", "my leaf.png"),
            ("-blendu on -imfchan r b.png", "b.png"),
            ("-mm 0 1 1.png", "1.png"),
            ("-o 1 2 3 4.png", "4.png"),
            ("-leaf.png", "-leaf.png"),
        ] {
            assert_eq!(read(text).name, name, "{text}");
        }
        for text in ["", "  ", "-s 2 2", "-imfchan", "-mm 1 2"] {
            assert_eq!(Picture::read(text), None, "{text}");
        }
    }

    #[test]
    fn channels_and_gains_are_followed() {
        assert_eq!(read("-imfchan m a.png").channel, Channel::Matte);
        assert_eq!(
            read("-imfchan l -mm 1 -1 a.png"),
            Picture {
                name: "a.png".to_owned(),
                channel: Channel::Luminance,
                base: 1.0,
                gain: -1.0,
                ignored: None,
            }
        );
        assert_eq!(read("a.png").channel, Channel::Any);
    }

    #[test]
    fn what_would_show_and_is_not_followed_is_told() {
        let told = |text: &str| read(text).ignored;
        assert_eq!(told("-s 2 2 a.png"), Some("-s 2 2".to_owned()));
        assert_eq!(told("-clamp on a.png"), Some("-clamp on".to_owned()));
        assert_eq!(told("-imfchan z a.png"), Some("-imfchan z".to_owned()));
        assert_eq!(told("-mm a b c.png"), Some("-mm a b".to_owned()));
        for harmless in ["-s 1 1 1 -o 0 0 0 a.png", "-clamp off -cc on a.png", "-bm 0.5 a.png"] {
            assert_eq!(told(harmless), None, "{harmless}");
        }
    }
}
