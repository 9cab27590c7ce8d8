//! Adapters: what there is, in words, and which comes first.

/// Describes an adapter in words, and says what of ours it supports.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AdapterDescription {
    /// The adapter's own name.
    pub name: String,
    /// The graphics interface: `vulkan`, `gl`, `metal`, `dx12` or `webgpu`.
    pub backend: String,
    /// The kind of device: `discrete GPU`, `integrated GPU`, `virtual GPU`, `software` or `other`.
    pub kind: String,
    /// The driver's name and version.
    pub driver: String,
    /// Whether passes can be timed on the device.
    pub timestamps: bool,
    /// Whether casters can be flattened onto near planes.
    pub unclipped_depth: bool,
    /// Whether a texture can be viewed in another format than its own, which showing a picture in a window needs.
    pub view_formats: bool,
}

impl std::fmt::Display for AdapterDescription {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { name, backend, kind, driver, timestamps: _, unclipped_depth: _, view_formats: _ } = self;
        let parts = [kind, backend, driver].map(String::as_str);
        let known: Vec<&str> = parts.into_iter().filter(|part| !part.is_empty()).collect();
        write!(f, "{name} ({})", known.join(", "))
    }
}

fn instance(backends: wgpu::Backends) -> wgpu::Instance {
    wgpu::Instance::new(wgpu::InstanceDescriptor {
        backends,
        ..wgpu::InstanceDescriptor::new_without_display_handle()
    })
}

pub(crate) fn describe(adapter: &wgpu::Adapter) -> AdapterDescription {
    let info = adapter.get_info();
    let kind = match info.device_type {
        wgpu::DeviceType::DiscreteGpu => "discrete GPU",
        wgpu::DeviceType::IntegratedGpu => "integrated GPU",
        wgpu::DeviceType::VirtualGpu => "virtual GPU",
        wgpu::DeviceType::Cpu => "software",
        wgpu::DeviceType::Other => "other",
    };
    AdapterDescription {
        // Browsers do not tell.
        name: if info.name.is_empty() { "the browser's adapter".to_owned() } else { info.name },
        backend: info.backend.to_string(),
        kind: kind.to_owned(),
        driver: [info.driver, info.driver_info].join(" ").trim().to_owned(),
        timestamps: adapter.features().contains(wgpu::Features::TIMESTAMP_QUERY),
        unclipped_depth: adapter.features().contains(wgpu::Features::DEPTH_CLIP_CONTROL),
        view_formats: adapter.get_downlevel_capabilities().flags.contains(wgpu::DownlevelFlags::VIEW_FORMATS),
    }
}

/// Hardware before software, Vulkan, Metal and DX12 before GL.
pub(crate) fn preference(adapter: &wgpu::Adapter) -> (u8, u8) {
    let info = adapter.get_info();
    let kind = match info.device_type {
        wgpu::DeviceType::DiscreteGpu => 0,
        wgpu::DeviceType::IntegratedGpu => 1,
        wgpu::DeviceType::VirtualGpu => 2,
        wgpu::DeviceType::Other => 3,
        wgpu::DeviceType::Cpu => 4,
    };
    (u8::from(info.backend == wgpu::Backend::Gl), kind)
}

pub(crate) fn adapters(backends: wgpu::Backends) -> Vec<wgpu::Adapter> {
    let mut adapters = pollster::block_on(instance(backends).enumerate_adapters(backends));
    adapters.sort_by_key(preference);
    adapters
}
