/// One joint's share in a vertex.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Influence {
    /// Index of the joint.
    pub joint: u32,
    /// Its weight: as an `.attach` file has it; of a Collada file, divided by the vertex' sum.
    pub weight: f32,
}

/// Which joints move which vertices: every non-zero weight of the file, none dropped, stored as
/// runs one after the other. They need not add up to 1.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Attachments {
    influences: Vec<Influence>,
    /// Start of each vertex' run, and the end of the last: one more than there are vertices.
    starts: Vec<u32>,
}

/// Why weights do not fit a skeleton.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum AttachmentsError {
    /// A weight names a joint past the end.
    #[error("vertex {vertex}: expected a joint below {joints}, found {joint}")]
    NoSuchJoint {
        /// Index of the vertex.
        vertex: usize,
        /// The joint named.
        joint: u32,
        /// How many joints there are.
        joints: usize,
    },
}

impl Attachments {
    /// No vertices yet; [`Attachments::push_vertex`] adds them in order.
    pub fn new() -> Self {
        Self {
            influences: Vec::new(),
            starts: vec![0],
        }
    }

    /// Adds the next vertex with its influences; zero weights are left out, for they move nothing.
    pub fn push_vertex(&mut self, influences: impl IntoIterator<Item = Influence>) {
        self.influences
            .extend(influences.into_iter().filter(|i| i.weight != 0.0));
        if self.starts.is_empty() {
            self.starts.push(0);
        }
        self.starts.push(self.influences.len() as u32);
    }

    /// How many vertices there are.
    pub fn vertex_count(&self) -> usize {
        self.starts.len().saturating_sub(1)
    }

    /// The joints that move `vertex`, which must be below [`Attachments::vertex_count`].
    pub fn of_vertex(&self, vertex: usize) -> &[Influence] {
        &self.influences[self.starts[vertex] as usize..self.starts[vertex + 1] as usize]
    }

    /// The influences of all vertices, in order.
    pub fn vertices(&self) -> impl Iterator<Item = &[Influence]> {
        self.starts
            .windows(2)
            .map(|run| &self.influences[run[0] as usize..run[1] as usize])
    }

    /// The largest number of joints that move one vertex.
    pub fn most_influences(&self) -> usize {
        self.vertices().map(<[Influence]>::len).max().unwrap_or(0)
    }

    /// At most `most` influences a vertex: the largest, of equals the one that comes first, divided
    /// by their sum. What programs with a fixed number of influences show, for comparison.
    pub fn limited(&self, most: usize) -> Self {
        let mut limited = Self::new();
        let mut kept = Vec::new();
        for influences in self.vertices() {
            kept.clear();
            kept.extend_from_slice(influences);
            // Stable: equals stay in order.
            kept.sort_by(|a, b| b.weight.total_cmp(&a.weight));
            kept.truncate(most);
            let sum: f32 = kept.iter().map(|influence| influence.weight).sum();
            let scale = if sum > 0.0 { sum.recip() } else { 1.0 };
            limited.push_vertex(kept.iter().map(|influence| Influence {
                weight: influence.weight * scale,
                ..*influence
            }));
        }
        limited
    }

    /// Checks that every joint named is below `joints`.
    ///
    /// # Errors
    /// Names the first vertex whose joint is not.
    pub fn check(&self, joints: usize) -> Result<(), AttachmentsError> {
        for (vertex, influences) in self.vertices().enumerate() {
            if let Some(bad) = influences.iter().find(|i| i.joint as usize >= joints) {
                return Err(AttachmentsError::NoSuchJoint {
                    vertex,
                    joint: bad.joint,
                    joints,
                });
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn weights(pairs: &[(u32, f32)]) -> impl Iterator<Item = Influence> {
        pairs
            .iter()
            .map(|&(joint, weight)| Influence { joint, weight })
    }

    #[test]
    fn the_largest_are_kept_of_equals_the_first_and_divided_by_their_sum() {
        let mut all = Attachments::new();
        all.push_vertex(weights(&[
            (7, 0.1),
            (3, 0.25),
            (5, 0.1),
            (1, 0.5),
            (0, 0.05),
        ]));
        all.push_vertex(weights(&[]));
        all.push_vertex(weights(&[(2, 0.5)]));
        let three = all.limited(3);
        let sum = 0.5 + 0.25 + 0.1;
        let kept: Vec<Influence> =
            weights(&[(1, 0.5 / sum), (3, 0.25 / sum), (7, 0.1 / sum)]).collect();
        assert_eq!(three.of_vertex(0).len(), 3);
        for (found, expected) in three.of_vertex(0).iter().zip(&kept) {
            assert_eq!(found.joint, expected.joint);
            assert!((found.weight - expected.weight).abs() < 1e-7);
        }
        assert!(three.of_vertex(1).is_empty());
        assert_eq!(
            three.of_vertex(2),
            [Influence {
                joint: 2,
                weight: 1.0
            }]
        );
    }
}
