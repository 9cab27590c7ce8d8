//! Two roads to one answer: moments of depth by the shaders on the GPU, and in Rust. Both keep V11.

use bytemuck::{Pod, Zeroable};
use glam::{Vec2, Vec4};
use umbrage::shaders::{moments as moments_wgsl, msm_blocker as msm_blocker_wgsl};
use umbrage::{Esm, Evsm2, Evsm4, Exponent, Moments, Msm, Precision, Vsm};

use crate::common::device;

#[path = "../../../umbrage-core/src/moments/v11.rs"]
mod v11;

/// A texel's depths, by pairs of weight and depth, and a receiver before or behind them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
struct Question {
    deltas: [[f32; 2]; 4],
    slope: Vec2,
    receiver: f32,
    /// Where above 0, stored moments are rounded to one part in so many, as a format of integers does.
    steps: f32,
}

/// What a road makes of a question.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
struct Answer {
    stored: Vec4,
    visibility: f32,
    _pad: f32,
    share: f32,
    mean: f32,
}

const MAIN: &str = "
struct Question { deltas: array<vec2f, 4>, slope: vec2f, receiver: f32, steps: f32 }
struct Answer { stored: vec4f, visibility: f32, blocker: vec2f }
@group(0) @binding(0) var<storage, read> questions: array<Question>;
@group(0) @binding(1) var<storage, read_write> answers: array<Answer>;
@compute @workgroup_size(64) fn main(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&questions) { return; }
    let question = questions[id.x];
    var stored = umbrage_moments_none();
    for (var i = 0; i < 4; i++) {
        let delta = question.deltas[i];
        stored = umbrage_moments_add(stored, umbrage_moments_of(delta.y, question.slope), delta.x);
    }
    if question.steps > 0.0 { stored = round(stored * question.steps) / question.steps; }
    answers[id.x].stored = stored;
    answers[id.x].visibility = umbrage_moments_visibility(stored, question.receiver, MIN_STANDARD_DEVIATION);
    answers[id.x].blocker = ask_blocker(stored, question.receiver);
}
";

/// What the shaders make of the questions.
fn on_gpu(moments: &Moments, questions: &[Question]) -> Vec<Answer> {
    let (text, call) = match moments {
        Moments::Msm(msm) => (msm_blocker_wgsl(msm), "umbrage_moments_blocker(stored, receiver)"),
        Moments::Vsm(_) | Moments::Esm(_) | Moments::Evsm2(_) | Moments::Evsm4(_) => {
            (moments_wgsl(moments), "vec2f(0.0, receiver)")
        }
    };
    let min_standard_deviation = match *moments {
        Moments::Vsm(Vsm { min_variance, .. })
        | Moments::Evsm2(Evsm2 { min_variance, .. })
        | Moments::Evsm4(Evsm4 { min_variance, .. }) => min_variance.sqrt(),
        Moments::Esm(_) | Moments::Msm(_) => 0.0,
    };
    let ask = format!(
        "const MIN_STANDARD_DEVIATION: f32 = {min_standard_deviation:?};\nfn ask_blocker(stored: vec4f, receiver: f32) -> vec2f {{ return {call}; }}"
    );
    let (device, queue) = device(wgpu::Backends::VULKAN);
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some("moments"),
        source: wgpu::ShaderSource::Wgsl((text + MAIN + &ask).into()),
    });
    let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: Some("moments"),
        layout: None,
        module: &module,
        entry_point: Some("main"),
        compilation_options: Default::default(),
        cache: None,
    });
    let buffer = |size: usize, usage| {
        device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size: size as u64,
            usage,
            mapped_at_creation: false,
        })
    };
    let asked = bytemuck::cast_slice::<_, u8>(questions);
    let size = size_of::<Answer>() * questions.len();
    let input = buffer(asked.len(), wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST);
    let output = buffer(size, wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC);
    let back = buffer(size, wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST);
    queue.write_buffer(&input, 0, asked);
    let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: None,
        layout: &pipeline.get_bind_group_layout(0),
        entries: &[
            wgpu::BindGroupEntry { binding: 0, resource: input.as_entire_binding() },
            wgpu::BindGroupEntry { binding: 1, resource: output.as_entire_binding() },
        ],
    });
    let mut encoder = device.create_command_encoder(&Default::default());
    {
        let mut pass = encoder.begin_compute_pass(&Default::default());
        pass.set_pipeline(&pipeline);
        pass.set_bind_group(0, &group, &[]);
        pass.dispatch_workgroups((questions.len() as u32).div_ceil(64), 1, 1);
    }
    encoder.copy_buffer_to_buffer(&output, 0, &back, 0, size as u64);
    queue.submit([encoder.finish()]);
    back.map_async(wgpu::MapMode::Read, .., |result| result.expect("mapped"));
    device.poll(wgpu::PollType::wait_indefinitely()).expect("polled");
    let mapped = back.get_mapped_range(..).expect("mapped");
    bytemuck::cast_slice(&mapped).to_vec()
}

/// The moments that Rust stores.
fn stored(moments: &Moments, question: &Question) -> Vec4 {
    let sum = question.deltas.iter().fold(moments.none(), |sum, [weight, depth]| {
        moments.add(sum, moments.of_depth(*depth, question.slope), *weight)
    });
    if question.steps > 0.0 { (sum * question.steps).round() / question.steps } else { sum }
}

/// Visibility, and the share and mean depth of blockers, in Rust.
fn in_rust(moments: &Moments, stored: Vec4, receiver: f32) -> [f32; 3] {
    let blocker = match moments {
        Moments::Msm(msm) => msm.blocker(stored, receiver),
        Moments::Vsm(_) | Moments::Esm(_) | Moments::Evsm2(_) | Moments::Evsm4(_) => None,
    };
    let (share, mean) = blocker.unwrap_or((0.0, receiver));
    [moments.visibility(stored, receiver), share, mean]
}

fn exponent(value: f32, precision: Precision) -> Exponent {
    Exponent::new(value, precision).expect("a valid exponent")
}

/// In the order of V11's columns; `vectors.rs` of the core says where 42 comes from.
fn columns() -> [Moments; 6] {
    let positive = exponent(42.0, Precision::F32);
    [
        Moments::Vsm(Vsm { min_variance: 0.0, ..Vsm::default() }),
        Moments::Esm(Esm { exponent: 80.0 }),
        Moments::Evsm2(Evsm2 { exponent: positive, ..Evsm2::default() }),
        Moments::Evsm4(Evsm4 { positive, ..Evsm4::default() }),
        Moments::Msm(Msm::F32),
        Moments::Msm(Msm::UNORM16),
    ]
}

/// Up to four depths from a sequence, of a 64th so that two are equal or well apart, and a receiver that is near none.
fn spread(steps: f32) -> Vec<Question> {
    let share = |i: u32, step: f64| (f64::from(i) * step).fract() as f32;
    (1..20_000)
        .map(|i| {
            let count = 1 + i as usize % 4;
            let mut deltas = [[0.0; 2]; 4];
            for (k, delta) in deltas.iter_mut().take(count).enumerate() {
                let depth = (share(i, [0.8567, 0.7338, 0.6288, 0.5385][k]) * 64.0).round() / 64.0;
                *delta = [0.05 + share(i, [0.1831, 0.3723, 0.7077, 0.9127][k]), depth];
            }
            let total: f32 = deltas.iter().map(|[weight, _]| weight).sum();
            let deltas = deltas.map(|[weight, depth]| [weight / total, depth]);
            let receiver = ((share(i, 0.4376) * 64.0).floor() + 0.5) / 64.0;
            let slope = Vec2::new(share(i, 0.3141), share(i, 0.2718)) * 0.02 - 0.01;
            Question { deltas, slope, receiver, steps }
        })
        .collect()
}

#[test]
fn moments_on_the_gpu_are_v11() {
    for (column, moments) in columns().into_iter().enumerate() {
        let (mut questions, mut wanted) = (Vec::new(), Vec::new());
        for depths in v11::V11 {
            let mut deltas = [[0.0; 2]; 4];
            deltas.iter_mut().zip(depths.deltas).for_each(|(to, (weight, depth))| *to = [*weight, *depth]);
            for row in depths.rows {
                questions.push(Question { deltas, receiver: row.receiver, ..Question::default() });
                wanted.push((row.visibility[column], row.truly_lit));
            }
        }
        for ((question, answer), wanted) in questions.iter().zip(on_gpu(&moments, &questions)).zip(wanted) {
            let (got, (wanted, truly_lit)) = (answer.visibility, wanted);
            assert!((got - wanted).abs() < 1e-3, "{moments:?}, {question:?}: {got}, not {wanted}");
            assert!(got > truly_lit - 1e-3, "{moments:?}, {question:?}: {got} is no bound of {truly_lit}");
        }
    }
}

#[test]
fn moments_on_the_gpu_are_those_in_rust() {
    let half = exponent(5.54, Precision::F16);
    let others = [
        Moments::Vsm(Vsm { light_bleed_reduction: 0.2, ..Vsm::default() }),
        Moments::Evsm2(Evsm2 { exponent: half, min_variance: 1e-5, light_bleed_reduction: 0.1 }),
        Moments::Evsm4(Evsm4 {
            positive: half,
            negative: half,
            min_variance: 1e-5,
            light_bleed_reduction: 0.1,
        }),
        Moments::Msm(Msm { light_bleed_reduction: 0.3, ..Msm::F32 }),
    ];
    for moments in columns().into_iter().chain(others) {
        let steps = if moments == Moments::Msm(Msm::UNORM16) { 65535.0 } else { 0.0 };
        let questions = spread(steps);
        let mut largest = [0f32; 4];
        for (question, answer) in questions.iter().zip(on_gpu(&moments, &questions)) {
            let size = stored(&moments, question).abs().max(Vec4::ONE);
            let apart = (answer.stored - stored(&moments, question)).abs() / size;
            largest[0] = largest[0].max(apart.max_element());
            let got = [answer.visibility, answer.share, answer.mean];
            // Of the same texel, so that a rounding step of a stored integer is no difference.
            let rust = in_rust(&moments, answer.stored, question.receiver);
            for (largest, (got, rust)) in largest[1..].iter_mut().zip(got.into_iter().zip(rust)) {
                *largest = largest.max((got - rust).abs());
            }
        }
        println!("{moments:?}: {largest:?}");
        assert!(largest.iter().all(|difference| *difference < 1e-4), "{moments:?}: {largest:?}");
    }
}

#[test]
fn texels_that_no_depths_can_have_made_still_give_a_visibility_on_the_gpu() {
    // Weights and depths from these make moments of all sizes.
    let odd = [0.0, 1.0, 0.5, -1.0, 1e-30, 1e30, -1e30, 3.0];
    let questions: Vec<Question> = (0..32_768)
        .map(|i| {
            let [a, b, c, d, e] = [1, 8, 64, 512, 4096].map(|place| odd[i / place % 8]);
            let deltas = [[a, b], [c, d], [0.0; 2], [0.0; 2]];
            Question { deltas, slope: Vec2::new(e, a), receiver: e, steps: 0.0 }
        })
        .collect();
    for moments in columns() {
        for (question, answer) in questions.iter().zip(on_gpu(&moments, &questions)) {
            let is_share = |value: f32| (0.0..=1.00001).contains(&value);
            let is_blocker =
                !matches!(moments, Moments::Msm(_)) || is_share(answer.share) && is_share(answer.mean);
            assert!(is_share(answer.visibility) && is_blocker, "{moments:?}, {question:?}: {answer:?}");
        }
    }
}
