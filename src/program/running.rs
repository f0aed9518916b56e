use super::autosave::Autosave;
use super::awaited::Awaited;
use super::clipboard::{CopiedPose, PasteInto};
use super::comparison::Comparison;
use super::document_file::DocumentFile;
use super::exports::Exporting;
use super::frame::Pass;
use super::frame_rate::FrameRate;
use super::graphics::GraphicsInfo;
use super::job::Finished;
use super::look_tried::LookTried;
use super::mesh_comparison::MeshComparison;
use super::mesh_marks::MeshMarks;
use super::picture_work::PictureWork;
use super::preferences::Preferences;
use super::questions::Asked;
use super::reading::Readings;
use super::start_pictures::StartPictures;
use super::view_before::ViewBefore;
use super::{FileKind, Host, HostEvent, NotStored, Purpose, globals};
use crate::diagnose::ToldFor;
use crate::editor::{Session, Severity};
use crate::io::builtin::{self, BuiltinKind};
use crate::render::Backdrop;
use crate::revision::Revision;
use crate::scene::{FitArea, Shape, ShapeId, Skinning};
use crate::ui::{self, Screenshot, UiOutput, UiState};
use std::collections::{BTreeMap, BTreeSet, HashMap, VecDeque};
use std::mem::Discriminant;
use std::ops::Range;
use std::path::PathBuf;

/// Options that the program is started with.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Scenes to open and files to import, in order.
    pub files: Vec<PathBuf>,
    /// Title of the window; the one of [`globals`] if `None`.
    pub title: Option<String>,
    /// Way of skinning, in place of the one in the preferences.
    pub skinning: Option<Skinning>,
    /// Whether files were asked for, also if none of them could be had: nothing else is shown in their
    /// place.
    pub asks_for_files: bool,
    /// Whether there is only the scene, to be turned, posed and reset, without panels.
    pub is_viewer: bool,
    /// Whether the machine is made for fingers first of all, as a phone is.
    pub has_fingers_first: bool,
}

impl Options {
    /// Files that the program opens when it is started with these options and what `host` stored: at
    /// the very first start without files it is the showcase, so that there is something to see and
    /// to turn.
    pub fn files_at_start(&self, host: &dyn Host) -> Vec<PathBuf> {
        let is_first = || !Preferences::load(host).is_some_and(|it| it.started_before);
        if self.files.is_empty() && !self.asks_for_files && is_first() {
            vec![PathBuf::from("builtin:showcase")]
        } else {
            self.files.clone()
        }
    }
}

/// The running program, wherever it runs.
pub struct Program {
    pub(super) session: Session,
    pub(super) ui: UiState,
    /// Preferences of the last run, with the folder of this one.
    pub(super) preferences: Preferences,
    /// Preferences as they were stored last.
    pub(super) stored: Preferences,
    /// Files that were chosen last to be written, as long as nobody knows whether they can be.
    pub(super) to_write: BTreeMap<FileKind, PathBuf>,
    /// Purpose of the file that was chosen last, where it was refused, and the numbers of the messages about that.
    pub(super) refused: Option<(Discriminant<Purpose>, Range<u64>)>,
    pub(super) comparison: Option<Comparison>,
    pub(super) mesh_comparison: Option<MeshComparison>,
    pub(super) mesh_marks: MeshMarks,
    /// Pictures that were asked for while a dialog is in the way.
    pub(super) pending_pictures: Vec<(PathBuf, Screenshot)>,
    /// Pictures that are taken at the end of this frame.
    pub(super) due_pictures: Vec<(PathBuf, Screenshot)>,
    /// Pictures that are being drawn, the first of them now.
    pub(super) pictures: VecDeque<PictureWork>,
    /// Number of pictures that are drawn and being made files of.
    pub(super) encoding: usize,
    /// Whether the program ends as soon as all pictures are written.
    pub(super) quitting: bool,
    /// What gets what is on the clipboard, once its text is there.
    pub(super) paste_into: Option<PasteInto>,
    /// The pose that was copied last.
    pub(super) copied_pose: Option<CopiedPose>,
    /// The shape under the pointer when the last frame was drawn.
    pub(super) hovered_shape: Option<ShapeId>,
    pub(super) frame_rate: FrameRate,
    pub(super) graphics: GraphicsInfo,
    /// Title of the window without the document.
    pub(super) program_title: String,
    /// Title that the window has.
    shown_title: String,
    pub(super) document: DocumentFile,
    pub(super) autosave: Autosave,
    /// Whether there is only the scene, without panels.
    pub(super) is_viewer: bool,
    /// Width and height of the window, in points.
    pub(super) window_size: Option<(f32, f32)>,
    /// The same of the last frame, also of a maximized one.
    shown_size: Option<(f32, f32)>,
    /// Document, its file and the one that it is compared with, of which the files are watched.
    pub(super) watched_of: Option<(Revision, Option<PathBuf>, Option<PathBuf>)>,
    /// Files that the host watches.
    pub(super) watched: BTreeSet<PathBuf>,
    /// Files that were written together with one that was chosen, with the CRC-32 of their bytes.
    pub(super) exported: HashMap<PathBuf, u32>,
    /// Those of the write that is under way.
    pub(super) exporting: Option<Exporting>,
    /// Question that waits for its answer.
    pub(super) asked: Option<Asked>,
    /// What waits for files that the host brings.
    pub(super) awaited: Vec<Awaited>,
    /// Files that are read beside the program.
    pub(super) readings: Readings,
    builtin_characters: Vec<&'static str>,
    builtin_curves: Vec<&'static str>,
    builtin_poses: Vec<&'static str>,
    pub(super) start_pictures: StartPictures,
    /// Brightness of what is behind the scene: that of the panels.
    pub(super) backdrop: Backdrop,
    /// The picture of the scene as it was shown last.
    pub(super) fit_area: FitArea,
    /// Whether everything is to be fitted into the picture as soon as its size is known.
    pub(super) fit_due: bool,
    /// Views from before the document was fitted into the picture with what had been added.
    pub(super) views_before: Vec<ViewBefore>,
    /// Whether a document's own view is to suit the picture as soon as its size is known.
    pub(super) own_view_due: bool,
    /// The character of a comparison that has begun, to be seen large as soon as the size of the picture is
    /// known.
    pub(super) closer_due: Option<ShapeId>,
    /// What the look was before others were tried in the document.
    pub(super) look_tried: Option<LookTried>,
    /// Way of skinning in the first frame.
    pub(super) skinning_at_start: Option<Skinning>,
}

impl Program {
    /// A program that shows `session`, with the preferences of a first start and no title.
    pub fn showing(session: Session, graphics: GraphicsInfo) -> Self {
        let document = DocumentFile::untitled(session.document());
        Self {
            session,
            ui: UiState::new(),
            preferences: Preferences::default(),
            stored: Preferences::default(),
            to_write: BTreeMap::new(),
            comparison: None,
            mesh_comparison: None,
            mesh_marks: MeshMarks::default(),
            pending_pictures: Vec::new(),
            due_pictures: Vec::new(),
            pictures: VecDeque::new(),
            encoding: 0,
            quitting: false,
            paste_into: None,
            copied_pose: None,
            look_tried: None,
            hovered_shape: None,
            frame_rate: FrameRate::default(),
            graphics,
            program_title: String::new(),
            shown_title: String::new(),
            document,
            autosave: Autosave::default(),
            is_viewer: false,
            window_size: None,
            shown_size: None,
            watched_of: None,
            watched: BTreeSet::new(),
            exported: HashMap::new(),
            exporting: None,
            asked: None,
            awaited: Vec::new(),
            readings: Readings::default(),
            builtin_characters: builtins(BuiltinKind::Character),
            builtin_curves: builtins(BuiltinKind::Curve),
            builtin_poses: builtins(BuiltinKind::Pose),
            start_pictures: StartPictures::default(),
            backdrop: Backdrop::default(),
            fit_area: FitArea::whole(4.0 / 3.0),
            fit_due: false,
            views_before: Vec::new(),
            own_view_due: false,
            closer_due: None,
            refused: None,
            skinning_at_start: None,
        }
    }

    /// Starts the program with the preferences that `host` stored and the
    /// [`files_at_start`](Options::files_at_start) of `options`.
    pub fn start(options: &Options, graphics: GraphicsInfo, host: &mut dyn Host) -> Self {
        let mut program = Self::showing(Session::new(), graphics);
        program.preferences = Preferences::load(host).unwrap_or_default();
        program.stored = program.preferences.clone();
        program.program_title = options.title.clone().unwrap_or_else(globals::title);
        program.ui.theme = program.preferences.theme;
        program.ui.look_of_new = program.preferences.look;
        program.ui.panel_folded = program.preferences.panel_folded;
        program.ui.reads_aloud = program.preferences.reads_aloud;
        program.ui.panel_width = program.preferences.panel_width;
        if let Some(navigation) = program.preferences.navigation {
            program.ui.set_navigation(navigation);
        }
        program.ui.skinning = options.skinning.or(program.preferences.skinning);
        program.skinning_at_start = program.ui.skinning;

        let is_first = !program.preferences.started_before;
        program.ui.first_help = is_first;
        program.ui.has_fingers_first = options.has_fingers_first;
        program.is_viewer = options.is_viewer;
        if options.is_viewer {
            program.ui.become_viewer();
        }
        program.open_at_start(&options.files_at_start(host), host);
        program.take_events(host);
        program.preferences.started_before = true;
        program.keep_preferences(host);
        program.offer_restoring(host);
        program.show_title(host);
        program
    }

    /// Goes on with other graphics and another context of egui, after those before were lost.
    pub fn replace_graphics(&mut self, graphics: GraphicsInfo) {
        self.graphics = graphics;
        self.ui.replace_context();
        self.start_pictures = StartPictures::default();
        if let Some(comparison) = &mut self.comparison {
            comparison.replace_graphics();
        }
    }

    /// Gives the window the title that it should have.
    pub(super) fn show_title(&mut self, host: &mut dyn Host) {
        let title = self.title();
        if title != self.shown_title {
            host.set_title(&title);
            self.shown_title = title;
        }
    }

    /// The session: document, selection, view and messages.
    pub fn session(&self) -> &Session {
        &self.session
    }

    /// The session, to be changed by a host of its own accord.
    pub fn session_mut(&mut self) -> &mut Session {
        &mut self.session
    }

    /// The panels' state, which hosts may set up before the first frame.
    pub fn ui_mut(&mut self) -> &mut UiState {
        &mut self.ui
    }

    /// Shows the panels in `root`, the `Ui` of the whole window, and carries out the actions of the
    /// user in them and in the view. Needs no OpenGL.
    pub fn show(&mut self, root: &mut egui::Ui, pass: Pass, host: &mut dyn Host) -> Shown {
        let context = root.ctx().clone();
        if pass == Pass::Input {
            self.graphics.max_texture_side = context.input(|input| input.max_texture_side);
            let size = context.content_rect().size();
            let size = (size.x, size.y);
            // To ask an X server in each frame would take as long as its network does.
            if self.shown_size.replace(size) != Some(size) && !host.is_maximized() {
                self.window_size = Some(size);
            }
        }
        if let Some(comparison) = &mut self.comparison {
            comparison.load_textures(&context);
        }
        self.update_mesh_marks();
        self.update_mesh_comparison(host.now());
        let compare_mesh = self.mesh_comparison.as_ref().map(MeshComparison::view);
        let compare = self.comparison.as_ref().and_then(Comparison::view);
        let is_busy = compare.is_some() || self.asked.is_some() || self.is_starting();
        let is_start_page = ui::has_start_page(&self.session, is_busy);
        let drawn_with = (self.backdrop, self.ui.look_of_new);
        self.start_pictures
            .notice(is_start_page, drawn_with, &context);
        let name = self.document_name();
        let question = self.asked.as_ref().map(|asked| asked.question(&name));
        let title = self.title();
        let progress = self
            .picture_progress()
            .or_else(|| self.reading_progress(host.now()))
            .or_else(|| self.awaited_progress(host));
        let input = ui::ViewInput {
            title: &title,
            is_page: host.is_page(),
            is_viewer: self.is_viewer,
            recent: &self.preferences.recent,
            question: question.as_ref(),
            is_starting: self.is_starting(),
            builtin_characters: &self.builtin_characters,
            builtin_curves: &self.builtin_curves,
            builtin_poses: &self.builtin_poses,
            start_pictures: self.start_pictures.shown(),
            hovered_shape: self.hovered_shape,
            frames_per_second: self.frame_rate.shown(),
            backend: &self.graphics.description,
            gesture_under_way: self.ui.gesture_under_way(),
            is_below_dialog: host.is_dialog_open(),
            keys_are_taken: host.is_dialog_open() || pass == Pass::Display,
            compare: compare.as_ref(),
            compare_mesh: compare_mesh.as_ref(),
            legend: match &self.mesh_comparison {
                Some(comparison) => Some(comparison.legend()),
                None => self.mesh_marks.legend(),
            },
            progress: progress.as_ref().map(|(text, part)| (text.as_str(), *part)),
        };
        self.ui.has_file = self.document.path().is_some();
        let mut output = ui::show(root, &self.session, &mut self.ui, &input);
        self.backdrop = match context.theme() {
            egui::Theme::Dark => Backdrop::Dark,
            egui::Theme::Light => Backdrop::Light,
        };
        self.fit_area = output.fit_area(&self.ui);
        let mut fits = std::mem::take(&mut self.fit_due);
        if fits {
            self.fit_added();
        }
        fits |= self.suit_own_view() | self.come_closer();
        if pass == Pass::Input {
            self.hovered_shape = ui::view_gestures(
                &output.view,
                &output.places,
                &self.session,
                &mut self.ui,
                &mut output.actions,
            );
        }
        host.show_dialogs(&context);
        let actions = std::mem::take(&mut output.actions);
        let mut changed = fits | self.carry_out(actions, host);
        changed |= self.take_events(host);
        Shown {
            panels: output,
            changed,
        }
    }

    /// Takes in the events of the host; whether there were any.
    pub(super) fn take_events(&mut self, host: &mut dyn Host) -> bool {
        let mut any = false;
        loop {
            any |= self.take_waiting_events(host);
            if !self.use_read(host) {
                return any;
            }
            any = true;
        }
    }

    fn take_waiting_events(&mut self, host: &mut dyn Host) -> bool {
        let mut any = false;
        let mut dropped = Vec::new();
        while let Some(event) = host.next_event() {
            any = true;
            match event {
                HostEvent::Chosen {
                    request,
                    path,
                    others,
                    files,
                } => {
                    self.remember_chosen(request.purpose, &path);
                    if request.purpose.shape().is_some()
                        && self.is_from_another_scene(request.opened)
                    {
                        continue;
                    }
                    self.use_chosen(request.purpose, (path, others), files, host);
                }
                HostEvent::Dropped { path, files } => dropped.push((path, files)),
                HostEvent::StoreFailed(NotStored { error, kept_in }) => {
                    let error = error.to_string();
                    self.tell_store_failure(&error, kept_in.as_deref(), host.now());
                }
                HostEvent::Unreadable(error) => self.tell(Severity::Error, error.to_string()),
                HostEvent::Brought(result) => self.take_brought(result, host),
                HostEvent::Changed(path) => self.notice_change(&path, host),
                HostEvent::CloseRequested => self.ui.close(),
                HostEvent::Written { path, result } => self.written(&path, result, host),
                HostEvent::Pasted(text) => self.paste(&text, host),
                HostEvent::Finished(result) => match result.0 {
                    Finished::Compared(result) => {
                        if let Some(comparison) = &mut self.comparison {
                            comparison.take_result(result);
                        }
                    }
                    Finished::Diagnosed(result) => {
                        if let Some(comparison) = &mut self.mesh_comparison {
                            let shape = self.session.scene().shape(comparison.shape);
                            let file = shape.and_then(Shape::source_file);
                            comparison.take_result(*result, ToldFor::of_file(file));
                        }
                    }
                    Finished::Read { of, read } => self.take_read(of, read),
                    Finished::Encoded { path, bytes } => self.take_encoded(&path, bytes, host),
                    Finished::GivenUp => {}
                },
            }
        }
        self.use_all_dropped(dropped, host);
        any
    }
}

/// Result of showing the panels once.
pub struct Shown {
    /// Where the panels left room for the view.
    pub panels: UiOutput,
    /// Whether anything was carried out or came in.
    pub changed: bool,
}

fn builtins(kind: BuiltinKind) -> Vec<&'static str> {
    builtin::catalogue()
        .into_iter()
        .filter(|builtin| builtin.kind == kind)
        .map(|builtin| builtin.name)
        .collect()
}
