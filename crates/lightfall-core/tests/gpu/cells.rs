//! The pixel look as numbers: the pattern of the dither, and the mean of the pixels that a cell
//! covers. What is expected is written out by hand.

use crate::gpu;
use crate::light::light_from;
use glam::{UVec2, Vec3, Vec4};
use lightfall_core::gpu::kernel::uniform;
use lightfall_core::gpu::{Gpu, Presentation, bindings, read_back};
use wgpu::util::{BufferInitDescriptor, DeviceExt, TextureDataOrder};

/// Bayer's matrix of order 4 (Bayer 1973, "An optimum method for two-level rendition of
/// continuous-tone pictures") as the picture shows it: rows from the top, columns from the left.
const BAYER: [[u32; 4]; 4] = [
    [0, 8, 2, 10], //
    [12, 4, 14, 6],
    [3, 11, 1, 9],
    [15, 7, 13, 5],
];

/// The cells of 3 x 3 periods of the pattern, row by row.
fn cells() -> impl Iterator<Item = [u32; 2]> + Clone {
    (0..12).flat_map(|y| (0..12).map(move |x| [x, y]))
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_dithers_ranks_are_bayers_matrix_with_x_to_the_right_and_y_down() {
    let given = cells().map(|[x, y]| Vec4::new(x as f32, y as f32, 0.0, 0.0));
    let ranks = light_from(
        gpu(),
        &Presentation::shader().source(),
        "vec4<f32>(bayer(vec2<u32>(given.xy)))",
        &[],
        given,
    );
    for ([x, y], rank) in cells().zip(ranks) {
        let expected = BAYER[y as usize % 4][x as usize % 4];
        assert_eq!(rank.x, expected as f32, "the cell in column {x}, row {y}");
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn one_colour_between_two_levels_is_dithered_by_bayers_matrix() {
    // Three levels: 0, 1/2 and 1 of the encoded value.
    let settings = Presentation {
        levels: 3.0,
        dither: 1,
        ..Presentation::default()
    };
    // From the middle level to the top one, a sixteenth at a time. Between two thresholds, where
    // rounding matters to no cell.
    for lit in 0..=16_u32 {
        let encoded = (1.0 + (f64::from(lit) / 16.0).min(0.999)) / 2.0;
        // IEC 61966-2-1.
        let linear = ((encoded + 0.055) / 1.055).powf(2.4) as f32;
        let given = cells().map(|[x, y]| Vec4::new(x as f32, y as f32, linear, 0.0));
        let shown = light_from(
            gpu(),
            &Presentation::shader().source(),
            "vec4<f32>(srgb_encode(quantize(vec3<f32>(given.z), vec2<u32>(given.xy))), 0.0)",
            &[(bindings::PRESENTATION, uniform(&settings))],
            given,
        );
        for ([x, y], shown) in cells().zip(shown) {
            // The cells with the highest ranks reach the next level first.
            let is_lit = BAYER[y as usize % 4][x as usize % 4] + lit >= 16;
            let expected = if is_lit { 1.0 } else { 0.5 };
            // f32 rounds the powers of the transfer function and of its inverse.
            assert!(
                (shown.x - expected).abs() < 1e-5,
                "{lit} sixteenths above the level, column {x}, row {y}: {}",
                shown.x
            );
        }
    }
}

/// The means that `cell_mean` gives the cells of a grid over a picture, row by row.
fn means(gpu: &Gpu, size: [u32; 2], pixels: &[Vec3], grid: [u32; 2]) -> Vec<Vec3> {
    let settings = Presentation {
        picture: size.into(),
        grid: grid.into(),
        ..Presentation::default()
    };
    let texels: Vec<u8> = pixels
        .iter()
        .flat_map(|light| light.extend(1.0).to_array())
        .flat_map(f32::to_le_bytes)
        .collect();
    let texture = gpu.device.create_texture_with_data(
        &gpu.queue,
        &wgpu::TextureDescriptor {
            label: Some("picture"),
            size: wgpu::Extent3d {
                width: size[0],
                height: size[1],
                depth_or_array_layers: 1,
            },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: wgpu::TextureFormat::Rgba32Float,
            usage: wgpu::TextureUsages::TEXTURE_BINDING,
            view_formats: &[],
        },
        TextureDataOrder::default(),
        &texels,
    );
    let numbers = gpu.device.create_buffer_init(&BufferInitDescriptor {
        label: Some("presentation"),
        contents: &uniform(&settings),
        usage: wgpu::BufferUsages::UNIFORM,
    });
    let bytes = u64::from(UVec2::from(grid).element_product()) * 16;
    let buffer = |usage| {
        gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("means"),
            size: bytes,
            usage,
            mapped_at_creation: false,
        })
    };
    let output = buffer(wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC);
    let readable = buffer(wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ);
    let entry =
        "@group(0) @binding(BINDING_OUTPUT) var<storage, read_write> means: array<vec4<f32>>;
        @compute @workgroup_size(1) fn each(@builtin(global_invocation_id) cell: vec3<u32>) {
            means[cell.y * presentation.grid.x + cell.x] = vec4<f32>(cell_mean(cell.xy), 0.0);
        }";
    let module = gpu
        .shader("means", &(Presentation::shader().source() + entry))
        .unwrap();
    let pipeline = gpu
        .device
        .create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some("means"),
            layout: None,
            module: &module,
            entry_point: Some("each"),
            compilation_options: Default::default(),
            cache: None,
        });
    let view = texture.create_view(&Default::default());
    let resources = [
        (bindings::PRESENTATION, numbers.as_entire_binding()),
        (
            bindings::PRESENTATION_SOURCE,
            wgpu::BindingResource::TextureView(&view),
        ),
        (bindings::OUTPUT, output.as_entire_binding()),
    ];
    let bind_group = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: None,
        layout: &pipeline.get_bind_group_layout(0),
        entries: &resources.map(|(binding, resource)| wgpu::BindGroupEntry { binding, resource }),
    });
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    {
        let mut pass = encoder.begin_compute_pass(&Default::default());
        pass.set_pipeline(&pipeline);
        pass.set_bind_group(0, &bind_group, &[]);
        pass.dispatch_workgroups(grid[0], grid[1], 1);
    }
    encoder.copy_buffer_to_buffer(&output, 0, &readable, 0, bytes);
    gpu.queue.submit([encoder.finish()]);
    read_back(&gpu.device, &readable)
        .unwrap()
        .chunks_exact(16)
        .map(|mean| {
            let channel = |at: usize| f32::from_le_bytes(mean[at..at + 4].try_into().unwrap());
            Vec3::new(channel(0), channel(4), channel(8))
        })
        .collect()
}

#[test]
#[ignore = "needs a graphics adapter"]
fn a_cell_weighs_each_pixel_by_the_part_of_it_that_it_covers() {
    // Seven columns in three cells: a cell is 2 1/3 pixels wide. Five rows in two: 2 1/2 high.
    let columns = [7.0, 0.0, 21.0, 14.0, 0.0, 7.0, 28.0];
    let rows = [5.0, 0.0, 10.0, 20.0, 5.0];
    // Red depends on the column alone and green on the row alone; blue is one pixel in the middle,
    // in column 2 and row 2, which four cells share.
    let pixels: Vec<Vec3> = (0..5)
        .flat_map(|y| (0..7).map(move |x| (x, y)))
        .map(|(x, y)| {
            Vec3::new(
                columns[x],
                rows[y],
                if (x, y) == (2, 2) { 70.0 } else { 0.0 },
            )
        })
        .collect();
    // Red: (7 + 0 + 21/3) / (7/3) = 6; (21 2/3 + 14 + 0 2/3) / (7/3) = 12; (0/3 + 7 + 28) / (7/3) = 15.
    let red = [6.0, 12.0, 15.0];
    // Green: (5 + 0 + 10/2) / (5/2) = 4; (10/2 + 20 + 5) / (5/2) = 12.
    let green = [4.0, 12.0];
    // Blue: a cell is 7/3 x 5/2 = 35/6 pixels large. The pixel's left third and right two thirds
    // lie in the first and second column of cells, and half of it in either row: 70 (1/3 1/2) / (35/6)
    // = 2, and 70 (2/3 1/2) / (35/6) = 4.
    let blue = [2.0, 4.0, 0.0];
    let found = means(gpu(), [7, 5], &pixels, [3, 2]);
    for (i, mean) in found.iter().enumerate() {
        let (column, row) = (i % 3, i / 3);
        let expected = Vec3::new(red[column], green[row], blue[column]);
        // 7/3 and 5/2 of the sizes and their sums are rounded to f32: some units of 1e-7 of 28.
        assert!(
            mean.abs_diff_eq(expected, 2e-5),
            "the cell in column {column}, row {row}: {mean} in place of {expected}"
        );
    }
    assert_eq!(found.len(), 6);
}
