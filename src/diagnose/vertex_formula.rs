//! The formula of skinning at work on one vertex, with all that is between the vertex at rest and in
//! the pose.

use super::formula::{Factor, Factors, Formula};
use super::joint_transforms::Joints;
use super::model::Model;
use super::skin::keep;
use crate::character::{Character, Pose};
use glam::{DMat4, DVec3, DVec4, Vec4Swizzles};

/// How a formula moves a vertex: v' = Σ wᵢ Tᵢ Bᵢ⁻¹ v, or what a mistake makes of it. Points are in
/// model space, but for those of a joint's frame between two factors. A fourth coordinate that is not 1 is not told.
#[derive(Clone, Debug, PartialEq)]
pub struct VertexFormula {
    /// Index of the vertex, from 0.
    pub vertex: usize,
    /// Where it is in the bind pose, as the program has it.
    pub rest: DVec3,
    /// What is summed, in the order of the joints in the file. Empty for a vertex without weights, and
    /// where the formula moves nothing: these stay at rest.
    pub terms: Vec<Term>,
    /// Joints of which the file has a weight that does not count, with that weight.
    pub left_out: Vec<(usize, f64)>,
    /// Factor of each coordinate of the sum, by which it is also divided by its fourth one where it is.
    pub written: DVec3,
    /// Where it is in the pose.
    pub sum: DVec3,
}

/// What one joint adds to the sum.
#[derive(Clone, Debug, PartialEq)]
pub struct Term {
    /// Joint that moves the vertex.
    pub joint: usize,
    /// Joint whose weight in the file it is.
    pub weight_of: usize,
    /// The weight as it counts.
    pub weight: f64,
    /// The factors in the order in which they come to the vertex, and where each takes it.
    pub steps: Vec<Step>,
    /// Where the joint alone would take the vertex.
    pub moved: DVec3,
    /// That place times the weight.
    pub weighted: DVec3,
}

/// One factor.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// Which it is.
    pub factor: Factor,
    /// Its matrix.
    pub matrix: DMat4,
    /// Where it takes the vertex from where the one before did.
    pub at: DVec3,
}

impl VertexFormula {
    /// `formula` at work on the vertex of `character` in `pose` that the file has at `vertex`; `None`
    /// if there is none.
    pub fn new(
        character: &Character,
        pose: &Pose,
        formula: &Formula,
        vertex: usize,
    ) -> Option<Self> {
        let model = Model::new(character);
        let rest = *model.positions.get(vertex)?;
        let formula = formula.in_order_of_file();
        let joints = Joints::new(&model, pose, &formula);
        let shaped = joints.shape(&formula) * rest.extend(1.0);
        let rest = shaped.xyz();
        let source = model.source(formula.vertex_order, vertex);
        let influences = model.influences_by(formula.weights.rows, source.weights);
        let mut kept = Vec::new();
        keep(influences, formula.weights, &mut kept);
        kept.sort_by_key(|&(index, _)| index);
        let first = kept
            .first()
            .and_then(|&(index, _)| joints.moved_by(formula.weights.columns, index));
        let mut whole = DVec4::ZERO;
        let term = |&(index, weight): &(usize, f64)| {
            let joint = joints.moved_by(formula.weights.columns, index)?;
            let mut at = shaped;
            let step = |&factor: &Factor| {
                let of = match factor {
                    Factor::InverseBindOfFirst => first.unwrap_or(joint),
                    other => other.joint(index, joint),
                };
                let matrix = joints.matrix(factor, of);
                at = matrix * at;
                Step {
                    factor,
                    matrix,
                    at: at.xyz(),
                }
            };
            let steps = formula.factors.in_order().iter().map(step).collect();
            let moved = formula.divided.each(at);
            whole += moved * weight;
            Some(Term {
                joint,
                weight_of: index,
                weight,
                steps,
                moved: moved.xyz(),
                weighted: moved.xyz() * weight,
            })
        };
        let moves = formula.factors != Factors::Nothing;
        let terms: Vec<Term> = kept.iter().filter(|_| moves).filter_map(term).collect();
        let counts = |joint: usize| terms.iter().any(|term| term.weight_of == joint);
        let in_file = influences
            .iter()
            .map(|one| (one.joint as usize, f64::from(one.weight)));
        let written = DVec3::from_array(formula.written) * formula.divided.factor(whole);
        let sum = if influences.is_empty() || !moves {
            rest
        } else {
            terms.iter().map(|term| term.weighted).sum()
        };
        Some(Self {
            vertex,
            rest,
            left_out: in_file.filter(|&(joint, _)| !counts(joint)).collect(),
            terms,
            written,
            sum: sum * written,
        })
    }
}
