//! The panel below the view while a character is compared with a mesh.

use super::panel::{label, say};
use super::{CompareMeshAction, CompareMeshView, MeshesShown};
use crate::compare::sentence;
use crate::diagnose::{
    Diagnosis, Mistake, OtherPose, POSE_NOT_APPLIED, Shown, ToldFor, Verdict, of_size,
};
use crate::editor::{Edit, Session, View};
use crate::scene::FitArea;
use crate::ui::below_view::{Heights, below_the_view, columns, has_room_for_columns, scrolled};
use crate::ui::theme::Palette;
use crate::ui::widgets::named;
use crate::ui::{Action, Ask};
use egui::{Align, Button, Label, Layout, RichText, Ui};
use std::path::Path;

/// At the height alone, what is wrong is read without scrolling in a window of 1280 points.
const HEIGHTS: Heights = Heights {
    lowest: 64.0,
    alone: 208.0,
    beside: 0.24,
};

/// Everything that the parts of the panel need.
pub(super) struct Parts<'a> {
    session: &'a Session,
    pub compare: &'a CompareMeshView<'a>,
    area: FitArea,
    pub chosen: &'a mut MeshPanelState,
    actions: &'a mut Vec<Action>,
}

/// What is chosen in the panel.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(in crate::ui) struct MeshPanelState {
    /// The vertex that is marked in the view.
    pub marked: Option<usize>,
    /// Whether the formula of that vertex is explained, in another panel below the view.
    pub explains: bool,
}

const LOAD_POSE: &str = "Load Its Pose…";

/// Most letters of a file's name on a button.
const LONGEST_NAME: usize = 24;

/// The panel; returns what is chosen in it. The camera goes to a vertex that is chosen.
pub(in crate::ui) fn show(
    root: &mut Ui,
    session: &Session,
    compare: &CompareMeshView,
    area: FitArea,
    mut chosen: MeshPanelState,
    actions: &mut Vec<Action>,
) -> MeshPanelState {
    let place = ("compare with a mesh", chosen.explains);
    let mut parts = Parts {
        session,
        compare,
        area,
        chosen: &mut chosen,
        actions,
    };
    below_the_view(root, place, HEIGHTS, |ui| {
        parts.header(ui);
        // What is scrolled is so for one mesh.
        ui.push_id(compare.mesh, |ui| {
            if has_room_for_columns(ui) {
                columns(ui, |number, ui| match number {
                    0 => parts.diagnosis(ui),
                    1 => parts.numbers(ui),
                    _ => parts.regions(ui),
                });
            } else {
                scrolled(ui, |ui| {
                    parts.diagnosis(ui);
                    parts.numbers(ui);
                    parts.regions(ui);
                });
            }
        });
    });
    chosen
}

/// Share of right vertices, of all and of those that the pose moves, above which a mesh is in the pose that it is held against.
const MOSTLY_RIGHT: f64 = 0.5;
/// Said once a pose is taken that others may be as well.
const SHARED_TURN: &str = "Joints in one place share a turn, and this mesh does not tell how. Another mesh may: for that, \
                           load the file of the pose, if there is one";

impl Parts<'_> {
    fn header(&mut self, ui: &mut Ui) {
        ui.with_layout(Layout::right_to_left(Align::Min), |ui| {
            let close = named(ui.add(Button::new("×")), "Stop comparing with the mesh");
            if close
                .on_hover_text("Back to the scene alone (Esc)")
                .clicked()
            {
                self.ask(CompareMeshAction::Close);
            }
            let other = named(ui.add(Button::new("Open…")), "Compare with another mesh");
            if other.on_hover_text("Compare with another mesh").clicked() {
                let selected = self.session.selected();
                let character = selected.filter(|&id| self.session.scene().character(id).is_some());
                let shape = character.unwrap_or(self.compare.shape);
                self.ask(CompareMeshAction::Choose(shape));
            }
            ui.with_layout(
                Layout::left_to_right(Align::Min).with_main_wrap(true),
                |ui| {
                    for shown in MeshesShown::ALL {
                        let is_shown = self.compare.shown == shown;
                        let label = match shown {
                            MeshesShown::Both => "Both".to_owned(),
                            MeshesShown::Ours => "Exact".to_owned(),
                            MeshesShown::Theirs => shortened(self.compare.name),
                        };
                        let button = ui.selectable_label(is_shown, label);
                        let tip = explained(shown, self.compare.name);
                        if button.on_hover_text(tip).clicked() {
                            self.ask(CompareMeshAction::Show(shown));
                        }
                    }
                    let shape = self.session.scene().shape(self.compare.shape);
                    let ours = shape.map_or("", |shape| &shape.name);
                    let theirs = in_its_folder(self.compare.path);
                    let text = format!("{theirs} against the exact {ours}");
                    let color = Palette::of(ui.visuals()).weak;
                    ui.add(Label::new(RichText::new(text).color(color)).truncate())
                        .on_hover_text(format!(
                            "{}: the exact mesh is the character in its pose",
                            self.compare.path.display()
                        ));
                },
            );
        });
    }

    fn ask(&mut self, action: CompareMeshAction) {
        self.actions.push(Action::Ask(Ask::CompareMesh(action)));
    }

    /// Moves the camera to a vertex, and marks it.
    pub(super) fn go_to(&mut self, vertex: usize) {
        self.chosen.marked = Some(vertex);
        if let Some(camera) = self.compare.camera(self.session, vertex, self.area) {
            self.ask(CompareMeshAction::LookFrom(camera));
        }
    }

    /// What is wrong, in words.
    fn diagnosis(&mut self, ui: &mut Ui) {
        let palette = Palette::of(ui.visuals());
        if let Some(problem) = self.compare.problem {
            say(ui, problem, palette.error);
            let text = "The colors and numbers are those of the version before.";
            return say(ui, text, palette.weak);
        }
        if self.compare.is_diagnosing {
            let mut text = "Looking for the mistake…".to_owned();
            if let Some(part) = self.compare.diagnosed_part {
                text += &format!(" {:.0} %", 100.0 * part);
            }
            return say(ui, &text, palette.weak);
        }
        match self.compare.diagnosis {
            None => {}
            Some(Err(error)) => say(ui, &error.to_string(), palette.error),
            Some(Ok(diagnosis)) => self.found(ui, diagnosis),
        }
    }

    fn found(&mut self, ui: &mut Ui, diagnosis: &Diagnosis) {
        let palette = Palette::of(ui.visuals());
        let off = of_size(diagnosis.error);
        if !diagnosis.faces.is_none() {
            let text = format!("In {} {}.", self.compare.name, diagnosis.faces);
            say(ui, &text, palette.warning);
        }
        let lacks_pose = self.lacks_pose(diagnosis);
        if self.is_as_in_file(diagnosis) {
            return self.as_the_file_has_it(ui, diagnosis);
        }
        if lacks_pose {
            // What a student forgets first.
            let text = format!(
                "The character is at rest, but {} seems to be posed: load the pose that it was made in, if it is of \
                 this character.",
                self.compare.name
            );
            say(ui, &text, palette.warning);
            self.load_pose(ui);
        }
        match diagnosis.verdict {
            Verdict::Right | Verdict::Triangles => {
                let what = if diagnosis.is_right() {
                    "Right: this is the exact result"
                } else {
                    "Right but for its triangles: its vertices are the exact result"
                };
                say(ui, &format!("{what} to within {off}."), palette.strong);
                if !diagnosis.unseen.is_empty() {
                    let unseen = diagnosis.unseen.join(", ");
                    let text = format!(
                        "Mistakes that, made in the usual way, would not show here: {unseen}"
                    );
                    let ids = diagnosis.unseen.iter().copied();
                    label(ui, &text, palette.weak).on_hover_text(format!(
                        "{}\n\nA pose that turns joints about several axes shows more.",
                        meanings(ids, diagnosis.told_for)
                    ));
                }
                return;
            }
            Verdict::Explained => {
                for mistake in &diagnosis.mistakes {
                    say(ui, &mistake.to_string(), palette.strong);
                    let text = format!("Section {} · Look at {}", mistake.section, mistake.look_at);
                    say(ui, &text, palette.text);
                }
                let text = format!("That explains {} to within {off}.", self.compare.name);
                say(ui, &text, palette.weak);
                if let Some(pose) = diagnosis.without_joint() {
                    say(ui, &format!("Or {pose}."), palette.text);
                }
                if let Some(coarse) = &diagnosis.coarse {
                    say(ui, &sentence(&coarse.beside_mistakes()), palette.text);
                }
            }
            // Nothing can be said of a mesh in a pose that is not there.
            Verdict::Unexplained if lacks_pose => {}
            Verdict::OtherPose | Verdict::Unexplained => self.unexplained(ui, diagnosis),
        }
        self.same_as(ui, diagnosis);
        if let Some(first) = diagnosis
            .first
            .as_ref()
            .filter(|_| self.compare.measure.is_none())
        {
            say(ui, &format!("Shown by {first}"), palette.text);
        }
    }

    /// Whether the character is at rest, and theirs may be of a pose.
    fn lacks_pose(&self, diagnosis: &Diagnosis) -> bool {
        let character = self.session.scene().character(self.compare.shape);
        let is_at_rest = character.is_some_and(|character| character.pose().is_bind());
        let is_of_pose = match diagnosis.verdict {
            Verdict::Right | Verdict::Triangles | Verdict::OtherPose => true,
            Verdict::Explained | Verdict::Unexplained => false,
        };
        is_at_rest && !is_of_pose && !diagnosis.is_in_one_place()
    }

    /// Whether theirs is the mesh of the character's file, of a character at rest that is not quite so once it is skinned.
    fn is_as_in_file(&self, diagnosis: &Diagnosis) -> bool {
        let is_file = diagnosis.is_as_in_file || diagnosis.together() == [POSE_NOT_APPLIED];
        self.lacks_pose(diagnosis) && is_file
    }

    /// The vertex that shows what is wrong, as far as that is known.
    pub(super) fn shown(&self) -> Option<&Shown> {
        let diagnosis = self.compare.diagnosis?.as_ref().ok()?;
        let is_told = self.compare.problem.is_none() && !self.is_as_in_file(diagnosis);
        diagnosis.first.as_ref().filter(|_| is_told)
    }

    /// What is known of the mesh of the character's file beside the character at rest.
    fn as_the_file_has_it(&mut self, ui: &mut Ui, diagnosis: &Diagnosis) {
        let palette = Palette::of(ui.visuals());
        let name = self.compare.name;
        let text = format!("{name} is the mesh at rest as the character's file has it.");
        say(ui, &text, palette.strong);
        let away = of_size(diagnosis.error_from_exact);
        let text = format!(
            "Skinned, the character is up to {away} from it, as where weights do not sum to 1. Only a pose shows \
             whether a mesh is skinned: load the one that {name} was made in, if there is one."
        );
        say(ui, &text, palette.text);
        self.load_pose(ui);
        self.same_as(ui, diagnosis);
    }

    /// Mistakes that give the same.
    fn same_as(&self, ui: &mut Ui, diagnosis: &Diagnosis) {
        if diagnosis.same_as.is_empty() {
            return;
        }
        let all = diagnosis.same_as.iter().map(|ids| ids.join(" and "));
        let text = format!(
            "Indistinguishable here: {}",
            all.collect::<Vec<_>>().join(", ")
        );
        let others: Vec<_> = diagnosis.others.iter().map(ToString::to_string).collect();
        label(ui, &text, Palette::of(ui.visuals()).weak).on_hover_text(others.join("\n"));
    }

    /// What is known of a mesh that no mistake gives.
    fn unexplained(&mut self, ui: &mut Ui, diagnosis: &Diagnosis) {
        let palette = Palette::of(ui.visuals());
        let found = diagnosis.found();
        if let Some(other) = &diagnosis.other_pose {
            self.other_pose(ui, other, other.but_for(diagnosis.tolerance));
        }
        for (index, finding) in found.iter().enumerate() {
            let is_first = index == 0 && diagnosis.other_pose.is_none();
            let color = if is_first {
                palette.strong
            } else {
                palette.text
            };
            say(ui, &sentence(finding), color);
        }
        if found.is_empty() && diagnosis.other_pose.is_none() {
            let text = "No known mistake gives this mesh in this pose, nor do two of those that are tried \
                        together.";
            say(ui, text, palette.strong);
            let name = self.compare.name;
            if diagnosis.agrees.min(diagnosis.moved_agree) > MOSTLY_RIGHT {
                let percent = (100.0 * diagnosis.agrees).floor();
                let text = format!(
                    "{percent} % of its vertices are right, so {name} is in this pose: what is wrong is at the joints \
                     below."
                );
                say(ui, &text, palette.text);
            } else {
                let text = format!(
                    "Was {name} made from this character, in this pose? If it was made in another pose, load that one."
                );
                say(ui, &text, palette.text);
                self.load_pose(ui);
            }
        }
        if let Some(nearest) = &diagnosis.nearest {
            let text = format!(
                "Nearest: {}; that explains {:.0} % of it",
                nearest.mistake,
                100.0 * nearest.explains
            );
            say(ui, &text, palette.text);
        }
    }

    /// A way to the pose that theirs was made in.
    fn load_pose(&mut self, ui: &mut Ui) {
        let tip = "Choose the pose file that the other program was given";
        if ui.button(LOAD_POSE).on_hover_text(tip).clicked() {
            let load = Ask::LoadPose(self.compare.shape);
            self.actions.push(Action::Ask(load));
        }
    }

    /// In which pose theirs is right, and how to take it.
    fn other_pose(&mut self, ui: &mut Ui, other: &OtherPose, but_for: Option<String>) {
        let palette = Palette::of(ui.visuals());
        let text = match but_for {
            Some(but_for) => format!("{but_for}, this is the exact result of another pose"),
            None => "this is the exact result, but of another pose".to_owned(),
        };
        say(ui, &sentence(&text), palette.strong);
        if let Some(mistake) = &other.besides {
            say(ui, &mistake.to_string(), palette.text);
        }
        let name = self.compare.name;
        let text = format!(
            "If that is the pose that {name} was made in, load it or take it here. If not, the program that \
             made it turns joints otherwise than the pose says:"
        );
        say(ui, &text, palette.text);
        ui.horizontal_wrapped(|ui| {
            let button = ui.button("Take Its Pose");
            let tip =
                format!("Give the character the angles that {name} shows; Undo takes them back");
            if button.on_hover_text(tip).clicked() {
                let edit = Edit::SetPose(self.compare.shape, other.pose.clone());
                self.actions.push(Action::Edit(edit));
                if other.joints.iter().any(|joint| joint.is_ambiguous) {
                    self.actions
                        .push(Action::View(View::Tell(SHARED_TURN.into())));
                }
            }
            self.load_pose(ui);
        });
        let (told, more) = other.told();
        for joint in told {
            say(ui, &joint.to_string(), palette.text);
        }
        if more > 0 {
            say(ui, &format!("… and {more} more joints"), palette.weak);
        }
    }
}

/// What mistakes of these names are, a line each.
fn meanings<'a>(ids: impl Iterator<Item = &'a str>, program: ToldFor) -> String {
    let mistakes = ids.filter_map(Mistake::find);
    let told = mistakes.map(|mistake| mistake.told_for(program).to_string());
    told.collect::<Vec<_>>().join("\n")
}

fn explained(shown: MeshesShown, name: &str) -> String {
    match shown {
        MeshesShown::Both => {
            format!("The exact mesh in the colors of the distances, {name} over it like glass")
        }
        MeshesShown::Ours => "The exact mesh alone, in the colors of the distances".to_owned(),
        MeshesShown::Theirs => format!("{name} alone, in the colors of the distances"),
    }
}

/// A file's name with the folder that it is in: those of a class have one name.
fn in_its_folder(path: &Path) -> String {
    let name = |path: &Path| {
        path.file_name()
            .map(|name| name.to_string_lossy().into_owned())
    };
    let folder = path.parent().and_then(name);
    let names = [folder, name(path)].into_iter().flatten();
    names.collect::<Vec<_>>().join("/")
}

/// A file's name, with its beginning alone if it is long.
fn shortened(name: &str) -> String {
    if name.chars().count() <= LONGEST_NAME {
        return name.to_owned();
    }
    name.chars().take(LONGEST_NAME - 1).chain(['…']).collect()
}
