//! The adapter that a text asks for: its number in the list of all, its PCI bus id, or a part of its
//! name. Two equal cards differ only in the first two.

use wgpu::AdapterInfo;

/// The place of the adapter that a text asks for, among all that can be chosen.
///
/// One or two digits mean a number, also that of no adapter: a script that counts too far must not get
/// a card whose name has this digit. Then a text that is a bus id means the bus id, and any other one
/// the name. Of adapters that are one card, as through several interfaces,
/// the first is meant.
///
/// # Errors
/// The places of all that are meant, if they are none or several.
pub fn requested_place(text: &str, adapters: &[AdapterInfo]) -> Result<usize, Vec<usize>> {
    let text = text.trim();
    if let Some(number) = number(text) {
        return if number < adapters.len() {
            Ok(number)
        } else {
            Err(Vec::new())
        };
    }
    let all = |is_meant: &dyn Fn(&AdapterInfo) -> bool| -> Vec<usize> {
        let meant = adapters.iter().enumerate().filter(|(_, it)| is_meant(it));
        meant.map(|(place, _)| place).collect()
    };
    let wanted = text.to_lowercase();
    let meant = match BusId::read(text) {
        Some(bus) => {
            all(&|it| BusId::read(&it.device_pci_bus_id).is_some_and(|its| bus.means(its)))
        }
        None => {
            // A whole name may be a part of another one.
            let whole = all(&|it| it.name.to_lowercase() == wanted);
            if whole.is_empty() {
                all(&|it| it.name.to_lowercase().contains(&wanted))
            } else {
                whole
            }
        }
    };
    match meant[..] {
        [first, ref others @ ..]
            if others
                .iter()
                .all(|it| may_be_one_card(&adapters[first], &adapters[*it])) =>
        {
            Ok(first)
        }
        _ => Err(meant),
    }
}

/// Whether two adapters may be one card: an interface lists it once, or says that both are in one place.
fn may_be_one_card(one: &AdapterInfo, other: &AdapterInfo) -> bool {
    let is_in_one_place = !one.device_pci_bus_id.is_empty()
        && one.device_pci_bus_id == other.device_pci_bus_id
        && one.name == other.name;
    one.backend != other.backend || is_in_one_place
}

/// A number of the list. More digits are those of a name, such as 4090.
fn number(text: &str) -> Option<usize> {
    let is_number = text.len() <= 2 && text.bytes().all(|byte| byte.is_ascii_digit());
    is_number.then(|| text.parse().ok())?
}

/// The place of a card on the PCI bus.
#[derive(Clone, Copy)]
struct BusId {
    domain: Option<u32>,
    bus: u32,
    device: u32,
    function: u32,
}

impl BusId {
    /// Reads `domain:bus:device.function` in hexadecimal digits. The domain may be missing.
    fn read(text: &str) -> Option<Self> {
        let hexadecimal = |digits: &str| u32::from_str_radix(digits, 16).ok();
        let (rest, function) = text.rsplit_once('.')?;
        let (rest, device) = rest.rsplit_once(':')?;
        let (domain, bus) = match rest.rsplit_once(':') {
            Some((domain, bus)) => (Some(hexadecimal(domain)?), bus),
            None => (None, rest),
        };
        Some(Self {
            domain,
            bus: hexadecimal(bus)?,
            device: hexadecimal(device)?,
            function: hexadecimal(function)?,
        })
    }

    fn means(self, other: Self) -> bool {
        let place = |it: Self| (it.bus, it.device, it.function);
        place(self) == place(other) && (self.domain.is_none() || self.domain == other.domain)
    }
}
