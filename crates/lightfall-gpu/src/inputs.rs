//! The contents of the uniforms that a scene's shaders read, beside the scene's own numbers: a new
//! uniform is a row of [`bindings`], and an arm of [`Inputs::contents`].

use super::bindings::{
    self, Binding, ERROR_MAP, HOT_SPOT, JET, PAGE_THORNE, SPECTRUM, STARLIGHT, STRUCTURE,
    THICK_DISK, TILT, WAVE_HEIGHTS,
};
use super::error_map::ErrorMap;
use super::jet::GpuJet;
use super::kernel::{table_bytes, uniform};
use super::medium::GpuThickDisk;
use super::scene::{GpuHotSpot, GpuTilt};
use super::starlight::GpuStarlight;
use super::structure::{GpuStructure, wave_heights};
use lightfall_model::scene::{HotSpotKind, Scene, SkyMode, View};
use lightfall_optics::disk::Profile;
use lightfall_optics::spectrum;
use lightfall_optics::stars::Depth;
use std::sync::LazyLock;

/// The table of thermal colours, which is the same for all scenes.
static SPECTRUM_TABLE: LazyLock<Vec<u8>> = LazyLock::new(|| table_bytes(&spectrum::table()));

/// The values that determine the contents.
#[derive(Clone, Copy, Debug)]
pub struct Inputs<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// The most waves that each ring of the disk's structure is drawn with. `None`: as many as the
    /// scene says.
    pub max_waves: Option<u32>,
    /// The errors that the view `error` shows.
    pub errors: Option<&'a ErrorMap>,
}

impl<'a> Inputs<'a> {
    /// The inputs that follow from the scene alone.
    pub fn new(scene: &'a Scene) -> Self {
        Self {
            scene,
            max_waves: None,
            errors: None,
        }
    }

    /// The uniforms of the picture's layout that the scene uses, by their bindings.
    pub fn of_picture(&self) -> Vec<(u32, Vec<u8>)> {
        self.of_rows(|row| row.in_picture)
    }

    /// The uniforms that a shader's text declares, by their bindings.
    pub fn declared_in(&self, text: &str) -> Vec<(u32, Vec<u8>)> {
        self.of_rows(|row| row.is_declared_in(text))
    }

    fn of_rows(&self, wanted: impl Fn(&Binding) -> bool) -> Vec<(u32, Vec<u8>)> {
        let rows = bindings::ALL.iter().filter(|row| wanted(row));
        rows.filter_map(|row| Some((row.number, self.contents(row.number)?)))
            .collect()
    }

    /// The bytes of a uniform; `None` if the scene does not use it. The scene's own numbers and
    /// those of point stars change at other times and have writers of their own.
    fn contents(&self, binding: u32) -> Option<Vec<u8>> {
        let scene = self.scene;
        match binding {
            TILT if scene.disk.is_tilted() => Some(uniform(&GpuTilt::new(scene))),
            HOT_SPOT if scene.drawn_hot_spot() != HotSpotKind::None => {
                Some(uniform(&GpuHotSpot::new(scene)))
            }
            SPECTRUM => Some(SPECTRUM_TABLE.clone()),
            // Where stars are drawn in front of the picture, a uniform with their depth takes its place.
            STARLIGHT if scene.sky.mode == SkyMode::Picture => {
                Some(uniform(&GpuStarlight::new(scene, Depth::NO_POINTS)))
            }
            STRUCTURE => Some(uniform(&GpuStructure::new(scene, self.max_waves)?)),
            WAVE_HEIGHTS => Some(uniform(&wave_heights(scene, self.max_waves)?)),
            JET => Some(uniform(&GpuJet::new(scene)?)),
            THICK_DISK => Some(uniform(&GpuThickDisk::new(scene)?)),
            PAGE_THORNE => match Profile::new(scene) {
                Profile::PageThorne(disk) => Some(table_bytes(&disk.table())),
                Profile::Newtonian(_) => None,
            },
            ERROR_MAP if scene.view == View::Error => Some(self.errors?.bytes()),
            _ => None,
        }
    }
}
