// The layers that are drawn, by the bits of scene.picture.layers.
//
// Gives: is_drawn, light_of_layer.

fn is_drawn(layer: u32) -> bool {
    return (scene.picture.layers & layer) != 0u;
}

// The light of a layer and its share of the ray; both are zero if the layer is not drawn.
fn light_of_layer(layer: u32, light: vec3<f32>, share: f32) -> vec4<f32> {
    return select(vec4<f32>(0.0), vec4<f32>(light, share), is_drawn(layer));
}
