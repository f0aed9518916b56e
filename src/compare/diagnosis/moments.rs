//! Where the pixels of a mask are in the mean.

use crate::steps::Pace;
use glam::DVec2;

/// Number of the drawn pixels, their middle, and the direction in which they reach farthest.
#[derive(Clone, Copy, Debug)]
pub(super) struct Moments {
    pub count: f64,
    pub center: DVec2,
    pub direction: f64,
}

impl Moments {
    /// `None` where nothing is drawn.
    pub async fn of(drawn: &[bool], width: usize, pace: &Pace) -> Option<Self> {
        let places = || {
            let drawn = drawn.iter().enumerate().filter(|(_, drawn)| **drawn);
            drawn.map(|(i, _)| DVec2::new((i % width) as f64, (i / width) as f64))
        };
        let (count, sum) = places().fold((0.0, DVec2::ZERO), |(count, sum), at| {
            (count + 1.0, sum + at)
        });
        pace.after(drawn.len()).await;
        if count == 0.0 {
            return None;
        }
        let center = sum / count;
        let (squares, product) = places().fold((DVec2::ZERO, 0.0), |(squares, product), at| {
            let off = at - center;
            (squares + off * off, product + off.x * off.y)
        });
        pace.after(drawn.len()).await;
        Some(Self {
            count,
            center,
            direction: 0.5 * (2.0 * product).atan2(squares.x - squares.y),
        })
    }
}
