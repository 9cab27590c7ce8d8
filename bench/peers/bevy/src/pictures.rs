//! The pictures that visibility is taken from: with shadows (S), without (U), and by ambient light alone (A). In linear
//! light, visibility is (S − A) / (U − A), where U − A is not small.

use std::path::{Path, PathBuf};
use std::time::Duration;

use anyhow::{Context as _, ensure};
use bevy::prelude::*;
use bevy::render::view::screenshot::{Screenshot, save_to_disk};

use crate::app::Peer;
use crate::stage::SUN_LUX;

/// A picture is waited for so many frames at most.
const MOST_FRAMES: u32 = 400;

impl Peer {
    /// Writes all three into a folder.
    pub fn write_pictures(&mut self, folder: &Path) -> anyhow::Result<()> {
        std::fs::create_dir_all(folder).with_context(|| format!("cannot make {}", folder.display()))?;
        for (name, lux, shadows) in
            [("lit", SUN_LUX, true), ("unshadowed", SUN_LUX, false), ("ambient", 0.0, false)]
        {
            self.change_sun(|sun| (sun.illuminance, sun.shadow_maps_enabled) = (lux, shadows));
            self.settle();
            self.write_picture(folder.join(name).with_extension("png"))?;
        }
        self.change_sun(|sun| sun.illuminance = SUN_LUX);
        Ok(())
    }

    fn write_picture(&mut self, path: PathBuf) -> anyhow::Result<()> {
        // One of an earlier run would be taken for it.
        if path.exists() {
            std::fs::remove_file(&path)?;
        }
        let screenshot = Screenshot::image(self.target.clone());
        self.app.world_mut().spawn(screenshot).observe(save_to_disk(path.clone()));
        for _ in 0..MOST_FRAMES {
            self.app.update();
            if path.exists() {
                return Ok(());
            }
            std::thread::sleep(Duration::from_millis(5));
        }
        ensure!(path.exists(), "Bevy wrote no picture: {}", path.display());
        Ok(())
    }
}
