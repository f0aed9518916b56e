//! `<controller>`: which joints move which positions.

use super::document::{Dae, Impact, Node, child};
use super::meshes::{self, Geometry};
use super::quoted;
use super::sources::{Input, Sources, inputs, integers, matrix, names};
use crate::io::Diagnostic;
use glam::DMat4;
use std::collections::HashMap;
use std::rc::Rc;

/// A mesh with weights, in the file's terms.
pub(super) struct Skin<'a> {
    pub geometry: Rc<Geometry>,
    pub bind_shape: DMat4,
    /// Sid or id of each joint of the list.
    pub joints: Vec<&'a str>,
    /// Whether `joints` are ids of nodes; otherwise sids.
    pub joints_are_ids: bool,
    /// The file's own bind pose of each joint; as many as joints, or none.
    pub inverse_binds: Vec<DMat4>,
    pub weights: Rows,
}

/// For each position the joints that move it, as indices into the skin's list.
#[derive(Default)]
pub(super) struct Rows {
    pairs: Vec<(u32, f32)>,
    ends: Vec<usize>,
}

impl Rows {
    /// How many pairs there are.
    pub fn len(&self) -> usize {
        self.pairs.len()
    }

    /// The pairs of `position`; none beyond the last.
    pub fn get(&self, position: usize) -> &[(u32, f32)] {
        let Some(&end) = self.ends.get(position) else {
            return &[];
        };
        let start = position
            .checked_sub(1)
            .map_or(0, |before| self.ends[before]);
        &self.pairs[start..end]
    }
}

/// Geometries, each read once however often it is instanced. `None` for those that failed, of
/// which a warning was kept.
#[derive(Default)]
pub(super) struct Geometries {
    pub sources: Sources,
    read: HashMap<roxmltree::NodeId, Option<Rc<Geometry>>>,
}

impl Geometries {
    /// The geometry in `node`.
    pub fn get<'a>(&mut self, dae: &Dae<'a>, node: Node<'a>) -> Option<Rc<Geometry>> {
        if let Some(known) = self.read.get(&node.id()) {
            return known.clone();
        }
        let read = meshes::read_geometry(dae, &mut self.sources, node);
        let read = read.map_err(|error| error.followed_by("the mesh is left out"));
        let geometry = dae.or_warn(Impact::Shape, read).map(Rc::new);
        self.read.insert(node.id(), geometry.clone());
        geometry
    }
}

/// Kinds of `<controller>`.
#[derive(Clone)]
pub(super) enum Controller<'a> {
    /// Joints move it.
    Skin(Rc<Skin<'a>>),
    /// It is blended with others, which are left out: the mesh as it is.
    Morph(Rc<Geometry>),
}

/// Reads a `<controller>`; `None`, with a warning, if its geometry cannot be read.
///
/// # Errors
/// If it is neither a skin nor a morph of a mesh of this file.
pub(super) fn read<'a>(
    dae: &Dae<'a>,
    geometries: &mut Geometries,
    controller: Node<'a>,
) -> Result<Option<Controller<'a>>, Diagnostic> {
    if let Some(morph) = child(controller, "morph") {
        dae.ignore("morph");
        let geometry = geometries.get(dae, base_geometry(dae, morph)?);
        return Ok(geometry.map(Controller::Morph));
    }
    let skin = dae.child(controller, "skin")?;
    let Some(geometry) = geometries.get(dae, base_geometry(dae, skin)?) else {
        return Ok(None);
    };
    let bind_shape = match child(skin, "bind_shape_matrix") {
        Some(node) => matrix(dae, node)?,
        None => DMat4::IDENTITY,
    };
    let mut read = Skin {
        geometry,
        bind_shape,
        joints: Vec::new(),
        joints_are_ids: false,
        inverse_binds: Vec::new(),
        weights: Rows::default(),
    };
    // Whatever is wrong with the weights, the mesh is there.
    dae.or_warn(
        Impact::Shape,
        read.read_joints(dae, &mut geometries.sources, skin),
    );
    let positions = read.geometry.positions.len();
    let rows = weights(
        dae,
        &mut geometries.sources,
        skin,
        read.joints.len(),
        positions,
    );
    let rows = rows.map_err(|error| error.followed_by("the weights are left out"));
    read.weights = dae.or_warn(Impact::Shape, rows).unwrap_or_default();
    Ok(Some(Controller::Skin(Rc::new(read))))
}

/// The geometry that `deformer` deforms, directly or through a morph.
fn base_geometry<'a>(dae: &Dae<'a>, deformer: Node<'a>) -> Result<Node<'a>, Diagnostic> {
    let target = dae.target(deformer, "source")?;
    if target.tag_name().name() == "controller"
        && let Some(morph) = child(target, "morph")
    {
        dae.ignore("morph");
        return dae.target_called(morph, "source", "geometry");
    }
    dae.target_called(deformer, "source", "geometry")
}

impl<'a> Skin<'a> {
    fn read_joints(
        &mut self,
        dae: &Dae<'a>,
        sources: &mut Sources,
        skin: Node<'a>,
    ) -> Result<(), Diagnostic> {
        let joints = dae.child(skin, "joints")?;
        for input in inputs(dae, joints)? {
            match input.semantic {
                "JOINT" => {
                    let names = names(dae, input.node)?;
                    self.joints = names.names;
                    self.joints_are_ids = names.are_ids;
                }
                "INV_BIND_MATRIX" => {
                    if let Some(source) =
                        dae.or_warn(Impact::Shape, sources.floats(dae, input.node, 16))
                    {
                        self.inverse_binds = source
                            .rows::<16>()
                            .map(|row| DMat4::from_cols_array(&row.map(f64::from)).transpose())
                            .collect();
                    }
                }
                other => dae.ignore(format!("input {other}")),
            }
        }
        let (joints, binds) = (self.joints.len(), self.inverse_binds.len());
        if joints != binds && binds > 0 {
            let message = format!("expected {joints} inverse bind matrices, found {binds}");
            dae.warn(Impact::Shape, skin, message);
            self.inverse_binds.clear();
        }
        Ok(())
    }
}

fn weights<'a>(
    dae: &Dae<'a>,
    sources: &mut Sources,
    skin: Node<'a>,
    joints: usize,
    positions: usize,
) -> Result<Rows, Diagnostic> {
    let node = dae.child(skin, "vertex_weights")?;
    let inputs = inputs(dae, node)?;
    let find = |semantic: &str| {
        let found = inputs.iter().find(|input| input.semantic == semantic);
        found.ok_or_else(|| {
            dae.error(
                node,
                format!("expected an <input> with the {semantic}, found none"),
            )
        })
    };
    let (joint, weight): (&Input, &Input) = (find("JOINT")?, find("WEIGHT")?);
    let values = sources.floats(dae, weight.node, 1)?;
    let stride = inputs
        .iter()
        .map(|input| input.offset + 1)
        .max()
        .unwrap_or(1);
    let counts = integers::<u32>(dae, dae.child(node, "vcount")?)?;
    let indices = match child(node, "v") {
        Some(v) => integers::<i32>(dae, v)?,
        None => Vec::new(),
    };
    if counts.len() != positions {
        let found = counts.len();
        let impact = if found < positions {
            Impact::Shape
        } else {
            Impact::None
        };
        dae.warn(
            impact,
            node,
            format!("expected weights for {positions} positions, found {found}"),
        );
    }
    let mut rows = Rows::default();
    let mut left = indices.chunks_exact(stride);
    let (mut missing, mut bad) = (0_usize, 0_usize);
    let mut first_bad = None;
    for (position, &count) in counts.iter().enumerate() {
        let mut found = 0;
        for pair in left.by_ref().take(count as usize) {
            found += 1;
            match (
                usize::try_from(pair[joint.offset]),
                usize::try_from(pair[weight.offset]),
            ) {
                (Ok(joint), Ok(weight)) if joint < joints && weight < values.len() => {
                    rows.pairs.push((joint as u32, values.row::<1>(weight)[0]));
                }
                _ => {
                    bad += 1;
                    let numbers = [joint, weight].map(|input| pair[input.offset]);
                    first_bad.get_or_insert((position, numbers));
                }
            }
        }
        missing = missing.saturating_add(count as usize - found);
        rows.ends.push(rows.pairs.len());
    }
    if missing > 0 || left.len() > 0 {
        dae.warn(
            Impact::Shape,
            node,
            "expected <v> as long as <vcount> says, found another length",
        );
    }
    if let Some((position, [joint, weight])) = first_bad {
        let limit = quoted(&format!("0 to {}", joints.saturating_sub(1)));
        let times = if bad == 1 { "time" } else { "times" };
        dae.warn(
            Impact::Shape,
            node,
            format!(
                "expected joints {limit} and weights that exist, found others {bad} {times}, first joint {joint} with weight {weight} at position {position} (from 0): left out"
            ),
        );
    }
    Ok(rows)
}
