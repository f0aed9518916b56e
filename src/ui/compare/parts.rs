//! Which parts of a scene differ: limbs, by the bones of the characters in view, and other shapes.

use super::bones_seen::{CharacterSeen, characters_seen};
use crate::compare::{Area, FigureOff};
use crate::editor::Session;
use crate::scene::ShapeId;
use glam::Vec2;

/// How far from a bone's line a pixel may be that is off where the bone is, by the figure's scale: the line runs through the
/// middle of a limb, which is off unless the limb has hardly moved.
const AT_BONE: f32 = 0.012;
/// Share of a bone's line that is off where the joint before it is turned: its beginning stays where it is.
const IS_OFF: f32 = 0.4;
/// Share of a bone's line from which on it is right, so that the joint above that it hangs on is not turned.
const IS_RIGHT: f32 = 0.5;
/// Length of a bone, by the longest one of the figure, below which it is inside of the limb that hangs on it, as at hips.
const SHORT: f32 = 0.25;
/// Share of the bones that hang on a joint which may be right where it is turned: where they are now, others were.
const RIGHT_BELOW: f32 = 0.4;
/// How far from its bones a limb reaches, by that scale, …
const THICK: f32 = 0.06;
/// … and the share of what is off that limbs have to have: with less something else differs, such as the camera.
const EXPLAINED: f32 = 0.9;
/// The same where shadows are among what is off.
const EXPLAINED_ON_GROUND: f32 = 0.6;
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
    Bones {
        lines: Vec<[Vec2; 2]>,
        thick: f32,
        /// Where the joint is that turns them.
        joint: Vec2,
    },
    /// In the box around a shape.
    Box {
        id: ShapeId,
        least: Vec2,
        most: Vec2,
    },
}

impl Reach {
    /// How far a pixel is, by how far the part reaches. One in a box is as far as a limb reaches, so that it is a limb's where
    /// there is one.
    fn distance(&self, pixel: Vec2) -> f32 {
        match self {
            Self::Bones { lines, thick, .. } => {
                let distances = lines.iter().map(|line| distance_from(*line, pixel));
                distances.fold(f32::INFINITY, f32::min) / thick
            }
            Self::Box { least, most, .. } => 1.0 + pixel.distance(pixel.clamp(*least, *most)),
        }
    }

    /// Whether what was at a pixel can be the part, turned otherwise or moved.
    fn may_have_been_at(&self, pixel: Vec2) -> bool {
        match self {
            Self::Bones {
                lines,
                thick,
                joint,
            } => {
                let ends = lines.iter().flatten().map(|end| end.distance(*joint));
                pixel.distance(*joint) <= ends.fold(0.0, f32::max) + thick
            }
            Self::Box { .. } => true,
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
    let shapes = seen_shapes(session, size).into_iter();
    seen.extend(shapes.filter(|(_, reach)| shows(session, reach, &ours, size)));
    let nearest = |pixel: Vec2| {
        let distances = seen.iter().map(|(_, reach)| reach.distance(pixel));
        distances
            .enumerate()
            .min_by(|(_, a), (_, b)| a.total_cmp(b))
    };
    let is_at_part = |pixel: &&Vec2| nearest(**pixel).is_some_and(|(_, it)| it <= 1.0);
    let explained = ours.iter().filter(is_at_part).count() as f32;
    let needed = match off.has_outline {
        true => EXPLAINED,
        false => EXPLAINED_ON_GROUND,
    };
    if explained < needed * ours.len() as f32 {
        return Vec::new();
    }
    // The figure is as large in both pictures.
    let of_both = 2.0 * (ours.len() + right.len()) as f64;
    let mut pixels = vec![Vec::new(); seen.len()];
    let mut add = |part: usize, pixel: Vec2| pixels[part].push((pixel.x as u32, pixel.y as u32));
    for &pixel in &ours {
        if let Some((part, _)) = nearest(pixel) {
            add(part, pixel);
        }
    }
    for &pixel in &theirs {
        let all = seen.iter().enumerate();
        let may_be = all.filter(|(_, (_, reach))| reach.may_have_been_at(pixel));
        let distances = may_be.map(|(part, (_, reach))| (part, reach.distance(pixel)));
        if let Some((part, _)) = distances.min_by(|(_, a), (_, b)| a.total_cmp(b)) {
            add(part, pixel);
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
        Reach::Bones {
            lines: lines.collect(),
            thick,
            joint: Vec2::ZERO,
        }
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
        let id = shape.id;
        Some((shape.name.to_string(), Reach::Box { id, least, most }))
    });
    boxes.collect()
}

/// Pixels in the box around a shape of which it is found out whether the shape is there, …
const PROBED: usize = 64;
/// … and the share of them from which on the shape differs, and not only what was behind or before it.
const SHOWS: f64 = 0.3;

/// Whether many of the pixels `ours` in a box show the shape.
fn shows(session: &Session, reach: &Reach, ours: &[Vec2], size: Vec2) -> bool {
    let Reach::Box { id, .. } = reach else {
        return true;
    };
    let Some(shape) = session.evaluated().shape(*id) else {
        return false;
    };
    let inside: Vec<Vec2> = ours
        .iter()
        .copied()
        .filter(|pixel| reach.distance(*pixel) <= 1.0)
        .collect();
    let probed = inside.iter().step_by(inside.len().div_ceil(PROBED).max(1));
    let camera = &session.view().camera;
    let count = probed.len() as f64;
    let met = probed.filter(|pixel| shape.is_met_by(&camera.ray(**pixel, size)));
    met.count() as f64 > SHOWS * count
}

/// Pixels by where they are.
struct PixelMap {
    is_in: Vec<bool>,
    size: [usize; 2],
}

impl PixelMap {
    fn new(pixels: &[Vec2], size: Vec2) -> Self {
        let size = [size.x as usize, size.y as usize];
        let mut is_in = vec![false; size[0] * size[1]];
        for pixel in pixels {
            is_in[pixel.y as usize * size[0] + pixel.x as usize] = true;
        }
        Self { is_in, size }
    }

    /// Distance of the nearest pixel, if there is one within `most`.
    fn nearest(&self, at: Vec2, most: f32) -> Option<f32> {
        let along = |at: f32, size: usize| {
            let end = (at + most).floor().max(-1.0) + 1.0;
            (at - most).ceil().max(0.0) as usize..size.min(end as usize)
        };
        let rows = along(at.y, self.size[1]);
        let pixels = rows.flat_map(|y| along(at.x, self.size[0]).map(move |x| (x, y)));
        let known = pixels.filter(|(x, y)| self.is_in[y * self.size[0] + x]);
        let distances = known.map(|(x, y)| Vec2::new(x as f32, y as f32).distance(at));
        distances
            .filter(|distance| *distance <= most)
            .reduce(f32::min)
    }
}

/// The limbs whose bones are at pixels that are `off` in the live view while others are `right`, each with all of its bones;
/// `None` where a root is turned.
fn seen_limbs(
    session: &Session,
    [off, right]: [&[Vec2]; 2],
    size: Vec2,
) -> Option<Vec<(String, Reach)>> {
    let [off, right] = [off, right].map(|pixels| PixelMap::new(pixels, size));
    let mut limbs: Vec<(String, Reach)> = Vec::new();
    for character in characters_seen(session, size) {
        let scale = scale(&character, size.y);
        let nearest = |at: Vec2, pixels: &PixelMap| pixels.nearest(at, AT_BONE * scale);
        let joints = character.joints;
        let seen = character.bones.iter().filter_map(|(joint, pixels)| {
            let ends = [*pixels.first()?, *pixels.last()?];
            let both = pixels
                .iter()
                .map(|&at| [&off, &right].map(|all| nearest(at, all)));
            let (mut of_off, mut of_right) = (0, 0);
            for [off, right] in both {
                match (off, right) {
                    (Some(off), right) if right.is_none_or(|right| off <= right) => of_off += 1,
                    (_, Some(_)) => of_right += 1,
                    _ => {}
                }
            }
            let share = |count: usize| count as f32 / pixels.len() as f32;
            Some(BoneBeside {
                joint: *joint,
                ends,
                off: share(of_off),
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
            let below = seen
                .iter()
                .filter(|bone| bone.joint != joint && above(bone.joint).any(|it| it == joint));
            let (right, others): (Vec<&BoneBeside>, Vec<_>) =
                below.partition(|bone| bone.right >= IS_RIGHT);
            own.any(|bone| bone.off >= IS_OFF && bone.off > bone.right)
                && next.all(|bone| bone.right < IS_RIGHT)
                && right.len() as f32 <= RIGHT_BELOW * (right.len() + others.len()) as f32
        };
        let mut turned: Vec<bool> = (0..joints.len()).map(is_turned).collect();
        // From what hangs on it such a joint cannot be told, which is what is posed.
        let longest = character.lengths.iter().copied().fold(0.0, f32::max);
        let is_short = |joint: usize| {
            let bones = character.bones.iter().zip(&character.lengths);
            let mut own = bones.filter(|((of, _), _)| *of == joint);
            own.all(|(_, length)| *length < SHORT * longest)
        };
        for joint in 0..joints.len() {
            let mut children =
                (0..joints.len()).filter(|&child| joints[child].parent == Some(joint));
            let has_turned_child = children.any(|child| turned[child]);
            turned[joint] &= !(has_turned_child && is_short(joint));
        }
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
        let named = |(joint, lines): (usize, Vec<[Vec2; 2]>)| {
            let mut bones = character.bones.iter();
            let own = bones.find(|(of, _)| *of == joint);
            let at = own.and_then(|(_, pixels)| pixels.first());
            let reach = Reach::Bones {
                joint: *at.unwrap_or(&lines[0][0]),
                lines,
                thick: THICK * scale,
            };
            (character.name_of(joint), reach)
        };
        limbs.extend(own.into_iter().map(named));
    }
    Some(limbs)
}
