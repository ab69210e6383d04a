// Elementary functions with a stated error, for where that of WGSL's built-ins would show: atan2 may be wrong by 4096
// units in the last place, 2.4e-4 of the result.

// Arctangent on [-1, 1]: x times a polynomial in x^2, interpolated at Chebyshev's points; its own error is 1e-8 rad.
fn arctangent_within_one(x: f32) -> f32 {
    let y = x * x;
    var sum = 0.00276628346;
    sum = sum * y - 0.015731249;
    sum = sum * y + 0.0421376228;
    sum = sum * y - 0.0745685473;
    sum = sum * y + 0.106183708;
    sum = sum * y - 0.141977981;
    sum = sum * y + 0.199918717;
    sum = sum * y - 0.333330363;
    return x + x * y * sum;
}

// Angle of (x, y) from the x axis, in [-pi, pi], at most 5e-7 rad off with WGSL's division; zero for (0, 0).
fn arctangent2(y: f32, x: f32) -> f32 {
    let largest = max(max(abs(x), abs(y)), TINY);
    var angle = arctangent_within_one(min(abs(x), abs(y)) / largest);
    angle = select(angle, 0.5 * PI - angle, abs(y) > abs(x));
    angle = select(angle, PI - angle, x < 0.0);
    return select(angle, -angle, y < 0.0);
}
