//! The actions of panels, menus, keys and gestures, carried out.

use super::clipboard::{Pasted, Sides};
use super::document::Next;
use super::files::file_stem;
use super::running::Program;
use super::{Host, Purpose};
use crate::editor::{Edit, Severity, View};
use crate::io::builtin;
use crate::revision::Revision;
use crate::scene::ViewSettings;
use crate::ui::{Action, Ask, CompareAction, GestureStep, HistoryMove};
use std::path::Path;

const DARK_FROM_HERE: &str = "The Course look has one light, from +Z, so that shapes are dark from this side: \
                              View ⏵ View from ⏵ +Z shows the other, the Studio look lights all";

impl Program {
    /// Carries out the actions of panels, menus, keys and gestures: the one place that does.
    /// Returns whether there is something new to show. A drag that is held still is none.
    pub fn carry_out(&mut self, actions: Vec<Action>, host: &mut dyn Host) -> bool {
        let mut changed = false;
        for action in actions {
            changed |= match action {
                Action::Edit(edit) => self.edit(edit),
                Action::Gesture(step) => {
                    match step {
                        GestureStep::Begin => self.session.begin_gesture(),
                        GestureStep::BeginOnLastStep => {
                            self.session.begin_gesture_on_last_step();
                        }
                        GestureStep::Commit => self.session.commit_gesture(),
                        GestureStep::Cancel => self.session.cancel_gesture(),
                    }
                    true
                }
                Action::History(step) => {
                    match step {
                        HistoryMove::Undo => self.undo(),
                        HistoryMove::Redo => drop(self.session.redo()),
                        HistoryMove::GoTo(done) => self.session.go_to_step(done),
                    }
                    true
                }
                Action::View(view) => {
                    // The look that pictures are compared in is for that time only.
                    if let View::ChooseLook(look) = view
                        && self.comparison.is_none()
                    {
                        self.choose_look_of_new(look);
                        self.ui.follow_look(look);
                        let before = *self.session.view();
                        let view = ViewSettings { look, ..before };
                        if look != before.look && view.looks_against_the_light() {
                            self.tell(Severity::Info, DARK_FROM_HERE.to_owned());
                        }
                    }
                    let view = self.with_compared(view);
                    self.session.look(view);
                    true
                }
                Action::Ask(ask) => {
                    self.answer(ask, host);
                    true
                }
            };
        }
        changed
    }

    /// Edits the document; a refusal becomes a message. Returns whether there is something new to
    /// show.
    pub(super) fn edit(&mut self, edit: Edit) -> bool {
        let kept = match &edit {
            Edit::KeepPose { name, .. } => Some(name.clone()),
            _ => None,
        };
        match self.session.edit(edit) {
            Ok(change) => {
                if !change.added.is_empty() {
                    self.show_added(&change.added, None);
                }
                if let Some(name) = kept.filter(|_| !change.is_nothing()) {
                    self.tell(Severity::Info, format!("Kept the pose as {name}"));
                }
                !change.is_nothing()
            }
            Err(refused) => {
                self.tell(Severity::Error, refused.to_string());
                true
            }
        }
    }

    /// Whether an answer is about a scene that another has taken the place of; a message says so.
    pub(super) fn is_from_another_scene(&mut self, opened: Revision) -> bool {
        let is_late = opened != self.session.opened();
        if is_late {
            let text = "Nothing was done: another scene has been opened in the meantime";
            self.tell(Severity::Warning, text);
        }
        is_late
    }

    pub(super) fn tell(&mut self, severity: Severity, text: impl Into<String>) {
        self.session.messages.tell(severity, text);
    }

    fn answer(&mut self, ask: Ask, host: &mut dyn Host) {
        match ask {
            Ask::ImportShape => self.choose_file(Purpose::ImportShape, "", host),
            Ask::ImportCharacter => self.choose_file(Purpose::ImportCharacter, "", host),
            Ask::ImportCurve => self.choose_file(Purpose::ImportCurve, "", host),
            Ask::ExportCurve(id) => {
                let shape = self.session.scene().shape(id);
                let stem = file_stem(shape.map_or("curve", |shape| &shape.name));
                self.choose_file(Purpose::ExportCurve(id), &format!("{stem}.swp"), host);
            }
            Ask::ExportGeometry => {
                let name = format!("{}.obj", self.free_stem(self.document_stem(), "posed"));
                self.choose_file(Purpose::ExportGeometry, &name, host);
            }
            Ask::Screenshot(shot) => {
                let stem = self.document_stem();
                let name = if shot.turntable.is_some() {
                    format!("{stem}-turntable.gif")
                } else {
                    format!("{stem}.png")
                };
                self.choose_file(Purpose::SaveScreenshot(shot), &name, host);
            }
            Ask::CancelWork => {
                self.cancel_pictures();
                self.stop_waiting(host);
                self.cancel_reading(host);
            }
            Ask::ExportSelected => {
                let mut selected = self.session.selected_shapes();
                let stem = match (selected.next(), selected.next()) {
                    (Some(shape), None) => file_stem(&shape.name),
                    _ => self.document_stem(),
                };
                let name = format!("{}.obj", self.free_stem(stem, "posed"));
                self.choose_file(Purpose::ExportSelected, &name, host);
            }
            Ask::ExportMaterials => {
                let name = format!("{}.obj", self.free_stem(self.document_stem(), "posed"));
                self.choose_file(Purpose::ExportMaterials, &name, host);
            }
            Ask::ExportCharacter(id) => {
                let shape = self.session.scene().shape(id);
                let stem = file_stem(shape.map_or("character", |shape| &shape.name));
                let name = format!("{}.skel", self.free_stem(stem, "copy"));
                self.choose_file(Purpose::ExportCharacter(id), &name, host);
            }
            Ask::SavePose(shape, kept) => {
                let name = self.name_of_pose(shape, kept);
                self.choose_file(
                    Purpose::SavePose(shape, kept),
                    &format!("{name}.json"),
                    host,
                );
            }
            Ask::LoadPose(shape) => self.choose_file(Purpose::LoadPose(shape), "", host),
            Ask::UseBuiltinPose(shape, name) => {
                let path = format!("{}poses/{name}.json", builtin::PREFIX);
                self.load_pose(shape, Path::new(&path), &*host.files());
            }
            Ask::InsertBuiltin(name) => {
                self.import_any(Path::new(&format!("builtin:{name}")), &host.files(), host);
            }
            Ask::New => self.leave_for(Next::New, host),
            Ask::Open => self.leave_for(Next::Open, host),
            Ask::OpenRecent(path) => {
                let to_open = self.to_open(vec![path], host.files());
                self.leave_for(Next::OpenFiles(to_open), host);
            }
            Ask::OpenBuiltin(name) => self.leave_for(Next::OpenBuiltin(name), host),
            Ask::Save => self.save(None, host),
            Ask::SaveAs => self.save_as(None, host),
            Ask::SaveWithFiles => {
                let name = format!("{}.zip", self.document_stem());
                self.choose_file(Purpose::SaveWithFiles, &name, host);
            }
            Ask::CopyLink => self.copy_link(host),
            Ask::Revert => self.revert(host),
            Ask::Reload => self.reload(host),
            Ask::FindSource(shape) => self.find_source(shape, host),
            Ask::Answer(answer) => self.take_answer(answer, host),
            Ask::CopyShapes => drop(self.copy_shapes("Copied", host)),
            Ask::CutShapes => self.cut_shapes(host),
            Ask::Paste => {
                let shape = self.session.selected();
                self.ask_for_clipboard(shape, Pasted::whole(Sides::AsTheyAre), host);
            }
            Ask::CopyPose { shape, joints } => self.copy_pose(shape, joints, host),
            Ask::PastePose(shape) => self.ask_for_pose(shape, Sides::AsTheyAre, host),
            Ask::PastePoseMirrored(shape) => self.ask_for_pose(shape, Sides::Exchanged, host),
            Ask::PastePoseOnto {
                shape,
                joints,
                mirrored,
            } => {
                let joints = Some(joints);
                let sides = match mirrored {
                    true => Sides::Exchanged,
                    false => Sides::AsTheyAre,
                };
                let pasted = Pasted {
                    joints,
                    ..Pasted::whole(sides)
                };
                self.ask_for_clipboard(Some(shape), pasted, host);
            }
            Ask::Compare(action) => self.compare(action, host),
            Ask::CompareMesh(action) => self.compare_mesh(action, host),
            Ask::Quit => self.leave_for(Next::Quit, host),
        }
    }

    fn compare(&mut self, action: CompareAction, host: &mut dyn Host) {
        match action {
            CompareAction::Choose => self.choose_file(Purpose::Compare, "", host),
            CompareAction::Save => {
                let name = format!("{}-comparison.png", self.document_stem());
                self.choose_file(Purpose::SaveComparison, &name, host);
            }
            CompareAction::Close => self.end_comparison(),
            CompareAction::Set(settings) => {
                if let Some(comparison) = &mut self.comparison {
                    comparison.set(settings, host.now());
                }
            }
        }
    }
}
