//! A bust with a jaw to open, a tongue, and eyes, lids and brows of their own. Modeled on the
//! adult's face, in meters above the ground, and enlarged at the end.
mod bones;
mod mouth;
mod surface;

use super::super::adult::face;
use super::super::polygonize::Grid;
use super::eye::eye;
use super::grown::{self, Seed};
use super::model::{Rig, Skin, plain};
use super::paint::Painted;
use glam::DVec3;

/// The middle of the bust, which becomes the origin, and how much larger it is than life.
const MIDDLE: DVec3 = DVec3::new(0.0, 1.628, 0.0);
const ENLARGED: f64 = 5.0;

/// Materials by index; the skin is what is not painted.
const HAIR: usize = 1;
const LIPS: usize = 2;
const PALATE: usize = 3;
const SHIRT: usize = 4;
const TEETH: usize = 5;
const TONGUE: usize = 6;
const EYE_WHITE: usize = 7;
const IRIS: usize = 8;
const PUPIL: usize = 9;

pub fn rig() -> Rig {
    let materials = vec![
        plain("Skin", [0.80, 0.55, 0.42]),
        plain("Hair", [0.13, 0.08, 0.06]),
        plain("Lips", [0.69, 0.36, 0.32]),
        plain("Palate", [0.36, 0.09, 0.10]),
        plain("Shirt", [0.20, 0.42, 0.44]),
        plain("Teeth", [0.95, 0.93, 0.87]),
        plain("Tongue", [0.80, 0.36, 0.36]),
        plain("Eye white", [0.95, 0.95, 0.93]),
        plain("Iris", [0.36, 0.25, 0.12]),
        plain("Pupil", [0.03, 0.03, 0.03]),
    ];
    let mut rig = Rig::new("Face", materials);
    bones::add(&mut rig);
    let head = grown::grow(&Seed {
        field: &surface::surface,
        grid: Grid {
            low: DVec3::new(0.0, 1.43, -0.14),
            high: DVec3::new(0.19, 1.84, 0.14),
            step: 0.0016,
        },
        size: &surface::size,
    });
    let owner = |p| bones::owner(&rig, p);
    let weights = grown::weights(&head, &rig.bones, &owner, &bones::reach);
    let mut painted = Painted::new(head.mesh, weights);
    surface::paint(&mut painted);
    let mut skin = Skin::new("Bust");
    skin.add_painted(painted);
    mouth::teeth(&mut skin, &rig);
    mouth::tongue(&mut skin, &rig);
    for (name, side) in [("Left eye", 1.0), ("Right eye", -1.0)] {
        let at = DVec3::new(face::EYE.x * side, face::EYE.y, face::EYE.z);
        let rings = [(PUPIL, 0.20), (IRIS, 0.44), (EYE_WHITE, 9.0)];
        let weights = vec![(bones::index(&rig, name), 1.0)];
        skin.add_painted(eye(at, 0.0151, DVec3::Z, &rings, &weights));
    }
    let enlarged = |p: &mut DVec3| *p = (*p - MIDDLE) * ENLARGED;
    skin.positions.iter_mut().for_each(enlarged);
    for bone in &mut rig.bones {
        enlarged(&mut bone.head);
        enlarged(&mut bone.tail);
    }
    rig.skins.push(skin);
    rig
}
