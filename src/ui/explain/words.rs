//! The formula in letters, with what a mistake changes of it.

use super::letters::{letter, raised};
use crate::diagnose::{
    AngleUnits, Chain, Divided, Factor, Formula, JointFormula, Offsets, Rotations, Shaped,
    VertexOrder,
};
use crate::ui::theme::Palette;
use egui::text::{LayoutJob, TextFormat};
use egui::{Align, Color32, FontId, Stroke, Ui};

/// What became of a part of the exact formula.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Mark {
    Same,
    Changed,
    LeftOut,
}

/// A part of a product.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Part {
    text: &'static str,
    /// Exponent.
    above: &'static str,
    mark: Mark,
}

/// A line such as `T = T(parent) · Offset · Rx · Ry · Rz`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Line {
    start: &'static str,
    parts: Vec<Part>,
}

fn part(text: &'static str, mark: Mark) -> Part {
    Part {
        text,
        above: "",
        mark,
    }
}

fn changed_if(changed: bool) -> Mark {
    if changed { Mark::Changed } else { Mark::Same }
}

fn left_out_if(left_out: bool) -> Mark {
    if left_out { Mark::LeftOut } else { Mark::Same }
}

/// The product of `factors`, which are in the order in which they come to a vertex.
pub(super) fn product(factors: &[Factor]) -> Line {
    let part = |factor: &Factor| {
        let (text, above) = letter(*factor);
        Part {
            text,
            above,
            mark: Mark::Same,
        }
    };
    Line {
        start: "",
        parts: factors.iter().rev().map(part).collect(),
    }
}

/// The lines of a formula: what is done to a vertex, and how T and B are made.
pub(super) fn lines(formula: &Formula) -> [Line; 3] {
    [vertex(formula), current(formula), bind(formula)]
}

fn vertex(formula: &Formula) -> Line {
    let exact = Formula::default();
    let in_order = formula.in_order_of_file();
    let mut parts = Vec::new();
    for (axis, mirror) in ["mirror x", "mirror y", "mirror z"].into_iter().enumerate() {
        if formula.written[axis] < 0.0 {
            parts.push(part(mirror, Mark::Changed));
        }
    }
    let are_others =
        in_order.vertex_order != VertexOrder::File || formula.joint_order != exact.joint_order;
    let weights = formula.weights;
    let is_scaled = weights.is_normalized || weights.rescaled != exact.weights.rescaled;
    let weight = match (is_scaled, weights.factor == exact.weights.factor) {
        (true, _) => "Σ w / Σw",
        (false, true) => "Σ w",
        (false, false) => "Σ 2 · w",
    };
    let factors = formula.factors.in_order();
    let mut weight = part(weight, changed_if(weights != exact.weights || are_others));
    if factors.is_empty() {
        weight.mark = Mark::LeftOut;
    }
    // The fourth coordinate, of the sum or of what each joint adds to it.
    let by_fourth = part("1/v₄", Mark::Changed);
    match formula.divided {
        Divided::Nothing => parts.push(weight),
        Divided::Sum => parts.extend([by_fourth, weight]),
        Divided::Each => parts.extend([weight, by_fourth]),
    }
    let exact = exact.factors.in_order();
    let is_kept = |factor: &Factor| factors.contains(factor);
    let as_part = |factor: &Factor, mark| {
        let (text, above) = letter(*factor);
        Part { text, above, mark }
    };
    if exact.iter().all(is_kept) || factors.iter().any(|factor| !exact.contains(factor)) {
        // All of them, in one order or another, or one in the place of another.
        let is_same = |(place, own): (usize, &Factor)| match factors.len() == exact.len() {
            true => exact[place] == *own,
            false => exact.contains(own),
        };
        let places = factors.iter().enumerate().rev();
        parts.extend(places.map(|(place, own)| as_part(own, changed_if(!is_same((place, own))))));
    } else {
        let all = exact.iter().rev();
        parts.extend(all.map(|factor| as_part(factor, left_out_if(!is_kept(factor)))));
    }
    // The skin's own matrix, which has placed the vertex where all is well.
    match formula.shaped {
        Shaped::Exactly => {}
        Shaped::Not => parts.push(part("M", Mark::LeftOut)),
        Shaped::Transposed | Shaped::TransposedAsPoints => parts.push(Part {
            above: "T",
            ..part("M", Mark::Changed)
        }),
    }
    parts.push(part("v", Mark::Same));
    Line {
        start: "v' =",
        parts,
    }
}

fn current(formula: &Formula) -> Line {
    let own = &formula.joint;
    let mut own_parts = vec![part("Offset", of_offsets(own.offsets))];
    let turns = rotations(own);
    if own.rotates_first {
        own_parts.splice(0..0, turns);
        for part in own_parts.iter_mut().filter(|part| part.mark == Mark::Same) {
            part.mark = Mark::Changed;
        }
    } else {
        own_parts.extend(turns);
    }
    chained("T =", "T(parent)", formula.chain, own_parts)
}

fn of_offsets(offsets: Offsets) -> Mark {
    match offsets {
        Offsets::All => Mark::Same,
        Offsets::None => Mark::LeftOut,
        Offsets::OfRoots
        | Offsets::ButOfRoots
        | Offsets::OfUnposed
        | Offsets::Twice
        | Offsets::TwiceOfPosed => Mark::Changed,
    }
}

fn bind(formula: &Formula) -> Line {
    let own = vec![part("Offset", of_offsets(formula.joint.bind_offsets))];
    chained("B =", "B(parent)", formula.bind_chain, own)
}

fn chained(start: &'static str, parent: &'static str, chain: Chain, own: Vec<Part>) -> Line {
    let mut parts = own;
    match chain {
        Chain::ParentOwn => parts.insert(0, part(parent, Mark::Same)),
        Chain::Own => parts.insert(0, part(parent, Mark::LeftOut)),
        Chain::OwnParent => parts.push(part(parent, Mark::Changed)),
        Chain::ParentsOwn
        | Chain::WithoutRotations
        | Chain::OwnParentRotation
        | Chain::OwnRotation
        | Chain::OwnRotationInPlace
        | Chain::OffsetsNotTurned
        | Chain::ParentAtRest
        | Chain::TurnsOwnParent => {
            parts.insert(0, part(parent, Mark::Changed));
        }
    }
    Line { start, parts }
}

fn rotations(own: &JointFormula) -> Vec<Part> {
    if own.rotations != Rotations::Exact {
        let is_transposed = own.rotations == Rotations::Transposed;
        return vec![Part {
            text: "(Rx · Ry · Rz)",
            above: if is_transposed { "T" } else { "" },
            mark: Mark::Changed,
        }];
    }
    let exact = [0, 1, 2];
    let turn = |(place, axis): (usize, usize)| {
        let is_turned = own.angles[axis] < 0.0;
        let is_left_out = own.angles[axis] == 0.0 || !own.has_pose;
        let is_converted = own.units[axis] == AngleUnits::Radians;
        let letters = match (own.units[axis], is_turned) {
            (AngleUnits::Degrees, _) => ["Rx(degrees)", "Ry(degrees)", "Rz(degrees)"],
            (AngleUnits::ConvertedTwice, _) => ["Rx(π/180 x)", "Ry(π/180 y)", "Rz(π/180 z)"],
            (AngleUnits::Complements, _) => ["Rx(90° - x)", "Ry(90° - y)", "Rz(90° - z)"],
            (AngleUnits::Radians, true) => ["Rx(-x)", "Ry(-y)", "Rz(-z)"],
            (AngleUnits::Radians, false) => ["Rx", "Ry", "Rz"],
        };
        let is_changed = own.order[place] != exact[place] || is_turned || !is_converted;
        let mark = if is_left_out {
            Mark::LeftOut
        } else {
            changed_if(is_changed)
        };
        part(letters[axis], mark)
    };
    own.order.into_iter().enumerate().map(turn).collect()
}

impl Line {
    /// The same with a word before it.
    pub(super) fn after(self, start: &'static str) -> Self {
        Self { start, ..self }
    }

    /// The same product, times the vertex.
    pub(super) fn times_vertex(mut self) -> Self {
        self.parts.push(part("v", Mark::Same));
        self
    }

    /// The line in letters, without what is left out.
    pub(super) fn spoken(&self) -> String {
        let parts = self.parts.iter().filter(|part| part.mark != Mark::LeftOut);
        let parts = parts.map(|part| format!("{}{}", part.text, raised(part.above)));
        let parts = parts.collect::<Vec<_>>().join(" · ");
        format!("{} {parts}", self.start).trim_start().to_owned()
    }

    /// The line with colors: what a mistake changes stands out, what it leaves out is struck.
    pub(super) fn laid_out(&self, ui: &Ui, size: f32, color: Color32) -> LayoutJob {
        let palette = Palette::of(ui.visuals());
        let mut job = LayoutJob::default();
        let text = |color: Color32| TextFormat {
            font_id: FontId::proportional(size),
            color,
            ..TextFormat::default()
        };
        job.append(self.start, 0.0, text(color));
        for (index, part) in self.parts.iter().enumerate() {
            let between = match index {
                0 if self.start.is_empty() => "",
                0 => " ",
                _ => " · ",
            };
            job.append(between, 0.0, text(palette.weak));
            let format = match part.mark {
                Mark::Same => text(color),
                Mark::Changed => text(palette.error),
                Mark::LeftOut => TextFormat {
                    strikethrough: Stroke::new(1.5, palette.error),
                    ..text(palette.weak)
                },
            };
            job.append(part.text, 0.0, format.clone());
            let above = TextFormat {
                font_id: FontId::proportional(size * 0.7),
                valign: Align::TOP,
                ..format
            };
            job.append(part.above, 0.0, above);
        }
        job
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnose::Mistake;

    fn spoken(id: &str, reading: usize) -> [String; 3] {
        let mut formula = Formula::default();
        let mistake = Mistake::find(id).unwrap();
        (mistake.readings[reading].make)(&mut formula);
        lines(&formula).map(|line| line.spoken())
    }

    const EXACT: [&str; 3] = [
        "v' = Σ w · T · B⁻¹ · v",
        "T = T(parent) · Offset · Rx · Ry · Rz",
        "B = B(parent) · Offset",
    ];

    #[test]
    fn the_exact_formula_is_the_assignment_s() {
        assert_eq!(lines(&Formula::default()).map(|line| line.spoken()), EXACT);
    }

    #[test]
    fn a_mistake_changes_its_part_and_no_other() {
        let [_, current, bind] = EXACT;
        let of_vertex = |id| spoken(id, 0);
        assert_eq!(
            of_vertex("no-inverse-bind"),
            ["v' = Σ w · T · v", current, bind]
        );
        assert_eq!(
            of_vertex("inverse-bind-only"),
            ["v' = Σ w · B⁻¹ · v", current, bind]
        );
        assert_eq!(
            of_vertex("bind-not-inverted"),
            ["v' = Σ w · T · B · v", current, bind]
        );
        assert_eq!(
            of_vertex("factors-swapped"),
            ["v' = Σ w · B⁻¹ · T · v", current, bind]
        );
        assert_eq!(spoken("pose-not-applied", 1), ["v' = v", current, bind]);
        // Of the first joint for all of them.
        assert_eq!(
            spoken("inverse-bind-shared", 0)[0],
            "v' = Σ w · T · B₁⁻¹ · v"
        );
        // In the frames of a Collada file.
        let of_file = |id| spoken(id, 1)[0].clone();
        assert_eq!(of_file("no-inverse-bind"), "v' = Σ w · T · R · A⁻¹ · v");
        assert_eq!(
            of_file("factors-swapped"),
            "v' = Σ w · A · B⁻¹ · A⁻¹ · T · R · A⁻¹ · v"
        );
        let of_joint = |id, reading: usize| spoken(id, reading)[1].clone();
        assert_eq!(of_joint("parent-missing", 1), "T = Offset · Rx · Ry · Rz");
        assert_eq!(
            of_joint("parent-order", 0),
            "T = Offset · Rx · Ry · Rz · T(parent)"
        );
        assert_eq!(
            of_joint("euler-zyx", 0),
            "T = T(parent) · Offset · Rz · Ry · Rx"
        );
        assert_eq!(
            of_joint("rotation-transposed", 0),
            "T = T(parent) · Offset · (Rx · Ry · Rz)ᵀ"
        );
        let first = "T = T(parent) · Rx · Ry · Rz · Offset";
        assert_eq!(of_joint("rotation-before-translation", 0), first);
        assert_eq!(
            of_joint("one-axis-ignored-y", 0),
            "T = T(parent) · Offset · Rx · Rz"
        );
        assert_eq!(
            of_joint("sign-flipped-z", 0),
            "T = T(parent) · Offset · Rx · Ry · Rz(-z)"
        );
        assert_eq!(spoken("bind-parent-missing", 0)[2], "B = Offset");
        assert_eq!(
            spoken("matrix-transposed", 1)[0],
            "v' = 1/v₄ · Σ w · B⁻ᵀ · Tᵀ · v"
        );
        assert_eq!(spoken("matrix-transposed", 3)[0], "v' = Σ w · Tᵀ · B⁻¹ · v");
        assert_eq!(
            spoken("mesh-mirrored", 0)[0],
            "v' = mirror x · Σ w · T · B⁻¹ · v"
        );
    }

    #[test]
    fn every_mistake_shows_in_the_formula() {
        for mistake in crate::diagnose::MISTAKES {
            for reading in mistake.readings {
                let mut formula = Formula::default();
                (reading.make)(&mut formula);
                let is_marked = |line: &Line| line.parts.iter().any(|p| p.mark != Mark::Same);
                // What only numbers vertices anew is in no product.
                let is_shown = formula.in_order_of_file() != Formula::default();
                let marked = lines(&formula).iter().any(is_marked);
                assert_eq!(marked, is_shown, "{} {}", mistake.id, reading.how);
            }
        }
    }
}
