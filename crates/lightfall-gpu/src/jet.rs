//! The numbers of jets: their uniform, and the nodes at which their light is asked for.

use super::scene::time_lead;
use super::shader::text::{add_constant, add_f32, add_u32};
use encase::ShaderType;
use glam::{Vec2, Vec4};
use lightfall_model::geometry::quadrature::gauss_legendre;
use lightfall_model::scene::Scene;
use lightfall_optics::medium::jet::{
    AXIS, Jet, KINDS, KNOTS, Knots, SHEATH_KNOTS, STRANDS, TRAVEL, WAVES, Wave,
};
use lightfall_optics::photometry::DISK_HDR_SCALE;
use lightfall_optics::synchrotron;
use std::f64::consts::TAU;

/// Rows of the table of travel times, which have two entries, and of the waves.
const TRAVEL_ROWS: usize = TRAVEL / 2;
const WAVE_ROWS: usize = WAVES / 4;

/// Mirror of `Jet` in shaders/medium/jet.wgsl. Smooth jets have room for patterns, because a buffer keeps its
/// size.
#[expect(missing_docs, reason = "the shader says what each field means")]
#[derive(ShaderType, Clone, Debug, PartialEq)]
pub struct GpuJet {
    pub kappa: f32,
    pub inverse_width: f32,
    pub sheath: f32,
    pub inverse_sheath_width: f32,
    pub spine: f32,
    pub inverse_spine_width2: f32,
    pub rim: f32,
    pub speed: f32,
    pub rise: f32,
    pub rest: f32,
    pub base: f32,
    pub length: f32,
    pub fade: f32,
    pub radius: f32,
    pub decay: f32,
    pub swirl: f32,
    pub colour: f32,
    pub cooling: f32,
    pub heating: f32,
    pub brightness: f32,
    pub colours: [Vec4; synchrotron::TABLE_LEN],
    pub patterns: GpuPatterns,
}

/// Mirror of `JetWaves` in shaders/medium/jet/knots.wgsl.
#[expect(missing_docs, reason = "the shader says what each field means")]
#[derive(ShaderType, Clone, Copy, Debug, Default, PartialEq)]
pub struct GpuJetWaves {
    pub frequency: Vec4,
    pub about: Vec4,
    pub along: Vec4,
    pub across: Vec4,
    pub phases_above: Vec4,
    pub phases_below: Vec4,
    pub amplitude: Vec4,
}

/// Mirror of `Patterns` in shaders/medium/jet/knots.wgsl.
#[expect(missing_docs, reason = "the shader says what each field means")]
#[derive(ShaderType, Clone, Debug, Default, PartialEq)]
pub struct GpuPatterns {
    pub start: f32,
    pub per_ln_r: f32,
    pub axis: f32,
    pub strands: f32,
    pub knots: f32,
    pub sheath_knots: f32,
    pub travel: [Vec4; TRAVEL_ROWS],
    pub waves: [GpuJetWaves; WAVE_ROWS],
}

/// Places of the table of colours for each doubling of the frequency.
fn colours_per_octave() -> f64 {
    let [low, high] = synchrotron::TABLE_RANGE;
    (synchrotron::TABLE_LEN - 1) as f64 / (high / low).log2()
}

impl GpuJet {
    /// The numbers of the scene's jets; `None` if it has none.
    pub fn new(scene: &Scene) -> Option<Self> {
        let jet = Jet::of(scene)?;
        let shape = jet.shape;
        let [lowest, _] = synchrotron::TABLE_RANGE;
        let table = synchrotron::table();
        Some(Self {
            kappa: shape.kappa as f32,
            inverse_width: (1.0 / shape.width) as f32,
            sheath: shape.sheath[0] as f32,
            inverse_sheath_width: (1.0 / shape.sheath[1]) as f32,
            spine: shape.spine[0] as f32,
            inverse_spine_width2: shape.spine[1].powi(-2) as f32,
            rim: (0.5 * shape.rim) as f32,
            speed: shape.speed as f32,
            rise: shape.rise as f32,
            rest: jet.rest() as f32,
            base: shape.base as f32,
            length: shape.length as f32,
            fade: (shape.fade * shape.length) as f32,
            radius: jet.radius(1.0) as f32,
            decay: shape.decay as f32,
            swirl: shape.swirl as f32,
            colour: (colours_per_octave() * (jet.frequency(1.0, 1.0) / lowest).log2()) as f32,
            cooling: (colours_per_octave() * shape.cooling) as f32,
            heating: shape.heating as f32,
            brightness: (DISK_HDR_SCALE * scene.jet.brightness) as f32,
            colours: std::array::from_fn(|i| Vec4::from_array(table[i])),
            patterns: GpuPatterns::new(scene).unwrap_or_default(),
        })
    }
}

impl GpuPatterns {
    /// The patterns of the scene's jets at its clock; `None` for smooth ones.
    ///
    /// The clock is that of the GPU's delays: `disk.time` less the time that they leave out.
    pub fn new(scene: &Scene) -> Option<Self> {
        let knots = Knots::of(scene)?;
        let clock = scene.disk.time - time_lead(scene).unwrap_or(0.0);
        let travel = |i: usize| {
            let [time, turn] = knots.travel.entries[i];
            Vec2::new(time as f32, (turn / TAU) as f32)
        };
        let row = |i: usize| {
            let (from, to) = (travel(2 * i), travel(2 * i + 1));
            Vec4::new(from.x, from.y, to.x, to.y)
        };
        Some(Self {
            start: knots.travel.start as f32,
            per_ln_r: (1.0 / knots.travel.spacing) as f32,
            axis: AXIS as f32,
            strands: (STRANDS * knots.spread) as f32,
            knots: (KNOTS * knots.spread) as f32,
            sheath_knots: (SHEATH_KNOTS * knots.spread) as f32,
            travel: std::array::from_fn(row),
            waves: std::array::from_fn(|i| {
                let waves: [Wave; 4] = std::array::from_fn(|lane| knots.waves[4 * i + lane]);
                GpuJetWaves::new(&waves, clock)
            }),
        })
    }
}

impl GpuJetWaves {
    fn new(waves: &[Wave; 4], clock: f64) -> Self {
        let lanes = |number: &dyn Fn(&Wave) -> f64| {
            let [x, y, z, w] = waves.each_ref().map(|wave| number(wave) as f32);
            Vec4::new(x, y, z, w)
        };
        let phases = |side: usize| {
            lanes(&|wave| {
                let turns = (wave.phases[side] + wave.frequency * clock) / TAU;
                turns - turns.round()
            })
        };
        Self {
            frequency: lanes(&|wave| wave.frequency / TAU),
            about: lanes(&|wave| wave.about),
            along: lanes(&|wave| wave.along / TAU),
            across: lanes(&|wave| wave.across / TAU),
            phases_above: phases(0),
            phases_below: phases(1),
            amplitude: lanes(&|wave| wave.amplitude),
        }
    }
}

/// The nodes of each of the four pieces of a jet that a ray passes, for a largest error of the light.
///
/// Measured against f64 in six scenes, from the side and along the axis: 95 of 100 pixels with light
/// have an error below 6e-2 with four nodes, 5e-3 with six, and 1e-3 with nine.
pub(super) fn jet_nodes(max_error: f64) -> u32 {
    match max_error {
        error if error >= 0.07 => 4,
        error if error >= 0.012 => 6,
        error if error >= 0.001 => 9,
        _ => 12,
    }
}

/// Appends the constants that the shaders share.
pub(super) fn add_constants(prelude: &mut String, nodes: u32, knots: bool) {
    let pairs: Vec<_> = gauss_legendre(nodes as usize)
        .into_iter()
        .map(|(place, weight)| format!("vec2<f32>({:?}, {:?})", place as f32, weight as f32))
        .collect();
    let kind = format!("array<vec2<f32>, {nodes}>");
    add_u32(prelude, "JET_NODE_COUNT", nodes);
    add_constant(
        prelude,
        "JET_NODES",
        &kind,
        format!("{kind}({})", pairs.join(", ")),
    );
    add_u32(prelude, "JET_COLOURS", synchrotron::TABLE_LEN as u32);
    add_f32(prelude, "JET_COLOURS_PER_OCTAVE", colours_per_octave());
    add_f32(
        prelude,
        "JET_FALL_BEYOND_COLOURS",
        synchrotron::FALL_BEYOND_TABLE,
    );
    if knots {
        add_u32(prelude, "JET_TRAVEL_ROWS", TRAVEL_ROWS as u32);
        add_u32(prelude, "JET_WAVE_ROWS", WAVE_ROWS as u32);
        // Rows of strands come first, then those of knots.
        add_u32(prelude, "JET_STRAND_ROWS", KINDS[0] as u32 / 4);
    }
}
