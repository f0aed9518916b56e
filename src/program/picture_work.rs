//! Pictures that are saved while the window goes on: large ones part by part, turntables picture by
//! picture, one part a frame.

use super::files::file_name;
use super::graphics::Graphics;
use super::job::{Job, Work};
use super::running::Program;
use super::{Host, Previous};
use crate::editor::{Session, Severity};
use crate::geometry::Picture;
use crate::io::image::PictureFormat;
use crate::io::{Animation, Diagnostic};
use crate::render::{
    Backdrop, Background, Frame, LargePicture, Marks, PictureParts, RenderError, check_picture_size,
};
use crate::scene::{
    Evaluated, Scene, ViewSettings, fit_turntable, turntable_cameras, turntable_milliseconds,
};
use crate::ui::Screenshot;
use std::path::{Path, PathBuf};

/// Pixels a side of the parts of large pictures, few enough that the window answers between them.
const TILE: u32 = 1024;
/// Most pixels of a picture that is drawn in one piece.
const ONE_PIECE: u64 = 1 << 22;

/// A picture, or the pictures of a turntable, of the scene as it was when they were asked for.
pub(super) struct PictureWork {
    path: PathBuf,
    format: PictureFormat,
    scene: Scene,
    evaluated: Evaluated,
    backdrop: Backdrop,
    /// Colors and ghosts of meshes.
    marks: Marks,
    /// View of each picture.
    views: Vec<ViewSettings>,
    /// Number of pictures that are complete.
    done: usize,
    asked: LargePicture,
    /// The picture that is being drawn.
    parts: Option<PictureParts>,
    /// The pictures of a turntable so far.
    animation: Option<Animation>,
}

/// Result of drawing a part.
enum Step {
    /// There is more to draw.
    More,
    /// The one picture is complete.
    Picture(Picture),
    /// The turntable is complete: the content of its file.
    Animation(Vec<u8>),
}

impl PictureWork {
    /// A picture of `session` as it is now, in a view of `view_size` pixels.
    ///
    /// # Errors
    /// If the file cannot hold what is asked for.
    fn new(
        path: PathBuf,
        shot: &Screenshot,
        (session, backdrop, marks): (&Session, Backdrop, Marks),
        (view_size, samples): ((u32, u32), u32),
    ) -> Result<Self, Diagnostic> {
        let format = PictureFormat::of(&path)?;
        let size = shot.size.unwrap_or(view_size);
        check(&path, format, shot, size)?;
        let mut view = *session.view();
        let evaluated = session.evaluated().clone();
        let (views, animation) = match shot.turntable {
            None => (vec![view], None),
            Some(turntable) => {
                let frames = turntable.frames;
                if turntable.fit {
                    let bounds = evaluated.world_bounds();
                    let aspect = size.0 as f32 / size.1 as f32;
                    fit_turntable(&mut view.camera, frames, &bounds, aspect);
                }
                let cameras = turntable_cameras(view.camera, frames);
                let views = cameras.map(|camera| ViewSettings { camera, ..view });
                let animation = Animation::new(turntable_milliseconds(frames));
                let failed = |message| Diagnostic::new(&path, message);
                (views.collect(), Some(animation.map_err(failed)?))
            }
        };
        let is_large = u64::from(size.0) * u64::from(size.1) > ONE_PIECE;
        Ok(Self {
            path,
            format,
            scene: session.scene().clone(),
            evaluated,
            backdrop,
            marks,
            views,
            done: 0,
            asked: LargePicture {
                size,
                samples,
                background: if shot.transparent {
                    Background::Transparent
                } else {
                    Background::Look
                },
                tile: is_large.then_some(TILE),
            },
            parts: None,
            animation,
        })
    }

    /// Draws the next part.
    ///
    /// # Errors
    /// If it cannot be drawn, or the file cannot hold it.
    fn step(&mut self, graphics: &mut Graphics) -> Result<Step, PictureError> {
        let Some(view) = self.views.get(self.done) else {
            return Ok(Step::More);
        };
        let frame = Frame {
            scene: &self.scene,
            evaluated: &self.evaluated,
            view,
            backdrop: self.backdrop,
            marks: self.marks.clone(),
        };
        let mut parts = match self.parts.take() {
            Some(parts) => parts,
            None => graphics.picture_parts(&self.asked),
        };
        graphics.draw_part(&mut parts, &frame)?;
        if !parts.is_complete() {
            self.parts = Some(parts);
            return Ok(Step::More);
        }
        self.done += 1;
        let Some(animation) = &mut self.animation else {
            return Ok(Step::Picture(parts.into_picture()));
        };
        animation
            .add(parts.into_picture())
            .map_err(PictureError::Format)?;
        if self.done < self.views.len() {
            return Ok(Step::More);
        }
        let complete = self.animation.take().map(Animation::finish);
        Ok(complete.map_or(Step::More, Step::Animation))
    }

    /// Part of the work that is done, from 0 to 1.
    fn part(&self) -> f32 {
        let parts = self.parts.as_ref();
        let inner = parts.map_or(0.0, |parts| parts.done() as f32 / parts.count() as f32);
        (self.done as f32 + inner) / self.views.len() as f32
    }

    fn name(&self) -> String {
        file_name(&self.path)
    }
}

/// Why a picture cannot be made.
#[derive(Debug, thiserror::Error)]
enum PictureError {
    #[error("the picture cannot be drawn: {0}")]
    Render(#[from] RenderError),
    #[error("{0}")]
    Format(String),
}

/// # Errors
/// If a file of `format` cannot hold what is asked for.
fn check(
    path: &Path,
    format: PictureFormat,
    shot: &Screenshot,
    size: (u32, u32),
) -> Result<(), Diagnostic> {
    let wrong = |message: String| Err(Diagnostic::new(path, message));
    if shot.turntable.is_some() && format != PictureFormat::Gif {
        return wrong("expected a name that ends in .gif for a turntable".to_owned());
    }
    if shot.transparent && format != PictureFormat::Png {
        return wrong(
            "expected a name that ends in .png for a picture without background".to_owned(),
        );
    }
    check_picture_size(size).or_else(wrong)
}

impl Program {
    /// Begins the pictures that are due, draws a part of the first one that is under way, and hands
    /// complete ones on to be written. Whether there is more to draw.
    pub(super) fn save_pictures(&mut self, graphics: &mut Graphics, host: &mut dyn Host) -> bool {
        for (path, shot) in std::mem::take(&mut self.due_pictures) {
            if shot.with_panels {
                self.save_window(path, graphics, host);
                continue;
            }
            let view = (graphics.view_size(), graphics.samples());
            let marks = self.marks_of_meshes(host.now());
            let shown = (&self.session, self.backdrop, marks);
            match PictureWork::new(path.clone(), &shot, shown, view) {
                Ok(work) => self.pictures.push_back(work),
                Err(error) => self.tell_written(&path, Err(error)),
            }
        }
        if let Some(mut work) = self.pictures.pop_front() {
            match work.step(graphics) {
                Ok(Step::More) => self.pictures.push_front(work),
                Ok(Step::Picture(picture)) => {
                    self.encode(work.path, picture, work.format, host);
                }
                Ok(Step::Animation(bytes)) => {
                    host.write_file(&work.path, bytes, Previous::KeepForeign);
                }
                Err(error) => {
                    let error = Diagnostic::new(&work.path, error.to_string());
                    self.tell_written(&work.path, Err(error));
                }
            }
        }
        self.quit_after_pictures(host);
        !self.pictures.is_empty()
    }

    fn save_window(&mut self, path: PathBuf, graphics: &Graphics, host: &mut dyn Host) {
        let picture = graphics.read_window();
        match (picture, PictureFormat::of(&path)) {
            (Ok(Some(picture)), Ok(format)) => self.encode(path, picture, format, host),
            (Ok(None), _) => {
                let text = "Not saved: pictures with panels cannot be taken here";
                self.tell(Severity::Error, text);
            }
            (Err(error), _) => {
                let text = format!("Not saved: the picture cannot be drawn: {error}");
                self.tell(Severity::Error, text);
            }
            (_, Err(error)) => self.tell_written(&path, Err(error)),
        }
    }

    /// Makes `picture` a file beside the program, which takes seconds for a large one.
    fn encode(
        &mut self,
        path: PathBuf,
        picture: Picture,
        format: PictureFormat,
        host: &mut dyn Host,
    ) {
        self.encoding += 1;
        host.start_job(Job::new(Work::Encode {
            path,
            picture,
            format,
        }));
    }

    /// Writes a picture that has become a file.
    pub(super) fn take_encoded(
        &mut self,
        path: &Path,
        bytes: Result<Vec<u8>, String>,
        host: &mut dyn Host,
    ) {
        self.encoding = self.encoding.saturating_sub(1);
        match bytes {
            Ok(bytes) => host.write_file(path, bytes, Previous::KeepForeign),
            Err(message) => self.tell_written(path, Err(Diagnostic::new(path, message))),
        }
        self.quit_after_pictures(host);
    }

    /// Text and part done, from 0 to 1, of the pictures that take longer than a frame.
    pub(super) fn picture_progress(&self) -> Option<(String, f32)> {
        let work = self.pictures.front()?;
        Some((format!("Drawing {}", work.name()), work.part()))
    }

    /// Gives up the pictures that are being drawn.
    pub(super) fn cancel_pictures(&mut self) {
        for work in std::mem::take(&mut self.pictures) {
            let text = format!("Cancelled: {} is not written", work.path.display());
            self.tell(Severity::Info, text);
        }
    }

    /// Whether a picture that was asked for is not written yet.
    pub(super) fn has_pictures_under_way(&self) -> bool {
        !self.pictures.is_empty() || self.encoding > 0
    }
}
