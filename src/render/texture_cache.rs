use crate::geometry::Picture;
use crate::gpu::{Filter, Gl, GpuError, Sampling, Texture, Wrap};
use std::rc::Rc;
use std::sync::Arc;

/// The pictures of materials in the memory of the graphics card, each once, however many
/// materials and meshes show it.
///
/// Pixels stay the stored values that they are in the file, as all colors here do: the Course look
/// lights stored values, as its original does, and the Studio look makes them linear itself. So a
/// picture of one color looks as a material of that color, and mipmaps average what other viewers
/// average.
#[derive(Debug, Default)]
pub(super) struct TextureCache {
    /// `None` for a picture that the driver refused, which is told once.
    held: Vec<(Arc<Picture>, Option<Rc<Texture>>)>,
    notices: Vec<String>,
}

impl TextureCache {
    /// The texture of `picture`; `None` if the driver refuses it.
    pub fn texture(&mut self, gl: &Gl, picture: &Arc<Picture>) -> Option<Rc<Texture>> {
        let known = self
            .held
            .iter()
            .find(|(held, _)| Arc::ptr_eq(held, picture));
        if let Some((_, texture)) = known {
            return texture.clone();
        }
        let texture = match upload(gl, picture) {
            Ok(texture) => Some(Rc::new(texture)),
            Err(error) => {
                let Picture { width, height, .. } = **picture;
                self.notices.push(format!(
                    "A picture of {width}x{height} pixels is not shown on its material: {error}"
                ));
                None
            }
        };
        self.held.push((picture.clone(), texture.clone()));
        texture
    }

    /// Forgets what no mesh shows any more.
    pub fn forget_unused(&mut self) {
        self.held.retain(|(picture, texture)| match texture {
            Some(texture) => Rc::strong_count(texture) > 1,
            None => Arc::strong_count(picture) > 1,
        });
    }

    /// What was refused since the last call, in words for the user.
    pub fn take_notices(&mut self) -> Vec<String> {
        std::mem::take(&mut self.notices)
    }
}

fn upload(gl: &Gl, picture: &Picture) -> Result<Texture, GpuError> {
    // Texture coordinates count from the lower left, pictures from the top.
    let row = (picture.width as usize * 4).max(1);
    let rows = picture.rgba.chunks(row).rev();
    let upwards: Vec<u8> = rows.flatten().copied().collect();
    let sampling = Sampling {
        filter: Filter::Linear,
        wrap: Wrap::Repeat,
        mipmaps: true,
    };
    Texture::new(gl, picture.width, picture.height, &upwards, sampling)
}
