//! Which limbs differ of a figure, by the bones of the characters in view.

use super::FigureOff;
use super::bones_seen::characters_seen;
use crate::compare::Area;
use crate::editor::Session;
use glam::Vec2;

/// How far from a bone's line a pixel may be that is off where the bone is, by the picture's height: the line runs through the
/// middle of a limb, which is off unless the limb has hardly moved.
const AT_BONE: f32 = 0.012;
/// Share of a bone's line that is off where the joint before it is turned: its beginning stays where it is.
const IS_OFF: f32 = 0.4;
/// Share of a bone's line from which on it is right, so that the joint above that it hangs on is not turned.
const IS_RIGHT: f32 = 0.5;
/// How far from its bones a limb reaches, by the picture's height, …
const THICK: f32 = 0.06;
/// … and the share of what is off that limbs have to have: with less something else differs, such as the camera.
const EXPLAINED: f32 = 0.9;
/// Percent of the figure from which on they are no limbs of it any more: a camera that is elsewhere leaves less of it right.
const FIGURE: f64 = 50.0;
/// Most limbs of one figure that differ by themselves.
const MOST: usize = 6;

/// A limb that differs: what a joint turns.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Limb {
    /// Name of the joint, with the character's if there are several.
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

impl BoneBeside {
    fn distance(&self, pixel: Vec2) -> f32 {
        let [start, end] = self.ends;
        let along = end - start;
        let part = (pixel - start).dot(along) / along.length_squared().max(f32::MIN_POSITIVE);
        (start + along * part.clamp(0.0, 1.0)).distance(pixel)
    }
}

/// The limbs that differ in a live view of `size` pixels: those of the joints nearest to the root that turn bones that are
/// `off`. None if these are not all that differs, or if together they are the figure itself, which a camera that is elsewhere
/// moves as well.
pub(super) fn limbs(session: &Session, off: &FigureOff, size: (u32, u32)) -> Vec<Limb> {
    let size = Vec2::new(size.0 as f32, size.1 as f32);
    let [ours, theirs, right] = [&off.ours, &off.theirs, &off.right].map(|pixels| {
        let pixels = pixels.iter().map(|&[x, y]| Vec2::new(x as f32, y as f32));
        pixels.collect::<Vec<Vec2>>()
    });
    let limbs = seen_limbs(session, [&ours, &right], size);
    let nearest = |pixel: Vec2| {
        let distances = limbs.iter().map(|(_, bones)| {
            let distances = bones.iter().map(|bone| bone.distance(pixel));
            distances.fold(f32::INFINITY, f32::min)
        });
        distances
            .enumerate()
            .min_by(|(_, a), (_, b)| a.total_cmp(b))
    };
    let at_limb = |pixel: &&Vec2| nearest(**pixel).is_some_and(|(_, it)| it <= THICK * size.y);
    let explained = ours.iter().filter(at_limb).count() as f32;
    if limbs.len() > MOST || explained < EXPLAINED * ours.len() as f32 {
        return Vec::new();
    }
    // The figure is as large in both pictures.
    let of_both = 2.0 * (ours.len() + right.len()) as f64;
    let mut pixels = vec![Vec::new(); limbs.len()];
    for &pixel in ours.iter().chain(&theirs) {
        if let Some((limb, _)) = nearest(pixel) {
            pixels[limb].push((pixel.x as u32, pixel.y as u32));
        }
    }
    let limbs = limbs.into_iter().zip(pixels);
    let limbs = limbs.filter_map(|((name, _), pixels)| {
        let percent = 100.0 * pixels.len() as f64 / of_both;
        let area = Area::around(pixels)?;
        Some(Limb {
            name,
            area,
            percent,
        })
    });
    let limbs: Vec<Limb> = limbs.collect();
    let of_figure: f64 = limbs.iter().map(|limb| limb.percent).sum();
    if of_figure >= FIGURE {
        return Vec::new();
    }
    limbs
}

/// The limbs whose bones are at pixels that are `off` in the live view while others are `right`, each with all of its bones.
/// None where a root is turned.
fn seen_limbs(
    session: &Session,
    [off, right]: [&[Vec2]; 2],
    size: Vec2,
) -> Vec<(String, Vec<BoneBeside>)> {
    let is_among =
        |at: Vec2, pixels: &[Vec2]| pixels.iter().any(|it| it.distance(at) <= AT_BONE * size.y);
    let mut limbs: Vec<(String, Vec<BoneBeside>)> = Vec::new();
    for character in characters_seen(session, size) {
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
            return Vec::new();
        }
        let mut own: Vec<(usize, Vec<BoneBeside>)> = Vec::new();
        for bone in seen {
            let Some(top) = tops[bone.joint] else {
                continue;
            };
            match own.iter_mut().find(|(joint, _)| *joint == top) {
                Some((_, bones)) => bones.push(bone),
                None => own.push((top, vec![bone])),
            }
        }
        let named = |(joint, bones)| (character.name_of(joint), bones);
        limbs.extend(own.into_iter().map(named));
    }
    limbs
}
