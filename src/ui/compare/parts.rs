//! Which parts of a scene differ: limbs, and shapes without bones.

use super::absent::{Attributed, hidden_at, without_absent};
use super::bones_seen::characters_seen;
use super::clusters::{fill_an_area, without_strays};
use super::limbs::{Body, Limb, Limbs, limbs};
use super::owned::{Owned, seen_at};
use super::shapes_seen::{ShapeSeen, shapes_seen};
use super::turned::Covered;
use crate::compare::{Area, FigureOff};
use crate::editor::Session;
use crate::scene::ShapeId;
use glam::Vec2;
use std::collections::HashSet;

/// Share of what is off that parts have to have: with less something else differs, such as the camera.
const EXPLAINED: f32 = 0.9;
/// Share of what the other picture shows up to which pixels of the live view that are off along lines are left over from something
/// else: of lines of the ground behind a goblet it was 0.006.
const STRAYS: f64 = 0.02;
/// Percent of the figure from which on they are no parts of it any more: a camera that is elsewhere leaves less of it right.
const FIGURE: f64 = 50.0;
/// Share of what is off that is little beside other parts.
const LITTLE: f64 = 0.05;
/// Most parts that differ by themselves.
const MOST: usize = 6;

/// A part that differs.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Part {
    /// Name of the joint, with the character's if there are several, or of the shape.
    pub name: String,
    pub kind: Kind,
    /// The area round what is off of it in either picture.
    pub area: Area,
    /// Share of the figure that this is, in percent.
    pub percent: f64,
}

/// What a part is.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Kind {
    /// A limb, with what else may be turned in its place in a sentence.
    Limb { instead: Option<String> },
    /// A shape without bones, and how it differs, as far as that is told.
    Shape(Option<How>),
    /// A character, of which more than limbs differs, and how if it does not stand elsewhere.
    Character(Option<How>),
    /// Something in the other picture where the live view has nothing; its name is that of a hidden shape, or empty.
    Absent,
}

/// How a shape differs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum How {
    /// It covers what it should, in other colors.
    Color,
    /// It covers nearly that, in other colors: of a character also limbs are turned.
    ColorAndMore,
    /// It covers something else.
    Place,
    /// The same of a curve, which may have other control points.
    PlaceOrPoints,
    /// The same of a surface, which may also be shown as lines in one of the pictures.
    PlaceOrLines,
    /// The other picture has nothing there.
    Missing,
    /// The same of a surface, of which single lines count as nothing.
    MissingOrLines,
}

/// Share of the pixels that a shape covers in both pictures from which on it is where it should be, …
const SAME_PLACE: f64 = 0.95;
/// … and up to which it is elsewhere: one that is turned in its place covers much of what it did.
const OTHER_PLACE: f64 = 0.9;

/// Share of the pixels that a character covers in both pictures from which on it may have another color: with a knee that is
/// turned by 60 degrees as well it was 0.93, …
const RECOLORED_PLACE: f64 = 0.8;
/// … and share of what is seen of it that is off, then: one that is moved by a little keeps its color where it still is.
const RECOLORED: f32 = 0.95;

/// How a character differs of which more than limbs does, where it has another color; `None` where it stands elsewhere.
fn how_of_character(
    character: ShapeId,
    owned: &Owned,
    [ours, theirs]: &[Vec<(u32, u32)>; 2],
) -> Option<How> {
    let off = owned.off_of(character, |_| true)?;
    if off < RECOLORED {
        return None;
    }
    match share_of_both(ours, theirs) {
        SAME_PLACE.. => Some(How::Color),
        RECOLORED_PLACE.. => Some(How::ColorAndMore),
        _ => None,
    }
}

/// Share of the pixels that these are in both pictures.
fn share_of_both(ours: &[(u32, u32)], theirs: &[(u32, u32)]) -> f64 {
    let of_theirs: HashSet<_> = theirs.iter().collect();
    let both = ours.iter().filter(|pixel| of_theirs.contains(pixel));
    both.count() as f64 / ours.len().max(theirs.len()).max(1) as f64
}

/// Share of what it covers that the other picture shows something at which has nothing there.
const NOTHING: f64 = 0.02;

/// Share of what is seen of a surface that is off where the other picture shows it as lines: of one that was moved by a tenth of its
/// height it was 0.51.
const LINES_OFF: f32 = 0.97;

/// How a shape differs that is off at these pixels of the live view, and at those of the other picture, where the share `off_of_curve`
/// is off of it if it is a curve.
fn how([ours, theirs]: &[Vec<(u32, u32)>; 2], off_of_curve: Option<f32>) -> Option<How> {
    let how = match share_of_both(ours, theirs) {
        _ if (theirs.len() as f64) < NOTHING * ours.len() as f64 => How::Missing,
        SAME_PLACE.. => How::Color,
        ..=OTHER_PLACE => How::Place,
        _ => return None,
    };
    let Some(off) = off_of_curve else {
        return Some(how);
    };
    let may_be_lines = off >= LINES_OFF;
    Some(match how {
        How::Missing if may_be_lines => How::MissingOrLines,
        How::Place if may_be_lines && have_one_middle(ours, theirs) => How::PlaceOrLines,
        How::Place => How::PlaceOrPoints,
        how => how,
    })
}

/// How far apart the middles of two areas are at most that are about the same, by their sides: of a goblet as a wireframe with
/// normals it was 0.02.
const ONE_MIDDLE: f32 = 0.05;

/// Whether the areas round pixels lie about the same middle, as where a shape stays where it is.
fn have_one_middle(ours: &[(u32, u32)], theirs: &[(u32, u32)]) -> bool {
    let areas = [ours, theirs].map(|pixels| Area::around(pixels.iter().copied()));
    let [Some(ours), Some(theirs)] = areas else {
        return false;
    };
    let [size, of_theirs] =
        [ours, theirs].map(|area| Vec2::new(area.width as f32, area.height as f32));
    let [corner, corner_of_theirs] =
        [ours, theirs].map(|area| Vec2::new(area.x as f32, area.y as f32));
    let apart = corner + 0.5 * size - corner_of_theirs - 0.5 * of_theirs;
    apart.abs().cmple(ONE_MIDDLE * size).all()
}

/// What may be a part.
enum Seen<'a> {
    Limb(Limb),
    Shape(ShapeSeen<'a>),
}

impl Seen<'_> {
    /// How far a pixel is, by how far the part reaches: 1 at most where the part is.
    fn distance(&self, pixel: Vec2) -> f32 {
        match self {
            Self::Limb(limb) => limb.body.distance(pixel),
            Self::Shape(shape) => shape.distance(pixel),
        }
    }

    /// Whether what was at a pixel can be the part, turned otherwise or moved.
    fn may_have_been_at(&self, pixel: Vec2) -> bool {
        match self {
            Self::Limb(limb) => limb.may_have_been_at(pixel),
            Self::Shape(_) => true,
        }
    }

    /// Its name, and what it is where these pixels of the live view are off, and those of the other picture.
    fn told(self, pixels: &[Vec<(u32, u32)>; 2], owned: &Owned) -> (String, Kind) {
        match self {
            Self::Limb(limb) => {
                let instead = limb.instead;
                (limb.name, Kind::Limb { instead })
            }
            Self::Shape(shape) => {
                let kind = match shape.is_character {
                    true => Kind::Character(how_of_character(shape.id, owned, pixels)),
                    false => {
                        let off = owned.off_of_other(shape.id).unwrap_or(1.0);
                        Kind::Shape(how(pixels, shape.is_curve.then_some(off)))
                    }
                };
                (shape.name.to_owned(), kind)
            }
        }
    }
}

/// The parts that differ, and what is known beside them.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Parts {
    /// None if they are not all that differs, or if together they are the figure itself, which a camera that is elsewhere moves
    /// as well.
    pub all: Vec<Part>,
    /// Whether all of some shape stands still, which none does that another camera shows.
    pub is_shape_still: bool,
}

/// The parts that differ in a live view of `size` pixels.
pub(super) fn parts(session: &Session, off: &FigureOff, size: (u32, u32)) -> Parts {
    let size = Vec2::new(size.0 as f32, size.1 as f32);
    let pixels = [&off.ours, &off.theirs, &off.right]
        .map(|all| -> Vec<Vec2> { all.iter().map(at).collect() });
    let [ours, _, right] = &pixels;
    let parts = |covered| {
        let limbs = limbs(session, off, [ours, right], size, covered);
        Parts {
            is_shape_still: limbs.owned.has_still_shape(),
            all: parts_with((limbs, covered), session, off, &pixels, size),
        }
    };
    let strict = parts(Covered::Maybe);
    // What is off is of parts where no camera is.
    if strict.all.is_empty() && off.is_camera_right {
        return parts(Covered::Not);
    }
    strict
}

/// The same where limbs are known, and the pixels of `off` as points. Where nothing is covered, what a joint moves is its limb
/// however far from its bones.
fn parts_with(
    (limbs, covered): (Limbs, Covered),
    session: &Session,
    off: &FigureOff,
    [ours, theirs, right]: &[Vec<Vec2>; 3],
    size: Vec2,
) -> Vec<Part> {
    let is_camera_right = limbs.is_camera_right;
    // What a root turns is all of the figure, as what a camera shows that is elsewhere.
    if !limbs.whole.is_empty() {
        let recolored = recolored_alone(session, off, &limbs.owned);
        if recolored.is_some() || !is_camera_right {
            return recolored.into_iter().collect();
        }
    }
    let shapes = shapes_seen(session, size, &limbs.whole).into_iter();
    let differs =
        |shape: &ShapeSeen| shape.shows_at(ours, session, size) && !limbs.owned.is_still(shape.id);
    let shapes = shapes.filter(differs);
    let of_limbs = limbs.all.into_iter().map(Seen::Limb);
    let seen: Vec<Seen> = of_limbs.chain(shapes.map(Seen::Shape)).collect();
    let nearest = |pixel: Vec2, may_be: &dyn Fn((usize, &Seen)) -> bool| {
        let all = seen.iter().enumerate().filter(|it| may_be(*it));
        let distances = all.map(|(part, it)| (part, it.distance(pixel)));
        distances.min_by(|(_, a), (_, b)| a.total_cmp(b))
    };
    let moved = |pixel: Vec2| -> Option<(usize, f32)> {
        let mesh = seen_at(session, pixel, size).filter(|_| covered == Covered::Not)?;
        let is_moved = |it: &Seen| matches!(it, Seen::Limb(limb) if limb.moves(&mesh));
        Some((seen.iter().position(is_moved)?, 1.0))
    };
    let of_ours = ours.iter().map(|&pixel| {
        let nearest = nearest(pixel, &|_| true);
        let is_near = nearest.is_some_and(|(_, distance)| distance <= 1.0);
        let moved = (!is_near).then(|| moved(pixel)).flatten();
        (pixel, moved.or(nearest))
    });
    let of_ours: Vec<_> = of_ours.collect();
    // As far as its own pixels a limb reaches in the other picture, too.
    let mut reach = vec![0.0_f32; seen.len()];
    for (pixel, nearest) in &of_ours {
        if let Some((part, _)) = *nearest
            && let Seen::Limb(limb) = &seen[part]
            && covered == Covered::Not
        {
            reach[part] = reach[part].max(limb.distance_from_joint(*pixel));
        }
    }
    let is_explained = |(pixel, nearest): &&(Vec2, Option<(usize, f32)>)| {
        let mut trunks = limbs.trunks.iter();
        nearest.is_some_and(|(_, distance)| distance <= 1.0)
            || trunks.any(|trunk| trunk.distance(*pixel) <= 1.0)
    };
    let explained = of_ours.iter().filter(is_explained).count() as f32;
    let shown = (theirs.len() + right.len()).max(1) as f64;
    // Lines of the ground that are behind something in the other picture may be left over.
    let are_strays = (ours.len() as f64) < STRAYS * shown && !fill_an_area(&off.ours, off.apart);
    // No shape is where the ground is that has sunk or risen with the lowest one.
    let of_shapes = || {
        let of_shapes = ours
            .iter()
            .filter(|at| seen_at(session, **at, size).is_some());
        of_shapes.count() as f32
    };
    if explained < EXPLAINED * ours.len() as f32
        && !are_strays
        && explained < EXPLAINED * of_shapes()
    {
        return Vec::new();
    }
    let of_theirs = theirs.iter().map(|&pixel| {
        let may_have_been_at = |(part, it): (usize, &Seen)| {
            let is_within = match it {
                Seen::Limb(limb) => limb.distance_from_joint(pixel) <= reach[part],
                Seen::Shape(_) => true,
            };
            is_within || it.may_have_been_at(pixel)
        };
        (pixel, nearest(pixel, &may_have_been_at))
    });
    let mut pixels = vec![[Vec::new(), Vec::new()]; seen.len()];
    let whole = |pixel: Vec2| (pixel.x as u32, pixel.y as u32);
    for (pixel, nearest) in of_ours {
        if let Some((part, _)) = nearest {
            pixels[part][0].push(whole(pixel));
        }
    }
    let of_theirs = of_theirs.map(|(pixel, nearest)| Attributed {
        pixel: whole(pixel),
        part: nearest.map(|(part, _)| part),
    });
    let size_of_shape = |(seen, [ours, _]): (&Seen, &[Vec<_>; 2])| match seen {
        Seen::Limb(_) => None,
        Seen::Shape(_) => Some(ours.len()),
    };
    let sizes: Vec<Option<usize>> = seen.iter().zip(&pixels).map(size_of_shape).collect();
    let (of_parts, absent) = without_absent(of_theirs, &sizes, off);
    for Attributed { pixel, part } in of_parts {
        if let Some(part) = part {
            pixels[part][1].push(pixel);
        }
    }
    let count = |pixels: &[Vec<(u32, u32)>; 2]| pixels.iter().map(Vec::len).sum::<usize>() as f64;
    let all: f64 = pixels.iter().map(count).sum();
    // What was before a shape is off there as well.
    let is_covered = |seen: &Seen, count: f64| match seen {
        Seen::Shape(shape) => count < LITTLE * all && limbs.owned.is_mostly_right(shape.id),
        Seen::Limb(_) => false,
    };
    // The figure is as large in both pictures.
    let of_both = 2.0 * (ours.len() + right.len()) as f64;
    let parts = seen.into_iter().zip(pixels);
    let parts = parts.filter(|(seen, pixels)| !is_covered(seen, count(pixels)));
    let parts = parts.filter_map(|(seen, pixels)| {
        let percent = 100.0 * count(&pixels) / of_both;
        let (name, kind) = seen.told(&pixels, &limbs.owned);
        let shown = match kind {
            Kind::Limb { .. } => pixels,
            _ => pixels.map(|of| without_strays(&of, off.apart)),
        };
        Some(Part {
            area: Area::around(shown.concat())?,
            name,
            kind,
            percent,
        })
    });
    let mut parts: Vec<Part> = parts.collect();
    let of_figure: f64 = parts.iter().map(|part| part.percent).sum();
    if parts.len() + absent.len() > MOST || of_figure >= FIGURE && !is_camera_right {
        return Vec::new();
    }
    // Without anything that is where it should be, what is drawn may as well be seen by another camera.
    if !right.is_empty() {
        let named = |pixels: Vec<(u32, u32)>| {
            let pixels = without_strays(&pixels, off.apart);
            let area = Area::around(pixels.iter().copied())?;
            Some(Part {
                name: hidden_at(session, area, size)
                    .unwrap_or_default()
                    .to_owned(),
                kind: Kind::Absent,
                area,
                percent: 100.0 * pixels.len() as f64 / shown,
            })
        };
        parts.extend(absent.into_iter().filter_map(named));
    }
    parts
}

/// The character that is alone in view, if all of it has another color: then no camera that is elsewhere is what differs.
fn recolored_alone(session: &Session, off: &FigureOff, owned: &Owned) -> Option<Part> {
    let mut visible = session
        .scene()
        .shapes()
        .iter()
        .filter(|shape| shape.visible);
    let (Some(shape), None) = (visible.next(), visible.next()) else {
        return None;
    };
    let pixels = [&off.ours, &off.theirs].map(|all| all.iter().map(|&[x, y]| (x, y)).collect());
    let how = how_of_character(shape.id, owned, &pixels)?;
    let count = |pixels: &[[u32; 2]]| pixels.len() as f64;
    let percent = 100.0 * (count(&off.ours) + count(&off.theirs))
        / (2.0 * (count(&off.ours) + count(&off.right)));
    Some(Part {
        name: shape.name.clone(),
        kind: Kind::Character(Some(how)),
        area: off.area,
        percent,
    })
}

fn at(&[x, y]: &[u32; 2]) -> Vec2 {
    Vec2::new(x as f32, y as f32)
}

/// What is off of the shapes in a live view of `size` pixels. Where that is not told from what is behind them, this tells
/// nothing of them.
pub(super) fn of_shapes(session: &Session, off: &FigureOff, size: (u32, u32)) -> FigureOff {
    let mut of_shapes = off.clone();
    if off.has_outline {
        return of_shapes;
    }
    let size = Vec2::new(size.0 as f32, size.1 as f32);
    let characters = characters_seen(session, size).into_iter();
    let bodies: Vec<Body> = characters
        .map(|character| Body::of(&character, size.y))
        .collect();
    let shapes = shapes_seen(session, size, &[]);
    of_shapes.ours.retain(|pixel| {
        let pixel = at(pixel);
        shapes.iter().any(|shape| shape.distance(pixel) <= 1.0)
            || bodies.iter().any(|body| body.distance(pixel) <= 1.0)
    });
    of_shapes
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::editor::Edit;
    use crate::scene::{NewShape, ShapeKind};
    use glam::Vec3;

    /// Every third pixel from `least` to `most`.
    fn filled(least: Vec2, most: Vec2) -> Vec<[u32; 2]> {
        let along = |from: f32, to: f32| (from as u32..=to as u32).filter(|at| at % 3 == 0);
        along(least.y, most.y)
            .flat_map(|y| along(least.x, most.x).map(move |x| [x, y]))
            .collect()
    }

    #[test]
    fn a_shape_is_outlined_without_lines_that_differ_as_well() {
        let mut session = Session::new();
        let mut aside = NewShape::new("Aside", ShapeKind::Cube);
        aside.placement.transform.position = Vec3::X * 2.0;
        let cube = NewShape::new("Cube", ShapeKind::Cube);
        session.edit(Edit::Insert(vec![cube, aside])).unwrap();
        let size = (600, 400);
        let seen = shapes_seen(&session, Vec2::new(600.0, 400.0), &[]);
        let [cube, aside] = [0, 1].map(|shape| filled(seen[shape].least, seen[shape].most));
        let line = filled(Vec2::new(3.0, 0.0), Vec2::new(3.0, 399.0));
        let around = |pixels: &[[u32; 2]]| Area::around(pixels.iter().map(|&[x, y]| (x, y)));
        let off = FigureOff {
            area: around(&cube).unwrap(),
            theirs: [&cube[..], &line].concat(),
            ours: cube.clone(),
            right: aside,
            apart: 3,
            has_outline: true,
            is_camera_right: false,
        };
        let parts: Vec<_> = parts(&session, &off, size)
            .all
            .into_iter()
            .map(|part| (part.name, Some(part.area)))
            .collect();
        assert_eq!(parts, [("Cube".to_owned(), around(&cube))]);
    }
}
