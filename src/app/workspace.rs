use super::application::{AppError, Options, Wake};
use super::compare::Comparison;
use super::exports::file_stem;
use super::file_dialogs::{FileDialogs, Purpose};
use super::frame::FramePictures;
use super::frame_rate::FrameRate;
use super::globals;
use super::preferences::Preferences;
use crate::editor::{Session, apply_edit, apply_view};
use crate::gpu::WindowContext;
use crate::io::builtin::{self, BuiltinKind};
use crate::render::{InterfacePainter, Renderer};
use crate::scene::{ShapeId, Skinning};
use crate::ui::{self, Action, Ask, UiState};
use std::path::{Path, PathBuf};
use std::time::Duration;
use winit::dpi::{LogicalSize, PhysicalSize};
use winit::event::WindowEvent;
use winit::event_loop::{ActiveEventLoop, EventLoopProxy};
use winit::window::Window;

/// Everything that exists while the window is open.
///
/// Fields are dropped in this order: what was made with OpenGL before its context.
pub(super) struct Workspace {
    pub(super) pictures: FramePictures,
    pub(super) comparison: Option<Comparison>,
    pub(super) renderer: Renderer,
    pub(super) painter: InterfacePainter,
    pub(super) window: WindowContext,
    pub(super) egui: egui_winit::State,
    pub(super) session: Session,
    pub(super) ui: UiState,
    pub(super) dialogs: FileDialogs,
    pub(super) preferences: Preferences,
    /// A picture with panels is taken once the dialogs that asked for it are gone.
    pub(super) pending_screenshot: Option<PathBuf>,
    /// The shape under the pointer when the last frame was drawn.
    pub(super) hovered_shape: Option<ShapeId>,
    pub(super) title: String,
    /// What draws, for the status line.
    pub(super) backend: String,
    pub(super) builtin_characters: Vec<&'static str>,
    pub(super) builtin_curves: Vec<&'static str>,
    pub(super) proxy: EventLoopProxy<Wake>,
    pub(super) frame_rate: FrameRate,
    /// What deformed characters in the first frame.
    skinning_at_start: Option<Skinning>,
    quit: bool,
}

impl Workspace {
    pub fn new(
        event_loop: &ActiveEventLoop,
        proxy: &EventLoopProxy<Wake>,
        options: &Options,
    ) -> Result<Self, AppError> {
        let (width, height) = globals::WINDOW_SIZE;
        let (least_width, least_height) = ui::LEAST_SIZE;
        let title = options.title.clone().unwrap_or_else(globals::title);
        let attributes = Window::default_attributes()
            .with_title(&title)
            .with_inner_size(LogicalSize::new(width, height))
            .with_min_inner_size(LogicalSize::new(least_width, least_height))
            // Accessibility must be set up before the window is first shown.
            .with_visible(false);
        let window = WindowContext::new(event_loop, attributes)?;
        let renderer = Renderer::new(window.gl())?;
        let painter = InterfacePainter::new(window.gl())?;
        let context = egui::Context::default();
        let mut egui = egui_winit::State::new(
            context,
            egui::ViewportId::ROOT,
            event_loop,
            Some(window.window().scale_factor() as f32),
            event_loop.system_theme(),
            Some(painter.max_texture_side()),
        );
        egui.init_accesskit(event_loop, window.window(), proxy.clone());

        let info = window.gl().info();
        let backend = format!("OpenGL {} · {}", info.version, info.renderer);
        let preferences = Preferences::load();
        let mut workspace = Self {
            pictures: FramePictures::default(),
            comparison: None,
            renderer,
            painter,
            window,
            egui,
            session: Session::new(),
            ui: UiState::new(),
            dialogs: FileDialogs::new(),
            preferences,
            pending_screenshot: None,
            hovered_shape: None,
            title,
            backend,
            builtin_characters: builtins(BuiltinKind::Character),
            builtin_curves: builtins(BuiltinKind::Curve),
            proxy: proxy.clone(),
            frame_rate: FrameRate::default(),
            skinning_at_start: None,
            quit: false,
        };
        workspace.ui.theme = workspace.preferences.theme;
        workspace
            .ui
            .set_navigation(workspace.preferences.navigation);
        workspace.ui.skinning = options.skinning.or(workspace.preferences.skinning);
        workspace.skinning_at_start = workspace.ui.skinning;
        workspace.open_first_files(&options.files);
        workspace.preferences.started_before = true;
        workspace.window.window().set_visible(true);
        Ok(workspace)
    }

    /// What was asked for; at the very first start the showcase, so that there is something to
    /// see and to turn.
    fn open_first_files(&mut self, files: &[PathBuf]) {
        self.ui.first_help = !self.preferences.started_before;
        if files.is_empty() && !self.preferences.started_before {
            self.open_at_start(&[PathBuf::from("builtin:showcase")]);
        } else {
            self.open_at_start(files);
        }
    }

    pub fn request_redraw(&self) {
        self.window.window().request_redraw();
    }

    pub fn wants_to_quit(&self) -> bool {
        self.quit
    }

    pub fn resize(&self, size: PhysicalSize<u32>) {
        self.window.resize(size.width, size.height);
    }

    /// Hands an event to the panels; whether they want to be drawn again.
    pub fn on_window_event(&mut self, event: &WindowEvent) -> bool {
        if let WindowEvent::DroppedFile(path) = event {
            self.use_dropped(path);
        }
        self.egui
            .on_window_event(self.window.window(), event)
            .repaint
    }

    pub fn on_accessibility(&mut self, event: egui_winit::accesskit_winit::Event) {
        use egui_winit::accesskit_winit::WindowEvent;
        match event.window_event {
            WindowEvent::InitialTreeRequested => self.egui.egui_ctx().enable_accesskit(),
            WindowEvent::ActionRequested(request) => {
                self.egui.on_accesskit_action_request(request);
            }
            WindowEvent::AccessibilityDeactivated => self.egui.egui_ctx().disable_accesskit(),
        }
    }

    /// Draws one frame and does what its panels asked for. Returns how long nothing needs to be
    /// drawn unless an event comes.
    pub fn redraw(&mut self) -> Result<Duration, AppError> {
        let size = self.window.window().inner_size();
        if size.width == 0 || size.height == 0 {
            return Ok(Duration::MAX);
        }
        self.draw_frame(size)
    }

    /// Does what panels, menus, keys and gestures asked for.
    pub(super) fn carry_out(&mut self, actions: Vec<Action>) {
        for action in actions {
            match action {
                Action::Edit(edit) => apply_edit(&mut self.session, edit),
                Action::View(view) => apply_view(&mut self.session, view),
                Action::Ask(ask) => self.answer(ask),
            }
        }
    }

    fn answer(&mut self, ask: Ask) {
        let folder = self.preferences.last_folder.as_deref();
        match ask {
            Ask::ImportShape => self.dialogs.open(Purpose::ImportShape, folder),
            Ask::ImportCharacter => self.dialogs.open(Purpose::ImportCharacter, folder),
            Ask::ImportCurve => self.dialogs.open(Purpose::ImportCurve, folder),
            Ask::ExportCurve(id) => {
                let shape = self.session.scene().shape(id);
                let stem = file_stem(shape.map_or("curve", |shape| &shape.name));
                let purpose = Purpose::ExportCurve(id);
                self.dialogs
                    .open_to_save(purpose, folder, &format!("{stem}.swp"));
            }
            Ask::ExportGeometry => {
                let purpose = Purpose::ExportGeometry;
                self.dialogs.open_to_save(purpose, folder, "scene.obj");
            }
            Ask::Screenshot(shot) => {
                let purpose = Purpose::SaveScreenshot(shot);
                self.dialogs.open_to_save(purpose, folder, "screenshot.png");
            }
            Ask::InsertBuiltin(name) => self.import_any(Path::new(&format!("builtin:{name}"))),
            Ask::OpenBuiltin(name) => self.open(Path::new(&format!("builtin:{name}"))),
            Ask::CopyPose(shape) => self.copy_pose(shape),
            Ask::PastePose(shape) => self.paste_pose(shape),
            Ask::SavePose(shape, kept) => self.choose_pose_to_save(shape, kept),
            Ask::LoadPose(shape) => self.dialogs.open(Purpose::LoadPose(shape), folder),
            Ask::Compare(action) => self.compare(action),
            Ask::Quit => self.quit = true,
        }
    }

    /// Uses the file chosen in a dialog.
    pub(super) fn use_chosen(&mut self, purpose: Purpose, path: PathBuf) {
        self.preferences.last_folder = path.parent().map(Path::to_owned);
        match purpose {
            Purpose::ImportShape => self.import_shape(&path),
            Purpose::ImportCurve => self.import_curve(&path),
            Purpose::ImportCharacter => self.import_character(&path),
            Purpose::ExportCurve(id) => self.export_curve(id, &path),
            Purpose::ExportGeometry => self.export_geometry(&path),
            Purpose::SaveScreenshot(shot) if shot.with_panels => {
                self.pending_screenshot = Some(path);
            }
            Purpose::SaveScreenshot(shot) => self.save_view(&path, shot),
            Purpose::SavePose(shape, kept) => self.save_pose(shape, kept, &path),
            Purpose::LoadPose(shape) => self.load_pose(shape, &path),
            Purpose::Compare => self.compare_with(&path),
            Purpose::SaveComparison => self.save_comparison(&path),
        }
    }

    pub fn save_preferences(mut self) {
        self.preferences.theme = self.ui.theme;
        self.preferences.navigation = self.ui.navigation;
        // One that was asked for on the command line, and left so, is for that time only.
        if self.ui.skinning != self.skinning_at_start {
            self.preferences.skinning = self.ui.skinning;
        }
        self.preferences.save();
    }
}

fn builtins(kind: BuiltinKind) -> Vec<&'static str> {
    builtin::catalogue()
        .into_iter()
        .filter(|builtin| builtin.kind == kind)
        .map(|builtin| builtin.name)
        .collect()
}
