//! What a filter makes of one place of a map: the twin of `shaders/filter/` and of what stands below it.
//!
//! Kernels are summed texel by texel, and moments blurred around the place that is asked for: slow, and another road than
//! the shaders take.

use glam::{Mat2, Vec2, Vec3, Vec4, Vec4Swizzles as _};
use umbrage_core::kernel::{
    POISSON, gaussian, interleaved_gradient_noise, picked, poisson, spiral, two_squares, world_noise,
};
use umbrage_core::{
    CompareDepth, Disc, Filter, Moments, NoiseSource, Pcss, Prefilter, Rays, Settings, ShadowPlan,
    ShadowView, SoftMoments, SummedVariance,
};

use super::{Place, Query};
use crate::maps::MapTexels;
use crate::shadows::PICTURE_SIZE;

/// A place of a view's tile, and the map to read it from.
pub(super) struct Reader<'a> {
    pub plan: &'a ShadowPlan,
    pub settings: &'a Settings,
    pub maps: &'a MapTexels,
    pub view: &'a ShadowView,
    pub place: Place,
}

impl Reader<'_> {
    /// How much light the filter lets through.
    pub fn visibility(&self, asker: &Query) -> f32 {
        let noise = |noise: NoiseSource| match noise {
            NoiseSource::Screen => interleaved_gradient_noise(asker.pixel),
            NoiseSource::World => world_noise(asker.position),
            NoiseSource::None => 0.0,
        };
        let filter = &self.settings.filter;
        match filter {
            Filter::Hard {} => self.lit(self.place.texel.floor()),
            Filter::Bilinear {} => self.kernel(&[1.0]),
            Filter::Pcf { size } => self.kernel(&vec![1.0; *size as usize]),
            Filter::Optimised { size: 3 } => self.kernel(&[1.0, 2.0, 1.0]),
            Filter::Optimised { size: 5 } => self.kernel(&[1.0, 3.0, 4.0, 3.0, 1.0]),
            Filter::Optimised { .. } => self.kernel(&[1.0, 5.0, 12.0, 16.0, 12.0, 5.0, 1.0]),
            Filter::Poisson(disc) => self.disc(disc, &disc.table(), |_, point| point),
            Filter::Stratified(disc) => {
                let all: Vec<Vec2> = poisson(POISSON.len(), disc.centred).collect();
                let noise = noise(disc.noise);
                self.disc(disc, &disc.table(), |i, _| all[picked(i, noise)])
            }
            Filter::Rotated(disc) => {
                let turn = turn(noise(disc.noise));
                self.disc(disc, &disc.table(), |_, point| turn.rotate(point))
            }
            Filter::Vogel(disc) => {
                let turn = turn(noise(disc.noise));
                self.disc(disc, &spiral(disc.taps), |_, point| turn.rotate(point))
            }
            Filter::Footprint(of) => {
                let footprint = self.footprint(asker);
                let most = Vec2::splat(of.max_texels);
                let tap = |i: u32| {
                    let point = two_squares(i as usize);
                    self.tap((footprint * point.xy() + point.zw()).clamp(-most, most))
                };
                (0..of.taps).map(tap).sum::<f32>() / of.taps as f32
            }
            Filter::Pcss(pcss) => self.pcss(pcss, turn(noise(pcss.noise))),
            Filter::Vsm(_) | Filter::Esm(_) | Filter::Evsm2(_) | Filter::Evsm4(_) | Filter::Msm(_) => {
                match (filter.moments(self.view.depth_metres), filter.prefilter()) {
                    (Some(moments), Some(prefilter)) => {
                        moments.visibility(self.prefiltered(&moments, prefilter), self.depth())
                    }
                    _ => 1.0,
                }
            }
            Filter::Savsm(of) => self.summed(of),
            Filter::Mssm(of) => self.summed_soft(of),
        }
    }

    /// How far along the light the place's own depth lies.
    fn depth(&self) -> f32 {
        self.view.linear_depth(self.place.texel, self.place.reference)
    }

    fn side(&self) -> i64 {
        i64::from(self.view.tile.size)
    }

    /// Whether a texel, given by its upper left corner, leaves the receiver lit: 1 or 0.
    fn lit(&self, corner: Vec2) -> f32 {
        let inside = corner.clamp(Vec2::ZERO, Vec2::splat((self.side() - 1) as f32));
        let Place { texel, reference, gradient, .. } = self.place;
        let reference = (reference + gradient.dot(inside + 0.5 - texel)).min(1.0);
        f32::from(u8::from(reference <= self.stored(inside)))
    }

    fn stored(&self, corner: Vec2) -> f32 {
        self.maps.depth(self.view.tile, corner.x as i64, corner.y as i64)
    }

    /// Four comparisons around a place, weighted bilinearly.
    fn bilinear(&self, texel: Vec2) -> f32 {
        let inside = texel.clamp(Vec2::splat(0.5), Vec2::splat(self.side() as f32 - 0.5)) - 0.5;
        let (corner, share) = (inside.floor(), inside - inside.floor());
        let row = |y: f32| {
            let lit = |x: f32| self.lit(corner + Vec2::new(x, y));
            lit(0.0) + (lit(1.0) - lit(0.0)) * share.x
        };
        row(0.0) + (row(1.0) - row(0.0)) * share.y
    }

    /// Bilinear lookups, one texel apart, in rows and columns that weigh so.
    fn kernel(&self, weights: &[f32]) -> f32 {
        let middle = (weights.len() / 2) as f32;
        let mut sum = 0.0;
        for (y, row) in weights.iter().enumerate() {
            for (x, column) in weights.iter().enumerate() {
                let tap = Vec2::new(x as f32 - middle, y as f32 - middle);
                sum += row * column * self.bilinear(self.place.texel + tap);
            }
        }
        sum / weights.iter().sum::<f32>().powi(2)
    }

    /// A comparison beside the place, as the settings make it.
    fn tap(&self, offset: Vec2) -> f32 {
        match self.settings.compare_depth() {
            CompareDepth::Plane | CompareDepth::Facing => self.lit((self.place.texel + offset).floor()),
            CompareDepth::Own => self.bilinear(self.place.texel + offset),
        }
    }

    /// The mean of comparisons at points of a disc; `place` says where one of them lies here.
    fn disc(&self, disc: &Disc, points: &[Vec2], place: impl Fn(u32, Vec2) -> Vec2) -> f32 {
        let Vec2 { x, y } = self.place.texel_metres;
        let radius = Vec2::new(disc.radius_at(x), disc.radius_at(y));
        let rim = CORNERS.map(|corner| self.tap(corner * radius)).iter().sum::<f32>() / 4.0;
        if disc.early_out && (rim == 0.0 || rim == 1.0) {
            return rim;
        }
        let taps = (0..).zip(points).map(|(i, point)| self.tap(place(i, *point) * radius));
        taps.sum::<f32>() / points.len() as f32
    }

    /// How the place on the map changes from a pixel to the next, to the right and upward, texels.
    fn footprint(&self, Query { position, normal, .. }: &Query) -> Mat2 {
        let clip_from_world = self.plan.camera().clip_from_world();
        let [x, y, w] = [0, 1, 3].map(|i| clip_from_world.row(i));
        let point = position.extend(1.0);
        let depth = w.dot(point);
        let pixels = |row: Vec4, side: u32| {
            (row.truncate() - w.truncate() * (row.dot(point) / depth)) * (0.5 * side as f32 / depth)
        };
        let (right, up) = (pixels(x, PICTURE_SIZE[0]), pixels(y, PICTURE_SIZE[1]));
        let area = normal.dot(right.cross(up));
        let scale = if area.abs() > 1e-30 { 1.0 / area } else { 0.0 };
        let texel_basis = self.view.texel_basis_at(*position);
        let on_map = |step: Vec3| texel_basis.texels(step * scale);
        Mat2::from_cols(on_map(up.cross(*normal)), on_map(normal.cross(right)))
    }

    /// Radius of the disc on the map through which the light is seen past a blocker at an even depth, texels.
    fn penumbra(&self, max_texels: f32, blocker: f32) -> Vec2 {
        let size = self.settings.filter.light_size().unwrap_or_default();
        let size = self.plan.lights()[self.view.light].half_size(size);
        let way = (self.depth() - blocker).max(0.0) * self.view.depth_metres;
        let metres = match self.view.rays {
            Rays::Parallel => size * way,
            Rays::FromApex => {
                size * way / (self.view.near_metres + blocker * self.view.depth_metres).max(f32::MIN_POSITIVE)
            }
        };
        (metres / self.place.texel_metres).clamp(Vec2::splat(0.5), Vec2::splat(max_texels))
    }

    fn pcss(&self, pcss: &Pcss, turn: Vec2) -> f32 {
        let last = Vec2::splat((self.side() - 1) as f32);
        let search = self.penumbra(pcss.max_texels, 0.0);
        let blockers: Vec<f32> = spiral(pcss.blockers)
            .iter()
            .map(|point| (self.place.texel + turn.rotate(*point) * search).floor().clamp(Vec2::ZERO, last))
            .filter(|corner| self.lit(*corner) == 0.0)
            .map(|corner| self.view.linear_depth(corner + 0.5, self.stored(corner)))
            .collect();
        if blockers.is_empty() {
            return 1.0;
        }
        let radius = self.penumbra(pcss.max_texels, blockers.iter().sum::<f32>() / blockers.len() as f32);
        let taps = spiral(pcss.taps).into_iter().map(|point| self.tap(turn.rotate(point) * radius));
        taps.sum::<f32>() / pcss.taps as f32
    }

    /// The moments of one texel of the depth map; of the nearest inside, for places outside.
    fn moments_of(&self, moments: &Moments, x: i64, y: i64) -> Vec4 {
        let depth = |x: i64, y: i64| {
            let [x, y] = [x, y].map(|i| i.clamp(0, self.side() - 1));
            let corner = Vec2::new(x as f32, y as f32);
            self.view.linear_depth(corner + 0.5, self.stored(corner))
        };
        let here = depth(x, y);
        let lesser = |a: f32, b: f32| if a.abs() < b.abs() { a } else { b };
        let right = lesser(depth(x + 1, y) - here, here - depth(x - 1, y));
        let down = lesser(depth(x, y + 1) - here, here - depth(x, y - 1));
        moments.of_depth(here, Vec2::new(right, down))
    }

    /// The moments of the place: of blurred texels, weighted bilinearly.
    fn prefiltered(&self, moments: &Moments, prefilter: &Prefilter) -> Vec4 {
        let downsample = i64::from(prefilter.downsample);
        let side = self.side() / downsample;
        let sharp = |x: i64, y: i64| {
            let [x, y] = [x, y].map(|i| i.clamp(0, side - 1) * downsample);
            let weight = 1.0 / (downsample * downsample) as f32;
            let texels = (0..downsample * downsample)
                .map(|i| self.moments_of(moments, x + i % downsample, y + i / downsample));
            texels.fold(moments.none(), |sum, of| moments.add(sum, of, weight))
        };
        let weights = gaussian(prefilter.blur_texels);
        let reach = i64::from(prefilter.blur_texels);
        let weighed = |i: i64| weights[i.unsigned_abs() as usize];
        let blurred = |x: i64, y: i64| {
            (-reach..=reach).fold(moments.none(), |sum, j| {
                let row = (-reach..=reach)
                    .fold(moments.none(), |sum, i| moments.add(sum, sharp(x + i, y + j), weighed(i)));
                moments.add(sum, row, weighed(j))
            })
        };
        let inset = Vec2::splat(0.5 * downsample as f32);
        let inside = self.place.texel.clamp(inset, Vec2::splat(self.side() as f32) - inset);
        let place = inside / downsample as f32 - 0.5;
        let (corner, share) = (place.floor(), place - place.floor());
        let at = |x: i64, y: i64| {
            blurred((corner.x as i64 + x).min(side - 1), (corner.y as i64 + y).min(side - 1))
        };
        at(0, 0).lerp(at(1, 0), share.x).lerp(at(0, 1).lerp(at(1, 1), share.x), share.y)
    }

    /// The mean of moments over a box of such half sides; texels that it cuts count in part.
    fn over(&self, moments: &Moments, radius: Vec2) -> Vec4 {
        let size = Vec2::splat(self.side() as f32);
        let low = (self.place.texel - radius).clamp(Vec2::ZERO, size);
        let high = (self.place.texel + radius).clamp(Vec2::ZERO, size);
        let share = |i: i64, low: f32, high: f32| ((i + 1) as f32).min(high) - (i as f32).max(low);
        let mut sum = Vec4::ZERO;
        for y in low.y.floor() as i64..high.y.ceil() as i64 {
            for x in low.x.floor() as i64..high.x.ceil() as i64 {
                let weight = share(x, low.x, high.x) * share(y, low.y, high.y);
                let corner = Vec2::new(x as f32, y as f32);
                let depth = self.view.linear_depth(corner + 0.5, self.stored(corner));
                sum += moments.of_depth(depth, Vec2::ZERO) * weight;
            }
        }
        sum / ((high.x - low.x) * (high.y - low.y))
    }

    fn summed(&self, of: &SummedVariance) -> f32 {
        let Some(moments) = self.settings.filter.moments(self.view.depth_metres) else { return 1.0 };
        let Vec2 { x, y } = self.place.texel_metres;
        moments.visibility(self.over(&moments, Vec2::new(of.radius_at(x), of.radius_at(y))), self.depth())
    }

    fn summed_soft(&self, of: &SoftMoments) -> f32 {
        let Some(Moments::Msm(msm)) = self.settings.filter.moments(self.view.depth_metres) else {
            return 1.0;
        };
        let moments = Moments::Msm(msm);
        // Half a side of the square that has the area of the unit disc.
        let square = 0.5 * std::f32::consts::PI.sqrt();
        let search = self.penumbra(of.max_texels, 0.0) * square;
        let blockers = msm.blocker(self.over(&moments, search), self.depth());
        let blocker = blockers.map_or(self.depth(), |(_, depth)| depth);
        let radius = (self.penumbra(of.max_texels, blocker) * square).max(Vec2::splat(0.5));
        moments.visibility(self.over(&moments, radius), self.depth())
    }
}

/// Four points on the rim of the unit disc.
const CORNERS: [Vec2; 4] = {
    let half = std::f32::consts::FRAC_1_SQRT_2;
    [Vec2::new(half, half), Vec2::new(-half, half), Vec2::new(-half, -half), Vec2::new(half, -half)]
};

/// The turn of a place with this noise, as a unit vector.
fn turn(noise: f32) -> Vec2 {
    Vec2::from_angle(std::f32::consts::TAU * noise)
}
