//! Whether the other picture shows the skeleton of a character whose mesh is in the live view.

use super::bones_seen::{BoneSeen, characters_seen};
use crate::editor::Session;
use crate::geometry::BONE_HALF_WIDTH;
use crate::math::distance_from_segment;
use crate::scene::ShapeId;
use glam::Vec2;

/// How far from the middle of a bone its box and the spheres of its joints reach, in the character's space.
const REACH: f32 = 2.0 * BONE_HALF_WIDTH;
/// Pixels beside that which edges and rounding add.
const EDGE: f32 = 2.0;
/// Share of what the other picture shows that lies along bones, where it is they: with shadows of the ground behind it was 0.9, and
/// of these alone 0.5.
const ALONG: f32 = 0.85;
/// Share of the bones that something of the other picture lies along, then, as others may be behind shapes: of skeletons it was 0.68
/// to 0.9.
const COVERED: f32 = 0.6;

/// Whether pixels of the other picture, which stand for those up to `apart` from them, are the bones of a character as it is posed in
/// a live view of `size` pixels.
pub(super) fn shows_skeleton(
    session: &Session,
    character: ShapeId,
    theirs: &[(u32, u32)],
    apart: u32,
    size: Vec2,
) -> bool {
    let characters = characters_seen(session, size).into_iter();
    let seen = characters
        .filter(|seen| seen.shape == character)
        .map(|seen| seen.bones);
    let bones: Vec<BoneSeen> = seen.flatten().collect();
    let Some(reach) = reach(session, character, size.y) else {
        return false;
    };
    let lines: Vec<[Vec2; 2]> = bones.iter().filter_map(BoneSeen::line).collect();
    let pixels = theirs.iter().map(|&(x, y)| Vec2::new(x as f32, y as f32));
    let pixels: Vec<Vec2> = pixels.collect();
    let is_along = |pixel: &&Vec2| {
        let mut distances = lines
            .iter()
            .map(|line| distance_from_segment(**pixel, *line));
        distances.any(|distance| distance <= reach)
    };
    let along: Vec<&Vec2> = pixels.iter().filter(is_along).collect();
    if along.is_empty() || (along.len() as f32) < ALONG * pixels.len() as f32 {
        return false;
    }
    let points = bones.iter().flat_map(|bone| &bone.pixels);
    let near = reach + apart as f32;
    let covered = points
        .clone()
        .filter(|point| along.iter().any(|pixel| pixel.distance(**point) <= near));
    covered.count() as f32 >= COVERED * points.count() as f32
}

/// How far a bone of a character reaches in a view so many pixels high.
fn reach(session: &Session, character: ShapeId, height: f32) -> Option<f32> {
    let shape = session.evaluated().shape(character)?;
    let camera = &session.view().camera;
    let middle = shape.world_box().center();
    let world_per_pixel = camera.world_per_pixel(middle, height)?;
    Some(REACH * shape.scale() / world_per_pixel + EDGE)
}
