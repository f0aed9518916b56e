//! Pictures as the panels show them.

use crate::geometry::Picture;
use crate::ui::{self, ShownPicture};
use egui::{Context, TextureHandle};
use std::sync::Arc;

/// A picture with the texture that shows it, made when it is first shown.
pub(super) struct Textured {
    pub picture: Arc<Picture>,
    pub texture: Option<TextureHandle>,
}

impl Textured {
    pub fn new(picture: Picture) -> Self {
        Self {
            picture: Arc::new(picture),
            texture: None,
        }
    }

    pub fn load(&mut self, context: &Context, name: &str) {
        let picture = &self.picture;
        self.texture
            .get_or_insert_with(|| ui::picture_texture(context, name, picture));
    }

    pub fn shown(&self) -> Option<ShownPicture<'_>> {
        Some(ShownPicture {
            picture: &self.picture,
            texture: self.texture.as_ref()?.id(),
        })
    }
}
