//! What must be made anew when settings change? Each thing depends on some of them, which are its key: where two settings
//! have the same key, it can stay.

use crate::bias::CompareDepth;
use crate::contact::Contact;
use crate::filter::{LightSize, ShaderNumber, Stored};
use crate::fit::Fit;
use crate::light_box::LightBox;
use crate::schema::cost::Cost;
use crate::settings::bias::{BiasNumbers, FrameBias, PlanBias};
use crate::settings::{
    Bias, CasterFaces, DepthFormat, DepthLayer, Exact, Scheme, Select, Settings, Shade, Storage,
    TransparentCasters,
};
use crate::warp::Warp;

/// What the textures of the maps depend on, and the steps that make moments or sums of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MapsKey {
    /// The number of views of a sun.
    pub splits: u32,
    /// The number of views of a spot.
    pub spot_splits: u32,
    /// Texels a side of a tile, for lights that say none of their own.
    pub resolution: u32,
    /// The share of the side of the split before that each split's tile has, from 0.25 to 2 times.
    pub resolution_falloff: f32,
    /// The format of a texel.
    pub depth: DepthFormat,
    /// Where the tiles lie.
    pub storage: Storage,
    /// What is stored of the surfaces that a ray of light meets.
    pub depth_layer: DepthLayer,
    /// What lookups read instead of depths.
    pub stored: Stored,
}

/// What the pipelines depend on that draw casters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CasterKey {
    /// The format that they write.
    pub depth: DepthFormat,
    /// Whether casters before the near plane are flattened onto it, where a device can.
    pub flattens: bool,
    /// The faces that are drawn.
    pub faces: CasterFaces,
    /// Casters are drawn so many of the format's smallest steps deeper.
    pub raster_constant: i32,
    /// Casters are drawn so much deeper, in their own depth slopes a texel.
    pub raster_slope: f32,
    /// Whether casters are drawn once more, for the second surface.
    pub draws_second: bool,
}

/// What the shader text of receivers depends on.
#[derive(Clone, Debug, PartialEq)]
pub struct ReceiverKey {
    /// The filter's kind, which is the name of its shader file.
    pub filter: &'static str,
    /// The numbers that the text is compiled with.
    pub numbers: Vec<ShaderNumber>,
    /// The number of mip levels of moments that there are to choose from; 0 where there are no moments.
    pub mip_levels: u32,
    /// The rule by which a receiver finds its view.
    pub select: Select,
    /// Whether a view is blended with the next.
    pub blends: bool,
    /// What each texel is compared with.
    pub compare_depth: CompareDepth,
    /// Which receivers are traced, where there is something to trace.
    pub exact: Exact,
    /// The march through the camera's depth, where there is one.
    pub contact: Option<Contact>,
}

/// What the planner asks of settings.
#[derive(Debug, PartialEq)]
struct PlanKey<'a> {
    splits: u32,
    spot_splits: u32,
    scheme: Scheme,
    lambda: f32,
    split_bias: f32,
    manual: &'a [f32],
    distance: Option<f32>,
    near: Option<f32>,
    resolution: u32,
    resolution_falloff: f32,
    depth: DepthFormat,
    storage: Storage,
    fit: Fit,
    light_box: Option<LightBox>,
    flattens: bool,
    transparent_casters: TransparentCasters,
    caster_error: f32,
    warp: Warp,
    select: Select,
    blend: f32,
    /// The reach of lookups: of the filter, of the receiver's plane, of the offset along the normal.
    reach_texels: [f32; 3],
    bias: PlanBias,
    receiver_plane: bool,
}

/// What is uploaded with each frame.
#[derive(Debug, PartialEq)]
struct FrameKey {
    bias: FrameBias,
    depth: DepthFormat,
    blend: f32,
    transparent_casters: TransparentCasters,
    light_size: Option<LightSize>,
    shade: Shade,
}

/// Every key of some settings.
struct Keys<'a> {
    plan: PlanKey<'a>,
    frame: FrameKey,
    receiver: ReceiverKey,
    caster: CasterKey,
    maps: MapsKey,
}

/// What a change of settings makes anew; each field is one [`Cost`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Change {
    /// The next plan differs.
    pub plan: bool,
    /// The numbers that are uploaded with each frame differ.
    pub frame: bool,
    /// Receivers' shaders, and the pipelines that hold them, must be made anew.
    pub shader: bool,
    /// The pipelines that draw casters must be made anew.
    pub casters: bool,
    /// The maps, and the steps that make moments or sums of them, must be made anew.
    pub maps: bool,
}

impl Change {
    /// Whether it makes one of the costs.
    pub fn makes(&self, cost: Cost) -> bool {
        match cost {
            Cost::Plan => self.plan,
            Cost::Frame => self.frame,
            Cost::Shader => self.shader,
            Cost::Casters => self.casters,
            Cost::Maps => self.maps,
        }
    }

    /// Whether no object of the GPU must be made anew.
    pub fn is_free(&self) -> bool {
        !(self.shader || self.casters || self.maps)
    }
}

impl Settings {
    /// What must be made anew when these settings give way to others.
    pub fn change_to(&self, other: &Self) -> Change {
        let (from, to) = (self.keys(), other.keys());
        Change {
            plan: from.plan != to.plan,
            frame: from.frame != to.frame,
            shader: from.receiver != to.receiver,
            casters: from.caster != to.caster,
            maps: from.maps != to.maps,
        }
    }

    /// What the textures of the maps depend on, and the steps that make moments or sums of them.
    pub fn maps_key(&self) -> MapsKey {
        self.keys().maps
    }

    /// What the pipelines depend on that draw casters.
    pub fn caster_key(&self) -> CasterKey {
        self.keys().caster
    }

    /// What the shader text of receivers depends on.
    pub fn receiver_key(&self) -> ReceiverKey {
        self.keys().receiver
    }

    /// Every setting is taken apart here, so that a new one finds its keys.
    fn keys(&self) -> Keys<'_> {
        let Self {
            splits,
            spot_splits,
            scheme,
            lambda,
            split_bias,
            ref manual,
            distance,
            near,
            resolution,
            resolution_falloff,
            depth,
            storage,
            fit,
            light_box,
            transparent_casters,
            caster_error,
            unclipped_depth: _, // with the filter, it says whether casters are flattened
            warp,
            select,
            blend,
            filter,
            exact,
            bias,
            contact,
            shade,
        } = *self;
        let flattens = self.flattens_casters();
        let Bias { receiver_plane, casters: faces, raster_constant, raster_slope, depth_layer, .. } = bias;
        let BiasNumbers { plan, frame } = bias.numbers();
        let draws_second = depth_layer != DepthLayer::First;
        let stored = filter.stores();
        let mip_levels = match stored {
            Stored::Prefiltered { prefilter, .. } => prefilter.mip_levels,
            Stored::Depths | Stored::Summed { .. } => 0,
        };
        let offset_reach = filter.offset_reach_texels(f32::MIN_POSITIVE);
        Keys {
            plan: PlanKey {
                splits,
                spot_splits,
                scheme,
                lambda,
                split_bias,
                manual,
                distance,
                near,
                resolution,
                resolution_falloff,
                depth,
                storage,
                fit,
                light_box,
                flattens,
                transparent_casters,
                caster_error,
                warp,
                select,
                blend,
                reach_texels: [filter.reach_texels(), filter.plane_reach_texels(), offset_reach],
                bias: plan,
                receiver_plane,
            },
            frame: FrameKey {
                bias: frame,
                depth,
                blend,
                transparent_casters,
                light_size: filter.light_size(),
                shade,
            },
            receiver: ReceiverKey {
                filter: filter.kind(),
                numbers: filter.numbers(),
                mip_levels,
                select,
                blends: blend > 0.0,
                compare_depth: self.compare_depth(),
                exact,
                contact,
            },
            caster: CasterKey { depth, flattens, faces, raster_constant, raster_slope, draws_second },
            maps: MapsKey {
                splits,
                spot_splits,
                resolution,
                resolution_falloff,
                depth,
                storage,
                depth_layer,
                stored,
            },
        }
    }
}
