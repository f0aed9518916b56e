//! Silhouettes: which pixels of a picture a figure covers.

use super::clipping::{NEAREST, in_depth, is_in_depth};
use crate::compare::{Area, difference, outline_placement};
use crate::geometry::Picture;
use glam::{DMat4, DVec2, DVec3, DVec4};
use std::collections::HashMap;

/// Difference of a channel from the background's above which a pixel is drawn: more than what lossy
/// formats add, and less than what is left of a figure's color in the shade.
pub(super) const DRAWN: u8 = 12;

/// The part of a picture that is looked at: every so many pixels, in columns and rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Samples {
    /// Size of the picture in pixels.
    picture: [u32; 2],
    /// Pixels from one sample to the next.
    pub(super) step: u32,
    columns: usize,
    rows: usize,
}

impl Samples {
    /// Those of a picture of this size in pixels, in no more columns and rows than `most`.
    pub(super) fn new(width: u32, height: u32, most: u32) -> Self {
        let step = width.max(height).div_ceil(most).max(1);
        Self {
            picture: [width, height],
            step,
            columns: (width / step) as usize,
            rows: (height / step) as usize,
        }
    }

    /// The same picture with this many pixels from one sample to the next, if that is fewer.
    pub(super) fn with_step(self, step: u32) -> Self {
        let [width, height] = self.picture;
        let step = step.clamp(1, self.step);
        Self {
            step,
            columns: (width / step) as usize,
            rows: (height / step) as usize,
            ..self
        }
    }

    /// Width or height in pixels, whichever is more, of what `points` take up in the picture.
    pub(super) fn extent(&self, points: &[DVec3], clip_from_model: DMat4) -> u32 {
        let size = DVec2::from_array(self.picture.map(f64::from));
        let (mut low, mut high) = (size, DVec2::ZERO);
        for point in points {
            let clip = clip_from_model * point.extend(1.0);
            if clip.w > NEAREST && clip.is_finite() {
                let pixel = self.sample_of(clip) * f64::from(self.step);
                let pixel = pixel.clamp(DVec2::ZERO, size);
                (low, high) = (low.min(pixel), high.max(pixel));
            }
        }
        (high - low).max_element().max(1.0).ceil() as u32
    }

    fn count(&self) -> usize {
        self.columns * self.rows
    }

    /// The sample of a mesh that `pixel` of the picture lies in, with fractions.
    fn sample_of(&self, clip: DVec4) -> DVec2 {
        let ndc = clip.truncate() / clip.w;
        let [width, height] = self.picture.map(f64::from);
        let pixel = DVec2::new((ndc.x + 1.0) * 0.5 * width, (1.0 - ndc.y) * 0.5 * height);
        // The center of a sample's pixel is a whole number.
        let center = f64::from(self.step / 2) + 0.5;
        (pixel - center) / f64::from(self.step)
    }

    /// Adds the samples in a triangle to `changes`: for each row where more is covered, and where
    /// less. So a triangle costs as much as it has rows, and torn meshes have large ones.
    fn cover(&self, triangle: [DVec2; 3], changes: &mut [i32]) {
        let [a, b, c] = triangle;
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        let first = low.y.ceil().max(0.0);
        let last = high.y.floor().min(self.rows as f64 - 1.0);
        if first > last || high.x < 0.0 {
            return;
        }
        for row in first as usize..=last as usize {
            let y = row as f64;
            let (mut left, mut right) = (f64::INFINITY, f64::NEG_INFINITY);
            for (from, to) in [(a, b), (b, c), (c, a)] {
                if y < from.y.min(to.y) || y > from.y.max(to.y) {
                    continue;
                }
                // A level edge lies in the row from end to end.
                let level = [from.x, to.x];
                let cut = from.x + (y - from.y) / (to.y - from.y) * (to.x - from.x);
                for x in if from.y == to.y { level } else { [cut; 2] } {
                    (left, right) = (left.min(x), right.max(x));
                }
            }
            let left = left.ceil().max(0.0);
            let right = right.floor().min(self.columns as f64 - 1.0);
            if left <= right {
                let row = row * (self.columns + 1);
                changes[row + left as usize] += 1;
                changes[row + right as usize + 1] -= 1;
            }
        }
    }

    /// The samples at which `picture` differs from its background by more than `noise`.
    fn drawn(&self, picture: &Picture, noise: u8) -> Vec<bool> {
        let (pixels, _) = picture.rgba.as_chunks::<4>();
        let background = background(picture);
        let half = (self.step / 2) as usize;
        let is_drawn = (0..self.count()).map(|index| {
            let (column, row) = (index % self.columns, index / self.columns);
            let [x, y] = [column, row].map(|at| at * self.step as usize + half);
            let pixel = pixels[y * picture.width as usize + x];
            difference(pixel, background) > noise
        });
        is_drawn.collect()
    }

    /// The samples that are covered by what was added to `changes`.
    fn covered(&self, changes: &[i32]) -> Vec<bool> {
        let mut covered = Vec::with_capacity(self.count());
        for row in changes.chunks(self.columns + 1) {
            let mut depth = 0;
            covered.extend(row[..self.columns].iter().map(|change| {
                depth += change;
                depth > 0
            }));
        }
        covered
    }

    /// The samples that are in a square of two by two such ones.
    fn in_squares(&self, is_drawn: &[bool]) -> Vec<bool> {
        let columns = self.columns;
        let mut are_in = vec![false; is_drawn.len()];
        for row in 1..self.rows {
            for column in 1..columns {
                let last = row * columns + column;
                let square = [last, last - 1, last - columns, last - columns - 1];
                if square.iter().all(|&at| is_drawn[at]) {
                    square.into_iter().for_each(|at| are_in[at] = true);
                }
            }
        }
        are_in
    }

    /// Whether any sample around each is `wanted`, or its own; the outside is like the border.
    fn around(&self, is_covered: &[bool], wanted: bool) -> Vec<bool> {
        fn merge<'a>(
            wanted: bool,
            into: impl Iterator<Item = &'a mut bool>,
            from: impl Iterator<Item = &'a bool>,
        ) {
            for (into, from) in into.zip(from) {
                *into = if wanted { *into | *from } else { *into & *from };
            }
        }
        let mut across = is_covered.to_vec();
        let columns = self.columns.max(1);
        for (into, from) in across.chunks_mut(columns).zip(is_covered.chunks(columns)) {
            merge(wanted, into.iter_mut().skip(1), from.iter());
            merge(wanted, into.iter_mut(), from.iter().skip(1));
        }
        let mut around = across.clone();
        merge(wanted, around.iter_mut().skip(columns), across.iter());
        merge(wanted, around.iter_mut(), across.iter().skip(columns));
        around
    }
}

/// What is covered, by sample, without what is thinner than three samples: lines that are drawn
/// beside a figure are no part of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Silhouette {
    samples: Samples,
    is_covered: Vec<bool>,
    /// Which samples have one beside them that differs.
    is_edge: Vec<bool>,
    /// Which samples are drawn, however thin that is, or have one beside them that is.
    is_near: Vec<bool>,
    /// Which samples are drawn where that is two samples thick or more, as limbs of a small figure are.
    is_limb: Vec<bool>,
}

impl Silhouette {
    /// All of `picture` that differs from its background, the color that most of its border has, by more than `noise` in
    /// any channel.
    pub(super) fn of_picture(picture: &Picture, samples: Samples, noise: u8) -> Self {
        Self::new(samples, &samples.drawn(picture, noise))
    }

    /// A mesh with the vertices `points` as it is seen with `clip_from_model`.
    pub(super) fn of_mesh(
        points: &[DVec3],
        triangles: &[[u32; 3]],
        clip_from_model: DMat4,
        samples: Samples,
    ) -> Self {
        let clip = |point: &DVec3| clip_from_model * point.extend(1.0);
        let seen = |clip: DVec4| is_in_depth(clip).then(|| samples.sample_of(clip));
        let seen: Vec<Option<DVec2>> = points.iter().map(|point| seen(clip(point))).collect();
        let mut changes = vec![0; (samples.columns + 1) * samples.rows];
        for corners in triangles.iter().map(|of| of.map(|corner| corner as usize)) {
            if let [Some(a), Some(b), Some(c)] = corners.map(|corner| seen[corner]) {
                samples.cover([a, b, c], &mut changes);
            } else {
                let inside = in_depth(corners.map(|corner| clip(&points[corner])));
                let inside: Vec<DVec2> =
                    inside.iter().map(|&clip| samples.sample_of(clip)).collect();
                if let [first, others @ ..] = &inside[..] {
                    for pair in others.windows(2) {
                        samples.cover([*first, pair[0], pair[1]], &mut changes);
                    }
                }
            }
        }
        Self::new(samples, &samples.covered(&changes))
    }

    /// The silhouette of what is drawn.
    fn new(samples: Samples, is_drawn: &[bool]) -> Self {
        let thin = samples.around(is_drawn, false);
        let is_covered = samples.around(&thin, true);
        let [inside, outside] = [false, true].map(|covered| samples.around(&is_covered, covered));
        let is_edge = inside
            .iter()
            .zip(&outside)
            .map(|(inside, outside)| inside != outside);
        Self {
            samples,
            is_edge: is_edge.collect(),
            is_near: samples.around(is_drawn, true),
            is_limb: samples.in_squares(is_drawn),
            is_covered,
        }
    }

    /// How `exact` is placed in this one, in words, by samples; `None` if it is where it should be, or not there.
    pub(super) fn placement_of(&self, exact: &Self) -> Option<String> {
        outline_placement(
            self.samples.columns,
            [&exact.is_covered, &self.is_covered],
            1,
        )
    }

    /// Whether nothing is covered.
    pub(super) fn is_blank(&self) -> bool {
        !self.is_covered.contains(&true)
    }

    /// Number of samples that it covers and that are not at its edge.
    pub(super) fn inner_area(&self) -> usize {
        let both = self.is_covered.iter().zip(&self.is_edge);
        both.filter(|(covered, edge)| **covered && !**edge).count()
    }

    /// Number of samples that this one or `other` covers.
    pub(super) fn area_with(&self, other: &Self) -> usize {
        let both = self.is_covered.iter().zip(&other.is_covered);
        both.filter(|(own, other)| **own || **other).count()
    }

    /// Samples of this picture that differ from `mesh` and are at the edge of neither, where a pixel more
    /// or less says nothing. Where a limb of the mesh is just too thin to be covered, that it is in the
    /// picture says nothing, either; what is thin in the picture may be a line, and excuses nothing.
    pub(super) fn off<'a>(&'a self, mesh: &'a Self) -> impl Iterator<Item = usize> + 'a {
        let all = 0..self.is_covered.len();
        all.filter(|&at| {
            !self.is_edge[at]
                && match self.is_covered[at] {
                    // What is covered, or at an edge of that, is near.
                    true => !mesh.is_near[at],
                    false => mesh.is_covered[at] && !mesh.is_edge[at] || self.lacks(mesh, at),
                }
        })
    }

    /// Samples at which `mesh` has limbs, and near which nothing is drawn in this picture: what is thin, and may be a line where
    /// it is drawn, is missed where it is not.
    pub(super) fn lacking<'a>(&'a self, mesh: &'a Self) -> impl Iterator<Item = usize> + 'a {
        let all = 0..self.is_near.len();
        all.filter(|&at| self.lacks(mesh, at))
    }

    fn lacks(&self, mesh: &Self, at: usize) -> bool {
        mesh.is_limb[at] && !self.is_near[at]
    }

    /// Whether the samples that are off ([`Self::off`]) are covered by `mesh` alone, and not by this one, which has no limbs
    /// elsewhere.
    pub(super) fn only_lacks(&self, mesh: &Self) -> bool {
        let has_others = mesh.lacking(self).next().is_some();
        !has_others && self.off(mesh).all(|at| !self.is_covered[at])
    }

    /// Whether a point lies on or beside what is drawn; `None` for one that is not in the picture.
    pub(super) fn is_near(&self, clip: DVec4) -> Option<bool> {
        if !(clip.w > NEAREST && clip.is_finite()) {
            return None;
        }
        let Samples { columns, rows, .. } = self.samples;
        let at = self.samples.sample_of(clip).round();
        let is_inside = at.cmpge(DVec2::ZERO).all() && at.x < columns as f64 && at.y < rows as f64;
        is_inside.then(|| self.is_near[at.y as usize * columns + at.x as usize])
    }

    /// The box around samples, as the pixels x, y, width and height of the picture.
    pub(super) fn bounds(&self, samples: impl Iterator<Item = usize>) -> Option<[u32; 4]> {
        let Samples { step, columns, .. } = self.samples;
        let places = samples.map(|at| ((at % columns) as u32, (at / columns) as u32));
        let Area {
            x,
            y,
            width,
            height,
        } = Area::around(places)?;
        Some([x, y, width, height].map(|samples| samples * step))
    }
}

/// The pixels at the border of a picture.
fn border(picture: &Picture) -> impl Iterator<Item = [u8; 4]> {
    let (pixels, _) = picture.rgba.as_chunks::<4>();
    let (width, height) = (picture.width as usize, picture.height as usize);
    let all = pixels.iter().enumerate();
    all.filter_map(move |(at, pixel)| {
        let (x, y) = (at % width, at / width);
        (x == 0 || y == 0 || x + 1 == width || y + 1 == height).then_some(*pixel)
    })
}

/// The color that most pixels of the border have.
fn background(picture: &Picture) -> [u8; 4] {
    let mut counts: HashMap<[u8; 4], usize> = HashMap::new();
    for pixel in border(picture) {
        *counts.entry(pixel).or_default() += 1;
    }
    // Of equals one that does not depend on the order of the map.
    let most = counts
        .into_iter()
        .max_by_key(|&(color, count)| (count, color));
    most.map_or([0; 4], |(color, _)| color)
}

/// Share of the border of a picture that differs from its background.
pub(super) fn drawn_border(picture: &Picture) -> f64 {
    let background = background(picture);
    let (all, drawn) = border(picture).fold((0, 0), |(all, drawn), pixel| {
        let is_drawn = difference(pixel, background) > DRAWN;
        (all + 1, drawn + u32::from(is_drawn))
    });
    f64::from(drawn) / f64::from(all.max(1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::camera::rh::proj::opengl;
    use std::f32::consts::FRAC_PI_2;

    #[test]
    fn of_a_floor_the_part_between_the_near_and_the_far_plane_is_covered() {
        let clip_from_model = opengl::perspective(FRAC_PI_2, 1.0, 0.1, 10.0).as_dmat4();
        let samples = Samples::new(100, 100, 100);
        let rows = |corners: [DVec3; 3]| {
            let seen = Silhouette::of_mesh(&corners, &[[0, 1, 2]], clip_from_model, samples);
            let rows = seen.is_covered.chunks(samples.columns);
            let is_whole = |row: &[bool]| row.iter().all(|covered| *covered);
            rows.map(is_whole).collect::<Vec<_>>()
        };
        // A floor one unit below the eye, from far behind it to a distance before the far plane, or beyond that.
        for (end, depth) in [(5.0, 5.0), (9e4, 10.0)] {
            let corners = [(-9e4, -end), (9e4, -end), (0.0, 9e4)];
            let top = 50.0 + 50.0 / depth;
            let expected: Vec<bool> = (0..100).map(|row| f64::from(row) + 0.5 >= top).collect();
            assert_eq!(rows(corners.map(|(x, z)| DVec3::new(x, -1.0, z))), expected);
        }
        // Behind the eye or beyond the far plane nothing is.
        for z in [5.0, -11.0] {
            let wall = [(-999.0, -999.0), (999.0, -999.0), (0.0, 999.0)];
            assert!(!rows(wall.map(|(x, y)| DVec3::new(x, y, z))).contains(&true));
        }
        let nan = [
            DVec3::NAN,
            DVec3::new(-9.0, 0.0, -5.0),
            DVec3::new(9.0, 0.0, -5.0),
        ];
        assert!(!rows(nan).contains(&true));
    }
}
