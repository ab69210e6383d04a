//! Pictures of the screen, and how they differ.

/// What the window shows.
#[derive(Clone, PartialEq)]
pub struct Shot {
    pub width: usize,
    pub height: usize,
    bgrx: Vec<u8>,
}

impl Shot {
    /// Rows of blue, green, red and a byte more.
    pub fn new(width: usize, height: usize, bgrx: Vec<u8>) -> Self {
        Self {
            width,
            height,
            bgrx,
        }
    }

    pub fn pixel(&self, x: usize, y: usize) -> [u8; 3] {
        let at = 4 * (y * self.width + x);
        [self.bgrx[at + 2], self.bgrx[at + 1], self.bgrx[at]]
    }

    /// Share of the pixels of a rectangle that differ from another shot's: all if that has another
    /// size.
    pub fn changed(
        &self,
        other: &Self,
        x: std::ops::Range<usize>,
        y: std::ops::Range<usize>,
    ) -> f64 {
        if (self.width, self.height) != (other.width, other.height) {
            return 1.0;
        }
        let count = x.len() * y.len();
        let differ = y.flat_map(|y| x.clone().map(move |x| (x, y)));
        differ
            .filter(|&(x, y)| self.pixel(x, y) != other.pixel(x, y))
            .count() as f64
            / count as f64
    }

    /// Some of its rows.
    pub fn rows(&self, rows: std::ops::Range<usize>) -> Self {
        let bytes = |row: usize| 4 * self.width * row.min(self.height);
        let bgrx = self.bgrx[bytes(rows.start)..bytes(rows.end.max(rows.start))].to_vec();
        Self {
            width: self.width,
            height: bgrx.len() / (4 * self.width),
            bgrx,
        }
    }

    /// Writes a picture file.
    pub fn save(&self, file: &std::path::Path) {
        let colour = |x: u32, y: u32| image::Rgb(self.pixel(x as usize, y as usize));
        let picture = image::RgbImage::from_fn(self.width as u32, self.height as u32, colour);
        picture.save(file).unwrap();
    }

    /// Number of different colours.
    pub fn colours(&self) -> usize {
        let pixels = (0..self.height).flat_map(|y| (0..self.width).map(move |x| (x, y)));
        pixels
            .map(|(x, y)| self.pixel(x, y))
            .collect::<std::collections::BTreeSet<_>>()
            .len()
    }
}
