/// Parentheses and signs deeper than this are refused, so that no text can exhaust the stack.
const DEEPEST: usize = 32;

/// The value of what a person typed into a number's field: `45/2`, `-(3 + 4) * 1.5`, `90°`.
///
/// Knows + − * / parentheses and signs, the typographic × ÷ −, a trailing degree sign, and a
/// comma where others write a decimal point. `None` if it is anything else or not finite.
pub fn evaluate(text: &str) -> Option<f64> {
    let plain: Vec<char> = text
        .trim()
        .trim_end_matches('°')
        .chars()
        .filter(|c| !c.is_whitespace())
        .map(|c| match c {
            '×' | '·' => '*',
            '÷' => '/',
            '−' => '-',
            ',' => '.',
            other => other,
        })
        .collect();
    let mut reader = Reader {
        rest: &plain,
        depth: 0,
    };
    let value = reader.sum()?;
    (reader.rest.is_empty() && value.is_finite()).then_some(value)
}

struct Reader<'a> {
    rest: &'a [char],
    depth: usize,
}

impl Reader<'_> {
    fn take(&mut self, wanted: char) -> bool {
        match self.rest.split_first() {
            Some((&first, rest)) if first == wanted => {
                self.rest = rest;
                true
            }
            _ => false,
        }
    }

    fn sum(&mut self) -> Option<f64> {
        let mut value = self.product()?;
        loop {
            if self.take('+') {
                value += self.product()?;
            } else if self.take('-') {
                value -= self.product()?;
            } else {
                return Some(value);
            }
        }
    }

    fn product(&mut self) -> Option<f64> {
        let mut value = self.factor()?;
        loop {
            if self.take('*') {
                value *= self.factor()?;
            } else if self.take('/') {
                value /= self.factor()?;
            } else {
                return Some(value);
            }
        }
    }

    fn factor(&mut self) -> Option<f64> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return None;
        }
        let value = if self.take('-') {
            -self.factor()?
        } else if self.take('+') {
            self.factor()?
        } else if self.take('(') {
            let inner = self.sum()?;
            if !self.take(')') {
                return None;
            }
            inner
        } else {
            self.number()?
        };
        self.depth -= 1;
        Some(value)
    }

    fn number(&mut self) -> Option<f64> {
        let length = self
            .rest
            .iter()
            .take_while(|c| c.is_ascii_digit() || **c == '.')
            .count();
        let (digits, rest) = self.rest.split_at(length);
        self.rest = rest;
        digits.iter().collect::<String>().parse().ok()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arithmetic_follows_the_usual_order() {
        for (text, value) in [
            ("7", 7.0),
            ("45/2", 22.5),
            ("1 + 2 * 3", 7.0),
            ("-(1+2)*3", -9.0),
            ("2--1", 3.0),
            ("8/2/2", 2.0),
            (".5", 0.5),
            ("1,5", 1.5),
            ("−30°", -30.0),
            ("3×4÷6", 2.0),
        ] {
            assert_eq!(evaluate(text), Some(value), "{text}");
        }
    }

    #[test]
    fn anything_else_is_no_number() {
        for text in [
            "", "-", "1+", "(1", "1)", "1..2", "a", "1 a", "1/0", "inf", "()", "1e5",
        ] {
            assert_eq!(evaluate(text), None, "{text}");
        }
    }

    #[test]
    fn endless_parentheses_are_refused_rather_than_followed() {
        assert_eq!(evaluate(&"(".repeat(100_000)), None);
        assert_eq!(evaluate(&"-".repeat(100_000)), None);
    }
}
