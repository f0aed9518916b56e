use super::{CompareCounts, CompareJudgment, CompareReport, CompareView};
use crate::ui::CompareSettings;
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
            let (name, value, hint) = perceived(judged);
            line(ui, name, &value, judged_color, hint);
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

fn perceived(judgment: Option<&CompareJudgment>) -> Line {
    let value = match judgment {
        None => UNKNOWN.to_owned(),
        Some(CompareJudgment { ssim, flip, .. }) => match ssim {
            Some(ssim) => format!("{ssim:.5}, {flip:.5}"),
            None => format!("none below 11×11 pixels, {flip:.5}"),
        },
    };
    (
        "SSIM, FLIP",
        value,
        "Structural similarity, 1 if equal; and the difference that a person sees when the pictures blink, 0 if equal",
    )
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
pub(super) fn findings(ui: &mut Ui, look_is_course: bool, compare: &CompareView) {
    let palette = Palette::of(ui.visuals());
    ui.vertical(|ui| {
        let mut say = |text: &str, color| {
            let text = RichText::new(text).color(color);
            ui.add(Label::new(text).wrap().selectable(true));
        };
        let report = compare.report;
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
        for hint in hints(look_is_course, compare.settings, counts) {
            say(hint, palette.text);
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
    });
}

const COVERED: &str = "If A shows the other program's panels, leave them out: Mask its panels.";
const OTHER_LOOK: &str =
    "B has the Studio look. Course look draws it as the course's program does.";
const SMOOTH: &str = "B has smooth edges; the course's program has none.";

/// What the person at the panel can do about differences.
fn hints(
    look_is_course: bool,
    settings: &CompareSettings,
    counts: &CompareCounts,
) -> impl Iterator<Item = &'static str> {
    // Where not even the border has a color of its own, something lies over the scene.
    let covered = settings.masks.is_empty() && counts.drawn == counts.compared;
    [
        (!look_is_course, OTHER_LOOK),
        (look_is_course && settings.smooth_edges, SMOOTH),
        (look_is_course && covered, COVERED),
    ]
    .into_iter()
    .filter_map(|(applies, hint)| applies.then_some(hint))
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
