//! A chain of long boxes with rubber bellows between them.
use super::super::solids::{aimed, drum, moved, rounded_box, turned};
use super::model::{Rig, Skin, along_chain, plain};
use glam::DVec3;
use std::f64::consts::TAU;

const LINKS: usize = 6;
/// From one joint to the next.
const LENGTH: f64 = 0.32;
/// Between a joint and the box on either side.
const GAP: f64 = 0.045;
const HALF: DVec3 = DVec3::new(0.105, LENGTH / 2.0 - GAP, 0.072);

pub fn rig() -> Rig {
    let mut rig = Rig::new(
        "Chain",
        vec![
            plain("Red", [0.78, 0.16, 0.13]),
            plain("White", [0.90, 0.88, 0.84]),
            plain("Rubber", [0.13, 0.14, 0.16]),
            plain("Steel", [0.56, 0.60, 0.65]),
        ],
    );
    let start = |link: usize| -0.96 + LENGTH * link as f64;
    let mut bones = Vec::new();
    for link in 0..LINKS {
        let parent = link.checked_sub(1);
        let (head, tail) = (DVec3::Y * start(link), DVec3::Y * start(link + 1));
        bones.push(rig.bone(format!("Link {}", link + 1), parent, head, tail));
    }
    let starts: Vec<f64> = (0..LINKS).map(start).collect();
    let mut skin = Skin::new("Links");
    for (link, &bone) in bones.iter().enumerate() {
        let middle = DVec3::Y * (start(link) + LENGTH / 2.0);
        // The links taper toward the end, like a tail.
        let slim = 1.0 - 0.07 * link as f64;
        let half = DVec3::new(HALF.x * slim, HALF.y, HALF.z * slim);
        let body = moved(rounded_box(half, 0.024, 2), middle);
        skin.add_rigid(&body, link % 2, bone);
        for side in [-1.0, 1.0] {
            for end in [-1.0, 1.0] {
                let bolt = drum(0.019 * slim, 0.010, 0.005, 12);
                let at = middle + DVec3::new(0.0, end * 0.070, side * half.z);
                skin.add_rigid(&aimed(bolt, DVec3::Z, at), 3, bone);
            }
        }
        if link > 0 {
            let rubber = moved(turned(&bellows(0.060 * slim), 16), DVec3::Y * start(link));
            skin.add(&rubber, 2, |p| {
                along_chain(p.y, &bones, &starts, GAP + 0.02)
            });
        }
    }
    let foot = moved(drum(0.17, 0.025, 0.012, 32), DVec3::Y * (start(0) + 0.010));
    skin.add_rigid(&foot, 3, bones[0]);
    rig.skins.push(skin);
    rig
}

/// The profile of bellows about a joint; its ends lie inside the boxes.
fn bellows(radius: f64) -> Vec<(f64, f64)> {
    const STEPS: usize = 16;
    let reach = GAP + 0.012;
    let fold = |i: usize| {
        let t = i as f64 / STEPS as f64;
        let wave = 0.5 - 0.5 * (TAU * 4.0 * t).cos();
        (radius - 0.014 * (1.0 - wave), reach * (2.0 * t - 1.0))
    };
    let mut profile = vec![(0.0, -reach)];
    profile.extend((0..=STEPS).map(fold));
    profile.push((0.0, reach));
    profile
}
