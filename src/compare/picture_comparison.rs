use super::rules::with_messages;
use super::{Allowance, Area, CompareError, Differences, FigureOff, Finding, Pair};
use crate::geometry::{GroundColors, Picture};
use crate::steps::{Pace, Steps, at_once};
use serde::Serialize;
use std::fmt;
use std::sync::Arc;

/// Options of a comparison of pictures, and what still passes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PictureOptions {
    /// A pixel differs if a channel does by more than this, of 255.
    pub threshold: u8,
    /// How many pixels may differ.
    pub allowed: Allowance,
}

/// Result of a comparison of two pictures.
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
    /// How similar they look, and what is wrong.
    #[serde(flatten)]
    pub judgment: Judgment,
}

/// Measures that take longer than counting pixels: how similar two pictures look, and why they
/// differ.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Judgment {
    /// Structural similarity, 1 if equal; `None` for pictures too small.
    pub ssim: Option<f64>,
    /// Mean perceived difference, 0 if equal, at most 1.
    pub flip: f64,
    /// What is wrong, the most telling first.
    #[serde(serialize_with = "with_messages")]
    pub findings: Vec<Finding>,
    /// The area round what is drawn, which findings are placed in; see [`Pair::figure`].
    pub figure: Option<Area>,
    /// What differs of what is drawn, but for edges and lines, from which the parts of a scene that do can be told.
    #[serde(skip)]
    pub off: Option<FigureOff>,
}

/// A comparison of two pictures in two halves, [`PictureJob::measure`] and [`PictureJob::judge`].
/// It owns all that it needs, so that it can be carried out elsewhere than where it was begun.
#[derive(Clone, Debug)]
pub struct PictureJob {
    /// A, the reference.
    pub a: Arc<Picture>,
    /// B.
    pub b: Arc<Picture>,
    /// A pixel differs if a channel does by more than this, of 255.
    pub threshold: u8,
    /// Areas that are left out.
    pub ignore: Vec<Area>,
    /// What figures stand on in a picture that has no background of one color.
    pub ground: Option<GroundColors>,
}

/// Result of the quick half of a [`PictureJob`].
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// Pixel by pixel.
    pub differences: Differences,
    /// See [`Pair::heat_map`].
    pub heat_map: Picture,
}

/// Pixels that a step of a [`PictureJob`] works on once: a few milliseconds at most, also where the
/// processor is slow.
const STEP: usize = 1 << 14;

impl PictureJob {
    /// Counts and heat map: milliseconds for a picture of a million pixels. An error if the pictures
    /// cannot be compared (see [`Pair::new`]).
    pub fn measure(self) -> Steps<'static, Result<Measured, CompareError>> {
        self.measure_by(STEP)
    }

    /// Similarity and causes: up to seconds. An error if the pictures cannot be compared (see
    /// [`Pair::new`]).
    pub fn judge(self) -> Steps<'static, Result<Judgment, CompareError>> {
        self.judge_by(STEP)
    }

    fn measure_by(self, step: usize) -> Steps<'static, Result<Measured, CompareError>> {
        Steps::new(step, |pace| async move {
            let pair = self.pair(&pace).await?;
            Ok(Measured {
                differences: pair.paced_differences(self.threshold, &pace).await,
                heat_map: pair.paced_heat_map(&pace).await,
            })
        })
    }

    fn judge_by(self, step: usize) -> Steps<'static, Result<Judgment, CompareError>> {
        Steps::new(step, |pace| async move {
            let pair = self.pair(&pace).await?;
            Ok(pair.paced_judge(&pace).await)
        })
    }

    async fn pair(&self, pace: &Pace) -> Result<Pair<'_>, CompareError> {
        let pair = Pair::paced_new(&self.a, &self.b, &self.ignore, pace).await?;
        Ok(pair.on_ground(self.ground))
    }
}

impl Pair<'_> {
    /// How similar the pictures look, and what is wrong.
    pub fn judge(&self) -> Judgment {
        at_once(|pace| async move { self.paced_judge(&pace).await })
    }

    /// The same in steps, of which each measure has about as large a share as it takes time.
    async fn paced_judge(&self, pace: &Pace) -> Judgment {
        pace.begin(0.0..0.2);
        let ssim = self.paced_ssim(pace).await;
        pace.begin(0.2..0.8);
        let flip = self.paced_flip(pace).await.mean;
        pace.begin(0.8..1.0);
        Judgment {
            ssim,
            flip,
            findings: self.paced_findings(pace).await,
            figure: self.paced_figure(pace).await,
            off: self.paced_figure_off(pace).await,
        }
    }

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
            judgment: self.judge(),
        }
    }
}

impl PictureComparison {
    /// Whether the outlines of what is drawn differ, and nothing is known that explains it.
    pub fn differs_in_outline(&self) -> bool {
        let mut findings = self.judgment.findings.iter();
        findings.any(|finding| matches!(finding, Finding::Outline { .. }))
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
            let drawn_differing = self.differences.drawn_differing_pixels;
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
        match self.judgment.ssim {
            Some(ssim) => write!(f, "\nSSIM                {ssim:.6}")?,
            None => write!(f, "\nSSIM                none (needs 11×11 pixels)")?,
        }
        write!(f, "\nFLIP                {:.6}", self.judgment.flip)?;
        let mut told = String::new();
        for finding in &self.judgment.findings {
            write!(f, "\nfound: {finding}")?;
            let place = finding.area().zip(self.judgment.figure);
            let place = place.map(|(area, figure)| area.place_in(figure));
            if let Some(place) = place.filter(|place| *place != told && !finding.is_everywhere()) {
                write!(f, "\n       {place}")?;
                told = place;
            }
        }
        let findings = &self.judgment.findings;
        if differing_pixels > 0 && findings.iter().all(Finding::is_beside_others) {
            let differences = match findings.is_empty() {
                true => "differences",
                false => "other differences",
            };
            write!(f, "\nno single cause explains the {differences}")?;
        }
        let verdict = if self.passed { "passed" } else { "failed" };
        write!(f, "\n{verdict}: at most {} may differ", self.allowed_pixels)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compare::test_pictures::{noise, painted};
    use proptest::prelude::*;

    /// A gray square in a dark picture, `right` pixels further right.
    fn square(right: usize) -> Arc<Picture> {
        let (width, height) = (64, 48);
        let gray = |i: usize| {
            let (x, y) = (i % width, i / width);
            let inside = (20 + right..40 + right).contains(&x) && (10..30).contains(&y);
            match inside {
                true => (80 + (x - right) * y % 100) as u8,
                false => 26,
            }
        };
        Arc::new(Picture {
            width: width as u32,
            height: height as u32,
            rgba: (0..width * height)
                .flat_map(|i| [gray(i), gray(i), gray(i), 255])
                .collect(),
        })
    }

    fn job(b: Arc<Picture>, ignore: &[&str]) -> PictureJob {
        PictureJob {
            a: square(0),
            b,
            threshold: 0,
            ignore: ignore.iter().map(|area| area.parse().unwrap()).collect(),
            ground: None,
        }
    }

    #[test]
    fn equal_pictures_have_no_differing_pixel_and_nothing_is_wrong() {
        let job = job(square(0), &[]);
        let measured = job.clone().measure().finish().unwrap();
        let counts = &measured.differences;
        assert_eq!((counts.differing_pixels, counts.max), (0, 0));
        assert_eq!(counts.psnr, f64::INFINITY);
        let (pixels, _) = measured.heat_map.rgba.as_chunks::<4>();
        assert!(pixels.iter().all(|&pixel| pixel == [0, 0, 0, 255]));
        let equal = Judgment {
            ssim: Some(1.0),
            flip: 0.0,
            findings: Vec::new(),
            figure: "20,10,20,20".parse().ok(),
            off: None,
        };
        assert_eq!(job.judge().finish().unwrap(), equal);
    }

    #[test]
    fn both_steps_leave_out_the_ignored_areas_and_the_first_heeds_the_threshold() {
        let mut b = (*square(0)).clone();
        for (x, y, by) in [(5, 5, 9), (60, 40, 3)] {
            b.rgba[4 * (64 * y + x)] += by;
        }
        let b = Arc::new(b);
        let differing = |job: &PictureJob| {
            job.clone()
                .measure()
                .finish()
                .unwrap()
                .differences
                .differing_pixels
        };
        let whole = job(Arc::clone(&b), &[]);
        assert_eq!(differing(&whole), 2);
        assert_eq!(
            differing(&PictureJob {
                threshold: 3,
                ..whole.clone()
            }),
            1
        );
        let part = job(b, &["0,0,32,48"]);
        assert_eq!(differing(&part), 1);
        assert_eq!(part.clone().measure().finish().unwrap().differences.max, 3);
        let rounding = |job: &PictureJob| match job.clone().judge().finish().unwrap().findings[..] {
            [Finding::NearlySame { others, .. }] => others,
            ref other => panic!("{other:?}"),
        };
        assert_eq!((rounding(&whole), rounding(&part)), (1, 0));
    }

    #[test]
    fn a_movement_is_judged_and_has_a_sentence() {
        let judgment = job(square(3), &[]).judge().finish().unwrap();
        let sentences: Vec<String> = judgment.findings.iter().map(Finding::sentence).collect();
        assert_eq!(sentences, ["B is A moved 3 pixels right."]);
        assert!(judgment.ssim < Some(0.99) && judgment.flip > 0.0);
    }

    #[test]
    fn ignoring_everything_leaves_nothing_to_compare() {
        let job = job(square(3), &["0,0,64,48"]);
        assert_eq!(
            job.clone().measure().finish().err(),
            Some(CompareError::NothingToCompare)
        );
        assert_eq!(
            job.judge().finish().err(),
            Some(CompareError::NothingToCompare)
        );
    }

    /// A picture of the given kind for each cause that takes its own way to be found: with a figure
    /// elsewhere, larger, lit in another way, in noise, over another background, and all transparent.
    fn changed(kind: usize) -> Picture {
        let (width, height) = (330, 200);
        if kind == 0 {
            return noise(width, height, 0..=255, 7);
        }
        painted(width, height, |x, y| {
            let (by, radius) = match kind {
                2 => (5.0, 60.0),
                3 => (0.0, 75.0),
                _ => (0.0, 60.0),
            };
            let [right, down] = [x as f32 - 150.0 - by, y as f32 - 95.0];
            let light = (1.0 - (right - 20.0).hypot(down + 15.0) / 12.0).max(0.0);
            let light = if kind == 4 { 90.0 * light } else { 0.0 };
            let is_slab = (260..300).contains(&x) && (30..45).contains(&y);
            match right.hypot(down) < radius {
                true => {
                    let shade = 90.0 + 0.3 * right + 0.2 * down;
                    let [r, g, b] = [1.0, 0.7, 0.5].map(|part| (part * shade + light) as u8);
                    [r, g, b, if kind == 6 { 0 } else { 255 }]
                }
                false if is_slab => [51, 77, 179, if kind == 6 { 0 } else { 255 }],
                false if kind == 5 => [200, 210, 220, 255],
                false => [26, 26, 26, if kind == 6 { 0 } else { 255 }],
            }
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(40))]

        #[test]
        fn in_steps_of_any_size_every_bit_is_that_of_the_whole(
            kinds in (0..7_usize, 0..7_usize),
            step in prop_oneof![1..50_000_usize, Just(usize::MAX)],
            masked in any::<bool>(),
        ) {
            let job = PictureJob {
                a: Arc::new(changed(kinds.0)),
                b: Arc::new(changed(kinds.1)),
                threshold: 3,
                ignore: if masked { vec!["10,20,180,90".parse().unwrap()] } else { Vec::new() },
                ground: None,
            };
            let pair = Pair::new(&job.a, &job.b, &job.ignore).unwrap();
            let measured = in_steps(job.clone().measure_by(step));
            let whole = Measured {
                differences: pair.differences(3),
                heat_map: pair.heat_map(),
            };
            prop_assert_eq!(measured.unwrap(), whole);
            let judgment = in_steps(job.clone().judge_by(step)).unwrap();
            prop_assert_eq!(judgment, pair.judge());
        }
    }

    /// The result of all steps, between which the part that is done never falls.
    fn in_steps<T>(mut steps: Steps<T>) -> T {
        let mut part = 0.0;
        loop {
            if let Some(result) = steps.step() {
                return result;
            }
            assert!((part..=1.0).contains(&steps.part()));
            part = steps.part();
        }
    }
}
