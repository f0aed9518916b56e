//! The report as one page that needs nothing else: pictures and style are in it, and its policy
//! keeps a browser from fetching anything. It is XML as well as HTML.

mod results;

use super::canvas::Color;
use super::report::{MistakeGroup, Report};
use super::style::STYLE;
use super::thumbnail::{AGREES, ERRORS, GHOST, LARGEST_ERROR, ONLY_EXACT, ONLY_THEIRS};
use std::collections::BTreeMap;
use std::fmt::{Display, Write};

/// Names of a mistake's group that are shown at once.
const SHOWN_NAMES: usize = 12;

impl Report {
    /// The page.
    pub fn to_html(&self) -> String {
        let mut page = self.begun_page(&self.title);
        page.head(self);
        page.sections(self);
        page.mistakes(self);
        page.tests(self);
        page.submissions(self);
        page.ended()
    }

    /// A page about each submission alone, with its path, in their order: for who made it.
    pub fn to_pages(&self) -> impl Iterator<Item = (&str, String)> {
        self.submissions
            .iter()
            .enumerate()
            .map(|(number, submission)| {
                let mut page = self.begun_page(&format!("{}: {}", self.title, submission.name));
                page.add(format_args!("<h1>{}</h1>\n", Escaped(&self.title)));
                page.submission(self, number, submission, true);
                page.tests(self);
                (&*submission.page, page.ended())
            })
    }

    fn begun_page(&self, title: &str) -> Page {
        let mut page = Page::default();
        let title = Escaped(title);
        page.add(format_args!(
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n\
             <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; \
             style-src 'unsafe-inline'\"/>\n<title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n"
        ));
        page
    }
}

impl Page {
    fn ended(mut self) -> String {
        self.add(format_args!(
            "<footer>Pictures show what a submission gives, colored by how far each vertex is from the \
             exact result, before the exact mesh in light gray. Each result says what its mistakes leave of \
             which section's points; the shares are those of the rubric.</footer>\n</body>\n</html>\n"
        ));
        self.0
    }
}

/// Text of a page, in which markup and what no page can hold is replaced.
struct Escaped<'a>(&'a str);

impl Display for Escaped<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.0.chars().try_for_each(|c| match c {
            '&' => f.write_str("&amp;"),
            '<' => f.write_str("&lt;"),
            '>' => f.write_str("&gt;"),
            '"' => f.write_str("&quot;"),
            '\n' | '\t' => f.write_char(c),
            '\u{fffe}' | '\u{ffff}' => f.write_char(char::REPLACEMENT_CHARACTER),
            c if c.is_control() => f.write_char(char::REPLACEMENT_CHARACTER),
            c => f.write_char(c),
        })
    }
}

/// A page that is being written.
#[derive(Default)]
struct Page(String);

impl Page {
    fn add(&mut self, text: std::fmt::Arguments) {
        // Writing to a string never fails.
        let _ = self.0.write_fmt(text);
    }

    fn head(&mut self, report: &Report) {
        let title = Escaped(&report.title);
        let count = report.submissions.len();
        let all_right = report
            .submissions
            .iter()
            .filter(|one| one.summaries().is_empty());
        let (all_right, plural) = (all_right.count(), if count == 1 { "" } else { "s" });
        self.add(format_args!(
            "<h1>{title}</h1>\n<p class=\"dim\">{count} submission{plural}"
        ));
        self.middle(report, all_right);
        let open = report.submissions.iter().filter(|one| one.not_graded > 0.0);
        match open.count() {
            0 => {}
            1 => self.add(format_args!(
                " One submission still needs points given by hand."
            )),
            open => self.add(format_args!(
                " {open} submissions still need points given by hand."
            )),
        }
        self.add(format_args!("</p>\n"));
    }

    /// What submissions have on average: a share of what is graded so far where points are still to be
    /// given, which are not as many for each.
    fn middle(&mut self, report: &Report, all_right: usize) {
        let Some(first) = report.submissions.first() else {
            return;
        };
        self.add(format_args!(", {all_right} right in every test."));
        let is_open = report.submissions.iter().any(|one| one.not_graded > 0.0);
        let graded = report.submissions.iter().filter(|one| one.graded() > 0.0);
        let mut all: Vec<f64> = graded
            .map(|one| match is_open {
                true => 100.0 * one.points / one.graded(),
                false => one.points,
            })
            .collect();
        if all.is_empty() {
            return;
        }
        all.sort_by(f64::total_cmp);
        let mean = all.iter().sum::<f64>() / all.len() as f64;
        let median = (all[(all.len() - 1) / 2] + all[all.len() / 2]) / 2.0;
        match is_open {
            true => self.add(format_args!(
                " Of what is graded so far the mean is {mean:.0} %, the median {median:.0} %."
            )),
            false => self.add(format_args!(
                " Of {} points the mean is {mean:.1}, the median {median:.1}.",
                first.possible
            )),
        }
    }

    fn sections(&mut self, report: &Report) {
        self.add(format_args!(
            "<h2>Points by section</h2>\n<div class=\"wide\"><table>\n<thead><tr><th>Section</th>\
             <th class=\"number\">Possible</th><th class=\"number\">Mean</th><th></th></tr></thead>\n<tbody>\n"
        ));
        for section in &report.sections {
            let points = report.submissions.iter();
            let points = points.filter_map(|one| *one.sections.get(&section.section)?);
            let points: Vec<f64> = points.collect();
            let mean = points.iter().sum::<f64>() / points.len().max(1) as f64;
            let share = if section.possible > 0.0 {
                (mean / section.possible).min(1.0)
            } else {
                0.0
            };
            let name = section.name();
            let (name, extra) = (Escaped(&name), if section.extra { " (extra)" } else { "" });
            self.add(format_args!(
                "<tr><td>{name}<span class=\"dim\">{extra}</span></td><td class=\"number\">{}</td>",
                section.possible
            ));
            if points.is_empty() {
                let given = match section.extra {
                    true => "none given",
                    false => "not graded yet",
                };
                self.add(format_args!(
                    "<td class=\"number dim\">–</td><td class=\"dim\">by hand, {given}</td></tr>\n"
                ));
            } else {
                let of = match points.len() {
                    count if count == report.submissions.len() => String::new(),
                    count => format!(" <span class=\"dim\">({count} graded)</span>"),
                };
                self.add(format_args!(
                    "<td class=\"number\">{mean:.1}{of}</td><td><span class=\"of\"><span class=\"bar\" \
                     style=\"width:{:.0}%\"></span></span></td></tr>\n",
                    100.0 * share
                ));
            }
        }
        self.add(format_args!("</tbody></table></div>\n"));
    }

    fn mistakes(&mut self, report: &Report) {
        if report.mistakes.is_empty() {
            return;
        }
        self.add(format_args!(
            "<h2>Mistakes</h2>\n<div class=\"wide\"><table>\n<thead><tr><th>Mistake</th><th>Section</th>\
             <th class=\"number\">Submissions</th><th>Who</th></tr></thead>\n<tbody>\n"
        ));
        let numbers: BTreeMap<&str, usize> = report
            .submissions
            .iter()
            .enumerate()
            .map(|(index, one)| (&*one.name, index))
            .collect();
        let most = report.mistakes[0].submissions.len();
        for group in &report.mistakes {
            self.mistake(group, &numbers, most);
        }
        self.add(format_args!("</tbody></table></div>\n"));
    }

    fn mistake(&mut self, group: &MistakeGroup, numbers: &BTreeMap<&str, usize>, most: usize) {
        let count = group.submissions.len();
        self.add(format_args!(
            "<tr><td><code>{}</code><br/>{}<br/><span class=\"dim\">Look at {}</span></td><td>{}</td>\
             <td class=\"number\">{count}<span class=\"bar\" style=\"width:{:.0}%\"></span></td><td>",
            Escaped(&group.id),
            Escaped(group.meaning),
            Escaped(group.look_at),
            Escaped(group.section),
            100.0 * count as f64 / most.max(1) as f64
        ));
        let links = group
            .submissions
            .keys()
            .filter_map(|name| Some((name, numbers.get(name.as_str())?)));
        for (index, (name, number)) in links.take(SHOWN_NAMES).enumerate() {
            let comma = if index == 0 { "" } else { ", " };
            self.add(format_args!(
                "{comma}<a href=\"#s{number}\">{}</a>",
                Escaped(name.as_str())
            ));
        }
        if count > SHOWN_NAMES {
            self.add(format_args!(" and {} more", count - SHOWN_NAMES));
        }
        self.add(format_args!("</td></tr>\n"));
    }

    fn tests(&mut self, report: &Report) {
        self.add(format_args!("<h2>Tests</h2>\n<div class=\"tests\">\n"));
        for test in &report.tests {
            let name = Escaped(&test.name);
            let points = test
                .points
                .iter()
                .map(|(section, points)| format!("{section}: {points}"));
            let points = points.collect::<Vec<_>>().join(", ");
            self.add(format_args!("<figure>"));
            self.picture(
                test.picture.as_deref(),
                &format!("the exact result of {}", test.name),
            );
            self.add(format_args!(
                "<figcaption><strong>{name}</strong>, {}<br/><span class=\"dim\">{}</span></figcaption></figure>\n",
                test.kind,
                Escaped(&points)
            ));
        }
        self.add(format_args!(
            "</div>\n<p class=\"legend\"><span><i style=\"background:{}\"></i>agrees</span>\
             <span><i class=\"ramp\" style=\"background:linear-gradient(90deg, {})\"></i>off, up to {:.0} % of the \
             size and more</span><span><i style=\"background:{}\"></i>the exact mesh behind it</span>",
            css(AGREES),
            ERRORS.map(css).join(", "),
            100.0 * LARGEST_ERROR,
            css(GHOST)
        ));
        if report.tests.iter().any(|test| test.kind == "picture") {
            self.add(format_args!(
                "<span><i style=\"background:{}\"></i>drawn, but not in the exact picture</span>\
                 <span><i style=\"background:{}\"></i>missing in the picture</span>",
                css(ONLY_THEIRS),
                css(ONLY_EXACT)
            ));
        }
        self.add(format_args!("</p>\n"));
    }

    /// A PNG in Base64.
    fn picture(&mut self, png: Option<&str>, shown: &str) {
        if let Some(png) = png {
            // A part that is merged may hold anything.
            let (shown, png) = (Escaped(shown), Escaped(png));
            self.add(format_args!(
                "<img alt=\"{shown}\" src=\"data:image/png;base64,{png}\"/>"
            ));
        }
    }
}

/// A color of thumbnails in the words of a style.
fn css([red, green, blue]: Color) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_page_cannot_hold_is_replaced() {
        let text = "<b a=\"1\">&\u{0}\u{1b}[1m\u{ffff}é";
        let expected = "&lt;b a=&quot;1&quot;&gt;&amp;\u{fffd}\u{fffd}[1m\u{fffd}é";
        assert_eq!(Escaped(text).to_string(), expected);
    }
}
