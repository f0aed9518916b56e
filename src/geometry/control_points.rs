//! Editing of control points: moving, adding and removing them, in whole pieces.

use super::curve::{Basis, Curve, CurveError, CurveForm};
use glam::Vec3;

impl Curve {
    /// The same curve with control point `index` at `position`, in model space. A closed curve
    /// stays closed: where its last points repeat its first, the repeated one moves too. A circle,
    /// or an index that does not exist, changes nothing.
    ///
    /// # Errors
    /// If `position` is not finite or too large.
    pub fn with_control_point(&self, index: usize, position: Vec3) -> Result<Self, CurveError> {
        let CurveForm::Spline {
            basis,
            flat,
            control_points,
        } = self.form()
        else {
            return Ok(self.clone());
        };
        let mut moved = control_points.clone();
        for (i, point) in moved.iter_mut().enumerate() {
            if i == index || Some(i) == twin(*basis, control_points, index) {
                *point = position;
            }
        }
        Self::spline(*basis, *flat, self.steps(), moved)
    }

    /// The same curve with more control points after point `index`: one for a B-spline, three,
    /// which make a piece, for a Bézier curve. After the last point the curve continues straight;
    /// elsewhere the piece of a Bézier curve is split, which does not change its shape, and a
    /// B-spline gets a point halfway to the next one. A closed curve stays closed. A circle, or an
    /// index that does not exist, changes nothing.
    ///
    /// # Errors
    /// If there would be too many points.
    pub fn with_point_after(&self, index: usize) -> Result<Self, CurveError> {
        self.with_points_changed(index, |basis, points| match basis {
            Basis::Bezier => split_or_extended(points, index),
            Basis::BSpline => halved_or_extended(points, index),
        })
    }

    /// The same curve without control point `index`; of a Bézier curve the handles beside it go
    /// too, or at an end the piece. A closed curve stays closed. A circle, or a point for which
    /// [`Curve::can_lose_point`] is false, changes nothing.
    ///
    /// # Errors
    /// Never in practice: fewer points of a valid curve are within all bounds.
    pub fn without_point(&self, index: usize) -> Result<Self, CurveError> {
        if !self.can_lose_point(index) {
            return Ok(self.clone());
        }
        self.with_points_changed(index, |basis, points| match basis {
            Basis::Bezier => without_knot(points, index),
            Basis::BSpline => without_vertex(points, index),
        })
    }

    /// Whether [`Curve::without_point`] removes point `index`: enough others must be left, and the
    /// handles of a Bézier curve only go with the point between them.
    pub fn can_lose_point(&self, index: usize) -> bool {
        let CurveForm::Spline {
            basis,
            control_points: points,
            ..
        } = self.form()
        else {
            return false;
        };
        let least = match basis {
            Basis::Bezier if !index.is_multiple_of(3) => return false,
            Basis::Bezier => 7,
            // Three points that are all repeated are the fewest that close.
            Basis::BSpline if repeats_its_start(*basis, points) => 7,
            Basis::BSpline => 5,
        };
        index < points.len() && points.len() >= least
    }

    fn with_points_changed(
        &self,
        index: usize,
        change: impl FnOnce(Basis, &[Vec3]) -> Vec<Vec3>,
    ) -> Result<Self, CurveError> {
        match self.form() {
            CurveForm::Spline {
                basis,
                flat,
                control_points,
            } if index < control_points.len() => {
                let changed = change(*basis, control_points);
                Self::spline(*basis, *flat, self.steps(), changed)
            }
            _ => Ok(self.clone()),
        }
    }
}

/// Halves the piece that starts at or contains point `index` (de Casteljau), or adds a piece after
/// the last point.
fn split_or_extended(points: &[Vec3], index: usize) -> Vec<Vec3> {
    let last = points.len() - 1;
    let mut changed = points.to_vec();
    if index == last && !repeats_its_start(Basis::Bezier, points) {
        let onward = points[last] - points[last - 1];
        changed.extend([1.0, 2.0, 3.0].map(|times| points[last] + onward * times));
        return changed;
    }
    let first = index.min(last - 1) / 3 * 3;
    let [a, b, c, d] = [0, 1, 2, 3].map(|i| points[first + i]);
    let (ab, bc, cd) = (a.midpoint(b), b.midpoint(c), c.midpoint(d));
    let (abc, bcd) = (ab.midpoint(bc), bc.midpoint(cd));
    let halves = [ab, abc, abc.midpoint(bcd), bcd, cd];
    changed.splice(first + 1..first + 3, halves);
    changed
}

fn halved_or_extended(points: &[Vec3], index: usize) -> Vec<Vec3> {
    let last = points.len() - 1;
    if repeats_its_start(Basis::BSpline, points) {
        let shared = repeated(Basis::BSpline);
        let mut ring = points[..points.len() - shared].to_vec();
        let at = index % ring.len();
        let halfway = ring[at].midpoint(ring[(at + 1) % ring.len()]);
        ring.insert(at + 1, halfway);
        return closed(ring);
    }
    let mut changed = points.to_vec();
    let added = match points.get(index + 1) {
        Some(&next) => points[index].midpoint(next),
        None => points[last] * 2.0 - points[last - 1],
    };
    changed.insert(index + 1, added);
    changed
}

fn without_knot(points: &[Vec3], index: usize) -> Vec<Vec3> {
    let last = points.len() - 1;
    if index > 0 && index < last {
        return [&points[..index - 1], &points[index + 2..]].concat();
    }
    if repeats_its_start(Basis::Bezier, points) {
        // The pieces on either side of the start become one, which ends at the second knot.
        return [&points[3..last - 1], &[points[2], points[3]]].concat();
    }
    match index {
        0 => points[3..].to_vec(),
        _ => points[..last - 2].to_vec(),
    }
}

fn without_vertex(points: &[Vec3], index: usize) -> Vec<Vec3> {
    let mut changed = points.to_vec();
    if repeats_its_start(Basis::BSpline, points) {
        changed.truncate(points.len() - repeated(Basis::BSpline));
        changed.remove(index % changed.len());
        return closed(changed);
    }
    changed.remove(index);
    changed
}

/// A ring of B-spline control points, with the first ones repeated at its end.
fn closed(mut ring: Vec<Vec3>) -> Vec<Vec3> {
    for i in 0..repeated(Basis::BSpline) {
        ring.push(ring[i]);
    }
    ring
}

/// Number of points at the end of a closed curve that repeat the first ones.
fn repeated(basis: Basis) -> usize {
    match basis {
        Basis::Bezier => 1,
        Basis::BSpline => 3,
    }
}

/// Whether the last control points repeat the first ones, so that the curve closes.
fn repeats_its_start(basis: Basis, points: &[Vec3]) -> bool {
    let shared = repeated(basis);
    // With fewer points the first and the last ones would be the same ones.
    match points.len().checked_sub(shared) {
        Some(first_repeated) => {
            first_repeated >= shared && points[..shared] == points[first_repeated..]
        }
        None => false,
    }
}

/// Index of the control point that repeats point `index` in a closed curve.
fn twin(basis: Basis, points: &[Vec3], index: usize) -> Option<usize> {
    if !repeats_its_start(basis, points) {
        return None;
    }
    let shared = repeated(basis);
    let first_repeated = points.len() - shared;
    if index < shared {
        Some(first_repeated + index)
    } else {
        index.checked_sub(first_repeated)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spline(basis: Basis, points: &[(i32, i32)]) -> Curve {
        let points = points
            .iter()
            .map(|&(x, y)| Vec3::new(x as f32, y as f32, 0.0));
        Curve::spline(basis, true, 8, points.collect()).unwrap()
    }

    const OPEN: [(i32, i32); 7] = [(0, 0), (1, 2), (3, 2), (4, 0), (5, -2), (7, -2), (8, 0)];
    const LOOP: [(i32, i32); 10] = [
        (4, 0),
        (4, 2),
        (2, 4),
        (0, 4),
        (-2, 4),
        (-4, 2),
        (-4, 0),
        (-4, -4),
        (4, -4),
        (4, 0),
    ];
    const RING: [(i32, i32); 8] = [
        (0, 0),
        (4, 0),
        (6, 4),
        (4, 8),
        (0, 4),
        (0, 0),
        (4, 0),
        (6, 4),
    ];

    fn is_closed(curve: &Curve) -> bool {
        let points = curve.evaluate();
        let (first, last) = (points[0], points[points.len() - 1]);
        first.position.distance(last.position) < 1e-5
    }

    #[test]
    fn splitting_a_bezier_curve_leaves_its_course() {
        let curve = spline(Basis::Bezier, &OPEN);
        for index in 0..6 {
            let split = curve.with_point_after(index).unwrap();
            assert_eq!(split.control_points().len(), 10);
            let halved = split.with_steps(4).unwrap().evaluate();
            // The halves have four steps each where the whole has eight.
            let whole = curve.evaluate();
            let part = index / 3 * 8;
            let halves = &halved[index / 3 * 4..index / 3 * 4 + 9];
            for (a, b) in halves.iter().zip(&whole[part..]) {
                assert!(a.position.distance(b.position) < 1e-5, "behind {index}");
            }
        }
    }

    #[test]
    fn behind_the_last_point_a_curve_runs_on_straight() {
        let bezier = spline(Basis::Bezier, &OPEN).with_point_after(6).unwrap();
        let end = &bezier.control_points()[6..];
        let expected = [(8, 0), (9, 2), (10, 4), (11, 6)];
        assert_eq!(end, spline(Basis::Bezier, &expected).control_points());
        let b_spline = spline(Basis::BSpline, &OPEN).with_point_after(6).unwrap();
        assert_eq!(b_spline.control_points()[7], Vec3::new(9.0, 2.0, 0.0));
    }

    #[test]
    fn a_b_spline_gets_a_point_halfway() {
        let changed = spline(Basis::BSpline, &OPEN).with_point_after(2).unwrap();
        assert_eq!(changed.control_points().len(), 8);
        assert_eq!(changed.control_points()[3], Vec3::new(3.5, 1.0, 0.0));
    }

    #[test]
    fn curves_that_close_stay_closed() {
        for curve in [spline(Basis::Bezier, &LOOP), spline(Basis::BSpline, &RING)] {
            assert!(is_closed(&curve));
            for index in 0..curve.control_points().len() {
                let more = curve.with_point_after(index).unwrap();
                assert!(more.control_points().len() > curve.control_points().len());
                assert!(is_closed(&more), "more behind {index}");
                let fewer = curve.without_point(index).unwrap();
                let fewer_points = fewer.control_points().len() < curve.control_points().len();
                assert_eq!(fewer_points, curve.can_lose_point(index));
                assert!(is_closed(&fewer), "without {index}");
            }
        }
    }

    #[test]
    fn a_bezier_curve_loses_the_handles_with_their_point() {
        let curve = spline(Basis::Bezier, &OPEN);
        let middle = spline(Basis::Bezier, &[(0, 0), (1, 2), (7, -2), (8, 0)]);
        assert_eq!(curve.without_point(3).unwrap(), middle);
        let (front, back) = (&OPEN[..4], &OPEN[3..]);
        assert_eq!(curve.without_point(0).unwrap(), spline(Basis::Bezier, back));
        assert_eq!(
            curve.without_point(6).unwrap(),
            spline(Basis::Bezier, front)
        );
        assert!(!curve.can_lose_point(4), "a handle");
    }

    #[test]
    fn the_last_piece_stays() {
        for (basis, points) in [
            (Basis::Bezier, &OPEN[..4]),
            (Basis::BSpline, &OPEN[..4]),
            (
                Basis::BSpline,
                &[(0, 0), (1, 0), (1, 1), (0, 0), (1, 0), (1, 1)],
            ),
        ] {
            let curve = spline(basis, points);
            for index in 0..points.len() + 1 {
                assert!(!curve.can_lose_point(index));
                assert_eq!(curve.without_point(index).unwrap(), curve);
            }
        }
    }

    #[test]
    fn a_circle_has_no_points_to_add_or_lose() {
        let circle = Curve::circle(8, 1.0).unwrap();
        assert_eq!(circle.with_point_after(0).unwrap(), circle);
        assert_eq!(circle.without_point(0).unwrap(), circle);
    }
}
