//! The order of uniforms in the layouts of the picture and of the kernels of stars. A fault of Mesa
//! 22.3's software renderer restricts it (gpu/bindings.rs).

use crate::variants::every_variant;
use lightfall_core::gpu::stars::StarKernel;
use lightfall_core::gpu::{Entry, Variant};
use lightfall_core::scene::Scene;
use naga::{AddressSpace, TypeInner};
use std::collections::{BTreeMap, HashMap};

/// The numbers of a shader's uniforms in group 0, and whether each is a table.
fn uniforms(source: &str) -> BTreeMap<u32, bool> {
    let module = naga::front::wgsl::parse_str(source).unwrap();
    let uniform = |(_, global): (_, &naga::GlobalVariable)| {
        let binding = global.binding.filter(|binding| binding.group == 0)?;
        let is_table = matches!(module.types[global.ty].inner, TypeInner::Array { .. });
        (global.space == AddressSpace::Uniform).then_some((binding.binding, is_table))
    };
    module.global_variables.iter().filter_map(uniform).collect()
}

/// Whether a uniform at this place of a layout, counted from one, overwrites memory in use unless it
/// is a table.
fn is_unsafe_place(place: usize) -> bool {
    place == 4 || place >= 8
}

fn assert_safe(name: &str, layout: &BTreeMap<u32, bool>) {
    for (at, (binding, is_table)) in layout.iter().enumerate() {
        let place = at + 1;
        assert!(
            *is_table || !is_unsafe_place(place),
            "{name}: uniform {place}, binding {binding}, holds numbers: {layout:?}"
        );
    }
}

/// Every shader of the picture has the same layout, which holds the uniforms of all of them.
#[test]
fn uniforms_of_the_picture_are_tables_where_old_lavapipe_writes_elsewhere() {
    let of_picture = |variant: &Variant| matches!(variant.entry, Entry::Picture | Entry::Refine);
    let declarations = |source: &String| -> Vec<String> {
        let lines = source.lines().filter(|line| line.contains("var<uniform>"));
        lines.map(String::from).collect()
    };
    // Thousands of variants declare the same uniforms.
    let different: HashMap<Vec<String>, String> = every_variant()
        .into_iter()
        .filter(of_picture)
        .map(|variant| variant.source())
        .map(|source| (declarations(&source), source))
        .collect();
    let layout: BTreeMap<u32, bool> = different
        .values()
        .flat_map(|source| uniforms(source))
        .collect();
    assert!(layout.len() >= 8, "{layout:?}");
    assert_safe("picture", &layout);
}

#[test]
fn uniforms_of_every_kernel_of_stars_are_tables_where_old_lavapipe_writes_elsewhere() {
    let scene = Scene::default();
    let all: BTreeMap<u32, bool> = StarKernel::ALL
        .into_iter()
        .flat_map(|kernel| uniforms(&kernel.source(&scene)))
        .collect();
    for kernel in StarKernel::ALL {
        let layout = kernel
            .reads()
            .iter()
            .filter_map(|binding| Some((*binding, *all.get(binding)?)))
            .collect();
        assert_safe(kernel.word(), &layout);
    }
}
