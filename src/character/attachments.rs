/// Influence of one joint on a vertex.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Influence {
    /// Index of the joint.
    pub joint: u32,
    /// Weight: as in an `.attach` file; of a Collada file, divided by the vertex' sum.
    pub weight: f32,
}

/// Influences of the joints on all vertices: every non-zero weight of the file, none dropped,
/// stored as one run per vertex. The weights of a vertex need not add up to 1.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Attachments {
    influences: Vec<Influence>,
    /// Start of each vertex' run, and the end of the last: one entry more than there are vertices.
    starts: Vec<u32>,
}

/// Reason why weights do not fit a skeleton.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum AttachmentsError {
    /// A weight names a joint that does not exist.
    #[error("vertex {vertex}: expected a joint below {joints}, found {joint}")]
    NoSuchJoint {
        /// Index of the vertex.
        vertex: usize,
        /// Index of the joint that is named.
        joint: u32,
        /// Number of joints.
        joints: usize,
    },
}

impl Attachments {
    /// No vertices; [`Attachments::push_vertex`] adds them in order.
    pub fn new() -> Self {
        Self {
            influences: Vec::new(),
            starts: vec![0],
        }
    }

    /// Appends a vertex with its influences; zero weights are left out, for they move nothing.
    pub fn push_vertex(&mut self, influences: impl IntoIterator<Item = Influence>) {
        self.influences
            .extend(influences.into_iter().filter(|i| i.weight != 0.0));
        if self.starts.is_empty() {
            self.starts.push(0);
        }
        self.starts.push(self.influences.len() as u32);
    }

    /// The joint with the largest weight of a vertex with these influences; `None` without any.
    pub fn strongest(influences: &[Influence]) -> Option<u32> {
        let most = influences
            .iter()
            .max_by(|a, b| a.weight.total_cmp(&b.weight));
        most.map(|influence| influence.joint)
    }

    /// Number of vertices.
    pub fn vertex_count(&self) -> usize {
        self.starts.len().saturating_sub(1)
    }

    /// Influences of `vertex`, which must be below [`Attachments::vertex_count`].
    pub fn of_vertex(&self, vertex: usize) -> &[Influence] {
        &self.influences[self.starts[vertex] as usize..self.starts[vertex + 1] as usize]
    }

    /// Influences of all vertices, in order.
    pub fn vertices(&self) -> impl Iterator<Item = &[Influence]> {
        self.starts
            .windows(2)
            .map(|run| &self.influences[run[0] as usize..run[1] as usize])
    }

    /// Estimated memory, in bytes.
    pub fn memory(&self) -> usize {
        size_of_val(&*self.influences) + size_of_val(&*self.starts)
    }

    /// Largest number of influences of a vertex.
    pub fn most_influences(&self) -> usize {
        self.vertices().map(<[Influence]>::len).max().unwrap_or(0)
    }

    /// The same with at most `most` influences per vertex: the largest, of equals the first ones,
    /// divided by their sum, as in programs with a fixed number of influences.
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

    /// Checks that every joint that is named is below `joints`.
    ///
    /// # Errors
    /// The first vertex whose joint is not.
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
    fn the_largest_weights_are_kept_of_equals_the_first_and_divided_by_their_sum() {
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
