//! A small server of files, for the machine that it runs on alone: it sends the compressed files that lie beside the
//! others, as web servers do that are told to, which those of crates do not find by themselves.

use super::compress::with_extension;
use std::fs;
use std::io::{self, BufRead, BufReader, Write};
use std::net::{Ipv4Addr, TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::thread;

/// A server of the files in a folder.
#[derive(Debug)]
pub struct Server {
    folder: PathBuf,
    listener: TcpListener,
    port: u16,
}

impl Server {
    /// A server of `folder` at `port` of this machine, or at any free port for 0.
    ///
    /// # Errors
    /// If there is no page in the folder, or the port is taken.
    pub fn new(folder: &Path, port: u16) -> io::Result<Self> {
        if !folder.join("index.html").is_file() {
            let text = format!("{} has no index.html: run `make web`", folder.display());
            return Err(io::Error::new(io::ErrorKind::NotFound, text));
        }
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port)).map_err(|error| {
            let text = format!("port {port} cannot be used ({error}): name another one");
            io::Error::new(error.kind(), text)
        })?;
        let port = listener.local_addr()?.port();
        Ok(Self {
            folder: folder.to_owned(),
            listener,
            port,
        })
    }

    /// Where a browser finds it.
    #[must_use]
    pub fn address(&self) -> String {
        format!("http://127.0.0.1:{}/", self.port)
    }
}

/// Answers browsers for ever.
pub fn serve(server: &Server) {
    for stream in server.listener.incoming().flatten() {
        let folder = server.folder.clone();
        // A browser that goes away in the middle needs no answer.
        thread::spawn(move || answer(&folder, stream));
    }
}

fn answer(folder: &Path, mut stream: TcpStream) -> io::Result<()> {
    let mut lines = BufReader::new(stream.try_clone()?).lines();
    let request = lines.next().unwrap_or(Ok(String::new()))?;
    let mut accepted = String::new();
    for line in lines {
        let line = line?.to_lowercase();
        if line.is_empty() {
            break;
        }
        if let Some(list) = line.strip_prefix("accept-encoding:") {
            accepted = list.to_owned();
        }
    }
    match file_of(folder, &request) {
        Some(path) => send(&mut stream, &path, &accepted),
        None => stream
            .write_all(b"HTTP/1.1 404 Not Found\r\nContent-Length: 0\r\nConnection: close\r\n\r\n"),
    }
}

/// The file that a request names, if it is one below `folder`.
fn file_of(folder: &Path, request: &str) -> Option<PathBuf> {
    let address = request.strip_prefix("GET /")?.split([' ', '?']).next()?;
    let is_plain =
        |part: &str| !part.is_empty() && !part.starts_with('.') && !part.contains(['\\', ':', '%']);
    if !address.is_empty() && !address.split('/').all(is_plain) {
        return None;
    }
    let mut path = folder.join(address);
    if path.is_dir() {
        path = path.join("index.html");
    }
    path.is_file().then_some(path)
}

/// Sends the file at `path`, in the smallest form that is there and `accepted`.
fn send(stream: &mut TcpStream, path: &Path, accepted: &str) -> io::Result<()> {
    let kind = match path.extension().and_then(|extension| extension.to_str()) {
        Some("html") => "text/html; charset=utf-8",
        Some("js") => "text/javascript",
        Some("wasm") => "application/wasm",
        Some("svg") => "image/svg+xml",
        _ => "application/octet-stream",
    };
    let (sent, encoding) = smallest(path, accepted);
    let bytes = fs::read(sent)?;
    let encoding =
        encoding.map_or_else(String::new, |name| format!("Content-Encoding: {name}\r\n"));
    let length = bytes.len();
    write!(
        stream,
        "HTTP/1.1 200 OK\r\nContent-Type: {kind}\r\nContent-Length: {length}\r\n{encoding}\
         Vary: Accept-Encoding\r\nCache-Control: no-cache\r\nConnection: close\r\n\r\n"
    )?;
    stream.write_all(&bytes)
}

/// The file that is sent for `path`, with its encoding if it has one.
fn smallest(path: &Path, accepted: &str) -> (PathBuf, Option<&'static str>) {
    let is_accepted = |name: &str| accepted.split([',', ';']).any(|word| word.trim() == name);
    let packed = [("br", "br"), ("gzip", "gz")]
        .into_iter()
        .find_map(|(name, extension)| {
            let packed = with_extension(path, extension);
            (is_accepted(name) && packed.is_file()).then_some((packed, Some(name)))
        });
    packed.unwrap_or_else(|| (path.to_owned(), None))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_files_below_the_folder_are_served() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("index.html"), "page").unwrap();
        let found = |request: &str| file_of(folder.path(), request);
        let index = Some(folder.path().join("index.html"));
        assert_eq!(found("GET / HTTP/1.1"), index);
        assert_eq!(found("GET /index.html?open=a.obj HTTP/1.1"), index);
        assert_eq!(found("GET /none.js HTTP/1.1"), None);
        assert_eq!(found("GET /../index.html HTTP/1.1"), None);
        assert_eq!(found("GET //etc/hostname HTTP/1.1"), None);
        assert_eq!(found("POST / HTTP/1.1"), None);
    }

    #[test]
    fn files_are_sent_in_the_smallest_form_that_the_browser_takes() {
        let folder = tempfile::tempdir().unwrap();
        let script = folder.path().join("editor.js");
        fs::write(&script, "start();".repeat(1000)).unwrap();
        crate::compress(folder.path()).unwrap();
        let sent = |accepted: &str| smallest(&script, accepted);
        let with = |extension| with_extension(&script, extension);
        assert_eq!(sent(" gzip, deflate, br"), (with("br"), Some("br")));
        assert_eq!(sent(" gzip;q=1.0"), (with("gz"), Some("gzip")));
        assert_eq!(sent(""), (script.clone(), None));
    }
}
