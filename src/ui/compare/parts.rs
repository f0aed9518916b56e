//! Which parts of a scene differ: limbs, and shapes without bones.

use super::absent::{Attributed, give_back, hidden_at, without_absent};
use super::bones_seen::characters_seen;
use super::candidates::{Candidate, Nearest, moved_or_nearest, nearest};
use super::clusters::{fill_an_area, without_strays};
use super::how::{How, how_of_character};
use super::limbs::{Body, limbs};
use super::owned::{Owned, seen_at};
use super::part::{Kind, Part, Pixels};
use super::pixel_map::PixelMaps;
use super::seen_in_cells::SeenInCells;
use super::shapes_seen::shapes_seen;
use super::turned::Certainty;
use crate::compare::{Area, FigureOff};
use crate::editor::Session;
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
    if off.has_outline && off.theirs.is_empty() && off.right.is_empty() {
        let all = Part {
            name: String::new(),
            kind: Kind::All,
            area: off.area,
            percent: 100.0,
        };
        return Parts {
            all: vec![all],
            is_shape_still: false,
        };
    }
    let size = Vec2::new(size.0 as f32, size.1 as f32);
    let [ours, theirs, right] = [&off.ours, &off.theirs, &off.right]
        .map(|all| -> Vec<Vec2> { all.iter().map(at).collect() });
    let differing = Differing {
        session,
        off,
        size,
        owned: Owned::new(session, [&ours, &right], size),
        maps: PixelMaps::new([&ours, &right], &theirs, size),
        seen: SeenInCells::new(session, size, off.apart),
        ours,
        theirs,
        right,
    };
    let mut all = differing.parts(Certainty::Sure);
    // What is off is of parts where no camera is.
    if all.is_empty() && off.is_camera_right {
        all = differing.parts(Certainty::Likely);
    }
    Parts {
        all,
        is_shape_still: differing.owned.has_still_shape(),
    }
}

/// What differs in a live view of `size` pixels, as pixels of it and of the other picture.
struct Differing<'a> {
    session: &'a Session,
    off: &'a FigureOff,
    size: Vec2,
    ours: Vec<Vec2>,
    theirs: Vec<Vec2>,
    right: Vec<Vec2>,
    /// What is seen at `ours` and at what is `right`.
    owned: Owned<'a>,
    /// Where all these are.
    maps: PixelMaps,
    /// Which shape is seen where.
    seen: SeenInCells<'a>,
}

impl Differing<'_> {
    /// The parts of which it has to be so certain that they differ.
    fn parts(&self, certainty: Certainty) -> Vec<Part> {
        let limbs = limbs(
            self.session,
            &self.owned,
            self.off,
            &self.maps,
            self.size,
            certainty,
        );
        let has_whole = !limbs.whole.is_empty();
        if has_whole && let Some(alone) = self.shown_otherwise_alone() {
            return vec![alone];
        }
        let shapes = shapes_seen(self.session, self.size, &limbs.whole).into_iter();
        let shapes = shapes.filter(|shape| {
            let shows = shape.shows_at(&self.ours, self.session, self.size);
            shows && !self.owned.is_still(shape.id)
        });
        let of_limbs = limbs.all.into_iter().map(Candidate::Limb);
        let mut candidates: Vec<Candidate> = of_limbs.chain(shapes.map(Candidate::Shape)).collect();
        let of_ours = self.ours.iter().map(|&pixel| {
            let nearest = match certainty {
                Certainty::Sure => nearest(&candidates, pixel, |_| true, &self.seen),
                Certainty::Likely => moved_or_nearest(&candidates, pixel, &self.seen),
            };
            (pixel, nearest)
        });
        let of_ours: Vec<(Vec2, Nearest)> = of_ours.collect();
        // A shape may stand before what is off, in the other picture.
        let may_cover = |candidate: &Candidate| matches!(candidate, Candidate::Shape(_));
        let covered: HashSet<(u32, u32)> = match candidates.iter().any(may_cover) {
            true => self.theirs.iter().copied().map(whole).collect(),
            false => HashSet::new(),
        };
        if !self.is_explained(&of_ours, &limbs.trunks, &covered) {
            return Vec::new();
        }
        let mut pixels = vec![[Vec::new(), Vec::new()]; candidates.len()];
        for (pixel, nearest) in of_ours {
            let Some((part, _)) = nearest else { continue };
            pixels[part][0].push(whole(pixel));
            if let Candidate::Limb(limb) = &mut candidates[part]
                && certainty == Certainty::Likely
            {
                limb.extend_to(pixel);
            }
        }
        let of_theirs = self.theirs.iter().map(|&pixel| {
            let may_be = |it: &Candidate| it.may_have_been_at(pixel);
            let nearest = nearest(&candidates, pixel, may_be, &self.seen);
            Attributed {
                pixel: whole(pixel),
                part: nearest.map(|(part, _)| part),
            }
        });
        let size_of_shape = |(candidate, [ours, _]): (&Candidate, &Pixels)| match candidate {
            Candidate::Limb(_) => None,
            Candidate::Shape(_) => Some(ours.len()),
        };
        let sizes: Vec<Option<usize>> = candidates.iter().zip(&pixels).map(size_of_shape).collect();
        let (of_parts, mut absent) = without_absent(of_theirs, &sizes, self.off);
        for Attributed { pixel, part } in of_parts {
            if let Some(part) = part {
                pixels[part][1].push(pixel);
            }
        }
        let shapes = pixels
            .iter_mut()
            .zip(&sizes)
            .filter(|(_, size)| size.is_some());
        give_back(&mut absent, shapes.map(|(pixels, _)| pixels));
        let mut parts = self.parts_of(candidates, pixels);
        let is_in_place = |part: &Part| part.kind.is_in_place();
        let is_camera_right = limbs.is_camera_right || has_whole && parts.iter().any(is_in_place);
        // What a root turns is all of the figure, as what a camera shows that is elsewhere, unless it is only shown otherwise.
        if has_whole && !is_camera_right {
            let is_shown_otherwise = |part: &Part| part.kind.is_shown_otherwise();
            let are_all = absent.is_empty() && parts.iter().all(is_shown_otherwise);
            return if are_all { parts } else { Vec::new() };
        }
        let may_be_camera = parts.iter().filter(|part| !part.kind.is_of_ours_alone());
        let of_figure: f64 = may_be_camera.map(|part| part.percent).sum();
        if parts.len() + absent.len() > MOST || of_figure >= FIGURE && !is_camera_right {
            return Vec::new();
        }
        // Without anything that is where it should be, what is drawn may as well be seen by another camera.
        if !self.right.is_empty() {
            parts.extend(absent.into_iter().filter_map(|pixels| self.absent(&pixels)));
        }
        parts
    }

    /// Whether the candidates explain what is off of the live view, or what hangs on joints of these `trunks` does, or what stands
    /// before it in the other picture at the pixels that may be `covered`.
    fn is_explained(
        &self,
        of_ours: &[(Vec2, Nearest)],
        trunks: &[Body],
        covered: &HashSet<(u32, u32)>,
    ) -> bool {
        let is_explained = |(pixel, nearest): &&(Vec2, Nearest)| {
            nearest.is_some_and(|(_, distance)| distance <= 1.0)
                || trunks.iter().any(|trunk| trunk.distance(*pixel) <= 1.0)
                || covered.contains(&whole(*pixel))
        };
        let explained = of_ours.iter().filter(is_explained).count() as f32;
        let ours = self.ours.len();
        // Lines of the ground that are behind something in the other picture may be left over.
        let are_strays = || {
            (ours as f64) < STRAYS * self.shown() && !fill_an_area(&self.off.ours, self.off.apart)
        };
        // No shape is where the ground is that has sunk or risen with the lowest one.
        let of_shapes = || {
            let is_of_shape = |at: &&Vec2| seen_at(self.session, **at, self.size).is_some();
            self.ours.iter().filter(is_of_shape).count()
        };
        explained >= EXPLAINED * ours as f32
            || are_strays()
            || explained >= EXPLAINED * of_shapes() as f32
    }

    /// How many pixels the other picture shows.
    fn shown(&self) -> f64 {
        (self.theirs.len() + self.right.len()).max(1) as f64
    }

    /// The candidates that differ at these pixels, as parts.
    fn parts_of(&self, candidates: Vec<Candidate>, pixels: Vec<Pixels>) -> Vec<Part> {
        let count = |pixels: &Pixels| pixels.iter().map(Vec::len).sum::<usize>() as f64;
        let all: f64 = pixels.iter().map(count).sum();
        // What was before a shape is off there as well.
        let is_covered = |candidate: &Candidate, count: f64| match candidate {
            Candidate::Shape(shape) => count < LITTLE * all && self.owned.is_mostly_right(shape.id),
            Candidate::Limb(_) => false,
        };
        let parts = candidates.into_iter().zip(pixels);
        let parts = parts.filter(|(candidate, pixels)| !is_covered(candidate, count(pixels)));
        let parts = parts.filter_map(|(candidate, pixels)| {
            let (name, kind) = candidate.told(&pixels, (&self.owned, &self.seen), self.off);
            let percent = kind.percent(&pixels, self.off);
            let shown = match kind {
                Kind::Limb { .. } => pixels,
                _ => pixels.map(|of| without_strays(&of, self.off.apart)),
            };
            Some(Part {
                area: Area::around(shown.concat())?,
                name,
                kind,
                percent,
            })
        });
        parts.collect()
    }

    /// The character that is alone in view, if all of it has another color, or is shown otherwise or not at all: then no camera that is
    /// elsewhere is what differs.
    fn shown_otherwise_alone(&self) -> Option<Part> {
        let shapes = self.session.scene().shapes().iter();
        let mut visible = shapes.filter(|shape| shape.visible);
        let (Some(shape), None) = (visible.next(), visible.next()) else {
            return None;
        };
        let pixels = [&self.ours, &self.theirs];
        let pixels = pixels.map(|all| all.iter().copied().map(whole).collect());
        let how = how_of_character(shape.id, (&self.owned, &self.seen), &pixels, self.off)
            .filter(|how| *how != How::ColorAndPlace)?;
        let kind = Kind::Character(Some(how));
        Some(Part {
            name: shape.name.clone(),
            area: self.off.area,
            percent: kind.percent(&pixels, self.off),
            kind,
        })
    }

    /// Something that only the other picture shows, at these pixels.
    fn absent(&self, pixels: &[(u32, u32)]) -> Option<Part> {
        let pixels = without_strays(pixels, self.off.apart);
        let area = Area::around(pixels.iter().copied())?;
        let hidden = hidden_at(self.session, area, self.size);
        Some(Part {
            name: hidden.unwrap_or_default().to_owned(),
            kind: Kind::Absent,
            area,
            percent: 100.0 * pixels.len() as f64 / self.shown(),
        })
    }
}

fn whole(pixel: Vec2) -> (u32, u32) {
    (pixel.x as u32, pixel.y as u32)
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
            thin: None,
            outlines: [const { Vec::new() }; 2],
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
