//! The robot's arms, grippers and legs.
use super::super::mesh::Mesh;
use super::super::solids::{aimed, ball, drum, moved, rounded_box, shaped, turned};
use super::{ANKLE, Assembly, ELBOW, HIP, KNEE, SHOULDER, WRIST};
use glam::DVec3;

/// A limb: a turned sleeve along the line between two joints; `profile` is (radius, share of the
/// length).
fn limb(from: DVec3, to: DVec3, profile: &[(f64, f64)], sides: u32) -> Mesh {
    let length = from.distance(to);
    let profile: Vec<(f64, f64)> = profile.iter().map(|&(r, t)| (r, t * length)).collect();
    aimed(turned(&profile, sides), to - from, from)
}

pub fn arm(robot: &mut Assembly) {
    let outward = DVec3::new(0.9, 0.42, 0.0);
    robot.add_both("shoulder", moved(ball(0.064, 14), SHOULDER));
    let pad = [
        (0.0, 0.094),
        (0.036, 0.090),
        (0.066, 0.072),
        (0.082, 0.044),
        (0.086, 0.020),
        (0.080, 0.014),
        (0.070, 0.018),
        (0.0, 0.02),
    ];
    let pad: Vec<(f64, f64)> = pad.iter().rev().copied().collect();
    robot.add_both("shoulder", aimed(turned(&pad, 16), outward, SHOULDER));
    let upper = [
        (0.0, 0.16),
        (0.038, 0.16),
        (0.043, 0.20),
        (0.043, 0.60),
        (0.036, 0.66),
        (0.036, 0.86),
        (0.0, 0.86),
    ];
    robot.add_both("shoulder", limb(SHOULDER, ELBOW, &upper, 12));
    let hinge = (ELBOW - SHOULDER)
        .cross(WRIST - ELBOW)
        .normalize_or(DVec3::Z);
    robot.add_both("elbow", aimed(drum(0.050, 0.046, 0.012, 14), hinge, ELBOW));
    robot.add_both("elbow", aimed(drum(0.026, 0.053, 0.006, 10), hinge, ELBOW));
    let fore = [
        (0.0, 0.16),
        (0.034, 0.16),
        (0.040, 0.26),
        (0.060, 0.40),
        (0.063, 0.46),
        (0.060, 0.78),
        (0.054, 0.84),
        (0.036, 0.86),
        (0.0, 0.86),
    ];
    robot.add_both("elbow", limb(ELBOW, WRIST, &fore, 14));
}

fn along_forearm() -> DVec3 {
    (WRIST - ELBOW).normalize_or(DVec3::NEG_Y)
}

/// The hinges of the gripper's two jaws, on either side of the wrist.
pub fn jaws() -> [DVec3; 2] {
    let across = DVec3::Z - along_forearm() * along_forearm().z;
    [1.0, -1.0].map(|side| WRIST + along_forearm() * 0.045 + across * 0.032 * side)
}

pub fn gripper(robot: &mut Assembly) {
    let along = along_forearm();
    robot.add_both("wrist", aimed(drum(0.040, 0.020, 0.008, 12), along, WRIST));
    let palm = rounded_box(DVec3::new(0.034, 0.024, 0.052), 0.012, 1);
    robot.add_both("wrist", aimed(palm, along, WRIST + along * 0.034));
    let across = (DVec3::Z - along * along.z).normalize_or(DVec3::Z);
    let third = along.cross(across);
    for (side, name, hinge) in [
        (1.0, "upper jaw", jaws()[0]),
        (-1.0, "lower jaw", jaws()[1]),
    ] {
        robot.add_both(name, aimed(drum(0.018, 0.030, 0.005, 12), third, hinge));
        // A jaw bows outward and comes back to meet the other at its tip.
        let profile = [
            (0.0, 0.0),
            (0.018, 0.002),
            (0.021, 0.022),
            (0.019, 0.050),
            (0.015, 0.078),
            (0.010, 0.102),
            (0.0, 0.108),
        ];
        let claw = shaped(turned(&profile, 8), |p| {
            let t = p.y / 0.108;
            let bow = 0.110 * t * (0.72 - t);
            hinge + third * p.x + along * p.y + across * (side * bow + p.z * 0.62)
        });
        robot.add_both(name, claw);
    }
}

pub fn leg(robot: &mut Assembly) {
    robot.add_both("leg", moved(ball(0.060, 12), HIP));
    let thigh = [
        (0.0, 0.10),
        (0.056, 0.10),
        (0.066, 0.16),
        (0.068, 0.30),
        (0.056, 0.70),
        (0.046, 0.78),
        (0.046, 0.90),
        (0.0, 0.90),
    ];
    robot.add_both("leg", limb(HIP, KNEE, &thigh, 14));
    robot.add_both("knee", aimed(drum(0.058, 0.056, 0.014, 14), DVec3::X, KNEE));
    robot.add_both("knee", aimed(drum(0.030, 0.064, 0.006, 10), DVec3::X, KNEE));
    let cap = shaped(
        rounded_box(DVec3::new(0.040, 0.050, 0.020), 0.014, 1),
        |p| {
            DVec3::new(
                p.x * (1.0 - 3.0 * p.y.min(0.0).abs()),
                p.y,
                p.z - 4.0 * p.y * p.y,
            )
        },
    );
    robot.add_both("knee", moved(cap, KNEE + DVec3::new(0.0, 0.002, 0.058)));
    let shin = [
        (0.0, 0.14),
        (0.044, 0.14),
        (0.048, 0.22),
        (0.070, 0.36),
        (0.078, 0.50),
        (0.082, 0.84),
        (0.074, 0.90),
        (0.044, 0.92),
        (0.0, 0.92),
    ];
    robot.add_both("knee", limb(KNEE, ANKLE, &shin, 14));
    robot.add_both("foot", moved(ball(0.044, 12), ANKLE));
    let foot = shaped(
        rounded_box(DVec3::new(0.075, 0.042, 0.135), 0.028, 2),
        |p| {
            // Flat soles, the back higher than the toes.
            let front = (p.z + 0.135) / 0.27;
            let height = if p.y > 0.0 {
                p.y * (1.25 - 0.75 * front)
            } else {
                p.y
            };
            DVec3::new(p.x * (0.82 + 0.28 * front), height, p.z)
        },
    );
    robot.add_both("foot", moved(foot, ANKLE + DVec3::new(0.0, -0.058, 0.045)));
    let toe = rounded_box(DVec3::new(0.066, 0.020, 0.030), 0.014, 1);
    robot.add_both("foot", moved(toe, ANKLE + DVec3::new(0.0, -0.062, 0.172)));
}
