//! Prints a configuration: as a device configuration file (CiA 306) and as a concise one (CiA 302).

use crate::backend::eds::{self, Commissioning};
use crate::configuration::{Configuration, Write};
use crate::emit::escape;
use crate::model::Model;

/// Longest `FileName`: behind its key, a line has the 255 characters that CiA 306 allows.
const LONGEST: usize = 246;

/// The device configuration file of a drive, which says that it is called `name`. It is the EDS with `ParameterValue`s and
/// a section `DeviceComissioning`.
pub fn file(model: &Model, configuration: &Configuration, name: &str) -> String {
    let name: String = escape::ini(name).chars().take(LONGEST).collect();
    let commissioning = Commissioning {
        file: &name,
        node_id: configuration.node_id,
        name: configuration.name.as_deref().unwrap_or_default(),
        bit_rate: configuration.bit_rate,
        network: configuration.network,
        serial: configuration.serial,
        values: configuration.values(),
    };
    eds::configured(model, &commissioning)
}

/// The concise device configuration: how many writes there are, then each one with index, sub-index, length and value, all
/// little-endian. A master writes them in this order.
pub fn concise(configuration: &Configuration) -> Vec<u8> {
    let writes = &configuration.writes;
    // A drive has far less entries than 32 bits count.
    let mut out = u32::try_from(writes.len()).unwrap_or(u32::MAX).to_le_bytes().to_vec();
    for write in writes {
        add(write, &mut out);
    }
    out
}

fn add(write: &Write, out: &mut Vec<u8>) {
    out.extend(write.address.index.to_le_bytes());
    out.push(write.address.sub);
    out.extend(u32::from(write.bytes).to_le_bytes());
    out.extend(write.value.to_le_bytes().into_iter().take(write.bytes.into()));
}
