//! How much may differ in a comparison that passes.

use std::str::FromStr;

/// How many elements may differ. Written `12`, or `0.5%`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Allowance {
    /// So many.
    Count(u64),
    /// A share 0..=1: of the drawn pixels of pictures, of the vertices of meshes.
    Share(f64),
}

impl Allowance {
    /// The greatest number that may differ, of `total`.
    pub fn of(self, total: u64) -> u64 {
        match self {
            Self::Count(count) => count,
            Self::Share(share) => (share * total as f64) as u64,
        }
    }
}

impl Default for Allowance {
    fn default() -> Self {
        Self::Count(0)
    }
}

impl FromStr for Allowance {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong =
            || format!("expected a number such as 12, or a share such as 0.1%, found “{text}”");
        match text.strip_suffix('%') {
            Some(percent) => match percent.trim().parse::<f64>() {
                Ok(percent) if (0.0..=100.0).contains(&percent) => Ok(Self::Share(percent / 100.0)),
                _ => Err(wrong()),
            },
            None => text.parse().map(Self::Count).map_err(|_| wrong()),
        }
    }
}
