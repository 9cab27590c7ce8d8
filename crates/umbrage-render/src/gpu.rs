//! Adapters, and a device on one of them.

use umbrage::Capabilities;

use crate::error::RenderError;

/// An adapter, its device and its queue. A clone is the same device.
#[derive(Clone, Debug)]
pub struct Gpu {
    /// What resources are made with.
    pub device: wgpu::Device,
    /// What work is handed to.
    pub queue: wgpu::Queue,
    /// Whose they are.
    pub adapter: AdapterDescription,
}

/// An adapter in words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AdapterDescription {
    /// The adapter's own name.
    pub name: String,
    /// `vulkan`, `gl`, `metal`, `dx12` or `webgpu`.
    pub backend: String,
    /// What kind of device it is.
    pub kind: String,
    /// Driver and version.
    pub driver: String,
    /// Whether passes can be timed on the device.
    pub timestamps: bool,
    /// Whether casters can be flattened onto near planes.
    pub unclipped_depth: bool,
    /// Whether a picture can be seen as other numbers than it was drawn as: what windows need.
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

fn describe(adapter: &wgpu::Adapter) -> AdapterDescription {
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
fn preference(adapter: &wgpu::Adapter) -> (u8, u8) {
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

fn adapters(backends: wgpu::Backends) -> Vec<wgpu::Adapter> {
    let mut adapters = pollster::block_on(instance(backends).enumerate_adapters(backends));
    adapters.sort_by_key(preference);
    adapters
}

impl Gpu {
    /// Every adapter here, the one that [`Self::new`] prefers first.
    pub fn adapters() -> Vec<AdapterDescription> {
        adapters(wgpu::Backends::all()).iter().map(describe).collect()
    }

    /// A device on the preferred adapter, or on the first whose description contains `wanted`, in any case.
    ///
    /// # Errors
    /// When there is no such adapter, or it gives no device.
    pub fn new(wanted: Option<&str>) -> Result<Self, RenderError> {
        // GL is asked only where nothing else will do: it is slow to start, and chatty.
        let mut adapters = adapters(wgpu::Backends::PRIMARY);
        if Self::choose(&adapters, wanted).is_err() {
            adapters = self::adapters(wgpu::Backends::all());
        }
        let adapter = Self::choose(&adapters, wanted)?;
        let description = describe(adapter);
        let (device, queue) =
            pollster::block_on(adapter.request_device(&Self::wanted_device(adapter))).map_err(|e| {
                RenderError::NoDevice { adapter: description.name.clone(), reason: e.to_string() }
            })?;
        Ok(Self { device, queue, adapter: description })
    }

    /// What to ask an adapter's device for: all that shadows profit from, timestamps, and the adapter's own limits.
    pub fn wanted_device(adapter: &wgpu::Adapter) -> wgpu::DeviceDescriptor<'static> {
        wgpu::DeviceDescriptor {
            label: Some("Gpu::device"),
            required_features: Capabilities::wanted_features(adapter)
                | (adapter.features() & wgpu::Features::TIMESTAMP_QUERY),
            required_limits: adapter.limits(),
            ..Default::default()
        }
    }

    /// A device that somebody else has made, as a window does; best from [`Self::wanted_device`].
    pub fn of_device(adapter: &wgpu::Adapter, device: wgpu::Device, queue: wgpu::Queue) -> Self {
        Self { device, queue, adapter: describe(adapter) }
    }

    /// The best of some adapters: hardware before software, and GL last; of those whose description contains `wanted`, in
    /// any case.
    ///
    /// # Errors
    /// When there is none, or none such.
    pub fn choose<'a>(
        adapters: &'a [wgpu::Adapter],
        wanted: Option<&str>,
    ) -> Result<&'a wgpu::Adapter, RenderError> {
        let text = |adapter: &wgpu::Adapter| describe(adapter).to_string();
        let matches = |adapter: &&wgpu::Adapter| {
            wanted.is_none_or(|wanted| text(adapter).to_lowercase().contains(&wanted.to_lowercase()))
        };
        let best = adapters.iter().filter(matches).min_by_key(|adapter| preference(adapter));
        best.ok_or_else(|| match wanted {
            Some(wanted) if !adapters.is_empty() => RenderError::NoSuchAdapter {
                wanted: wanted.to_owned(),
                found: adapters.iter().map(text).collect(),
            },
            _ => RenderError::NoAdapter,
        })
    }

    /// Makes something large, and says so where there is no memory for it.
    ///
    /// # Errors
    /// As `make`, and when the device has no room.
    pub(crate) fn allocate<T, E>(
        &self,
        what: &str,
        make: impl FnOnce() -> Result<T, E>,
    ) -> Result<T, RenderError>
    where
        RenderError: From<E>,
    {
        if cfg!(target_arch = "wasm32") {
            // A page cannot wait for the scopes: what is refused reaches the device's own handler of errors.
            return Ok(make()?);
        }
        // What was refused for want of memory is invalid wherever it is used next: both are one failure.
        let invalid = self.device.push_error_scope(wgpu::ErrorFilter::Validation);
        let no_memory = self.device.push_error_scope(wgpu::ErrorFilter::OutOfMemory);
        let made = make();
        let no_memory = pollster::block_on(no_memory.pop());
        let invalid = pollster::block_on(invalid.pop());
        match (no_memory, invalid) {
            (None, None) => Ok(made?),
            (Some(_), _) => Err(RenderError::Device(format!("there is no memory for {what}"))),
            (None, Some(error)) => Err(RenderError::Device(format!("{what} cannot be made: {error}"))),
        }
    }

    /// Copies the first `count` numbers of a buffer to the CPU, and waits for them.
    ///
    /// # Errors
    /// When the device fails.
    pub(crate) fn read_floats(&self, buffer: &wgpu::Buffer, count: usize) -> Result<Vec<f32>, RenderError> {
        let size = 4 * count as u64;
        let copy = self.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("Gpu::read_floats"),
            size,
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let mut encoder = self.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        encoder.copy_buffer_to_buffer(buffer, 0, &copy, 0, size);
        self.queue.submit([encoder.finish()]);
        self.read_mapped(copy, |bytes| {
            bytes.as_chunks().0.iter().map(|four| f32::from_ne_bytes(*four)).collect()
        })
    }

    /// What `read` makes of the bytes of a buffer that can be mapped, once everything handed over is done.
    ///
    /// # Errors
    /// When the device fails.
    pub(crate) fn read_mapped<T>(
        &self,
        buffer: wgpu::Buffer,
        read: impl FnOnce(&[u8]) -> T,
    ) -> Result<T, RenderError> {
        let coming = Coming::new(buffer);
        self.wait()?;
        coming.take(read).unwrap_or_else(|| Err(RenderError::Device("a buffer was not mapped".to_owned())))
    }

    /// Waits until everything that was handed over is done.
    ///
    /// # Errors
    /// When the device is lost.
    pub fn wait(&self) -> Result<(), RenderError> {
        self.device
            .poll(wgpu::PollType::wait_indefinitely())
            .map(drop)
            .map_err(|e| RenderError::Device(e.to_string()))
    }
}

/// The bytes of a buffer on their way to the CPU.
#[derive(Debug)]
pub(crate) struct Coming {
    buffer: wgpu::Buffer,
    mapped: std::sync::mpsc::Receiver<Result<(), wgpu::BufferAsyncError>>,
}

impl Coming {
    /// Asks for them: they come when everything that was handed over before is done.
    pub fn new(buffer: wgpu::Buffer) -> Self {
        let (sender, mapped) = std::sync::mpsc::channel();
        buffer.map_async(wgpu::MapMode::Read, .., move |result| {
            // Whoever asked may have lost interest.
            let _ = sender.send(result);
        });
        Self { buffer, mapped }
    }

    /// What `read` makes of them; `None` where they have not come yet.
    pub fn take<T>(&self, read: impl FnOnce(&[u8]) -> T) -> Option<Result<T, RenderError>> {
        let failed = |error: &dyn std::fmt::Display| RenderError::Device(error.to_string());
        match self.mapped.try_recv() {
            Err(std::sync::mpsc::TryRecvError::Empty) => None,
            Err(error) => Some(Err(failed(&error))),
            Ok(Err(error)) => Some(Err(failed(&error))),
            Ok(Ok(())) => Some(self.buffer.get_mapped_range(..).map(|b| read(&b)).map_err(|e| failed(&e))),
        }
    }
}
