//! The GPU objects behind shadows, and which of them other settings or lights need anew.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use umbrage_core::{Allocation, Fit, Settings};
use umbrage_wgsl::{ShaderKey, caster_bindings, receiver_bindings};

use crate::bindings;
use crate::capabilities::Capabilities;
use crate::filtered::Filtered;
use crate::filtered_textures::Source;
use crate::frame::FrameBuffers;
use crate::kept::Kept;
use crate::layers::Layers;
use crate::maps::{Maps, clear_pipeline};
use crate::objects::Objects;
use crate::occluders::Occluders;
use crate::receivers::{Bound, ReceiverLayout, Samplers, SamplersKind};
use crate::samples::Samples;
use crate::still_maps::StillMaps;

/// What the objects are to serve.
#[derive(Clone, Copy)]
pub(crate) struct Wanted<'a> {
    pub settings: &'a Settings,
    pub key: &'a ShaderKey,
    pub allocation: &'a Allocation,
    pub capabilities: Capabilities,
    pub occluders: Option<&'a Occluders>,
}

/// What the tiles of some maps show, known to all copies of the shadows that draw into them.
#[derive(Clone, Debug, Default)]
pub(crate) struct SharedTiles(Arc<Mutex<Kept>>);

impl SharedTiles {
    pub fn lock(&self) -> MutexGuard<'_, Kept> {
        // What a thread left half-noted when it panicked is not believed.
        self.0.lock().unwrap_or_else(|poisoned: PoisonError<_>| {
            let mut kept = poisoned.into_inner();
            kept.forget();
            kept
        })
    }
}

/// All GPU objects.
#[derive(Clone, Debug)]
pub(crate) struct Parts {
    pub caster_layout: wgpu::BindGroupLayout,
    pub buffers: FrameBuffers,
    pub maps: Maps,
    pub layers: Option<Layers>,
    /// The maps of what stands, once there was a use for them.
    pub still: Option<StillMaps>,
    /// The steps that fit views to what is seen, where that is asked for.
    pub samples: Option<Samples>,
    /// What the tiles show, which all who share the maps must agree on.
    pub kept: SharedTiles,
    pub filtered: Option<Filtered>,
    /// What the filtered maps were made for.
    key: ShaderKey,
    samplers: Samplers,
    /// What rays go through.
    occluders: Option<Occluders>,
    pub receiver_layout: ReceiverLayout,
    pub receiver_group: wgpu::BindGroup,
}

impl Parts {
    /// Objects for what is wanted: those of `old` where they serve it.
    pub fn new(objects: &Objects<'_>, wanted: Wanted<'_>, old: Option<&Self>) -> Self {
        let Wanted { settings, key, allocation, capabilities, occluders } = wanted;
        let (layout, views) = (allocation.layout(), allocation.tiles().len() as u32);
        let caster_layout = kept(old.map(|old| &old.caster_layout), || {
            bindings::group_layout(objects, "Shadows::caster_layout", &caster_bindings())
        });
        let buffers = kept(old.map(|old| &old.buffers).filter(|buffers| buffers.views == views), || {
            FrameBuffers::new(objects, views, &caster_layout)
        });
        let maps = kept(old.map(|old| &old.maps).filter(|maps| maps.layout == layout), || {
            Maps::new(objects, layout, capabilities, clear_pipeline(objects, layout).as_ref())
        });
        // What binds the frame and the maps goes on only where both do.
        let bound = old.filter(|old| old.buffers.frame == buffers.frame && old.maps.all == maps.all);
        let depth_layer = settings.bias.depth_layer;
        let layers = bound.and_then(|old| old.layers.clone()).filter(|layers| layers.makes(depth_layer));
        let layers = layers.or_else(|| Layers::new(objects, &buffers, &maps, depth_layer, capabilities));
        // With a second surface a tile is one with its layers.
        let still = bound.filter(|_| layers.is_none()).and_then(|old| old.still.clone());
        let has_samples = settings.fit == Fit::Sample && capabilities.computes;
        let samples = has_samples
            .then(|| kept(bound.and_then(|old| old.samples.as_ref()), || Samples::new(objects, &buffers)));
        let filtered = match bound.filter(|old| old.key == *key) {
            Some(old) => old.filtered.clone(),
            None => {
                let min_layers = capabilities.min_layers;
                let source = Source { objects, buffers: &buffers, depths: &maps.all, layout, min_layers };
                let old = old.and_then(|old| old.filtered.as_ref());
                Filtered::new(source, key, &settings.filter, old)
            }
        };
        let kind = SamplersKind::of(&settings.filter);
        let samplers = kept(old.map(|old| &old.samplers).filter(|samplers| samplers.are(kind)), || {
            Samplers::new(objects, kind)
        });
        let bindings = receiver_bindings(key);
        let receiver_layout = old.map(|old| &old.receiver_layout).filter(|old| old.bindings == bindings);
        let receiver_layout = kept(receiver_layout, || ReceiverLayout::new(objects, bindings));
        let same_group = bound.filter(|old| {
            old.receiver_layout.layout == receiver_layout.layout
                && old.samplers.are(kind)
                && old.occluders.as_ref() == occluders
                && texture(&old.filtered) == texture(&filtered)
        });
        let receiver_group = kept(same_group.map(|old| &old.receiver_group), || {
            let filtered = filtered.as_ref();
            let bound = Bound { buffers: &buffers, maps: &maps, filtered, samplers: &samplers, occluders };
            receiver_layout.group(objects, bound)
        });
        let key = key.clone();
        Self {
            caster_layout,
            buffers,
            maps,
            layers,
            still,
            samples,
            // Settings say how casters are drawn too: what was drawn with others is not kept.
            kept: SharedTiles::default(),
            filtered,
            key,
            samplers,
            occluders: occluders.cloned(),
            receiver_layout,
            receiver_group,
        }
    }

    /// What receivers bind, for a group in which it begins with this number.
    pub fn receiver_entries(&self, first: u32) -> Vec<wgpu::BindGroupEntry<'_>> {
        let Self { buffers, maps, samplers, .. } = self;
        let (filtered, occluders) = (self.filtered.as_ref(), self.occluders.as_ref());
        self.receiver_layout.entries(Bound { buffers, maps, filtered, samplers, occluders }, first)
    }

    /// Whether something must be drawn anew where these stand instead of others.
    pub fn has_other_maps(&self, old: &Self) -> bool {
        let first = |parts: &Self| parts.layers.as_ref().map(|layers| layers.first.all.clone());
        self.maps.all != old.maps.all
            || first(self) != first(old)
            || texture(&self.filtered) != texture(&old.filtered)
    }

    /// Bytes of the casters that rays go through; 0 where none are bound.
    pub fn occluder_bytes(&self) -> u64 {
        self.occluders.as_ref().map_or(0, Occluders::bytes)
    }

    /// Bytes of all maps that lookups read and that those are made from.
    pub fn bytes(&self) -> u64 {
        self.maps.layout.bytes()
            + self.layers.as_ref().map_or(0, Layers::bytes)
            + self.still.as_ref().map_or(0, |still| still.maps.layout.bytes())
            + self.filtered.as_ref().map_or(0, |filtered| filtered.textures().bytes())
    }
}

/// The one that there is, or a new one.
fn kept<T: Clone>(old: Option<&T>, make: impl FnOnce() -> T) -> T {
    old.cloned().unwrap_or_else(make)
}

fn texture(filtered: &Option<Filtered>) -> Option<&wgpu::TextureView> {
    filtered.as_ref().map(|filtered| &filtered.textures().all)
}
