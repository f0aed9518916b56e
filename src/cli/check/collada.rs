//! What there is in a Collada file besides shapes.

use crate::io::dae::{DaeReport, UpAxis};
use serde::Serialize;
use std::collections::BTreeMap;

/// Contents of a Collada file besides its shapes.
#[derive(Debug, Serialize)]
pub(super) struct ColladaReport {
    up_axis: &'static str,
    meters_per_unit: f64,
    skins: usize,
    /// Range in the file; the shapes' weights have been divided by their sums.
    weight_sums: Option<[f32; 2]>,
    unweighted_vertices: usize,
    inverse_bind_difference: Option<Difference>,
    ignored: BTreeMap<String, usize>,
}

/// Largest difference between inverse bind matrices and scene.
#[derive(Debug, Serialize)]
struct Difference {
    joint: String,
    difference: f64,
}

impl ColladaReport {
    /// Lines of the report as text: label and value.
    pub(super) fn in_words(&self) -> Vec<(&'static str, String)> {
        let mut lines = vec![(
            "collada",
            format!("{} up, {} m a unit", self.up_axis, self.meters_per_unit),
        )];
        if self.skins > 0 {
            lines.push(("  skins", self.skins.to_string()));
        }
        if let Some([low, high]) = self.weight_sums {
            lines.push((
                "  weight sums",
                format!("{low:.4} to {high:.4} in the file"),
            ));
        }
        if self.unweighted_vertices > 0 {
            let count = self.unweighted_vertices;
            let which = if count == 1 {
                "vertex stays"
            } else {
                "vertices stay"
            };
            lines.push(("  unweighted", format!("{count} {which} at rest")));
        }
        if let Some(Difference { joint, difference }) = &self.inverse_bind_difference {
            let most = if *difference == 0.0 {
                "as in the scene".to_owned()
            } else {
                format!("differs from the scene by at most {difference:.1e}, at {joint}")
            };
            lines.push(("  bind pose", most));
        }
        for (what, count) in &self.ignored {
            lines.push(("  ignored", format!("{count} × {what}")));
        }
        lines
    }
}

impl From<DaeReport> for ColladaReport {
    fn from(report: DaeReport) -> Self {
        Self {
            up_axis: match report.space.up {
                UpAxis::X => "X",
                UpAxis::Y => "Y",
                UpAxis::Z => "Z",
            },
            meters_per_unit: report.space.meters,
            skins: report.skins,
            weight_sums: report.weight_sums.map(|(low, high)| [low, high]),
            unweighted_vertices: report.unweighted,
            inverse_bind_difference: report.worst_inverse_bind.map(|worst| Difference {
                joint: worst.joint,
                difference: worst.difference,
            }),
            ignored: report.ignored,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bind_pose_without_a_difference_is_reported_as_equal() {
        let lines = |difference| {
            let report = ColladaReport {
                up_axis: "Y",
                meters_per_unit: 1.0,
                skins: 1,
                weight_sums: None,
                unweighted_vertices: 1,
                inverse_bind_difference: Some(Difference {
                    joint: "Bone.002".to_owned(),
                    difference,
                }),
                ignored: BTreeMap::new(),
            };
            report.in_words()[2..]
                .iter()
                .map(|(_, words)| words.clone())
                .collect::<Vec<_>>()
        };
        assert_eq!(lines(0.0), ["1 vertex stays at rest", "as in the scene"]);
        let most = "differs from the scene by at most 1.5e-3, at Bone.002";
        assert_eq!(lines(0.0015)[1], most);
    }
}
