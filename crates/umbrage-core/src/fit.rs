//! What a view's map is fitted to.
//!
//! A fit answers with the [`Region`] of light space that the map must hold, and with a [`CasterPolicy`]; each has a file
//! of its own in `fit/`. What follows, from the region to the matrix, is the same for all.

mod cutter;
mod light_extent;
pub(crate) mod outline;
mod scene;
mod stable;
mod view;
mod visible_receivers;
mod world;

use crate::casters::CasterPolicy;
use crate::light_frustum::LightFrustum;
use crate::receivers::{Receivers, ViewInput};
use crate::region::Region;
use crate::schema::values::Choice;

use light_extent::Depths;
use outline::Outline;

/// What a view's map is fitted to. A tighter fit has finer texels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum Fit {
    /// The map is fitted to the part of the slice that has something in it ("scene-dependent", Ferko 2010 §3.2).
    Scene,
    /// The map is fitted to the whole slice ("scene-independent", Ferko 2010 §3.2).
    View,
    /// The map is fitted to a sphere around the slice, moved by whole texels; for a spot, to its whole cone. Edges hold
    /// still under any motion of the camera.
    Stable,
    /// The map of a sun is fitted to what the camera's depth shows of the slice (sample distribution shadow maps, Lauritzen et al.
    /// 2011): a compute pass chooses it within the region that is planned, in [`ShadowView::samples`](crate::ShadowView::samples).
    /// It grows at once, and shrinks late and by steps, so that edges hold still for a while. Spots and point lights are fitted as
    /// by [`Fit::Scene`].
    Sample,
    /// The map of a sun is fitted to the box of the whole world, or to [`LightBox`](crate::LightBox) where the settings have one;
    /// that of a spot to its whole cone. It does not depend on the camera: the plain shadow map (Williams 1978), which need not
    /// be drawn again while the world and its lights stand.
    World,
}

/// The fits, as the schema lists them.
pub(crate) const FITS: &[Choice] = &[
    Choice {
        name: "scene",
        label: "scene",
        help: "The part of the slice that has something in it: the finest texels.",
        source: "Ferko 2010, §3.2, scene-dependent",
    },
    Choice {
        name: "view",
        label: "view",
        help: "The whole slice.",
        source: "Ferko 2010, §3.2, scene-independent",
    },
    Choice {
        name: "stable",
        label: "stable",
        help: "A sphere around the slice, moved by whole texels; for a spot, its whole cone. \
               Edges hold still while the camera moves, and texels are coarser.",
        source: "Valient 2008",
    },
    Choice {
        name: "sample",
        label: "sample",
        help: "What the camera's depth shows of the slice, found by a compute pass: finer texels than of the scene, \
               where much of it is hidden. Needs the camera's depth before shadows are drawn; for suns.",
        source: "Lauritzen et al. 2011",
    },
    Choice {
        name: "world",
        label: "world",
        help: "The box of the whole world, or the `light_box` that is given; for a spot, its whole cone. \
               It is drawn once while nothing moves, and in a large world its texels are huge. One split is enough.",
        source: "Williams 1978; Ferko 2010, listing 4.4; opengl-tutorial 16",
    },
];

impl Fit {
    /// The region that a view's map must hold, and which casters are drawn into it. `outline` is room to work in.
    pub(crate) fn region<'a>(
        self,
        input: &ViewInput<'_>,
        receivers: &'a Receivers,
        outline: &'a mut Outline,
    ) -> (Region<'a>, CasterPolicy) {
        match (&input.light_frustum, self) {
            (LightFrustum::FromApex(pyramid), Self::Stable | Self::World) => {
                light_extent::region(input, pyramid, receivers, Depths::OfLight)
            }
            // Faces must meet, and of a cone that nobody sees nothing else is known.
            (LightFrustum::FromApex(pyramid), Self::Scene | Self::View | Self::Sample)
                if pyramid.is_face || receivers.lit_slice.is_empty() =>
            {
                light_extent::region(input, pyramid, receivers, Depths::OfReceivers)
            }
            (LightFrustum::Parallel(_), Self::Stable) => stable::region(input, receivers),
            (LightFrustum::Parallel(_), Self::World) => world::region(input, receivers),
            (LightFrustum::Parallel(_), Self::Sample) => scene::region_in_steps(input, receivers, outline),
            (_, Self::Scene | Self::Sample) => scene::region(input, receivers, outline),
            (_, Self::View) => view::region(input, &receivers.lit_slice, &receivers.body, outline),
        }
    }
}
