//! How far a mesh is from that of a character, in numbers, in the panel of the comparison.

use super::mesh_panel::Parts;
use super::panel::{line, of_which, say};
use crate::diagnose::{MeshMeasure, Shown, part_of_size};
use crate::ui::theme::Palette;
use egui::{Button, Grid, RichText, Ui};

impl Parts<'_> {
    /// How far off theirs is, with ways to where it is farthest and to where that shows what is wrong.
    pub(super) fn numbers(&mut self, ui: &mut Ui) {
        let Some(measure) = self.compare.measure else {
            let text = format!(
                "{} has another number of vertices, so that none is known to be one of the exact mesh: \
                 there are no distances.",
                self.compare.name
            );
            return say(ui, &text, Palette::of(ui.visuals()).text);
        };
        let color = Palette::of(ui.visuals()).text;
        Grid::new("distances")
            .num_columns(2)
            .spacing([12.0, 1.0])
            .min_row_height(16.0)
            .show(ui, |ui| {
                for (name, value, hint) in lines(measure) {
                    line(ui, name, &value, color, hint);
                }
            });
        if let Some(vertex) = measure.worst_vertex {
            ui.add_space(4.0);
            let button = ui.button("Show the Worst Vertex");
            let tip = "Move the camera to the vertex that is farthest off, and mark it";
            if button.on_hover_text(tip).clicked() {
                self.go_to(vertex);
            }
        }
        if let Some(first) = self.shown().cloned() {
            self.shown_by(ui, &first, measure.worst_vertex);
        }
    }

    /// Ways to the vertex that shows what is wrong, if that is not the `worst`, and to its formula.
    fn shown_by(&mut self, ui: &mut Ui, first: &Shown, worst: Option<usize>) {
        if worst != Some(first.vertex) {
            let joint = first.joint.as_deref();
            let at = joint.map_or(String::new(), |joint| format!(" at {joint}"));
            let text = format!("Show Vertex {}{at}, the First Much Off", first.vertex);
            let is_marked = self.chosen.marked == Some(first.vertex);
            let button = ui.add(Button::new(text).selected(is_marked).wrap());
            let tip = format!(
                "Move the camera to the worst of the vertices that the first joint, from the root on, moves nearly alone and \
                 much off, and mark it: what the joints below add is not in it\n{first}"
            );
            if button.on_hover_text(tip).clicked() {
                self.go_to(first.vertex);
            }
        }
        if self.chosen.explains {
            return;
        }
        // Another one may be marked.
        let vertex = self.chosen.marked.unwrap_or(first.vertex);
        let formula = ui.button(format!("Show the Formula of Vertex {vertex}"));
        let tip = "Explain how the joints move this vertex, in numbers that follow the pose (K)";
        if formula.on_hover_text(tip).clicked() {
            self.go_to(vertex);
            self.chosen.explains = true;
        }
    }

    /// Where vertices are off, by joints, the worst first: each leads to its worst vertex.
    pub(super) fn regions(&mut self, ui: &mut Ui) {
        let palette = Palette::of(ui.visuals());
        let Some(measure) = self.compare.measure else {
            return;
        };
        if measure.regions.is_empty() {
            if self.compare.problem.is_some() {
                // Not of the file as it is now.
                return;
            }
            return say(ui, "Every vertex is in its place.", palette.text);
        }
        let title = "Vertices off, by the joint that moves them most (distances in % of the size):";
        say(ui, title, palette.weak);
        for region in &measure.regions {
            let is_marked = self.chosen.marked == Some(region.worst_vertex);
            let worst = part_of_size(region.worst);
            let text = RichText::new(format!("{}, by up to {worst}", region.extent())).small();
            let button = ui.add(Button::selectable(is_marked, text).wrap());
            let tip = "Go to its vertex that is farthest off, and mark it";
            if button.on_hover_text(tip).clicked() {
                self.go_to(region.worst_vertex);
            }
        }
    }
}

type Line = (&'static str, String, &'static str);

fn lines(measure: &MeshMeasure) -> [Line; 4] {
    // The numbers in brackets have no room beside more words; the hints say what they are a part of.
    let by_size = |distance: f64| part_of_size(distance / measure.size);
    [
        (
            "Vertices off",
            of_which(measure.off as u64, measure.distances.len() as u64),
            "Vertices that are farther from their place than the meshes agree",
        ),
        (
            "Farthest",
            format!("{} ({:.6})", by_size(measure.worst), measure.worst),
            "The largest distance, by the diagonal of the box around the exact mesh, and as it is",
        ),
        (
            "Mean",
            format!("{} ({:.6})", by_size(measure.mean), measure.mean),
            "The mean distance of all vertices, by the same and as it is",
        ),
        (
            "Agree up to",
            format!("{} ({:.6})", by_size(measure.tolerance), measure.tolerance),
            "What computing in single precision and the digits of the file are off by, by the same and as it is",
        ),
    ]
}
