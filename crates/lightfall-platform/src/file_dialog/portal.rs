//! The dialog of the desktop's portal, which is asked through the session bus:
//! <https://flatpak.github.io/xdg-desktop-portal/docs/doc-org.freedesktop.portal.FileChooser.html>.
//!
//! The portal answers twice. It answers the call at once, with a handle, and it sends a response when
//! the user has chosen or cancelled. The first answer has a time limit, the second one has none.

use super::FileRequest;
use ashpd::desktop::ResponseError;
use ashpd::desktop::file_chooser::{FileFilter, OpenFileRequest};
use ashpd::zbus::connection::{Builder, Connection};
use ashpd::zbus::fdo::{DBusProxy, NameOwnerChangedStream};
use ashpd::{Error, Uri};
use async_io::Timer;
use bevy::tasks::futures_lite::{StreamExt, future};
use percent_encoding::percent_decode_str;
use std::ffi::OsString;
use std::io;
use std::os::unix::ffi::OsStringExt;
use std::path::PathBuf;
use std::pin::pin;
use std::time::Duration;

/// The portal's name on the bus.
const NAME: &str = "org.freedesktop.portal.Desktop";
/// The object that its interfaces belong to.
const PATH: &str = "/org/freedesktop/portal/desktop";
/// Its interface for file dialogs.
const FILE_CHOOSER: &str = "org.freedesktop.portal.FileChooser";

/// The desktop's portal.
#[derive(Clone, Debug)]
pub struct Portal {
    /// The address of the session bus. None for the one that the environment names.
    pub bus: Option<String>,
    /// The longest time in which the bus connects, the portal says that it has file dialogs, and it
    /// answers the call that opens one. A bus that has to start the portal first may need seconds.
    pub patience: Duration,
}

impl Default for Portal {
    fn default() -> Self {
        Self {
            bus: None,
            patience: Duration::from_secs(10),
        }
    }
}

pub(super) fn pick_file(request: &FileRequest) -> Result<Option<PathBuf>, String> {
    Portal::default().pick_file(request)
}

impl Portal {
    /// Shows a dialog and waits for the user. Returns the file that the user chose; none if the user
    /// cancelled the dialog.
    ///
    /// # Errors
    /// Why the portal shows no dialog or gives no answer: there is no bus or no portal, the portal
    /// does not answer in time, it ends while the dialog is open, or it reports a failure.
    pub fn pick_file(&self, request: &FileRequest) -> Result<Option<PathBuf>, String> {
        match async_io::block_on(self.ask(request)) {
            Ok(file) => path_of(&file)
                .map(Some)
                .ok_or(format!("the chosen file, {file}, is not on this machine")),
            Err(Error::Response(ResponseError::Cancelled)) => Ok(None),
            Err(error) => Err(error.to_string()),
        }
    }

    /// The address of the file that the user chose.
    async fn ask(&self, request: &FileRequest) -> Result<Uri, Error> {
        let late = async {
            Timer::after(self.patience).await;
            Err(io::Error::new(io::ErrorKind::TimedOut, "the portal does not answer").into())
        };
        let (connection, owners) = future::or(self.find(), late).await?;
        let mut answer = pin!(open(&connection, request));
        let answers = async { Some(answer.as_mut().await) };
        let ends = async {
            portal_ends(owners).await;
            None
        };
        if let Some(answer) = future::or(answers, ends).await {
            return answer;
        }
        // What a portal has sent before its end counts.
        let ended = io::Error::new(io::ErrorKind::BrokenPipe, "the portal has ended");
        let answer = future::poll_once(answer).await;
        answer.unwrap_or(Err(ended.into()))
    }

    /// Connects to a portal that has file dialogs. Returns the connection, whose calls have a time
    /// limit, and the changes of the portal's owner.
    async fn find(&self) -> Result<(Connection, NameOwnerChangedStream), Error> {
        let builder = match &self.bus {
            Some(address) => Builder::address(address.as_str())?,
            None => Builder::session()?,
        };
        let connection = builder.method_timeout(self.patience).build().await?;
        let bus = DBusProxy::new(&connection).await?;
        let owners = bus
            .receive_name_owner_changed_with_args(&[(0, NAME)])
            .await?;
        connection
            .call_method(
                Some(NAME),
                PATH,
                Some("org.freedesktop.DBus.Properties"),
                "Get",
                &(FILE_CHOOSER, "version"),
            )
            .await?;
        Ok((connection, owners))
    }
}

/// Opens the dialog. Returns the address of the file that the user chose.
async fn open(connection: &Connection, request: &FileRequest) -> Result<Uri, Error> {
    let filter = FileFilter::new(request.kind);
    let filter = request.extensions.iter().fold(filter, |filter, extension| {
        filter.glob(&format!("*.{extension}"))
    });
    let response = OpenFileRequest::default()
        .connection(Some(connection.clone()))
        .title(request.title)
        .filter(filter)
        .current_folder::<&PathBuf>(request.folder.as_ref())?
        .send()
        .await?
        .response()?;
    response.uris().first().cloned().ok_or(Error::NoResponse)
}

/// Waits until the portal has lost its name, or the bus has ended.
async fn portal_ends(mut owners: NameOwnerChangedStream) {
    while let Some(change) = owners.next().await {
        // Before a portal that has just been started, the name had no owner.
        if change.args().is_ok_and(|args| args.old_owner().is_some()) {
            break;
        }
    }
}

/// The path that a file's address names: `file:///a%20b` is `/a b`. None for other addresses.
fn path_of(address: &Uri) -> Option<PathBuf> {
    let place = address.as_str().strip_prefix("file:")?;
    let path = match place.strip_prefix("//") {
        Some(place) => &place[place.find('/')?..],
        None => place,
    };
    let bytes: Vec<u8> = percent_decode_str(path).collect();
    Some(OsString::from_vec(bytes).into())
}
