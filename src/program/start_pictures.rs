//! Small pictures of the built-in characters and scenes, for the start page.

use super::Host;
use super::awaited::Awaited;
use super::graphics::Graphics;
use super::running::Program;
use crate::editor::{Session, View};
use crate::geometry::Picture;
use crate::io::Loaded;
use crate::io::builtin::{self, BuiltinKind};
use crate::render::{Backdrop, Background, Frame, LargePicture, Marks};
use crate::scene::{FitArea, Look};
use crate::ui::{START_SCENES, StartPicture, picture_texture};
use egui::{Context, TextureHandle};
use std::path::{Path, PathBuf};

/// Width and height of a picture, in pixels: enough for screens with two pixels a point.
const SIZE: (u32, u32) = (192, 144);

/// Pictures that have been drawn so far. One is drawn a frame, and only while the start page is
/// shown, so that nobody waits for them.
#[derive(Default)]
pub(super) struct StartPictures {
    is_wanted: bool,
    /// Whether files of the next one are on their way.
    is_waiting: bool,
    /// What all of them are drawn with: others are drawn anew.
    drawn_with: (Backdrop, Option<Look>),
    /// Number of the names of [`names`] that have been drawn, or cannot be.
    done: usize,
    /// Pictures that have no texture yet.
    drawn: Vec<(&'static str, Picture)>,
    /// Textures, which live as long as their handles.
    textures: Vec<TextureHandle>,
    shown: Vec<StartPicture>,
}

impl StartPictures {
    /// Takes note of whether the start page is shown, of what a picture on it opens with, and makes
    /// textures of what has been drawn.
    pub fn notice(&mut self, is_wanted: bool, with: (Backdrop, Option<Look>), context: &Context) {
        if is_wanted && self.drawn_with != with {
            *self = Self {
                drawn_with: with,
                ..Self::default()
            };
        }
        self.is_wanted = is_wanted;
        for (name, picture) in self.drawn.drain(..) {
            let texture = picture_texture(context, name, &picture);
            self.shown.push(StartPicture {
                name,
                texture: texture.id(),
            });
            self.textures.push(texture);
        }
    }

    /// Goes on with files that are there now.
    pub fn go_on(&mut self) {
        self.is_waiting = false;
    }

    /// Goes on without the picture whose files cannot be had.
    pub fn go_without(&mut self) {
        if std::mem::take(&mut self.is_waiting) {
            self.done += 1;
        }
    }

    /// Pictures that can be shown.
    pub fn shown(&self) -> &[StartPicture] {
        &self.shown
    }
}

impl Program {
    /// Draws the next picture of the start page, if there is one to draw; whether there was.
    pub(super) fn draw_start_picture(
        &mut self,
        graphics: &mut Graphics,
        host: &mut dyn Host,
    ) -> bool {
        let pictures = &mut self.start_pictures;
        let is_due = pictures.is_wanted && !pictures.is_waiting;
        let Some(name) = names().nth(pictures.done).filter(|_| is_due) else {
            return false;
        };
        let path = PathBuf::from(format!("{}{name}", builtin::PREFIX));
        let absent = builtin::absent(&*host.files(), &path);
        if !absent.is_empty() {
            pictures.is_waiting = true;
            self.wait_for(absent, Awaited::StartPicture, host);
            return false;
        }
        pictures.done += 1;
        // Without its picture there is still its name.
        let backdrop = self.backdrop;
        let picture = self.shown_first(&path, host).and_then(|session| {
            let frame = Frame {
                scene: session.scene(),
                evaluated: session.evaluated(),
                view: session.view(),
                backdrop,
                marks: Marks::default(),
            };
            let asked = LargePicture {
                size: SIZE,
                samples: graphics.samples(),
                background: Background::Look,
                tile: None,
            };
            let mut parts = graphics.picture_parts(&asked);
            while !parts.is_complete() {
                graphics.draw_part(&mut parts, &frame).ok()?;
            }
            Some(parts.into_picture())
        });
        let drawn = &mut self.start_pictures.drawn;
        drawn.extend(picture.map(|picture| (name, picture)));
        true
    }

    /// A built-in file as it is seen when it is opened.
    fn shown_first(&self, path: &Path, host: &dyn Host) -> Option<Session> {
        let mut loaded = Loaded::default();
        loaded.add(&*host.files(), path).ok()?;
        let Loaded {
            mut shapes, view, ..
        } = loaded;
        let own = view.is_some();
        let view = view.unwrap_or_else(|| self.first_view(&mut shapes, false));
        let mut session = Session::with_shapes(shapes, view);
        if !own {
            session.look(View::Select(None));
            session.look(View::Fit(FitArea::whole(SIZE.0 as f32 / SIZE.1 as f32)));
        }
        Some(session)
    }
}

/// Names of built-in files that the start page shows, in its order.
fn names() -> impl Iterator<Item = &'static str> {
    let catalogue = builtin::catalogue().into_iter();
    let characters = catalogue.filter(|builtin| builtin.kind == BuiltinKind::Character);
    let scenes = START_SCENES.iter().map(|(name, _)| *name);
    characters.map(|builtin| builtin.name).chain(scenes)
}
