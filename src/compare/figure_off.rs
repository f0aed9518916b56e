//! Which pixels differ of what is drawn, but for edges and lines.

use super::Area;
use super::PixelGrid;
use super::differences::difference;
use super::exactly_same::ExactlySame;
use super::pair::Pair;
use crate::steps::Pace;

/// Share of a figure that may differ so in the smallest places, which are passed over: in one that is right a thousandth does,
/// and a forearm that is turned a little is more than a hundredth.
const LITTLE: f64 = 0.002;
/// Pixels from one that stands for those around it to the next, …
const APART: u32 = 3;
/// … of figures that are larger than so many: of smaller ones each stands for itself.
const SMALL: usize = 6000;
/// Most pixels that stand for others, about: of still larger figures they are further apart.
const MOST: usize = 30_000;

/// What differs of a figure between two pictures A and B of one size.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FigureOff {
    /// The area round it.
    pub area: Area,
    /// Some of the pixels `(x, y)` that are off of the figure in B, which are spread evenly.
    pub ours: Vec<[u32; 2]>,
    /// The same of the figure in A.
    pub theirs: Vec<[u32; 2]>,
    /// Pixels that are off of the figure in A and lie in edges and lines alone, which `theirs` leaves out; `None` where what
    /// is behind the figure has lines itself.
    pub thin: Option<Vec<[u32; 2]>>,
    /// Some of the pixels that are right in B, as of those that are off.
    pub right: Vec<[u32; 2]>,
    /// Some of the pixels that show the figure in A and in B, right or off, but for edges, lines and the smallest places.
    pub outlines: [Vec<[u32; 2]>; 2],
    /// How many pixels they are apart, along rows and columns, from the top left pixel on.
    pub apart: u32,
    /// Whether the figure is told from what is behind it. Otherwise all of the picture counts as the figure.
    pub has_outline: bool,
    /// Whether what is behind the figure, or what is right of it, is exactly the same in both, so that the camera is.
    pub is_camera_right: bool,
}

impl FigureOff {
    /// What is off, from the islands of A and of B that are, of figures that are so many pixels in both pictures together, from
    /// the pixels that are `right`, and from the islands that show figures; `None` if nothing worth the name is off.
    pub fn new(
        grid: PixelGrid,
        [theirs, ours]: [&[Vec<usize>]; 2],
        of_figures: usize,
        right: Vec<usize>,
        outlines: [&[Vec<usize>]; 2],
        has_outline: bool,
        is_camera_right: bool,
    ) -> Option<Self> {
        let mut sizes: Vec<usize> = ours.iter().chain(theirs).map(Vec::len).collect();
        sizes.sort_unstable();
        let mut passed_over = 0;
        let least = sizes.into_iter().find(|size| {
            passed_over += size;
            passed_over as f64 > LITTLE * of_figures as f64
        })?;
        let told = |islands: &[Vec<usize>], least: usize| -> Vec<usize> {
            let told = islands.iter().filter(|island| island.len() >= least);
            told.flatten().copied().collect()
        };
        let outlines = outlines.map(|islands| {
            let count: usize = islands.iter().map(Vec::len).sum();
            told(islands, (LITTLE * count as f64) as usize + 1)
        });
        let [ours, theirs] = [ours, theirs].map(|islands| told(islands, least));
        let count = ours.len() + theirs.len() + right.len();
        let apart = match count {
            ..=SMALL => 1,
            _ => (count.div_ceil(MOST).isqrt() as u32).max(APART),
        };
        let spread = |places: Vec<usize>| grid.spread(places, apart);
        Some(Self {
            area: grid.area_around(ours.iter().chain(&theirs).copied())?,
            ours: spread(ours),
            theirs: spread(theirs),
            thin: None,
            right: spread(right),
            outlines: outlines.map(spread),
            apart,
            has_outline,
            is_camera_right,
        })
    }
}

impl Pair<'_> {
    /// What is off of what is drawn; `None` if the pictures agree but for edges and lines.
    pub(super) async fn paced_figure_off(&self, pace: &Pace) -> Option<FigureOff> {
        let grid = self.grid();
        let (a, b) = (self.a(), self.b());
        let count = self.kept().len();
        let mut off = [vec![false; count], vec![false; count]];
        let mut figures = off.clone();
        let mut right = vec![false; count];
        let mut of_figures = 0;
        pace.bands(count, |band| {
            for at in band.filter(|&at| self.kept()[at]) {
                let drawn = self.figures_at(at);
                let differs = difference(a[at], b[at]) > self.drawn_above();
                for ((off, figure), drawn) in off.iter_mut().zip(&mut figures).zip(drawn) {
                    off[at] = drawn && differs;
                    figure[at] = drawn;
                    of_figures += usize::from(drawn);
                }
                right[at] = drawn == [true; 2] && !differs;
            }
        })
        .await;
        let mut islands = Vec::new();
        for off in &off {
            islands.push(grid.paced_islands(off, pace).await);
        }
        if islands.iter().all(Vec::is_empty) {
            return None;
        }
        let has_outline = self.has_figures();
        if self.backgrounds().contains(&None) {
            // However large the picture is about the figure, or of this program's own ones, in which what is right is equal.
            of_figures = islands.iter().flatten().map(Vec::len).sum();
        }
        let mut solid = Vec::new();
        let mut same = ExactlySame::default();
        pace.bands(count, |band| {
            let is_solid = |at: &usize| right[*at] && grid.is_solid(*at, |at| right[at]);
            for at in band.filter(is_solid) {
                solid.push(at);
                // What has one color has it from wherever it is seen, and an upright line, as of an axis, has it from all around.
                if grid.around(at).any(|near| a[near] != a[at]) {
                    same.count(grid.pixel(at), [a[at], b[at]]);
                }
            }
        })
        .await;
        let mut outlines = Vec::new();
        for figure in &figures {
            outlines.push(grid.paced_islands(figure, pace).await);
        }
        let found = FigureOff::new(
            grid,
            [&islands[0], &islands[1]],
            of_figures,
            solid,
            [&outlines[0], &outlines[1]],
            has_outline,
            same.tells_of_camera(),
        )?;
        // Lines of the ground are none of the figure.
        let is_known = self.backgrounds().iter().all(Option::is_some);
        let thin = is_known.then(|| {
            let [mut thin, _] = off;
            for &at in islands[0].iter().flatten() {
                thin[at] = false;
            }
            let thin: Vec<usize> = (0..count).filter(|&at| thin[at]).collect();
            let step = thin.len().div_ceil(MOST).max(1);
            let some = thin.into_iter().step_by(step);
            some.map(|at| grid.pixel(at)).collect()
        });
        Some(FigureOff { thin, ..found })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compare::test_pictures::from_gray;
    use crate::steps::at_once;

    #[test]
    fn outlines_have_all_that_is_drawn_whatever_differs() {
        let picture = |figure: std::ops::Range<usize>, is_checkered: bool| {
            let gray = (0..120 * 120).map(|at| {
                let (x, y) = (at % 120, at / 120);
                match figure.contains(&x) && figure.contains(&y) {
                    true if is_checkered && (x + y) % 2 == 0 => 160,
                    true => 100,
                    false => 0,
                }
            });
            from_gray(120, &gray.collect::<Vec<u8>>())
        };
        // Of the smaller one, before the larger one, every second pixel differs.
        let (a, b) = (picture(40..60, true), picture(20..110, false));
        let pair = Pair::new(&a, &b, &[]).unwrap();
        let found = at_once(|pace| async move { pair.paced_figure_off(&pace).await });
        let FigureOff {
            outlines, apart, ..
        } = found.unwrap();
        for (outline, figure) in outlines.iter().zip([40..60, 20..110]) {
            let inside = figure.start + 1..figure.end - 1;
            let along = inside.filter(|at| (*at as u32).is_multiple_of(apart));
            assert_eq!(outline.len(), along.clone().count().pow(2));
            let is_inside = |at: u32| along.clone().any(|inside| inside as u32 == at);
            assert!(outline.iter().flatten().all(|&at| is_inside(at)));
        }
    }

    #[test]
    fn an_upright_line_is_the_same_from_all_around_and_makes_no_camera_right() {
        let picture = |figure: usize| {
            let gray = (0..120 * 90).map(|at| match (at % 120, at / 120) {
                (60..=61, _) => 200,
                (x, y) if (figure..figure + 30).contains(&x) && (30..60).contains(&y) => {
                    90 + x as u8
                }
                _ => 0,
            });
            from_gray(120, &gray.collect::<Vec<u8>>())
        };
        let off = |a: usize, b: usize| {
            let (a, b) = (picture(a), picture(b));
            let pair = Pair::new(&a, &b, &[]).unwrap();
            let found = at_once(|pace| async move { pair.paced_figure_off(&pace).await });
            found.map(|off| off.is_camera_right)
        };
        assert_eq!(off(5, 80), Some(false));
        assert_eq!(off(5, 5), None);
    }
}
