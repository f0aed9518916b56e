//! How often the direction of a closed curve turns round, which tells inside from outside also where parts of it cross.

use glam::DVec2;
use std::f64::consts::TAU;

/// Angle between two edges from which on they may turn to either side, in radians: that of a half turn but for rounding.
const BACK: f64 = 3.0;

/// How many times the direction of a closed polygon turns round on the way once along it, counter-clockwise: 1 or −1 unless it
/// crosses itself. It stays the same where a part of the curve is pushed through another one, while the area that it encloses may
/// change its sign (H. Whitney, *On regular closed curves in the plane*, 1937). `None` if an edge turns back. Corners that are up to
/// `coinciding` apart count as one.
pub(super) fn turning_number(corners: &[DVec2], coinciding: f64) -> Option<i32> {
    let mut apart: Vec<DVec2> = Vec::with_capacity(corners.len());
    for &corner in corners.iter().chain(corners.first()) {
        if apart
            .last()
            .is_none_or(|last| last.distance(corner) > coinciding)
        {
            apart.push(corner);
        }
    }
    let mut edges: Vec<DVec2> = apart.windows(2).map(|pair| pair[1] - pair[0]).collect();
    edges.extend(edges.first().copied());
    let turns = edges.windows(2).map(|pair| pair[0].angle_to(pair[1]));
    let all = turns.map(|turn| (turn.abs() < BACK).then_some(turn));
    let sum: f64 = all.sum::<Option<f64>>()?;
    Some((sum / TAU).round() as i32)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn turns(corners: &[[f64; 2]]) -> Option<i32> {
        let corners: Vec<DVec2> = corners.iter().copied().map(DVec2::from).collect();
        turning_number(&corners, 1e-9)
    }

    #[test]
    fn a_curve_turns_once_however_a_part_of_it_is_pushed_through_another_one() {
        let simple = [[0.0, 0.0], [4.0, 0.0], [4.0, 1.0], [2.0, 1.0], [0.0, 1.0]];
        assert_eq!(turns(&simple), Some(1));
        // Its lower edge far above its upper one: more of it lies to the right than to the left.
        let pushed = [
            [0.0, 0.0],
            [1.0, 0.0],
            [2.0, 9.0],
            [3.0, 0.0],
            [4.0, 0.0],
            [4.0, 1.0],
            [0.0, 1.0],
        ];
        assert_eq!(turns(&pushed), Some(1));
        let mut backward = pushed;
        backward.reverse();
        assert_eq!(turns(&backward), Some(-1));
        let eight = [[0.0, 0.0], [2.0, 1.0], [2.0, 0.0], [0.0, 1.0]];
        assert_eq!(turns(&eight), Some(0));
    }

    #[test]
    fn what_turns_back_is_told_to_neither_side() {
        assert_eq!(turns(&[[0.0, 0.0], [1.0, 0.0]]), None);
        assert_eq!(turns(&[]), Some(0));
    }
}
