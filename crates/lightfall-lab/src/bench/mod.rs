//! Error against run time, for each scene, method and setting.

mod delay;
mod equal_error;
mod flight;
mod labels;
mod light;
mod markdown;
mod measurement;
mod medium;
mod pareto;
mod pictures;
mod plan;
mod plot;
mod refine;
mod scenes;
mod settings;
mod studies;

pub use delay::{DelayMeasurement, delay_table};
pub use equal_error::{AtEqualError, at_equal_error};
pub use flight::{FlightFault, FlightMeasurement, flight_rows, flight_table, run_flights};
pub use light::{LightMeasurement, light_table};
pub use markdown::{markdown, ratio_range};
pub use measurement::Measurement;
pub use medium::{MediumMeasurement, medium_table};
pub use pareto::{AutoMargin, Ranking, auto_margin, is_on_front};
pub use pictures::{
    PICTURE_SETTINGS, PictureError, PictureMeasurement, PictureSetting, TRUE_SAMPLES,
    measured_part, pictures_table, with_smooth_disk,
};
pub use plan::{Plan, Step};
pub use plot::plot;
pub use refine::{RefinementMeasurement, refinement_table};
pub use scenes::{BenchScene, scenes};
pub(crate) use settings::able_methods;
pub use settings::{Setting, methods_for, settings};
pub use studies::Study;
