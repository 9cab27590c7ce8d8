//! Which tile of the maps each view has. That depends on the lights' kinds and sizes and on a few settings, and not on the
//! camera: an allocation persists from frame to frame, while views are made anew.

mod arrange;

use arrayvec::ArrayVec;

use crate::error::SettingsError;
use crate::light::{FACES, Light, LightKind};
use crate::settings::{
    DepthFormat, LARGEST_TILE, LEAST_TILE, MAX_SPLITS, Settings, Storage, check_resolution,
};

use arrange::arrange;

/// The tiles of all views of some lights, in the order of a plan's views, and the texture that holds them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Allocation {
    storage: Storage,
    layout: MapLayout,
    /// The sides of each light's tiles.
    lights: Vec<TileGroup>,
    tiles: Vec<Tile>,
}

/// The sides of one light's tiles, texels, split by split or face by face.
type TileGroup = ArrayVec<u32, MAX_SPLITS>;

/// A square in the maps.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tile {
    /// The array layer that it lies in.
    pub layer: u32,
    /// Its left edge, texels.
    pub x: u32,
    /// Its upper edge, texels.
    pub y: u32,
    /// Its side, texels.
    pub size: u32,
}

/// The texture that holds the views' tiles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MapLayout {
    /// The width of each layer, texels.
    pub width: u32,
    /// The height of each layer, texels.
    pub height: u32,
    /// The number of array layers.
    pub layers: u32,
    /// The format of a texel.
    pub depth: DepthFormat,
}

impl Allocation {
    /// Gives the views of such lights their tiles.
    ///
    /// # Errors
    /// When a light's resolution is out of range.
    pub fn new(settings: &Settings, lights: &[Light]) -> Result<Self, SettingsError> {
        let groups: Result<_, _> = lights.iter().map(|light| light.tile_group(settings)).collect();
        Ok(Self::of_groups(settings, groups?))
    }

    /// Gives the views of one sun their tiles.
    pub fn of_sun(settings: &Settings) -> Self {
        Self::of_groups(settings, vec![settings.split_sides(settings.resolution, settings.splits)])
    }

    fn of_groups(settings: &Settings, lights: Vec<TileGroup>) -> Self {
        let sizes: Vec<u32> = lights.iter().flatten().copied().collect();
        let mut tiles = vec![Tile::default(); sizes.len()];
        let layout = arrange(settings.storage, settings.depth, &sizes, &mut tiles);
        Self { storage: settings.storage, layout, lights, tiles }
    }

    /// The texture that holds all tiles.
    pub fn layout(&self) -> MapLayout {
        self.layout
    }

    /// The tiles of all views, light by light.
    pub fn tiles(&self) -> &[Tile] {
        &self.tiles
    }

    /// The tiles of one light, split by split or face by face; none where there is no such light.
    pub fn tiles_of(&self, light: usize) -> &[Tile] {
        let Some(group) = self.lights.get(light) else { return &[] };
        let first = self.lights[..light].iter().map(|group| group.len()).sum::<usize>();
        &self.tiles[first..first + group.len()]
    }

    /// Whether such lights under such settings get just these tiles. It allocates nothing.
    pub fn serves(&self, settings: &Settings, lights: &[Light]) -> bool {
        let is_same = |(group, light): (&TileGroup, &Light)| light.tile_group(settings).as_ref() == Ok(group);
        self.storage == settings.storage
            && self.layout.depth == settings.depth
            && self.lights.len() == lights.len()
            && self.lights.iter().zip(lights).all(is_same)
    }
}

impl MapLayout {
    /// Whether the texture has room for all of another.
    pub fn holds(&self, other: &Self) -> bool {
        self.width >= other.width && self.height >= other.height && self.layers >= other.layers
    }

    /// The number of texels in all layers, unused ones included.
    pub fn texels(&self) -> u64 {
        u64::from(self.width) * u64::from(self.height) * u64::from(self.layers)
    }

    /// The number of bytes of all layers, unused texels included.
    pub fn bytes(&self) -> u64 {
        self.texels() * self.depth.bytes()
    }
}

impl Light {
    /// The number of shadow views that the light makes.
    pub fn views(&self, settings: &Settings) -> u32 {
        match self.kind() {
            LightKind::Directional { .. } => settings.splits,
            LightKind::Spot { .. } => settings.spot_splits,
            LightKind::Point { .. } => FACES,
        }
    }

    fn tile_group(&self, settings: &Settings) -> Result<TileGroup, SettingsError> {
        let size = self.resolution().unwrap_or(settings.resolution);
        let sides = match self.kind() {
            LightKind::Directional { .. } | LightKind::Spot { .. } => {
                settings.split_sides(size, self.views(settings))
            }
            LightKind::Point { .. } => std::iter::repeat_n(size, FACES as usize).collect(),
        };
        for side in &sides {
            check_resolution(*side)?;
            settings.filter.check_tile(*side)?;
        }
        Ok(sides)
    }
}

impl Settings {
    /// The sides of the tiles of so many splits, of which the first has so many texels: each has `resolution_falloff` times those
    /// of the one before, in whole steps of eight, which filters may halve thrice, and no fewer than a tile may have.
    fn split_sides(&self, first: u32, splits: u32) -> TileGroup {
        let falloff = f64::from(self.resolution_falloff);
        let side = |split: u32| match split {
            0 => first,
            _ => {
                let eighths = (f64::from(first) * falloff.powi(split as i32) / 8.0).round();
                eighths.clamp(f64::from(LEAST_TILE / 8), f64::from(LARGEST_TILE / 8)) as u32 * 8
            }
        };
        (0..splits).take(MAX_SPLITS).map(|split| if falloff == 1.0 { first } else { side(split) }).collect()
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::*;

    fn lights() -> [Light; 3] {
        let sun = Light::directional(Vec3::NEG_Y).expect("a sun");
        let spot = Light::spot(Vec3::Y, Vec3::NEG_Y, 0.5, 9.0).expect("a spot");
        let point = Light::point(Vec3::Y, 9.0).expect("a point light");
        [sun, spot.with_resolution(512), point.with_resolution(256)]
    }

    #[test]
    fn each_light_has_tiles_of_its_own_and_all_come_light_by_light() {
        let settings = Settings { splits: 3, spot_splits: 2, ..Settings::default() };
        let allocation = Allocation::new(&settings, &lights()).expect("an allocation");
        let of: Vec<_> = (0..4).map(|light| allocation.tiles_of(light)).collect();
        assert_eq!(of.iter().map(|tiles| tiles.len()).collect::<Vec<_>>(), [3, 2, 6, 0]);
        assert_eq!([of[0][0].size, of[1][0].size, of[2][0].size], [settings.resolution, 512, 256]);
        assert_eq!(of.concat(), allocation.tiles());
    }

    #[test]
    fn splits_of_falling_resolution_take_less_of_an_atlas() {
        let settings = Settings {
            resolution: 2048,
            resolution_falloff: 0.5,
            storage: Storage::Atlas,
            ..Settings::default()
        };
        let allocation = Allocation::of_sun(&settings);
        assert_eq!(
            allocation.tiles().iter().map(|tile| tile.size).collect::<Vec<_>>(),
            [2048, 1024, 512, 256]
        );
        let even = Allocation::of_sun(&Settings { resolution_falloff: 1.0, ..settings.clone() });
        assert!(2 * allocation.layout().bytes() <= even.layout().bytes(), "{:?}", allocation.layout());
        let steep = Settings { resolution: 20, resolution_falloff: 0.25, ..settings };
        assert_eq!(Allocation::of_sun(&steep).tiles().iter().map(|tile| tile.size).min(), Some(16));
    }

    #[test]
    fn an_allocation_serves_while_lights_and_sizes_are_the_same_wherever_the_lights_are() {
        let (settings, lights) = (Settings::default(), lights());
        let allocation = Allocation::new(&settings, &lights).expect("an allocation");
        let [sun, spot, point] = lights;
        let moved = Light::spot(Vec3::X, Vec3::NEG_Z, 1.0, 3.0).expect("a spot").with_resolution(512);
        let bad = spot.with_resolution(1);
        for (wanted, settings, lights) in [
            (true, settings.clone(), vec![sun, moved, point]),
            (true, Settings { lambda: 0.1, ..settings.clone() }, vec![sun, spot, point]),
            (false, settings.clone(), vec![spot, sun, point]),
            (false, settings.clone(), vec![sun, spot]),
            (false, settings.clone(), vec![sun, spot.with_resolution(256), point]),
            (false, settings.clone(), vec![sun, bad, point]),
            (false, Settings { resolution_falloff: 0.5, ..settings.clone() }, vec![sun, spot, point]),
            (false, Settings { splits: 3, ..settings.clone() }, vec![sun, spot, point]),
            (false, Settings { storage: Storage::Atlas, ..settings.clone() }, vec![sun, spot, point]),
            (false, Settings { depth: DepthFormat::F32, ..settings.clone() }, vec![sun, spot, point]),
        ] {
            assert_eq!(allocation.serves(&settings, &lights), wanted, "{settings:?}, {lights:?}");
        }
        assert!(Allocation::new(&settings, &[bad]).is_err(), "a tile of one texel");
        assert!(Allocation::of_sun(&settings).serves(&settings, &[sun]), "a sun's");
    }
}
