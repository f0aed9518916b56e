//! The scene as a flat list of nodes, parents before children, instances of nodes unfolded, and
//! the space that it is in.

use super::document::{Dae, Impact, MOST_CHILDREN, MOST_DEPTH, MOST_NODES, Node, child};
use super::quoted;
use super::sources::{fixed, matrix, text};
use crate::io::Diagnostic;
use glam::{DMat3, DMat4, DVec3};

/// A node as it stands in the scene.
pub(super) struct SceneNode<'a> {
    pub xml: Node<'a>,
    pub parent: Option<usize>,
    depth: usize,
    /// From the node to the file's world.
    pub world: DMat4,
    /// Whether it is a joint: by its type, or because a skin names it.
    pub is_joint: bool,
}

impl<'a> SceneNode<'a> {
    /// Its name in the file, else its sid or id.
    pub fn name(&self) -> &'a str {
        ["name", "sid", "id"]
            .iter()
            .find_map(|key| self.xml.attribute(*key))
            .unwrap_or("Node")
    }
}

/// All nodes of the file's scene in the order of the document.
///
/// # Errors
/// If there is no scene, or it or its nodes have too much in them.
pub(super) fn flatten<'a>(dae: &Dae<'a>) -> Result<Vec<SceneNode<'a>>, Diagnostic> {
    let scene = find(dae)?;
    let mut nodes: Vec<SceneNode> = Vec::new();
    // What is still to visit, next last, with the place of the parent in `nodes`.
    let mut open: Vec<(Node, Option<usize>)> = Vec::new();
    push_children(dae, scene, None, &mut open);
    let (mut visited, mut children) = (0, 0);
    while let Some((xml, parent)) = open.pop() {
        let depth = parent.map_or(0, |parent| nodes[parent].depth + 1);
        visited += 1;
        if visited > MOST_NODES || depth > MOST_DEPTH {
            let message = format!(
                "expected at most {MOST_NODES} nodes in a scene and {MOST_DEPTH} inside one another, found more"
            );
            return Err(dae.error(xml, message));
        }
        if ancestors(&nodes, parent).any(|ancestor| nodes[ancestor].xml == xml) {
            dae.warn(
                Impact::Shape,
                xml,
                "expected a tree of nodes, found one that holds itself: left out",
            );
            continue;
        }
        // They are walked here and again for the meshes among them.
        children += xml.children().count();
        if children > MOST_CHILDREN {
            let message = format!(
                "expected at most {MOST_CHILDREN} elements in the nodes of a scene, found more"
            );
            return Err(dae.error(xml, message));
        }
        let local = local(dae, xml)?;
        let world = parent.map_or(local, |parent| nodes[parent].world * local);
        if !world.is_finite() {
            return Err(dae.error(xml, "expected a transform with finite numbers, found more"));
        }
        nodes.push(SceneNode {
            xml,
            parent,
            depth,
            world,
            is_joint: xml.attribute("type") == Some("JOINT"),
        });
        push_children(dae, xml, Some(nodes.len() - 1), &mut open);
    }
    Ok(nodes)
}

/// `node` and all below it, as a range of a flat list.
pub(super) fn subtree(nodes: &[SceneNode], node: usize) -> std::ops::Range<usize> {
    let below = nodes[node + 1..]
        .iter()
        .take_while(|other| other.depth > nodes[node].depth);
    node..node + 1 + below.count()
}

/// `node` and what is above it, in a flat list.
pub(super) fn ancestors<'n>(
    nodes: &'n [SceneNode],
    node: Option<usize>,
) -> impl Iterator<Item = usize> + 'n {
    std::iter::successors(node, |&node| nodes[node].parent)
}

/// The scene that the file shows.
///
/// # Errors
/// If there is none.
pub(super) fn find<'a>(dae: &Dae<'a>) -> Result<Node<'a>, Diagnostic> {
    let instance = child(dae.root, "scene").and_then(|s| child(s, "instance_visual_scene"));
    if let Some(instance) = instance
        && let Some(scene) = dae.or_warn(
            Impact::Shape,
            dae.target_called(instance, "url", "visual_scene"),
        )
    {
        return Ok(scene);
    }
    let library = dae.child(dae.root, "library_visual_scenes")?;
    dae.child(library, "visual_scene")
}

fn push_children<'a>(
    dae: &Dae<'a>,
    of: Node<'a>,
    place: Option<usize>,
    open: &mut Vec<(Node<'a>, Option<usize>)>,
) {
    let start = open.len();
    for node in of.children().filter(Node::is_element) {
        match node.tag_name().name() {
            "node" => open.push((node, place)),
            "instance_node" => {
                if let Some(target) =
                    dae.or_warn(Impact::Shape, dae.target_called(node, "url", "node"))
                {
                    open.push((target, place));
                }
            }
            "instance_camera" | "instance_light" => dae.ignore(node.tag_name().name()),
            _ => {}
        }
    }
    open[start..].reverse();
}

/// A node's own transform: the product of its elements in their order.
fn local(dae: &Dae, node: Node) -> Result<DMat4, Diagnostic> {
    let mut product = DMat4::IDENTITY;
    for element in node.children().filter(Node::is_element) {
        product *= match element.tag_name().name() {
            "matrix" => matrix(dae, element)?,
            "translate" => DMat4::from_translation(DVec3::from_array(fixed(dae, element)?)),
            "scale" => DMat4::from_scale(DVec3::from_array(fixed(dae, element)?)),
            "rotate" => {
                let [x, y, z, degrees] = fixed(dae, element)?;
                match DVec3::new(x, y, z).try_normalize() {
                    Some(axis) => DMat4::from_axis_angle(axis, degrees.to_radians()),
                    None => DMat4::IDENTITY,
                }
            }
            "skew" | "lookat" => {
                let tag = element.tag_name().name();
                dae.warn(
                    Impact::Shape,
                    element,
                    format!("expected a transform that can be read, found <{tag}>: left out"),
                );
                DMat4::IDENTITY
            }
            _ => continue,
        };
    }
    Ok(product)
}

/// Which way the file's axes point, and how long its unit is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FileSpace {
    /// The axis that points up.
    pub up: UpAxis,
    /// Meters a unit; positions are scaled by it.
    pub meters: f64,
}

/// The axis that points up in a Collada file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum UpAxis {
    /// `(x, y, z)` is `(−y, x, z)` with +Y up.
    X,
    /// As here.
    #[default]
    Y,
    /// `(x, y, z)` is `(x, z, −y)` with +Y up, as Blender writes.
    Z,
}

impl FileSpace {
    /// Space of `<asset>`; +Y up and meters where it says nothing.
    pub(super) fn read(dae: &Dae) -> Self {
        let asset = child(dae.root, "asset");
        let up = asset.and_then(|asset| child(asset, "up_axis"));
        let up = up.map_or(UpAxis::Y, |node| match text(node) {
            "X_UP" => UpAxis::X,
            "Y_UP" => UpAxis::Y,
            "Z_UP" => UpAxis::Z,
            other => {
                let found = quoted(other);
                dae.warn(
                    Impact::Shape,
                    node,
                    format!("expected X_UP, Y_UP or Z_UP, found {found}: taken as Y_UP"),
                );
                UpAxis::Y
            }
        });
        let unit = asset.and_then(|asset| child(asset, "unit"));
        let meters = unit.and_then(|node| {
            let value = node.attribute("meter")?;
            let meters = value.trim().parse::<f64>().ok();
            let sensible = meters.filter(|meters| (1e-9..=1e9).contains(meters));
            if sensible.is_none() {
                let found = quoted(value);
                dae.warn(
                    Impact::Shape,
                    node,
                    format!("expected the meters of a unit, found {found}: taken as 1"),
                );
            }
            sensible
        });
        Self {
            up,
            meters: meters.unwrap_or(1.0),
        }
    }

    /// The matrix that brings the file's positions into ours.
    pub fn ours_from_file(&self) -> DMat4 {
        let axes = match self.up {
            UpAxis::X => DMat3::from_cols(DVec3::Y, DVec3::NEG_X, DVec3::Z),
            UpAxis::Y => DMat3::IDENTITY,
            UpAxis::Z => DMat3::from_cols(DVec3::X, DVec3::NEG_Z, DVec3::Y),
        };
        DMat4::from_mat3(axes * self.meters)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_turn_as_collada_says() {
        let point = DVec3::new(1.0, 2.0, 3.0);
        let ours = |up, meters| {
            FileSpace { up, meters }
                .ours_from_file()
                .transform_point3(point)
        };
        assert_eq!(ours(UpAxis::Z, 1.0), DVec3::new(1.0, 3.0, -2.0));
        assert_eq!(ours(UpAxis::X, 1.0), DVec3::new(-2.0, 1.0, 3.0));
        assert_eq!(ours(UpAxis::Y, 0.5), point * 0.5);
    }
}
