//! The arguments of `lightfall bench`, `lightfall extremes` and `lightfall doctor`.

use super::args::SceneArgs;
use super::number::whole_number;
use super::size::size;
use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use glam::UVec2;
use lightfall_core::gpu::timing::Stage;
use lightfall_core::scene::{Method, presets};
use lightfall_core::words::Words;
use lightfall_lab::bench::{BenchScene, Plan, scenes};
use std::path::PathBuf;

/// The arguments of `lightfall bench`.
#[derive(Debug, Args)]
#[command(
    after_help = "Without --json, a Markdown table goes to standard output. --out also writes bench.csv, bench.json, bench.md \
                        and, for each scene, a plot SCENE.svg."
)]
pub struct BenchArgs {
    /// Scenes, by number or name, separated by commas; edge-on is preset 2 without spin,
    /// edge-on-spinning with it [default: all]
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = bench_scene)]
    pub scenes: Vec<BenchScene>,
    /// Methods, separated by commas: closed, mino, verlet, kerr-schild [default: all that can trace
    /// the scene]
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = method)]
    pub methods: Vec<Method>,
    /// Size of the picture whose rays are timed [default: 1920x1080, with --quick 160x90]
    #[arg(long, value_name = "WxH", value_parser = size)]
    pub size: Option<UVec2>,
    /// Entry point of the shader that is timed
    #[arg(long, value_parser = words::<Stage>(), default_value = Stage::Compute.word())]
    pub entry: Stage,
    /// Number of rays whose error is measured in each scene [default: 8192, with --quick 512]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = whole_number::<u32>(16, 1_000_000))]
    pub rays: Option<u32>,
    /// Measure few settings with few rays and small pictures. Without a graphics card all scenes
    /// take minutes; the command says how many after the first scene
    #[arg(long)]
    pub quick: bool,
    /// Also time whole frames, with each method at the scene's own setting
    #[arg(long)]
    pub frames: bool,
    /// Measure the time between emission and arrival instead: its error against the run time of
    /// tracing with 2, 3, 4 and 8 nodes, for closed and mino. --out then writes delay.csv,
    /// delay.json and delay.md
    #[arg(long, conflicts_with = "frames")]
    pub delay: bool,
    /// Time the light of a living disk instead: structure, limb darkening and the delay that they
    /// need, against a smooth disk, as a compute kernel. --out then writes light.csv, light.json
    /// and light.md
    #[arg(long, conflicts_with_all = ["frames", "delay", "entry", "rays"])]
    pub light: bool,
    /// Measure matter with depth instead: the error of its light with 3, 4, 8 and 12 nodes in a chunk
    /// against the run time, in four scenes, and the time of a smooth and of a living disk over that
    /// of a living sheet, all by mino. The size is 480x270 on a software renderer. --out then writes
    /// medium.csv, medium.json and medium.md
    #[arg(long, conflicts_with_all = ["frames", "delay", "light", "entry", "scenes", "methods"])]
    pub medium: bool,
    /// Measure whole pictures instead: the error of single rays, of means of 4, 16 and 64 frames
    /// and of refined edges, against the run time, with 1024 frames as the truth. Without --scenes
    /// that is edge-on, without --size at 960x540; a disk with structure is measured without it, too. --out then writes pictures.csv, pictures.json
    /// and pictures.md
    #[arg(long, conflicts_with_all = ["frames", "delay", "light", "medium", "entry", "methods", "rays", "quick"])]
    pub pictures: bool,
    /// Refine the article's methods instead: the errors of verlet and kerr-schild with ever shorter
    /// steps, larger budgets of steps and affine length, a farther radius of escape and a smaller
    /// least step. --out then writes refine.csv, refine.json and refine.md
    #[arg(long, conflicts_with_all = ["frames", "delay", "light", "medium", "pictures", "entry", "size"])]
    pub refine: bool,
    /// Measure the flight of a ship instead, on one core and without a graphics adapter: its errors
    /// after ten turns against the run time, for three tolerances of a step. --out then writes
    /// flight.csv, flight.json and flight.md
    #[arg(long, conflicts_with_all = ["frames", "delay", "light", "medium", "pictures", "refine", "entry", "size", "scenes", "methods", "rays", "quick"])]
    pub flight: bool,
    /// Where the report goes.
    #[command(flatten)]
    pub report: ReportArgs,
}

/// Where a report goes.
#[derive(Debug, Args)]
pub struct ReportArgs {
    /// Folder for the reports; it is created, and files of the same names are replaced
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Print JSON to standard output
    #[arg(long)]
    pub json: bool,
}

/// The arguments of `lightfall extremes`.
#[derive(Debug, Args)]
#[command(
    after_help = "Without --json, a Markdown table goes to standard output, or the text of hunt.txt. --out also writes \
                        extremes.csv, extremes.json and extremes.md, or the files that --delay, --medium and --hunt name. The exit status is \
                        1 if closed or mino does not hold a cell, if a hunt finds a ray beyond its tolerance that nothing \
                        explains, if --delay finds a hit whose delay is beyond 1e-3 rad and wrong for its place, or if a cell \
                        of --medium does not hold."
)]
pub struct ExtremesArgs {
    /// Methods, separated by commas: closed, mino, verlet, kerr-schild [default: all that can trace
    /// the scene]
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = method)]
    pub methods: Vec<Method>,
    /// Number of rays of each cell, at least 16
    #[arg(long, value_name = "N", default_value_t = 96, allow_negative_numbers = true, value_parser = whole_number::<u32>(16, 100_000))]
    pub rays: u32,
    /// Measure a grid of ordinary spins, radii and inclinations instead of the extremes
    #[arg(long, conflicts_with = "hunt")]
    pub grid: bool,
    /// Measure the time between emission and arrival instead, for closed and mino: the angle by
    /// which the disk's matter turns in its error, and why where that is over 1e-3 rad. --out then
    /// writes delays.csv, delays.json and delays.md
    #[arg(long, conflicts_with = "hunt")]
    pub delay: bool,
    /// Measure matter with depth instead: its light where it is hardest, against the f64 twin's.
    /// --out then writes matter.csv, matter.json and matter.md
    #[arg(long, conflicts_with_all = ["hunt", "grid", "delay", "methods"])]
    pub medium: bool,
    /// Instead of the matrix, trace N rays through random scenes by `auto`, 2000 rays a
    /// scene, and list the worst ray of each of the worst scenes. --out then writes hunt.csv, hunt.json and hunt.txt, whose
    /// lines trace the rays again
    #[arg(long, value_name = "N", conflicts_with_all = ["methods", "rays"], allow_negative_numbers = true, value_parser = whole_number::<u32>(1, 100_000_000))]
    pub hunt: Option<u32>,
    /// Seed of the hunt's random numbers: the same seed finds the same rays [default: 1]
    #[arg(long, value_name = "SEED", allow_negative_numbers = true, value_parser = whole_number::<u64>(0, u64::MAX))]
    pub seed: Option<u64>,
    /// Where the report goes.
    #[command(flatten)]
    pub report: ReportArgs,
}

/// The arguments of `lightfall doctor`.
#[derive(Debug, Args)]
#[command(
    after_help = "The self-test traces rays of presets 3 and 8 as pictures do and compares them with the f64 reference; \
                        docs/ACCURACY.md states the errors that they must stay below. The shaders of every pass are checked for all built-in presets and \
                        for the scene that the options name. Nothing on the machine is changed. The exit status is 1 \
                        if something that is needed does not work; the report says what it is and what to do."
)]
pub struct DoctorArgs {
    /// Print JSON to standard output
    #[arg(long)]
    pub json: bool,
    /// The scene whose shaders are checked beside those of the presets.
    #[command(flatten)]
    pub scene: SceneArgs,
}

impl BenchArgs {
    /// The plan that these arguments describe.
    #[must_use]
    pub fn plan(&self) -> Plan {
        let mut plan = Plan::new(self.quick);
        if !self.scenes.is_empty() {
            plan.scenes.clone_from(&self.scenes);
        }
        if !self.methods.is_empty() {
            plan.methods.clone_from(&self.methods);
        }
        if self.pictures {
            // The truth of a scene takes minutes without a graphics card.
            let opening = presets::PRESETS[presets::DEFAULT - 1].name;
            plan.scenes
                .retain(|scene| !self.scenes.is_empty() || scene.name == opening);
            plan.size = UVec2::new(960, 540);
        }
        plan.size = self.size.unwrap_or(plan.size);
        plan.rays = self.rays.map_or(plan.rays, |rays| rays as usize);
        plan.stage = if self.pictures {
            Stage::Fragment
        } else {
            self.entry
        };
        plan
    }
}

/// Reads a word of an enumeration. The help lists them with their meanings.
fn words<T: Words + Send + Sync>() -> impl TypedValueParser<Value = T> {
    let choices = T::CHOICES.iter();
    let values = choices.map(|choice| PossibleValue::new(choice.word).help(choice.meaning));
    PossibleValuesParser::new(values)
        .map(|word| T::from_word(&word).expect("only these words are accepted"))
}

/// Reads a scene's number or name.
fn bench_scene(text: &str) -> Result<BenchScene, String> {
    let name = presets::find(text).map_or(text, |preset| preset.name);
    let all = scenes();
    let names: Vec<&str> = all.iter().map(|scene| scene.name.as_str()).collect();
    let message = format!(
        "the scenes are {}; the number of a preset among them will do",
        names.join(", ")
    );
    all.into_iter()
        .find(|scene| scene.name == name)
        .ok_or(message)
}

/// Reads the name of a method that runs on the GPU.
fn method(text: &str) -> Result<Method, String> {
    let methods = Method::on_gpu();
    let found = methods.iter().find(|method| method.word() == text).copied();
    found.ok_or_else(|| {
        let allowed: Vec<_> = methods.into_iter().map(Method::word).collect();
        format!("the methods are {}", allowed.join(", "))
    })
}
