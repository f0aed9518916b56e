//! The README of a submission: the assignment's questions and the student's answers, read from a
//! file, asked on the terminal, and written.

use crate::disk;
use crate::io::Diagnostic;
use std::io::{BufRead, Write};
use std::path::Path;

/// Question of the assignment.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Question {
    /// Word that an answers file may have in place of the question.
    pub key: &'static str,
    pub text: &'static str,
}

/// What the README of a submission answers, in its order: whose it is, and the five questions.
pub(super) const QUESTIONS: &[Question] = &[
    Question {
        key: "Name",
        text: "What is your name?",
    },
    Question {
        key: "Compiling",
        text: "How is your code compiled and run, and on which systems have you tested it?",
    },
    Question {
        key: "Collaboration",
        text: "Did you work with anyone in the class, and what help did you give or receive?",
    },
    Question {
        key: "References",
        text: "Which references (books, papers, websites, models by others) helped you?",
    },
    Question {
        key: "Problems",
        text: "Which problems does your code have, what causes them, and how would you fix them?",
    },
    Question {
        key: "Extra credit",
        text: "Which extra credit did you do, and how are the additional features used?",
    },
];

/// First heading of the README.
const TITLE: &str = "Hierarchical Modeling and SSD";
/// Heading of the list of what is in the archive, after what the student says about it.
const CONTENTS: &str = "What is in this archive";
/// Line before that list, which is written anew each time.
const LISTED: &str = "The files:";

/// Answers to [`QUESTIONS`], and other sections that the student has written.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Answers {
    /// One for each question; empty where it is not answered yet.
    answers: [String; QUESTIONS.len()],
    /// Heading and text.
    others: Vec<(String, String)>,
    /// What the student says about what is in the archive.
    about_contents: String,
}

impl Answers {
    /// Reads a README as [`Answers::readme`] writes it, or a file of the same form: each answer is
    /// below a heading (`## …`) that is the question or its key. What is before the first heading
    /// does not count; sections with other headings are kept.
    ///
    /// # Errors
    /// If it is not text in UTF-8, or has two answers to one question.
    pub fn read(path: &Path, bytes: &[u8]) -> Result<Self, Diagnostic> {
        let text = std::str::from_utf8(bytes).map_err(|error| {
            let before = &bytes[..error.valid_up_to()];
            let line = before.iter().filter(|&&byte| byte == b'\n').count() + 1;
            Diagnostic::at(path, line, 1, "expected text in UTF-8, found other bytes")
        })?;
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let mut read = Self::default();
        let mut section: Option<(&str, usize, String)> = None;
        let mut is_code = false;
        for (index, line) in text.lines().enumerate() {
            is_code ^= line.trim_start().starts_with("```");
            match line.strip_prefix("## ").filter(|_| !is_code) {
                Some(heading) => {
                    read.add(path, section.take())?;
                    section = Some((heading.trim(), index + 1, String::new()));
                }
                None => {
                    if let Some((_, _, text)) = &mut section {
                        text.push_str(line);
                        text.push('\n');
                    }
                }
            }
        }
        read.add(path, section)?;
        Ok(read)
    }

    fn add(
        &mut self,
        path: &Path,
        section: Option<(&str, usize, String)>,
    ) -> Result<(), Diagnostic> {
        let Some((heading, line, text)) = section else {
            return Ok(());
        };
        let text = text.trim().to_owned();
        let is_meant = |question: &Question| {
            let names = [question.key, question.text];
            let heading = heading.trim_end_matches([':', '?']);
            let is = |name: &str| name.trim_end_matches('?').eq_ignore_ascii_case(heading);
            names.into_iter().any(is)
        };
        match QUESTIONS.iter().position(is_meant) {
            Some(index) if self.answers[index].is_empty() => self.answers[index] = text,
            Some(index) => {
                let key = QUESTIONS[index].key;
                let message = format!("expected one answer to “{key}”, found a second");
                return Err(Diagnostic::at(path, line, 4, message));
            }
            None if heading == CONTENTS => {
                let lines = text.lines().take_while(|line| line.trim() != LISTED);
                let own: Vec<&str> = lines.collect();
                own.join("\n").trim().clone_into(&mut self.about_contents);
            }
            None => self.others.push((heading.to_owned(), text)),
        }
        Ok(())
    }

    /// Answers the first question, which is the student's name, unless it is answered.
    pub fn set_name(&mut self, name: &str) {
        name.trim().clone_into(&mut self.answers[0]);
    }

    /// The student's name; empty if it is not known.
    pub fn name(&self) -> &str {
        &self.answers[0]
    }

    /// Questions without an answer.
    pub fn missing(&self) -> Vec<&'static Question> {
        let all = QUESTIONS.iter().zip(&self.answers);
        let missing = all.filter(|(_, answer)| answer.is_empty());
        missing.map(|(question, _)| question).collect()
    }

    /// Asks for each answer that is missing: prints the question to `out`, and takes the lines of
    /// `input` up to an empty one. Asks again where the first line is empty.
    ///
    /// # Errors
    /// If `input` ends before all is answered, or reading or printing fails.
    pub fn ask(
        &mut self,
        input: &mut impl BufRead,
        out: &mut impl Write,
    ) -> Result<(), std::io::Error> {
        for (question, answer) in QUESTIONS.iter().zip(&mut self.answers) {
            while answer.is_empty() {
                writeln!(out, "{} (An empty line ends the answer.)", question.text)?;
                let mut lines: Vec<String> = Vec::new();
                loop {
                    let mut line = String::new();
                    let is_over = input.read_line(&mut line)? == 0;
                    if is_over && lines.is_empty() {
                        return Err(std::io::ErrorKind::UnexpectedEof.into());
                    }
                    if line.trim().is_empty() {
                        break;
                    }
                    lines.push(line.trim_end().to_owned());
                }
                *answer = lines.join("\n").trim().to_owned();
                if answer.is_empty() {
                    writeln!(
                        out,
                        "An answer is needed; where there is nothing to say: none."
                    )?;
                }
            }
        }
        Ok(())
    }

    /// Writes the form with what is answered to a new file of `folder`. Returns its name.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn keep(&self, folder: &Path) -> Result<String, Diagnostic> {
        let (mut name, mut number) = ("answers.md".to_owned(), 1);
        while folder.join(&name).exists() {
            number += 1;
            name = format!("answers-{number}.md");
        }
        disk::write_whole(&folder.join(&name), self.readme(&[]).as_bytes())?;
        Ok(name)
    }

    /// The README, with one line for each of `contents`; without those the form to be filled in.
    pub fn readme(&self, contents: &[String]) -> String {
        let mut text = format!("# {TITLE}\n");
        let answered = QUESTIONS.iter().map(|question| question.text);
        let answered = answered.zip(self.answers.iter().map(String::as_str));
        let others = self.others.iter();
        let others = others.map(|(heading, text)| (heading.as_str(), text.as_str()));
        for (heading, section) in answered.chain(others) {
            text.push_str(&format!("\n## {heading}\n\n{section}\n"));
        }
        if contents.is_empty() {
            return text;
        }
        text.push_str(&format!("\n## {CONTENTS}\n\n"));
        if !self.about_contents.is_empty() {
            text.push_str(&format!("{}\n\n", self.about_contents));
        }
        text.push_str(&format!("{LISTED}\n\n"));
        for line in contents {
            text.push_str(&format!("- {line}\n"));
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Answers, Diagnostic> {
        Answers::read(Path::new("a.md"), text.as_bytes())
    }

    const ALL: &str = "before\n## Name\nAda\n## compiling\nmake\n\n```\n## no heading\n```\n\
        ## Collaboration:\nno\n## References\nnone\n## Problems\nnone\n## Extra Credit\nno\n\
        ## Comments\nIt was fun.\n";

    #[test]
    fn answers_stand_below_their_headings_and_other_sections_are_kept() {
        let answers = read(ALL).unwrap();
        assert_eq!(answers.missing(), Vec::<&Question>::new());
        assert_eq!(answers.name(), "Ada");
        let readme = answers.readme(&["all".to_owned()]);
        assert!(readme.contains("## Comments\n\nIt was fun.\n"), "{readme}");
        assert!(readme.contains("```\n## no heading\n```"), "{readme}");
        assert!(!readme.contains("before"), "{readme}");
    }

    #[test]
    fn a_readme_that_was_written_is_read_again_as_the_same_answers() {
        let answers = read(ALL).unwrap();
        let readme = answers.readme(&["code".to_owned()]);
        assert_eq!(read(&readme), Ok(answers.clone()));
        // What the student says about the archive is kept, and the list is written anew.
        let own = "My notes.\n\n- the walk";
        let said = readme.replace("The files:", &format!("{own}\n\nThe files:"));
        let again = read(&said).unwrap().readme(&["data".to_owned()]);
        let expected = format!("archive\n\n{own}\n\nThe files:\n\n- data\n");
        assert!(again.ends_with(&expected), "{again}");
        let typed = read(&format!("{ALL}## What is in this archive\n{own}\n")).unwrap();
        assert!(typed.readme(&["data".to_owned()]).ends_with(&expected));
        assert!(!answers.readme(&[]).contains("archive"), "the form");
    }

    #[test]
    fn two_answers_to_one_question_are_refused_at_the_second() {
        let error = read("## Name\nAda\n## NAME\nBob\n").unwrap_err();
        let expected = "a.md:3:4: expected one answer to “Name”, found a second";
        assert_eq!(error.to_string(), expected);
        let error = Answers::read(Path::new("a.md"), b"## Name\n\xff").unwrap_err();
        let expected = "a.md:2:1: expected text in UTF-8, found other bytes";
        assert_eq!(error.to_string(), expected);
    }

    #[test]
    fn only_what_is_missing_is_asked_and_an_empty_answer_is_asked_again() {
        let given = ALL.replace("## References\nnone\n", "## References\n");
        let mut answers = read(&given.replace("Ada", "")).unwrap();
        let (mut out, typed) = (Vec::new(), "Ada\n\n\na book\nanother\n\nnot read\n");
        answers.ask(&mut typed.as_bytes(), &mut out).unwrap();
        assert_eq!(answers.name(), "Ada");
        let asked = String::from_utf8(out).unwrap();
        assert_eq!(asked.lines().count(), 4, "{asked}");
        assert!(asked.contains("nothing to say: none"), "{asked}");
        assert!(answers.readme(&[]).contains("\n\na book\nanother\n\n"));
        let mut answers = Answers::default();
        assert!(
            answers
                .ask(&mut "Ada\n".as_bytes(), &mut Vec::new())
                .is_err()
        );
    }
}
