//! How much work a call takes, for inputs that could make one take for ever: in time of the
//! processor on the test's own thread, which other programs on a busy machine do not lengthen.

use cpu_time::ThreadTime;
use std::time::Duration;

/// What `run` returns, and the time of the processor that it took.
pub fn work<T>(run: impl FnOnce() -> T) -> (T, Duration) {
    let start = ThreadTime::now();
    let result = run();
    (result, start.elapsed())
}

/// Holds the work of `run` to being in proportion to the size of its input: for eight times as
/// much it takes eight times as long, where work that grows with the square takes 64 times.
///
/// `input` makes what is worked on from its size.
#[track_caller]
pub fn grows_in_proportion<T>(size: usize, input: impl Fn(usize) -> T, run: impl Fn(T)) {
    const LARGER: usize = 8;
    let least = |size: usize| {
        let times = (0..3).map(|_| {
            let input = input(size);
            work(|| run(input)).1
        });
        times.min().unwrap_or_default()
    };
    let (little, much) = (least(size), least(LARGER * size));
    let times = much.as_secs_f64() / little.as_secs_f64();
    assert!(
        times < 24.0,
        "{LARGER} times the input took {times:.0} times the work: {little:?} and {much:?}"
    );
}

#[test]
#[should_panic(expected = "times the work")]
fn work_that_grows_with_the_square_is_seen() {
    let all_pairs = |size: usize| {
        let pairs = (0..size).flat_map(|a| (0..size).map(move |b| a ^ b));
        std::hint::black_box(pairs.map(std::hint::black_box).max());
    };
    grows_in_proportion(300, |size| size, all_pairs);
}
