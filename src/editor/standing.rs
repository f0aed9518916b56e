//! What stands somewhere, and the way out of it.

use crate::math::Aabb;
use glam::Vec3;

/// Gap between a figure and what it stands beside, relative to its width.
const GAP: f32 = 0.1;
/// Share of both boxes that has to be in the other for one to stand in the other: a lamp in a hand
/// does not, nor does a figure in a room.
const INSIDE: f32 = 0.1;
/// Share of the shorter side of two figures' boxes, in each direction, from which on one stands in the other, however
/// large that is: a lizard whose tail looks out behind a man does, a rider on a horse does not.
const MOSTLY_INSIDE: f32 = 0.5;

/// The same from which on it shows that one reaches into the other.
const SHOWS: f32 = 0.05;

/// Least volume of what a figure does not stand in, relative to its own, though it is no figure: a lamp or a sword in a hand
/// has less.
const LARGE: f32 = 0.05;

/// What stands somewhere already.
pub(super) struct Stander {
    pub(super) bounds: Aabb,
    /// Whether nothing else stands in it: it is a figure, or hides what is inside of it.
    pub(super) is_solid: bool,
}

/// The least movement in the direction `along`, that of an axis, after which a figure with these `bounds` stands in none
/// of those that are there. What is moved at all does not come to where it would reach into another one a little, either.
pub(super) fn way_out(bounds: &Aabb, there: &[Stander], along: Vec3) -> Vec3 {
    if !there.iter().any(|other| stands_in(bounds, other)) {
        return Vec3::ZERO;
    }
    let gap = GAP * bounds.size().dot(along);
    let after = |other: &Stander| (other.bounds.max - bounds.min).dot(along) + gap;
    let mut ways: Vec<f32> = there.iter().map(after).filter(|way| *way > 0.0).collect();
    ways.sort_by(f32::total_cmp);
    let mut free = ways.into_iter().map(|way| along * way).filter(|&way| {
        let moved = moved(bounds, way);
        let is_there = |other: &Stander| stands_in(&moved, other) || reaches_into(&moved, other);
        !there.iter().any(is_there)
    });
    free.next().unwrap_or(Vec3::ZERO)
}

/// Whether a figure and what is there stand in one another. A figure is in a room, but not in another figure.
fn stands_in(figure: &Aabb, other: &Stander) -> bool {
    let (a, b) = (figure, &other.bounds);
    let larger = volume(a.size()).max(volume(b.size()));
    volume(common(a, b)) > INSIDE * larger || share_each_side(figure, other, MOSTLY_INSIDE)
}

/// Whether they have so much in common that it shows.
fn reaches_into(figure: &Aabb, other: &Stander) -> bool {
    share_each_side(figure, other, SHOWS)
}

/// Whether a figure and another one, or something large that is no room about it, have this `share` of the shorter side in
/// common in each direction.
fn share_each_side(figure: &Aabb, other: &Stander, share: f32) -> bool {
    let (a, b) = (figure, &other.bounds);
    // A room goes beyond the figure on all sides.
    let is_around = || b.min.cmple(a.min).all() && b.max.cmpge(a.max).all();
    let is_large = || volume(b.size()) >= LARGE * volume(a.size()) && !is_around();
    let shorter = a.size().min(b.size());
    (other.is_solid || is_large()) && common(a, b).cmpge(share * shorter).all()
}

fn common(a: &Aabb, b: &Aabb) -> Vec3 {
    a.max.min(b.max) - a.min.max(b.min)
}

fn volume(size: Vec3) -> f32 {
    size.max(Vec3::ZERO).element_product()
}

/// The bounds of a curve, as deep as it is wide: what is made of it takes up as much, and a flat one would stand in
/// nothing.
pub(super) fn body_of(bounds: &Aabb) -> Aabb {
    let (center, half) = (bounds.center(), bounds.size() / 2.0);
    let radius = half.x.max(half.z);
    let half = half.with_x(radius).with_z(radius);
    Aabb {
        min: center - half,
        max: center + half,
    }
}

/// `bounds` elsewhere.
pub(super) fn moved(bounds: &Aabb, by: Vec3) -> Aabb {
    Aabb {
        min: bounds.min + by,
        max: bounds.max + by,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn boxed(low: [f32; 3], high: [f32; 3]) -> Aabb {
        Aabb::from_points([low, high].map(Vec3::from))
    }

    fn way_among(own: &Aabb, there: &[Aabb], is_solid: bool) -> Vec3 {
        let there = there.iter().map(|&bounds| Stander { bounds, is_solid });
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
    fn what_is_moved_does_not_come_to_where_it_reaches_into_a_third_one() {
        let own = boxed([-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]);
        let long = boxed([2.4, -1.0, -1.0], [16.4, 2.0, 1.0]);
        // Where it is, reaching into the other a little is as its file has it.
        let own_there = moved(&own, Vec3::X * 2.2);
        assert_eq!(way_among(&own_there, &[long], true), Vec3::ZERO);
        let way = way_among(&own, &[own, long], true);
        assert!((way.x - 17.6).abs() < 1e-5, "{way}");
    }

    #[test]
    fn a_figure_in_a_room_and_a_lamp_in_a_hand_stay_there() {
        let own = boxed([-0.5, 0.0, -0.5], [0.5, 2.0, 0.5]);
        let room = boxed([-5.0, 0.0, -5.0], [5.0, 3.0, 5.0]);
        let lamp = boxed([0.3, 1.0, 0.2], [0.4, 1.2, 0.3]);
        let floor = boxed([-5.0, 0.0, -5.0], [5.0, 0.0, 5.0]);
        assert_eq!(way_out(&own, &[room, lamp, floor]), Vec3::ZERO);
        let vase = boxed([-0.2, 0.0, -0.2], [0.2, 0.9, 0.2]);
        let way = way_out(&own, &[room, lamp, floor, vase]);
        assert!((way.x - 0.8).abs() < 1e-5, "{way}");
    }
}
