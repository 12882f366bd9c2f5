//! What the runtime does: a client with any drive, a virtual drive with any master.

mod bytes;
mod client;
mod sim;

use crate::targets::{Kind, Target};

/// `client.step` and `sim.step`.
pub fn targets() -> Vec<Target> {
    vec![
        Target { name: "client.step".into(), kind: Kind::Bytes, function: Box::new(client::step) },
        Target { name: "sim.step".into(), kind: Kind::Bytes, function: Box::new(sim::step) },
    ]
}
