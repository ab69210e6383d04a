// No delay for the method mino.
//
// Gives: crossing_delay, first_delay, step_delay.

fn first_delay(inward: bool) -> f32 {
    return 0.0;
}

fn step_delay(m: Motion, step: Step, h: f32) -> f32 {
    return 0.0;
}

fn crossing_delay(m: Motion, step: Step, h: f32, share: f32, v: f32) -> f32 {
    return 0.0;
}
