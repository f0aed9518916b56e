//! The page in a folder of a site, beside which there is nothing else.

use super::browser::{Browser, SIZE, VIEW, page_folder};
use super::picture::{assert_not_blank, difference};
use super::sharing::open_tag;
use std::io::{self, BufRead as _, BufReader, Write as _};
use std::net::{Ipv4Addr, Shutdown, TcpListener, TcpStream};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;

/// Where the page lies on the site.
const FOLDER: &str = "/course/editor/";

/// A site with the page in [`FOLDER`], until it is gone.
struct Site {
    address: String,
    is_gone: Arc<AtomicBool>,
}

impl Site {
    fn new() -> Self {
        let page = make_web::Server::new(&page_folder(), 0).expect("run `make test-web`");
        let host = page.address().replace("http://", "");
        let host = host.trim_end_matches('/').to_owned();
        thread::spawn(move || make_web::serve(&page));
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, 0)).unwrap();
        let port = listener.local_addr().unwrap().port();
        let is_gone = Arc::new(AtomicBool::new(false));
        let gone = Arc::clone(&is_gone);
        thread::spawn(move || {
            for stream in listener.incoming().flatten() {
                // A site that is gone says nothing.
                if !gone.load(Ordering::Relaxed) {
                    let host = host.clone();
                    thread::spawn(move || pass_on(stream, &host));
                }
            }
        });
        Self {
            address: format!("http://127.0.0.1:{port}{FOLDER}"),
            is_gone,
        }
    }
}

/// Asks the server at `host` for what a browser wants of [`FOLDER`]. There is nothing else.
fn pass_on(mut stream: TcpStream, host: &str) -> io::Result<()> {
    let mut head = String::new();
    let mut lines = BufReader::new(stream.try_clone()?);
    while !head.ends_with("\r\n\r\n") && lines.read_line(&mut head)? > 0 {}
    let Some(below) = head.strip_prefix(&format!("GET {FOLDER}")) else {
        return stream.write_all(
            b"HTTP/1.1 404 Not Found\r\nContent-Length: 0\r\nConnection: close\r\n\r\n",
        );
    };
    let mut server = TcpStream::connect(host)?;
    write!(server, "GET /{below}")?;
    io::copy(&mut server, &mut stream)?;
    stream.shutdown(Shutdown::Both)
}

#[test]
fn the_page_works_in_a_folder_of_a_site_with_its_network_and_without() {
    let site = Site::new();
    let browser = Browser::at(site.address.clone(), SIZE, 1.0);
    let scope = "navigator.serviceWorker.ready.then((found) => { window.scope = found.scope })";
    browser.script(scope);
    browser.wait("the page is kept", || {
        browser.script("return navigator.serviceWorker.controller !== null && 'scope' in window")
            == true
    });
    assert_eq!(
        browser.script("return window.scope"),
        site.address,
        "the rest of the site is not the page's"
    );
    let before = browser.picture();
    browser.go("?open=assets/rigs/crate.dae");
    let crate_shown = browser.picture();
    assert!(difference(&before, &crate_shown, VIEW) > 0.05);
    browser.go("index.html?open=builtin:crate");
    assert!(difference(&crate_shown, &browser.picture(), VIEW) < 0.001);

    site.is_gone.store(true, Ordering::Relaxed);
    // A scene with a character that has not been shown yet.
    browser.go("?open=builtin:mannequin-6");
    assert_not_blank(&browser.picture(), VIEW);
    browser.finish();
}

#[test]
fn a_tag_finds_the_page_in_a_folder_of_the_site() {
    let site = Site::new();
    let browser = Browser::at(site.address.clone(), SIZE, 1.0);
    let part = open_tag(&browser);
    assert_not_blank(&browser.picture(), part);
    browser.finish();
}
