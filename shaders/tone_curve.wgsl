// The tone curves: from light of any brightness, with the primaries of Rec. 709, to the range of a
// screen.
//
// Gives: toned.

// CURVE is a constant, because some drivers execute every side of a branch.
fn toned(light: vec3<f32>) -> vec3<f32> {
    if CURVE == SOFT {
        return toned_softly(light);
    }
    if CURVE == ACES {
        return toned_as_film(light);
    }
    if CURVE == REINHARD {
        return light / (1.0 + luminance(light));
    }
    return toned_neutrally(light);
}

// Rec. ITU-R BT.709, item 3.2.
fn luminance(light: vec3<f32>) -> f32 {
    return dot(light, vec3<f32>(0.2126, 0.7152, 0.0722));
}

// The PBR Neutral tone mapper (Khronos Group 2024): F_90 is the reflectance that is subtracted, K_s
// where the compression begins, and K_d how fast compressed light loses its colour.
const F_90: f32 = 0.04;
const K_S: f32 = 0.8 - F_90;
const K_D: f32 = 0.15;

fn toned_neutrally(light: vec3<f32>) -> vec3<f32> {
    let least = min(light.r, min(light.g, light.b));
    let offset = select(F_90, least - least * least / (4.0 * F_90), least < 2.0 * F_90);
    let above = light - offset;
    let peak = max(above.r, max(above.g, above.b));
    if peak < K_S {
        return above;
    }
    let room = 1.0 - K_S;
    let shown_peak = 1.0 - room * room / (peak + room - K_S);
    let colour = 1.0 / (K_D * (peak - shown_peak) + 1.0);
    return mix(vec3<f32>(shown_peak), above * (shown_peak / peak), colour);
}

fn saturating(light: vec3<f32>) -> vec3<f32> {
    return 1.0 - exp(-light);
}

// Stachowiak's "somewhat boring display transform" (2020): bright and colourful light moves from a
// curve of the luminance to one of each channel, and loses colour.
fn toned_softly(light: vec3<f32>) -> vec3<f32> {
    let luma = luminance(light);
    // The two colour differences of Rec. ITU-R BT.709, items 3.3 and 3.4.
    let chroma = vec2<f32>(
        dot(light, vec3<f32>(-0.1146, -0.3854, 0.5)),
        dot(light, vec3<f32>(0.5, -0.4542, -0.0458)),
    );
    let curves = saturating(vec3<f32>(luma, 2.4 * length(chroma), 0.0));
    let colourful = curves.y;
    let bleach = max(0.8 * (colourful - 0.7), 0.0);
    let by_luminance = light * (curves.x / max(luma, 1e-5));
    let by_channel = saturating(mix(light, vec3<f32>(luma), bleach * bleach));
    return 0.97 * mix(by_luminance, by_channel, colourful * colourful);
}

// Hill's fit of the reference and output transforms of ACES: from sRGB to the space of the curve, the
// curve, and back.
fn toned_as_film(light: vec3<f32>) -> vec3<f32> {
    let film = vec3<f32>(
        dot(light, vec3<f32>(0.59719, 0.35458, 0.04823)),
        dot(light, vec3<f32>(0.07600, 0.90834, 0.01566)),
        dot(light, vec3<f32>(0.02840, 0.13383, 0.83777)),
    );
    let shown = (film * (film + 0.0245786) - 0.000090537)
        / (film * (0.983729 * film + 0.4329510) + 0.238081);
    let back = vec3<f32>(
        dot(shown, vec3<f32>(1.60475, -0.53108, -0.07367)),
        dot(shown, vec3<f32>(-0.10208, 1.10813, -0.00605)),
        dot(shown, vec3<f32>(-0.00327, -0.07276, 1.07602)),
    );
    return clamp(back, vec3<f32>(0.0), vec3<f32>(1.0));
}
