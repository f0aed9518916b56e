//! What draws, in the status line: pictures per second, and the version and device of the graphics driver.

use super::ViewInput;
use super::shortened::text_width;
use super::theme::Palette;
use egui::{Label, RichText, TextStyle, Ui};

/// Shows what draws as fully as `room` points hold, or nothing. All of it is in the tooltip.
pub(super) fn show(ui: &mut Ui, input: &ViewInput, room: f32) {
    let whole = with_rate(input, input.backend);
    if whole.is_empty() {
        return;
    }
    let font = TextStyle::Small.resolve(ui.style());
    let weak = Palette::of(ui.visuals()).weak;
    let fits = |text: &String| !text.is_empty() && text_width(ui, text, &font) <= room;
    let short = with_rate(input, &shortened(input.backend));
    let rate = with_rate(input, "");
    let Some(text) = [whole.clone(), short, rate].into_iter().find(fits) else {
        return;
    };
    let label = Label::new(RichText::new(&text).small().color(weak)).extend();
    let label = ui.add(label);
    if text != whole {
        label.on_hover_text(whole);
    }
}

/// `backend` after the number of pictures per second while pictures are drawn.
fn with_rate(input: &ViewInput, backend: &str) -> String {
    let rate = input.frames_per_second.map(|rate| format!("{rate:.0} fps"));
    let parts = rate.into_iter().chain([backend.to_owned()]);
    let parts: Vec<String> = parts.filter(|part| !part.is_empty()).collect();
    parts.join(" · ")
}

/// The version and device of a `backend` such as `OpenGL 4.5 (Core Profile) Mesa 25.0.7 · llvmpipe (LLVM 19.1.7, 256
/// bits)`, without what surrounds them.
fn shortened(backend: &str) -> String {
    let Some((version, renderer)) = backend.split_once(" · ") else {
        return backend.to_owned();
    };
    let words: Vec<&str> = version.split(' ').take(2).collect();
    format!("{} · {}", words.join(" "), device(renderer))
}

/// The device in the name of a renderer. Chrome's has it between a vendor and a driver, as in `ANGLE (Intel, Mesa
/// Intel(R) UHD Graphics 620 (KBL GT2), OpenGL 4.6)`.
fn device(renderer: &str) -> &str {
    let inside = renderer.strip_prefix("ANGLE (");
    let inside = inside.and_then(|inside| inside.strip_suffix(')'));
    let of_angle = inside.and_then(|inside| inside.split_once(", "));
    let device = of_angle.map_or(renderer, |(_, device)| {
        device
            .rsplit_once(", ")
            .map_or(device, |(device, _)| device)
    });
    let device = device.rsplit_once("Renderer: ").map_or(device, |it| it.1);
    // Vulkan's version comes before the device, which is in brackets.
    let of_vulkan = device.strip_prefix("Vulkan ");
    let of_vulkan = of_vulkan.and_then(|device| device.split_once(" ("));
    let device = of_vulkan.map_or(device, |(_, device)| device);
    let ends = [" (", " Direct3D", "/PCIe", " Device"];
    let end = ends.iter().filter_map(|end| device.find(end)).min();
    &device[..end.unwrap_or(device.len())]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_name_of_a_driver_is_shortened_to_its_version_and_device() {
        for (backend, short) in [
            (
                "WebGL 2.0 · ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero) (0x0000C0DE)), SwiftShader driver)",
                "WebGL 2.0 · SwiftShader",
            ),
            (
                "WebGL 2.0 · ANGLE (NVIDIA, NVIDIA GeForce RTX 3080 Direct3D11 vs_5_0 ps_5_0, D3D11)",
                "WebGL 2.0 · NVIDIA GeForce RTX 3080",
            ),
            (
                "WebGL 2.0 · ANGLE (Intel, Mesa Intel(R) UHD Graphics 620 (KBL GT2), OpenGL 4.6)",
                "WebGL 2.0 · Mesa Intel(R) UHD Graphics 620",
            ),
            (
                "WebGL 2.0 · ANGLE (Apple, ANGLE Metal Renderer: Apple M1, Unspecified Version)",
                "WebGL 2.0 · Apple M1",
            ),
            (
                "OpenGL 4.5 (Core Profile) Mesa 25.0.7 · llvmpipe (LLVM 19.1.7, 256 bits)",
                "OpenGL 4.5 · llvmpipe",
            ),
            (
                "OpenGL 4.6.0 NVIDIA 550.54 · NVIDIA H100/PCIe/SSE2",
                "OpenGL 4.6.0 · NVIDIA H100",
            ),
            ("WebGL 2.0 · Mali-G78", "WebGL 2.0 · Mali-G78"),
            ("OpenGL 3.3", "OpenGL 3.3"),
            ("", ""),
        ] {
            assert_eq!(shortened(backend), short);
        }
    }
}
