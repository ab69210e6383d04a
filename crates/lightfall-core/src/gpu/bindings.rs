//! Numbers of the shaders' bindings, all of them in group 0, and the size of a workgroup. Every
//! shader gets them as constants in front of its text, under the names in the tables below.

/// The uniform `Scene`.
pub const SCENE: u32 = 0;
/// The table of thermal colours, a uniform.
pub const SPECTRUM: u32 = 1;
/// The storage array that a compute shader reads.
pub const INPUT: u32 = 2;
/// The storage array that a compute shader writes.
pub const OUTPUT: u32 = 3;
/// The table of the disk model `page-thorne`, a uniform.
pub const PAGE_THORNE: u32 = 4;
/// The grid of the view `error`, a uniform.
pub const ERROR_MAP: u32 = 5;
/// The rings and waves of the disk's structure, a uniform.
pub const STRUCTURE: u32 = 6;
/// The hot spot of the disk, a uniform.
pub const HOT_SPOT: u32 = 7;

/// The uniform `Presentation` of the presentation's shader, which has bindings of its own.
pub const PRESENTATION: u32 = 0;
/// The texture that a stage of the presentation reads.
pub const PRESENTATION_SOURCE: u32 = 1;

/// The uniform `Difference` of the difference's shader, which has bindings of its own.
pub const DIFFERENCE: u32 = 0;
/// The light of the pinned scene.
pub const DIFFERENCE_LEFT: u32 = 1;
/// The light of the current scene.
pub const DIFFERENCE_RIGHT: u32 = 2;

/// Invocations of a compute shader's workgroup.
pub const WORKGROUP_SIZE: u32 = 64;

/// The constants of the shaders that trace rays or draw the picture.
pub(super) const CONSTANTS: [(&str, u32); 9] = [
    ("BINDING_SCENE", SCENE),
    ("BINDING_SPECTRUM", SPECTRUM),
    ("BINDING_INPUT", INPUT),
    ("BINDING_OUTPUT", OUTPUT),
    ("BINDING_PAGE_THORNE", PAGE_THORNE),
    ("BINDING_ERROR_MAP", ERROR_MAP),
    ("BINDING_STRUCTURE", STRUCTURE),
    ("BINDING_HOT_SPOT", HOT_SPOT),
    ("WORKGROUP_SIZE", WORKGROUP_SIZE),
];

/// The constants of the presentation's shader.
pub(super) const PRESENTATION_CONSTANTS: [(&str, u32); 2] = [
    ("BINDING_PRESENTATION", PRESENTATION),
    ("BINDING_PRESENTATION_SOURCE", PRESENTATION_SOURCE),
];

/// The constants of the difference's shader.
pub(super) const DIFFERENCE_CONSTANTS: [(&str, u32); 3] = [
    ("BINDING_DIFFERENCE", DIFFERENCE),
    ("BINDING_DIFFERENCE_LEFT", DIFFERENCE_LEFT),
    ("BINDING_DIFFERENCE_RIGHT", DIFFERENCE_RIGHT),
];
