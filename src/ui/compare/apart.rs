//! Places apart from one another in which pictures differ.

use super::clusters::clusters;
use super::elsewhere::placement_of_all;
use super::other_camera::other_camera;
use super::owned::Owned;
use super::parts::{How, Kind, Part, at, of_shapes, parts};
use super::place::{MUCH, absent, near, place, placed_elsewhere, seen_from_elsewhere, whole};
use crate::compare::{Area, FigureOff, about, sentence};
use crate::editor::Session;
use crate::revision::Revision;
use crate::scene::Camera;
use glam::Vec2;

/// A place in which pictures differ.
#[derive(Clone, Debug)]
pub(super) struct Place {
    pub told: String,
    pub area: Area,
    /// Whether it is a part of the scene, so that the camera is right.
    pub is_part: bool,
    /// What else may be behind it, in a sentence.
    pub instead: Option<String>,
}

/// The places that were found last. They stay as long as nothing changes of what they follow from: to find them takes longer
/// than a frame should, for rays go to thousands of pixels.
#[derive(Clone, Debug, Default)]
pub(in crate::ui) struct KeptPlaces {
    of: Option<KeptOf>,
    places: Vec<Place>,
    /// Whether none are to be found, as while what differs is measured anew.
    rests: bool,
}

/// What places follow from: the document, its view of so many pixels, and what differs there, of which a new one has other
/// numbers of pixels or is round another area.
type KeptOf = (Revision, Camera, (u32, u32), Area, [usize; 3]);

impl KeptPlaces {
    /// Finds no new places if it `rests`, as in the midst of a drag.
    pub(super) fn rest(&mut self, rests: bool) {
        self.rests = rests;
    }

    /// The places that `find` finds from what is off in a live view of `size` pixels.
    fn get(
        &mut self,
        session: &Session,
        off: &FigureOff,
        size: (u32, u32),
        find: impl FnOnce() -> Vec<Place>,
    ) -> Vec<Place> {
        if self.rests {
            return self.places.clone();
        }
        let counts = [&off.ours, &off.theirs, &off.right].map(Vec::len);
        let camera = session.view().camera;
        let of = (session.document(), camera, size, off.area, counts);
        if self.of != Some(of) {
            self.places = find();
            self.of = Some(of);
        }
        self.places.clone()
    }

    /// The parts that differ in a live view of `size` pixels, if there are some that explain what does, or else all of the figure
    /// if it stands `elsewhere` or is seen by another camera.
    pub(super) fn of_figure(
        &mut self,
        session: &Session,
        off: &FigureOff,
        size: (u32, u32),
        elsewhere: impl FnOnce() -> Option<Place>,
    ) -> Vec<Place> {
        self.get(session, off, size, || {
            parts_or_all(session, off, size, elsewhere)
        })
    }

    /// The places apart from one another in which what is drawn differs, which has `figure` round it: parts of the scene, or
    /// else where a bone is near, or where they lie in the figure. None if there are too many.
    pub(super) fn apart(
        &mut self,
        session: &Session,
        off: &FigureOff,
        figure: Area,
        size: (u32, u32),
    ) -> Vec<Place> {
        self.get(session, off, size, || apart(session, off, figure, size))
    }
}

/// The parts that differ, or else all that is drawn if it stands `elsewhere` or is seen by another camera.
fn parts_or_all(
    session: &Session,
    off: &FigureOff,
    size: (u32, u32),
    elsewhere: impl FnOnce() -> Option<Place>,
) -> Vec<Place> {
    let parts = parts(session, off, size);
    let are_absent = parts.iter().all(|part| part.kind == Kind::Absent);
    let all = match parts.len() {
        // Round a shape that is only larger in the other picture nothing is in the live view, either.
        _ if are_absent => elsewhere().or_else(|| from_elsewhere(session, off, size)),
        1 => None,
        // What several parts would explain may be one camera.
        _ => from_elsewhere(session, off, size),
    };
    all.map_or_else(|| places_of(parts), |all| vec![all])
}

/// All that is drawn, if it is where the other picture has it as another camera sees it.
fn from_elsewhere(session: &Session, off: &FigureOff, size: (u32, u32)) -> Option<Place> {
    let [ours, right] = [&off.ours, &off.right].map(|all| all.iter().map(at).collect::<Vec<_>>());
    let view = Vec2::new(size.0 as f32, size.1 as f32);
    if Owned::new(session, [&ours, &right], view).has_still_shape() {
        return None;
    }
    let camera = other_camera(session, off, size)?;
    Some(Place {
        told: seen_from_elsewhere(&camera),
        area: off.area,
        is_part: false,
        instead: None,
    })
}

fn places_of(parts: Vec<Part>) -> Vec<Place> {
    let places = parts.into_iter().map(|part| {
        let (name, share) = (&part.name, about(part.percent));
        let (told, instead) = match part.kind {
            Kind::Character(how) => (whole(name, &share, how.map(in_words)), None),
            Kind::Shape(how) => (near(name, &share, how.map(in_words)), None),
            Kind::Limb { instead } => (near(name, &share, None), instead),
            Kind::Absent => (absent(name, &share), None),
        };
        Place {
            told,
            area: part.area,
            is_part: true,
            instead,
        }
    });
    places.collect()
}

/// How a shape differs.
fn in_words(how: How) -> &'static str {
    match how {
        How::Color => "its outline agrees, so that its color or light differs",
        How::ColorAndMore => "its color or light differs, and a part of its outline",
        How::Place => "it is moved, turned or scaled",
        How::Missing => "A shows nothing in its place",
    }
}

/// Most places apart from one another that are told one by one, …
const MOST_APART: usize = 4;
/// … and how far they are apart, by the picture's height.
const APART: f32 = 0.025;

fn apart(session: &Session, off: &FigureOff, figure: Area, size: (u32, u32)) -> Vec<Place> {
    let off = of_shapes(session, off, size);
    let known = parts_or_all(session, &off, size, || elsewhere(session, &off, size));
    if !known.is_empty() {
        return known;
    }
    let apart = areas_apart(&off, (APART * size.1 as f32).max(1.0) as u32);
    if apart.len() > MOST_APART {
        return Vec::new();
    }
    let places = apart.into_iter().map(|(area, is_ours)| {
        // Bones are where the live view has them, and none is to blame for much of a figure.
        let told = match is_ours && area.share_of(figure) < MUCH {
            true => place(session, area, figure, size),
            false => sentence(&area.place_in(figure)),
        };
        Place {
            told,
            area,
            is_part: false,
            instead: None,
        }
    });
    places.collect()
}

/// All that is drawn, if it has the outline of the other picture but stands elsewhere.
fn elsewhere(session: &Session, off: &FigureOff, size: (u32, u32)) -> Option<Place> {
    let (placement, within) = placement_of_all(session, off, size)?;
    Some(Place {
        told: placed_elsewhere(&placement, within, false),
        area: off.area,
        is_part: false,
        instead: None,
    })
}

/// The areas round pixels that are off which are at least about `cell` pixels apart, from the top down, and whether some of
/// these are of the live view. Where it is not known what is behind shapes, only such.
fn areas_apart(off: &FigureOff, cell: u32) -> Vec<(Area, bool)> {
    let pictures = [(&off.ours, true), (&off.theirs, false)].into_iter();
    let pixels =
        pictures.flat_map(|(pixels, is_ours)| pixels.iter().map(move |&[x, y]| ((x, y), is_ours)));
    let areas = clusters(pixels, |(pixel, _)| *pixel, cell)
        .into_iter()
        .filter_map(|cluster| {
            let is_ours = cluster.iter().any(|(_, is_ours)| *is_ours);
            let area = Area::around(cluster.into_iter().map(|(pixel, _)| pixel))?;
            (is_ours || off.has_outline).then_some((area, is_ours))
        });
    areas.collect()
}
