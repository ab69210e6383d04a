// No delay for the method closed around a spinning hole.
//
// Gives: crossing_delay.

fn crossing_delay(
    m: Radial,
    c: PhotonConstants,
    course: RadialCourse,
    inward: bool,
    u: f32,
    returned: bool,
    t: f32,
    height2: f32,
) -> f32 {
    return 0.0;
}
