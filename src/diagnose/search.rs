//! The search for the mistakes that give a mesh.

use super::MUCH_NEARER;
use super::diagnosis::ToldMistake;
use super::formula::{Formula, VertexOrder};
use super::found_otherwise::{ANGLES_SCALED, VERTEX_WITHOUT_W};
use super::model::Model;
use super::skin::{CutOff, Metric, Placed, Skinner};
use super::ways::{
    Made, formula, pairs_of_ways, pairs_with_whole_program, ways, ways_of_whole_program,
};
use crate::character::Pose;
use crate::steps::Pace;
use glam::DVec3;

/// Vertices that are looked at first are this many of those farthest off, …
const WORST: usize = 64;
/// … and about this many from all over the mesh.
const SPREAD: usize = 512;

/// Vertices after which the work may rest.
pub(super) const AT_ONCE: usize = 1 << 10;
/// Work of trying a formula, as that of so many vertices a joint.
const A_JOINT: usize = 4;

/// A mesh, and what it is held against.
#[derive(Debug)]
pub(super) struct Search<'a> {
    pub(super) model: &'a Model<'a>,
    pub(super) pose: &'a Pose,
    pub(super) theirs: &'a [DVec3],
    /// How far apart vertices may be and still agree.
    pub(super) tolerance: f64,
    metric: Metric,
    /// The largest coordinate, but for vertices far outside, which agree as far as their own coordinates are exact.
    largest: f64,
    /// Vertices that tell formulas apart, those that tell most first, and then those from all over.
    pub(super) sample: Vec<usize>,
}

/// Mistakes that together give a mesh or a silhouette.
#[derive(Clone, Debug)]
pub(super) struct Explanation {
    pub(super) made: Vec<Made>,
    /// What is left: the largest distance, or the part of the silhouette that is off.
    pub(super) error: f64,
    /// What is special about the one with numbers from the mesh, if there is one.
    pub(super) how: Option<String>,
}

impl Explanation {
    pub(super) fn ids(&self) -> Vec<&'static str> {
        self.made.iter().map(|made| made.mistake.id).collect()
    }

    /// How many of the mistakes are made in a way that programs hardly have.
    pub(super) fn rare(&self) -> usize {
        self.made.iter().filter(|made| made.reading.is_rare).count()
    }

    /// The same beside that vertices are in `order`, if that is not the file's.
    pub(super) fn of_order(mut self, order: VertexOrder) -> Self {
        let in_order = |made: &Made| formula(&[*made]).vertex_order == order;
        let renumbered = (order != VertexOrder::File).then(|| ways().find(in_order));
        self.made.splice(..0, renumbered.flatten());
        self
    }

    /// The same with [`VERTEX_WITHOUT_W`] in the place of the mistake that always gives the same mesh, if that is in it.
    pub(super) fn without_w(&self) -> Option<Self> {
        let mistake = &VERTEX_WITHOUT_W;
        let mut without_w = mistake
            .readings
            .iter()
            .map(|reading| Made { mistake, reading });
        let (place, same) = without_w.find_map(|without_w| {
            let gives = formula(&[without_w]);
            let mut made = self.made.iter();
            let place = made.position(|made| formula(&[*made]) == gives)?;
            Some((place, without_w))
        })?;
        let mut other = self.clone();
        other.made[place] = same;
        Some(other)
    }

    /// The mistakes in words.
    pub(super) fn told(&self) -> Vec<ToldMistake> {
        let told = |made: &Made| {
            let mut told = ToldMistake::new(*made);
            if let Some(how) = self.how.as_ref().filter(|_| made.is_by_numbers()) {
                told.how = how.clone().into();
            }
            told
        };
        self.made.iter().map(told).collect()
    }
}

/// A single mistake, and how near the mesh is to the one that it gives.
#[derive(Clone, Copy, Debug)]
pub(super) struct Alone {
    pub(super) made: Made,
    pub(super) nearness: Nearness,
}

/// How near two meshes are, as far as a sample from all over tells.
#[derive(Clone, Copy, Debug)]
pub(super) struct Nearness {
    /// Mean distance.
    pub(super) mean: f64,
    /// Vertices of the sample that agree.
    pub(super) agreeing: usize,
}

impl<'a> Search<'a> {
    /// A search with the distances of `theirs` from the exact mesh.
    pub(super) fn new(
        model: &'a Model<'a>,
        pose: &'a Pose,
        theirs: &'a [DVec3],
        (tolerance, largest): (f64, f64),
        distances: &[f64],
    ) -> Self {
        let mut sample: Vec<usize> = (0..theirs.len()).collect();
        sample.sort_by(|&a, &b| distances[b].total_cmp(&distances[a]));
        sample.truncate(WORST);
        let step = theirs.len().div_ceil(SPREAD).max(1);
        sample.extend((0..theirs.len()).step_by(step));
        Self {
            model,
            pose,
            theirs,
            tolerance,
            metric: Metric::Straight,
            largest,
            sample,
        }
    }

    /// The same, where vertices agree only within `limit`, if that is less.
    pub(super) fn within(&self, limit: f64) -> Self {
        Self {
            tolerance: self.tolerance.min(limit),
            sample: self.sample.clone(),
            ..*self
        }
    }

    /// The same in another pose.
    pub(super) fn in_pose<'b>(&'b self, pose: &'b Pose) -> Search<'b> {
        Search {
            pose,
            sample: self.sample.clone(),
            ..*self
        }
    }

    /// The same, where vertices agree if no coordinate is more than `limit` apart, or from where it may have been before
    /// its digits were `cut_off`.
    pub(super) fn of_coordinates_within(&self, limit: f64, cut_off: Option<CutOff>) -> Self {
        Self {
            tolerance: limit,
            metric: cut_off.map_or(Metric::ByCoordinate, Metric::ByCutCoordinate),
            sample: self.sample.clone(),
            ..*self
        }
    }

    /// Every mistake by itself, with those that explain the mesh.
    pub(super) async fn singles(&self, pace: &Pace) -> (Vec<Alone>, Vec<Explanation>) {
        let mut alone = Vec::new();
        let mut found = Vec::new();
        for made in ways() {
            let formula = formula(&[made]);
            let Some(mut skinner) = self.skinner(&formula) else {
                continue;
            };
            found.extend(self.explained_by(&mut skinner, vec![made], pace).await);
            let nearness = self.nearness(&mut skinner);
            pace.after(self.sample.len()).await;
            alone.push(Alone { made, nearness });
        }
        (alone, found)
    }

    /// Every two mistakes that explain the mesh, the one that explains more by itself first. A factor of angles has to bring
    /// it much nearer than the other one alone does, or as near as `rounding` tells.
    pub(super) async fn pairs(
        &self,
        alone: &[Alone],
        rounding: f64,
        pace: &Pace,
    ) -> Vec<Explanation> {
        let mean = |made: Made| {
            let one = alone
                .iter()
                .find(|one| std::ptr::eq(one.made.reading, made.reading));
            one.map_or_else(|| self.mean(&formula(&[made])), |one| one.nearness.mean)
        };
        let all: Vec<(Made, Made, Formula)> =
            pairs_of_ways().chain(pairs_with_whole_program()).collect();
        let mut found = Vec::new();
        for (done, (first, second, both)) in all.iter().enumerate() {
            pace.tell(done as f32 / all.len() as f32);
            let Some(mut skinner) = self.skinner(both) else {
                continue;
            };
            let made = vec![*first, *second];
            let explained = self.explained_by(&mut skinner, made, pace).await;
            let explained = explained.map(|mut both| {
                if mean(*second) < mean(*first) {
                    both.made.reverse();
                }
                both
            });
            let is_scaled = |made: &Made| std::ptr::eq(made.mistake, &raw const ANGLES_SCALED);
            let beside_scaled = match (is_scaled(first), is_scaled(second)) {
                (true, _) => Some(*second),
                (_, true) => Some(*first),
                _ => None,
            };
            found.extend(explained.filter(|both| {
                let is_much_nearer = |other: Made| both.error <= self.error_of(other) / MUCH_NEARER;
                both.error <= rounding || beside_scaled.is_none_or(is_much_nearer)
            }));
        }
        found
    }

    /// How near the mesh is to those that mistakes of a whole program give, each by itself.
    pub(super) async fn near_whole_program(&self, pace: &Pace) -> Vec<Alone> {
        let mut alone = Vec::new();
        for made in ways_of_whole_program() {
            if let Some(mut skinner) = self.skinner(&formula(&[made])) {
                let nearness = self.nearness(&mut skinner);
                alone.push(Alone { made, nearness });
                pace.after(self.sample.len()).await;
            }
        }
        alone
    }

    /// How far vertices of the sample are from those that a formula gives, at most; `None` if it cannot give the mesh.
    pub(super) fn error_of_sample(&self, formula: &Formula) -> Option<f64> {
        self.error_among(self.sample.iter().copied(), formula)
    }

    fn error_among(&self, vertices: impl Iterator<Item = usize>, formula: &Formula) -> Option<f64> {
        let mut skinner = self.skinner(formula)?;
        let distances = vertices.map(|index| self.distance(&mut skinner, index));
        Some(distances.fold(0.0, f64::max))
    }

    /// How near the mesh is to the one that a formula gives, in the mean; infinite if that cannot give it.
    pub(super) fn mean(&self, formula: &Formula) -> f64 {
        let skinner = self.skinner(formula);
        skinner.map_or(f64::INFINITY, |mut skinner| {
            self.nearness(&mut skinner).mean
        })
    }

    /// How far the mesh is from the one with a mistake alone, at most; infinite if that cannot give it.
    fn error_of(&self, made: Made) -> f64 {
        let error = self.error_among(0..self.theirs.len(), &formula(&[made]));
        error.unwrap_or(f64::INFINITY)
    }

    /// The vertices of the sample after those that are the farthest apart, of which a small mesh has fewer.
    fn spread(&self) -> &[usize] {
        &self.sample[self.theirs.len().min(WORST)..]
    }

    /// How near the mesh is to the one of `skinner`.
    pub(super) fn nearness(&self, skinner: &mut Skinner) -> Nearness {
        let spread = self.spread();
        let distances = spread.iter().map(|&index| self.distance(skinner, index));
        let distances: Vec<f64> = distances.collect();
        Nearness {
            mean: distances.iter().sum::<f64>() / spread.len().max(1) as f64,
            agreeing: distances
                .iter()
                .filter(|distance| **distance <= self.tolerance)
                .count(),
        }
    }

    /// Mean distance of the mesh from its own middle, of the vertices by which nearness is told.
    pub(super) fn distance_from_middle(&self) -> f64 {
        let spread = self.spread();
        let count = spread.len().max(1) as f64;
        let middle = spread
            .iter()
            .map(|&index| self.theirs[index])
            .sum::<DVec3>()
            / count;
        let away = spread
            .iter()
            .map(|&index| self.metric.between(middle, self.theirs[index]));
        away.sum::<f64>() / count
    }

    /// How many vertices of all are off from the mesh that a formula gives; `None` if it cannot give it.
    pub(super) fn off(&self, formula: &Formula) -> Option<usize> {
        let mut skinner = self.skinner(formula)?;
        let all = 0..self.theirs.len();
        let off = all.filter(|&index| self.distance(&mut skinner, index) > self.tolerance);
        Some(off.count())
    }

    pub(super) fn skinner(&self, formula: &Formula) -> Option<Skinner<'a>> {
        let fits = self.may_be_of(formula);
        fits.then(|| Skinner::new(self.model, self.pose, formula))
    }

    /// Whether a formula may give a mesh of so many vertices of the character in the pose.
    pub(super) fn may_be_of(&self, formula: &Formula) -> bool {
        self.model.count(formula.vertex_order) == self.theirs.len()
            && formula.is_of(self.model.character)
            && formula.is_of_pose(self.pose, self.model.skeleton().roots())
    }

    /// Whether a mistake is made in the way that is made most often, the first one that the character has.
    pub(super) fn is_usual(&self, made: Made) -> bool {
        let mistake = made.mistake;
        let mut ways = mistake.readings.iter();
        let usual = ways.find(|&reading| self.may_be_of(&formula(&[Made { mistake, reading }])));
        usual.is_some_and(|usual| std::ptr::eq(usual, made.reading))
    }

    /// Whether `theirs` is farther from where a formula puts the vertex than meshes are that agree.
    pub(super) fn is_off(&self, placed: Placed, theirs: DVec3) -> bool {
        placed.distance_by(self.metric, theirs) > self.tolerance
    }

    /// How far a vertex is from where `skinner` puts it; for one far outside as if it were not farther out than others.
    pub(super) fn distance(&self, skinner: &mut Skinner, index: usize) -> f64 {
        let theirs = self.theirs[index];
        let distance = skinner.distance(index, theirs, self.metric);
        let out = theirs.abs().max_element();
        let is_outside = self.largest > 0.0 && out > self.largest;
        if is_outside && out.is_finite() {
            distance * (self.largest / out)
        } else {
            distance
        }
    }

    /// `made` if every vertex agrees with the mesh that it gives.
    pub(super) async fn explained_by(
        &self,
        skinner: &mut Skinner<'_>,
        made: Vec<Made>,
        pace: &Pace,
    ) -> Option<Explanation> {
        pace.after(A_JOINT * self.model.skeleton().joints().len())
            .await;
        let mut error = 0.0_f64;
        for (done, index) in self
            .sample
            .iter()
            .copied()
            .chain(0..self.theirs.len())
            .enumerate()
        {
            let distance = self.distance(skinner, index);
            if distance > self.tolerance {
                return None;
            }
            error = error.max(distance);
            if done % AT_ONCE == AT_ONCE - 1 {
                pace.after(AT_ONCE).await;
            }
        }
        Some(Explanation {
            made,
            error,
            how: None,
        })
    }
}

/// The exact mesh as a program writes it that has its vertices in `order`.
pub(super) fn exact(model: &Model, pose: &Pose, order: VertexOrder) -> Vec<Placed> {
    let formula = Formula {
        vertex_order: order,
        ..Formula::default()
    };
    let mut skinner = Skinner::new(model, pose, &formula);
    (0..skinner.count())
        .map(|index| skinner.place(index))
        .collect()
}
