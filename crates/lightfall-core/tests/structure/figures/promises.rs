//! What the program promises of its methods: the CSV files keep it, and the window's page about limits
//! says it.

use super::bench::Bench;
use super::document::{Figures, claim};
use super::render::bound;
use lightfall_core::reports::bench::scenes;
use lightfall_core::scene::Method;

/// The page of the panel that says what is exact.
pub fn of_limitations_page() -> Figures {
    let p99 = Method::Closed.backward_p99(0.5);
    Figures {
        tables: Vec::new(),
        claims: vec![
            claim(
                "In closed form (closed) the turn is below {} rad without spin",
                [bound(Method::Closed.backward_max(0.0))],
            ),
            claim(
                "With spin it is within {} rad for 99 of 100 rays",
                [bound(p99.expect("closed has a bound"))],
            ),
        ],
    }
}

/// The program tells these bounds to its users, and `lightfall doctor` tests a machine against them.
#[test]
fn every_method_keeps_in_the_csv_files_what_the_program_promises_of_it() {
    for file in ["h200/bench", "llvmpipe/bench"] {
        for row in Bench::read(file).rows.iter().filter(|row| row.own_setting) {
            let scenes = scenes();
            let scene = scenes.iter().find(|scene| scene.name == row.scene);
            let spin = scene.expect("the scene still exists").scene.hole.spin;
            let method = Method::from_word(&row.method).expect("the method still exists");
            let Some(p99) = method.backward_p99(spin) else {
                continue;
            };
            assert!(row.backward_p99 <= p99, "{file}: {row:?}");
            if method == Method::Closed {
                assert!(
                    row.backward_max <= method.backward_max(spin),
                    "{file}: {row:?}"
                );
            }
        }
    }
}
