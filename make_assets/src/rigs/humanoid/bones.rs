//! The humanoid's bones, and which of them each place follows.
use super::super::super::adult::body::{ANKLE, ELBOW, HIP, KNEE, SHOULDER, WRIST};
use super::super::super::adult::{binding, hand};
use super::super::grown::bone;
use super::super::model::{Bone, Rig};
use glam::DVec3;

const FINGERS: [&str; 5] = ["thumb", "index", "middle", "ring", "little"];
/// Between the toes and the rest of the foot.
const TOES: DVec3 = DVec3::new(0.146, 0.030, 0.115);

/// Adds all bones, parents first; the one that goes on along a bone is its first child.
pub fn add(rig: &mut Rig) {
    let middle = |y: f64, z: f64| DVec3::new(0.0, y, z);
    bone(rig, "Hips", "", middle(0.985, -0.01), middle(1.120, -0.01));
    bone(
        rig,
        "Spine",
        "Hips",
        middle(1.120, -0.01),
        middle(1.315, -0.01),
    );
    bone(
        rig,
        "Chest",
        "Spine",
        middle(1.315, -0.01),
        middle(1.500, -0.022),
    );
    bone(
        rig,
        "Neck",
        "Chest",
        middle(1.500, -0.022),
        middle(1.600, -0.005),
    );
    bone(
        rig,
        "Head",
        "Neck",
        middle(1.600, -0.005),
        middle(1.810, -0.005),
    );
    let collar = DVec3::new(0.022, 1.440, 0.020);
    bone(rig, "Left collarbone", "Chest", collar, SHOULDER);
    bone(rig, "Left arm", "Left collarbone", SHOULDER, ELBOW);
    bone(rig, "Left forearm", "Left arm", ELBOW, WRIST);
    let fingers = hand::fingers();
    bone(rig, "Left hand", "Left forearm", WRIST, fingers[2][0]);
    for finger in [2, 1, 3, 4, 0] {
        let points = fingers[finger];
        let mut parent = "Left hand".to_owned();
        for part in 0..3 {
            let name = format!("Left {} {}", FINGERS[finger], part + 1);
            let end = points[part + 1];
            // The last bone goes on to the end of the flesh.
            let flesh = if part == 2 { 0.008 } else { 0.0 };
            let tail = end + (end - points[part]).normalize_or(DVec3::Y) * flesh;
            bone(rig, &name, &parent, points[part], tail);
            parent = name;
        }
    }
    bone(rig, "Left leg", "Hips", HIP, KNEE);
    bone(rig, "Left shin", "Left leg", KNEE, ANKLE);
    bone(rig, "Left foot", "Left shin", ANKLE, TOES);
    bone(
        rig,
        "Left toes",
        "Left foot",
        TOES,
        TOES + DVec3::new(0.011, -0.004, 0.075),
    );
}

/// Finds the bone of a place.
pub struct Owner<'a> {
    bones: &'a [Bone],
    fingers: [[DVec3; 4]; 5],
}

impl<'a> Owner<'a> {
    pub fn new(bones: &'a [Bone]) -> Self {
        Self {
            bones,
            fingers: hand::fingers(),
        }
    }

    /// The index of the bone that a place on the surface belongs to.
    pub fn of(&self, p: DVec3) -> usize {
        let near = DVec3::new(p.x.abs(), p.y, p.z);
        let part = match binding::owner(p) {
            1 => "Spine".to_owned(),
            2 | 4 | 8 => "Hips".to_owned(),
            3 if near.y > 1.600 - 0.50 * near.z.clamp(-0.03, 0.08) => "Head".to_owned(),
            3 => "Neck".to_owned(),
            5 | 9 => "leg".to_owned(),
            6 | 10 => "shin".to_owned(),
            7 | 11 if near.z > TOES.z + 0.004 => "toes".to_owned(),
            7 | 11 => "foot".to_owned(),
            12 | 15 if near.x > 0.075 && near.y > 1.37 => "collarbone".to_owned(),
            13 | 16 => "arm".to_owned(),
            14 | 17 => self.of_forearm(near),
            _ => "Chest".to_owned(),
        };
        let side = if p.x < 0.0 { "Right" } else { "Left" };
        let sided = format!("{side} {part}");
        let found = |name: &str| self.bones.iter().position(|bone| bone.name == name);
        found(&part).or_else(|| found(&sided)).unwrap_or(0)
    }

    /// Forearm, hand or a part of a finger, for a place of the left arm.
    fn of_forearm(&self, p: DVec3) -> String {
        if (p - WRIST).dot(WRIST - ELBOW) < 0.0 {
            return "forearm".to_owned();
        }
        let mut best = (f64::INFINITY, "hand".to_owned());
        for (name, points) in FINGERS.iter().zip(&self.fingers) {
            for part in 0..3 {
                let (from, to) = (points[part], points[part + 1]);
                let axis = to - from;
                let along = (p - from).dot(axis) / axis.length_squared();
                let off = p.distance(from + axis * along.clamp(0.0, 1.0));
                // What lies behind a knuckle is the palm's.
                let is_behind = part == 0 && along < 0.08;
                if off < best.0 {
                    best = (
                        off,
                        if is_behind {
                            "hand".to_owned()
                        } else {
                            format!("{name} {}", part + 1)
                        },
                    );
                }
            }
        }
        // The middle of the palm is far from every finger.
        if best.0 < 0.024 {
            best.1
        } else {
            "hand".to_owned()
        }
    }
}

/// How far borders are softened, where it is not as for the adult.
pub fn reach(p: DVec3) -> Option<f64> {
    let near = DVec3::new(p.x.abs(), p.y, p.z);
    let beyond = (near - WRIST).dot((WRIST - ELBOW).normalize_or(DVec3::Y));
    if near.x > 0.3 && beyond > 0.06 {
        return Some(0.0050);
    }
    (near.x > 0.3 && beyond > -0.05).then_some(0.014)
}
