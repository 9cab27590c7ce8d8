//! The shader texts that Umbrage has for some settings, each by a name, and what each binds.

use umbrage_core::Settings;
use umbrage_wgsl::{self as shaders, Binding, ShaderKey, Slot, Step, TextureSupport};

/// A shader text. Texts of steps are whole shaders, whose entry point is called as the stage is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
#[serde(rename_all = "lowercase")]
pub enum Stage {
    /// Goes in front of a shader that asks for visibility: `umbrage_visibility(world_position, world_normal, pixel)`
    Receiver,
    /// Goes in front of a caster's vertex shader: `umbrage_caster_position(world_position)`
    Caster,
    /// Goes behind the receiver's text: `umbrage_contact(light, world_position, world_normal, pixel)`, where `contact` is on
    Contact,
    /// Goes in front of a shader that looks into the maps: `umbrage_linear_depth(view_index, texel, stored)`
    Map,
    /// A vertex shader that empties a tile of an atlas
    Clear,
    /// A fragment shader behind the caster's text that leaves out the first surface, where `bias.depth_layer` wants two
    Peel,
    /// Shaders that make one depth of two surfaces, where `bias.depth_layer` wants two
    Join,
    /// A compute shader that makes moments of depths, where `filter.kind` blurs them
    Convert,
    /// A compute shader that blurs rows of moments
    Across,
    /// A compute shader that blurs columns of moments
    Down,
    /// A compute shader that makes the next smaller size of moments
    Halve,
    /// A compute shader that sums rows of moments, where `filter.kind` sums them
    Rows,
    /// A compute shader that sums columns of moments
    Columns,
}

/// What a device can do that runs the texts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Deserialize)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
#[serde(rename_all = "lowercase")]
pub enum Textures {
    /// What every WebGPU has
    #[default]
    Webgpu,
    /// Also 32-bit textures that samplers weigh, 16-bit normalised ones, and writing of two 16-bit floats
    All,
}

impl Stage {
    /// All stages, in the order of `umbrage wgsl --help`.
    pub const ALL: [Self; 13] = [
        Self::Receiver,
        Self::Caster,
        Self::Contact,
        Self::Map,
        Self::Clear,
        Self::Peel,
        Self::Join,
        Self::Convert,
        Self::Across,
        Self::Down,
        Self::Halve,
        Self::Rows,
        Self::Columns,
    ];
}

impl Textures {
    fn support(self) -> TextureSupport {
        match self {
            Self::Webgpu => TextureSupport::WEBGPU,
            Self::All => TextureSupport::ALL,
        }
    }
}

/// All texts of some settings.
#[derive(Debug)]
pub struct Stages<'a> {
    settings: &'a Settings,
    key: ShaderKey,
}

impl<'a> Stages<'a> {
    /// Returns the texts of settings for devices of a kind.
    pub fn new(settings: &'a Settings, textures: Textures) -> Self {
        Self { settings, key: ShaderKey::new(settings, textures.support()) }
    }

    /// Returns a stage's text; its bindings lie at `slot` where it goes in front of another's, and otherwise in group 0. `None` where the
    /// settings have no such stage.
    pub fn text(&self, stage: Stage, slot: impl Into<Slot>) -> Option<String> {
        let slot = slot.into();
        match stage {
            Stage::Receiver => Some(shaders::receiver(&self.key, slot)),
            Stage::Caster => Some(shaders::caster(slot)),
            Stage::Contact => self.settings.contact.as_ref().map(|contact| shaders::contact(contact, slot)),
            Stage::Map => Some(shaders::map()),
            Stage::Clear => Some(shaders::clear()),
            Stage::Peel => self.join().map(|_| shaders::peel()),
            Stage::Join => self.join(),
            Stage::Convert | Stage::Across | Stage::Down | Stage::Halve | Stage::Rows | Stage::Columns => {
                self.step(stage).map(|step| step.text)
            }
        }
    }

    /// Returns what a stage binds; `None` where the settings have no such stage.
    pub fn bindings(&self, stage: Stage) -> Option<Vec<Binding>> {
        match stage {
            Stage::Receiver => Some(shaders::receiver_bindings(&self.key)),
            Stage::Caster => Some(shaders::caster_bindings()),
            Stage::Contact => self.settings.contact.as_ref().map(|_| shaders::contact_bindings()),
            Stage::Map | Stage::Clear => None,
            Stage::Peel => self.join().map(|_| shaders::peel_bindings()),
            Stage::Join => self.join().map(|_| shaders::join_bindings()),
            Stage::Convert | Stage::Across | Stage::Down | Stage::Halve | Stage::Rows | Stage::Columns => {
                self.step(stage).map(|step| step.bindings.to_vec())
            }
        }
    }

    fn join(&self) -> Option<String> {
        shaders::join(self.settings.bias.depth_layer)
    }

    fn step(&self, stage: Stage) -> Option<Step> {
        let (moments, sums) = (self.key.moment_steps(), self.key.sum_steps());
        match stage {
            Stage::Convert => moments.map(|steps| steps.convert),
            Stage::Across => moments.map(|steps| steps.across),
            Stage::Down => moments.map(|steps| steps.down),
            Stage::Halve => moments.map(|steps| steps.halve),
            Stage::Rows => sums.map(|steps| steps.rows),
            Stage::Columns => sums.map(|steps| steps.columns),
            Stage::Receiver
            | Stage::Caster
            | Stage::Contact
            | Stage::Map
            | Stage::Clear
            | Stage::Peel
            | Stage::Join => None,
        }
    }
}
