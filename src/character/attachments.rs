/// One joint's share in a vertex.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Influence {
    /// Index of the joint.
    pub joint: u32,
    /// Its weight, as the file has it.
    pub weight: f32,
}

/// Which joints move which vertices: every non-zero weight of the file, none dropped, none
/// renormalised, stored as runs one after the other.
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
