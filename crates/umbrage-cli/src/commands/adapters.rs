//! `umbrage adapters`

use umbrage_render::Gpu;

use crate::failure::Outcome;
use crate::output::print;

pub fn run() -> Outcome {
    let adapters = Gpu::adapters();
    if adapters.is_empty() {
        return Err(umbrage_render::RenderError::NoAdapter.into());
    }
    for adapter in adapters {
        let has = |name, yes| if yes { name } else { "" };
        let features =
            [has("timestamps", adapter.timestamps), has("unclipped depth", adapter.unclipped_depth)];
        let features: Vec<_> = features.into_iter().filter(|name| !name.is_empty()).collect();
        print(&format!("{adapter}: {}\n", features.join(", ")))?;
    }
    Ok(())
}
