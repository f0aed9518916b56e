//! Work in steps, so that whoever waits for it can do other things between them.
//!
//! The work is written as asynchronous functions, which the compiler makes into what can be left and
//! taken up again; none of them waits for anything but its next step. The order of the work, and so
//! every bit of its result, is the same whatever the steps. How much work is done is told in units of
//! the work's own: pixels, vertices or bytes, each worked on once.

use std::cell::Cell;
use std::future::{Future, poll_fn};
use std::ops::Range;
use std::pin::Pin;
use std::rc::Rc;
use std::task::{Context, Poll, Waker};

/// Units that a pass over a list works on between two opportunities to rest.
const BAND: usize = 1 << 14;

/// Work under way, with a result of type `T`.
pub struct Steps<'a, T> {
    work: Pin<Box<dyn Future<Output = T> + 'a>>,
    pace: Rc<Pace>,
}

impl<'a, T> Steps<'a, T> {
    /// The work of what `begin` returns, in steps of at least so many `units`. None of it is done yet.
    pub(crate) fn new<F: Future<Output = T> + 'a>(
        units: usize,
        begin: impl FnOnce(Rc<Pace>) -> F,
    ) -> Self {
        let pace = Rc::new(Pace::new(units));
        let work = Box::pin(begin(Rc::clone(&pace)));
        Self { work, pace }
    }

    /// Work that cannot be interrupted, as one step.
    pub(crate) fn whole(work: impl FnOnce() -> T + 'a) -> Self
    where
        T: 'a,
    {
        Self::new(usize::MAX, |_| async move { work() })
    }

    /// Does the next step, and returns the result if it was the last one.
    ///
    /// # Panics
    /// If there has been a result already.
    pub fn step(&mut self) -> Option<T> {
        let mut nobody_waits = Context::from_waker(Waker::noop());
        match self.work.as_mut().poll(&mut nobody_waits) {
            Poll::Ready(result) => Some(result),
            Poll::Pending => None,
        }
    }

    /// Estimate of the part that is done, from 0 to 1. It never falls.
    pub fn part(&self) -> f32 {
        self.pace.part.get()
    }

    /// The same work, of whose result `change` makes another.
    pub(crate) fn map<U>(self, change: impl FnOnce(T) -> U + 'a) -> Steps<'a, U>
    where
        T: 'a,
    {
        let work = self.work;
        Steps {
            work: Box::pin(async move { change(work.await) }),
            pace: self.pace,
        }
    }

    /// Does all that is left.
    pub fn finish(mut self) -> T {
        loop {
            if let Some(result) = self.step() {
                return result;
            }
        }
    }
}

/// The result of work that is done in one step.
pub(crate) fn at_once<'a, T, F: Future<Output = T> + 'a>(begin: impl FnOnce(Rc<Pace>) -> F) -> T {
    Steps::new(usize::MAX, begin).finish()
}

/// How work goes on: it is told what was done, and ends a step when that is enough.
pub(crate) struct Pace {
    /// Units a step.
    step: usize,
    /// Units since the last rest.
    since: Cell<usize>,
    /// First and last part of the whole that [`Pace::begin`] is about.
    scope: Cell<(f32, f32)>,
    /// First and last part of the whole that [`Pace::tell`] is about.
    share: Cell<(f32, f32)>,
    part: Cell<f32>,
}

impl Pace {
    /// Steps of at least so many units.
    pub fn new(step: usize) -> Self {
        Self {
            step,
            since: Cell::default(),
            scope: Cell::new((0.0, 1.0)),
            share: Cell::new((0.0, 1.0)),
            part: Cell::default(),
        }
    }

    /// Takes note that so many units were worked on, and ends the step if it has had enough of them.
    pub async fn after(&self, units: usize) {
        let since = self.since.get().saturating_add(units);
        if since < self.step {
            self.since.set(since);
            return;
        }
        self.since.set(0);
        let mut has_rested = false;
        poll_fn(|_| match std::mem::replace(&mut has_rested, true) {
            true => Poll::Ready(()),
            false => Poll::Pending,
        })
        .await;
    }

    /// Calls `work` for ranges that together are `0..length`, in order.
    pub async fn bands(&self, length: usize, mut work: impl FnMut(Range<usize>)) {
        for start in (0..length).step_by(BAND) {
            let band = start..(start + BAND).min(length);
            let units = band.len();
            work(band);
            self.after(units).await;
        }
    }

    /// What is told from now on is about this share of the whole, or of the part that
    /// [`Pace::within`] leaves.
    pub fn begin(&self, share: Range<f32>) {
        self.share.set(part_of(self.scope.get(), share));
        self.tell(0.0);
    }

    /// Does `work`, whose whole is only this share of the whole here.
    pub async fn within<T>(&self, share: Range<f32>, work: impl Future<Output = T>) -> T {
        let before = self.scope.get();
        self.scope.set(part_of(before, share));
        self.begin(0.0..1.0);
        let result = work.await;
        self.tell(1.0);
        self.scope.set(before);
        result
    }

    /// Takes note of the part that is done, from 0 to 1.
    pub fn tell(&self, part: f32) {
        let (first, last) = self.share.get();
        self.part.set(first + part * (last - first));
    }
}

/// The `share` of a part that has its own first and last part.
fn part_of((first, last): (f32, f32), share: Range<f32>) -> (f32, f32) {
    let at = |part: f32| first + part * (last - first);
    (at(share.start), at(share.end))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Sum of the numbers below `length`, and the number of steps that it took.
    fn sum(length: usize, step: usize) -> (usize, usize) {
        let mut steps = Steps::new(step, |pace| async move {
            let mut sum = 0;
            pace.bands(length, |band| sum += band.sum::<usize>()).await;
            sum
        });
        let mut count = 1;
        loop {
            match steps.step() {
                Some(sum) => return (sum, count),
                None => count += 1,
            }
        }
    }

    #[test]
    fn work_rests_after_so_many_units_and_its_result_is_the_same() {
        let length = 4 * BAND + 1;
        let whole: usize = (0..length).sum();
        assert_eq!(sum(length, usize::MAX), (whole, 1));
        assert_eq!(sum(length, 2 * BAND), (whole, 3));
        assert_eq!(sum(length, 1), (whole, 6));
    }

    #[test]
    fn the_part_that_is_done_is_told_within_its_share() {
        let mut steps = Steps::new(1, |pace| async move {
            pace.begin(0.0..0.5);
            pace.after(1).await;
            pace.tell(0.5);
            pace.after(1).await;
            pace.begin(0.5..1.0);
            pace.tell(1.0);
        });
        let mut told = Vec::new();
        while steps.step().is_none() {
            told.push(steps.part());
        }
        told.push(steps.part());
        assert_eq!(told, [0.0, 0.25, 1.0]);
    }
    #[test]
    fn work_within_a_share_tells_of_its_own_whole_and_leaves_the_rest_to_others() {
        let mut steps = Steps::new(1, |pace| async move {
            pace.begin(0.0..0.2);
            pace.after(1).await;
            let part = async {
                pace.begin(0.5..1.0);
                pace.after(1).await;
                pace.tell(0.5);
                pace.after(1).await;
            };
            pace.within(0.2..0.6, part).await;
            pace.after(1).await;
            pace.begin(0.6..1.0);
            pace.tell(0.5);
            pace.after(1).await;
        });
        let mut told = Vec::new();
        while steps.step().is_none() {
            told.push((10.0 * steps.part()).round());
        }
        assert_eq!(told, [0.0, 4.0, 5.0, 6.0, 8.0]);
    }
}
