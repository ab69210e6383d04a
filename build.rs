//! Gives lightfall.exe its icon, its version information and its manifest. On other systems it does
//! nothing.

use std::error::Error;

const ICON: &str = "assets/icon/lightfall.ico";
const MANIFEST: &str = "packaging/windows/manifest.xml";

fn main() -> Result<(), Box<dyn Error>> {
    for file in [ICON, MANIFEST] {
        println!("cargo::rerun-if-changed={file}");
    }
    // The system of the program, which need not be the one that builds it.
    if std::env::var("CARGO_CFG_TARGET_OS")? == "windows" {
        let mut resource = winresource::WindowsResource::new();
        resource
            .set_icon(ICON)
            .set_manifest_file(MANIFEST)
            .set("ProductName", "Lightfall")
            .set("FileDescription", "Lightfall")
            .set("OriginalFilename", "lightfall.exe")
            .set(
                "LegalCopyright",
                "The Lightfall developers, MIT or Apache-2.0",
            );
        resource.compile()?;
    }
    Ok(())
}
