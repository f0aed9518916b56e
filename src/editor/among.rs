//! Where a figure that is added stands among the shapes that are there already.

use super::ground::{OFF_THE_GROUND, figures, lowest_at_rest};
use super::standing::{Stander, body_of, moved, way_out};
use super::{Edit, Session, hiding};
use crate::math::{Aabb, Euler};
use crate::scene::{
    Camera, Evaluated, EvaluatedShape, Evaluator, Look, NewShape, Scene, ShapeKind,
};
use glam::Vec3;

/// Depth of shapes by their width and height from which on they hide themselves.
const DEEP: f32 = 2.0;
/// How many times as far along X as along Z the eye is, from where figures stand beside each other along Z.
const FROM_THE_SIDE: f32 = 1.5;
/// Cosine of the angle from which on a figure shows its back.
const BACK: f32 = -0.5;

/// Places `shapes`, which are to be added, if one of them is a character: turned round where it would
/// show its back beside other characters, or else to `camera`, and beside whatever it would stand in, on
/// the ground of the other characters. Curves are placed beside characters, too, in which nobody would find
/// either of them, but not beside other curves, which they may belong to, and so are other shapes that would hide a
/// character in them. What stands in nothing stays where its file has it: on a horse, or in the air. In the Mannequin look
/// characters are only moved aside.
///
/// Returns whether shapes were moved so that they do not hide a character.
pub fn set_among(session: &Session, shapes: &mut [NewShape], camera: &Camera) -> bool {
    let mut bounds = bounds_of(shapes);
    let is_curve = |shape: &NewShape| matches!(shape.kind, ShapeKind::Curve(_));
    let Some(front) = shapes.iter().find_map(NewShape::front) else {
        let figures = figures_of(session);
        if shapes.iter().all(is_curve) {
            stand_beside(session, shapes, &bounds, |bounds| {
                way_out(&body_of(bounds), &figures, Vec3::X)
            });
            return false;
        }
        let by = way_out(&bounds, &figures, Vec3::X);
        let is_moved = by != Vec3::ZERO && hide_a_figure(session, shapes, camera.eye());
        if is_moved {
            move_all(shapes, by);
        }
        return is_moved;
    };
    let to_eye = camera.eye() - bounds.center();
    let wanted = session.scene().shapes().iter().find_map(|shape| {
        let front = shape.front();
        front.filter(|_| shape.visible)
    });
    let wanted = wanted.unwrap_or(to_eye);
    if !is_of_the_page(session) && shows_back(front, wanted) && turn_round(shapes, bounds.center())
    {
        bounds = bounds_of(shapes);
    }
    let others = standing_around(session, shapes, camera.eye());
    // Across the view: along it one would hide the other.
    let is_from_x = to_eye.x.abs() > FROM_THE_SIDE * to_eye.z.abs();
    let along = if is_from_x { Vec3::Z } else { Vec3::X };
    stand_beside(session, shapes, &bounds, |bounds| {
        let beside = way_out(bounds, &others, along);
        let back = backwards(bounds, &others, wanted);
        if beside != Vec3::ZERO && back != Vec3::ZERO && !is_from_x {
            back + way_out(&moved(bounds, back), &others, along)
        } else {
            beside
        }
    });
    false
}

/// Whether `shapes`, which are to be added, would hide one of the figures that are seen from the direction of `eye`.
fn hide_a_figure(session: &Session, shapes: &[NewShape], eye: Vec3) -> bool {
    let alone = evaluated_alone(shapes);
    let scene = session.scene();
    let is_figure = |shape: &&EvaluatedShape| {
        let shape = scene.shape(shape.id);
        shape.is_some_and(|shape| shape.visible && shape.front().is_some())
    };
    let mut figures = session.evaluated().shapes.iter().filter(is_figure);
    figures.any(|figure| {
        let mut hiding = alone.shapes.iter();
        hiding.any(|shape| hiding::hides(shape, figure, eye))
    })
}

/// What is seen in the document, where what would hide `shapes`, which are to be added, from the direction of `eye` is as
/// solid as a figure.
fn standing_around(session: &Session, shapes: &[NewShape], eye: Vec3) -> Vec<Stander> {
    let alone = evaluated_alone(shapes);
    let mut all = standing(session);
    let seen = session
        .evaluated()
        .shapes
        .iter()
        .filter(|shape| shape.visible);
    for (stander, shape) in all.iter_mut().zip(seen) {
        let mut added = alone.shapes.iter();
        stander.is_solid |= added.any(|figure| hiding::hides(shape, figure, eye));
    }
    all
}

/// The way back for what is deep, seen from the side that `others` face, until it stands out no further than these:
/// before them it would hide them.
fn backwards(bounds: &Aabb, others: &[Stander], facing: Vec3) -> Vec3 {
    let level = facing.with_y(0.0).normalize_or_zero();
    if level == Vec3::ZERO || !is_deep(bounds, level) {
        return Vec3::ZERO;
    }
    let reach = |bounds: &Aabb| {
        let half = bounds.size() / 2.0;
        level.dot(bounds.center()) + level.abs().dot(half)
    };
    let others = others.iter().map(|other| reach(&other.bounds));
    let further = reach(bounds) - others.fold(f32::NEG_INFINITY, f32::max);
    let further = Some(further).filter(|by| by.is_finite());
    -level * further.unwrap_or(0.0).max(0.0)
}

/// Whether what has these bounds is so deep, seen from the side that `front` faces, that most of it is behind its nearest
/// part.
pub fn is_deep(bounds: &Aabb, front: Vec3) -> bool {
    let size = bounds.size();
    let depth = size.dot(front.abs());
    let across = size.dot(front.cross(Vec3::Y).abs());
    depth > DEEP * across.max(size.y)
}

/// What is seen in the document.
fn standing(session: &Session) -> Vec<Stander> {
    let all = (session.scene().shapes().iter()).zip(&session.evaluated().shapes);
    let there = all.filter(|(_, evaluated)| evaluated.visible);
    let there = there.map(|(shape, evaluated)| Stander {
        bounds: evaluated.world_bounds(),
        is_solid: shape.front().is_some(),
    });
    there.collect()
}

/// The figures that are seen in the document.
pub(super) fn figures_of(session: &Session) -> Vec<Stander> {
    let mut figures = standing(session);
    figures.retain(|other| other.is_solid);
    figures
}

/// Moves shapes with these `bounds`, which would stand in others, onto the ground of the characters, and there by what
/// `way_out` says of their bounds then.
fn stand_beside(
    session: &Session,
    shapes: &mut [NewShape],
    bounds: &Aabb,
    way_out: impl Fn(&Aabb) -> Vec3,
) {
    if way_out(bounds) == Vec3::ZERO {
        return;
    }
    let up = ground_of_characters(session).map_or(0.0, |ground| ground - lowest_of(shapes));
    let is_off = up.is_finite() && up.abs() > OFF_THE_GROUND * bounds.size().y;
    let is_lifted = is_off && !is_of_the_page(session);
    let up = Vec3::Y * if is_lifted { up } else { 0.0 };
    move_all(shapes, up + way_out(&moved(bounds, up)));
}

/// Whether figures are shown as the Virtual Mannequin's page does: as high above its floor, and turned, as their files have
/// them, since the colors of normals show that.
fn is_of_the_page(session: &Session) -> bool {
    session.view().look == Look::Mannequin
}

fn move_all(shapes: &mut [NewShape], by: Vec3) {
    for shape in shapes {
        shape.placement.transform.position += by;
        shape.start.transform.position += by;
    }
}

/// Has figures that are to be added stand on the ground, if the view shows one: those that would sink below all that is
/// seen are lifted, since the ground would follow them down and leave everything else in the air, and those that would hang
/// in the air beside other characters are let down, but not what is above something, such as a rider.
pub fn put_on_ground(session: &Session, shapes: &mut [NewShape]) {
    if !session.view().has_ground() || shapes.iter().find_map(NewShape::front).is_none() {
        return;
    }
    let others = standing(session);
    // The ground is no higher than 0, also where all that is seen hovers.
    let heights = others.iter().map(|one| one.bounds.min.y.min(0.0));
    let lowest = heights.fold(f32::INFINITY, f32::min);
    let bounds = bounds_of(shapes);
    let own = lowest_of(shapes);
    let off_the_ground = OFF_THE_GROUND * bounds.size().y;
    let up = lowest - own;
    if up.is_finite() && up > off_the_ground {
        move_all(shapes, Vec3::Y * up);
        return;
    }
    let is_below = |other: &Stander| {
        let middle = bounds.center().with_y(other.bounds.center().y);
        other.bounds.contains(middle)
    };
    let ground = ground_of_characters(session).unwrap_or(lowest);
    let down = ground - own;
    if down.is_finite() && -down > off_the_ground && !others.iter().any(is_below) {
        let down = Vec3::Y * down;
        move_all(
            shapes,
            down + way_out(&moved(&bounds, down), &others, Vec3::X),
        );
    }
}

/// `shapes` of several files, of which the next so many are from one each, so that none stands in those of a file
/// before it: placed as by [`set_among`] one file after the other.
pub fn set_beside_each_other(
    shapes: Vec<NewShape>,
    counts: impl Iterator<Item = usize>,
    camera: &Camera,
) -> Vec<NewShape> {
    let mut rest = shapes.into_iter();
    let mut placed: Vec<NewShape> = Vec::new();
    let mut before = Session::new();
    for count in counts {
        let mut next: Vec<NewShape> = rest.by_ref().take(count).collect();
        if !placed.is_empty() {
            set_among(&before, &mut next, camera);
        }
        // Adding shapes is never refused.
        let _ = before.edit(Edit::Insert(next.clone()));
        placed.extend(next);
    }
    placed
}

/// Places a new shape beside the others in which it would be hidden, and lifts it onto the ground of figures if a part of
/// it or of its control points would be below. A curve is placed beside figures alone: it may belong to other curves. Only
/// if the view shows a ground: elsewhere it is where the course's editor has it.
pub fn set_beside_others(session: &Session, shape: &mut NewShape) {
    if !session.view().has_ground() {
        return;
    }
    let up = ground_of_characters(session).map_or(0.0, |ground| ground - lowest_point(shape));
    let is_curve = matches!(shape.kind, ShapeKind::Curve(_));
    // A curve need not stand on anything, but is not hidden below the ground.
    let up = if is_curve { up.max(0.0) } else { up };
    let mut by = Vec3::Y * if up.is_finite() { up } else { 0.0 };
    let mut bounds = bounds_of(std::slice::from_ref(shape));
    let mut others = standing(session);
    if is_curve {
        bounds = body_of(&bounds);
        others.retain(|other| other.is_solid);
    }
    let lifted = moved(&bounds, by);
    by += way_out(&lifted, &others, Vec3::X);
    for placement in [&mut shape.placement, &mut shape.start] {
        placement.transform.position += by;
    }
}

/// Height, in the world, of the lowest point of a shape that is in no scene yet, control points included.
fn lowest_point(shape: &NewShape) -> f32 {
    let alone = evaluated_alone(std::slice::from_ref(shape));
    let lowest = alone.shapes.iter().map(|shape| {
        let curves = shape
            .geometry
            .curves
            .iter()
            .flat_map(|curves| &curves.curves);
        let points = curves.flat_map(|curve| curve.control_points.iter().copied());
        let points = Aabb::from_points(points).transformed(shape.world_from_model);
        shape.world_bounds().union(points).min.y
    });
    lowest.fold(f32::INFINITY, f32::min)
}

/// Bounds of shapes that are in no scene yet, in the world. Those that are hidden take their place,
/// too.
pub fn bounds_of(shapes: &[NewShape]) -> Aabb {
    let alone = evaluated_alone(shapes);
    let all = alone.shapes.iter();
    all.fold(Aabb::EMPTY, |all, shape| all.union(shape.world_bounds()))
}

/// The height that shapes, which are to be added, stand on: of what their meshes have, if they have any, since a joint
/// may hang below.
fn lowest_of(shapes: &[NewShape]) -> f32 {
    let alone = evaluated_alone(shapes);
    let lowest = alone
        .shapes
        .iter()
        .map(|shape| match lowest_at_rest(shape) {
            height if height.is_finite() => height,
            _ => shape.world_bounds().min.y,
        });
    lowest.fold(f32::INFINITY, f32::min)
}

fn evaluated_alone(shapes: &[NewShape]) -> Evaluated {
    let mut alone = Scene::new();
    for shape in shapes {
        alone.add(shape.clone());
    }
    Evaluator::new().evaluate(&alone, 0.0)
}

/// Height, in the world, of the lowest point of all characters that are seen, at rest: a leg that is lifted
/// leaves the ground where it is.
fn ground_of_characters(session: &Session) -> Option<f32> {
    let lowest = figures(session).map(|(_, shown)| lowest_at_rest(shown));
    lowest.reduce(f32::min).filter(|height| height.is_finite())
}

fn shows_back(front: Vec3, toward: Vec3) -> bool {
    let level = |vector: Vec3| vector.with_y(0.0).normalize_or_zero();
    level(front).dot(level(toward)) < BACK
}

/// Turns all shapes by half a turn about the vertical through `center`; not those that are turned
/// already, whose angles would become others than their file has. Whether they were turned.
fn turn_round(shapes: &mut [NewShape], center: Vec3) -> bool {
    let is_turned = |shape: &NewShape| shape.placement.transform.rotation != Euler::ZERO;
    if shapes.iter().any(is_turned) {
        return false;
    }
    for shape in shapes {
        for placement in [&mut shape.placement, &mut shape.start] {
            let transform = &mut placement.transform;
            let opposite = 2.0 * center - transform.position;
            transform.position = opposite.with_y(transform.position.y);
            transform.rotation = Euler::from_degrees(Vec3::new(0.0, 180.0, 0.0));
        }
    }
    true
}
