// Tests the candidates in bent cells by interpolation, so that few rays are spent on images in
// another cell, or too faint.
//
// Gives: test_candidates.

// The distance outside the cell, in cells, at which an interpolated image is left to other cells,
// and the factor by which its magnification may exceed the interpolated one. In random scenes with
// 239 000 images, 0.05 and 1.05 find the same ones.
const TEST_MARGIN: f32 = 0.15;
const TEST_SAFETY: f32 = 1.4;

// Keeps the candidates whose image lies in the cell or near it.
@compute @workgroup_size(WORKGROUP_SIZE)
fn test_candidates(@builtin(global_invocation_id) id: vec3<u32>) {
    let count = min(atomicLoad(&candidate_counts.lists[BENT].candidates), mesh.capacity);
    for (var i = id.x; i < count; i += TEST_GROUPS * WORKGROUP_SIZE) {
        let packed = candidates[BENT * mesh.capacity + i];
        let candidate = unpacked_candidate(packed);
        let star = candidate.star;
        let number = candidate.cell;
        let direction = star_list[star].direction;
        let rows = rows_about(number, direction, tangents_at(direction));
        let image = interpolated_image(rows, INTERPOLATION_STEPS);
        let place = image.place;
        let outside = max(abs(place.x - 0.5), abs(place.y - 0.5)) - 0.5;
        let is_known = is_below(image.last_step, TEST_MARGIN);
        let jacobian = jacobian_at(rows, place);
        let seen = square(mesh.spacing) * pixel_solid_angle(mesh_place(vec2<f32>(number) + place));
        let gain = mesh_points[number.y * mesh.points.x + number.x].gain * seen / max(abs(determinant(jacobian)), TINY);
        let is_faint = TEST_SAFETY * gain * unpacked_flux(star_list[star].light) < stars.flux_limit;
        if !(is_known && (is_faint || outside > TEST_MARGIN)) {
            add_rough(packed.x, star, select(candidate.starts, FROM_MESH, is_known));
        }
    }
}
