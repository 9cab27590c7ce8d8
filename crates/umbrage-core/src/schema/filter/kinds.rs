//! Which filters there are.

use crate::schema::Choice;

pub(super) const KINDS: &[Choice] = &[
    Choice {
        name: "hard",
        label: "hard",
        help: "One comparison with the nearest texel: the least work, and edges of steps.",
        source: "Williams 1978",
    },
    Choice {
        name: "bilinear",
        label: "bilinear",
        help: "Four comparisons, weighted bilinearly: one lookup of the sampler's.",
        source: "opengl-tutorial 16",
    },
    Choice {
        name: "pcf",
        label: "PCF",
        help: "The mean of a square of bilinear lookups, one texel apart.",
        source: "Reeves, Salesin & Cook 1987",
    },
    Choice {
        name: "optimised",
        label: "optimised PCF",
        help: "A bell-shaped kernel of bilinear lookups, in as few of them as can be.",
        source: "Castaño 2013",
    },
    Choice {
        name: "poisson",
        label: "Poisson disc",
        help: "A fixed table of points on a disc. ArrayVec of them make bands.",
        source: "opengl-tutorial 16",
    },
    Choice {
        name: "stratified",
        label: "stratified disc",
        help: "Points picked at random from the table, at each place others: noise instead of bands.",
        source: "opengl-tutorial 16",
    },
    Choice {
        name: "rotated",
        label: "rotated disc",
        help: "The table, at each place turned by another angle: finer noise.",
        source: "opengl-tutorial 16; Jimenez 2014",
    },
    Choice {
        name: "vogel",
        label: "Vogel disc",
        help: "A spiral of equal areas, of any number of points, at each place turned by another angle.",
        source: "Vogel 1979; Jimenez 2014",
    },
    Choice {
        name: "footprint",
        label: "footprint",
        help: "Comparisons all over what the pixel covers of the map. \
               The least error against the mean over a pixel, at the cost of PCF 5 × 5.",
        source: "",
    },
    Choice {
        name: "pcss",
        label: "PCSS",
        help: "Percentage-closer soft shadows: a disc as wide as the penumbra. It searches for blockers first.",
        source: "Fernando 2005",
    },
    Choice {
        name: "vsm",
        label: "VSM",
        help: "Mean and variance of depth, blurred before they are read. Light leaks where shadows overlap.",
        source: "Donnelly & Lauritzen 2006",
    },
    Choice {
        name: "savsm",
        label: "summed-area VSM",
        help: "Mean and variance of depth over boxes of any size, from a summed-area table.",
        source: "Lauritzen 2007",
    },
    Choice {
        name: "esm",
        label: "ESM",
        help: "The mean of an exponential of depth. Light leaks close behind a caster.",
        source: "Annen et al. 2008; Salvi 2008",
    },
    Choice {
        name: "evsm2",
        label: "EVSM, two numbers",
        help: "Mean and variance of an exponential of depth: fewer leaks than VSM.",
        source: "Lauritzen & McCool 2008",
    },
    Choice {
        name: "evsm4",
        label: "EVSM, four numbers",
        help: "Mean and variance of two exponentials of depth, one that grows and one that falls: \
               fewer leaks still, for twice the memory.",
        source: "Lauritzen & McCool 2008",
    },
    Choice {
        name: "msm",
        label: "MSM",
        help: "Four moments of depth, blurred before they are read.",
        source: "Peters & Klein 2015; Peters et al. 2017",
    },
    Choice {
        name: "mssm",
        label: "soft MSM",
        help: "Soft shadows from a summed-area table of four moments. The cost does not grow with the penumbra.",
        source: "Peters et al. 2017",
    },
];
