//! `<geometry>`: positions, and triangles whose corners index them and their other attributes.

use super::document::{Dae, Node, child};
use super::label;
use super::primitives::{self, Primitive};
use super::source::{Input, Source, Sources, inputs};
use crate::io::Diagnostic;
use glam::Vec3;
use std::rc::Rc;

/// A mesh as the file has it, in its own space.
pub(super) struct Geometry {
    pub name: String,
    pub positions: Vec<Vec3>,
    pub primitives: Vec<Primitive>,
}

/// What `<vertices>` bundles under one index.
pub(super) struct Vertices<'a> {
    pub id: &'a str,
    pub others: Vec<(Input<'a>, Rc<Source>)>,
}

/// Reads a `<geometry>`.
///
/// # Errors
/// If it is no mesh or has no positions. Triangles that cannot be read are warnings.
pub(super) fn read<'a>(
    dae: &Dae<'a>,
    sources: &mut Sources,
    node: Node<'a>,
) -> Result<Geometry, Diagnostic> {
    let Some(mesh) = child(node, "mesh") else {
        let message = format!(
            "expected <mesh> in {}: other kinds are not read",
            label(node)
        );
        return Err(dae.error(node, message));
    };
    let vertices = dae.child(mesh, "vertices")?;
    let mut positions = None;
    let mut others = Vec::new();
    for input in inputs(dae, vertices)? {
        match input.semantic {
            "POSITION" => positions = Some(sources.floats(dae, input.node, 3)?),
            semantic => {
                if let Some(columns) = primitives::columns(semantic)
                    && let Some(source) = dae.or_warn(sources.floats(dae, input.node, columns))
                {
                    others.push((input, source));
                }
            }
        }
    }
    let Some(positions) = positions else {
        return Err(dae.error(
            vertices,
            "expected an <input> with the POSITION, found none",
        ));
    };
    let positions: Vec<Vec3> = positions.rows().map(Vec3::from_array).collect();
    if positions.is_empty() {
        return Err(dae.error(node, "expected positions, found none"));
    }
    let vertices = Vertices {
        id: vertices.attribute("id").unwrap_or_default(),
        others,
    };
    let primitives = mesh
        .children()
        .filter(Node::is_element)
        .filter_map(|node| dae.or_warn(primitives::read(dae, sources, node, &vertices, &positions)))
        .flatten()
        .filter(|primitive| !primitive.positions.is_empty())
        .collect();
    let name = node.attribute("name").or(node.attribute("id"));
    Ok(Geometry {
        name: name.unwrap_or("Mesh").to_owned(),
        positions,
        primitives,
    })
}
