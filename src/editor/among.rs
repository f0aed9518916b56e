//! Where a figure that is added stands among the shapes that are there already.

use super::{Edit, Session, hiding};
use crate::math::{Aabb, Euler, Transform};
use crate::scene::{
    Camera, Evaluated, EvaluatedShape, Evaluator, NewShape, Scene, ShapeId, ShapeKind,
};
use glam::Vec3;

/// Gap between a figure and what it stands beside, relative to its width.
const GAP: f32 = 0.1;
/// Share of both boxes that has to be in the other for one to stand in the other: a lamp in a hand
/// does not, nor does a figure in a room.
const INSIDE: f32 = 0.1;
/// Share of the shorter side of two figures' boxes, in each direction, from which on one stands in the other, however
/// large that is: a lizard whose tail looks out behind a man does, a rider on a horse does not.
const MOSTLY_INSIDE: f32 = 0.5;
/// Distance from the ground, relative to its height, from which on a figure hangs or sinks.
const OFF_THE_GROUND: f32 = 0.02;
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
/// character in them. What stands in nothing stays where its file has it: on a horse, or in the air.
///
/// Returns whether shapes were moved so that they do not hide a character.
pub fn set_among(session: &Session, shapes: &mut [NewShape], camera: &Camera) -> bool {
    let mut bounds = bounds_of(shapes);
    let is_curve = |shape: &NewShape| matches!(shape.kind, ShapeKind::Curve(_));
    let Some(front) = shapes.iter().find_map(NewShape::front) else {
        let mut figures = standing(session);
        figures.retain(|other| other.is_figure);
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
    if shows_back(front, wanted) && turn_round(shapes, bounds.center()) {
        bounds = bounds_of(shapes);
    }
    let others = standing(session);
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
    figures.any(|figure| hiding::hide(&alone, figure, eye))
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
        is_figure: shape.front().is_some(),
    });
    there.collect()
}

/// The bounds of a curve, as deep as it is wide: what is made of it takes up as much, and a flat one would stand in
/// nothing.
fn body_of(bounds: &Aabb) -> Aabb {
    let (center, half) = (bounds.center(), bounds.size() / 2.0);
    let radius = half.x.max(half.z);
    let half = half.with_x(radius).with_z(radius);
    Aabb {
        min: center - half,
        max: center + half,
    }
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
    let up = ground_of_characters(session).map_or(0.0, |ground| ground - lowest_at_rest(shapes));
    let is_off = up.is_finite() && up.abs() > OFF_THE_GROUND * bounds.size().y;
    let up = Vec3::Y * if is_off { up } else { 0.0 };
    move_all(shapes, up + way_out(&moved(bounds, up)));
}

fn move_all(shapes: &mut [NewShape], by: Vec3) {
    for shape in shapes {
        shape.placement.transform.position += by;
        shape.start.transform.position += by;
    }
}

fn moved(bounds: &Aabb, by: Vec3) -> Aabb {
    Aabb {
        min: bounds.min + by,
        max: bounds.max + by,
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
    let heights = others.iter().map(|one| one.bounds.min.y);
    let lowest = heights.fold(f32::INFINITY, f32::min);
    let bounds = bounds_of(shapes);
    let own = lowest_at_rest(shapes);
    let off_the_ground = OFF_THE_GROUND * bounds.size().y;
    let up = lowest - own;
    if up.is_finite() && up > off_the_ground {
        move_all(shapes, Vec3::Y * up);
        return;
    }
    let is_below = |other: &Stander| {
        let middle = bounds.center().with_y(other.bounds.center().y);
        other.bounds.min.cmple(middle).all() && other.bounds.max.cmpge(middle).all()
    };
    let down = ground_of_characters(session).map_or(0.0, |ground| ground - own);
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
    let up = up.max(0.0);
    let mut by = Vec3::Y * if up.is_finite() { up } else { 0.0 };
    let mut bounds = bounds_of(std::slice::from_ref(shape));
    let mut others = standing(session);
    if matches!(shape.kind, ShapeKind::Curve(_)) {
        bounds = body_of(&bounds);
        others.retain(|other| other.is_figure);
    }
    let lifted = moved(&bounds, by);
    by += way_out(&lifted, &others, Vec3::X);
    for placement in [&mut shape.placement, &mut shape.start] {
        placement.transform.position += by;
    }
}

/// `transform`, in which the shape `id` is scaled otherwise than it is: moved up or down so that a figure that stands on
/// the ground stays there.
pub fn kept_on_ground(session: &Session, id: ShapeId, transform: Transform) -> Transform {
    let mut kept = transform;
    let (Some(floor), Some(shown)) = (ground_below(session, id), session.evaluated().shape(id))
    else {
        return kept;
    };
    let at_rest = shown.geometry.mesh.bounds();
    let up = floor - at_rest.transformed(transform.world_from_model()).min.y;
    if up.is_finite() {
        kept.position.y += up;
    }
    kept
}

/// Height, in the world, of the ground that the shape `id` stands on; `None` if it stands on none, or is no figure.
pub(super) fn ground_below(session: &Session, id: ShapeId) -> Option<f32> {
    session.scene().shape(id)?.front()?;
    let ground = ground_of_characters(session).filter(|_| session.view().has_ground())?;
    let bounds = at_rest(session.evaluated().shape(id)?);
    let above = bounds.min.y - ground;
    (above.abs() <= OFF_THE_GROUND * bounds.size().y).then_some(bounds.min.y)
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
fn lowest_at_rest(shapes: &[NewShape]) -> f32 {
    let alone = evaluated_alone(shapes);
    let lowest = alone.shapes.iter().map(|shape| match at_rest(shape) {
        mesh if mesh.is_empty() => shape.world_bounds().min.y,
        mesh => mesh.min.y,
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
    let shapes = session.scene().shapes().iter();
    let characters = shapes.filter(|shape| shape.visible && shape.front().is_some());
    let evaluated = characters.filter_map(|shape| session.evaluated().shape(shape.id));
    let lowest = evaluated.map(|shape| at_rest(shape).min.y);
    lowest.reduce(f32::min).filter(|height| height.is_finite())
}

/// Bounds of a shape at rest, in the world.
fn at_rest(shape: &EvaluatedShape) -> Aabb {
    let bounds = shape.geometry.mesh.bounds();
    bounds.transformed(shape.world_from_model)
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

/// What stands somewhere already.
struct Stander {
    bounds: Aabb,
    is_figure: bool,
}

/// The least movement in the direction `along`, that of an axis, after which a figure with these `bounds` stands in none
/// of those that are there.
fn way_out(bounds: &Aabb, there: &[Stander], along: Vec3) -> Vec3 {
    let gap = GAP * bounds.size().dot(along);
    let after = |other: &Stander| (other.bounds.max - bounds.min).dot(along) + gap;
    let mut ways: Vec<f32> = there.iter().map(after).filter(|way| *way > 0.0).collect();
    ways.sort_by(f32::total_cmp);
    let ways = std::iter::once(0.0).chain(ways);
    let ways = ways.map(|way| along * way);
    let mut free = ways.filter(|&way| {
        let moved = moved(bounds, way);
        !there.iter().any(|other| stands_in(&moved, other))
    });
    free.next().unwrap_or(Vec3::ZERO)
}

/// Whether a figure and what is there stand in one another. A figure is in a room, but not in another figure.
fn stands_in(figure: &Aabb, other: &Stander) -> bool {
    let volume = |size: Vec3| size.max(Vec3::ZERO).element_product();
    let (a, b) = (figure, &other.bounds);
    let common = a.max.min(b.max) - a.min.max(b.min);
    let larger = volume(a.size()).max(volume(b.size()));
    let is_within = || common.cmpge(MOSTLY_INSIDE * a.size().min(b.size())).all();
    volume(common) > INSIDE * larger || other.is_figure && is_within()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn boxed(low: [f32; 3], high: [f32; 3]) -> Aabb {
        Aabb::from_points([low, high].map(Vec3::from))
    }

    fn way_among(own: &Aabb, there: &[Aabb], is_figure: bool) -> Vec3 {
        let there = there.iter().map(|&bounds| Stander { bounds, is_figure });
        super::way_out(own, &there.collect::<Vec<_>>(), Vec3::X)
    }

    fn way_out(own: &Aabb, there: &[Aabb]) -> Vec3 {
        way_among(own, there, false)
    }

    #[test]
    fn a_figure_does_not_stand_in_a_larger_one_but_sits_on_it() {
        let own = boxed([-0.5, 0.0, -0.5], [0.5, 2.0, 0.5]);
        let giant = boxed([-5.0, 0.0, -5.0], [5.0, 20.0, 5.0]);
        let way = way_among(&own, &[giant], true);
        assert!((way.x - 5.6).abs() < 1e-5, "{way}");
        let way = way_among(&giant, &[own], true);
        assert!((way.x - 6.5).abs() < 1e-5, "{way}");
        let lizard = boxed([-0.3, 0.6, -1.5], [0.3, 0.9, 1.5]);
        let way = way_among(&lizard, &[own], true);
        assert!((way.x - 0.86).abs() < 1e-5, "{way}");
        let horse = boxed([-0.6, -1.5, -5.0], [0.6, 0.4, 5.0]);
        assert_eq!(way_among(&own, &[horse], true), Vec3::ZERO);
    }

    #[test]
    fn a_flat_curve_that_is_larger_than_a_figure_goes_past_it_and_one_overhead_stays() {
        let figure = boxed([-0.5, 0.0, -0.2], [0.5, 2.0, 0.2]);
        let curve = boxed([-5.0, 0.0, 0.0], [5.0, 20.0, 0.0]);
        let way = way_among(&body_of(&curve), &[figure], true);
        assert!((way.x - 6.5).abs() < 1e-5, "{way}");
        let overhead = boxed([-1.0, 3.0, 0.0], [1.0, 4.0, 0.0]);
        assert_eq!(way_among(&body_of(&overhead), &[figure], true), Vec3::ZERO);
    }

    #[test]
    fn a_box_moves_past_all_that_it_would_stand_in_and_no_further() {
        let own = boxed([-0.5, 0.0, -0.5], [0.5, 2.0, 0.5]);
        let beside = boxed([0.7, 0.0, -0.5], [1.7, 2.0, 0.5]);
        assert_eq!(way_out(&own, &[beside]), Vec3::ZERO);
        let way = way_out(&own, &[own, beside]);
        assert!((way.x - 2.3).abs() < 1e-5 && way.y == 0.0, "{way}");
        let far = boxed([9.0, 0.0, -0.5], [9.5, 2.0, 0.5]);
        let way = way_out(&own, &[far, own]);
        assert!((way.x - 1.1).abs() < 1e-5, "{way}");
    }

    #[test]
    fn a_figure_in_a_room_and_a_lamp_in_a_hand_stay_there() {
        let own = boxed([-0.5, 0.0, -0.5], [0.5, 2.0, 0.5]);
        let room = boxed([-5.0, 0.0, -5.0], [5.0, 3.0, 5.0]);
        let lamp = boxed([0.3, 1.0, 0.2], [0.4, 1.2, 0.3]);
        let floor = boxed([-5.0, 0.0, -5.0], [5.0, 0.0, 5.0]);
        assert_eq!(way_out(&own, &[room, lamp, floor]), Vec3::ZERO);
    }
}
