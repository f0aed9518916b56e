//! The left hand: palm, four fingers and a thumb, in a frame of its own.
use super::super::field::{blend, chain, ellipsoid, round_cone};
use super::body::{ELBOW, WRIST};
use glam::DVec3;

/// A finger as (knuckle across the palm, along, spread, lengths, radius).
type Finger = (f64, f64, f64, [f64; 3], f64);

const FINGERS: [Finger; 4] = [
    (0.0345, 0.088, 0.11, [0.042, 0.026, 0.018], 0.0104),
    (0.0112, 0.092, 0.02, [0.046, 0.030, 0.020], 0.0107),
    (-0.0122, 0.088, -0.07, [0.043, 0.028, 0.019], 0.0102),
    (-0.0342, 0.079, -0.17, [0.034, 0.021, 0.017], 0.0090),
];

/// The frame at the wrist: along the fingers, out of the back of the hand, toward the thumb.
fn frame() -> [DVec3; 3] {
    let along = (WRIST - ELBOW).normalize_or_zero();
    let along = (along + DVec3::new(0.0, -0.10, -0.06)).normalize_or_zero();
    let thumb = (DVec3::Z - along * along.z).normalize_or_zero();
    let back = thumb.cross(along);
    // Turned about the forearm, so that the palm looks in and back a little.
    let (sin, cos) = (0.26, 0.9656);
    [along, back * cos + thumb * sin, thumb * cos - back * sin]
}

/// About the middle of the hand.
pub fn center() -> DVec3 {
    WRIST + frame()[0] * 0.095
}

/// About where the fingers end.
pub fn tips() -> DVec3 {
    WRIST + frame()[0] * 0.160 - frame()[1] * 0.03
}

/// The surface of the left hand with the wrist in the sleeve.
pub fn surface(p: DVec3) -> f64 {
    let rough = (p - center()).length() - 0.125;
    if rough > 0.05 {
        return rough;
    }
    let [along, back, thumb] = frame();
    let q = p - WRIST;
    let q = DVec3::new(q.dot(along), q.dot(back), q.dot(thumb));
    let wrist = chain_flat(
        q,
        &[
            (DVec3::new(-0.07, 0.0, 0.0), 0.026),
            (DVec3::new(0.012, 0.0, 0.0), 0.0255),
        ],
        0.8,
    );
    let palm = chain_flat(
        q,
        &[
            (DVec3::new(0.030, -0.002, 0.020), 0.024),
            (DVec3::new(0.082, 0.0, 0.026), 0.0185),
        ],
        0.68,
    );
    let heel = chain_flat(
        q,
        &[
            (DVec3::new(0.030, -0.003, -0.014), 0.024),
            (DVec3::new(0.076, 0.0, -0.024), 0.0185),
        ],
        0.68,
    );
    let middle = chain_flat(
        q,
        &[
            (DVec3::new(0.03, 0.0, 0.0), 0.024),
            (DVec3::new(0.084, 0.001, 0.002), 0.0185),
        ],
        0.66,
    );
    let mut d = blend(blend(palm, heel, 0.012), middle, 0.012);
    d = blend(d, wrist, 0.022);
    d = blend(
        d,
        ellipsoid(
            q,
            DVec3::new(0.034, -0.012, 0.026),
            DVec3::new(0.028, 0.014, 0.016),
        ),
        0.014,
    );
    for finger in FINGERS {
        d = blend(d, self::finger(q, finger), 0.0045);
    }
    blend(d, thumb_surface(q), 0.010)
}

/// A chain of round cones pressed flat against the palm.
fn chain_flat(q: DVec3, spheres: &[(DVec3, f64)], flat: f64) -> f64 {
    let press = |v: DVec3| DVec3::new(v.x, v.y / flat, v.z);
    let pressed: Vec<(DVec3, f64)> = spheres.iter().map(|s| (press(s.0), s.1)).collect();
    chain(press(q), &pressed) * flat
}

/// A finger, bent a little more at each joint.
fn finger(q: DVec3, finger: Finger) -> f64 {
    let points = joints_of(finger);
    let radius = finger.4;
    let mut d = f64::INFINITY;
    for i in 0..3 {
        let (from, end) = (
            radius * (1.0 - 0.05 * i as f64),
            radius * (0.95 - 0.06 * i as f64),
        );
        let bone = round_cone(q, (points[i], from), (points[i + 1], end));
        d = blend(d, bone, 0.002);
    }
    d
}

/// The knuckle, two joints and the end of a finger.
fn joints_of((across, along, spread, lengths, _): Finger) -> [DVec3; 4] {
    let mut at = DVec3::new(along, 0.0005, across);
    let mut points = [at; 4];
    // The slope toward the palm, in steps: relaxed fingers are never straight.
    for (i, (length, slope)) in lengths.into_iter().zip([0.16, 0.42, 0.62]).enumerate() {
        let direction = DVec3::new(1.0, -slope, spread).normalize_or_zero();
        at += direction * length;
        points[i + 1] = at;
    }
    points
}

/// The thumb's joints and end, with their radii.
const THUMB: [(DVec3, f64); 4] = [
    (DVec3::new(0.018, -0.006, 0.026), 0.0150),
    (DVec3::new(0.058, -0.014, 0.054), 0.0115),
    (DVec3::new(0.086, -0.018, 0.066), 0.0102),
    (DVec3::new(0.108, -0.022, 0.069), 0.0082),
];

fn thumb_surface(q: DVec3) -> f64 {
    chain(q, &THUMB)
}

/// The joints and the end of each finger of the left hand, the thumb first.
pub fn fingers() -> [[DVec3; 4]; 5] {
    let [along, back, thumb] = frame();
    let place = |q: DVec3| WRIST + along * q.x + back * q.y + thumb * q.z;
    let [index, middle, ring, little] = FINGERS.map(joints_of);
    let thumb = THUMB.map(|sphere| sphere.0);
    [thumb, index, middle, ring, little].map(|points| points.map(place))
}
