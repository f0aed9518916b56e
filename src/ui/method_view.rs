//! Both methods of skinning in one view, blended or side by side. All of it is a view: the document
//! knows nothing of it.

use super::swipe_line;
use super::theme::Palette;
use super::widgets::{named, titled_choice};
use crate::editor::Session;
use crate::revision::Revision;
use crate::scene::{Evaluated, EvaluatedGeometry, ShapeId};
use egui::{Align2, Label, Rect, RichText, Slider, Ui, vec2};
use std::sync::Arc;

/// By which method characters are shown in the view.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum MethodView {
    /// Each by its own.
    #[default]
    Own,
    /// All of them between both methods.
    Blend,
    /// All of them by linear blending at the left of a line, by dual quaternions at its right.
    Split,
}

/// The scene as the view shows it where that is not what is in the document.
#[derive(Clone, Debug)]
pub struct ShownScene {
    /// All of it, or what is at the left of a line.
    pub evaluated: Evaluated,
    /// What is at the right of the line, and where that stands, 0 (left) to 1.
    pub right: Option<(Evaluated, f32)>,
}

/// State of the view of both methods.
#[derive(Clone, Debug)]
pub(super) struct MethodViewState {
    view: MethodView,
    /// Share of dual quaternions in a blend.
    share: f32,
    /// Where the line stands, 0 (left) to 1.
    line: f32,
    /// Characters between the methods, as they were shown last.
    kept: Vec<Between>,
}

impl Default for MethodViewState {
    fn default() -> Self {
        Self {
            view: MethodView::Own,
            share: 0.5,
            line: 0.5,
            kept: Vec::new(),
        }
    }
}

/// A character between the methods.
#[derive(Clone, Debug)]
struct Between {
    /// Revision of the character as the document has it.
    exact: Revision,
    share: f32,
    geometry: Arc<EvaluatedGeometry>,
}

impl MethodViewState {
    /// Shows characters by their own methods again.
    pub(super) fn end(&mut self) {
        (self.view, self.kept) = (MethodView::Own, Vec::new());
    }

    /// The scene as the view shows it; `None` while characters are shown by their own methods.
    pub(super) fn shown(&mut self, session: &Session) -> Option<ShownScene> {
        let shares = match self.view {
            MethodView::Own => return None,
            MethodView::Blend => vec![self.share],
            MethodView::Split => vec![0.0, 1.0],
        };
        let known = std::mem::take(&mut self.kept);
        let mut scenes = shares.into_iter().map(|share| {
            let mut evaluated = session.evaluated().clone();
            for shape in &mut evaluated.shapes {
                let exact = shape.geometry.revision;
                let same = |one: &&Between| one.exact == exact && one.share == share;
                let kept = known.iter().find(same).cloned().or_else(|| {
                    let geometry = Arc::new(shape.geometry.between_methods(share)?);
                    Some(Between {
                        exact,
                        share,
                        geometry,
                    })
                });
                if let Some(kept) = kept {
                    shape.geometry = Arc::clone(&kept.geometry);
                    self.kept.push(kept);
                }
            }
            evaluated
        });
        let evaluated = scenes.next()?;
        let right = scenes.next();
        drop(scenes);
        Some(ShownScene {
            evaluated,
            right: right.map(|right| (right, self.line)),
        })
    }

    /// What is left of the volume of a character as it is shown, in words; empty if it is shown by its own
    /// method or not closed.
    fn volumes(&self, session: &Session, id: ShapeId) -> Vec<String> {
        let Some(shape) = session.evaluated().shape(id) else {
            return Vec::new();
        };
        let exact = shape.geometry.revision;
        let own = self.kept.iter().filter(|one| one.exact == exact);
        own.filter_map(|one| {
            let name = match self.view {
                MethodView::Own => return None,
                MethodView::Blend => "Blend",
                MethodView::Split if one.share == 0.0 => LINEAR,
                MethodView::Split => DUAL,
            };
            let kept = one.geometry.volume_kept()?;
            Some(format!("{name}: volume {:.1} %", kept * 100.0))
        })
        .collect()
    }
}

const LINEAR: &str = "Linear blend";
const DUAL: &str = "Dual quaternions";

/// The choice of how the view shows the methods, below that of the character `id`.
pub(super) fn choice(ui: &mut Ui, session: &Session, id: ShapeId, state: &mut MethodViewState) {
    let views = [
        (
            MethodView::Own,
            "Off",
            "Show each character by its own method",
        ),
        (
            MethodView::Blend,
            "Blend",
            "Show all characters between both methods, in the view alone",
        ),
        (
            MethodView::Split,
            "Split",
            "Show linear blending at the left of a line that you drag and dual quaternions at its right, in \
             the view alone",
        ),
    ];
    titled_choice(ui, "Compare Methods", &mut state.view, &views);
    if state.view == MethodView::Blend {
        let slider = Slider::new(&mut state.share, 0.0..=1.0).show_value(false);
        named(ui.add(slider), "Share of dual quaternions")
            .on_hover_text("From linear blending (left) to dual quaternions (right)");
    }
    for volume in state.volumes(session, id) {
        ui.add(Label::new(volume).truncate());
    }
}

/// Shows over the view, below the tools, which method is seen where.
pub(super) fn over_view(
    ui: &mut Ui,
    (view, below_tools): (Rect, f32),
    state: &mut MethodViewState,
) {
    let top = view.top() + below_tools;
    match state.view {
        MethodView::Own => {}
        MethodView::Blend => {
            let percent = (state.share * 100.0).round();
            let text = format!("Blend: {percent} % {}", DUAL.to_lowercase());
            let middle = egui::pos2(view.center().x, top);
            let size = vec2(208.0, SIZE.y);
            label(ui, Align2::CENTER_TOP.anchor_size(middle, size), &text);
        }
        MethodView::Split => {
            swipe_line::show(ui, view, &mut state.line);
            let x = swipe_line::x(ui, view, state.line);
            for (anchor, x, text) in [
                (Align2::RIGHT_TOP, x - 8.0, LINEAR),
                (Align2::LEFT_TOP, x + 8.0, DUAL),
            ] {
                let place = anchor.anchor_size(egui::pos2(x, top), SIZE);
                label(ui, place, text);
            }
        }
    }
}

/// Size of a label in the view, in points.
const SIZE: egui::Vec2 = vec2(152.0, 20.0);

fn label(ui: &mut Ui, place: Rect, text: &str) {
    let palette = Palette::of(ui.visuals());
    ui.painter().rect_filled(place, 4, palette.panel);
    let text = RichText::new(text).small().color(palette.text);
    ui.put(place, Label::new(text).selectable(false).truncate());
}
