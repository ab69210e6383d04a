//! Which adapter is used if one is preferred.

use lightfall_core::gpu::{AdapterName, Gpu, adapters, chosen, named_by_environment, prefer};

#[test]
#[ignore = "needs a graphics adapter"]
fn a_preferred_adapter_is_used_if_it_exists_and_the_best_one_otherwise() {
    if named_by_environment().is_some() {
        return;
    }
    let best = Gpu::headless().unwrap().info;
    let without = chosen();
    assert_eq!((&without.name, without.place), (&None, None));
    // The last of the list, which is seldom the best. The preference belongs to the process, but
    // other tests of this program only ask for the device that they share.
    let last = adapters().pop().unwrap();
    prefer(Some(last.name.clone()));
    let (choice, opened) = (chosen(), Gpu::headless().unwrap().info);
    prefer(Some(AdapterName {
        name: "A card that was taken out".into(),
        backend: "vulkan".into(),
    }));
    let (choice_without, opened_without) = (chosen(), Gpu::headless().unwrap().info);
    // An adapter with the same name on another interface is another adapter.
    prefer(Some(AdapterName {
        backend: "noop".into(),
        ..last.name.clone()
    }));
    let choice_other = chosen();
    prefer(None);
    assert_eq!(choice.name.as_ref(), Some(&last.name.name));
    assert_eq!(choice.backends, wgpu::Backends::from(opened.backend));
    assert_eq!(AdapterName::of(&opened), last.name);
    assert_eq!((choice_without, choice_other), (without.clone(), without));
    assert_eq!(AdapterName::of(&opened_without), AdapterName::of(&best));
    // As `lightfall --list-gpus` prints it.
    let line = last.to_string();
    assert!(
        line.starts_with(&format!(
            "{} ({}, {}, ",
            last.name.name, last.kind, last.name.backend
        )),
        "{line}"
    );
}
