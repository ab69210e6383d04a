//! Rust's structs against WGSL's: the same members, in the same order, at the same offsets.

use encase::ShaderType;
use lightfall_core::gpu::rays::{GpuHit, GpuTrace};
use lightfall_core::gpu::{GpuScene, Variant};
use lightfall_core::scene::Scene;

/// Names and offsets of a WGSL struct's members, and its size, as naga lays it out.
fn wgsl(name: &str) -> (Vec<(String, u64)>, u64) {
    let module = naga::front::wgsl::parse_str(&Variant::rays(&Scene::default()).source()).unwrap();
    let found = module
        .types
        .iter()
        .find(|(_, declared)| declared.name.as_deref() == Some(name))
        .unwrap()
        .1;
    let naga::TypeInner::Struct { members, span } = &found.inner else {
        panic!("{name} is no struct")
    };
    let members = members
        .iter()
        .map(|member| (member.name.clone().unwrap(), u64::from(member.offset)))
        .collect();
    (members, u64::from(*span))
}

/// Names of a struct's fields in their order, from the way Rust prints it.
fn field_names(printed: &str) -> Vec<String> {
    let top = printed
        .lines()
        .filter(|line| line.starts_with("    ") && !line.starts_with("     "));
    top.filter_map(|line| line.trim().split_once(':'))
        .map(|(name, _)| name.into())
        .collect()
}

macro_rules! assert_same_layout {
    ($rust:ty, $wgsl:literal) => {
        let (members, size) = wgsl($wgsl);
        let names = field_names(&format!("{:#?}", <$rust>::default()));
        let offsets = <$rust>::METADATA.extra.offsets;
        assert_eq!(names.len(), offsets.len());
        let ours: Vec<(String, u64)> = names.into_iter().zip(offsets).collect();
        assert_eq!(ours, members, $wgsl);
        assert_eq!(<$rust>::min_size().get(), size, $wgsl);
    };
}

#[test]
fn rust_and_wgsl_lay_out_their_structs_alike() {
    assert_same_layout!(GpuScene, "Scene");
    assert_same_layout!(GpuHit, "Hit");
    assert_same_layout!(GpuTrace, "Trace");
}
