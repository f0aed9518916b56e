use super::{CompareCounts, CompareJudgment, CompareReport};
use crate::ui::theme::Palette;
use egui::{Grid, Label, RichText, Ui};

/// Shown for what is not known yet.
const UNKNOWN: &str = "…";

/// What was measured: a name, a number, and what it means.
pub(super) fn numbers(ui: &mut Ui, report: &CompareReport) {
    let palette = Palette::of(ui.visuals());
    let judged = report.judgment.as_ref();
    // What belongs to an older picture stands back until it is measured anew.
    let judged_color = if report.measuring {
        palette.weak
    } else {
        palette.text
    };
    Grid::new("numbers")
        .num_columns(2)
        .spacing([12.0, 1.0])
        .min_row_height(16.0)
        .show(ui, |ui| {
            for (name, value, hint) in counted(report.counts.as_ref()) {
                line(ui, name, &value, palette.text, hint);
            }
            for (name, value, hint) in perceived(judged) {
                line(ui, name, &value, judged_color, hint);
            }
        });
}

type Line = (&'static str, String, &'static str);

fn counted(counts: Option<&CompareCounts>) -> [Line; 4] {
    let value = |text: fn(&CompareCounts) -> String| counts.map_or(UNKNOWN.to_owned(), text);
    [
        (
            "Differing pixels",
            value(|c| of_which(c.differing, c.compared)),
            "Pixels of which a channel differs by more than the threshold",
        ),
        (
            "Of the drawn",
            value(|c| of_which(c.drawn_differing, c.drawn)),
            "The same among the pixels that are not background in one of the pictures",
        ),
        (
            "Difference",
            value(|c| format!("at most {}, mean {:.3} of 255", c.max, c.mean)),
            "Of a channel of a pixel",
        ),
        (
            "PSNR",
            value(|c| {
                if c.psnr.is_finite() {
                    format!("{:.2} dB", c.psnr)
                } else {
                    "infinite: no color differs".to_owned()
                }
            }),
            "Peak signal to noise ratio: larger is more alike",
        ),
    ]
}

fn perceived(judgment: Option<&CompareJudgment>) -> [Line; 2] {
    let ssim = match judgment {
        None => UNKNOWN.to_owned(),
        Some(CompareJudgment { ssim: None, .. }) => "needs 11×11 pixels".to_owned(),
        Some(CompareJudgment {
            ssim: Some(ssim), ..
        }) => format!("{ssim:.5}"),
    };
    let flip = judgment.map_or(UNKNOWN.to_owned(), |j| format!("{:.5}", j.flip));
    [
        ("SSIM", ssim, "Structural similarity: 1 if equal"),
        (
            "FLIP",
            flip,
            "The difference that a person sees when the pictures blink: 0 if equal, at most 1",
        ),
    ]
}

/// `37 of 12345 (0.300 %)`.
fn of_which(part: u64, whole: u64) -> String {
    let percent = 100.0 * part as f64 / whole.max(1) as f64;
    format!("{part} of {whole} ({percent:.3} %)")
}

fn line(ui: &mut Ui, name: &str, value: &str, color: egui::Color32, hint: &str) {
    let weak = Palette::of(ui.visuals()).weak;
    ui.label(RichText::new(name).small().color(weak))
        .on_hover_text(hint);
    let value = RichText::new(value).small().color(color);
    ui.add(Label::new(value).selectable(true))
        .on_hover_text(hint);
    ui.end_row();
}

/// What is wrong, in words.
pub(super) fn findings(ui: &mut Ui, report: &CompareReport) {
    let palette = Palette::of(ui.visuals());
    let mut say = |text: &str, color| {
        let text = RichText::new(text).color(color);
        ui.add(Label::new(text).wrap().selectable(true));
    };
    if let Some(problem) = &report.problem {
        return say(problem, palette.error);
    }
    let Some(counts) = &report.counts else {
        return say("Measuring…", palette.weak);
    };
    if counts.max == 0 {
        return say("A and B are equal, pixel by pixel.", palette.strong);
    }
    if counts.differing == 0 {
        say(
            "No pixel differs by more than the threshold.",
            palette.strong,
        );
    }
    match &report.judgment {
        Some(judgment) if !report.measuring => {
            for finding in &judgment.findings {
                say(finding, palette.strong);
            }
            if judgment.findings.is_empty() {
                say("No single cause explains the differences.", palette.text);
            }
        }
        _ => say("Looking for the cause…", palette.weak),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_are_told_with_their_whole_and_never_divide_by_zero() {
        assert_eq!(of_which(3, 1000), "3 of 1000 (0.300 %)");
        assert_eq!(of_which(0, 0), "0 of 0 (0.000 %)");
    }
}
