//! The words of the enumerations, and the property tables of their variants.

use lightfall_core::scene::{
    AccuracySetting, DiskModel, Kind, Method, ObserverKind, SkyMode, View, field,
};
use lightfall_core::words::Words;
use std::collections::BTreeSet;
use std::fmt::Debug;

/// Checks one enumeration against serde, which knows the variants on its own.
fn check<T>(all: &[T], key: &str)
where
    T: Words + Debug + PartialEq + serde::Serialize + serde::de::DeserializeOwned,
{
    let words: Vec<&str> = T::CHOICES.iter().map(|choice| choice.word).collect();
    assert_eq!(all.len(), words.len());
    for (variant, word) in all.iter().zip(&words) {
        assert_eq!(variant.word(), *word);
        assert_eq!(T::from_word(word).as_ref(), Some(variant));
        assert_eq!(serde_json::to_value(variant).unwrap(), *word);
        assert_eq!(
            serde_json::from_value::<T>((*word).into()).unwrap(),
            *variant
        );
    }
    let distinct: BTreeSet<_> = words.iter().collect();
    assert_eq!(
        distinct.len(),
        words.len(),
        "{key}: two variants share a word"
    );
    assert_eq!(field(key).unwrap().kind, Kind::Choice(T::CHOICES));
    assert_eq!(T::from_word("no such word"), None);
    // Serde's own complaint lists every variant that it knows.
    let complaint = serde_json::from_value::<T>("?".into())
        .unwrap_err()
        .to_string();
    let known: Vec<&str> = complaint.split('`').skip(3).step_by(2).collect();
    assert_eq!(known, words, "{complaint}");
}

#[test]
fn every_variant_has_one_word_that_serde_fields_and_messages_share() {
    check(&Method::ALL, "method");
    check(&View::ALL, "view");
    check(&ObserverKind::ALL, "observer.kind");
    check(&DiskModel::ALL, "disk.model");
    check(&SkyMode::ALL, "sky.mode");
}

#[test]
fn the_methods_on_the_gpu_begin_with_those_that_answer_every_ray() {
    assert_eq!(
        Method::on_gpu()
            .into_iter()
            .map(Method::word)
            .collect::<Vec<_>>(),
        ["closed", "mino", "verlet", "kerr-schild"]
    );
}

#[test]
fn auto_means_a_method_that_can_trace_the_hole_from_anywhere() {
    let method = Method::Auto.resolved();
    let properties = method.properties();
    assert_ne!(method, Method::Auto);
    assert!(
        properties.spins && properties.inside && properties.on_gpu && properties.answers_every_ray
    );
}

#[test]
fn auto_is_held_to_the_bars_of_the_method_that_it_means() {
    for chi in [0.0, 0.9, -0.9999] {
        let meant = Method::Auto.resolved();
        assert_eq!(Method::Auto.backward_max(chi), meant.backward_max(chi));
        assert_eq!(Method::Auto.backward_p99(chi), meant.backward_p99(chi));
    }
}

#[test]
fn a_method_has_a_bar_that_its_setting_can_reach() {
    for method in Method::on_gpu() {
        for chi in [0.0, 0.9, -0.9999] {
            let max = method.backward_max(chi);
            assert!(max > 0.0 && max < 0.01, "{}, {chi}", method.word());
            if method.properties().setting == AccuracySetting::None {
                let p99 = method.backward_p99(chi).unwrap();
                assert!(p99 <= max, "{}, {chi}", method.word());
            }
        }
    }
}

#[test]
fn every_sky_follows_another_and_the_last_leads_back_to_the_first() {
    let mut seen = vec![SkyMode::default()];
    while seen.len() < SkyMode::ALL.len() {
        seen.push(seen[seen.len() - 1].next());
    }
    assert_eq!(seen, SkyMode::ALL);
    assert_eq!(seen[seen.len() - 1].next(), SkyMode::default());
}
