use super::told::with_messages;
use super::{Differences, Finding, Pair};
use serde::Serialize;
use std::fmt;
use std::str::FromStr;

/// How to compare pictures, and what still passes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PictureOptions {
    /// A pixel differs if a channel does by more than this, of 255.
    pub threshold: u8,
    /// How many pixels may differ.
    pub allowed: Allowance,
}

/// How many elements may differ. Written `12`, or `0.5%`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Allowance {
    /// So many.
    Count(u64),
    /// A share 0..=1: of the drawn pixels of pictures, of the vertices of meshes.
    Share(f64),
}

/// What there is to say about two pictures.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PictureComparison {
    /// Whether no more pixels differ than are allowed.
    pub passed: bool,
    /// Pixels a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Above which difference of a channel a pixel differs.
    pub threshold: u8,
    /// How many pixels may differ.
    pub allowed_pixels: u64,
    /// Pixels that were left out.
    pub ignored_pixels: u64,
    /// Pixel by pixel.
    #[serde(flatten)]
    pub differences: Differences,
    /// Structural similarity, 1 if equal; `None` for pictures too small.
    pub ssim: Option<f64>,
    /// Mean perceived difference, 0 if equal, at most 1.
    pub flip: f64,
    /// What is wrong.
    #[serde(serialize_with = "with_messages")]
    pub findings: Vec<Finding>,
}

impl Pair<'_> {
    /// Every measure at once, and what is wrong.
    pub fn compare(&self, options: &PictureOptions) -> PictureComparison {
        let differences = self.differences(options.threshold);
        let allowed_pixels = options.allowed.of(differences.drawn_pixels);
        PictureComparison {
            passed: differences.differing_pixels <= allowed_pixels,
            width: self.width(),
            height: self.height(),
            threshold: options.threshold,
            allowed_pixels,
            ignored_pixels: self.kept().len() as u64 - differences.compared_pixels,
            differences,
            ssim: self.ssim(),
            flip: self.flip().mean,
            findings: self.findings(),
        }
    }
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

impl fmt::Display for PictureComparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Differences {
            compared_pixels,
            differing_pixels,
            drawn_pixels,
            ..
        } = self.differences;
        let percent = |total: u64| 100.0 * differing_pixels as f64 / total.max(1) as f64;
        write!(
            f,
            "differing pixels    {differing_pixels} of {compared_pixels} ({:.4} %) by more than {}",
            percent(compared_pixels),
            self.threshold
        )?;
        if drawn_pixels < compared_pixels {
            let drawn_differing = self.differences.drawn_pixels_above(self.threshold);
            let percent = 100.0 * drawn_differing as f64 / drawn_pixels.max(1) as f64;
            write!(
                f,
                "\n  of the drawn      {drawn_differing} of {drawn_pixels} ({percent:.4} %)"
            )?;
        }
        if let Some(area) = self.differences.differing_area {
            write!(f, "\n  within            {area} (x, y, width, height)")?;
        }
        if self.ignored_pixels > 0 {
            write!(f, "\nignored pixels      {}", self.ignored_pixels)?;
        }
        write!(f, "\nlargest difference  {} of 255", self.differences.max)?;
        write!(
            f,
            "\nmean difference     {:.6} of 255",
            self.differences.mean
        )?;
        if self.differences.psnr.is_finite() {
            write!(f, "\nPSNR                {:.3} dB", self.differences.psnr)?;
        } else {
            write!(f, "\nPSNR                infinite (no color differs)")?;
        }
        match self.ssim {
            Some(ssim) => write!(f, "\nSSIM                {ssim:.6}")?,
            None => write!(f, "\nSSIM                none (needs 11×11 pixels)")?,
        }
        write!(f, "\nFLIP                {:.6}", self.flip)?;
        for finding in &self.findings {
            write!(f, "\nfound: {finding}")?;
        }
        if differing_pixels > 0 && self.findings.is_empty() {
            write!(f, "\nno single cause explains the differences")?;
        }
        let verdict = if self.passed { "passed" } else { "failed" };
        write!(f, "\n{verdict}: at most {} may differ", self.allowed_pixels)
    }
}
