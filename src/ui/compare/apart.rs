//! Places apart from one another in which pictures differ.

use super::CompareView;
use super::clusters::clusters;
use super::elsewhere::placement_of_all;
use super::how::How;
use super::other_camera::other_camera;
use super::part::{Kind, Part};
use super::parts::{Parts, of_shapes, parts};
use super::place::{
    MUCH, absent, much_is_off, near, place, placed_elsewhere, seen_from_elsewhere, whole,
};
use crate::compare::{Area, FigureOff, about, sentence};
use crate::editor::Session;
use crate::revision::Revision;
use crate::scene::Camera;

/// What is told of a camera that the floor alone shows to be another one.
const FLOOR_ELSEWHERE: &str = "A is seen by another camera than B: its floor is elsewhere as well.";

/// What is told of a picture that shows nothing of what is in the live view.
const NOTHING: &str = "A shows nothing of what B does, or no more than lines: it is missing or hidden there, or A looks elsewhere.";

/// What a place in which pictures differ tells of the camera.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum CameraTold {
    /// It is right, for a part of the scene differs.
    Right,
    /// The other picture has another one, or may have, which the place says.
    Other,
    /// The other picture has the one that Home leads to, which the place says.
    Home,
    /// It may be either.
    Unknown,
}

/// A place in which pictures differ.
#[derive(Clone, Debug)]
pub(super) struct Place {
    pub told: String,
    pub area: Area,
    /// What it tells of the camera.
    pub camera: CameraTold,
    /// What else may be behind it, in a sentence.
    pub instead: Option<String>,
}

impl Place {
    /// A place about which nothing else is told.
    pub(super) fn new(told: String, area: Area, camera: CameraTold) -> Self {
        Self {
            told,
            area,
            camera,
            instead: None,
        }
    }
}

/// The places that were found last. They stay as long as nothing changes of what they follow from: to find them takes longer
/// than a frame should, for rays go to thousands of pixels.
#[derive(Clone, Debug, Default)]
pub(in crate::ui) struct KeptPlaces {
    of: Option<KeptOf>,
    places: Vec<Place>,
}

/// What places follow from: the document, its view of so many pixels, and what differs there, of which a new one has other
/// numbers of pixels or is round another area.
type KeptOf = (Revision, Camera, (u32, u32), Area, [usize; 3]);

impl KeptPlaces {
    /// The places that `find` finds from what is off. While that is measured anew, as in the midst of a drag, they stay.
    fn get(
        &mut self,
        session: &Session,
        compare: &CompareView,
        off: &FigureOff,
        find: impl FnOnce() -> Vec<Place>,
    ) -> Vec<Place> {
        if compare.report.measuring {
            return self.places.clone();
        }
        let counts = [&off.ours, &off.theirs, &off.right].map(Vec::len);
        let camera = session.view().camera;
        let of = (session.document(), camera, compare.size(), off.area, counts);
        if self.of != Some(of) {
            self.places = find();
            self.of = Some(of);
        }
        self.places.clone()
    }

    /// The parts that differ, if there are some that explain what does, or else all of the figure if it stands `elsewhere` or is
    /// seen by another camera.
    pub(super) fn of_figure(
        &mut self,
        session: &Session,
        compare: &CompareView,
        off: &FigureOff,
        elsewhere: impl FnOnce() -> Option<Place>,
    ) -> Vec<Place> {
        self.get(session, compare, off, || {
            parts_or_all(session, off, compare.size(), elsewhere)
        })
    }

    /// All of the figure, which is known to be seen by another camera, with how that differs if it is found.
    pub(super) fn seen_elsewhere(
        &mut self,
        session: &Session,
        compare: &CompareView,
        off: &FigureOff,
        elsewhere: impl FnOnce() -> Option<Place>,
    ) -> Vec<Place> {
        self.get(session, compare, off, || {
            let by_outline = || seen_by_other_camera(session, off, compare.size());
            let all = elsewhere().or_else(by_outline);
            let by_floor = || Place::new(FLOOR_ELSEWHERE.to_owned(), off.area, CameraTold::Other);
            vec![all.unwrap_or_else(by_floor)]
        })
    }

    /// The places apart from one another in which what is drawn differs, which has `figure` round it: parts of the scene, or
    /// else where a bone is near, or where they lie in the figure. None if there are too many.
    pub(super) fn apart(
        &mut self,
        session: &Session,
        compare: &CompareView,
        off: &FigureOff,
        figure: Area,
    ) -> Vec<Place> {
        self.get(session, compare, off, || {
            apart(session, off, figure, compare.size())
        })
    }
}

/// The parts that differ, or else all that is drawn if it stands `elsewhere` or is seen by another camera.
fn parts_or_all(
    session: &Session,
    off: &FigureOff,
    size: (u32, u32),
    elsewhere: impl FnOnce() -> Option<Place>,
) -> Vec<Place> {
    let Parts {
        all: parts,
        is_shape_still,
    } = parts(session, off, size);
    // Seen by another camera, no character would be in its place.
    let is_in_place =
        |part: &Part| matches!(part.kind, Kind::Character(_)) && part.kind.is_in_place();
    let is_camera_right = is_shape_still || off.is_camera_right || parts.iter().any(is_in_place);
    let by_other_camera = || match is_camera_right {
        true => None,
        false => seen_by_other_camera(session, off, size),
    };
    let are_absent = parts.iter().all(|part| part.kind == Kind::Absent);
    let all = match parts.len() {
        // Round a shape that is only larger in the other picture nothing is in the live view, either.
        _ if are_absent => {
            let by_other_camera = by_other_camera();
            let is_home = |place: &Place| place.camera == CameraTold::Home;
            match by_other_camera.as_ref().is_some_and(is_home) {
                true => by_other_camera,
                false => elsewhere().or(by_other_camera),
            }
        }
        1 => None,
        // What several parts would explain may be one camera.
        _ => by_other_camera(),
    };
    all.map_or_else(|| places_of(parts), |all| vec![all])
}

/// All that is drawn, if it is where the other picture has it as another camera sees it.
fn seen_by_other_camera(session: &Session, off: &FigureOff, size: (u32, u32)) -> Option<Place> {
    let camera = other_camera(session, off, size)?;
    let told = match camera.homes {
        Some(_) => CameraTold::Home,
        None => CameraTold::Other,
    };
    Some(Place::new(seen_from_elsewhere(&camera), off.area, told))
}

fn places_of(parts: Vec<Part>) -> Vec<Place> {
    let places = parts.into_iter().map(|part| {
        let (name, share) = (&part.name, about(part.percent));
        let camera = match part.kind {
            Kind::All => CameraTold::Other,
            _ => CameraTold::Right,
        };
        let (told, instead) = match part.kind {
            Kind::Character(how) => (whole(name, &share, how.map(How::in_words)), None),
            Kind::Shape(how) => (near(name, &share, how.map(How::in_words)), None),
            Kind::Limb { instead } => (near(name, &share, None), instead),
            Kind::Absent => (absent(name, &share), None),
            Kind::All => (NOTHING.to_owned(), None),
        };
        Place {
            told,
            area: part.area,
            camera,
            instead,
        }
    });
    places.collect()
}

/// Most places apart from one another that are told one by one, …
const MOST_APART: usize = 4;
/// … and how far they are apart, by the picture's height.
const APART: f32 = 0.025;
/// Share of the box round a figure in which one of them is of no single joint, for that would have been found: of one of two characters
/// whose weights were those of other joints it was 0.24.
const MUCH_APART: f64 = 0.1;

fn apart(session: &Session, off: &FigureOff, figure: Area, size: (u32, u32)) -> Vec<Place> {
    let off = of_shapes(session, off, size);
    let known = parts_or_all(session, &off, size, || elsewhere(session, &off, size));
    if !known.is_empty() {
        return known;
    }
    let apart = areas_apart(&off, (APART * size.1 as f32).max(1.0) as u32);
    let is_much = |(area, _): &(Area, bool)| area.share_of(figure) >= MUCH_APART;
    let are_many = apart.len() > MOST_APART;
    let figure_pixels = off.ours.len() + off.right.len();
    let share = off.ours.len() as f64 / figure_pixels.max(1) as f64;
    if apart.iter().any(is_much) || are_many && share >= MUCH {
        return vec![much(&off, figure)];
    }
    if are_many {
        return Vec::new();
    }
    let places = apart.into_iter().map(|(area, is_ours)| {
        // Bones are where the live view has them.
        let told = if is_ours {
            place(session, area, figure, size)
        } else {
            sentence(&area.place_in(figure))
        };
        Place::new(told, area, camera_beside(&off))
    });
    places.collect()
}

/// What is told of the camera where no parts of the scene explain what is off.
fn camera_beside(off: &FigureOff) -> CameraTold {
    match off.is_camera_right {
        true => CameraTold::Right,
        false => CameraTold::Unknown,
    }
}

/// Much of the figure, where no limbs explain what is off: no joint is to blame for that.
fn much(off: &FigureOff, figure: Area) -> Place {
    let camera = camera_beside(off);
    let told = much_is_off(&off.area.place_in(figure), camera);
    Place::new(told, off.area, camera)
}

/// All that is drawn, if it has the outline of the other picture but stands elsewhere.
fn elsewhere(session: &Session, off: &FigureOff, size: (u32, u32)) -> Option<Place> {
    let (placement, within) = placement_of_all(session, off, size)?;
    let told = placed_elsewhere(&placement, within, CameraTold::Unknown);
    Some(Place::new(told, off.area, CameraTold::Other))
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::editor::Edit;
    use crate::scene::{NewShape, ShapeKind};

    /// Every third pixel of a square round the middle of a picture.
    fn square(half: u32) -> Vec<[u32; 2]> {
        let along = |middle: u32| (middle - half..middle + half).filter(|at| at % 3 == 0);
        along(150)
            .flat_map(|y| along(300).map(move |x| [x, y]))
            .collect()
    }

    #[test]
    fn round_a_shape_that_is_larger_in_the_other_picture_nothing_is_missing() {
        let mut session = Session::new();
        let cube = NewShape::new("Cube", ShapeKind::Cube);
        session.edit(Edit::Insert(vec![cube])).unwrap();
        let (size, right) = ((600, 300), square(30));
        let theirs = square(60).into_iter();
        let off = FigureOff {
            area: "240,90,120,120".parse().unwrap(),
            ours: Vec::new(),
            theirs: theirs.filter(|pixel| !right.contains(pixel)).collect(),
            thin: None,
            outlines: [square(60), right.clone()],
            right,
            apart: 3,
            has_outline: true,
            is_camera_right: false,
        };
        let told = |elsewhere: Option<Place>| -> Vec<String> {
            let places = parts_or_all(&session, &off, size, || elsewhere).into_iter();
            places.map(|place| place.told).collect()
        };
        let larger = Place::new("Larger".to_owned(), off.area, CameraTold::Unknown);
        assert_eq!(told(Some(larger)), ["Larger"]);
        let [missing] = &told(None)[..] else {
            panic!("one place");
        };
        assert!(missing.starts_with("A shows something"), "{missing}");
    }
}
