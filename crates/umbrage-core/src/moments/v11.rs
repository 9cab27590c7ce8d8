//! V11: what another program makes of three sets of depths. A table alone, since the shaders are tested against it too.
//!
//! The vectors give the weights and depths of the first set. Those of the others follow from what they print: the share
//! that is truly lit gives weights, and the column of the variance mean and mean square.

/// Depths of a texel, and what is asked of it.
pub struct Depths {
    /// Weight and depth of each.
    pub deltas: &'static [(f32, f32)],
    /// At some receivers.
    pub rows: [Row; 6],
}

/// A receiver.
pub struct Row {
    /// Its depth.
    pub receiver: f32,
    /// The share of the depths that do not lie before it.
    pub truly_lit: f32,
    /// Visibility by VSM, ESM, EVSM2, EVSM4, and MSM for 32 and for 16 bits.
    pub visibility: [f32; 6],
}

const fn row(receiver: f32, truly_lit: f32, visibility: [f32; 6]) -> Row {
    Row { receiver, truly_lit, visibility }
}

/// The sets of two, three and four depths.
pub const V11: [Depths; 3] = [
    Depths {
        deltas: &[(0.3, 0.25), (0.7, 0.75)],
        rows: [
            row(0.2, 1.0, [1.0, 1.0, 1.0, 1.0, 1.0, 1.0]),
            row(0.35, 0.7, [1.0, 1.0, 1.0, 1.0, 0.700003, 0.700777]),
            row(0.5, 0.7, [1.0, 1.0, 1.0, 0.806949, 0.700001, 0.700169]),
            row(0.6, 0.7, [1.0, 1.0, 1.0, 0.733274, 0.7, 0.700099]),
            row(0.8, 0.0, [0.567568, 0.012821, 0.000048, 0.000048, 0.000006, 0.001861]),
            row(0.97, 0.0, [0.277191, 0.0, 0.0, 0.0, 0.0, 0.000056]),
        ],
    },
    Depths {
        deltas: &[(0.2, 0.1), (0.3, 0.4), (0.5, 0.9)],
        rows: [
            row(0.2, 0.8, [1.0, 1.0, 1.0, 1.0, 1.0, 1.0]),
            row(0.35, 0.8, [1.0, 1.0, 1.0, 0.897228, 0.861664, 0.861669]),
            row(0.5, 0.5, [1.0, 1.0, 1.0, 0.799557, 0.719779, 0.719788]),
            row(0.6, 0.5, [0.999065, 1.0, 1.0, 0.780604, 0.675287, 0.675295]),
            row(0.8, 0.5, [0.707947, 1.0, 1.0, 0.771012, 0.622806, 0.622808]),
            row(0.97, 0.0, [0.425388, 0.001849, 0.000002, 0.000002, 0.265844, 0.265863]),
        ],
    },
    Depths {
        deltas: &[(0.1, 0.05), (0.25, 0.3), (0.3, 0.55), (0.35, 0.95)],
        rows: [
            row(0.2, 0.9, [1.0, 1.0, 1.0, 1.0, 1.0, 1.0]),
            row(0.35, 0.65, [1.0, 1.0, 1.0, 0.942377, 0.960983, 0.960974]),
            row(0.5, 0.65, [1.0, 1.0, 1.0, 0.874598, 0.784951, 0.784952]),
            row(0.6, 0.35, [0.994747, 1.0, 1.0, 0.860574, 0.702899, 0.702904]),
            row(0.8, 0.35, [0.659458, 1.0, 1.0, 0.853372, 0.592793, 0.592798]),
            row(0.97, 0.0, [0.38359, 0.070664, 0.008963, 0.008963, 0.30712, 0.307126]),
        ],
    },
];
