//! Bones of the characters in view, as they lie in its picture.

use crate::character::Joint;
use crate::editor::Session;
use crate::scene::bones_in_world;
use glam::Vec2;

/// Points along a bone that are looked at.
const SAMPLES: u8 = 16;

/// A character in view.
pub(super) struct CharacterSeen<'a> {
    pub joints: &'a [Joint],
    /// Joints that turn bones, and where points along the bone are, in pixels, from the joint on. Those behind the camera
    /// are left out.
    pub bones: Vec<(usize, Vec<Vec2>)>,
    /// How long these bones are, in the world.
    pub lengths: Vec<f32>,
    /// Name of the character, if there are several.
    name: Option<&'a str>,
}

impl CharacterSeen<'_> {
    /// Name of a joint, with the character's if there are several.
    pub fn name_of(&self, joint: usize) -> String {
        let joint = &self.joints[joint].name;
        match self.name {
            Some(name) => format!("{joint} of {name}"),
            None => joint.clone(),
        }
    }
}

/// The characters that are visible in a live view of `size` pixels.
pub(super) fn characters_seen(session: &Session, size: Vec2) -> Vec<CharacterSeen<'_>> {
    let (scene, evaluated) = (session.scene(), session.evaluated());
    let camera = &session.view().camera;
    let shapes = scene.shapes().iter().filter(|shape| shape.visible);
    let characters = shapes.filter_map(|shape| Some((shape, scene.character(shape.id)?)));
    let are_several = characters.clone().count() > 1;
    let seen = characters.filter_map(|(shape, character)| {
        let bones = bones_in_world(scene, evaluated.shape(shape.id)?);
        let bones = bones.map(|(joint, start, end)| {
            let along = (0..=SAMPLES).map(|i| f32::from(i) / f32::from(SAMPLES));
            let pixels = along.filter_map(|t| camera.pixel(start.lerp(end, t), size));
            ((joint, pixels.collect()), start.distance(end))
        });
        let (bones, lengths) = bones.unzip();
        Some(CharacterSeen {
            joints: character.character.skeleton().joints(),
            bones,
            lengths,
            name: are_several.then_some(&*shape.name),
        })
    });
    seen.collect()
}
