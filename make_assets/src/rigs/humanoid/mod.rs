//! The adult once more, as other programs would have it: dressed in colors, with 51 joints down
//! to the ends of the fingers.
mod bones;
mod clothes;

use super::super::adult::{GROUND, binding};
use super::super::mesh::Mirrored;
use super::grown;
use super::model::{Rig, Skin};
use super::paint::Painted;

/// The rig; `body` stands on the ground.
pub fn rig(body: &Mirrored) -> Rig {
    let mut rig = Rig::new("Humanoid", clothes::materials());
    bones::add(&mut rig);
    let owner = bones::Owner::new(&rig.bones);
    let reach = |p| bones::reach(p).unwrap_or_else(|| binding::reach(p));
    let weights = grown::weights(body, &rig.bones, &|p| owner.of(p), &reach);
    let mut painted = Painted::new(body.mesh.clone(), weights);
    clothes::paint(&mut painted);
    for p in &mut painted.mesh.positions {
        p.y -= GROUND;
    }
    for bone in &mut rig.bones {
        bone.head.y -= GROUND;
        bone.tail.y -= GROUND;
    }
    let mut skin = Skin::new("Person");
    skin.add_painted(painted);
    rig.skins.push(skin);
    rig
}
