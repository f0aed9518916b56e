//! A robot of rigid parts: each part is a closed solid that follows one joint alone.
use super::mesh::Mesh;
use super::rig::{self, Character, Joint};
use super::solids::{aimed, ball, drum, moved, reflected, rounded_box, shaped, turned};
use glam::DVec3;

const HIP: DVec3 = DVec3::new(0.105, -0.115, 0.0);
const KNEE: DVec3 = DVec3::new(0.118, -0.430, 0.010);
const ANKLE: DVec3 = DVec3::new(0.125, -0.730, -0.010);
const SHOULDER: DVec3 = DVec3::new(0.262, 0.330, 0.0);
const ELBOW: DVec3 = DVec3::new(0.372, 0.095, 0.0);
const WRIST: DVec3 = DVec3::new(0.452, -0.120, 0.055);
const NECK: DVec3 = DVec3::new(0.0, 0.430, 0.0);

/// The parts so far, with the weights of their vertices.
struct Assembly {
    joints: Vec<Joint>,
    mesh: Mesh,
    owners: Vec<usize>,
}

impl Assembly {
    fn add(&mut self, joint: &str, part: Mesh) {
        let joint = self
            .joints
            .iter()
            .position(|j| j.name == joint)
            .unwrap_or(0);
        self.owners.extend(part.positions.iter().map(|_| joint));
        self.mesh.append(&part);
    }

    /// Adds a part to the left limb and its reflection to the right one.
    fn add_both(&mut self, joint: &str, part: Mesh) {
        self.add(&format!("Right {joint}"), reflected(&part));
        self.add(&format!("Left {joint}"), part);
    }
}

/// The whole robot, facing +Z.
pub fn character() -> Character {
    let mut robot = Assembly {
        joints: joints(),
        mesh: Mesh::default(),
        owners: Vec::new(),
    };
    trunk(&mut robot);
    head(&mut robot);
    arm(&mut robot);
    gripper(&mut robot);
    leg(&mut robot);
    let count = robot.joints.len() - 1;
    let row = |&owner: &usize| {
        (1..=count)
            .map(|c| if c == owner { 1.0 } else { 0.0 })
            .collect()
    };
    Character {
        weights: robot.owners.iter().map(row).collect(),
        joints: robot.joints,
        mesh: robot.mesh,
    }
}

fn joints() -> Vec<Joint> {
    let right = |p: DVec3| DVec3::new(-p.x, p.y, p.z);
    let [upper, lower] = jaws();
    rig::joints(&[
        ("Root", -1, DVec3::new(0.0, -0.04, 0.0)),
        ("Hips", 0, DVec3::new(0.0, -0.04, 0.0)),
        ("Torso", 0, DVec3::new(0.0, 0.035, 0.0)),
        ("Neck", 2, NECK),
        ("Head", 3, NECK + DVec3::Y * 0.06),
        ("Antenna", 4, DVec3::new(0.0, 0.735, -0.02)),
        ("Right shoulder", 2, right(SHOULDER)),
        ("Right elbow", 6, right(ELBOW)),
        ("Right wrist", 7, right(WRIST)),
        ("Right upper jaw", 8, right(upper)),
        ("Right lower jaw", 8, right(lower)),
        ("Left shoulder", 2, SHOULDER),
        ("Left elbow", 11, ELBOW),
        ("Left wrist", 12, WRIST),
        ("Left upper jaw", 13, upper),
        ("Left lower jaw", 13, lower),
        ("Right leg", 1, right(HIP)),
        ("Right knee", 16, right(KNEE)),
        ("Right foot", 17, right(ANKLE)),
        ("Left leg", 1, HIP),
        ("Left knee", 19, KNEE),
        ("Left foot", 20, ANKLE),
    ])
}

fn trunk(robot: &mut Assembly) {
    let hips = shaped(rounded_box(DVec3::new(0.150, 0.062, 0.098), 0.03, 1), |p| {
        let narrow = 1.0 + 2.4 * p.y;
        DVec3::new(p.x * narrow, p.y, p.z * narrow)
    });
    robot.add("Hips", moved(hips, DVec3::new(0.0, -0.060, 0.0)));
    robot.add(
        "Hips",
        moved(
            rounded_box(DVec3::new(0.034, 0.026, 0.012), 0.008, 1),
            DVec3::new(0.0, -0.045, 0.098),
        ),
    );
    let ribs = [
        (0.0, -0.06),
        (0.088, -0.06),
        (0.096, -0.045),
        (0.082, -0.030),
        (0.096, -0.015),
        (0.082, 0.0),
        (0.096, 0.015),
        (0.082, 0.030),
        (0.090, 0.045),
        (0.0, 0.06),
    ];
    robot.add("Torso", moved(turned(&ribs, 16), DVec3::Y * 0.045));
    let chest = shaped(
        rounded_box(DVec3::new(0.195, 0.165, 0.125), 0.055, 2),
        |p| {
            // Broad shoulders, a narrower waist, and a breast that bows forward.
            let wide = 1.0 + 1.05 * p.y;
            DVec3::new(p.x * wide, p.y, p.z * (1.0 + 0.45 * p.y) + 0.10 * p.y)
        },
    );
    robot.add("Torso", moved(chest, DVec3::new(0.0, 0.245, 0.0)));
    let plate = shaped(
        rounded_box(DVec3::new(0.128, 0.085, 0.018), 0.012, 1),
        |p| {
            DVec3::new(
                p.x * (1.0 + 1.2 * p.y),
                p.y,
                p.z + 0.22 * p.y - 0.55 * p.x * p.x,
            )
        },
    );
    robot.add("Torso", moved(plate, DVec3::new(0.0, 0.285, 0.142)));
    let lamp = [
        (0.0, -0.02),
        (0.046, -0.02),
        (0.046, 0.006),
        (0.040, 0.013),
        (0.034, 0.013),
        (0.031, 0.006),
        (0.024, 0.013),
        (0.012, 0.018),
        (0.0, 0.019),
    ];
    robot.add(
        "Torso",
        aimed(
            turned(&lamp, 16),
            DVec3::new(0.0, -0.1, 1.0),
            DVec3::new(0.0, 0.285, 0.160),
        ),
    );
    for x in [-1.0, 0.0, 1.0] {
        let vent = rounded_box(DVec3::new(0.024, 0.007, 0.010), 0.005, 1);
        robot.add("Torso", moved(vent, DVec3::new(0.062 * x, 0.165, 0.110)));
    }
    let pack = shaped(
        rounded_box(DVec3::new(0.125, 0.120, 0.050), 0.025, 1),
        |p| DVec3::new(p.x * (1.0 + 0.8 * p.y), p.y, p.z),
    );
    robot.add("Torso", moved(pack, DVec3::new(0.0, 0.255, -0.140)));
    for side in [-1.0, 1.0] {
        let tank = turned(
            &[
                (0.0, -0.125),
                (0.022, -0.118),
                (0.036, -0.095),
                (0.036, 0.095),
                (0.022, 0.118),
                (0.0, 0.125),
            ],
            12,
        );
        robot.add(
            "Torso",
            moved(tank, DVec3::new(0.058 * side, 0.255, -0.195)),
        );
    }
}

fn head(robot: &mut Assembly) {
    let bellows = [
        (0.0, -0.04),
        (0.058, -0.04),
        (0.058, -0.025),
        (0.046, -0.012),
        (0.058, 0.0),
        (0.046, 0.012),
        (0.058, 0.025),
        (0.046, 0.04),
        (0.046, 0.06),
        (0.0, 0.06),
    ];
    robot.add("Neck", moved(turned(&bellows, 14), NECK + DVec3::Y * 0.01));
    let center = DVec3::new(0.0, 0.605, 0.010);
    let skull = shaped(
        rounded_box(DVec3::new(0.142, 0.122, 0.125), 0.065, 2),
        |p| DVec3::new(p.x * (1.0 + 0.35 * p.y), p.y, p.z * (1.0 + 0.25 * p.y)),
    );
    robot.add("Head", moved(skull, center));
    // The visor bends round the face; two lenses look out of it.
    let visor = shaped(
        rounded_box(DVec3::new(0.130, 0.047, 0.026), 0.020, 3),
        |p| DVec3::new(p.x, p.y, p.z - 1.2 * p.x * p.x),
    );
    robot.add("Head", moved(visor, center + DVec3::new(0.0, 0.022, 0.122)));
    let lens = [
        (0.0, -0.02),
        (0.033, -0.02),
        (0.033, 0.004),
        (0.029, 0.009),
        (0.025, 0.009),
        (0.023, 0.003),
        (0.014, 0.011),
        (0.0, 0.014),
    ];
    for side in [-1.0, 1.0] {
        robot.add(
            "Head",
            aimed(
                turned(&lens, 14),
                DVec3::new(0.14 * side, 0.0, 1.0),
                center + DVec3::new(0.054 * side, 0.024, 0.147),
            ),
        );
        let ear = [
            (0.0, -0.03),
            (0.050, -0.03),
            (0.050, 0.004),
            (0.042, 0.014),
            (0.026, 0.014),
            (0.022, 0.026),
            (0.0, 0.026),
        ];
        robot.add(
            "Head",
            aimed(
                turned(&ear, 14),
                DVec3::X * side,
                center + DVec3::new(0.142 * side, 0.010, 0.0),
            ),
        );
    }
    for i in -1..=1 {
        let slot = rounded_box(DVec3::new(0.008, 0.016, 0.010), 0.004, 1);
        robot.add(
            "Head",
            moved(
                slot,
                center + DVec3::new(0.026 * f64::from(i), -0.062, 0.112),
            ),
        );
    }
    let crest = rounded_box(DVec3::new(0.022, 0.016, 0.085), 0.012, 1);
    robot.add(
        "Head",
        moved(crest, center + DVec3::new(0.0, 0.120, -0.005)),
    );
    let foot = DVec3::new(0.0, 0.735, -0.02);
    let rod = [
        (0.0, -0.015),
        (0.022, -0.015),
        (0.022, 0.0),
        (0.012, 0.012),
        (0.006, 0.016),
        (0.005, 0.105),
        (0.0, 0.11),
    ];
    robot.add("Antenna", moved(turned(&rod, 10), foot));
    robot.add("Antenna", moved(ball(0.023, 12), foot + DVec3::Y * 0.122));
}

/// A limb: a turned sleeve along the line between two joints; `profile` is (radius, share of the
/// length).
fn limb(from: DVec3, to: DVec3, profile: &[(f64, f64)], sides: u32) -> Mesh {
    let length = from.distance(to);
    let profile: Vec<(f64, f64)> = profile.iter().map(|&(r, t)| (r, t * length)).collect();
    aimed(turned(&profile, sides), to - from, from)
}

fn arm(robot: &mut Assembly) {
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
fn jaws() -> [DVec3; 2] {
    let across = DVec3::Z - along_forearm() * along_forearm().z;
    [1.0, -1.0].map(|side| WRIST + along_forearm() * 0.045 + across * 0.032 * side)
}

fn gripper(robot: &mut Assembly) {
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

fn leg(robot: &mut Assembly) {
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
