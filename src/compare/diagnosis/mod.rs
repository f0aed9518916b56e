//! Causes of the differences between two pictures. A finding is reported only where the pictures
//! bear it out pixel by pixel; where no cause explains the differences, there is no finding.

mod axes;
mod color;
mod detail;
mod evidence;
mod finding;
mod finding_words;
mod highlight;
mod lines;
mod moments;
mod outline;
mod placed;
#[cfg(test)]
mod rule_tests;

pub use finding::{Finding, HighlightChange, Which};

use super::Pair;
use super::rules::Beside::{self, Nothing, Only};
use super::rules::{Rule, found_by, without_names};
use crate::steps::{Pace, at_once};
use axes::Axes;
use evidence::Evidence;
use glam::DVec2;
use std::future::ready;
use std::pin::Pin;

impl Pair<'_> {
    /// Causes of the differences, as far as the pictures prove them, the most telling first. Empty
    /// if nothing does, or if the pictures are equal.
    pub fn findings(&self) -> Vec<Finding> {
        at_once(|pace| async move { self.paced_findings(&pace).await })
    }

    /// The same in steps.
    pub(super) async fn paced_findings(&self, pace: &Pace) -> Vec<Finding> {
        without_names(named_findings(self, pace).await)
    }

    /// A's outline found again in B, where all that is drawn is one figure, with the middle of A's.
    pub(super) fn whole_placed(&self) -> Option<(DVec2, Finding)> {
        at_once(|pace| async move {
            let evidence = Evidence::new(self, &pace).await;
            placed::whole_placed(&evidence).await
        })
    }
}

/// Findings with the names of their rules.
async fn named_findings(pair: &Pair<'_>, pace: &Pace) -> Vec<(&'static str, Finding)> {
    let evidence = Evidence::new(pair, pace).await;
    let count = Evidence::RULES.len() as f32;
    found_by(&Evidence::RULES, async |index, applies| {
        pace.tell(index as f32 / count);
        applies(&evidence).await
    })
    .await
}

/// What gives the finding of a rule.
type Applies<E> = for<'e> fn(&'e E) -> Pin<Box<dyn Future<Output = Option<Finding>> + 'e>>;

impl Evidence<'_> {
    /// Every cause, the most telling first:
    ///
    /// 1. nothing is visible: the picture was not drawn, or not saved with its colors;
    /// 2. the picture as a whole is another: mirrored, moved, with other channels or background;
    /// 3. one cause for what is drawn, those that leave less unexplained first: rounding, then
    ///    color, then the finest structures before coarse ones;
    /// 4. what remains to be said without a cause: outlines and colors that differ.
    const RULES: [Rule<Applies<Self>>; 20] = [
        rule("transparent", Nothing, |e| {
            Box::pin(ready(color::transparent(e)))
        }),
        rule("blank", Nothing, |e| Box::pin(color::blank(e))),
        rule("mirrored", Nothing, |e| Box::pin(outline::mirrored(e))),
        rule("shifted", Nothing, |e| Box::pin(outline::shifted(e))),
        rule("opacity", Only(&["mirrored", "shifted"]), |e| {
            Box::pin(color::opacity(e))
        }),
        rule("red_blue_exchanged", Nothing, |e| {
            Box::pin(color::red_blue_exchanged(e))
        }),
        rule("gray", Nothing, |e| Box::pin(color::gray(e))),
        rule("only_background", WHOLE_PICTURE, |e| {
            Box::pin(ready(color::only_background(e)))
        }),
        rule("background", WHOLE_PICTURE, |e| {
            Box::pin(ready(color::background_too(e)))
        }),
        rule("axes", BACKGROUND, |e| Box::pin(ready(axes_if(e, true)))),
        rule("axes_too", BACKGROUND, |e| {
            Box::pin(ready(axes_if(e, false)))
        }),
        rule("nearly_same", BACKGROUND, |e| {
            Box::pin(detail::nearly_same(e))
        }),
        rule("gamma", AXES, |e| Box::pin(color::gamma(e))),
        rule("brightness", AXES, |e| Box::pin(color::brightness(e))),
        rule("highlight", AXES, |e| Box::pin(highlight::highlight(e))),
        rule("edges", AXES, |e| Box::pin(detail::edges(e))),
        rule("detail", AXES, |e| Box::pin(detail::detail(e))),
        rule("placed", AXES, |e| Box::pin(placed::placed(e))),
        rule("outline", AXES, |e| Box::pin(outline::outline(e))),
        rule(
            "shading",
            Only(&["background", "axes_too", "outline"]),
            |e| Box::pin(outline::shading(e)),
        ),
    ];
}

/// Another background is reported beside what concerns the picture as a whole.
const WHOLE_PICTURE: Beside = Only(&[
    "blank",
    "mirrored",
    "shifted",
    "opacity",
    "red_blue_exchanged",
    "gray",
]);
/// Another background hides nothing else that is wrong.
const BACKGROUND: Beside = Only(&["background"]);
/// Nor do axes.
const AXES: Beside = Only(&["background", "axes_too"]);

/// Axes of one picture alone, if they are all that differs or are not, as `alone` says.
fn axes_if(evidence: &Evidence, alone: bool) -> Option<Finding> {
    let axes = evidence.axes().filter(|axes| axes.alone == alone);
    axes.map(Axes::finding)
}

const fn rule<'a>(
    name: &'static str,
    beside: Beside,
    applies: Applies<Evidence<'a>>,
) -> Rule<Applies<Evidence<'a>>> {
    Rule {
        name,
        beside,
        applies,
    }
}
