//! The formula of a vertex as a table: a row for each joint with a weight, and the sum.

use super::Explained;
use super::arrows::{colors, heaviest_first};
use super::digits::{Digits, weight};
use super::matrices;
use super::vertex::Told;
use super::words::{Line, product};
use crate::diagnose::{Factor, Factors, Step, Term};
use crate::ui::shortened::shortened;
use crate::ui::theme::{Palette, number_font};
use egui::{
    Align2, Color32, FontId, Painter, Rect, Response, Sense, Stroke, TextStyle, Ui, Vec2,
    WidgetInfo, WidgetType, pos2, vec2,
};
use glam::{DMat4, DVec3};
use std::collections::BTreeSet;

const ROW: f32 = 19.0;
/// Widths of columns, in points: weights, a coordinate, and the space between two points.
const WEIGHT: f32 = 44.0;
const COORDINATE: f32 = 46.0;
const GAP: f32 = 10.0;
const LEAST_NAME: f32 = 92.0;
/// Least space between a name and the first number, in points.
const BESIDE_NAME: f32 = 4.0;
/// Width of the triangle and the swatch before a name.
const MARKS: f32 = 32.0;
/// Place of the matrices below a row, and the space between them.
const INDENT: f32 = 12.0;
const BETWEEN: Vec2 = vec2(6.0, 4.0);

/// The columns that there is room for.
struct Columns {
    factors: &'static [Factor],
    /// Index of the first factor whose points are shown; those of the others unfold.
    first: usize,
}

impl Columns {
    fn new(factors: Factors, width: f32) -> Self {
        let factors = factors.in_order();
        let point = 3.0 * COORDINATE + GAP;
        let room = ((width - LEAST_NAME - MARKS - WEIGHT) / point).floor() as usize;
        let first = (factors.len() + 1).saturating_sub(room.max(1));
        Self {
            factors,
            first: first.min(factors.len()),
        }
    }

    /// Number of points in a row.
    fn count(&self) -> usize {
        self.factors.len() - self.first + 1
    }

    /// Right end of a coordinate of the point at `index` of those in a row.
    fn right(&self, row: Rect, index: usize, axis: usize) -> f32 {
        let point = 3.0 * COORDINATE + GAP;
        let from_end = (self.count() - 1 - index) as f32 * point;
        row.right() - from_end - (2 - axis) as f32 * COORDINATE
    }

    fn weight(&self, row: Rect) -> f32 {
        row.right() - self.count() as f32 * (3.0 * COORDINATE + GAP)
    }
}

/// What a row says.
struct Row<'a> {
    name: &'a str,
    swatch: Option<Color32>,
    /// Whether its matrices are shown, if it has some.
    unfolded: Option<bool>,
    weight: Option<f64>,
    /// Points, of which the last ones fill the last columns.
    points: Vec<DVec3>,
    color: Color32,
    is_struck: bool,
}

/// A vertex in the mesh that is compared with the character.
#[derive(Clone, Copy)]
pub(super) struct Compared<'a> {
    /// File of the mesh.
    pub name: &'a str,
    /// In model space.
    pub at: DVec3,
}

/// Shows the table. Returns the joint whose row is under the pointer.
pub(super) fn show(
    ui: &mut Ui,
    explained: &Explained,
    told: &Told,
    compared: Option<Compared>,
    unfolded: &mut BTreeSet<usize>,
) -> Option<usize> {
    let palette = Palette::of(ui.visuals());
    let columns = Columns::new(told.formula.factors, ui.available_width());
    let (formula, digits) = (&told.vertex, told.digits);
    ui.spacing_mut().item_spacing.y = 0.0;
    titles(ui, &columns);
    let name = |joint: usize| &*explained.shape.character.skeleton().joints()[joint].name;
    let mut hovered = None;
    if compared.is_some() {
        // What is compared is in sight however many joints there are.
        sums(ui, &columns, told, compared);
        line(ui);
    }
    let colors = colors(&formula.terms);
    // What counts most is in view where there is little room.
    for index in heaviest_first(&formula.terms) {
        let term = &formula.terms[index];
        let own = if term.joint == term.weight_of {
            name(term.joint).to_owned()
        } else {
            // As short as may be: both names are in sight.
            format!("{}, w of {}", name(term.joint), name(term.weight_of))
        };
        let is_unfolded = unfolded.contains(&term.weight_of);
        let steps = term.steps.iter().skip(columns.first).map(|step| step.at);
        let row = Row {
            name: &own,
            swatch: Some(colors[index]),
            unfolded: Some(is_unfolded),
            weight: Some(term.weight),
            points: steps.chain([term.weighted]).collect(),
            color: palette.text,
            is_struck: false,
        };
        let response = row.show(ui, &columns, digits, &spoken(told, term, &own));
        if response.hovered() {
            hovered = Some(term.joint);
        }
        if response.clicked() && !unfolded.remove(&term.weight_of) {
            unfolded.insert(term.weight_of);
        }
        if is_unfolded {
            unfold(ui, term, &own, digits);
        }
    }
    for &(joint, unused) in &formula.left_out {
        let row = Row {
            weight: Some(unused),
            is_struck: true,
            ..Row::plain(name(joint), Vec::new(), palette.weak)
        };
        row.show(ui, &columns, digits, &format!("{}: left out", name(joint)));
    }
    if compared.is_none() {
        line(ui);
        sums(ui, &columns, told, None);
    }
    hovered
}

/// A line between the terms and their sum.
fn line(ui: &Ui) {
    let y = ui.cursor().min.y + 1.0;
    let stroke = Stroke::new(1.0, Palette::of(ui.visuals()).line);
    ui.painter().hline(ui.max_rect().x_range(), y, stroke);
}

/// The sum, what it should be where a mistake is made, and what it is in a compared mesh.
fn sums(ui: &mut Ui, columns: &Columns, told: &Told, compared: Option<Compared>) {
    let palette = Palette::of(ui.visuals());
    let (formula, digits) = (&told.vertex, told.digits);
    let weights = formula.terms.iter().map(|term| term.weight).sum::<f64>();
    let sum = Row {
        weight: (!formula.terms.is_empty()).then_some(weights),
        ..Row::plain("v', the sum", vec![formula.sum], palette.strong)
    };
    sum.show(ui, columns, digits, "Sum");
    if formula.sum != told.exact.sum {
        let off = digits.length(formula.sum.distance(told.exact.sum));
        let name = format!("v' should be here, {off} away");
        let exact = Row::plain(&name, vec![told.exact.sum], palette.weak);
        exact.show(ui, columns, digits, "Right");
    }
    if let Some(compared) = compared {
        let off = digits.length(compared.at.distance(told.exact.sum));
        let name = format!("v' in {}, {off} off", compared.name);
        let theirs = Row::plain(&name, vec![compared.at], palette.strong);
        theirs.show(ui, columns, digits, &name);
    }
    if formula.terms.is_empty() {
        let why = if told.exact.terms.is_empty() {
            "No joint has a weight for this vertex, so it stays at rest."
        } else {
            "Nothing moves the vertex."
        };
        ui.label(why);
    }
}

fn titles(ui: &mut Ui, columns: &Columns) {
    let color = Palette::of(ui.visuals()).weak;
    let (row, _) = ui.allocate_exact_size(vec2(ui.available_width(), ROW), Sense::hover());
    let font = TextStyle::Small.resolve(ui.style());
    let painter = ui.painter();
    // Long products are set smaller, so as not to run into those beside them.
    let title = |right: f32, line: Line| {
        let of_size = |size: f32| painter.layout_job(line.laid_out(ui, size, color));
        let wide = of_size(font.size).size().x / (3.0 * COORDINATE - GAP);
        let text = of_size(font.size / wide.max(1.0));
        let at = pos2(right - text.size().x, row.center().y - text.size().y / 2.0);
        painter.galley(at, text, color);
    };
    title(columns.weight(row), product(&[]).after("w"));
    for index in 0..columns.count() {
        let factors = (columns.first + index + 1).min(columns.factors.len());
        let line = product(&columns.factors[..factors]).times_vertex();
        let is_weighted = index + 1 == columns.count();
        let line = if is_weighted {
            line.after("w ·")
        } else {
            line
        };
        title(columns.right(row, index, 2), line);
    }
    let at = pos2(row.left() + MARKS, row.center().y);
    painter.text(at, Align2::LEFT_CENTER, "Joint", font.clone(), color);
}

/// A row for assistive technology: its numbers, all of them.
fn spoken(told: &Told, term: &Term, name: &str) -> String {
    let factors = told.formula.factors.in_order();
    let title = |count: usize| product(&factors[..count]).times_vertex();
    let mut text = format!("{name}: w {}", weight(term.weight));
    for (count, step) in (1..).zip(&term.steps) {
        let at = point(step.at, told.digits);
        text += &format!(", {} {at}", title(count).spoken());
    }
    let title = title(factors.len()).after("w ·").spoken();
    text + &format!(", {title} {}", point(term.weighted, told.digits))
}

pub(super) fn point(at: DVec3, digits: Digits) -> String {
    let [x, y, z] = at.to_array().map(|value| digits.length(value));
    format!("({x}, {y}, {z})")
}

/// The matrices of a term, in the order of the product, and the product.
fn unfold(ui: &mut Ui, term: &Term, name: &str, digits: Digits) {
    let steps = term.steps.iter().rev();
    let mut all: Vec<(Vec<Factor>, DMat4)> =
        steps.map(|step| (vec![step.factor], step.matrix)).collect();
    if term.steps.len() > 1 {
        let product_of = |product: DMat4, step: &Step| step.matrix * product;
        let matrix = term.steps.iter().fold(DMat4::IDENTITY, product_of);
        let factors = term.steps.iter().map(|step| step.factor);
        all.push((factors.collect(), matrix));
    }
    let room = ui.available_width() - INDENT + BETWEEN.x;
    let in_row = (room / (matrices::WIDTH + BETWEEN.x)).floor().max(1.0) as usize;
    for row in all.chunks(in_row) {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = BETWEEN.x;
            ui.add_space(INDENT - BETWEEN.x);
            let text = Palette::of(ui.visuals()).text;
            for (factors, matrix) in row {
                let title = product(factors);
                let called = format!("{} of {name}", title.spoken());
                let title = title.laid_out(ui, 12.0, text);
                matrices::show(ui, title, &called, matrix, digits, factors.len() > 1);
            }
        });
        ui.add_space(BETWEEN.y);
    }
}

impl<'a> Row<'a> {
    fn plain(name: &'a str, points: Vec<DVec3>, color: Color32) -> Self {
        Self {
            name,
            swatch: None,
            unfolded: None,
            weight: None,
            points,
            color,
            is_struck: false,
        }
    }

    /// Shows the row, called `called` with its points where these are not in the name already.
    fn show(&self, ui: &mut Ui, columns: &Columns, digits: Digits, called: &str) -> Response {
        let sense = if self.unfolded.is_some() {
            Sense::click()
        } else {
            Sense::hover()
        };
        let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), ROW), sense);
        let palette = Palette::of(ui.visuals());
        let painter = ui.painter().with_clip_rect(rect.intersect(ui.clip_rect()));
        if self.unfolded.is_some() && (response.hovered() || response.has_focus()) {
            painter.rect_filled(rect, 3.0, palette.field_hovered);
        }
        let middle = rect.center().y;
        let small = TextStyle::Small.resolve(ui.style());
        if let Some(unfolded) = self.unfolded {
            let sign = if unfolded { "⏷" } else { "⏵" };
            let at = pos2(rect.left() + 8.0, middle);
            painter.text(at, Align2::CENTER_CENTER, sign, small, palette.weak);
        }
        if let Some(swatch) = self.swatch {
            let place = Rect::from_center_size(pos2(rect.left() + 22.0, middle), vec2(10.0, 10.0));
            painter.rect_filled(place, 2.0, swatch);
        }
        let font = TextStyle::Body.resolve(ui.style());
        let from = rect.left() + MARKS;
        let room = self.numbers_from(columns, rect) - from - BESIDE_NAME;
        let name = shortened(ui, self.name, &font, room);
        let is_shortened = name != self.name;
        let at = pos2(from, middle);
        self.text(&painter, at, Align2::LEFT_CENTER, &name, font);
        let text = |right: f32, value: String| {
            self.text(
                &painter,
                pos2(right, middle),
                Align2::RIGHT_CENTER,
                &value,
                number_font(),
            );
        };
        if let Some(of_joint) = self.weight {
            text(columns.weight(rect), weight(of_joint));
        }
        let first = self.first_column(columns);
        for (index, at) in self.points.iter().enumerate() {
            for (axis, value) in at.to_array().into_iter().enumerate() {
                text(
                    columns.right(rect, first + index, axis),
                    digits.length(value),
                );
            }
        }
        let points: Vec<String> = self.points.iter().map(|at| point(*at, digits)).collect();
        let called = match self.unfolded {
            Some(_) => called.to_owned(),
            None => format!("{called} {}", points.join(" ")),
        };
        response.widget_info(|| WidgetInfo::labeled(WidgetType::Button, true, &called));
        if is_shortened {
            return response.on_hover_text(self.name);
        }
        response
    }

    /// Index of the column that its first point is in.
    fn first_column(&self, columns: &Columns) -> usize {
        columns.count() - self.points.len().min(columns.count())
    }

    /// Left end of its numbers in `rect`.
    fn numbers_from(&self, columns: &Columns, rect: Rect) -> f32 {
        let first = self.first_column(columns);
        match self.weight {
            Some(_) => columns.weight(rect) - WEIGHT,
            None if first < columns.count() => columns.right(rect, first, 0) - COORDINATE,
            None => rect.right(),
        }
    }

    fn text(&self, painter: &Painter, at: egui::Pos2, align: Align2, text: &str, font: FontId) {
        let place = painter.text(at, align, text, font, self.color);
        if self.is_struck {
            painter.hline(
                place.x_range(),
                place.center().y,
                Stroke::new(1.0, self.color),
            );
        }
    }
}
