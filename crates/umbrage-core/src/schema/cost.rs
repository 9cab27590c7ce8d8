//! What does a change of a setting make anew?

/// What a change of a setting makes anew, cheapest first. The first two are made for every frame anyhow.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Cost {
    /// The next plan: where the maps lie, and what is drawn into them. No object of the GPU.
    Plan,
    /// The numbers that are uploaded with each frame. No object of the GPU.
    Frame,
    /// The text of receivers' shaders, and the pipelines that hold it.
    Shader,
    /// The pipelines that draw casters.
    Casters,
    /// The textures of the maps, and the steps that make moments or sums of them.
    Maps,
}

impl Cost {
    /// Every cost, cheapest first.
    pub const ALL: [Self; 5] = [Self::Plan, Self::Frame, Self::Shader, Self::Casters, Self::Maps];
}
