//! Another camera, from which all that is drawn is where the other picture has it.

use crate::compare::FigureOff;
use crate::editor::Session;
use crate::scene::{Camera, EvaluatedShape};
use glam::{IVec3, Vec2, Vec3};
use std::collections::HashSet;

/// Most columns and rows that pictures are looked at in.
const CELLS: u32 = 300;
/// Most points of surfaces that are followed.
const POINTS: usize = 15_000;
/// How much farther apart they are where they are too many.
const SPARSER: f32 = 1.5;
/// Distance in cells from which on outlines are apart, however far: shadows are far from what throws them.
const FARTHEST: usize = 8;
/// Mean distance that is told, in cells: of a small figure that was turned by 8 degrees it was 0.013.
const LEAST: f32 = 0.01;
/// How much more than of the live view itself may be left of the other picture where the right camera shows it, in parts, and in
/// cells: at most 1.26 times as much was, and 12 times of a limb, a shape that was moved and one of another color.
const LIKE_ITSELF: f32 = 1.25;
const ROUNDING: f32 = 0.005;
/// Another camera leaves at most one in so many of what differs without it. What limbs leave that are turned, no camera does.
const LEFT_ONE_IN: f32 = 4.0;
/// Directions that are tried first, in degrees to either side, and above and below.
const AROUND: [f32; 13] = [
    0.0, 7.0, -7.0, 14.0, -14.0, 21.0, -21.0, 28.0, -28.0, 35.0, -35.0, 42.0, -42.0,
];
const ABOVE: [f32; 5] = [0.0, 9.0, -9.0, 18.0, -18.0];
/// How many of them the search goes on from.
const STARTS: usize = 3;
/// Steps of the search at first, in degrees, and by the distance of the eye; and the part of them at which it ends.
const STEP: f32 = 4.0;
const NEARER: f32 = 0.06;
const ASIDE: f32 = 0.03;
const LAST: f32 = 1.0 / 16.0;
/// Turns, and changes of the distance in percent, that are told.
const TOLD_DEGREES: f32 = 2.5;
const TOLD_DISTANCE: f32 = 2.0;
/// What outlines may leave where the camera is exact enough to be told with numbers: where a figure's shadow made it 0.14, 14
/// degrees were found as 19.
const EXACT: f32 = 0.05;
/// How much more is told where it is not.
const ROUGHLY: f32 = 2.0;

/// How the other picture's camera differs, in words, if all that is drawn in a live view of `size` pixels is where that picture
/// has it when it is seen from there; `None` if no camera nearby shows it so, or the live view's own does.
pub(super) fn other_camera(session: &Session, off: &FigureOff, size: (u32, u32)) -> Option<String> {
    if !off.has_outline {
        return None;
    }
    let grid = Grid::new(off.apart, size);
    let surface = Surface::new(session, grid)?;
    let here = session.view().camera;
    let still = surface.covered(&here);
    // Of what agrees, lines of the ground are none of the shapes.
    let near = still.grown();
    let right = off
        .right
        .iter()
        .filter(|pixel| near.has(grid.cell(**pixel)));
    let theirs = Outline::new(grid.covered(off.theirs.iter().chain(right.clone())));
    let ours = Outline::new(grid.covered(off.ours.iter().chain(right)));
    // Shadows and the lines of the ground are in both pictures, and no camera explains them.
    let of_itself = ours.misfit(&still);
    let before = theirs.misfit(&still);
    let misfit = |camera: &Camera| theirs.misfit(&surface.covered(camera));
    let (after, there) = search(here, misfit);
    let is_same = after <= LIKE_ITSELF * of_itself + ROUNDING;
    let [before, after] = [before, after].map(|all| (all - of_itself).max(0.0));
    let is_found = is_same && before >= LEAST && after * LEFT_ONE_IN <= before;
    let is_exact = of_itself.max(after) <= EXACT;
    is_found.then(|| in_words(&here, &there, is_exact))?
}

/// The camera with the least misfit that is found from one, with that.
fn search(from: Camera, misfit: impl Fn(&Camera) -> f32) -> (f32, Camera) {
    let rated = |camera: Camera| (misfit(&camera), camera);
    let directions = AROUND
        .into_iter()
        .flat_map(|theta| ABOVE.map(|phi| [theta, phi]));
    let mut starts: Vec<(f32, Camera)> = directions
        .map(|[theta, phi]| rated(moved(from, [theta, phi, 0.0, 0.0, 0.0])))
        .collect();
    starts.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    starts.truncate(STARTS);
    let found = starts.into_iter().map(|mut best| {
        let mut part = 1.0;
        while part > LAST {
            let steps = [STEP, STEP, NEARER, ASIDE, ASIDE].map(|step| part * step);
            let tried = (0..steps.len()).flat_map(|along| {
                [-1.0, 1.0].map(|way| {
                    let mut by = [0.0; 5];
                    by[along] = way * steps[along];
                    rated(moved(best.1, by))
                })
            });
            match tried.min_by(|(a, _), (b, _)| a.total_cmp(b)) {
                Some(better) if better.0 < best.0 => best = better,
                _ => part *= 0.5,
            }
        }
        best
    });
    found
        .min_by(|(a, _), (b, _)| a.total_cmp(b))
        .unwrap_or((f32::INFINITY, from))
}

/// A camera that is turned about its target by these degrees, to the left and up, is so many times farther away by the power of
/// *e*, and looks so much farther to the right and up, by its distance.
fn moved(camera: Camera, [theta, phi, farther, right, up]: [f32; 5]) -> Camera {
    let aside = right * camera.right() + up * camera.up();
    Camera {
        theta: camera.theta + theta.to_radians(),
        phi: camera.phi + phi.to_radians(),
        radius: camera.radius * farther.exp(),
        target: camera.target + camera.radius * aside,
        ..camera
    }
}

/// How a camera differs from the one that is here, with how far if that `is_exact`; `None` if it is only moved to a side.
fn in_words(here: &Camera, there: &Camera, is_exact: bool) -> Option<String> {
    let least = if is_exact { 1.0 } else { ROUGHLY };
    let told = |by: f32, least_told: f32, unit: &str, [more, less]: [&str; 2]| {
        let way = if by > 0.0 { more } else { less };
        let far = match is_exact {
            true => format!("{:.0}{unit} {way}", by.abs()),
            false => way.to_owned(),
        };
        (by.abs() >= least * least_told).then_some(far)
    };
    let degrees = |by: f32, ways: [&str; 2]| told(by.to_degrees(), TOLD_DEGREES, "°", ways);
    let farther = 100.0 * (there.radius / here.radius - 1.0);
    let differs = [
        degrees(
            there.theta - here.theta,
            ["farther to the left", "farther to the right"],
        ),
        degrees(there.phi - here.phi, ["farther up", "farther down"]),
        told(farther, TOLD_DISTANCE, " %", ["farther away", "nearer"]),
    ];
    let differs: Vec<String> = differs.into_iter().flatten().collect();
    let about = if is_exact { "about " } else { "" };
    (!differs.is_empty()).then(|| format!("{about}{}", differs.join(", ")))
}

/// Cells of a picture: squares of pixels.
#[derive(Clone, Copy)]
struct Grid {
    /// Size of the picture in pixels.
    size: Vec2,
    /// Pixels along a cell.
    step: u32,
    columns: usize,
    rows: usize,
}

impl Grid {
    /// Those of a picture of which pixels are known that are `apart`.
    fn new(apart: u32, (width, height): (u32, u32)) -> Self {
        let apart = apart.max(1);
        let step = apart * (width.max(height)).div_ceil(CELLS * apart).max(1);
        Self {
            size: Vec2::new(width as f32, height as f32),
            step,
            columns: width.div_ceil(step) as usize,
            rows: height.div_ceil(step) as usize,
        }
    }

    /// Column and row of the cell that a pixel is in.
    fn cell(self, pixel: [u32; 2]) -> [usize; 2] {
        pixel.map(|along| (along / self.step) as usize)
    }

    /// The cells that pixels are in.
    fn covered<'p>(self, pixels: impl Iterator<Item = &'p [u32; 2]>) -> Cells {
        let mut covered = Cells::none(self);
        pixels.for_each(|pixel| covered.insert(self.cell(*pixel)));
        covered
    }
}

/// Some of the cells of a grid, as bits: many cameras are tried.
#[derive(Clone)]
struct Cells {
    /// 64 columns each, row by row.
    words: Vec<u64>,
    words_a_row: usize,
}

impl Cells {
    fn none(grid: Grid) -> Self {
        let words_a_row = grid.columns.div_ceil(64);
        Self {
            words: vec![0; words_a_row * grid.rows],
            words_a_row,
        }
    }

    fn place(&self, [column, row]: [usize; 2]) -> (usize, u64) {
        (row * self.words_a_row + column / 64, 1 << (column % 64))
    }

    fn insert(&mut self, cell: [usize; 2]) {
        let (word, bit) = self.place(cell);
        self.words[word] |= bit;
    }

    fn has(&self, cell: [usize; 2]) -> bool {
        let (word, bit) = self.place(cell);
        self.words[word] & bit != 0
    }

    /// These with all that are beside one.
    fn grown(&self) -> Self {
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

    fn count(&self) -> u32 {
        self.words.iter().map(|word| word.count_ones()).sum()
    }

    fn count_outside(&self, other: &Self) -> u32 {
        let words = self.words.iter().zip(&other.words);
        words.map(|(own, other)| (own & !other).count_ones()).sum()
    }
}

/// Cells that a picture has something in, and these with all that are so many cells away at most, one after the other.
struct Outline {
    cells: Cells,
    grown: Vec<Cells>,
}

impl Outline {
    fn new(cells: Cells) -> Self {
        let grown = std::iter::successors(Some(cells.grown()), |cells| Some(cells.grown()));
        Self {
            grown: grown.take(FARTHEST).collect(),
            cells,
        }
    }

    /// The mean distance in cells of this outline from the other one, and of that from this, as far as it is more than one.
    fn misfit(&self, other: &Cells) -> f32 {
        let mut off = 0;
        let mut grown_other = other.clone();
        for grown in &self.grown {
            grown_other = grown_other.grown();
            off += other.count_outside(grown) + self.cells.count_outside(&grown_other);
        }
        off as f32 / (self.cells.count() + other.count()).max(1) as f32
    }
}

/// Points of all visible surfaces, near enough to one another to be in every cell that these cover, or beside it.
struct Surface {
    grid: Grid,
    /// In the world.
    points: Vec<Vec3>,
}

impl Surface {
    /// `None` if nothing is before the camera.
    fn new(session: &Session, grid: Grid) -> Option<Self> {
        let camera = &session.view().camera;
        let shapes = session.evaluated().shapes.iter();
        let shapes: Vec<&EvaluatedShape> = shapes.filter(|shape| shape.visible).collect();
        let bounds = session.evaluated().world_bounds();
        let middle = 0.5 * (bounds.min + bounds.max);
        let of_pixel = camera.world_per_pixel(middle, grid.size.y)?;
        let mut apart = grid.step as f32 * of_pixel;
        loop {
            let mut points = Points::new(apart);
            let are_all = shapes.iter().all(|shape| points.add(shape));
            if are_all {
                let points = points.kept;
                return Some(Self { grid, points });
            }
            apart *= SPARSER;
        }
    }

    /// The cells that the surfaces are in as a camera sees them.
    fn covered(&self, camera: &Camera) -> Cells {
        let Grid { size, step, .. } = self.grid;
        let clip_from_world = camera.clip_from_world(size.x / size.y);
        let mut covered = Cells::none(self.grid);
        for point in &self.points {
            let clip = clip_from_world * point.extend(1.0);
            if clip.w <= 0.0 {
                continue;
            }
            let ndc = clip.truncate() / clip.w;
            // Pixels stand for those around them.
            let pixel = Vec2::new(ndc.x + 1.0, 1.0 - ndc.y) * 0.5 * size + 0.5 * step as f32;
            if pixel.cmpge(Vec2::ZERO).all() && pixel.cmplt(size).all() {
                covered.insert(self.grid.cell(pixel.as_uvec2().to_array()));
            }
        }
        covered
    }
}

/// Points of triangles in the world, one of those that are so near to one another.
struct Points {
    apart: f32,
    kept: Vec<Vec3>,
    known: HashSet<IVec3>,
}

impl Points {
    fn new(apart: f32) -> Self {
        Self {
            apart,
            kept: Vec::new(),
            known: HashSet::new(),
        }
    }

    /// Adds those of a shape; whether they are not too many.
    fn add(&mut self, shape: &EvaluatedShape) -> bool {
        let positions = shape.geometry.positions().iter();
        let positions: Vec<Vec3> = positions
            .map(|position| shape.world_from_model.transform_point3(*position))
            .collect();
        for corners in &shape.geometry.mesh.triangles {
            let [a, b, c] = corners.map(|corner| positions[corner as usize]);
            let longest = a.distance(b).max(b.distance(c)).max(c.distance(a));
            let steps = (longest / self.apart).ceil();
            if !steps.is_finite() || steps as usize > POINTS.isqrt() {
                return steps.is_nan();
            }
            let steps = steps.max(1.0) as u32;
            for along_b in 0..=steps {
                for along_c in 0..=steps - along_b {
                    let [to_b, to_c] = [along_b, along_c].map(|along| along as f32 / steps as f32);
                    let point = a + to_b * (b - a) + to_c * (c - a);
                    if self.known.insert((point / self.apart).round().as_ivec3()) {
                        self.kept.push(point);
                    }
                }
            }
            if self.kept.len() > POINTS {
                return false;
            }
        }
        true
    }
}
