//! Characters that the graphics card deforms, beside those of the processor.

use super::browser::{Browser, F3, F6, F7, F10, VIEW};
use super::picture::difference;
use image::RgbImage;

/// Counts the shaders that deform characters from now on.
const COUNT: &str = "
    window.skinning = 0;
    const methods = WebGL2RenderingContext.prototype;
    const { shaderSource } = methods;
    methods.shaderSource = function (shader, text) {
        if (text.includes('uniform sampler2D influences')) skinning += 1;
        return shaderSource.call(this, shader, text);
    };";

/// How characters are shown, one way after the other: each has other shaders or other colors.
fn shown_in_all_ways(browser: &Browser) -> [(&'static str, RgbImage); 5] {
    let shown = |way: &'static str, change: &dyn Fn()| {
        change();
        (way, browser.picture())
    };
    let pictures = [
        shown("lit", &|| browser.press(&[F7])),
        shown("flat", &|| browser.press(&[F6])),
        shown("number of influences", &|| browser.command("influences")),
        shown("with the bind pose", &|| browser.command("ghost")),
        shown("colors of normals", &|| {
            browser.command("colors materials");
            browser.press(&[F10]);
        }),
    ];
    browser.command("ghost");
    browser.press(&[F3]);
    pictures
}

#[test]
fn characters_look_the_same_whether_the_graphics_card_or_the_processor_deforms_them() {
    let browser = Browser::open();
    // A man whose mesh has normals, and bends.
    browser.go("?open=builtin:mannequin-5");
    browser.drag((498, 260), (558, 290));
    browser.press(&[F3]);
    browser.picture();
    browser.script(COUNT);
    let counted = || browser.script("return skinning").as_u64().unwrap();
    let by_processor = shown_in_all_ways(&browser);
    assert_eq!(counted(), 0, "the processor, where it is the graphics card");
    browser.command("graphics card");
    let by_card = shown_in_all_ways(&browser);
    assert!(counted() > 0);
    for ((way, processor), (_, card)) in by_processor.iter().zip(&by_card) {
        let off = difference(processor, card, VIEW);
        assert!(off < 0.002, "{way}: {off}");
    }
    for [(_, before), (way, after)] in by_card.array_windows() {
        let changed = difference(before, after, VIEW);
        assert!(changed > 0.005, "{way}: {changed}");
    }
    browser.finish();
}
