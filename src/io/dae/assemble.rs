//! Puts the instances of a scene together: meshes and weights.

use super::document::{Dae, FARTHEST, Impact, MOST_ELEMENTS};
use super::instances::{Binding, Instance};
use super::materials::{BoundMaterial, Materials};
use super::meshes::{Attribute, Primitive};
use super::report::DaeReport;
use super::rest_pose::RestPose;
use super::visual_scene::SceneNode;
use crate::character::{Attachments, Influence};
use crate::geometry::{Corner, MaterialGroup, MeshBuilder};
use crate::io::Diagnostic;
use crate::math::cofactors;
use glam::{DMat3, DMat4, Mat3, Vec2, Vec3};
use std::collections::HashMap;

/// A mesh under construction, with the weights of its positions so far.
#[derive(Default)]
pub(super) struct Part {
    pub builder: MeshBuilder,
    pub attachments: Attachments,
    /// What the mesh of each skin was placed by.
    pub placements: Vec<SkinPlacement>,
}

/// What the mesh of a skin is placed by at rest.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct SkinPlacement {
    /// From the bind pose to the scene's rest pose, in our space; `None` where that differs from joint to joint.
    pub rest: Option<DMat4>,
    /// The skin's own matrix.
    pub bind_shape: DMat4,
    /// The joints of the skin's own list; `None` for what is none.
    pub joints: Vec<Option<u32>>,
}

/// Puts instances together.
pub(super) struct Assembler<'d, 'a> {
    pub dae: &'d Dae<'a>,
    pub materials: Materials<'a>,
    pub report: DaeReport,
    elements: usize,
}

impl<'d, 'a> Assembler<'d, 'a> {
    pub fn new(dae: &'d Dae<'a>, materials: Materials<'a>, report: DaeReport) -> Self {
        Self {
            dae,
            materials,
            report,
            elements: 0,
        }
    }

    /// Adds `instance` to `builder`, brought into our space as `placement` says.
    ///
    /// # Errors
    /// If the file has grown too large by it.
    pub fn add(
        &mut self,
        builder: &mut MeshBuilder,
        instance: &Instance<'a>,
        placement: &Placement,
    ) -> Result<(), Diagnostic> {
        let geometry = &instance.geometry;
        let corners = geometry.primitives.iter().map(|p| p.positions.len());
        self.elements += geometry.positions.len() + corners.sum::<usize>() / 3;
        if self.elements > MOST_ELEMENTS {
            let message =
                format!("expected at most {MOST_ELEMENTS} positions and triangles, found more");
            return Err(self.dae.error(instance.xml, message));
        }
        let base = builder.positions().len() as u32;
        builder.extend_positions(self.positions(instance, placement));
        let turns = Turns::new(placement, geometry.positions.len());
        let bound = self.materials.bind(self.dae, instance.xml);
        let mut unbound: HashMap<&str, _> = HashMap::new();
        for primitive in &geometry.primitives {
            let material = primitive.material.as_deref().and_then(|symbol| {
                bound.get(symbol).cloned().or_else(|| {
                    unbound
                        .entry(symbol)
                        .or_insert_with(|| self.unbound(instance, symbol))
                        .clone()
                })
            });
            let set = material.as_ref().and_then(|material| material.texture_set);
            let start = builder.triangle_count();
            push_triangles(builder, primitive, set, base, &turns);
            if let Some(material) = material {
                builder.push_group(MaterialGroup {
                    triangles: start..builder.triangle_count(),
                    material: material.material,
                });
            }
        }
        Ok(())
    }

    fn unbound(&mut self, instance: &Instance<'a>, symbol: &str) -> Option<BoundMaterial> {
        let found = self.materials.called(self.dae, symbol);
        if found.is_none() {
            let symbol = super::quoted(symbol);
            let message =
                format!("expected a material for {symbol}, found none: the shape's color is used");
            self.dae.warn(Impact::Color, instance.xml, message);
        }
        found
    }

    fn positions(&self, instance: &Instance<'a>, placement: &Placement) -> Vec<Vec3> {
        let mut far = 0;
        let positions = instance
            .geometry
            .positions
            .iter()
            .enumerate()
            .map(|(at, position)| {
                let ours = placement.of(at).transform_point3(position.as_dvec3());
                // Not a number compares as false.
                if ours.abs().max_element() < FARTHEST && !ours.is_nan() {
                    ours.as_vec3()
                } else {
                    far += 1;
                    Vec3::ZERO
                }
            })
            .collect();
        if far > 0 {
            let message = format!(
                "expected positions within {FARTHEST:e} of the origin, found {far} others: put there"
            );
            self.dae.warn(Impact::Shape, instance.xml, message);
        }
        positions
    }

    /// Adds a skin to `part` in the scene's rest pose. `joint_of_node` gives the rig's joint for
    /// each node. The node of `instance` does not move the skin.
    ///
    /// # Errors
    /// If the file has grown too large by it.
    pub fn add_skin(
        &mut self,
        part: &mut Part,
        instance: &Instance<'a>,
        binding: &Binding<'a>,
        nodes: &[SceneNode<'a>],
        joint_of_node: &HashMap<usize, u32>,
    ) -> Result<(), Diagnostic> {
        let rest = RestPose::new(binding, &instance.geometry.positions, nodes, joint_of_node);
        self.check_inverse_binds(instance, &rest);
        let Part {
            builder,
            attachments,
            placements,
        } = part;
        let base = builder.positions().len();
        self.add_weights(attachments, instance, binding, joint_of_node);
        let ours_from_file = self.report.space.ours_from_file();
        let bind_shape = binding.skin.bind_shape;
        let as_a_whole = Some(ours_from_file * rest.first()).filter(|_| rest.as_a_whole);
        placements.push(SkinPlacement {
            rest: as_a_whole,
            bind_shape,
            joints: binding.rig_joints(joint_of_node),
        });
        if rest.as_a_whole {
            let placement = Placement::Whole(ours_from_file * rest.first() * bind_shape);
            return self.add(builder, instance, &placement);
        }
        let ours_from_mesh = |position: usize| {
            let influences = attachments.of_vertex(base + position);
            ours_from_file * rest.of_influences(influences) * bind_shape
        };
        self.add(builder, instance, &Placement::Each(&ours_from_mesh))
    }

    fn check_inverse_binds(&mut self, instance: &Instance<'a>, rest: &RestPose) {
        if rest.singular > 0 {
            let count = rest.singular;
            let message = format!(
                "expected inverse bind matrices that can be inverted, found {count} that cannot: left out"
            );
            self.dae.warn(Impact::Shape, instance.xml, message);
        }
        let Some(worst) = &rest.worst else { return };
        self.report.add_inverse_bind(worst);
        if !rest.as_a_whole {
            let joint = super::quoted(&worst.joint);
            let message = format!(
                "expected inverse bind matrices that agree with the scene's rest pose, found a difference of {:.3e} at {joint}: the mesh is shown in the scene's rest pose",
                worst.difference
            );
            self.dae.warn(Impact::Shape, instance.xml, message);
        }
    }

    /// The weights of a skin's positions, divided by their sums.
    fn add_weights(
        &mut self,
        attachments: &mut Attachments,
        instance: &Instance<'a>,
        binding: &Binding<'a>,
        joint_of_node: &HashMap<usize, u32>,
    ) {
        let joints = binding.rig_joints(joint_of_node);
        let (mut unusable, mut without) = (0, 0);
        let mut row: Vec<(u32, f32)> = Vec::new();
        for position in 0..instance.geometry.positions.len() {
            row.clear();
            let known = |&&(joint, _): &&(u32, f32)| joints[joint as usize].is_some();
            row.extend(binding.skin.weights.get(position).iter().filter(known));
            // Of equal weights the one first in the controller's list counts as larger.
            row.sort_by_key(|&(joint, _)| joint);
            row.dedup_by(|again, first| {
                let same = again.0 == first.0;
                first.1 += if same { again.1 } else { 0.0 };
                same
            });
            row.retain(|&(_, weight)| weight != 0.0);
            let sum: f32 = row.iter().map(|&(_, weight)| weight).sum();
            if row.is_empty() {
                self.report.unweighted += 1;
                without += 1;
            } else if sum > 0.0 && sum.is_finite() {
                self.report.add_weight_sum(sum);
            } else {
                unusable += 1;
                row.clear();
            }
            attachments.push_vertex(row.iter().filter_map(|&(joint, weight)| {
                let joint = joints[joint as usize]?;
                let weight = weight / sum;
                weight.is_finite().then_some(Influence { joint, weight })
            }));
        }
        // Some positions without weights are common; a mesh that hardly moves looks like a fault of the program.
        let all = instance.geometry.positions.len();
        if without * 10 >= all * 9 && all > 0 {
            let message = format!(
                "expected weights that are not 0, found none at {without} of {all} positions: these stay at rest"
            );
            self.dae.warn(Impact::Shape, instance.xml, message);
        }
        if unusable > 0 {
            let message = format!(
                "expected weights with a positive sum, found others at {unusable} positions: these stay at rest"
            );
            self.dae.warn(Impact::Shape, instance.xml, message);
        }
    }

    /// Binds all positions of `instance` to one joint.
    pub fn add_rigid(&mut self, part: &mut Part, instance: &Instance<'a>, joint: u32) {
        for _ in &instance.geometry.positions {
            let influence = Influence { joint, weight: 1.0 };
            part.attachments.push_vertex([influence]);
        }
    }
}

/// The transform that brings a mesh into our space.
pub(super) enum Placement<'p> {
    /// One for all positions.
    Whole(DMat4),
    /// One for each position, by its index in the mesh.
    Each(&'p dyn Fn(usize) -> DMat4),
}

impl Placement<'_> {
    fn of(&self, position: usize) -> DMat4 {
        match self {
            Self::Whole(ours_from_mesh) => *ours_from_mesh,
            Self::Each(ours_from_mesh) => ours_from_mesh(position),
        }
    }
}

/// Effect of a placement on normals and winding.
enum Turns {
    Whole(Turn),
    Each(Vec<Turn>),
}

impl Turns {
    fn new(placement: &Placement, positions: usize) -> Self {
        match placement {
            Placement::Whole(ours_from_mesh) => Self::Whole(Turn::new(*ours_from_mesh)),
            Placement::Each(_) => {
                let turns = (0..positions).map(|position| Turn::new(placement.of(position)));
                Self::Each(turns.collect())
            }
        }
    }

    fn of(&self, position: u32) -> &Turn {
        match self {
            Self::Whole(turn) => turn,
            Self::Each(turns) => &turns[position as usize],
        }
    }
}

/// Effect of a transform on normals and on the winding of triangles.
struct Turn {
    normals: Mat3,
    mirrors: bool,
}

impl Turn {
    fn new(ours_from_mesh: DMat4) -> Self {
        let linear = DMat3::from_mat4(ours_from_mesh);
        let mirrors = linear.determinant() < 0.0;
        // Of about unit size, so that no product of a unit's scale leaves the numbers of `f32`.
        let columns = [linear.x_axis, linear.y_axis, linear.z_axis];
        let size = columns.map(|column| column.abs().max_element());
        let size = size.into_iter().fold(f64::MIN_POSITIVE, f64::max);
        let cofactors = cofactors((linear * size.recip()).as_mat3());
        Self {
            normals: if mirrors { -cofactors } else { cofactors },
            mirrors,
        }
    }

    fn normal(&self, normal: [f32; 3]) -> Option<Vec3> {
        let normal = Vec3::from_array(normal).as_dvec3().try_normalize()?;
        (self.normals * normal.as_vec3()).try_normalize()
    }
}

fn push_triangles(
    builder: &mut MeshBuilder,
    primitive: &Primitive,
    set: Option<usize>,
    base: u32,
    turns: &Turns,
) {
    let texture = texture_of_set(&primitive.texture, set);
    let normals = primitive.normals.as_ref();
    // Corners share their normals, where there are not more normals than corners, and one turn is that of all.
    let turned: Option<Vec<Option<Vec3>>> = match (normals, turns) {
        (Some(Attribute { source, rows }), Turns::Whole(turn)) if source.len() <= rows.len() => {
            Some(source.rows().map(|row| turn.normal(row)).collect())
        }
        _ => None,
    };
    let normal = |at: usize| {
        let normals = normals?;
        let row = normals.rows[at] as usize;
        match &turned {
            Some(turned) => turned[row],
            None => {
                let turn = turns.of(primitive.positions[at]);
                turn.normal(normals.source.row(row))
            }
        }
    };
    let corner = |at: usize| Corner {
        position: base + primitive.positions[at],
        normal: normal(at),
        texture: texture
            .map(|texture| Vec2::from_array(texture.source.row(texture.rows[at] as usize))),
    };
    for first in (0..primitive.positions.len() / 3).map(|triangle| 3 * triangle) {
        let [a, b, c] = [first, first + 1, first + 2].map(corner);
        let mirrors = turns.of(primitive.positions[first]).mirrors;
        builder.push_triangle(if mirrors { [a, c, b] } else { [a, b, c] });
    }
}

/// The texture coordinates of the set asked for, else of the lowest.
fn texture_of_set(texture: &[(usize, Attribute)], set: Option<usize>) -> Option<&Attribute> {
    let asked = texture.iter().find(|(of_set, _)| Some(*of_set) == set);
    let lowest = || texture.iter().min_by_key(|(of_set, _)| *of_set);
    asked.or_else(lowest).map(|(_, attribute)| attribute)
}
