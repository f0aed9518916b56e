//! Differences placed by the bones of the characters in view.

use crate::compare::{Area, sentence};
use crate::editor::Session;
use crate::scene::bones_in_world;
use glam::Vec2;

/// Points along a bone that are looked at.
const SAMPLES: u8 = 8;
/// How far outside an area a bone may be, by the picture's height: limbs are so thick.
const NEAR: f32 = 0.04;

/// Sentence about where `area` of the live view is, which is a picture of `size` pixels, in words: by the joint that
/// turns the bone nearest to its middle, or else by where it lies in `figure`, the area round all
/// that is drawn.
pub(super) fn place(session: &Session, area: Area, figure: Area, size: (u32, u32)) -> String {
    let joint = if area.is_all_over(figure) {
        None
    } else {
        nearest_joint(session, area, size)
    };
    sentence(&match joint {
        Some(joint) => format!("near {joint}, in {} of the figure", area.part_of(figure)),
        None => area.place_in(figure),
    })
}

/// Name of the joint, with the character's if there are several.
fn nearest_joint(session: &Session, area: Area, size: (u32, u32)) -> Option<String> {
    let size = Vec2::new(size.0 as f32, size.1 as f32);
    let half = Vec2::new(area.width as f32, area.height as f32) / 2.0;
    let middle = Vec2::new(area.x as f32, area.y as f32) + half;
    let camera = &session.view().camera;
    let (scene, evaluated) = (session.scene(), session.evaluated());
    let mut nearest: Option<(f32, String)> = None;
    let characters = scene.shapes().iter().filter(|shape| shape.visible);
    let characters = characters.filter_map(|shape| Some((shape, scene.character(shape.id)?)));
    let several = characters.clone().count() > 1;
    for (shape, character) in characters {
        let Some(shown) = evaluated.shape(shape.id) else {
            continue;
        };
        let joints = character.character.skeleton().joints();
        for (joint, start, end) in bones_in_world(scene, shown) {
            let along = (0..=SAMPLES).map(|i| f32::from(i) / f32::from(SAMPLES));
            let pixels = along.filter_map(|t| camera.pixel(start.lerp(end, t), size));
            let pixels: Vec<Vec2> = pixels.collect();
            let outside = |pixel: &Vec2| ((pixel - middle).abs() - half).max(Vec2::ZERO).length();
            if !pixels.iter().any(|pixel| outside(pixel) <= NEAR * size.y) {
                continue;
            }
            // Of the whole bone: a shin ends where the foot begins, which alone may be off.
            let distances = pixels.iter().map(|pixel| (pixel - middle).length());
            let distance = distances.sum::<f32>() / pixels.len() as f32;
            if nearest.as_ref().is_none_or(|(least, _)| distance < *least) {
                let name = &joints[joint].name;
                let whose = if several {
                    format!("{name} of {}", shape.name)
                } else {
                    name.clone()
                };
                nearest = Some((distance, whose));
            }
        }
    }
    nearest.map(|(_, joint)| joint)
}
