//! What to do about a missing or old graphics driver, on each operating system.

/// What is missing where no adapter is found, and what to do. `os` is a name as in
/// [`std::env::consts::OS`].
pub fn without_adapter(os: &str) -> &'static str {
    match os {
        "windows" => {
            "no graphics adapter with Vulkan or Direct3D 12 was found: install the newest driver from the maker of the \
             graphics card"
        }
        "macos" => {
            "no Metal adapter was found: update macOS, and start the program on the Mac itself, because a virtual machine \
             may have no adapter"
        }
        _ => {
            "no Vulkan adapter was found: install the Vulkan driver of the graphics card; on Debian and Ubuntu the packages \
             libvulkan1 and mesa-vulkan-drivers serve cards of AMD and Intel and also draw without a card, and cards of \
             NVIDIA need NVIDIA's own driver"
        }
    }
}

/// What to do where an adapter cannot be used or fails. `os` is as in [`without_adapter`].
pub fn with_old_driver(os: &str) -> &'static str {
    match os {
        "windows" => "install the newest driver from the maker of the graphics card",
        "macos" => "update macOS, which brings its graphics drivers",
        _ => {
            "update the graphics driver or, on Debian and Ubuntu, install mesa-vulkan-drivers, which also draws without a \
             graphics card"
        }
    }
}
