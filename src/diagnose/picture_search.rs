//! The search for the mistakes that give a silhouette.

use super::formula::{Formula, VertexOrder};
use super::model::Model;
use super::search::Explanation;
use super::silhouette::{Samples, Silhouette};
use super::skin::Skinner;
use super::turned_camera;
use super::ways::{Made, formula, pairs_of_ways, ways};
use crate::character::Pose;
use crate::geometry::Picture;
use glam::{DMat4, DVec3};

/// Vertices that are looked at first are about this many, from all over the mesh.
const SPREAD: usize = 256;
/// Part of them that may lie beside what is drawn: parts may be too small or too dark to be found there.
const BESIDE: f64 = 0.05;
/// Pictures are looked at in no more columns and rows than this, …
const FINE: u32 = 400;
/// … and in no more than this to see which mistakes may fit.
const COARSE: u32 = 100;
/// Columns and rows in which small figures are looked at: in fewer, their limbs would be as thin as lines.
const OF_FIGURE: u32 = 200;
/// Samples of a picture of a small figure, at most.
const MOST_SAMPLES: u64 = 1 << 20;
/// Part of the coarse silhouette that may be off where mistakes may fit: at that size, limbs are as wide
/// as what counts as a line.
const MAY_FIT: f64 = 0.05;
/// Inner area of a silhouette, by that of the exact one, below which it says nothing.
const SCATTERED: f64 = 0.005;
/// Area of a coarse silhouette, in samples, below which it says nothing: what may be off is one sample.
const TELLING: f64 = 1.0 / MAY_FIT;

/// What is looked at closely.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Closeness {
    /// The figure: of a small one limbs are seen, and so are lines that are drawn beside it.
    Figure,
    /// The picture.
    Picture,
}

/// A picture, and what it is held against.
#[derive(Debug)]
pub(super) struct PictureSearch<'a> {
    model: &'a Model<'a>,
    pose: &'a Pose,
    clip_from_model: DMat4,
    fine: Seen,
    coarse: Seen,
    /// The picture as closely as a small figure is looked at, where `fine` is not that.
    closer: Option<Seen>,
    /// Some of the vertices of triangles.
    spread: Vec<usize>,
    /// Which part of the silhouette is off from the exact one.
    pub(super) error_from_exact: f64,
    /// Whether hardly anything is drawn but lines and specks, with which an empty picture would agree.
    pub(super) is_scattered: bool,
    /// Whether what is off from the exact silhouette is missing from the picture, and nothing is there beside it.
    pub(super) only_lacks: bool,
    /// The box around what is off from the exact silhouette, as the pixels x, y, width and height.
    pub(super) off_within: Option<[u32; 4]>,
}

/// The picture at one resolution.
#[derive(Debug)]
struct Seen {
    samples: Samples,
    theirs: Silhouette,
    /// Area of the picture's silhouette and the exact one together.
    area: f64,
}

impl<'a> PictureSearch<'a> {
    /// A search for what gives `picture`, which shows the model with `clip_from_model`, where what differs from the
    /// background by more than `noise` is drawn; `None` if nothing is, and where the figure is so large that it is looked at
    /// no more closely than the picture.
    pub(super) fn new(
        model: &'a Model<'a>,
        pose: &'a Pose,
        picture: &Picture,
        clip_from_model: DMat4,
        (noise, closeness): (u8, Closeness),
    ) -> Option<Self> {
        let points = points(&mut Skinner::new(model, pose, &Formula::default()));
        let of_picture = |most| Samples::new(picture.width, picture.height, most);
        let seen = |samples: Samples| {
            let theirs = Silhouette::of_picture(picture, samples, noise);
            let exact = Silhouette::of_mesh(&points, model.triangles(), clip_from_model, samples);
            let area = theirs.area_with(&exact) as f64;
            let seen = Seen {
                samples,
                theirs,
                area,
            };
            (seen, exact)
        };
        let all = of_picture(FINE);
        let pixels = u64::from(picture.width) * u64::from(picture.height);
        let least = (pixels.div_ceil(MOST_SAMPLES) as f64).sqrt().ceil() as u32;
        let extent = all.extent(&points, clip_from_model);
        let closer = all.with_step(extent.div_ceil(OF_FIGURE).max(least));
        let closer = Some(closer).filter(|closer| closer.step < all.step);
        let ((fine, exact), closer) = match closeness {
            Closeness::Picture => (seen(all), closer.map(seen)),
            Closeness::Figure => (seen(closer?), None),
        };
        if fine.theirs.is_blank() {
            return None;
        }
        let lacking = closer.as_ref().map(|(seen, exact)| seen.lacking(exact));
        let (closest, exact_there) = closer
            .as_ref()
            .map_or((&fine, &exact), |(seen, exact)| (seen, exact));
        let off_within = exact.bounds(fine.theirs.off(&exact));
        let off_within =
            off_within.or_else(|| exact_there.bounds(closest.theirs.lacking(exact_there)));
        let (coarse, _) = seen(of_picture(COARSE));
        let corners = model.triangles().as_flattened().iter();
        let mut vertices: Vec<usize> = corners.map(|&corner| corner as usize).collect();
        vertices.sort_unstable();
        vertices.dedup();
        let step = vertices.len().div_ceil(SPREAD).max(1);
        Some(Self {
            model,
            pose,
            clip_from_model,
            error_from_exact: fine.error(&exact).max(lacking.unwrap_or(0.0)),
            is_scattered: (fine.theirs.inner_area() as f64) < SCATTERED * exact.inner_area() as f64,
            only_lacks: closest.theirs.only_lacks(exact_there),
            off_within,
            fine,
            coarse,
            closer: closer.map(|(seen, _)| seen),
            spread: vertices.into_iter().step_by(step).collect(),
        })
    }

    /// Every mistake by itself, with what it leaves.
    pub(super) fn singles(&self) -> Vec<Explanation> {
        let seen = ways().map(|made| (made, formula(&[made])));
        let seen = seen.filter(|(_, formula)| self.is_seen(formula));
        seen.map(|(made, formula)| {
            let points = points(&mut self.skinner(&formula));
            Explanation {
                made: vec![made],
                error: self.fine_error(&points),
                how: None,
            }
        })
        .collect()
    }

    /// Those of `ways` to make a mistake that leave no more than `enough` by themselves.
    pub(super) fn within(&self, enough: f64, ways: impl Iterator<Item = Made>) -> Vec<Explanation> {
        let made = ways.map(|made| (made, formula(&[made])));
        let seen = made.filter(|(_, formula)| self.is_seen(formula));
        let seen = seen.filter_map(|(made, formula)| {
            let error = self.error_if_small(&formula)?;
            (error <= enough).then_some(Explanation {
                made: vec![made],
                error,
                how: None,
            })
        });
        seen.collect()
    }

    /// Every two mistakes that leave no more than `enough`, the one that leaves less by itself first.
    pub(super) fn pairs(&self, singles: &[Explanation], enough: f64) -> Vec<Explanation> {
        let alone = |made: Made| {
            let mut singles = singles.iter();
            let one = singles.find(|one| std::ptr::eq(one.made[0].reading, made.reading));
            one.map_or(f64::INFINITY, |one| one.error)
        };
        let seen = pairs_of_ways().filter(|(.., formula)| self.is_seen(formula));
        seen.filter_map(|(first, second, formula)| {
            let error = self.error_if_small(&formula)?;
            let mut made = vec![first, second];
            if alone(second) < alone(first) {
                made.reverse();
            }
            (error <= enough).then_some(Explanation {
                made,
                error,
                how: None,
            })
        })
        .collect()
    }

    /// What `formula` leaves, unless a look at some vertices or from afar tells that it is much.
    fn error_if_small(&self, formula: &Formula) -> Option<f64> {
        let mut skinner = self.skinner(formula);
        let most = (BESIDE * self.spread.len() as f64) as usize;
        // Many that are drawn to one place are the tip of one spike there, which may be thinner than a pixel.
        let mut beside: Vec<DVec3> = Vec::new();
        for &vertex in &self.spread {
            let placed = skinner.place(vertex);
            let clip = self.clip_from_model * placed.at.extend(1.0);
            let is_beside = !placed.is_unweighted && self.fine.theirs.is_near(clip) == Some(false);
            if is_beside && !beside.contains(&placed.at) {
                beside.push(placed.at);
                if beside.len() > most {
                    return None;
                }
            }
        }
        let points = points(&mut skinner);
        let may_fit = self.coarse.area < TELLING
            || self.error(&points, &self.coarse, self.clip_from_model) <= MAY_FIT;
        may_fit.then(|| self.fine_error(&points))
    }

    /// Whether a mistake may be seen in a picture, which is the same whatever the order in which vertices are
    /// kept.
    fn is_seen(&self, formula: &Formula) -> bool {
        let orders = [VertexOrder::File, VertexOrder::FirstUseInside];
        orders.contains(&formula.vertex_order)
            && formula.is_of(self.model.character)
            && formula.is_of_pose(self.pose, self.model.skeleton().roots())
    }

    fn skinner(&self, formula: &Formula) -> Skinner<'a> {
        Skinner::new(self.model, self.pose, formula)
    }

    /// The part of the silhouette that is off from the one of `points` as closely as is looked.
    fn fine_error(&self, points: &[DVec3]) -> f64 {
        self.fine_error_seen_with(points, self.clip_from_model)
    }

    /// The same where these are seen with `clip_from_model`.
    fn fine_error_seen_with(&self, points: &[DVec3], clip_from_model: DMat4) -> f64 {
        let error = self.error(points, &self.fine, clip_from_model);
        match &self.closer {
            Some(closer) if error <= MAY_FIT => {
                error.max(closer.lacking(&self.made(points, closer, clip_from_model)))
            }
            _ => error,
        }
    }

    /// The part of the silhouette that is off from the one of `points`.
    fn error(&self, points: &[DVec3], seen: &Seen, clip_from_model: DMat4) -> f64 {
        seen.error(&self.made(points, seen, clip_from_model))
    }

    fn made(&self, points: &[DVec3], seen: &Seen, clip_from_model: DMat4) -> Silhouette {
        Silhouette::of_mesh(
            points,
            self.model.triangles(),
            clip_from_model,
            seen.samples,
        )
    }

    /// Whether a camera that is turned a little shows the exact figure in the picture, but for the part `enough` of the silhouette.
    pub(super) fn is_of_turned_camera(&self, enough: f64) -> bool {
        let points = points(&mut self.skinner(&Formula::default()));
        let mut cameras = turned_camera::turned(self.clip_from_model, &points);
        cameras.any(|camera| self.fine_error_seen_with(&points, camera) <= enough)
    }
}

impl Seen {
    /// The part of the silhouette that is off from `made`.
    fn error(&self, made: &Silhouette) -> f64 {
        self.theirs.off(made).count() as f64 / self.area
    }

    /// The part of it that limbs are of `made` which are missing.
    fn lacking(&self, made: &Silhouette) -> f64 {
        self.theirs.lacking(made).count() as f64 / self.area
    }
}

/// Where the vertices of a mesh are.
pub(super) fn points(skinner: &mut Skinner) -> Vec<DVec3> {
    let all = 0..skinner.count();
    all.map(|at| skinner.place(at).at).collect()
}
