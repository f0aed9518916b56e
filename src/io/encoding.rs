//! What the bytes of a file are as text.

use super::{Diagnostic, image};
use std::borrow::Cow;
use std::path::Path;

/// `bytes` in UTF-8. What begins with the mark of UTF-16 is in that, as PowerShell keeps what a program prints. What is no
/// such text but holds only characters that are printed is taken for Latin-1, in which older programs write names and
/// comments; numbers are the same in both.
pub fn in_utf8(bytes: &[u8]) -> Cow<'_, [u8]> {
    let utf_16 = match bytes {
        [0xFF, 0xFE, units @ ..] => from_utf_16(units, u16::from_le_bytes),
        [0xFE, 0xFF, units @ ..] => from_utf_16(units, u16::from_be_bytes),
        _ => None,
    };
    if let Some(text) = utf_16 {
        return Cow::Owned(text.into_bytes());
    }
    let is_printed = |&byte: &u8| match byte {
        b'\t' | b'\n' | b'\r' => true,
        0..0x20 | 0x7f..0xa0 => false,
        _ => true,
    };
    if std::str::from_utf8(bytes).is_ok() || !bytes.iter().all(is_printed) {
        return Cow::Borrowed(bytes);
    }
    let text: String = bytes.iter().map(|&byte| char::from(byte)).collect();
    Cow::Owned(text.into_bytes())
}

/// The text of `bytes`, of which each two are a `unit`; `None` if they are no such text.
fn from_utf_16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> Option<String> {
    let (units, []) = bytes.as_chunks() else {
        return None;
    };
    let units = units.iter().map(|bytes| unit(*bytes));
    char::decode_utf16(units).collect::<Result<_, _>>().ok()
}

/// `bytes` as text, without the mark that some editors put before it.
///
/// # Errors
/// If they are not UTF-8, with the place of the first that is not.
pub(super) fn utf8<'a>(path: &Path, bytes: &'a [u8]) -> Result<&'a str, Diagnostic> {
    let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    std::str::from_utf8(bytes).map_err(|error| {
        // Under the name of another format no place in it says anything.
        if let Some(found) = no_text(bytes) {
            return Diagnostic::new(path, format!("expected text, found {found}"));
        }
        let good = &bytes[..error.valid_up_to()];
        let line = good.iter().filter(|&&byte| byte == b'\n').count() + 1;
        let last = good.rsplit(|&byte| byte == b'\n').next().unwrap_or(good);
        let column = String::from_utf8_lossy(last).chars().count() + 1;
        let found = bytes[error.valid_up_to()];
        let message = format!("expected text in UTF-8, found the byte 0x{found:02x}");
        Diagnostic::at(path, line, column, message)
    })
}

/// What `bytes` are that are known to be no text.
pub(super) fn no_text(bytes: &[u8]) -> Option<String> {
    match bytes {
        [b'P', b'K', 3, 4, ..] => Some("a .zip archive".to_owned()),
        _ => image::format_of(bytes).map(|format| format!("a {format} picture")),
    }
}

/// What `text` is that begins with a tag, as no line of ours does: saved under a name that is not its own, or in place
/// of what a page links to.
pub fn markup(text: &str) -> Option<&'static str> {
    let text = text.trim_start();
    let begins = |with: &str| {
        let start = text.get(..with.len());
        start.is_some_and(|start| start.eq_ignore_ascii_case(with))
    };
    if begins("<?xml") || begins("<COLLADA") {
        Some("XML: a Collada file has a name that ends in .dae")
    } else if begins("<!doctype html") || begins("<html") {
        Some("a web page (HTML)")
    } else {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_in_latin_1_is_read_and_one_that_is_none_stays_as_it_is() {
        let read = |bytes: &'static [u8]| in_utf8(bytes);
        assert_eq!(
            &*read(b"# J\xFCrgen\nv 1 2 3\n"),
            "# Jürgen\nv 1 2 3\n".as_bytes()
        );
        for bytes in [
            "# Jürgen\n".as_bytes(),
            b"v \xFC\x00 1\n",
            b"\x89PNG\r\n\x1a\n\xFF",
        ] {
            assert!(matches!(read(bytes), Cow::Borrowed(same) if same == bytes));
        }
    }

    #[test]
    fn a_text_in_utf_16_with_its_mark_is_read_and_half_a_character_is_none() {
        let text = "# Jürgen 𝄞\nv 1 2 3\n";
        let marked = || "\u{feff}".encode_utf16().chain(text.encode_utf16());
        let little: Vec<u8> = marked().flat_map(u16::to_le_bytes).collect();
        let big: Vec<u8> = marked().flat_map(u16::to_be_bytes).collect();
        assert_eq!(&*in_utf8(&little), text.as_bytes());
        assert_eq!(&*in_utf8(&big), text.as_bytes());
        for cut in [&little[..little.len() - 1], &little[..22]] {
            assert!(matches!(in_utf8(cut), Cow::Borrowed(same) if same == cut));
        }
    }
}
