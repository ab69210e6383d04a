//! The desktop's portal, played by a test on a session bus of its own.

use bevy::tasks::block_on;
use std::collections::HashMap;
use std::io::{BufRead, BufReader};
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::Duration;
use zbus::connection::{Builder, Connection};
use zbus::fdo;
use zbus::interface;
use zbus::message::Header;
use zbus::zvariant::{OwnedObjectPath, OwnedValue, Value};

const NAME: &str = "org.freedesktop.portal.Desktop";
const PATH: &str = "/org/freedesktop/portal/desktop";

/// Far longer than a busy machine needs.
const PATIENCE: Duration = Duration::from_secs(60);

/// A session bus on which nothing runs and which starts nothing. Dropping this value ends it.
pub struct Bus {
    daemon: Child,
    /// Where programs find it.
    pub address: String,
    _folder: tempfile::TempDir,
}

impl Bus {
    pub fn start() -> Self {
        let folder = tempfile::tempdir().unwrap();
        let config = folder.path().join("bus.conf");
        let place = folder.path().display();
        // The user's own bus would start the portal that is installed here.
        let text = format!(
            r#"<busconfig>
                <type>session</type>
                <listen>unix:dir={place}</listen>
                <policy context="default">
                    <allow send_destination="*" eavesdrop="true"/>
                    <allow eavesdrop="true"/>
                    <allow own="*"/>
                </policy>
            </busconfig>"#
        );
        std::fs::write(&config, text).unwrap();
        let mut daemon = Command::new("dbus-daemon")
            .args(["--nofork", "--print-address", "--config-file"])
            .arg(config)
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("dbus-daemon is missing; ./check installs it");
        let mut address = String::new();
        let output = daemon.stdout.take().unwrap();
        BufReader::new(output).read_line(&mut address).unwrap();
        Self {
            daemon,
            address: address.trim().to_owned(),
            _folder: folder,
        }
    }

    fn builder(&self) -> zbus::Result<Builder<'_>> {
        Ok(Builder::address(self.address.as_str())?.method_timeout(PATIENCE))
    }

    /// Ends the bus, and with it all that its programs wait for.
    pub fn end(&mut self) {
        self.daemon.kill().ok();
        self.daemon.wait().ok();
    }
}

impl Drop for Bus {
    fn drop(&mut self) {
        self.end();
    }
}

/// How a portal answers the call that opens a dialog.
#[derive(Clone, Copy, Debug)]
pub enum Answer {
    /// Not at all.
    None,
    /// With an error.
    Refusal,
    /// With the handle of a dialog that stays open.
    Dialog,
    /// With the handle of a dialog that has this response and this file's address.
    Response(u32, Option<&'static str>),
}

/// What a portal was asked for.
#[derive(Debug, PartialEq)]
pub struct Asked {
    pub title: String,
    /// The folder, with the zero byte that ends it on the bus.
    pub folder: Option<Vec<u8>>,
    pub filters: Vec<(String, Vec<(u32, String)>)>,
}

/// The handle of a dialog.
pub struct Dialog(OwnedObjectPath);

/// A portal on a bus. Dropping this value ends it.
pub struct Portal {
    connection: Option<Connection>,
    asked: Receiver<(Asked, Dialog)>,
}

impl Portal {
    pub fn start(bus: &Bus, answer: Answer) -> Self {
        let (sender, asked) = channel();
        let chooser = FileChooser { answer, sender };
        let started = async {
            let builder = bus.builder()?;
            builder.serve_at(PATH, chooser)?.name(NAME)?.build().await
        };
        Self {
            connection: Some(block_on(started).unwrap()),
            asked,
        }
    }

    /// A portal that has its name and answers nothing.
    pub fn start_mute(bus: &Bus) -> Self {
        let started = async {
            let builder = bus.builder()?;
            builder.name(NAME)?.build().await
        };
        Self {
            connection: Some(block_on(started).unwrap()),
            asked: channel().1,
        }
    }

    /// Waits until a dialog is asked for.
    pub fn asked(&self) -> (Asked, Dialog) {
        self.asked.recv_timeout(PATIENCE).unwrap()
    }

    /// Ends a dialog with this response and this file's address.
    pub fn respond(&self, dialog: &Dialog, code: u32, file: Option<&str>) {
        let connection = self.connection.as_ref().unwrap();
        block_on(respond(connection, dialog, code, file)).unwrap();
    }

    /// Ends the portal.
    pub fn end(&mut self) {
        if let Some(connection) = self.connection.take() {
            block_on(connection.close()).ok();
        }
    }
}

impl Drop for Portal {
    fn drop(&mut self) {
        self.end();
    }
}

async fn respond(
    connection: &Connection,
    dialog: &Dialog,
    code: u32,
    file: Option<&str>,
) -> zbus::Result<()> {
    let uris = file.map(|file| ("uris", Value::from(vec![file])));
    let results: HashMap<&str, Value> = uris.into_iter().collect();
    let interface = "org.freedesktop.portal.Request";
    let everyone = None::<&str>;
    connection
        .emit_signal(everyone, &dialog.0, interface, "Response", &(code, results))
        .await
}

struct FileChooser {
    answer: Answer,
    sender: Sender<(Asked, Dialog)>,
}

#[interface(name = "org.freedesktop.portal.FileChooser")]
impl FileChooser {
    #[zbus(property, name = "version")]
    fn version(&self) -> u32 {
        3
    }

    async fn open_file(
        &self,
        _parent: &str,
        title: &str,
        mut options: HashMap<String, OwnedValue>,
        #[zbus(header)] header: Header<'_>,
        #[zbus(connection)] connection: &Connection,
    ) -> fdo::Result<OwnedObjectPath> {
        fn option<T: TryFrom<OwnedValue>>(value: Option<OwnedValue>) -> Option<T> {
            value.and_then(|value| T::try_from(value).ok())
        }
        let asked = Asked {
            title: title.to_owned(),
            folder: option(options.remove("current_folder")),
            filters: option(options.remove("filters")).unwrap_or_default(),
        };
        let token: String = option(options.remove("handle_token")).unwrap();
        let sender = header
            .sender()
            .unwrap()
            .trim_start_matches(':')
            .replace('.', "_");
        let handle = OwnedObjectPath::try_from(format!("{PATH}/request/{sender}/{token}")).unwrap();
        // A test that has not asked for this does not listen any more.
        self.sender.send((asked, Dialog(handle.clone()))).ok();
        match self.answer {
            Answer::None => std::future::pending().await,
            Answer::Refusal => Err(fdo::Error::Failed("no".into())),
            Answer::Dialog => Ok(handle),
            Answer::Response(code, file) => {
                respond(connection, &Dialog(handle.clone()), code, file).await?;
                Ok(handle)
            }
        }
    }
}
