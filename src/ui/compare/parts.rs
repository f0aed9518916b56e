//! Which parts of a scene differ: limbs, by the bones of the characters in view, and other shapes.

use super::bones_seen::{CharacterSeen, characters_seen};
use crate::compare::{Area, FigureOff};
use crate::editor::Session;
use glam::Vec2;

/// How far from a bone's line a pixel may be that is off where the bone is, by the figure's scale: the line runs through the
/// middle of a limb, which is off unless the limb has hardly moved.
const AT_BONE: f32 = 0.012;
/// Share of a bone's line that is off where the joint before it is turned: its beginning stays where it is.
const IS_OFF: f32 = 0.4;
/// Share of a bone's line from which on it is right, so that the joint above that it hangs on is not turned.
const IS_RIGHT: f32 = 0.5;
/// How far from its bones a limb reaches, by that scale, …
const THICK: f32 = 0.06;
/// … and the share of what is off that limbs have to have: with less something else differs, such as the camera.
const EXPLAINED: f32 = 0.9;
/// Percent of the figure from which on they are no limbs of it any more: a camera that is elsewhere leaves less of it right.
const FIGURE: f64 = 50.0;
/// Most parts that differ by themselves.
const MOST: usize = 6;

/// A part that differs: a limb, which is what a joint turns, or a shape.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Part {
    /// Name of the joint, with the character's if there are several, or of the shape.
    pub name: String,
    /// The area round what is off of it in either picture.
    pub area: Area,
    /// Share of the figure that this is, in percent.
    pub percent: f64,
}

/// A bone, and what differs along it.
struct BoneBeside {
    joint: usize,
    ends: [Vec2; 2],
    /// Shares of its line that are off and that are right, 0 to 1. Nothing is known of where the figure is thin.
    off: f32,
    right: f32,
}

/// Distance of a pixel from the line between two.
fn distance_from([start, end]: [Vec2; 2], pixel: Vec2) -> f32 {
    let along = end - start;
    let part = (pixel - start).dot(along) / along.length_squared().max(f32::MIN_POSITIVE);
    (start + along * part.clamp(0.0, 1.0)).distance(pixel)
}

/// Where a part is in the live view.
enum Reach {
    /// So far around bones.
    Bones(Vec<[Vec2; 2]>, f32),
    /// In the box around a shape.
    Box([Vec2; 2]),
}

impl Reach {
    /// How far a pixel is, by how far the part reaches. One in a box is as far as a limb reaches, so that it is a limb's where
    /// there is one.
    fn distance(&self, pixel: Vec2) -> f32 {
        match self {
            Self::Bones(bones, thick) => {
                let distances = bones.iter().map(|bone| distance_from(*bone, pixel));
                distances.fold(f32::INFINITY, f32::min) / thick
            }
            Self::Box([least, most]) => 1.0 + pixel.distance(pixel.clamp(*least, *most)),
        }
    }
}

/// How much higher a picture is than the bones in it of which it is the scale: that of smaller ones is less.
const FILLS: f32 = 2.0;

/// The scale of a character in a picture of such a height: that, or less where the character is small.
fn scale(character: &CharacterSeen, height: f32) -> f32 {
    let pixels = || {
        character
            .bones
            .iter()
            .flat_map(|(_, pixels)| pixels)
            .copied()
    };
    let size = |[least, most]: [Vec2; 2]| (most - least).max_element();
    let ends = pixels().reduce(Vec2::min).zip(pixels().reduce(Vec2::max));
    ends.map_or(height, |(least, most)| {
        height.min(FILLS * size([least, most]))
    })
}

/// The parts that differ in a live view of `size` pixels: limbs of the joints nearest to the root that turn bones that are
/// `off`, and shapes. None if these are not all that differs, or if together they are the figure itself, which a camera that
/// is elsewhere moves as well.
pub(super) fn parts(session: &Session, off: &FigureOff, size: (u32, u32)) -> Vec<Part> {
    let size = Vec2::new(size.0 as f32, size.1 as f32);
    let [ours, theirs, right] = [&off.ours, &off.theirs, &off.right].map(|pixels| {
        let pixels = pixels.iter().map(|&[x, y]| Vec2::new(x as f32, y as f32));
        pixels.collect::<Vec<Vec2>>()
    });
    let Some(limbs) = seen_limbs(session, [&ours, &right], size) else {
        return Vec::new();
    };
    let mut seen = limbs;
    seen.extend(seen_shapes(session, size));
    let nearest = |pixel: Vec2| {
        let distances = seen.iter().map(|(_, reach)| reach.distance(pixel));
        distances
            .enumerate()
            .min_by(|(_, a), (_, b)| a.total_cmp(b))
    };
    let is_at_part = |pixel: &&Vec2| nearest(**pixel).is_some_and(|(_, it)| it <= 1.0);
    let explained = ours.iter().filter(is_at_part).count() as f32;
    if explained < EXPLAINED * ours.len() as f32 {
        return Vec::new();
    }
    // The figure is as large in both pictures.
    let of_both = 2.0 * (ours.len() + right.len()) as f64;
    let mut pixels = vec![Vec::new(); seen.len()];
    for &pixel in ours.iter().chain(&theirs) {
        if let Some((part, _)) = nearest(pixel) {
            pixels[part].push((pixel.x as u32, pixel.y as u32));
        }
    }
    let parts = seen.into_iter().zip(pixels);
    let parts = parts.filter_map(|((name, _), pixels)| {
        let percent = 100.0 * pixels.len() as f64 / of_both;
        let area = Area::around(pixels)?;
        Some(Part {
            name,
            area,
            percent,
        })
    });
    let parts: Vec<Part> = parts.collect();
    let of_figure: f64 = parts.iter().map(|part| part.percent).sum();
    if parts.len() > MOST || of_figure >= FIGURE {
        return Vec::new();
    }
    parts
}

/// What is off of the shapes in a live view of `size` pixels. What is behind them tells nothing of them, such as where something
/// was or throws its shadow.
pub(super) fn of_shapes(session: &Session, off: &FigureOff, size: (u32, u32)) -> FigureOff {
    let mut of_shapes = off.clone();
    if off.has_outline {
        return of_shapes;
    }
    let size = Vec2::new(size.0 as f32, size.1 as f32);
    let characters = characters_seen(session, size).into_iter();
    let bodies = characters.map(|character| {
        let thick = THICK * scale(&character, size.y);
        let bones = character.bones.iter();
        let lines = bones.filter_map(|(_, pixels)| Some([*pixels.first()?, *pixels.last()?]));
        Reach::Bones(lines.collect(), thick)
    });
    let shapes = seen_shapes(session, size).into_iter();
    let all: Vec<Reach> = bodies.chain(shapes.map(|(_, shape)| shape)).collect();
    of_shapes.ours.retain(|&[x, y]| {
        let pixel = Vec2::new(x as f32, y as f32);
        all.iter().any(|shape| shape.distance(pixel) <= 1.0)
    });
    of_shapes
}

/// The visible shapes without bones, with the boxes around them. None where a shape is alone: what differs is it, then.
fn seen_shapes(session: &Session, size: Vec2) -> Vec<(String, Reach)> {
    let (scene, evaluated) = (session.scene(), session.evaluated());
    let camera = &session.view().camera;
    let visible = || scene.shapes().iter().filter(|shape| shape.visible);
    if visible().count() < 2 {
        return Vec::new();
    }
    let others = visible().filter(|shape| scene.character(shape.id).is_none());
    let boxes = others.filter_map(|shape| {
        let corners = evaluated.shape(shape.id)?.world_box().corners();
        // One that reaches behind the camera is everywhere.
        let pixels = corners.into_iter().map(|corner| camera.pixel(corner, size));
        let pixels = pixels.collect::<Option<Vec<Vec2>>>()?;
        let least = pixels.iter().copied().reduce(Vec2::min)?;
        let most = pixels.iter().copied().reduce(Vec2::max)?;
        Some((shape.name.to_string(), Reach::Box([least, most])))
    });
    boxes.collect()
}

/// The limbs whose bones are at pixels that are `off` in the live view while others are `right`, each with all of its bones;
/// `None` where a root is turned.
fn seen_limbs(
    session: &Session,
    [off, right]: [&[Vec2]; 2],
    size: Vec2,
) -> Option<Vec<(String, Reach)>> {
    let mut limbs: Vec<(String, Reach)> = Vec::new();
    for character in characters_seen(session, size) {
        let scale = scale(&character, size.y);
        let is_among = |at: Vec2, pixels: &[Vec2]| {
            let mut pixels = pixels.iter();
            pixels.any(|it| it.distance(at) <= AT_BONE * scale)
        };
        let joints = character.joints;
        let seen = character.bones.iter().filter_map(|(joint, pixels)| {
            let ends = [*pixels.first()?, *pixels.last()?];
            let (of_off, others): (Vec<Vec2>, Vec<Vec2>) =
                pixels.iter().partition(|&&at| is_among(at, off));
            let of_right = others.iter().filter(|&&at| is_among(at, right)).count();
            let share = |count: usize| count as f32 / (of_off.len() + others.len()) as f32;
            Some(BoneBeside {
                joint: *joint,
                ends,
                off: share(of_off.len()),
                right: share(of_right),
            })
        });
        let seen: Vec<BoneBeside> = seen.collect();
        let above =
            |joint| std::iter::successors(Some(joint), |&joint: &usize| joints[joint].parent);
        let is_turned = |joint: usize| {
            let mut own = seen.iter().filter(|bone| bone.joint == joint);
            let mut next = seen
                .iter()
                .filter(|bone| joints[bone.joint].parent == Some(joint));
            own.any(|bone| bone.off >= IS_OFF && bone.off > bone.right)
                && next.all(|bone| bone.right < IS_RIGHT)
        };
        let turned: Vec<bool> = (0..joints.len()).map(is_turned).collect();
        let tops: Vec<Option<usize>> = (0..joints.len())
            .map(|joint| above(joint).filter(|&above| turned[above]).last())
            .collect();
        let is_root = |joint: usize| joints[joint].parent.is_none();
        if tops.iter().flatten().any(|&top| is_root(top)) {
            return None;
        }
        let mut own: Vec<(usize, Vec<[Vec2; 2]>)> = Vec::new();
        for bone in seen {
            let Some(top) = tops[bone.joint] else {
                continue;
            };
            match own.iter_mut().find(|(joint, _)| *joint == top) {
                Some((_, bones)) => bones.push(bone.ends),
                None => own.push((top, vec![bone.ends])),
            }
        }
        let reach = |bones| Reach::Bones(bones, THICK * scale);
        let named = |(joint, bones)| (character.name_of(joint), reach(bones));
        limbs.extend(own.into_iter().map(named));
    }
    Some(limbs)
}
