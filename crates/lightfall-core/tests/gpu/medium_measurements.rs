//! `lightfall bench --medium` and `lightfall extremes --medium`, and what they measure.

use crate::gpu;
use glam::UVec2;
use lightfall_lab::bench::{Plan, medium_table};
use lightfall_lab::extremes::{matter_cells, matter_table, measure_matter};

/// The measurements that the documents state, with few rays: the scenes and the bars are those of the
/// command.
#[test]
#[ignore = "needs a graphics adapter"]
fn matter_in_its_hardest_places_holds_the_error_that_it_is_asked_for() {
    let verdicts = measure_matter(gpu(), &matter_cells(96), |_| {}).unwrap();
    println!("{}", matter_table(&verdicts));
    assert!(verdicts.len() >= 25 && verdicts.iter().all(|verdict| verdict.lit > 10));
    assert!(verdicts.iter().all(|verdict| verdict.holds));
}

/// More nodes are more exact and slower, and a row that is known is not measured again.
#[test]
#[ignore = "needs a graphics adapter"]
fn a_quick_run_states_the_error_of_matter_against_its_run_time() {
    let plan = Plan {
        size: UVec2::new(64, 36),
        rays: 128,
        ..Plan::new(true)
    };
    let rows = plan.run_medium(gpu(), &[], |_| {}).unwrap();
    println!("{}", medium_table(&rows));
    assert_eq!(rows.len(), plan.medium_rows());
    for of_scene in rows.chunks(6) {
        let disks: Vec<&str> = of_scene.iter().map(|row| row.disk.as_str()).collect();
        let smooth = ["smooth"; 4];
        assert_eq!(disks[0], "thin");
        assert_eq!(disks[1..5], smooth);
        assert_eq!(disks[5], "living");
        assert_eq!(of_scene[0].time_over_thin(&rows), 1.0);
        let smooth = &of_scene[1..5];
        let jets = of_scene[0].scene == "jets";
        assert_eq!(
            smooth.iter().map(|row| row.nodes).collect::<Vec<_>>(),
            if jets { [4, 6, 9, 12] } else { [3, 4, 8, 12] }
        );
        assert_eq!(smooth.iter().filter(|row| row.own).count(), 1);
        for row in smooth {
            assert!(
                row.unfinished == 0 && row.not_finite == 0 && row.lit > 10,
                "{row:?}"
            );
            assert!(
                row.light_p50 <= row.light_p95 && row.light_p95 <= row.light_p99,
                "{row:?}"
            );
        }
        // The median of jets is that of f32 with the fewest nodes already.
        assert!(smooth[0].light_p95 > smooth[3].light_p95 && smooth[0].samples < smooth[3].samples);
    }
    let again = plan
        .run_medium(gpu(), &rows, |row| panic!("{row:?}"))
        .unwrap();
    assert_eq!(again.len(), rows.len());
}
