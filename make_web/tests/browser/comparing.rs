//! Comparing with a picture, while the page goes on.

use super::browser::{Browser, ENTER, ESC, F8, F12};

/// Notes when the browser begins a frame, and each time in which it could neither draw nor take what the
/// user does: between two tasks that follow each other as closely as it lets them.
const WATCH: &str = "
    window.frames = [], window.held = [];
    const frame = (now) => { frames.push(now); requestAnimationFrame(frame); };
    requestAnimationFrame(frame);
    let last = performance.now();
    const task = () => {
        const now = performance.now();
        held.push([last, now]);
        last = now;
        setTimeout(task, 0);
    };
    setTimeout(task, 0);";

/// Notes of each step of reading a picture back from the graphics card whether it can be done at once. It
/// can if the card copies the picture into a buffer, and if that is read when it is known to be there.
const READS: &str = "
    window.reads = [];
    let drawn = false;
    const methods = WebGL2RenderingContext.prototype;
    const { clientWaitSync, getBufferSubData, readPixels } = methods;
    methods.clientWaitSync = function (...given) {
        const status = clientWaitSync.apply(this, given);
        drawn = status !== this.TIMEOUT_EXPIRED;
        return status;
    };
    methods.readPixels = function (...given) {
        reads.push(['copied', typeof given[6] === 'number']);
        drawn = false;
        return readPixels.apply(this, given);
    };
    methods.getBufferSubData = function (...given) {
        reads.push(['read', drawn]);
        return getBufferSubData.apply(this, given);
    };";

/// The longest time, in milliseconds, for which the page stood still between the moment `chosen` and
/// the first of the jobs after the first `before` of them.
const CHOOSING: &str = "
    const [job] = performance.getEntriesByName('editor-job', 'measure').slice(before);
    const inside = held.filter(([from, to]) => to > chosen && from < job.startTime);
    return Math.max(...inside.map(([from, to]) => to - from));";

/// The longest of the jobs after the first `before` of them: its time in milliseconds, the longest time
/// within it for which the page stood still, and the number of frames that began within it.
const LONGEST: &str = "
    const jobs = performance.getEntriesByName('editor-job', 'measure').slice(before);
    jobs.sort((a, b) => b.duration - a.duration);
    const [begun, ended] = [jobs[0].startTime, jobs[0].startTime + jobs[0].duration];
    const inside = held.filter(([from, to]) => to > begun && from < ended);
    const longest = Math.max(...inside.map(([from, to]) => to - from));
    const drawn = frames.filter((time) => begun < time && time < ended);
    return [jobs[0].duration, longest, drawn.length];";

/// Number of jobs that have ended.
pub fn jobs(browser: &Browser) -> u64 {
    let ended =
        browser.script("return performance.getEntriesByName('editor-job', 'measure').length");
    ended.as_u64().unwrap()
}

#[test]
fn the_page_goes_on_while_a_picture_is_compared_with_the_view() {
    let browser = Browser::open();
    browser.press(&[F12]);
    browser.picture();
    browser.press(&[ENTER]);
    let picture = browser.downloaded("showcase.png");
    let file = tempfile::Builder::new().suffix(".png").tempfile().unwrap();
    std::fs::write(file.path(), picture).unwrap();
    // What differs is sought for longer than what does not.
    browser.drag((700, 650), (760, 650));
    browser.picture();
    browser.script(WATCH);
    browser.script(READS);
    let before = jobs(&browser);
    browser.press(&[F8]);
    let chosen = browser.script("return performance.now()");
    browser.choose(&[file.path().to_owned()]);
    let of_longest = || {
        let numbers = browser.script(&format!("const before = {before}; {LONGEST}"));
        [0, 1, 2].map(|index| numbers[index].as_f64().unwrap())
    };
    // The differences with hard edges and with smooth ones, and the cause.
    browser.wait("the pictures are compared", || {
        jobs(&browser) >= before + 3 && of_longest()[2] >= 10.0
    });
    let choosing = format!("const before = {before}, chosen = {chosen}; {CHOOSING}");
    let choosing = browser.script(&choosing).as_f64().unwrap();
    eprintln!("the longest stop until both pictures are there {choosing:.0} ms");
    let reads = browser.script("return reads");
    let reads = reads.as_array().unwrap();
    let at_once = reads.iter().all(|read| read[1] == true);
    assert!(
        reads.len() >= 4 && at_once,
        "the page waits for the graphics card: {reads:?}"
    );
    let [whole, longest, frames] = of_longest();
    eprintln!("compared in {whole:.0} ms with {frames} frames, the longest stop {longest:.0} ms");
    assert!(
        longest < whole / 5.0,
        "{longest} of {whole} ms in one piece"
    );
    browser.press(&[ESC]);
    browser.finish();
}
