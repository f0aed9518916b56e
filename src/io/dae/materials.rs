//! Materials: a symbol of the mesh → `<instance_material>` → effect → diffuse color or texture,
//! and the pictures of textures.

use super::document::{Dae, Impact, Node, child, children};
use super::quoted;
use super::sources::{count, floats, text};
use crate::geometry::{Material, Picture};
use crate::io::pictures::{MissingPictures, Pictures};
use crate::io::{Diagnostic, Files};
use glam::Vec3;
use roxmltree::NodeId;
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The color of a material of which the file says none: Blender's.
const DEFAULT_COLOR: Vec3 = Vec3::splat(0.8);
/// How many references from a texture to its image are followed.
const MOST_REFERENCES: usize = 4;

/// A material as an instance of a mesh has it.
#[derive(Clone)]
pub(super) struct BoundMaterial {
    pub material: Material,
    /// The set of texture coordinates that the texture asks for, if it does.
    pub texture_set: Option<usize>,
}

/// The materials of a document, each read once.
pub(super) struct Materials<'a> {
    textures: Textures<'a>,
    read: HashMap<NodeId, Option<Effect>>,
}

#[derive(Clone)]
struct Effect {
    material: Material,
    /// The texture's name for its coordinates.
    coordinates: Option<String>,
}

impl<'a> Materials<'a> {
    /// None yet; pictures will come from `files`.
    pub fn new(files: &'a dyn Files) -> Self {
        Self {
            textures: Textures::new(files),
            read: HashMap::new(),
        }
    }

    /// The materials that `instance` binds to symbols.
    pub fn bind(&mut self, dae: &Dae<'a>, instance: Node<'a>) -> HashMap<&'a str, BoundMaterial> {
        child(instance, "bind_material")
            .and_then(|bind| child(bind, "technique_common"))
            .into_iter()
            .flat_map(|common| children(common, "instance_material"))
            .filter_map(|node| {
                let symbol = node.attribute("symbol")?;
                let target =
                    dae.or_warn(Impact::Color, dae.target_called(node, "target", "material"))?;
                let effect = self.material(dae, target)?;
                let texture_set = effect.coordinates.as_deref().and_then(|name| {
                    let named = |input: &Node| input.attribute("semantic") == Some(name);
                    let input = children(node, "bind_vertex_input").find(named)?;
                    count(dae, input, "input_set").ok()?
                });
                let material = effect.material;
                Some((
                    symbol,
                    BoundMaterial {
                        material,
                        texture_set,
                    },
                ))
            })
            .collect()
    }

    /// Keeps one warning about all pictures that the materials so far name and that are missing.
    pub fn warn_of_missing_pictures(&self, dae: &Dae<'a>) {
        self.textures.warn_of_missing(dae);
    }

    /// The material whose id is the symbol itself, for files that bind none.
    pub fn called(&mut self, dae: &Dae<'a>, symbol: &str) -> Option<BoundMaterial> {
        let node = dae.by_id(symbol)?;
        if node.tag_name().name() != "material" {
            return None;
        }
        let effect = self.material(dae, node)?;
        Some(BoundMaterial {
            material: effect.material,
            texture_set: None,
        })
    }

    fn material(&mut self, dae: &Dae<'a>, node: Node<'a>) -> Option<Effect> {
        if let Some(known) = self.read.get(&node.id()) {
            return known.clone();
        }
        let effect = dae.or_warn(Impact::Color, self.effect(dae, node));
        self.read.insert(node.id(), effect.clone());
        effect
    }

    fn effect(&mut self, dae: &Dae<'a>, node: Node<'a>) -> Result<Effect, Diagnostic> {
        let instance = dae.child(node, "instance_effect")?;
        let effect = dae.target_called(instance, "url", "effect")?;
        let name = node.attribute("name").or(node.attribute("id"));
        let mut read = Effect {
            material: Material {
                name: name.unwrap_or("Material").to_owned(),
                color: DEFAULT_COLOR,
                texture: None,
            },
            coordinates: None,
        };
        let profile = dae.child(effect, "profile_COMMON")?;
        let technique = dae.child(profile, "technique")?;
        let channel = technique
            .children()
            .find_map(|shader| match shader.tag_name().name() {
                "lambert" | "phong" | "blinn" => child(shader, "diffuse"),
                "constant" => child(shader, "emission"),
                _ => None,
            });
        for value in channel
            .iter()
            .flat_map(|c| c.children())
            .filter(Node::is_element)
        {
            match value.tag_name().name() {
                "color" => read.material.color = color(dae, value)?,
                "param" => {
                    let sid = value.attribute("ref").unwrap_or_default();
                    let color_of = parameter(effect, profile, sid).and_then(|param| {
                        child(param, "float4").or_else(|| child(param, "float3"))
                    });
                    if let Some(node) = color_of {
                        read.material.color = color(dae, node)?;
                    }
                }
                "texture" => {
                    read.coordinates = value.attribute("texcoord").map(str::to_owned);
                    let image = image(dae, effect, profile, value)?;
                    read.material.texture = self.textures.picture(dae, image);
                    if read.material.texture.is_some() {
                        read.material.color = Vec3::ONE;
                    }
                }
                _ => {}
            }
        }
        Ok(read)
    }
}

fn color(dae: &Dae, node: Node) -> Result<Vec3, Diagnostic> {
    match floats(dae, node)?.as_slice() {
        &[r, g, b] | &[r, g, b, _] => Ok(Vec3::new(r, g, b).clamp(Vec3::ZERO, Vec3::ONE)),
        other => {
            let found = other.len();
            Err(dae.error(
                node,
                format!("expected a color of 3 or 4 numbers, found {found}"),
            ))
        }
    }
}

/// `<newparam>` by its sid, in the profile or the effect around it.
fn parameter<'a>(effect: Node<'a>, profile: Node<'a>, sid: &str) -> Option<Node<'a>> {
    [profile, effect]
        .into_iter()
        .flat_map(|scope| children(scope, "newparam"))
        .find(|param| param.attribute("sid") == Some(sid))
}

/// The `<image>` behind a `<texture>`: through sampler and surface (Collada 1.4), sampler alone
/// (1.5), or named at once, as some exporters do.
fn image<'a>(
    dae: &Dae<'a>,
    effect: Node<'a>,
    profile: Node<'a>,
    texture: Node<'a>,
) -> Result<Node<'a>, Diagnostic> {
    let mut name = texture.attribute("texture").unwrap_or_default();
    for _ in 0..MOST_REFERENCES {
        let Some(param) = parameter(effect, profile, name) else {
            break;
        };
        if let Some(sampler) = child(param, "sampler2D") {
            if let Some(instance) = child(sampler, "instance_image") {
                return dae.target_called(instance, "url", "image");
            }
            name = text(dae.child(sampler, "source")?);
        } else {
            name = text(dae.child(dae.child(param, "surface")?, "init_from")?);
        }
    }
    match dae.by_id(name) {
        Some(image) if image.tag_name().name() == "image" => Ok(image),
        _ => {
            let found = quoted(name);
            Err(dae.error(
                texture,
                format!("expected the id of an <image>, found {found}"),
            ))
        }
    }
}

/// The pictures of a document, each read once.
pub(super) struct Textures<'a> {
    pictures: Pictures<'a>,
    missing: MissingPictures,
    /// Place of the first that is missing.
    first_missing: Option<Node<'a>>,
    read: HashMap<NodeId, Option<Arc<Picture>>>,
}

impl<'a> Textures<'a> {
    /// None yet; they will come from `files`.
    pub fn new(files: &'a dyn Files) -> Self {
        Self {
            pictures: Pictures::new(files),
            missing: MissingPictures::default(),
            first_missing: None,
            read: HashMap::new(),
        }
    }

    /// The picture of an `<image>`; `None` if it is missing, and with a warning if it cannot be
    /// read.
    pub fn picture(&mut self, dae: &Dae<'a>, element: Node<'a>) -> Option<Arc<Picture>> {
        if let Some(known) = self.read.get(&element.id()) {
            return known.clone();
        }
        let picture = dae
            .or_warn(Impact::Color, self.read(dae, element))
            .flatten();
        self.read.insert(element.id(), picture.clone());
        picture
    }

    fn read(
        &mut self,
        dae: &Dae<'a>,
        element: Node<'a>,
    ) -> Result<Option<Arc<Picture>>, Diagnostic> {
        let init = dae.child(element, "init_from")?;
        let url = text(child(init, "ref").unwrap_or(init));
        let folder = dae.path.parent().unwrap_or(Path::new(""));
        let path = candidates(url)
            .into_iter()
            .map(|candidate| folder.join(candidate))
            .find(|path| self.pictures.exists(path));
        let Some(path) = path else {
            self.first_missing.get_or_insert(init);
            self.missing.add(url);
            return Ok(None);
        };
        self.pictures.get(&path).map(Some)
    }

    /// Keeps one warning about all missing pictures, which names the first.
    fn warn_of_missing(&self, dae: &Dae<'a>) {
        if let Some((place, message)) = self.first_missing.zip(self.missing.warning()) {
            dae.warn(Impact::Color, place, message);
        }
    }
}

/// Where `url` may mean, best first: as a URL, as a plain path, and, for a path of the author's
/// own machine, the file's name alone.
fn candidates(url: &str) -> Vec<PathBuf> {
    let plain = url.strip_prefix("file://").unwrap_or(url);
    let mut candidates = Vec::new();
    for path in [percent_decoded(plain), plain.to_owned()] {
        let slashes = path.replace('\\', "/");
        let name = slashes.rsplit('/').next().unwrap_or_default().to_owned();
        // `file:///C:/a.png`.
        let drive = slashes
            .strip_prefix('/')
            .filter(|rest| rest.as_bytes().get(1) == Some(&b':'));
        let drive = drive.map(str::to_owned);
        candidates.extend(
            [Some(slashes), drive, Some(path), Some(name)]
                .into_iter()
                .flatten(),
        );
    }
    candidates.retain(|candidate| !candidate.is_empty());
    candidates.into_iter().map(PathBuf::from).collect()
}

/// Decodes `%20` and the like; text that would not be UTF-8 stays as it was.
fn percent_decoded(text: &str) -> String {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.as_bytes();
    while let Some((&first, after)) = rest.split_first() {
        let digit = |at: usize| char::from(*after.get(at)?).to_digit(16);
        match (first, digit(0), digit(1)) {
            (b'%', Some(high), Some(low)) => {
                bytes.push((high * 16 + low) as u8);
                rest = &after[2..];
            }
            _ => {
                bytes.push(first);
                rest = after;
            }
        }
    }
    String::from_utf8(bytes).unwrap_or_else(|_| text.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percent_signs_are_decoded_and_broken_ones_kept() {
        assert_eq!(percent_decoded("a%20b%C3%A9.png"), "a bé.png");
        assert_eq!(percent_decoded("100%.png"), "100%.png");
        assert_eq!(percent_decoded("%zz%4"), "%zz%4");
        assert_eq!(percent_decoded("%FF"), "%FF");
    }

    #[test]
    fn a_path_of_the_authors_machine_also_means_the_file_beside_this_one() {
        let windows = candidates("file:///C:/My%20Art/skin.png");
        assert!(windows.contains(&PathBuf::from("C:/My Art/skin.png")));
        assert!(windows.contains(&PathBuf::from("skin.png")));
        assert!(candidates(r"textures\skin.png").contains(&PathBuf::from("textures/skin.png")));
    }
}
