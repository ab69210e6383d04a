//! A variant's choices among files that give the same name.

use super::link::Choice;
use super::{Entry, Tracer, Variant};
use crate::stars::StarKernel;
use lightfall_model::scene::{HotSpotKind, Projection, SkyMode, View};

impl Variant {
    /// The files that it chooses, whether its entry needs them or not.
    pub(super) fn choices(self) -> Vec<Choice> {
        let mut files = vec![
            self.entry_file().to_owned(),
            self.neighbours_file().to_owned(),
        ];
        files.extend(self.method_files());
        files.extend(self.disk_files());
        if self.has_medium() {
            files.extend(self.medium_files().into_iter().map(str::to_owned));
        }
        files.extend(self.view_files());
        files.push(if self.effects.lensing {
            "stars/closed.wgsl".into()
        } else {
            "stars/straight.wgsl".into()
        });
        let mut choices: Vec<_> = files.into_iter().map(Choice::of).collect();
        choices.extend(self.sky_files());
        choices.extend(self.sheet_files());
        choices.push(projection_file(self.projection));
        choices.push(Choice::of(if self.on_sides {
            "stars/sides/cube.wgsl"
        } else {
            "stars/sides/picture.wgsl"
        }));
        choices
    }

    /// The file that gives the entry point, where several do.
    fn entry_file(self) -> &'static str {
        match self.entry {
            Entry::Timed => "timed.wgsl",
            Entry::TimedLight => "timed_light.wgsl",
            _ if self.antialias => "antialias/geodesic.wgsl",
            _ => "geodesic.wgsl",
        }
    }

    /// The file that gives `trace`, and those that give its delays.
    fn method_files(self) -> [String; 3] {
        let tracer = self.tracer.word();
        let delay = if self.delay_nodes > 0 {
            "delay"
        } else {
            "delay/none"
        };
        let way = if self.throat {
            "delay/closed_kerr_throat.wgsl"
        } else {
            "delay/closed_kerr_radial.wgsl"
        };
        [file("method", tracer), file(delay, tracer), way.into()]
    }

    /// The file that gives `differences`, which measure a footprint. Only the entries of pictures
    /// have neighbours.
    fn neighbours_file(self) -> &'static str {
        let moves = (self.structure || self.knots) && self.entry != Entry::TimedLight;
        let compared =
            moves || self.reference_star || self.sky.is_map() || self.sky == SkyMode::Grid;
        match self.entry {
            Entry::Refine => "neighbours/lanes.wgsl",
            Entry::Picture if compared => "neighbours/pixels.wgsl",
            Entry::TimedLight if self.has_medium() && (self.structure || self.knots) => {
                "neighbours/fixed.wgsl"
            }
            _ => "neighbours/none.wgsl",
        }
    }

    /// The files of the disk's crossings and light.
    fn disk_files(self) -> Vec<String> {
        if !self.disk {
            return vec!["disk/none.wgsl".into()];
        }
        let structure: &[&str] = match (self.structure, self.entry) {
            (false, _) => &["disk/structure/none.wgsl"],
            (true, Entry::TimedLight) => &[
                "disk/structure/fixed_footprint.wgsl",
                "disk/structure/waves.wgsl",
            ],
            (true, _) => &["disk/structure/footprint.wgsl", "disk/structure/waves.wgsl"],
        };
        let hot_spot = match self.hot_spot {
            HotSpotKind::None => "disk/hot_spot/none.wgsl",
            HotSpotKind::Rigid | HotSpotKind::Sheared => "disk/hot_spot/spot.wgsl",
        };
        let behind = if self.medium_nodes > 0 {
            "stars/behind/matter.wgsl"
        } else {
            "stars/behind/sheet.wgsl"
        };
        let shines = self.entry != Entry::Star(StarKernel::Dim) && self.view.needs_light();
        let emission = if shines {
            "medium/emission/thermal.wgsl"
        } else {
            "medium/emission/none.wgsl"
        };
        let own = [
            behind,
            emission,
            "disk.wgsl",
            "disk/cover.wgsl",
            "disk/emission.wgsl",
            hot_spot,
        ];
        let named = [
            file("disk", self.disk_model.word()),
            file("disk/limb", self.limb.word()),
            file("medium/source", self.limb.word()),
        ];
        let own = own.iter().chain(structure);
        let own = own.copied().map(str::to_owned);
        own.chain(named).collect()
    }

    /// The files of matter with depth: what there is in a step of a ray, its structure, and the
    /// footprints of rays.
    fn medium_files(self) -> Vec<&'static str> {
        let (thick, jet) = (self.medium_nodes > 0, self.jet_nodes > 0);
        let matter = match (thick, jet, self.disk) {
            (true, true, _) => "medium/matter/disk_and_jet.wgsl",
            (true, false, _) => "medium/matter/disk.wgsl",
            (false, _, true) => "medium/matter/sheet_and_jet.wgsl",
            (false, _, false) => "medium/matter/jet.wgsl",
        };
        let differential = if self.structure || self.knots {
            "medium/structure/differential.wgsl"
        } else {
            "medium/structure/no_neighbours.wgsl"
        };
        let knots = if self.knots {
            "medium/jet/knots.wgsl"
        } else {
            "medium/jet/smooth.wgsl"
        };
        let [disk, sheet] = if self.structure {
            ["medium/structure/waves.wgsl", "medium/sheet/footprint.wgsl"]
        } else {
            ["medium/structure/none.wgsl", "medium/sheet/smooth.wgsl"]
        };
        let single = matches!(self.entry, Entry::Passages { .. });
        let chunks = if self.view == View::LightError || single {
            "medium/chunks/divided.wgsl"
        } else {
            "medium/chunks/whole.wgsl"
        };
        let [neighbours, means] = if single {
            ["medium/neighbours/given.wgsl", "medium/means/sums.wgsl"]
        } else {
            ["medium/neighbours/compared.wgsl", "medium/means/none.wgsl"]
        };
        vec![
            matter,
            differential,
            knots,
            disk,
            sheet,
            chunks,
            neighbours,
            means,
        ]
    }

    /// The files of a disk without thickness among jets. In layers, a file between it and the matter
    /// keeps what each crossing adds.
    fn sheet_files(self) -> Vec<Choice> {
        let sheet = Choice::of("medium/sheet.wgsl");
        match (self.layers, self.disk && self.medium_nodes == 0) {
            (false, _) => vec![sheet],
            (true, true) => vec![
                Choice::of("layers/sheet.wgsl"),
                sheet.renaming("add_sheet", "add_whole_sheet"),
            ],
            (true, false) => vec![Choice::of("layers/no_sheet.wgsl")],
        }
    }

    /// The files that give `sky_light` and `point_light`. Behind a tilted disk, a file between the
    /// sky and its background turns directions from the disk's frame.
    fn sky_files(self) -> Vec<Choice> {
        let background = match self.sky {
            SkyMode::Off => {
                return vec![Choice::of("sky/none.wgsl"), Choice::of("stars/none.wgsl")];
            }
            mode => Choice::of(file("sky", mode.word())),
        };
        let mut choices = vec![Choice::of("sky.wgsl")];
        let sums = Choice::of("stars/sums.wgsl");
        match (self.star_points, self.layers) {
            (true, false) => choices.push(sums),
            (true, true) => {
                choices.push(Choice::of("layers/point_light.wgsl"));
                choices.push(sums.renaming("point_light", "light_of_all_points"));
            }
            (false, _) => choices.push(Choice::of("stars/none.wgsl")),
        }
        choices.push(Choice::of(if self.reference_star {
            "sky/reference_star.wgsl"
        } else {
            "sky/no_reference_star.wgsl"
        }));
        if self.turned_sky {
            choices.push(Choice::of("sky/tilted.wgsl"));
            choices.push(background.renaming("sky_background", "background_in_hole_frame"));
        } else {
            choices.push(background);
        }
        choices
    }

    /// The files that colour a ray. A view that traces rays gives `fn light_along(photon: Photon)
    /// -> vec4<f32>`, and `view/traced.wgsl` calls it. Any other gives `fn light_at(place:
    /// vec2<f32>) -> vec4<f32>`, where `place` is in pixels from the upper left corner. Both return
    /// linear sRGB before exposure, and 1, or less in the shadow, where bloom must add nothing. For
    /// layers, the last number is their share of the ray.
    fn view_files(self) -> Vec<String> {
        let view = match self.view {
            View::Unfinished => View::Colour,
            view => view,
        };
        let file = match (self.has_medium(), view.shows_matter()) {
            (true, _) if self.layers => "layers/medium.wgsl".into(),
            _ if self.layers => "layers/colour.wgsl".into(),
            (true, _) => file("medium", view.word()),
            (false, true) => "view/no_matter.wgsl".into(),
            (false, false) => file("view", view.word()),
        };
        let mut files = vec![file];
        if view.properties().traces {
            files.push("view/traced.wgsl".into());
        }
        files
    }
}

impl Tracer {
    /// The name of its file below shaders/method.
    fn word(self) -> &'static str {
        match self {
            Self::Method(method) => method.word(),
            Self::ClosedKerr => "closed-kerr",
            Self::Straight => "straight",
        }
    }
}

/// The file that takes a pixel to a direction and back.
pub(crate) fn projection_file(projection: Projection) -> Choice {
    Choice::of(file("projection", projection.of_picture().word()))
}

/// The file of a word in a folder below shaders/.
fn file(folder: &str, word: &str) -> String {
    format!("{folder}/{}.wgsl", word.replace('-', "_"))
}
