//! The uniform of the disk's structure: its rings and waves, at the clock of a scene.

use super::scene::time_lead;
use super::shader::text::{add_f32, add_u32};
use encase::ShaderType;
use glam::{UVec4, Vec4};
use lightfall_model::scene::Scene;
use lightfall_optics::structure::{
    MAX_CHANGE, MAX_RINGS, MAX_WAVES, OCTAVES, Ring, Structure, Wave,
};
use std::f64::consts::TAU;

/// Maximum number of groups in a ring: a group is one wave of each octave.
const MAX_GROUPS: usize = MAX_WAVES / OCTAVES;

/// Mirror of `Structure` in shaders/disk/structure/waves.wgsl.
#[expect(missing_docs, reason = "the shader says what each field means")]
#[derive(ShaderType, Clone, Debug, PartialEq)]
pub struct GpuStructure {
    pub start: f32,
    pub rings_per_ln_r: f32,
    pub last_ring: f32,
    pub contrast: f32,
    pub group_count: u32,
    pub group_share: f32,
    pub amplitudes: Vec4,
    pub rings: [GpuRing; MAX_RINGS],
    pub groups: [GpuGroup; MAX_RINGS * MAX_GROUPS],
}

/// Mirror of `Group` in shaders/disk/structure/waves.wgsl.
#[expect(missing_docs, reason = "the shader says what each field means")]
#[derive(ShaderType, Clone, Copy, Debug, Default, PartialEq)]
pub struct GpuGroup {
    pub m: Vec4,
    pub k: Vec4,
}

/// Mirror of `Ring` in shaders/disk/structure/waves.wgsl.
#[expect(missing_docs, reason = "the shader says what each field means")]
#[derive(ShaderType, Clone, Copy, Debug, Default, PartialEq)]
pub struct GpuRing {
    pub centre: f32,
    pub lives_per_time: f32,
    pub life_over_turn: f32,
    pub lives: f32,
    pub phase_places: UVec4,
    pub number: f32,
    pub cycle: f32,
}

impl GpuStructure {
    /// The structure of the scene's disk at its clock, with at most `limit` waves in each ring;
    /// `None` for a smooth disk.
    ///
    /// The clock is that of the GPU's delays: `disk.time` less the time that they leave out.
    pub fn new(scene: &Scene, limit: Option<u32>) -> Option<Self> {
        let structure = Structure::new(scene, limit)?;
        let clock = scene.disk.time - time_lead(scene).unwrap_or(0.0);
        let mut rings = [GpuRing::default(); MAX_RINGS];
        let mut groups = [GpuGroup::default(); MAX_RINGS * MAX_GROUPS];
        for (i, ring) in structure.rings.iter().enumerate() {
            rings[i] = GpuRing::new(ring, clock);
            for (group, waves) in groups[i * MAX_GROUPS..].iter_mut().zip(&ring.groups) {
                *group = GpuGroup::new(waves);
            }
        }
        let (places, model) = (structure.places, structure.model);
        Some(Self {
            start: places.centre(0) as f32,
            rings_per_ln_r: (1.0 / places.width) as f32,
            last_ring: (places.count - 1) as f32,
            contrast: model.contrast as f32,
            group_count: model.octave as u32,
            group_share: (1.0 / model.octave as f64) as f32,
            amplitudes: Vec4::from_array(model.amplitudes().map(|a| a as f32)),
            rings,
            groups,
        })
    }

    /// Appends the constants that the shader shares.
    pub(super) fn add_constants(prelude: &mut String) {
        let [max_dx, max_dphi] = MAX_CHANGE;
        add_u32(prelude, "MAX_RINGS", MAX_RINGS as u32);
        add_u32(prelude, "MAX_GROUPS", MAX_GROUPS as u32);
        add_f32(prelude, "MAX_DX", max_dx);
        add_f32(prelude, "MAX_DPHI", max_dphi);
    }
}

/// The waves' numbers along the normal, in the order of [`GpuStructure::groups`]; `None` where no disk
/// with thickness has structure. Mirror of `wave_heights` in shaders/medium/structure/waves.wgsl.
pub(crate) fn wave_heights(
    scene: &Scene,
    limit: Option<u32>,
) -> Option<[Vec4; MAX_RINGS * MAX_GROUPS]> {
    let structure = Structure::new(scene, limit).filter(|_| scene.has_thick_disk())?;
    let mut heights = [Vec4::ZERO; MAX_RINGS * MAX_GROUPS];
    for (i, ring) in structure.rings.iter().enumerate() {
        for (height, waves) in heights[i * MAX_GROUPS..].iter_mut().zip(&ring.groups) {
            *height = Vec4::from_array(waves.map(|wave| wave.kappa as f32));
        }
    }
    Some(heights)
}

impl GpuGroup {
    fn new(waves: &[Wave; OCTAVES]) -> Self {
        Self {
            m: Vec4::from_array(waves.map(|wave| wave.m as f32)),
            k: Vec4::from_array(waves.map(|wave| wave.k as f32)),
        }
    }
}

impl GpuRing {
    fn new(ring: &Ring, clock: f64) -> Self {
        let (life, rest) = ring.lives(clock);
        // Without a cycle the shader only adds to the number of this life.
        let (first, number, cycle) = match ring.cycle {
            None => (life, 0.0, 0.0),
            Some(cycle) => (0, ring.number_in_cycle(life) as f32, cycle as f32),
        };
        Self {
            centre: ring.centre as f32,
            lives_per_time: (1.0 / ring.life) as f32,
            life_over_turn: (ring.life / TAU) as f32,
            lives: rest as f32,
            phase_places: UVec4::from_array(ring.phase_places(first)),
            number,
            cycle,
        }
    }
}
