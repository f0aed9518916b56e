//! Another camera, from which all that is drawn is where the other picture has it.

use super::cells::{Cells, Grid, Outline};
use super::clusters::in_areas;
use super::surface::Surface;
use crate::compare::FigureOff;
use crate::editor::Session;
use crate::scene::Camera;
use crate::ui::commands::homes;
use glam::{Mat3, Vec2, Vec3};
use std::collections::HashSet;

/// Mean distance in cells of the live view's own outline from where its surfaces are up to which these are what is drawn: it was
/// 0.016 at most, and 0.047 and more of a robot whose limbs are as thin as lines.
const KNOWN: f32 = 0.03;
/// Mean distance that is told, in cells: of a figure that was turned by 8 and 6 degrees it was 0.008.
const LEAST: f32 = 0.004;
/// Another camera leaves at most one in so many of what differs without it. What limbs leave that are turned, no camera does: of
/// a shoulder a camera left one in 3.4, and the right one beside an elbow that is turned as well one in 14.
const LEFT_ONE_IN: f32 = 7.0;
/// The same where no more is left of the other picture than of the live view itself, but for this part and so many cells.
const LEFT_LIKE_ITSELF: f32 = 4.0;
const LIKE_ITSELF: f32 = 1.25;
const ROUNDING: f32 = 0.005;
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
/// How much more one may leave without a turn that shows nothing, in cells.
const AS_GOOD: f32 = 0.004;
/// How much more one may leave to which Home leads: where nothing else differs, it was 0.0007 at most.
const HOME_LEAVES: f32 = 0.0015;
/// How many times as many cells may differ from there as from the best one that was found, whatever they leave:
/// limbs that are turned as well take the best one along. It was 1.02 at most there, and 1.17 and more where the camera was turned by
/// 8 and 4 degrees from Home.
const HOME_AS_GOOD: f32 = 1.08;
/// Most steps from one start.
const MOST_STEPS: usize = 60;
/// Turns, and changes of the distance in percent, that are told.
const TOLD_DEGREES: f32 = 2.5;
const TOLD_DISTANCE: f32 = 2.5;
/// How far beside, by its distance, another camera looks where that is told.
const TOLD_ASIDE: f32 = 0.03;
/// How much more is told where it is not exact.
const ROUGHLY: f32 = 2.0;
/// What outlines may leave where all that is drawn is explained, and the camera is exact enough to be told with numbers: it was 0.002
/// at most, and more where limbs were turned as well, 0.008 where a forearm was by 40 degrees and 0.014 where a leg was by 8.
const ALL: f32 = 0.005;
/// Distance in cells, farther away than which so many times as many cells are at most, and a few, as of the live view itself: where
/// limbs were turned as well there were up to 44 beside at most 3, and of cameras alone 11 beside 5.
const AWAY: usize = 2;
const MORE: u32 = 2;
const FEW: u32 = 2;

/// The other picture's camera.
pub(super) struct OtherCamera {
    /// How it differs, in words.
    pub told: String,
    /// Whether all that is drawn is where the other picture has it when it is seen from there, and not only most of it.
    pub explains_all: bool,
    /// How often Home is pressed that leads there, if it does.
    pub homes: Option<usize>,
}

/// How the other picture's camera differs, if what is drawn in a live view of `size` pixels is where that picture has it when it is
/// seen from there; `None` if no camera nearby shows it so, or the live view's own does.
pub(super) fn other_camera(
    session: &Session,
    off: &FigureOff,
    size: (u32, u32),
) -> Option<OtherCamera> {
    if !off.has_outline {
        return None;
    }
    let grid = Grid::new(off.apart, size);
    let surface = Surface::new(session, grid)?;
    let here = session.view().camera;
    let still = surface.covered(&here);
    // What both show elsewhere is ground, and none of the shapes.
    let near = still.grown();
    let outline = |own: &[[u32; 2]], other: &[[u32; 2]]| {
        let other: HashSet<&[u32; 2]> = other.iter().collect();
        let is_of_shapes =
            |pixel: &&[u32; 2]| !other.contains(pixel) || near.has(grid.cell(**pixel));
        let pixels = own.iter().filter(is_of_shapes).copied();
        // Where a ground is behind shapes, its lines are none of them.
        let pixels = match off.thin.is_some() {
            true => pixels.collect(),
            false => in_areas(pixels, off.apart),
        };
        Outline::new(grid.covered(pixels.into_iter()))
    };
    let [theirs, ours] = &off.outlines;
    let [theirs, ours] = [outline(theirs, ours), outline(ours, theirs)];
    // What is left of the ground and of shadows is in both pictures, and no camera explains it.
    let of_itself = ours.misfit(&still);
    if of_itself > KNOWN {
        return None;
    }
    let search = Search::new(&surface, &theirs, grid)?;
    let before = theirs.misfit(&still);
    let (after, there) = search.best(here)?;
    let is_same = after <= LIKE_ITSELF * of_itself + ROUNDING;
    let [own_before, own_after] = [before, after].map(|all| (all - of_itself).max(0.0));
    let left_one_in = if is_same {
        LEFT_LIKE_ITSELF
    } else {
        LEFT_ONE_IN
    };
    if own_before < LEAST || own_after * left_one_in > own_before {
        return None;
    }
    let (fewest, there) = search.finely(there);
    let is_as_good = |camera: &Camera, more: f32| search.misfit(camera) <= after + more;
    let is_good_home = |home: &Camera| {
        is_as_good(home, HOME_LEAVES) || search.difference(home) <= HOME_AS_GOOD * fewest
    };
    let mut homes = (1..).zip(homes(session));
    let home = homes.find(|(_, home)| *home != here && is_good_home(home));
    let there = match home {
        Some((_, home)) => home,
        None => unturned(there, here, |camera| is_as_good(camera, AS_GOOD)),
    };
    let is_exact = after <= ALL || home.is_some();
    let away = theirs.count_away(&surface.covered(&there), AWAY);
    let is_nothing_away = away <= MORE * ours.count_away(&still, AWAY) + FEW;
    Some(OtherCamera {
        told: in_words(&here, &there, is_exact)?,
        homes: home.map(|(presses, _)| presses),
        explains_all: (is_same || own_after <= ALL) && is_nothing_away,
    })
}

/// The search for a camera that shows surfaces where the other picture has what is drawn.
struct Search<'a> {
    surface: &'a Surface,
    theirs: &'a Outline,
    grid: Grid,
    /// The middle of the surfaces, in the world, about which cameras are turned.
    about: Vec3,
    /// The middle of what is drawn in the other picture, and how far that is spread, in cells.
    their_middle: Vec2,
    their_spread: f32,
}

impl<'a> Search<'a> {
    /// `None` if nothing is drawn in one of the pictures.
    fn new(surface: &'a Surface, theirs: &'a Outline, grid: Grid) -> Option<Self> {
        let (their_middle, their_spread) = theirs.cells().middle_and_spread()?;
        Some(Self {
            surface,
            theirs,
            grid,
            about: surface.middle()?,
            their_middle,
            their_spread,
        })
    }

    fn misfit(&self, camera: &Camera) -> f32 {
        self.theirs.misfit(&self.surface.covered(camera))
    }

    fn difference(&self, camera: &Camera) -> f32 {
        self.theirs.difference(&self.surface.covered(camera))
    }

    fn rated(&self, camera: Camera) -> (f32, Camera) {
        (self.misfit(&camera), camera)
    }

    /// The camera with the least misfit that is found from the one that is `here`, with that.
    fn best(&self, here: Camera) -> Option<(f32, Camera)> {
        let directions = AROUND
            .into_iter()
            .flat_map(|theta| ABOVE.map(|phi| [theta, phi]));
        let starts = directions.flat_map(|[theta, phi]| {
            let turned = moved(here, self.about, [theta, phi, 0.0, 0.0, 0.0]);
            let covered = self.surface.covered(&turned);
            let aligned = self.aligned(turned, &covered);
            let aligned = aligned.map(|aligned| self.rated(aligned));
            [Some((self.theirs.misfit(&covered), turned)), aligned]
        });
        let mut starts: Vec<(f32, Camera)> = starts.flatten().collect();
        starts.sort_by(|(a, _), (b, _)| a.total_cmp(b));
        starts.truncate(STARTS);
        let misfit = |camera: &Camera| self.misfit(camera);
        let found = starts.into_iter().map(|start| self.refined(start, misfit));
        found.min_by(|(a, _), (b, _)| a.total_cmp(b))
    }

    /// The camera that is so much farther away, and looks so far beside, that what one covers is about as large as the other picture
    /// has it, and where.
    fn aligned(&self, camera: Camera, covered: &Cells) -> Option<Camera> {
        let (middle, spread) = covered.middle_and_spread()?;
        let farther = spread / self.their_spread;
        let Grid { size, step, .. } = self.grid;
        let center = 0.5 * size / step as f32;
        let by = (self.their_middle - center) - (middle - center) / farther;
        // Of the whole height, at the distance of the target.
        let height = 2.0 * (0.5 * camera.fovy).tan() * farther;
        let aside = by * (height * step as f32 / size.y);
        let is_finite = farther.is_finite() && farther > 0.0 && aside.is_finite();
        let by = [0.0, 0.0, farther.ln(), -aside.x, aside.y];
        is_finite.then(|| moved(camera, self.about, by))
    }

    /// The best camera from which no step has a better rating, that is a lower one.
    fn refined(&self, mut best: (f32, Camera), rating: impl Fn(&Camera) -> f32) -> (f32, Camera) {
        let mut part = 1.0;
        for _ in 0..MOST_STEPS {
            if part <= LAST {
                break;
            }
            let steps = [STEP, STEP, NEARER, ASIDE, ASIDE].map(|step| part * step);
            let tried = (0..steps.len()).flat_map(|along| {
                [-1.0, 1.0].map(|way| {
                    let mut by = [0.0; 5];
                    by[along] = way * steps[along];
                    let moved = moved(best.1, self.about, by);
                    (rating(&moved), moved)
                })
            });
            match tried.min_by(|(a, _), (b, _)| a.total_cmp(b)) {
                Some(better) if better.0 < best.0 => best = better,
                _ => part *= 0.5,
            }
        }
        best
    }

    /// The camera from which still fewer cells differ than from one that is as good as any, with the part of those: from one degree to
    /// the next, outlines hardly move by a cell.
    fn finely(&self, camera: Camera) -> (f32, Camera) {
        let difference = |camera: &Camera| self.difference(camera);
        self.refined((difference(&camera), camera), difference)
    }
}

/// The camera without turns from the one that is `here` which show nothing, as round a goblet.
fn unturned(there: Camera, here: Camera, is_as_good: impl Fn(&Camera) -> bool) -> Camera {
    let without = [
        |camera: &mut Camera, here: &Camera| camera.theta = here.theta,
        |camera: &mut Camera, here: &Camera| camera.phi = here.phi,
    ];
    without.into_iter().fold(there, |camera, without_turn| {
        let mut unturned = camera;
        without_turn(&mut unturned, &here);
        if is_as_good(&unturned) {
            unturned
        } else {
            camera
        }
    })
}

/// A camera that is turned about a point by these degrees, to the left and up, is so many times farther away by the power of *e*, and
/// looks so much farther to the right and up, by its distance. Turned about its target, which may be far from what is drawn, it would
/// hardly show that.
fn moved(camera: Camera, about: Vec3, [theta, phi, farther, right, up]: [f32; 5]) -> Camera {
    let mut moved = camera;
    moved.orbit(Vec2::new(theta.to_radians(), phi.to_radians()));
    let axes = |of: &Camera| Mat3::from_cols(of.right(), of.up(), of.forward());
    let from_target = axes(&camera).transpose() * (about - camera.target);
    moved.target = about - axes(&moved) * from_target;
    moved.dolly(farther);
    moved.target += camera.radius * (right * camera.right() + up * camera.up());
    moved
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
    let mut differs: Vec<String> = differs.into_iter().flatten().collect();
    if differs.is_empty() {
        return None;
    }
    let aside = (there.target - here.target) / here.radius;
    let looks = |by: f32, [more, less]: [&str; 2]| {
        let way = if by > 0.0 { more } else { less };
        (by.abs() >= TOLD_ASIDE).then(|| format!("looking farther {way}"))
    };
    differs.extend(looks(aside.dot(there.right()), ["right", "left"]));
    differs.extend(looks(aside.dot(there.up()), ["up", "down"]));
    let about = if is_exact { "about " } else { "" };
    Some(format!("{about}{}", differs.join(", ")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_camera_is_told_by_its_turns_its_distance_and_where_it_looks() {
        let here = Camera::default();
        let told = |by, is_exact| in_words(&here, &moved(here, here.target, by), is_exact);
        let exact = |by| told(by, true);
        assert_eq!(exact([0.0; 5]), None);
        assert_eq!(exact([0.0, 0.0, 0.0, 0.2, 0.0]), None, "only moved");
        let turned = [12.0, -5.0, 0.0, 0.0, 0.0];
        assert_eq!(
            exact(turned).unwrap(),
            "about 12° farther to the left, 5° farther down"
        );
        assert_eq!(
            exact([-8.0, 1.0, 0.1, 0.0, 0.1]).unwrap(),
            "about 8° farther to the right, 11 % farther away, looking farther up"
        );
        // Roughly, only what is much.
        assert_eq!(
            told(turned, false).unwrap(),
            "farther to the left, farther down"
        );
        assert_eq!(
            told([12.0, -4.0, 0.0, 0.0, 0.0], false).unwrap(),
            "farther to the left"
        );
    }
}
