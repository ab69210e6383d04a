//! The structs of Rust and of WGSL that mirror each other: same members, same order, same offsets.

use encase::ShaderType;
use lightfall_core::gpu::passages::GpuPassage;
use lightfall_core::gpu::rays::{GpuHit, GpuTrace};
use lightfall_core::gpu::stars::{
    GpuMeshPoint, GpuStarImage, GpuStarMesh, GpuStars, StarKernel, candidate_shader,
};
use lightfall_core::gpu::{
    Accumulation, Bloom, Developer, Development, Difference, GpuDisk, GpuHole, GpuHotSpot, GpuJet,
    GpuJetWaves, GpuObserver, GpuPatterns, GpuPicture, GpuQuality, GpuRing, GpuScene, GpuShadow,
    GpuSky, GpuStructure, Presentation, Print, Variant,
};
use lightfall_core::scene::{DiskStructure, HotSpotKind, Scene};
use naga::{Module, TypeInner};

fn parsed(source: String) -> Module {
    naga::front::wgsl::parse_str(&source).unwrap()
}

/// A member's name, its offset, and the name of its type if that is a struct.
type Member = (String, u64, Option<String>);

/// The members of a WGSL struct, and its size, as naga lays it out.
fn wgsl_struct(module: &Module, name: &str) -> (Vec<Member>, u64) {
    let found = module
        .types
        .iter()
        .find(|(_, declared)| declared.name.as_deref() == Some(name))
        .unwrap_or_else(|| panic!("the shader has no struct {name}"))
        .1;
    let TypeInner::Struct { members, span } = &found.inner else {
        panic!("{name} is not a struct")
    };
    let members = members
        .iter()
        .map(|member| {
            let kind = &module.types[member.ty];
            let is_struct = matches!(kind.inner, TypeInner::Struct { .. });
            (
                member.name.clone().unwrap(),
                u64::from(member.offset),
                kind.name.clone().filter(|_| is_struct),
            )
        })
        .collect();
    (members, u64::from(*span))
}

/// The fields of a Rust struct in their order, from its `{:#?}` text: the name, and the type if
/// that is a struct.
fn rust_fields(printed: &str) -> Vec<(String, Option<String>)> {
    printed
        .lines()
        .filter(|line| line.starts_with("    ") && !line.starts_with("     "))
        .filter_map(|line| line.trim().split_once(": "))
        .map(|(name, value)| (name.into(), value.strip_suffix(" {").map(String::from)))
        .collect()
}

/// Asserts that a Rust struct and the WGSL struct of this name are laid out alike. The structs
/// within them are compared by name: `GpuHole` of Rust is `Hole` of WGSL.
fn assert_same_layout<T: ShaderType + std::fmt::Debug>(
    module: &Module,
    value: &T,
    name: &str,
    offsets: &[u64],
) {
    let (members, size) = wgsl_struct(module, name);
    let fields = rust_fields(&format!("{value:#?}"));
    assert_eq!(fields.len(), offsets.len(), "{name}");
    let ours: Vec<Member> = fields
        .into_iter()
        .zip(offsets)
        .map(|((field, kind), offset)| {
            let kind = kind.map(|kind| kind.trim_start_matches("Gpu").to_string());
            (field, *offset, kind)
        })
        .collect();
    assert_eq!(ours, members, "{name}");
    assert_eq!(T::min_size().get(), size, "the size of {name}");
}

macro_rules! assert_same_layout {
    ($module:expr, $($rust:ident = $wgsl:literal),+ $(,)?) => {
        $(assert_same_layout(
            $module,
            &<$rust>::default(),
            $wgsl,
            &<$rust>::METADATA.extra.offsets,
        );)+
    };
}

#[test]
fn rust_and_wgsl_lay_out_the_scene_alike() {
    let module = parsed(Variant::rays(&Scene::default()).source());
    assert_same_layout!(
        &module,
        GpuScene = "Scene",
        GpuObserver = "Observer",
        GpuHole = "Hole",
        GpuShadow = "Shadow",
        GpuDisk = "Disk",
        GpuSky = "Sky",
        GpuQuality = "Quality",
        GpuPicture = "Picture",
    );
    let structs = wgsl_struct(&module, "Scene").0;
    assert_eq!(
        structs.iter().filter(|(.., kind)| kind.is_some()).count(),
        7,
        "every member of Scene is one of the structs above"
    );
}

#[test]
fn rust_and_wgsl_lay_out_the_records_of_rays_alike() {
    let module = parsed(Variant::rays(&Scene::default()).source());
    assert_same_layout!(&module, GpuHit = "Hit", GpuTrace = "Trace");
    let mut scene = Scene::default();
    scene.disk.thickness = 0.06;
    let module = parsed(Variant::passages(&scene, false).source());
    assert_same_layout!(&module, GpuPassage = "PassageRecord");
}

#[test]
fn rust_and_wgsl_lay_out_the_disks_structure_alike() {
    let mut scene = Scene::default();
    scene.disk.structure = DiskStructure::Turbulent;
    let module = parsed(Variant::picture(&scene).source());
    let structure = GpuStructure::new(&scene, None).unwrap();
    let offsets = GpuStructure::METADATA.extra.offsets;
    assert_same_layout(&module, &structure, "Structure", &offsets);
    assert_same_layout!(&module, GpuRing = "Ring");
}

#[test]
fn rust_and_wgsl_lay_out_jets_alike() {
    let mut scene = Scene::default();
    scene.jet.enabled = true;
    let module = parsed(Variant::picture(&scene).source());
    let jet = GpuJet::new(&scene).unwrap();
    let offsets = GpuJet::METADATA.extra.offsets;
    assert_same_layout(&module, &jet, "Jet", &offsets);
    assert_same_layout!(&module, GpuPatterns = "Patterns", GpuJetWaves = "JetWaves");
}

#[test]
fn rust_and_wgsl_lay_out_the_hot_spot_alike() {
    let mut scene = Scene::default();
    scene.hot_spot.kind = HotSpotKind::Rigid;
    let module = parsed(Variant::picture(&scene).source());
    assert_same_layout!(&module, GpuHotSpot = "HotSpot");
}

#[test]
fn rust_and_wgsl_lay_out_the_images_of_stars_alike() {
    let module = parsed(StarKernel::Solve.source(&Scene::default()));
    assert_same_layout!(&module, GpuStars = "Stars", GpuStarImage = "StarImage");
    let module = parsed(candidate_shader().source());
    assert_same_layout!(
        &module,
        GpuStarMesh = "StarMesh",
        GpuMeshPoint = "MeshPoint"
    );
}

#[test]
fn rust_and_wgsl_lay_out_the_presentation_alike() {
    let module = parsed(Presentation::shader().source());
    assert_same_layout!(&module, Presentation = "Presentation");
}

#[test]
fn rust_and_wgsl_lay_out_bloom_development_and_print_alike() {
    let module = parsed(Bloom::shader().source());
    assert_same_layout!(&module, Bloom = "Bloom");
    let module = parsed(Developer::all()[1].shader().source());
    assert_same_layout!(&module, Development = "Development");
    let module = parsed(Print::shader().source());
    assert_same_layout!(&module, Print = "Print");
}

#[test]
fn rust_and_wgsl_lay_out_the_mean_of_frames_alike() {
    let module = parsed(Accumulation::shader().source());
    assert_same_layout!(&module, Accumulation = "Accumulation");
}

#[test]
fn rust_and_wgsl_lay_out_the_difference_alike() {
    let module = parsed(Difference::shader().source());
    assert_same_layout!(&module, Difference = "Difference");
}
