// Looks at the candidates in bent cells: the mesh tells nearly where their images are and how bright,
// so that rays are spent on few that are in another cell or too faint.
//
// Needs: BENT, FROM_MESH, PREDICTION_STEPS, PREDICT_GROUPS, TINY, WORKGROUP_SIZE, add_rough,
//     candidate_counts, candidates, jacobian_at, mesh, mesh_place, mesh_points, pixel_solid_angle,
//     predicted, rows_about, square, star_list, stars, tangents_at, unpacked_candidate,
//     unpacked_flux.
// Gives: predict.

// How far outside of its cell, in cells, an image must be by the cell's polynomial before it is left to
// other cells; and by how much its magnification may exceed the polynomial's. In random scenes with
// 239 000 images, 0.05 and 1.05 find the same ones.
const PREDICTION_MARGIN: f32 = 0.15;
const PREDICTION_SAFETY: f32 = 1.4;

// Of the candidates in bent cells, keeps those whose image lies in the cell or near it.
@compute @workgroup_size(WORKGROUP_SIZE)
fn predict(@builtin(global_invocation_id) id: vec3<u32>) {
    let count = min(atomicLoad(&candidate_counts.lists[BENT].candidates), mesh.capacity);
    for (var i = id.x; i < count; i += PREDICT_GROUPS * WORKGROUP_SIZE) {
        let packed = candidates[BENT * mesh.capacity + i];
        let candidate = unpacked_candidate(packed);
        let star = candidate.star;
        let number = candidate.cell;
        let direction = star_list[star].direction;
        let rows = rows_about(number, direction, tangents_at(direction));
        let prediction = predicted(rows, PREDICTION_STEPS);
        let place = prediction.place;
        let outside = max(abs(place.x - 0.5), abs(place.y - 0.5)) - 0.5;
        let is_known = prediction.last_step < PREDICTION_MARGIN;
        let jacobian = jacobian_at(rows, place);
        let seen = square(mesh.spacing) * pixel_solid_angle(mesh_place(vec2<f32>(number) + place));
        let gain = mesh_points[number.y * mesh.points.x + number.x].gain * seen / max(abs(determinant(jacobian)), TINY);
        let is_faint = PREDICTION_SAFETY * gain * unpacked_flux(star_list[star].light) < stars.flux_limit;
        if !(is_known && (is_faint || outside > PREDICTION_MARGIN)) {
            add_rough(packed.x, star, select(candidate.starts, FROM_MESH, is_known));
        }
    }
}
