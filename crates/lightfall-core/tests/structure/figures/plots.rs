//! The plots in docs/bench, which are drawn from the CSV files beside them.

use super::measured::measured;
use crate::root;
use lightfall_core::reports::bench::{
    DelayMeasurement, Measurement, PictureMeasurement, RefinementMeasurement, plot, plot_delays,
    plot_pictures, plot_refinements,
};
use lightfall_core::reports::import::{Head, Report};
use serde::de::DeserializeOwned;
use std::fs;

/// Draws the rows of a scene, given its name and a line about the measurement. `None` if there is
/// nothing to draw.
type Draw<T> = fn(&str, &str, &[T]) -> Result<Option<String>, String>;

/// A plot: its file below docs/bench, and its text.
struct Plot {
    file: String,
    svg: String,
}

/// Every plot.
fn all() -> Vec<Plot> {
    let of_size = |head: &Head| {
        let said = |name: &str| {
            head.get(name)
                .expect("a report says how it was made")
                .to_owned()
        };
        format!("{}, {}", said("size"), said("adapter"))
    };
    let of_adapter = |head: &Head| head.get("adapter").expect("a report says where").to_owned();
    [
        plots::<Measurement>("h200/bench", "", of_size, |row| &row.scene, plot),
        plots::<Measurement>("llvmpipe/bench", "", of_size, |row| &row.scene, plot),
        plots::<DelayMeasurement>(
            "h200-living/delay",
            "delay-",
            of_size,
            |row| &row.scene,
            plot_delays,
        ),
        plots::<PictureMeasurement>(
            "h200-pictures/pictures",
            "pictures-",
            of_size,
            |row| &row.scene,
            plot_pictures,
        ),
        plots::<RefinementMeasurement>(
            "llvmpipe/refine",
            "refine-",
            of_adapter,
            |row| &row.scene,
            plot_refinements,
        ),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// The plots of a CSV file, one for each scene, which `scene` names. Their names begin with `prefix`.
fn plots<T: DeserializeOwned>(
    file: &str,
    prefix: &str,
    about: fn(&Head) -> String,
    scene: fn(&T) -> &str,
    draw: Draw<T>,
) -> Vec<Plot> {
    let Report { head, rows } = measured::<T>(file);
    let folder = file.split('/').next().unwrap_or_default();
    let mut scenes: Vec<&str> = rows.iter().map(scene).collect();
    scenes.dedup();
    let drawn = scenes.into_iter().filter_map(|scene| {
        let svg = draw(scene, &about(&head), &rows).expect("the rows can be drawn")?;
        let file = format!("{folder}/{prefix}{scene}.svg");
        Some(Plot { file, svg })
    });
    drawn.collect()
}

#[test]
fn every_plot_of_the_documents_is_drawn_from_its_csv_file() {
    let folder = root().join("docs/bench");
    let mut faults = Vec::new();
    let plots = all();
    for Plot { file, svg } in &plots {
        let path = folder.join(file);
        if std::env::var_os(super::WRITE).is_some() {
            fs::write(&path, svg).expect("a plot can be written");
        } else if fs::read_to_string(&path).ok().as_ref() != Some(svg) {
            faults.push(format!("docs/bench/{file} is not what its CSV file says"));
        }
    }
    for entry in walk(&folder) {
        let is_known = plots.iter().any(|plot| plot.file == entry);
        if entry.ends_with(".svg") && !is_known {
            faults.push(format!("docs/bench/{entry} belongs to no CSV file"));
        }
    }
    assert!(
        faults.is_empty(),
        "\n{}\nscripts/docs draws the plots of docs/bench",
        faults.join("\n")
    );
}

/// The files in the folders of a folder, as `FOLDER/FILE`.
fn walk(folder: &std::path::Path) -> Vec<String> {
    let names = |path: &std::path::Path| -> Vec<String> {
        let entries = fs::read_dir(path).expect("a folder of docs/bench can be read");
        let names = entries.map(|entry| entry.expect("a folder can be listed").file_name());
        names.map(|name| name.to_string_lossy().into()).collect()
    };
    let files = |name: &String| {
        let own = names(&folder.join(name)).into_iter();
        own.map(|file| format!("{name}/{file}")).collect::<Vec<_>>()
    };
    names(folder).iter().flat_map(files).collect()
}
