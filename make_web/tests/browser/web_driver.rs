//! WebDriver, the protocol by which browsers are driven, as far as the tests need it.
//!
//! Crates for it (fantoccini, thirtyfour) bring an asynchronous runtime, HTTP and TLS for what is a dozen requests to a
//! program on the same machine, one after the other.

use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Read, Write};
use std::net::{Ipv4Addr, TcpStream};
use std::path::Path;
use std::process::{Child, Command, Stdio};

/// A browser with one window.
pub struct WebDriver {
    process: Child,
    port: u16,
    session: String,
}

impl WebDriver {
    /// Starts Chromium with WebGL 2 on the processor, for a screen of `scale` pixels a point; downloads
    /// go into `downloads`.
    pub fn start(downloads: &Path, scale: f32) -> Self {
        // It looks for a port that is free before it takes it, and ends if another has it by then.
        let mut tries = (0..5).map(|_| start_chromedriver());
        let started = tries.find_map(|started| started);
        let (process, port) = started.expect("chromedriver says its port");
        let mut driver = Self {
            process,
            port,
            session: String::new(),
        };
        let session = driver.request("POST", "/session", &capabilities(downloads, scale));
        driver.session = session["sessionId"].as_str().unwrap().to_owned();
        driver
    }

    /// Sends a command of the session.
    pub fn post(&self, path: &str, body: &Value) -> Value {
        self.request("POST", &format!("/session/{}{path}", self.session), body)
    }

    /// Asks for something of the session.
    pub fn get(&self, path: &str) -> Value {
        let path = format!("/session/{}{path}", self.session);
        self.request("GET", &path, &Value::Null)
    }

    /// Runs the body of a function of JavaScript, and returns what it returns.
    pub fn script(&self, script: &str) -> Value {
        self.post("/execute/sync", &json!({"script": script, "args": []}))
    }

    fn request(&self, method: &str, path: &str, body: &Value) -> Value {
        let body = if body.is_null() {
            String::new()
        } else {
            body.to_string()
        };
        let mut stream = TcpStream::connect((Ipv4Addr::LOCALHOST, self.port)).unwrap();
        let length = body.len();
        write!(
            stream,
            "{method} {path} HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Type: application/json\r\n\
             Content-Length: {length}\r\nConnection: close\r\n\r\n{body}"
        )
        .unwrap();
        let answer = body_of(BufReader::new(stream));
        let answer: Value = serde_json::from_slice(&answer).unwrap();
        let value = answer["value"].clone();
        assert!(value["error"].is_null(), "{method} {path}: {value}");
        value
    }
}

impl Drop for WebDriver {
    fn drop(&mut self) {
        // A test that fails in the middle closes its browser as well.
        let path = format!("/session/{}", self.session);
        if let Ok(mut stream) = TcpStream::connect((Ipv4Addr::LOCALHOST, self.port)) {
            let _ = write!(
                stream,
                "DELETE {path} HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\n\r\n"
            );
            let _ = stream.read(&mut [0; 1]);
        }
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

/// The body of an answer whose length is said.
fn body_of(mut answer: impl BufRead) -> Vec<u8> {
    let mut length = 0;
    loop {
        let mut line = String::new();
        answer.read_line(&mut line).unwrap();
        let line = line.trim().to_lowercase();
        if let Some(said) = line.strip_prefix("content-length:") {
            length = said.trim().parse().unwrap();
        }
        if line.is_empty() {
            break;
        }
    }
    let mut body = vec![0; length];
    answer.read_exact(&mut body).unwrap();
    body
}

/// Starts a chromedriver, and returns it with its port; `None` if it ends before it has one.
fn start_chromedriver() -> Option<(Child, u16)> {
    let mut process = Command::new("chromedriver")
        .arg("--port=0")
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .expect("chromedriver is installed: run `make test-web`");
    let output = process.stdout.take().expect("its output is read");
    let mut lines = BufReader::new(output).lines();
    let port = lines.find_map(|line| {
        let line = line.ok()?;
        let port = line.split("started successfully on port ").nth(1)?;
        port.trim_end_matches('.').parse().ok()
    });
    let Some(port) = port else {
        let _ = process.wait();
        return None;
    };
    // Whatever else it says must find somebody who reads it.
    std::thread::spawn(move || lines.count());
    Some((process, port))
}

fn capabilities(downloads: &Path, scale: f32) -> Value {
    json!({"capabilities": {"alwaysMatch": {
        "goog:loggingPrefs": {"browser": "ALL"},
        "goog:chromeOptions": {
            "args": [
                "--headless=new",
                "--no-sandbox",
                "--disable-dev-shm-usage",
                "--use-gl=angle",
                "--use-angle=swiftshader",
                "--enable-unsafe-swiftshader",
                "--ignore-gpu-blocklist",
                "--hide-scrollbars",
                format!("--force-device-scale-factor={scale}"),
            ],
            "prefs": {
                "download.default_directory": downloads,
                "download.prompt_for_download": false,
            },
        },
    }}})
}
