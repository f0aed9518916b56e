//! Detail of the pictures that are shown while something moves.

use std::time::Duration;

/// Drafts that take this long follow the hand badly.
const SLOW: Duration = Duration::from_millis(80);
/// Where drafts take less than this, those of the next finer detail are not slow, either: they have four times the
/// pixels, or each triangle up to three times.
const FAST: Duration = Duration::from_millis(20);
/// Time that drafts of another detail are taken to need before they are known.
const UNKNOWN: Duration = Duration::from_millis(30);
/// Share of the mean that a new draft makes up, and the most that it counts for: a single frame that takes long for
/// another reason changes nothing.
const SHARE: f32 = 0.5;
const MOST: Duration = Duration::from_millis(120);

/// What a draft shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Detail {
    /// Everything but samples.
    #[default]
    Fine,
    /// The same with half the width and height.
    Half,
    /// Half the width and height, of a scene of many triangles with fewer.
    Coarse,
    /// The same without shadows and the lines round marked shapes, for which all triangles are drawn once more each.
    Sketch,
}

/// Chooses the detail of drafts by how long the last ones took.
#[derive(Debug)]
pub(super) struct DraftDetail {
    mean: Duration,
    detail: Detail,
    /// Whether drafts of the scene with all its triangles have been slow.
    whole_is_slow: bool,
}

impl DraftDetail {
    /// The first drafts have this `detail`.
    pub fn beginning_with(detail: Detail) -> Self {
        Self {
            mean: UNKNOWN,
            detail,
            whole_is_slow: false,
        }
    }

    /// Takes note of how long the frame with the last draft, which had this `detail`, took. Of a scene that `is_large`,
    /// coarse drafts say little of how long others take.
    pub fn count(&mut self, took: Duration, detail: Detail, is_large: bool) {
        if detail != self.detail {
            self.mean = UNKNOWN;
            self.detail = detail;
        }
        self.mean = self.mean.mul_f32(1.0 - SHARE) + took.min(MOST).mul_f32(SHARE);
        let next = match detail {
            Detail::Fine if self.mean > SLOW => Detail::Half,
            Detail::Half if self.mean > SLOW && is_large => Detail::Coarse,
            Detail::Half | Detail::Coarse if self.mean > SLOW => Detail::Sketch,
            Detail::Half if self.mean < FAST => Detail::Fine,
            Detail::Coarse if self.mean < FAST && !(is_large && self.whole_is_slow) => Detail::Half,
            Detail::Sketch if self.mean < FAST && is_large => Detail::Coarse,
            Detail::Sketch if self.mean < FAST => Detail::Half,
            same => same,
        };
        if next != detail {
            self.whole_is_slow |= next > Detail::Half;
            self.mean = UNKNOWN;
            self.detail = next;
        }
    }

    /// Detail of the next draft.
    pub fn next(&self) -> Detail {
        self.detail
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Detail::{Coarse, Fine, Half, Sketch};

    fn after(detail: &mut DraftDetail, frames: &[u64]) -> Detail {
        for &milliseconds in frames {
            detail.count(Duration::from_millis(milliseconds), detail.next(), false);
        }
        detail.next()
    }

    #[test]
    fn drafts_that_take_long_lose_detail_step_by_step_and_a_single_slow_frame_takes_none() {
        let mut detail = DraftDetail::beginning_with(Fine);
        assert_eq!(after(&mut detail, &[30; 20]), Fine);
        assert_eq!(after(&mut detail, &[5000, 30, 30]), Fine);
        assert_eq!(after(&mut detail, &[110; 2]), Half);
        assert_eq!(after(&mut detail, &[60; 20]), Half);
        assert_eq!(after(&mut detail, &[300; 20]), Sketch);
        // Browsers answer after some frames, for all of them.
        let mut uneven = DraftDetail::beginning_with(Fine);
        assert_eq!(after(&mut uneven, &[180, 30, 180]), Half);
    }

    #[test]
    fn detail_comes_back_where_more_of_it_takes_no_longer_than_it_may() {
        let mut detail = DraftDetail::beginning_with(Fine);
        assert_eq!(after(&mut detail, &[300; 9]), Sketch);
        assert_eq!(after(&mut detail, &[40; 50]), Sketch);
        assert_eq!(after(&mut detail, &[15; 4]), Half);
        assert_eq!(after(&mut detail, &[15; 20]), Fine);
        assert_eq!(after(&mut detail, &[60; 50]), Fine);
    }

    #[test]
    fn coarse_drafts_of_a_large_scene_give_way_to_whole_ones_and_for_good_only_if_these_are_fast() {
        let mut detail = DraftDetail::beginning_with(Coarse);
        let frames = |detail: &mut DraftDetail, milliseconds, is_large| {
            for _ in 0..3 {
                detail.count(Duration::from_millis(milliseconds), detail.next(), is_large);
            }
            detail.next()
        };
        assert_eq!(detail.next(), Coarse);
        assert_eq!(frames(&mut detail, 40, true), Coarse);
        assert_eq!(frames(&mut detail, 10, true), Half, "they are worth a try");
        assert_eq!(frames(&mut detail, 90, true), Coarse);
        assert_eq!(
            frames(&mut detail, 10, true),
            Coarse,
            "and not a second one"
        );
        assert_eq!(frames(&mut detail, 90, true), Sketch);
        assert_eq!(frames(&mut detail, 10, true), Coarse);
        assert_eq!(
            frames(&mut detail, 10, false),
            Fine,
            "when most of it is deleted"
        );
    }
}
