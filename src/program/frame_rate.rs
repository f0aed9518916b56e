use std::time::Duration;

/// Frames further apart than this do not follow each other: nothing had changed between them.
const PAUSE: Duration = Duration::from_millis(250);
/// Share of the mean that a new frame makes up.
const SHARE: f32 = 0.1;
/// Frames in a row before their rate says anything.
const ENOUGH: u32 = 8;
/// Time for which a rate is shown: one that changed with every frame could not be read, and would have the
/// panels painted anew for its own sake.
const SHOWN: Duration = Duration::from_millis(500);

/// How fast frames are drawn while they follow each other.
#[derive(Debug, Default)]
pub(super) struct FrameRate {
    /// Time of the last frame, by the host's clock.
    last: Option<Duration>,
    /// Frames in a row, and their mean distance in seconds.
    row: u32,
    mean: f32,
    /// The rate that is shown, and since when.
    shown: Option<(f32, Duration)>,
}

impl FrameRate {
    /// Counts a frame that begins at `now`, by the host's clock.
    pub fn count(&mut self, now: Duration) {
        let since = self.last.map(|last| now.saturating_sub(last));
        self.last = Some(now);
        match since {
            Some(since) if since < PAUSE => {
                let seconds = since.as_secs_f32();
                self.mean = if self.row == 0 {
                    seconds
                } else {
                    self.mean + (seconds - self.mean) * SHARE
                };
                self.row += 1;
            }
            _ => self.row = 0,
        }
        let rate = (self.row >= ENOUGH && self.mean > 0.0).then(|| 1.0 / self.mean);
        self.shown = match (rate, self.shown) {
            (Some(_), Some((shown, since))) if now < since + SHOWN => Some((shown, since)),
            (rate, _) => rate.map(|rate| (rate, now)),
        };
    }

    /// Frames in a second, as they were half a second ago at most; none before there were enough in a row.
    pub fn shown(&self) -> Option<f32> {
        self.shown.map(|(rate, _)| rate)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rate_is_shown_while_frames_follow_each_other_and_not_after_a_pause() {
        let mut rate = FrameRate::default();
        let mut now = Duration::ZERO;
        for frame in 0..20 {
            now += Duration::from_millis(20);
            rate.count(now);
            assert_eq!(rate.shown().is_some(), frame >= 8, "after frame {frame}");
        }
        assert!((rate.shown().unwrap() - 50.0).abs() < 0.1);
        rate.count(now + Duration::from_secs(1));
        assert_eq!(rate.shown(), None);
    }

    #[test]
    fn one_slow_frame_changes_the_rate_a_little_and_many_change_it_to_theirs() {
        let mut rate = FrameRate::default();
        let mut now = Duration::ZERO;
        let mut frames = |count, milliseconds| {
            for _ in 0..count {
                now += Duration::from_millis(milliseconds);
                rate.count(now);
            }
            1.0 / rate.mean
        };
        frames(20, 20);
        // A tenth of 100 ms and nine tenths of 20 ms are 28 ms.
        assert!((frames(1, 100) - 1.0 / 0.028).abs() < 0.1);
        assert!((frames(100, 100) - 10.0).abs() < 0.1);
    }

    #[test]
    fn a_rate_stands_for_half_a_second() {
        let mut rate = FrameRate::default();
        let mut shown = Vec::new();
        // Frames that take longer and longer, for two seconds.
        let mut now = Duration::ZERO;
        let mut distance = 10.0;
        while now < Duration::from_secs(2) {
            distance += 0.2;
            now += Duration::from_secs_f32(distance / 1000.0);
            rate.count(now);
            shown.extend(rate.shown());
        }
        shown.dedup();
        assert!((3..=4).contains(&shown.len()), "{shown:?}");
        assert!(shown.is_sorted_by(|one, other| one > other), "{shown:?}");
    }
}
