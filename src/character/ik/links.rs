use glam::DVec3;

/// Links of less than this part of the longest one do not turn: no direction can be told.
const NO_LENGTH: f64 = 1e-9;

/// The links of a chain that have a length, from its first joint at the origin.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Links {
    /// Which of the chain's joints turns the link.
    pub places: Vec<usize>,
    /// Positive.
    pub lengths: Vec<f64>,
    /// Unit vectors, in model space.
    pub directions: Vec<DVec3>,
    finite: bool,
}

impl Links {
    /// From a chain's bones in model space, of which those without a length are left out.
    pub fn new(bones: &[DVec3]) -> Self {
        let longest = bones.iter().map(|bone| bone.length()).fold(0.0, f64::max);
        let mut links = Self {
            finite: bones.iter().all(|bone| bone.is_finite()),
            ..Self::default()
        };
        for (place, bone) in bones.iter().enumerate() {
            let length = bone.length();
            if let Some(direction) = bone.try_normalize()
                && length > NO_LENGTH * longest
            {
                links.places.push(place);
                links.lengths.push(length);
                links.directions.push(direction);
            }
        }
        links
    }

    /// Whether there is something to turn, and nothing infinite in it.
    pub fn is_sound(&self) -> bool {
        self.finite && !self.lengths.is_empty() && self.total().is_finite()
    }

    /// How far the chain reaches when it is straight.
    pub fn total(&self) -> f64 {
        self.lengths.iter().sum()
    }

    /// How near to its first joint the chain can bring its end.
    pub fn least(&self) -> f64 {
        let longest = self.lengths.iter().copied().fold(0.0, f64::max);
        (2.0 * longest - self.total()).max(0.0)
    }

    /// The same links in other directions.
    pub fn along(&self, directions: Vec<DVec3>) -> Self {
        Self {
            directions,
            ..self.clone()
        }
    }

    /// Where the end is.
    pub fn end(&self) -> DVec3 {
        let links = self.lengths.iter().zip(&self.directions);
        links.map(|(&length, &direction)| length * direction).sum()
    }

    /// Where the joints are, then the end; the first joint is at the origin.
    pub fn points(&self) -> Vec<DVec3> {
        let mut points = vec![DVec3::ZERO];
        let mut at = DVec3::ZERO;
        for (&length, &direction) in self.lengths.iter().zip(&self.directions) {
            at += length * direction;
            points.push(at);
        }
        points
    }
}
