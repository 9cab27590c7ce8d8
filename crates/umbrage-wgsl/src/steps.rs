//! The compute steps that make moments and sums of the maps, before anything reads them.

use umbrage_core::{Moments, Msm};

use crate::binding::{Binding, BindingKind, Dimension, SampleType, Stages};
use crate::constants::lines;
use crate::format::{MomentFormat, TexelFormat};
use crate::key::{ShaderKey, StoredLayout};
use crate::link::{Recipe, link, moments_module};
use crate::texts::said;

/// A compute step that reads one texture and writes another.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Step {
    /// The step's text.
    pub text: String,
    /// Its entry point.
    pub entry_point: &'static str,
    /// What its group holds: the frame, the current view, what is read and what is written. A step may use less.
    pub bindings: [Binding; 4],
}

/// The steps that make blurred moments.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct MomentSteps {
    /// What a texel of moments is.
    pub format: MomentFormat,
    /// How many sizes the moments are kept in, each half of the one before.
    pub levels: u32,
    /// From the depths of a view to its moments, in workgroups of 8 × 8 texels.
    pub convert: Step,
    /// A Gaussian over rows, from the moments of a view to the scratch, in workgroups of 64 × 1.
    pub across: Step,
    /// The same over columns, from the scratch back.
    pub down: Step,
    /// From one size of a layer to the next smaller one, in workgroups of 8 × 8.
    pub halve: Step,
}

/// The steps that make summed-area tables of moments.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct SumSteps {
    /// What a texel of sums is.
    pub format: TexelFormat,
    /// From the depths of a view to the sums of its rows, in the scratch: a workgroup a row.
    pub rows: Step,
    /// From the scratch to the sums of columns: a workgroup a column.
    pub columns: Step,
}

const DEPTHS: (&str, SampleType, Dimension) = ("umbrage_depths", SampleType::Depth, Dimension::D2Array);

impl ShaderKey {
    /// The steps that make blurred moments; `None` for a filter that has none.
    pub fn moment_steps(&self) -> Option<MomentSteps> {
        let StoredLayout::Moments { format, levels } = self.stored?.layout else { return None };
        let stored = if format.rounds { "prefilter/stored_rounded" } else { "prefilter/stored_as_is" };
        let step = |module, entry_point, read: (_, _, _), written| {
            self.step(module, entry_point, &[("umbrage_stored", stored)], read, (written, format.format))
        };
        let of_layer = |name| (name, SampleType::Float, Dimension::D2);
        Some(MomentSteps {
            format,
            levels,
            convert: step("prefilter/convert", "convert", DEPTHS, "umbrage_converted"),
            across: step("prefilter/blur", "across", of_layer("umbrage_sharp"), "umbrage_blurred"),
            down: step("prefilter/blur", "down", of_layer("umbrage_sharp"), "umbrage_blurred"),
            halve: step("prefilter/halve", "halve", of_layer("umbrage_larger"), "umbrage_smaller"),
        })
    }

    /// The steps that make sums; `None` for a filter that has none.
    pub fn sum_steps(&self) -> Option<SumSteps> {
        let StoredLayout::Sums { format } = self.stored?.layout else { return None };
        let written = ("umbrage_summed", format);
        let rows = ("umbrage_summed_rows", SampleType::Uint, Dimension::D2);
        Some(SumSteps {
            format,
            rows: self.step("prefilter/sum", "rows", &[], DEPTHS, written),
            columns: self.step("prefilter/sum", "columns", &[], rows, written),
        })
    }

    fn step(
        &self,
        module: &'static str,
        entry_point: &'static str,
        choices: &[(&'static str, &'static str)],
        (read, sample, dimension): (&'static str, SampleType, Dimension),
        (written, format): (&'static str, TexelFormat),
    ) -> Step {
        let stages = Stages::Compute;
        let moments = self.stored.map_or("moments/vsm", |stored| stored.module);
        let of_moments = ["umbrage_moments_of", "umbrage_moments_none", "umbrage_moments_add"];
        let choices: Vec<_> =
            of_moments.map(|name| (name, moments)).into_iter().chain(choices.iter().copied()).collect();
        let constants = self.constants();
        let recipe =
            Recipe { roots: &[module], choices: &choices, constants: &constants, ..Recipe::default() };
        let (read, written) = (
            Binding { binding: 2, name: read, kind: BindingKind::Texture { sample, dimension }, stages },
            Binding { binding: 3, name: written, kind: BindingKind::StorageTexture { format }, stages },
        );
        Step {
            text: said(link(recipe)).replace("UMBRAGE_FORMAT", format.wgsl()),
            entry_point,
            bindings: [Binding::frame(stages), Binding::current_view(stages), read, written],
        }
    }
}

/// The constants and functions of one kind of moments: what `umbrage_core::Moments` does, once more in WGSL. They bind nothing.
///
/// * `umbrage_moments_of(depth, slope) -> vec4f`
/// * `umbrage_moments_none() -> vec4f`
/// * `umbrage_moments_add(sum, moments, weight) -> vec4f`
/// * `umbrage_moments_visibility(moments, depth, min_standard_deviation) -> f32`; the deviation is a share of the depth range
pub fn moments(moments: &Moments) -> String {
    moments_text(moments, moments_module(moments.kind()))
}

/// As [`moments`] of four powers, with `umbrage_moments_blocker(moments, depth) -> vec2f`: what share of the depths lies before a
/// receiver, and their mean.
pub fn msm_blocker(msm: &Msm) -> String {
    moments_text(&Moments::Msm(*msm), "moments/msm_blocker")
}

fn moments_text(moments: &Moments, module: &str) -> String {
    let constants = lines(&moments.numbers());
    said(link(Recipe { roots: &[module], constants: &constants, ..Recipe::default() }))
}
