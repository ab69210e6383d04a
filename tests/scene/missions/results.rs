//! What is kept of missions, and which one comes next.

use lightfall::app::{MissionResult, MissionResults, first_choice, next_not_reached};
use lightfall_core::scene::mission::{self, MISSIONS, Mission, Quantity};
use std::fs;
use std::path::Path;

/// The missions of the list.
fn missions() -> Vec<Mission> {
    let missions = MISSIONS.iter();
    missions
        .map(|(name, text)| mission::load(name, text).unwrap())
        .collect()
}

fn result(mission: &str, reached: bool, lamps: usize, rapidity_used: f64) -> MissionResult {
    MissionResult {
        mission: mission.into(),
        reached,
        lamps,
        attempt: 1,
        own_time: 117.25,
        far_time: None,
        rapidity_used,
        par: Some((Quantity::RapidityUsed, rapidity_used)),
        peak_g: 9.5,
        peak_tide: 1e-13,
        lowest: 5.99,
        error: 3.5e-14,
        answer: None,
        is_right: None,
        time: "2026-03-01T09:05:00Z".into(),
        pupil: "Lovelace, \"Ada\"".into(),
    }
}

/// The rows of a file, without its header.
fn rows(file: &Path) -> Vec<String> {
    let text = fs::read_to_string(file).unwrap();
    text.lines().skip(1).map(str::to_owned).collect()
}

#[test]
fn results_are_kept_in_a_file_of_rows_that_is_read_again_and_the_best_one_has_the_most_lamps() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("new folder").join("results.csv");
    let mut results = MissionResults::load(Some(file.clone()));
    let rows = [
        result("graze", false, 0, 0.1),
        result("graze", true, 2, 1.2),
        result("graze", true, 3, 1.15),
        result("graze", true, 3, 1.1),
        result("sample", true, 3, 0.7),
    ];
    for row in &rows {
        results.add(row.clone()).unwrap();
        assert_eq!(MissionResult::read(&row.row()).as_ref(), Some(row));
    }
    let text = fs::read_to_string(&file).unwrap();
    assert_eq!(text.lines().count(), 6);
    assert!(
        text.starts_with("mission,outcome,lamps,attempt,own_time,"),
        "{text}"
    );
    let read = MissionResults::load(Some(file));
    assert_eq!(read.best("graze"), Some(&rows[3]));
    assert_eq!(read.best("penrose"), None);
    // More lamps, then less rapidity; and a failure is no better than anything.
    assert!(rows[2].is_better_than(&rows[1]) && rows[3].is_better_than(&rows[2]));
    assert!(!rows[3].is_better_than(&rows[3]) && !rows[0].is_better_than(&rows[1]));
}

/// The columns of earlier versions keep their places, and a name is no formula.
#[test]
fn the_last_cells_of_a_result_are_its_time_and_its_pupil() {
    let flown = MissionResult {
        pupil: "=1+1, Ada".into(),
        ..result("graze", true, 3, 1.0)
    };
    let row = flown.row();
    assert!(
        row.ends_with(",3.5e-14,,,2026-03-01T09:05:00Z,\"'=1+1, Ada\""),
        "{row}"
    );
    assert_eq!(MissionResult::read(&row).unwrap().row(), row);
    // A row of an earlier version has none of both.
    let old = MissionResult::read("sample,reached,3,1,1,1,1,,,1,1,2,1e-12,42,true").unwrap();
    assert_eq!((old.time.as_str(), old.pupil.as_str()), ("", ""));
    assert_eq!((old.answer, old.is_right), (Some(42.0), Some(true)));
}

/// A path that comes away has no highest point, and a table has no word for infinity.
#[test]
fn numbers_of_a_result_that_are_not_finite_are_empty_cells_and_the_row_is_read_again() {
    let missed = MissionResult {
        par: Some((Quantity::Apoapsis, f64::INFINITY)),
        peak_tide: f64::INFINITY,
        ..result("graze", false, 0, 0.5)
    };
    let row = missed.row();
    assert!(row.contains(",apoapsis,,9.5,,5.99,"), "{row}");
    let read = MissionResult::read(&row).unwrap();
    assert_eq!(read.row(), row);
    assert_eq!(
        read.par.map(|(quantity, _)| quantity),
        Some(Quantity::Apoapsis)
    );
}

/// Going back to the last goal goes on with the same attempt: its row is the better end of it, and of two
/// misses the later one.
#[test]
fn an_attempt_that_is_gone_on_with_has_one_row_and_keeps_its_better_end() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("results.csv");
    let mut results = MissionResults::load(Some(file.clone()));
    let rows = || rows(&file);
    let missed = result("graze", false, 0, 0.5);
    let (kept, written) = results.keep(None, missed.clone());
    assert_eq!((kept, written), (missed.clone(), Ok(())));
    // Of two misses the later one stays, whatever was spent.
    let again = result("graze", false, 0, 0.7);
    let (kept, _) = results.keep(Some(missed), again.clone());
    assert_eq!(kept, again);
    assert_eq!(rows(), [again.row()]);
    let reached = result("graze", true, 2, 1.2);
    let (kept, _) = results.keep(Some(again), reached.clone());
    assert_eq!(kept, reached);
    assert_eq!(rows(), [reached.row()]);
    // An answer may have been given since.
    let answered = MissionResult {
        answer: Some(42.0),
        is_right: Some(false),
        ..reached.clone()
    };
    results.correct_last(answered.clone()).unwrap();
    let (kept, _) = results.keep(Some(reached.clone()), result("graze", true, 1, 1.0));
    assert_eq!(kept, reached);
    assert_eq!(rows(), [answered.row()]);
    let better = result("graze", true, 3, 1.1);
    let (kept, _) = results.keep(Some(reached), better.clone());
    assert_eq!(kept, better);
    assert_eq!(rows(), [better.row()]);
    assert_eq!(results.best("graze"), Some(&better));
}

#[test]
fn the_nearest_miss_is_the_failed_attempt_with_the_most_of_its_par() {
    let mut results = MissionResults::default();
    for row in [
        result("longest", false, 0, 0.78),
        result("longest", false, 0, 0.98),
        result("longest", false, 0, 0.5),
        result("longest", true, 1, 1.2),
        result("graze", false, 0, 3.0),
    ] {
        results.add(row).unwrap();
    }
    let nearest = |quantity| {
        let nearest = results.nearest_miss("longest", quantity);
        nearest.and_then(|row| row.par).map(|(_, value)| value)
    };
    assert_eq!(nearest(Quantity::RapidityUsed), Some(0.98));
    assert_eq!(nearest(Quantity::LifeInside), None);
}

/// A table for a class has no digits of rounding.
#[test]
fn the_numbers_of_a_result_are_short_and_small_ones_have_an_exponent() {
    let row = MissionResult {
        own_time: 0.1 + 0.2,
        peak_tide: 5.0519e-13 * 1.000_000_000_001,
        ..result("graze", true, 3, 1.0 / 3.0)
    }
    .row();
    let cells: Vec<&str> = row.split(',').collect();
    assert_eq!(cells[4..7], ["0.3", "", "0.3333333333"], "{row}");
    assert_eq!(
        cells[9..13],
        ["9.5", "5.0519e-13", "5.99", "3.5e-14"],
        "{row}"
    );
}

#[test]
fn the_next_mission_is_the_first_one_after_this_that_was_not_reached_or_one_before_it() {
    let list = missions();
    let next = |name: &str, reached: &[&str]| {
        let next = next_not_reached(&list, name, |name| reached.contains(&name));
        next.map(|mission| mission.name.clone())
    };
    assert_eq!(next("two-burns", &[]).as_deref(), Some("weight"));
    assert_eq!(next("two-burns", &["weight"]).as_deref(), Some("gyroscope"));
    assert_eq!(next("longest", &["two-burns"]).as_deref(), Some("weight"));
    // A mission of one's own is in no list.
    assert_eq!(next("mine", &[]).as_deref(), Some("two-burns"));
    let others: Vec<&str> = MISSIONS.iter().map(|(name, _)| *name).skip(1).collect();
    assert_eq!(next("two-burns", &others), None);
}

#[test]
fn the_list_of_missions_begins_where_the_player_was_or_at_the_next_one_that_was_not_reached() {
    let list = missions();
    let choice = |flown, reached: &[&str]| {
        let place = first_choice(&list, flown, |name| reached.contains(&name));
        place.map(|place| list[place].name.as_str())
    };
    // At the start of the program, and after a mission that is not in the list.
    assert_eq!(choice(None, &[]), Some("two-burns"));
    assert_eq!(choice(None, &["two-burns"]), Some("weight"));
    assert_eq!(choice(Some(("mine", true)), &["two-burns"]), Some("weight"));
    // A mission that was not reached this time stays, though it was before.
    assert_eq!(choice(Some(("graze", false)), &[]), Some("graze"));
    assert_eq!(choice(Some(("graze", false)), &["graze"]), Some("graze"));
    assert_eq!(
        choice(Some(("graze", true)), &["graze", "ten-years"]),
        Some("sample")
    );
    let all: Vec<&str> = MISSIONS.iter().map(|(name, _)| *name).collect();
    assert_eq!(choice(None, &all), None);
    assert_eq!(choice(Some(("graze", true)), &all), Some("graze"));
}

#[test]
fn a_corrected_result_replaces_its_own_row_whatever_the_file_has_meanwhile() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("results.csv");
    let mut results = MissionResults::load(Some(file.clone()));
    let first = result("graze", true, 2, 1.2);
    results.add(first.clone()).unwrap();
    // Another window writes a row.
    let other = result("sample", true, 3, 0.7);
    let mut other_window = MissionResults::load(Some(file.clone()));
    other_window.add(other.clone()).unwrap();
    let answered = MissionResult {
        answer: Some(42.0),
        is_right: Some(false),
        ..first
    };
    results.correct_last(answered.clone()).unwrap();
    let lines = || rows(&file);
    assert_eq!(lines(), [answered.row(), other.row()]);
    // A file of an earlier version has fewer columns: its header becomes today's, and its rows stay.
    let old = "mission,outcome,lamps\nsample,reached,3,1,1,1,1,,,1,1,2,1e-12,\n";
    fs::write(&file, old).unwrap();
    results.correct_last(answered.clone()).unwrap();
    let text = fs::read_to_string(&file).unwrap();
    assert!(
        text.lines()
            .next()
            .unwrap()
            .ends_with(",answer,is_right,time,pupil"),
        "{text}"
    );
    assert_eq!(lines()[0], "sample,reached,3,1,1,1,1,,,1,1,2,1e-12,");
    assert_eq!(
        MissionResults::load(Some(file.clone()))
            .best("sample")
            .unwrap()
            .is_right,
        None
    );
    // A file that is gone is begun again, with its header.
    fs::remove_file(&file).unwrap();
    results.correct_last(answered.clone()).unwrap();
    assert_eq!(lines(), [answered.row()]);
}
