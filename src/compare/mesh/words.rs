//! A comparison of meshes in words.

use super::numbers::{length, vector};
use super::{MeshComparison, NEARLY, place};
use std::fmt;

impl MeshComparison {
    /// A sentence on the vertices that differ where no cause accounts for them.
    fn unexplained(&self) -> Option<String> {
        if !self.is_unexplained() {
            return None;
        }
        if let Some(nearly) = &self.nearly {
            let percent = 100.0 * NEARLY;
            return Some(format!(
                "nearly, to within {percent} % of the size: {nearly}"
            ));
        }
        let differing = self.differing_vertices;
        let agreeing = self.vertices - differing;
        let place = match self.differing_bounds {
            _ if agreeing == 0 => "no vertex agrees".to_owned(),
            None => format!("{agreeing} of {} vertices agree", self.vertices),
            Some([low, high]) => format!(
                "{agreeing} of {} vertices agree; those that differ lie in A within {} to {}",
                self.vertices,
                vector(low),
                vector(high)
            ),
        };
        Some(format!(
            "B is not A moved, turned, scaled, rounded or in another order: {place}"
        ))
    }
}

impl fmt::Display for MeshComparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "differing vertices  {} of {} by more than {}",
            self.differing_vertices,
            self.vertices,
            length(self.tolerance)
        )?;
        writeln!(f, "largest distance    {}", length(self.max))?;
        let by_size = length(self.max_by_size);
        writeln!(f, "  by size           {by_size} of {}", length(self.size))?;
        writeln!(f, "mean distance       {}", length(self.mean))?;
        writeln!(f, "RMS distance        {}", length(self.rms))?;
        let triangles = if self.same_triangles {
            "the same"
        } else {
            "differ"
        };
        writeln!(
            f,
            "triangles           {triangles} ({} in A)",
            self.triangles
        )?;
        for (number, vertex) in self.worst.iter().enumerate() {
            let place = |[x, y, z]: [f32; 3]| format!("({x}, {y}, {z})");
            let from = if number == 0 { " (from 0)" } else { "" };
            writeln!(
                f,
                "  vertex {}{from}: {} apart, {} in A, {} in B",
                vertex.index,
                length(vertex.distance),
                place(vertex.a),
                place(vertex.b)
            )?;
        }
        for finding in &self.findings {
            writeln!(f, "found: {finding}")?;
        }
        if let Some(unexplained) = self.unexplained() {
            writeln!(f, "{unexplained}")?;
            if self.nearly.is_none() {
                place::fmt_places(f, &self.places)?;
            }
        }
        if self.differing_vertices <= self.allowed_vertices && !self.same_triangles {
            return f.write_str("failed: the triangles differ");
        }
        let verdict = if self.passed { "passed" } else { "failed" };
        write!(f, "{verdict}: at most {} may differ", self.allowed_vertices)
    }
}
