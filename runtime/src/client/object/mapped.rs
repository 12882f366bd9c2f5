//! What process data overwrite.

use super::{AccessError, Action, Cause};
use crate::address::Address;
use crate::pdo::MapEntry;

/// That an SDO write to `address` has a lasting effect: `layout` is what the drive receives as process data now, and does
/// not carry it.
///
/// ```
/// use drivewright_runtime::client::object::{is_free, Cause};
/// use drivewright_runtime::pdo::MapEntry;
/// use drivewright_runtime::Address;
///
/// let layout = [0x6040_0010, 0x607A_0020].map(MapEntry::from_word);
/// assert!(is_free(Address::new(0x6081, 0), &layout).is_ok());
/// assert_eq!(is_free(Address::new(0x607A, 0), &layout).unwrap_err().cause, Cause::MappedInRxPdo);
/// ```
///
/// # Errors
/// [`Cause::MappedInRxPdo`].
pub fn is_free(address: Address, layout: &[MapEntry]) -> Result<(), AccessError> {
    if layout.iter().all(|entry| entry.address() != address) {
        return Ok(());
    }
    Err(AccessError { address, action: Action::Write(None), cause: Cause::MappedInRxPdo })
}
