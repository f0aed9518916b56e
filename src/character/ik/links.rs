use glam::{DQuat, DVec3};

/// Length, relative to the longest link, below which a link does not turn: it has no direction.
const NO_LENGTH: f64 = 1e-9;

/// Links of a chain that have a length, from its first joint at the origin.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Links {
    /// Index in the chain of the joint that turns each link.
    pub places: Vec<usize>,
    /// Lengths, positive.
    pub lengths: Vec<f64>,
    /// Directions, unit vectors in model space.
    pub directions: Vec<DVec3>,
    finite: bool,
}

impl Links {
    /// Links of a chain from its bones in model space; those without a length are left out.
    pub fn new(bones: &[DVec3]) -> Self {
        let longest = bones.iter().map(|bone| bone.length()).fold(0.0, f64::max);
        let mut links = Self {
            finite: bones.iter().all(|bone| bone.is_finite()),
            ..Self::default()
        };
        for (place, bone) in bones.iter().enumerate() {
            let length = bone.length();
            if let Some(direction) = bone.try_normalize()
                && length > NO_LENGTH * longest
            {
                links.places.push(place);
                links.lengths.push(length);
                links.directions.push(direction);
            }
        }
        links
    }

    /// Whether there is a link to turn, and all are finite.
    pub fn is_sound(&self) -> bool {
        self.finite && !self.lengths.is_empty() && self.total().is_finite()
    }

    /// Length of the straight chain.
    pub fn total(&self) -> f64 {
        self.lengths.iter().sum()
    }

    /// Smallest possible distance of the end from the first joint.
    pub fn least(&self) -> f64 {
        let longest = self.lengths.iter().copied().fold(0.0, f64::max);
        (2.0 * longest - self.total()).max(0.0)
    }

    /// The same links in other directions.
    pub fn along(&self, directions: Vec<DVec3>) -> Self {
        Self {
            directions,
            ..self.clone()
        }
    }

    /// Position of the end, from the first joint.
    pub fn end(&self) -> DVec3 {
        let links = self.lengths.iter().zip(&self.directions);
        links.map(|(&length, &direction)| length * direction).sum()
    }

    /// Positions of the joints and of the end; the first joint is at the origin.
    pub fn points(&self) -> Vec<DVec3> {
        let mut points = vec![DVec3::ZERO];
        let mut at = DVec3::ZERO;
        for (&length, &direction) in self.lengths.iter().zip(&self.directions) {
            at += length * direction;
            points.push(at);
        }
        points
    }
}

/// Initial bend of a straight chain, relative to its length: FABRIK does not leave a line.
const BEND: f64 = 0.1;
/// Distance of the target from the first joint, relative to the chain's length, below which it has
/// no direction.
const AT_THE_START: f64 = 1e-9;
/// Sine of the angle between the pole and the line from the first joint to the target below which
/// the pole is ignored.
const IN_LINE: f64 = 1e-3;

/// Way in which a chain reaches a target.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Reached {
    /// Rotation of the whole chain, as it is, towards the target and its bend towards the pole.
    pub turn: DQuat,
    /// Directions of the links then, unit vectors.
    pub directions: Vec<DVec3>,
}

/// Moves the end of `links` to `target`, both relative to the first joint, or as near as possible
/// on the line to the target. The chain bends towards `pole` if there is one, else as it does now,
/// and about `normal` if it is straight.
pub(super) fn reach(links: &Links, target: DVec3, pole: Option<DVec3>, normal: DVec3) -> Reached {
    let (least, total) = (links.least(), links.total());
    let axis = axis(links);
    let far = target.length() > AT_THE_START * total;
    let aim = target.try_normalize().filter(|_| far).unwrap_or(axis);
    let swing = arc(axis, aim, normal);
    let side_now = swing * bend_side(links).unwrap_or_else(|| side_about(normal, axis));
    let side = towards_pole(aim, pole, links).unwrap_or(side_now);
    let turn = twist(aim, side_now, side) * swing;
    let turned = links.along(links.directions.iter().map(|&d| turn * d).collect());
    let distance = target.length().clamp(least, total);
    let count = links.lengths.len();
    let directions = if count == 1 || distance >= total * (1.0 - 1e-15) {
        vec![aim; count]
    } else if count == 2 {
        two_bones(&links.lengths, distance, aim, side).to_vec()
    } else {
        many_bones(&turned, distance, aim, side, pole.is_some())
    };
    Reached { turn, directions }
}

/// Side of the aim on which the pole is, of unit length; `None` without one, or if it is in line
/// with the target.
fn towards_pole(aim: DVec3, pole: Option<DVec3>, links: &Links) -> Option<DVec3> {
    let pole = pole?.try_normalize().filter(|_| links.lengths.len() > 1)?;
    let side = pole.reject_from_normalized(aim);
    side.try_normalize().filter(|_| side.length() > IN_LINE)
}

/// Directions of two links by the law of cosines; `distance` is one that they can span.
fn two_bones(lengths: &[f64], distance: f64, aim: DVec3, side: DVec3) -> [DVec3; 2] {
    let (a, b) = (lengths[0], lengths[1]);
    let cos = if distance > 0.0 {
        ((a * a + distance * distance - b * b) / (2.0 * a * distance)).clamp(-1.0, 1.0)
    } else {
        0.0
    };
    let upper = cos * aim + (1.0 - cos * cos).max(0.0).sqrt() * side;
    let lower = (distance * aim - a * upper).try_normalize();
    [upper, lower.unwrap_or(-upper)]
}

/// Directions of three links or more, by FABRIK, after which the distance is made exact.
fn many_bones(links: &Links, distance: f64, aim: DVec3, side: DVec3, has_pole: bool) -> Vec<DVec3> {
    let mut points = links.points();
    if bend_side(links).is_none() {
        let total = links.total();
        let mut along = 0.0;
        for (point, length) in points.iter_mut().zip(&links.lengths) {
            *point += BEND * total * (std::f64::consts::PI * along / total).sin() * side;
            along += length;
        }
    }
    let drawn = links.along(fabrik(links, points, distance * aim));
    let closed = links.along(close(&drawn, distance, aim, aim.cross(side)));
    match bend_side(&closed).filter(|_| has_pole) {
        Some(bent) => {
            let turn = twist(aim, bent, side);
            closed.directions.into_iter().map(|d| turn * d).collect()
        }
        None => closed.directions,
    }
}

/// Mean distance of a chain's joints from the line between its ends, relative to its length, below
/// which it counts as straight: the side to which it bends is rounding.
const STRAIGHT: f64 = 1e-4;

/// Unit vector from the first joint to the end; along the first link if both are in one place.
fn axis(links: &Links) -> DVec3 {
    let end = links.end();
    let far = end.length() > 1e-6 * links.total();
    end.try_normalize()
        .filter(|_| far)
        .unwrap_or(links.directions[0])
}

/// Side of its axis to which the chain bends, of unit length; `None` if it is straight.
fn bend_side(links: &Links) -> Option<DVec3> {
    let axis = axis(links);
    let points = links.points();
    let mean = points.iter().sum::<DVec3>() / points.len() as f64;
    let off = mean.reject_from_normalized(axis);
    let clear = off.length() > STRAIGHT * links.total();
    off.try_normalize().filter(|_| clear)
}

/// Side to which a straight chain along `axis` bends if it bends about `normal`.
fn side_about(normal: DVec3, axis: DVec3) -> DVec3 {
    let side = normal.cross(axis).reject_from_normalized(axis);
    side.try_normalize()
        .filter(|_| side.length() > 1e-6 * normal.length())
        .unwrap_or_else(|| axis.any_orthonormal_vector())
}

/// Axis about which the chain bends, of unit length. A straight chain bends like a knee if it is
/// upright, else like an elbow, of a figure that faces along `front`.
pub(super) fn bend_normal(links: &Links, front: DVec3) -> DVec3 {
    let axis = axis(links);
    let guess = || {
        let bends_to = if axis.y.abs() > 0.5 { front } else { -front };
        let side = bends_to.reject_from_normalized(axis);
        let clear = side.length() > 0.1;
        let side = side.try_normalize().filter(|_| clear);
        side.unwrap_or_else(|| axis.any_orthonormal_vector())
    };
    axis.cross(bend_side(links).unwrap_or_else(guess))
}

/// Shortest rotation from one unit vector to another; about `normal`, as far as possible, if they
/// are opposite.
pub(super) fn arc(from: DVec3, to: DVec3, normal: DVec3) -> DQuat {
    if from.dot(to) > -1.0 + 1e-12 {
        return DQuat::from_rotation_arc(from, to);
    }
    let about = normal.reject_from_normalized(from);
    let about = about
        .try_normalize()
        .unwrap_or_else(|| from.any_orthonormal_vector());
    DQuat::from_axis_angle(about, std::f64::consts::PI)
}

/// Rotation about the unit vector `axis` that takes `from` as near to `to` as possible.
fn twist(axis: DVec3, from: DVec3, to: DVec3) -> DQuat {
    let angle = axis.dot(from.cross(to));
    let along = from.dot(to) - axis.dot(from) * axis.dot(to);
    DQuat::from_axis_angle(axis, angle.atan2(along))
}

/// Most iterations of FABRIK. More change little, and the rest is made exact afterwards.
const ROUNDS: usize = 32;
/// Distance from the target, relative to the chain's length, at which FABRIK ends.
const NEAR: f64 = 1e-9;

/// Directions of the links after FABRIK with this `target`: alternately backward from there and
/// forward from the first joint, each point is moved onto the line to its neighbor. The joints
/// start at `points`, whose distances need not be those of the links.
fn fabrik(links: &Links, mut points: Vec<DVec3>, target: DVec3) -> Vec<DVec3> {
    let mut directions = links.directions.clone();
    let last = links.lengths.len();
    let towards =
        |from: DVec3, to: DVec3, direction: DVec3| (to - from).try_normalize().unwrap_or(direction);
    for _ in 0..ROUNDS {
        points[last] = target;
        for i in (0..last).rev() {
            let direction = towards(points[i], points[i + 1], directions[i]);
            points[i] = points[i + 1] - links.lengths[i] * direction;
        }
        points[0] = DVec3::ZERO;
        for i in 0..last {
            directions[i] = towards(points[i], points[i + 1], directions[i]);
            points[i + 1] = points[i] + links.lengths[i] * directions[i];
        }
        if points[last].distance(target) <= NEAR * links.total() {
            break;
        }
    }
    directions
}

/// Number of halvings of an interval until only rounding is left.
const HALVINGS: usize = 54;

/// Opens or closes the chain's bends until its end is at `distance` from its first joint, in the
/// direction `aim`, both to rounding. The distance must be possible for its links; `normal`,
/// perpendicular to `aim`, is the axis about which the chain folds.
///
/// Between the chain as it is and the chain pulled straight, or folded up, the distance changes
/// continuously, so that it is right somewhere in between.
fn close(links: &Links, distance: f64, aim: DVec3, normal: DVec3) -> Vec<DVec3> {
    let opens = links.end().length() < distance;
    let goals = if opens {
        let along = links.end().try_normalize().unwrap_or(aim);
        vec![along; links.lengths.len()]
    } else {
        folded(links, aim, normal)
    };
    let ways = links.directions.iter().zip(goals);
    let ways: Vec<_> = ways
        .map(|(&from, to)| (from, arc(from, to, normal)))
        .collect();
    let blended = |part: f64| {
        let blend = |&(from, way): &(DVec3, DQuat)| DQuat::IDENTITY.slerp(way, part) * from;
        links.along(ways.iter().map(blend).collect())
    };
    let (mut near, mut far) = (0.0, 1.0);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (near + far);
        if (blended(middle).end().length() < distance) == opens {
            near = middle;
        } else {
            far = middle;
        }
    }
    let closed = blended(0.5 * (near + far));
    let end = closed.end().try_normalize();
    let turn = end.map_or(DQuat::IDENTITY, |end| arc(end, aim, normal));
    closed.directions.into_iter().map(|d| turn * d).collect()
}

/// Directions of the links as three straight rods that bring the end as near to the first joint as
/// possible: they form a triangle, or else the middle rod, longer than the others together, lies
/// along `aim` and the others against it.
fn folded(links: &Links, aim: DVec3, normal: DVec3) -> Vec<DVec3> {
    let half = 0.5 * links.total();
    let mut before = 0.0;
    let mut middle = 0;
    while middle + 1 < links.lengths.len() && before + links.lengths[middle] < half {
        before += links.lengths[middle];
        middle += 1;
    }
    let rod = links.lengths[middle];
    let after = (links.total() - before - rod).max(0.0);
    let [first, second, third] = if rod >= half {
        [-aim, aim, -aim]
    } else {
        triangle([before, rod, after], aim, normal)
    };
    let mut directions = vec![first; middle];
    directions.push(second);
    directions.resize(links.lengths.len(), third);
    directions
}

/// Unit vectors along the sides of a triangle of these lengths, one after the other; the first is
/// `aim`.
fn triangle([a, b, c]: [f64; 3], aim: DVec3, normal: DVec3) -> [DVec3; 3] {
    let across = normal.cross(aim);
    let x = (a * a + c * c - b * b) / (2.0 * a);
    let corner = x * aim + (c * c - x * x).max(0.0).sqrt() * across;
    let second = (corner - a * aim).try_normalize().unwrap_or(-aim);
    let third = (-corner).try_normalize().unwrap_or(-aim);
    [aim, second, third]
}
