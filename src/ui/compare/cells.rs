//! Outlines in a picture by its cells, in which many can be compared.

use glam::Vec2;

/// Most columns and rows that pictures are looked at in.
const CELLS: u32 = 300;
/// Distance in cells from which on outlines are apart, however far: shadows are far from what throws them.
const FARTHEST: usize = 8;

/// Cells of a picture: squares of pixels.
#[derive(Clone, Copy)]
pub(super) struct Grid {
    /// Size of the picture in pixels.
    pub size: Vec2,
    /// Pixels along a cell.
    pub step: u32,
    /// Pixels from one that is known to the next.
    pub apart: u32,
    columns: usize,
    rows: usize,
}

impl Grid {
    /// Those of a picture of which pixels are known that are `apart`.
    pub fn new(apart: u32, (width, height): (u32, u32)) -> Self {
        let apart = apart.max(1);
        let step = apart * (width.max(height)).div_ceil(CELLS * apart).max(1);
        Self {
            size: Vec2::new(width as f32, height as f32),
            step,
            apart,
            columns: width.div_ceil(step) as usize,
            rows: height.div_ceil(step) as usize,
        }
    }

    /// Column and row of the cell that a pixel is in.
    pub fn cell(self, pixel: [u32; 2]) -> [usize; 2] {
        pixel.map(|along| (along / self.step) as usize)
    }

    /// The cells that pixels are in.
    pub fn covered(self, pixels: impl Iterator<Item = [u32; 2]>) -> Cells {
        let mut covered = Cells::none(self);
        pixels.for_each(|pixel| covered.insert(self.cell(pixel)));
        covered
    }
}

/// Some of the cells of a grid, as bits: many cameras are tried.
#[derive(Clone)]
pub(super) struct Cells {
    /// 64 columns each, row by row.
    words: Vec<u64>,
    words_a_row: usize,
}

impl Cells {
    pub fn none(grid: Grid) -> Self {
        let words_a_row = grid.columns.div_ceil(64);
        Self {
            words: vec![0; words_a_row * grid.rows],
            words_a_row,
        }
    }

    fn place(&self, [column, row]: [usize; 2]) -> (usize, u64) {
        (row * self.words_a_row + column / 64, 1 << (column % 64))
    }

    pub fn insert(&mut self, cell: [usize; 2]) {
        let (word, bit) = self.place(cell);
        self.words[word] |= bit;
    }

    pub fn has(&self, cell: [usize; 2]) -> bool {
        let (word, bit) = self.place(cell);
        self.words[word] & bit != 0
    }

    /// These with all that are beside one.
    pub fn grown(&self) -> Self {
        let mut wide = self.words.clone();
        for (into, row) in
            (wide.chunks_mut(self.words_a_row)).zip(self.words.chunks(self.words_a_row))
        {
            for (at, into) in into.iter_mut().enumerate() {
                let before = if at > 0 { row[at - 1] >> 63 } else { 0 };
                let after = row.get(at + 1).map_or(0, |word| word << 63);
                *into |= row[at] << 1 | row[at] >> 1 | before | after;
            }
        }
        let mut words = wide.clone();
        let below = words.iter_mut().skip(self.words_a_row);
        below.zip(&wide).for_each(|(into, above)| *into |= above);
        let below = wide.iter().skip(self.words_a_row);
        words
            .iter_mut()
            .zip(below)
            .for_each(|(into, below)| *into |= below);
        Self { words, ..*self }
    }

    /// The middle of these, in cells, and how far they are spread round that; `None` of none.
    pub fn middle_and_spread(&self) -> Option<(Vec2, f32)> {
        let words = self.words.iter().enumerate();
        let cells = words.flat_map(|(at, word)| {
            let (row, first) = (at / self.words_a_row, at % self.words_a_row * 64);
            let columns = (0..64).filter(move |column| word >> column & 1 == 1);
            columns.map(move |column| Vec2::new((first + column) as f32, row as f32))
        });
        let count = self.count();
        let middle = cells.clone().sum::<Vec2>() / count as f32;
        let squares: f32 = cells.map(|cell| cell.distance_squared(middle)).sum();
        (count > 0).then(|| (middle, (squares / count as f32).sqrt()))
    }

    fn count(&self) -> u32 {
        self.words.iter().map(|word| word.count_ones()).sum()
    }

    fn count_outside(&self, other: &Self) -> u32 {
        let words = self.words.iter().zip(&other.words);
        words.map(|(own, other)| (own & !other).count_ones()).sum()
    }
}

/// Cells that a picture has something in, and these with all that are so many cells away at most, one after the other.
pub(super) struct Outline {
    cells: Cells,
    grown: Vec<Cells>,
}

impl Outline {
    pub fn new(cells: Cells) -> Self {
        let grown = std::iter::successors(Some(cells.grown()), |cells| Some(cells.grown()));
        Self {
            grown: grown.take(FARTHEST).collect(),
            cells,
        }
    }

    /// The cells that have something.
    pub fn cells(&self) -> &Cells {
        &self.cells
    }

    /// The mean distance in cells of this outline from the other one, and of that from this, as far as it is more than one.
    pub fn misfit(&self, other: &Cells) -> f32 {
        let mut off = 0;
        let mut grown_other = other.clone();
        for grown in &self.grown {
            grown_other = grown_other.grown();
            off += other.count_outside(grown) + self.cells.count_outside(&grown_other);
        }
        off as f32 / self.count_with(other)
    }

    /// The part of the cells of this outline and of the other one that one of them alone has.
    pub fn difference(&self, other: &Cells) -> f32 {
        let differ = other.count_outside(&self.cells) + self.cells.count_outside(other);
        differ as f32 / self.count_with(other)
    }

    fn count_with(&self, other: &Cells) -> f32 {
        (self.cells.count() + other.count()).max(1) as f32
    }

    /// How many cells of this outline and of the other one are more than so many away from the other, [`FARTHEST`] at most.
    pub fn count_away(&self, other: &Cells, cells: usize) -> u32 {
        let grown_other = (0..cells).fold(other.clone(), |grown, _| grown.grown());
        let grown = cells
            .checked_sub(1)
            .map_or(&self.cells, |last| &self.grown[last]);
        other.count_outside(grown) + self.cells.count_outside(&grown_other)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A picture of two words of columns and a few rows.
    fn grid() -> Grid {
        Grid::new(1, (100, 20))
    }

    fn square(left: usize, top: usize) -> Cells {
        let mut cells = Cells::none(grid());
        for row in top..top + 5 {
            (left..left + 5).for_each(|column| cells.insert([column, row]));
        }
        cells
    }

    #[test]
    fn cells_grow_over_the_columns_of_a_word_and_not_out_of_the_picture() {
        for cell in [[63, 5], [64, 5], [0, 0], [99, 19]] {
            let mut cells = Cells::none(grid());
            cells.insert(cell);
            let grown = cells.grown();
            let [column, row] = cell;
            for y in 0..20_usize {
                for x in 0..100_usize {
                    let is_near = x.abs_diff(column) <= 1 && y.abs_diff(row) <= 1;
                    assert_eq!(grown.has([x, y]), is_near, "{cell:?} {x} {y}");
                }
            }
        }
    }

    #[test]
    fn cells_are_spread_round_their_middle() {
        let (middle, spread) = square(60, 5).middle_and_spread().unwrap();
        assert_eq!(middle, Vec2::new(62.0, 7.0));
        assert_eq!(spread, 2.0);
        assert_eq!(Cells::none(grid()).middle_and_spread(), None);
    }

    #[test]
    fn outlines_are_farther_apart_the_farther_they_are_moved_but_for_one_cell() {
        let outline = Outline::new(square(60, 5));
        let misfits = [0, 1, 3, 6].map(|moved| outline.misfit(&square(60 + moved, 5)));
        assert_eq!(misfits[..2], [0.0, 0.0]);
        assert!(
            misfits.is_sorted() && misfits[1] < misfits[2],
            "{misfits:?}"
        );
        assert_eq!(outline.misfit(&square(60, 5)), 0.0);
        assert!(outline.misfit(&square(61, 11)) > misfits[2]);
        // Of a square of five cells that was moved by three, one column of either is away by three.
        let away = [0, 2, 3].map(|cells| outline.count_away(&square(63, 5), cells));
        assert_eq!(away, [30, 10, 0]);
    }
}
