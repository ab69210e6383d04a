//! docs/ACCURACY.md.

use super::bench::{Bench, InScene};
use super::document::{Claim, Figures, claim};
use super::measured::measured;
use super::refine;
use super::render::{at_most, bound, extent, largest, ratio, short, table};
use lightfall_core::reports::bench::{
    BenchScene, DelayMeasurement, LightMeasurement, Measurement, PictureMeasurement, delay_table,
    light_table, pictures_table, ratio_range, scenes,
};
use lightfall_core::reports::extremes::Verdict;
use lightfall_core::scene::Method;

pub fn figures() -> Figures {
    let h200 = Bench::read("h200/bench");
    let mesa = Bench::read("llvmpipe/bench");
    let grid = measured::<Verdict>("h200/grid").rows;
    let pictures = measured::<PictureMeasurement>("h200-pictures/pictures").rows;
    let mut claims = methods(&h200, &grid);
    claims.extend(floor(&h200));
    claims.extend(without_spin(&h200));
    claims.extend(with_spin(&h200));
    claims.extend(mino(&h200, &grid));
    claims.extend(picture_errors(&pictures));
    claims.push(living_disk());
    claims.extend(on_mesa(&mesa));
    claims.extend(refine::claims());
    Figures {
        tables: vec![
            ("h200", errors_and_times(&h200)),
            ("equal-error", equal_error(&h200)),
            ("delay", delays()),
            ("light", lights()),
            ("pictures", shown(&pictures, &["edge-on", "above"])),
            ("llvmpipe", mesa_times(&mesa)),
        ],
        claims,
    }
}

/// Each scene's rows of `auto`, of mino's own and tightest setting, and of the article's methods at the
/// scene's own setting and at the article's.
fn errors_and_times(bench: &Bench) -> String {
    let mut chosen: Vec<&Measurement> = Vec::new();
    for mino in bench.scenes() {
        chosen.extend([mino.closed, mino.own(), mino.finest()]);
        for method in ["verlet", "kerr-schild"] {
            let all = bench.of(method);
            let own = all.iter().find(|in_scene| in_scene.scene == mino.scene);
            chosen.extend(own.into_iter().flat_map(InScene::article));
        }
    }
    table(
        "scene | method, setting | trace ms | frame ms | backward px, median | 99th percentile | in rad | \
         wrong class | given up",
        chosen.into_iter().map(|row| {
            vec![
                row.scene.clone(),
                row.label() + if row.auto { " *" } else { "" },
                short(row.trace_ms),
                row.frame_ms.map(short).unwrap_or_default(),
                short(row.backward_p50_px),
                short(row.backward_p99_px),
                short(row.backward_p99),
                row.misclassified.to_string(),
                row.unfinished.to_string(),
            ]
        }),
    )
}

fn equal_error(bench: &Bench) -> String {
    let cells = |scene: &str, method: &str| {
        let measured = bench.of(method).iter().any(|found| found.scene == scene);
        match bench.times_as_fast(scene, method) {
            Some(ranges) => ranges.map(ratio_range),
            None if measured => ["no level that it reaches".into(), String::new()],
            None => [String::new(), String::new()],
        }
    };
    table(
        "scene | against verlet | without the floor | against kerr-schild | without the floor | against mino | \
         without the floor",
        bench.scenes().iter().map(|in_scene| {
            let others = ["verlet", "kerr-schild", "mino"];
            let ratios = others.map(|method| cells(in_scene.scene, method)).concat();
            [vec![in_scene.scene.to_owned()], ratios].concat()
        }),
    )
}

fn delays() -> String {
    let mut rows = measured::<DelayMeasurement>("h200-living/delay").rows;
    let shown = ["edge-on", "above", "extremal", "edge-on-spinning"];
    rows.retain(|row| shown.contains(&row.scene.as_str()));
    delay_table(&rows)
}

fn lights() -> String {
    let mut rows = measured::<LightMeasurement>("h200-living/light").rows;
    let shown = ["edge-on", "above", "close", "extremal", "edge-on-spinning"];
    rows.retain(|row| shown.contains(&row.scene.as_str()));
    light_table(&rows)
}

/// The rows of scenes whose names begin with one of these words.
fn shown(rows: &[PictureMeasurement], scenes: &[&str]) -> String {
    let begins = |row: &&PictureMeasurement| scenes.iter().any(|name| row.scene.starts_with(name));
    let rows: Vec<PictureMeasurement> = rows.iter().filter(begins).cloned().collect();
    pictures_table(&rows)
}

fn mesa_times(bench: &Bench) -> String {
    let others = ["verlet", "kerr-schild", "mino"].map(|method| bench.of(method));
    table(
        "scene | `closed`, ms for 160x90 | times as long: verlet 0.85 | kerr-schild 0.85 | mino 0.05 | \
         99th percentile, rad: closed | verlet 0.85 | kerr-schild 0.85 | mino 0.05",
        bench.scenes().iter().map(|InScene { scene, closed, .. }| {
            let own = others.each_ref().map(|all| {
                let found = all.iter().find(|in_scene| in_scene.scene == *scene);
                found.map(InScene::own)
            });
            let text = |of: &dyn Fn(&Measurement) -> String| {
                own.map(|row| row.map_or_else(String::new, of))
            };
            let mut row = vec![(*scene).to_owned(), short(closed.trace_ms)];
            row.extend(text(&|own| ratio(own.trace_ms / closed.trace_ms)));
            row.push(short(closed.backward_p99));
            row.extend(text(&|own| short(own.backward_p99)));
            row
        }),
    )
}

/// How many times as long as `closed` a method takes at its usual setting, over these scenes.
fn times_as_long(scenes: &[InScene]) -> [f64; 2] {
    extent(
        scenes
            .iter()
            .map(|found| found.own().trace_ms / found.closed.trace_ms),
    )
}

/// Mino's largest 99th percentile in the cells of the grid.
fn on_grid(grid: &[Verdict], method: &str) -> f64 {
    let own = grid.iter().filter(|cell| cell.method == method);
    largest(own.map(|cell| cell.backward_p99))
}

fn methods(bench: &Bench, grid: &[Verdict]) -> Vec<Claim> {
    let mino = bench.scenes();
    let p99 = |of: fn(&InScene<'_>) -> f64| largest(mino.iter().map(of));
    let own = p99(|found| found.own().backward_p99).max(on_grid(grid, "mino"));
    let finest = p99(|found| found.finest().backward_p99).max(on_grid(grid, "mino, tightest"));
    let promised = |spin: f64| {
        bound(
            Method::Closed
                .backward_p99(spin)
                .expect("closed has a bound"),
        )
    };
    vec![
        claim(
            "with spin 99 of 100 rays within {} rad in the scenes below",
            [promised(0.5)],
        ),
        claim(
            "99 of 100 rays within {} rad at the default setting, and within {} at the tightest",
            [own, finest].map(at_most),
        ),
        claim(
            "the article's integrator, for comparison: {} to {} times as slow as `closed`",
            times_as_long(&bench.without_spin()).map(ratio),
        ),
        claim(
            "the article's integrator for spin, for comparison: {} to {} times as slow as `closed` at its usual setting",
            times_as_long(&bench.of("kerr-schild")).map(ratio),
        ),
        claim(
            "Half of a scene's {} rays are spread over its picture",
            [bench.rows[0].rays.to_string()],
        ),
        claim(
            "99 of 100 within {} rad without spin and within {} rad with it",
            [promised(0.0), promised(0.5)],
        ),
    ]
}

fn floor(bench: &Bench) -> Vec<Claim> {
    let plain = bench.without_spin();
    let exactness = bench.scenes();
    let exactness = exactness
        .iter()
        .map(|mino| mino.closed.backward_p99 / mino.finest().backward_p99);
    let coarse = plain.iter().filter_map(|verlet| verlet.at(1.55));
    let coarse: Vec<f64> = coarse.map(|row| row.trace_ms).collect();
    let net = plain
        .iter()
        .filter_map(|verlet| bench.times_as_fast(verlet.scene, "verlet"))
        .flat_map(|[_, net]| net);
    vec![
        claim(
            "The 99th percentile of `closed` is {} to {} times that of `mino` at its tightest setting",
            extent(exactness).map(ratio),
        ),
        claim(
            "when it traces only straight lines without a disk: {} ms",
            [short(bench.floor)],
        ),
        claim(
            "in `closed` without spin it is {} to {} of the time",
            extent(
                plain
                    .iter()
                    .map(|found| bench.floor / found.closed.trace_ms),
            )
            .map(ratio),
        ),
        claim(
            "`verlet` at its setting 1.55 takes {} to {} times as long as the floor",
            extent(coarse.iter().map(|time| time / bench.floor)).map(ratio),
        ),
        claim(
            "Without the floor `closed` is {} to {} times as fast as `verlet`",
            extent(net).map(ratio),
        ),
    ]
}

fn without_spin(bench: &Bench) -> Vec<Claim> {
    let plain = bench.without_spin();
    let closed = || plain.iter().map(|found| found.closed);
    let finite = |found: &InScene| {
        let errors = found.rows().map(|row| row.backward_p99);
        extent(errors)[0]
    };
    let no_lower = plain.iter().filter(|found| {
        let usual = found.own();
        found
            .rows()
            .all(|row| row.value >= usual.value || row.backward_p99 >= usual.backward_p99)
    });
    vec![
        claim(
            "For a hole without spin `closed` takes {} to {} ms for two million rays, every measured ray is within {} rad",
            [
                extent(closed().map(|row| row.trace_ms)).map(short).to_vec(),
                vec![at_most(largest(closed().map(|row| row.backward_max)))],
            ]
            .concat(),
        ),
        claim(
            "The smallest 99th percentile that any setting of `verlet` reaches is {} to {} times that of `closed` in the same scene",
            extent(
                plain
                    .iter()
                    .map(|found| finite(found) / found.closed.backward_p99),
            )
            .map(ratio),
        ),
        claim(
            "In {} of the {} scenes no finer step than the usual one lowers the 99th percentile",
            [no_lower.count(), plain.len()].map(|number| number.to_string()),
        ),
    ]
}

fn with_spin(bench: &Bench) -> Vec<Claim> {
    let (mino, kerr_schild) = (bench.spinning("mino"), bench.spinning("kerr-schild"));
    let closed = || mino.iter().map(|found| found.closed);
    let fastest = mino.iter().map(|found| {
        let times = found.rows().map(|row| row.trace_ms);
        extent(times)[0] / found.closed.trace_ms
    });
    let net = kerr_schild
        .iter()
        .map(|found| bench.net_ratio(found.own(), found.closed));
    vec![
        claim(
            "With spin `closed` takes {} to {} ms. The fastest setting of `mino` takes {} to {} times as long",
            [
                extent(closed().map(|row| row.trace_ms)).map(short),
                extent(fastest).map(ratio),
            ]
            .concat(),
        ),
        claim(
            "Of 100 rays of `closed` 99 are within {} to {} rad, depending on the scene, and every measured one is within {} rad",
            [
                extent(closed().map(|row| row.backward_p99))
                    .map(at_most)
                    .to_vec(),
                vec![at_most(largest(closed().map(|row| row.backward_max)))],
            ]
            .concat(),
        ),
        claim(
            "`kerr-schild` at its usual setting takes {} to {} times as long as `closed`, or, without the floor, {} to {} times",
            [times_as_long(&kerr_schild), extent(net)]
                .concat()
                .into_iter()
                .map(ratio),
        ),
    ]
}

fn mino(bench: &Bench, grid: &[Verdict]) -> Vec<Claim> {
    let scenes = bench.scenes();
    let over_own = |of: &dyn Fn(&InScene) -> f64| {
        extent(scenes.iter().map(|found| of(found) / found.own().trace_ms)).map(ratio)
    };
    let coarse = |found: &InScene| found.at(1.0).map_or(f64::NAN, |row| row.trace_ms);
    let coarse_px = scenes.iter().filter_map(|found| found.at(1.0));
    vec![
        claim(
            "99 of 100 rays are within {} rad in these scenes and within {} on [the grid](EXTREMES.md) of ordinary places",
            [
                largest(scenes.iter().map(|found| found.own().backward_p99)),
                on_grid(grid, "mino"),
            ]
            .map(at_most),
        ),
        claim(
            "at most {} of a pixel in these scenes, is far below the setting",
            [at_most(largest(
                scenes.iter().map(|found| found.own().backward_p99_px),
            ))],
        ),
        claim(
            "With one pixel allowed, it takes {} to {} of the time, and 99 of 100 rays stay within {} of a pixel",
            [
                over_own(&coarse).to_vec(),
                vec![at_most(largest(coarse_px.map(|row| row.backward_p99_px)))],
            ]
            .concat(),
        ),
        claim(
            "At its tightest setting 99 of 100 rays are within {} rad for {} to {} times the time",
            [
                vec![at_most(largest(
                    scenes.iter().map(|found| found.finest().backward_p99),
                ))],
                over_own(&|found| found.finest().trace_ms).to_vec(),
            ]
            .concat(),
        ),
        hits_in_limit(&scenes),
    ]
}

/// The errors of hits in the scene in which they are largest.
fn hits_in_limit(scenes: &[InScene]) -> Claim {
    let limit = scenes
        .iter()
        .find(|found| found.scene == "limit")
        .expect("preset `limit` is measured");
    let rows = [limit.own(), limit.finest(), limit.closed];
    let radius = rows.map(|row| short(row.hit_r_p50));
    let shift = rows.map(|row| short(row.hit_g_p50));
    claim(
        "In preset `limit` the median relative error of a hit's r is {} ({} at the tightest setting, {} by `closed`) \
         and that of its g {} ({}, {})",
        [radius, shift].concat(),
    )
}

/// Error and time of a setting over those of single rays, in all scenes that are smooth or not.
fn over_single_rays(
    rows: &[PictureMeasurement],
    smooth: bool,
    (antialias, samples): (bool, u32),
) -> [String; 4] {
    let chosen = rows.iter().filter(|row| {
        row.scene.ends_with("-smooth") == smooth
            && (row.antialias, row.samples) == (antialias, samples)
    });
    let pairs: Vec<[f64; 2]> = chosen
        .filter_map(|row| {
            let one = rows
                .iter()
                .find(|one| one.scene == row.scene && !one.antialias && one.samples == 1)?;
            Some([row.rms / one.rms, row.over_one])
        })
        .collect();
    let [low, high] = extent(pairs.iter().map(|[error, _]| *error));
    let [quick, slow] = extent(pairs.iter().map(|[_, time]| *time));
    [low, high, quick, slow].map(ratio)
}

fn picture_errors(rows: &[PictureMeasurement]) -> Vec<Claim> {
    vec![
        claim(
            "In the scenes without structure refined edges have {} to {} of the error of single rays for {} to {} times their time",
            over_single_rays(rows, true, (true, 1)),
        ),
        claim(
            "four rays in every pixel have {} to {} of it for {} to {} times the time",
            over_single_rays(rows, true, (false, 4)),
        ),
        claim(
            "with it refined edges have {} to {} of the error of single rays for {} to {} times their time",
            over_single_rays(rows, false, (true, 1)),
        ),
    ]
}

fn living_disk() -> Claim {
    let rows = measured::<LightMeasurement>("h200-living/light").rows;
    let time = |scene: &str, method: &str| {
        let is_it = |row: &&LightMeasurement| row.scene == scene && row.method == method;
        rows.iter().find(is_it).map(|row| row.living_ms)
    };
    let spinning = scenes()
        .into_iter()
        .filter(|scene| scene.scene.hole.spin != 0.0);
    let ratios: Vec<f64> = spinning
        .filter_map(|BenchScene { name, .. }| Some(time(&name, "closed")? / time(&name, "mino")?))
        .collect();
    claim(
        "a living disk around a spinning hole takes `closed` {} to {} times as long as `mino`",
        extent(ratios).map(ratio),
    )
}

fn on_mesa(bench: &Bench) -> Vec<Claim> {
    let (mino, kerr_schild) = (bench.spinning("mino"), bench.spinning("kerr-schild"));
    let worst = |of: fn(&InScene<'_>) -> f64| at_most(largest(mino.iter().map(of)));
    let over = |of: fn(&InScene<'_>) -> f64| {
        extent(mino.iter().map(|found| of(found) / found.closed.trace_ms)).map(ratio)
    };
    let net = kerr_schild
        .iter()
        .map(|found| bench.net_ratio(found.own(), found.closed));
    let edge_on = bench.scenes();
    let edge_on = edge_on.iter().find(|found| found.scene == "edge-on");
    let edge_on = edge_on.expect("the scene is measured").closed;
    vec![
        claim(
            "`closed` holds {} rad for such rays",
            [at_most(edge_on.backward_p99)],
        ),
        claim(
            "With spin 99 of 100 rays of `closed` are within {} rad, and of `mino` at its default setting within {}",
            [
                worst(|found| found.closed.backward_p99),
                worst(|found| found.own().backward_p99),
            ],
        ),
        claim(
            "`mino` takes {} to {} times as long as `closed` there at its default setting, and {} to {} at its tightest, which is within {} rad",
            [
                over(|found| found.own().trace_ms).to_vec(),
                over(|found| found.finest().trace_ms).to_vec(),
                vec![worst(|found| found.finest().backward_p99)],
            ]
            .concat(),
        ),
        claim(
            "`kerr-schild` takes {} to {} times as long, {} to {} without the floor of {} ms",
            [
                times_as_long(&kerr_schild).map(ratio).to_vec(),
                extent(net).map(ratio).to_vec(),
                vec![short(bench.floor)],
            ]
            .concat(),
        ),
    ]
}
