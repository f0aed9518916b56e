//! A robot of rigid parts: each part is a closed solid that follows one joint alone.
mod limbs;
mod trunk;

use super::mesh::Mesh;
use super::rig::{self, Character, Joint};
use super::solids::reflected;
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
    trunk::trunk(&mut robot);
    trunk::head(&mut robot);
    limbs::arm(&mut robot);
    limbs::gripper(&mut robot);
    limbs::leg(&mut robot);
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
    let [upper, lower] = limbs::jaws();
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
