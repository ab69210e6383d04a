//! What `--gpu` means on machines with many adapters.

use lightfall_core::gpu::requested_place;
use wgpu::{AdapterInfo, Backend, DeviceType};

fn adapter(name: &str, backend: Backend, bus: &str) -> AdapterInfo {
    AdapterInfo {
        name: name.into(),
        vendor: 0,
        device: 0,
        device_type: DeviceType::DiscreteGpu,
        device_pci_bus_id: bus.into(),
        driver: String::new(),
        driver_info: String::new(),
        backend,
        subgroup_min_size: 32,
        subgroup_max_size: 32,
        transient_saves_memory: false,
    }
}

/// A machine with two equal cards, and a third one whose name begins as theirs do and that has two
/// interfaces.
fn machine() -> Vec<AdapterInfo> {
    use Backend::{Dx12, Vulkan};
    vec![
        adapter("ACME RX 6800 XT", Vulkan, "0000:21:00.0"),
        adapter("ACME RX 6800", Vulkan, "0000:01:00.0"),
        adapter("ACME RX 6800", Vulkan, "0001:c1:00.0"),
        adapter("Software", Vulkan, ""),
        adapter("ACME RX 6800 XT", Dx12, "0000:21:00.0"),
    ]
}

#[test]
fn two_digits_mean_the_place_in_the_list_and_more_of_them_a_part_of_a_name() {
    let all = machine();
    for place in 0..all.len() {
        assert_eq!(requested_place(&place.to_string(), &all), Ok(place));
    }
    assert_eq!(requested_place("680", &all), Err(vec![0, 1, 2, 4]));
    // Digits of names, but numbers that no adapter has.
    for number in ["6", "8", "68", "00006"] {
        assert_eq!(requested_place(number, &all), Err(vec![]), "{number}");
    }
}

#[test]
fn equal_cards_are_told_apart_by_their_bus_ids_in_every_spelling() {
    let all = machine();
    for (bus, place) in [
        ("0000:01:00.0", 1),
        ("0001:c1:00.0", 2),
        ("01:00.0", 1),
        // As nvidia-smi prints it.
        ("00000001:C1:00.0", 2),
        ("1:0.0", 1),
        // One card through two interfaces.
        ("21:00.0", 0),
    ] {
        assert_eq!(requested_place(bus, &all), Ok(place), "{bus}");
    }
    for bus in ["0002:c1:00.0", "01:00.1", "0:0.0"] {
        assert_eq!(requested_place(bus, &all), Err(vec![]), "{bus}");
    }
}

#[test]
fn a_name_means_one_card_or_is_refused_with_all_that_it_could_mean() {
    let mut all = machine();
    assert_eq!(requested_place("soft", &all), Ok(3));
    assert_eq!(requested_place(" 6800 xt ", &all), Ok(0));
    // The whole name of two cards, which is a part of another card's.
    assert_eq!(requested_place("acme rx 6800", &all), Err(vec![1, 2]));
    assert_eq!(requested_place("acme", &all), Err(vec![0, 1, 2, 4]));
    for broken in [
        "zzz",
        "1:2:3:4.5",
        "::.",
        "01:00",
        ".",
        "Ⅷ:0.0",
        "99999999999999999999999",
    ] {
        assert_eq!(requested_place(broken, &all), Err(vec![]), "{broken}");
    }
    // Nothing tells two programs of one name apart but their numbers.
    all.push(adapter("Software", Backend::Vulkan, ""));
    assert_eq!(requested_place("software", &all), Err(vec![3, 5]));
    assert_eq!(requested_place("5", &all), Ok(5));
    // A card that an interface lists twice.
    all.push(all[0].clone());
    assert_eq!(requested_place("6800 xt", &all), Ok(0));
}
