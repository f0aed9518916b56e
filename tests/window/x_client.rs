//! Another program of the desktop: a file manager from which files are dragged, and the close
//! button of a window's frame.

use std::path::Path;
use std::time::{Duration, Instant};
use x11rb::COPY_DEPTH_FROM_PARENT;
use x11rb::connection::Connection;
use x11rb::properties::WmSizeHints;
use x11rb::protocol::Event;
use x11rb::protocol::xproto::{
    Atom, AtomEnum, ClientMessageEvent, ConnectionExt, CreateWindowAux, EventMask, PropMode,
    SELECTION_NOTIFY_EVENT, SelectionNotifyEvent, SelectionRequestEvent, Window, WindowClass,
};
use x11rb::rust_connection::RustConnection;
use x11rb::wrapper::ConnectionExt as _;

/// How long an answer may take before it is taken not to come.
const PATIENCE: Duration = Duration::from_secs(60);

/// A connection to the display, with a window of its own that nobody sees.
pub struct XClient {
    connection: RustConnection,
    window: Window,
}

impl XClient {
    pub fn connect(display: &str) -> Self {
        let (connection, screen) = x11rb::connect(Some(display)).expect("a display");
        let window = connection.generate_id().expect("a number for a window");
        let root = connection.setup().roots[screen].root;
        let (class, values) = (WindowClass::INPUT_OUTPUT, CreateWindowAux::new());
        connection
            .create_window(
                COPY_DEPTH_FROM_PARENT,
                window,
                root,
                0,
                0,
                1,
                1,
                0,
                class,
                0,
                &values,
            )
            .expect("a window");
        Self { connection, window }
    }

    /// Asks `window` to close, as its frame's button does.
    pub fn close(&self, window: &str) {
        let window = number(window);
        let delete = self.atom("WM_DELETE_WINDOW");
        self.send(window, "WM_PROTOCOLS", [delete, 0, 0, 0, 0]);
    }

    /// Width and height below which the frame of `window` does not let it be made.
    pub fn least_size(&self, window: &str) -> Option<(i32, i32)> {
        let hints = WmSizeHints::get_normal_hints(&self.connection, number(window));
        let hints = hints.expect("the connection").reply();
        hints.expect("the window")?.min_size
    }

    /// Drops a file on `window`, by the protocol XDND (freedesktop.org), version 5.
    pub fn drop(&self, file: &Path, window: &str) {
        let target = number(window);
        let (list, copy) = (self.atom("text/uri-list"), self.atom("XdndActionCopy"));
        let selection = self.atom("XdndSelection");
        let now = x11rb::CURRENT_TIME;
        self.connection
            .set_selection_owner(self.window, selection, now)
            .expect("the selection");
        let (place, version) = (100 << 16 | 100, 5 << 24);
        self.send(target, "XdndEnter", [self.window, version, list, 0, 0]);
        self.send(target, "XdndPosition", [self.window, 0, place, now, copy]);
        let (status, finished) = (self.atom("XdndStatus"), self.atom("XdndFinished"));
        let mut told = false;
        loop {
            match self.next_event() {
                Event::SelectionRequest(request) => {
                    self.give(&request, &format!("file://{}\r\n", file.display()));
                    told = true;
                }
                Event::ClientMessage(message) if message.type_ == status => {
                    let [_, accepted, ..] = message.data.as_data32();
                    assert_eq!(accepted & 1, 1, "files cannot be dropped");
                }
                Event::ClientMessage(message) if message.type_ == finished => return,
                _ => continue,
            }
            if told {
                self.send(target, "XdndDrop", [self.window, 0, now, 0, 0]);
                told = false;
            }
        }
    }

    fn next_event(&self) -> Event {
        let since = Instant::now();
        loop {
            let event = self.connection.poll_for_event().expect("the connection");
            if let Some(event) = event {
                return event;
            }
            assert!(since.elapsed() < PATIENCE, "the window does not answer");
            std::thread::sleep(Duration::from_millis(10));
        }
    }

    /// Gives what is dragged to the window that asks for it.
    fn give(&self, request: &SelectionRequestEvent, text: &str) {
        let SelectionRequestEvent {
            requestor,
            property,
            target,
            ..
        } = *request;
        let bytes = text.as_bytes();
        self.connection
            .change_property8(PropMode::REPLACE, requestor, property, target, bytes)
            .expect("a property");
        let notify = SelectionNotifyEvent {
            response_type: SELECTION_NOTIFY_EVENT,
            sequence: 0,
            time: request.time,
            requestor,
            selection: request.selection,
            target,
            property,
        };
        self.connection
            .send_event(false, requestor, EventMask::NO_EVENT, notify)
            .expect("an event");
        self.connection.flush().expect("the connection");
    }

    fn send(&self, window: Window, kind: &str, data: [u32; 5]) {
        let message = ClientMessageEvent::new(32, window, self.atom(kind), data);
        self.connection
            .send_event(false, window, EventMask::NO_EVENT, message)
            .expect("an event");
        // What is only on its way is lost with the connection.
        self.connection.sync().expect("the connection");
    }

    fn atom(&self, name: &str) -> Atom {
        let cookie = self.connection.intern_atom(false, name.as_bytes());
        let reply = cookie.expect("the connection").reply();
        reply.map_or(AtomEnum::NONE.into(), |reply| reply.atom)
    }
}

fn number(window: &str) -> Window {
    window.parse().expect("a window's number")
}
