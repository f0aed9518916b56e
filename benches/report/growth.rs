//! How a cost grows: what several sizes cost, and the exponent of the line through their logarithms.

use plotters::prelude::{
    ChartBuilder, Circle, Color, IntoDrawingArea, IntoLogRange, LineSeries, RGBColor, SVGBackend,
    WHITE,
};
use std::ops::Range;
use std::path::Path;

const SIZE: (u32, u32) = (560, 360);
/// Labels of an axis, at most.
const LABELS: usize = 5;
const GRID: RGBColor = RGBColor(225, 225, 225);
const LINE: RGBColor = RGBColor(150, 150, 150);
const POINTS: RGBColor = RGBColor(31, 100, 180);

/// What was measured of one thing that grows.
pub struct Growth {
    /// What is done.
    pub what: String,
    /// What there is more of from one size to the next.
    pub of: &'static str,
    /// Each size with its cost.
    pub costs: Vec<(f64, f64)>,
}

impl Growth {
    /// The exponent: 0 for a cost that stays, 1 for one that doubles when the size does.
    pub fn exponent(&self) -> f64 {
        self.slope_and_middle().0
    }

    /// The slope of the line through the logarithms of sizes and costs, and a point of it.
    fn slope_and_middle(&self) -> (f64, (f64, f64)) {
        let points = || self.costs.iter().map(|(size, cost)| (size.ln(), cost.ln()));
        let count = self.costs.len() as f64;
        let middle = points().fold((0.0, 0.0), |sum, p| {
            (sum.0 + p.0 / count, sum.1 + p.1 / count)
        });
        let products = points().map(|p| (p.0 - middle.0) * (p.1 - middle.1));
        let squares = points().map(|p| (p.0 - middle.0) * (p.0 - middle.0));
        (products.sum::<f64>() / squares.sum::<f64>(), middle)
    }

    /// Name of the file of the plot.
    pub fn file_name(&self) -> String {
        let words = self.what.split(|c: char| !c.is_ascii_alphanumeric());
        let words: Vec<String> = words
            .filter(|word| !word.is_empty())
            .map(str::to_lowercase)
            .collect();
        format!("{}.svg", words.join("-"))
    }

    /// Draws the costs over the sizes, both by their logarithms, with the line through them.
    pub fn plot(&self, path: &Path) -> Result<(), Box<dyn std::error::Error>> {
        let area = SVGBackend::new(path, SIZE).into_drawing_area();
        area.fill(&WHITE)?;
        let (slope, middle) = self.slope_and_middle();
        let line = |size: f64| (middle.1 + slope * (size.ln() - middle.0)).exp();
        let caption = format!("{}: exponent {slope:.2}", self.what);
        let mut chart = ChartBuilder::on(&area)
            .caption(caption, ("sans-serif", 15))
            .margin(12)
            .margin_right(48)
            .x_label_area_size(42)
            .y_label_area_size(64)
            .build_cartesian_2d(
                around(self.costs.iter().map(|cost| cost.0)).log_scale(),
                around(self.costs.iter().map(|cost| cost.1)).log_scale(),
            )?;
        chart
            .configure_mesh()
            .x_labels(LABELS)
            .y_labels(LABELS)
            .x_desc(self.of)
            .y_desc("ms")
            .bold_line_style(GRID)
            .light_line_style(WHITE.mix(0.0))
            .x_label_formatter(&|size| plain(*size))
            .y_label_formatter(&|cost| plain(*cost))
            .draw()?;
        let ends = [self.costs.first(), self.costs.last()];
        let ends = ends
            .into_iter()
            .flatten()
            .map(|&(size, _)| (size, line(size)));
        chart.draw_series(LineSeries::new(ends, LINE))?;
        let circles = self
            .costs
            .iter()
            .map(|&at| Circle::new(at, 4, POINTS.filled()));
        chart.draw_series(circles)?;
        area.present()?;
        Ok(())
    }
}

/// A range with room at both ends.
fn around(numbers: impl Iterator<Item = f64>) -> Range<f64> {
    let (least, most) = numbers.fold((f64::INFINITY, 0.0_f64), |(least, most), number| {
        (least.min(number), most.max(number))
    });
    least / 1.6..most * 1.6
}

/// A number without an exponent, as a person writes it.
fn plain(number: f64) -> String {
    match number {
        _ if number >= 1e6 => format!("{} million", number / 1e6),
        // Labels are one digit times a power of ten, but for what rounding adds.
        _ => format!("{}", (number * 1e6).round() / 1e6),
    }
}
