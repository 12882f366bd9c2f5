//! The process image: where the signals of an axis are in the process data that are in use.

use core::fmt;

use crate::address::Address;
use crate::cia402::{Mode, Statusword};
use crate::client::axis::{Outputs, Sample};
use crate::model::DriveModel;
use crate::pdo::MapEntry;

/// The most bytes of process data in a direction.
pub const FRAME_BYTES: usize = 64;
/// The objects of the next axis of a drive lie this much higher.
const AXIS_OFFSET: u16 = 0x800;

macro_rules! signals {
    ($($(#[$doc:meta])* $name:ident { $($(#[$signal_doc:meta])* $signal:ident = $index:literal, $bits:literal;)* })*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize))]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        pub enum $name {
            $($(#[$signal_doc])* $signal,)*
        }

        impl $name {
            /// All of them.
            pub const ALL: &'static [Self] = &[$(Self::$signal),*];

            /// Its entry for the first axis of a drive.
            pub const fn address(self) -> Address {
                match self {
                    $(Self::$signal => Address::new($index, 0),)*
                }
            }

            /// Its length, CiA 402.
            pub const fn bits(self) -> u8 {
                match self {
                    $(Self::$signal => $bits,)*
                }
            }
        }
    )*};
}

signals! {
    /// What goes to the drive.
    Output {
        /// Mode of operation.
        Mode = 0x6060, 8;
        /// Target position.
        Position = 0x607A, 32;
        /// Target velocity.
        Velocity = 0x60FF, 32;
        /// Target torque.
        Torque = 0x6071, 16;
        /// Controlword: the last one, so that what it starts has arrived before.
        Controlword = 0x6040, 16;
    }
    /// What comes from the drive.
    Input {
        /// Statusword.
        Statusword = 0x6041, 16;
        /// Mode of operation that is active.
        Mode = 0x6061, 8;
        /// Actual position.
        Position = 0x6064, 32;
        /// Actual velocity.
        Velocity = 0x606C, 32;
        /// Actual torque.
        Torque = 0x6077, 16;
        /// Error code.
        ErrorCode = 0x603F, 16;
    }
}

impl Output {
    /// The value on the wire; as many bytes of it count as the signal has.
    pub(super) const fn bytes(self, outputs: &Outputs) -> [u8; 4] {
        let [low, high] = match self {
            Self::Position => return outputs.position.to_le_bytes(),
            Self::Velocity => return outputs.velocity.to_le_bytes(),
            Self::Mode => [outputs.mode.0.to_le_bytes()[0], 0],
            Self::Torque => outputs.torque.to_le_bytes(),
            Self::Controlword => outputs.controlword.0.to_le_bytes(),
        };
        [low, high, 0, 0]
    }
}

/// What has come in so far: from process data, and by SDO where process data do not carry it.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Reading {
    statusword: Option<Statusword>,
    rest: Sample,
}

impl Reading {
    /// Takes a signal from its bytes; `None` unless they are as many as it has.
    #[must_use]
    pub fn take(mut self, input: Input, bytes: &[u8]) -> Option<Self> {
        let two = || <[u8; 2]>::try_from(bytes).ok();
        let four = || <[u8; 4]>::try_from(bytes).ok();
        match input {
            Input::Statusword => self.statusword = Some(Statusword(u16::from_le_bytes(two()?))),
            Input::Mode => self.rest.mode = Some(Mode(i8::from_le_bytes(bytes.try_into().ok()?))),
            Input::Position => self.rest.position = Some(i32::from_le_bytes(four()?)),
            Input::Velocity => self.rest.velocity = Some(i32::from_le_bytes(four()?)),
            Input::Torque => self.rest.torque = Some(i16::from_le_bytes(two()?)),
            Input::ErrorCode => self.rest.error_code = Some(u16::from_le_bytes(two()?)),
        }
        Some(self)
    }

    /// The statusword, if it has come.
    pub const fn statusword(&self) -> Option<Statusword> {
        self.statusword
    }

    /// The sample; `None` without a statusword.
    pub fn sample(&self) -> Option<Sample> {
        Some(Sample { statusword: self.statusword?, ..self.rest })
    }
}

/// Why process data cannot be used.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum ImageError {
    /// The model has no process data with this mapping object.
    NoPdo {
        /// Its index.
        index: u16,
    },
    /// An entry has another length than the signal that it is.
    Width {
        /// What is mapped.
        entry: MapEntry,
        /// The length of the signal, in bits.
        expected: u8,
    },
    /// An entry is not one or more whole bytes.
    NotBytes {
        /// What is mapped.
        entry: MapEntry,
    },
    /// There are more bytes than [`FRAME_BYTES`].
    TooLong,
    /// The drive sent another number of bytes than the layout has.
    Length {
        /// Bytes of the layout.
        expected: usize,
        /// Bytes that came.
        found: usize,
    },
}

impl fmt::Display for ImageError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoPdo { index } => write!(f, "the model has no process data {index:04X}h"),
            Self::Width { entry, expected } => write!(f, "{entry} is mapped, the signal has {expected} bit"),
            Self::NotBytes { entry } => write!(f, "{entry} is mapped, which is not whole bytes"),
            Self::TooLong => write!(f, "more than {FRAME_BYTES} bytes are mapped"),
            Self::Length { expected, found } => {
                write!(f, "the drive sent {found} bytes of process data, the layout has {expected}")
            }
        }
    }
}

impl core::error::Error for ImageError {}

/// Where the signals are. What is not mapped goes by SDO, and is named by [`unmapped_outputs`](Self::unmapped_outputs) and
/// [`unmapped_inputs`](Self::unmapped_inputs).
///
/// ```
/// use drivewright_runtime::client::image::{Image, Input, Output};
/// use drivewright_runtime::pdo::MapEntry;
///
/// let rx = [0x6040_0010, 0x607A_0020].map(MapEntry::from_word);
/// let tx = [0x6041_0010, 0x6064_0020].map(MapEntry::from_word);
/// let image = Image::new(&rx, &tx).unwrap();
/// assert_eq!((image.rx_bytes(), image.output(Output::Position)), (6, Some(2)));
/// assert!(image.unmapped_inputs().any(|signal| signal == Input::Mode));
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Image<'m> {
    rx: &'m [MapEntry],
    tx: &'m [MapEntry],
    axis: u8,
}

impl<'m> Image<'m> {
    /// The image of these layouts: what the drive receives, and what it sends. Both empty: everything goes by SDO.
    ///
    /// # Errors
    /// [`ImageError`] where a signal has the wrong length, an entry is not whole bytes, or there is no room.
    pub fn new(rx: &'m [MapEntry], tx: &'m [MapEntry]) -> Result<Self, ImageError> {
        Self::for_axis(rx, tx, 0)
    }

    /// As [`new`](Self::new) for one axis of several, which count from 0: its objects lie 800h higher for each.
    ///
    /// # Errors
    /// As of [`new`](Self::new).
    pub fn for_axis(rx: &'m [MapEntry], tx: &'m [MapEntry], axis: u8) -> Result<Self, ImageError> {
        let image = Self { rx, tx, axis };
        let is_odd = |entry: &&MapEntry| entry.bits() == 0 || entry.bits() % 8 != 0;
        if let Some(entry) = rx.iter().chain(tx).find(is_odd) {
            return Err(ImageError::NotBytes { entry: *entry });
        }
        if bytes(rx) > FRAME_BYTES || bytes(tx) > FRAME_BYTES {
            return Err(ImageError::TooLong);
        }
        Output::ALL.iter().try_for_each(|signal| image.width(rx, signal.address(), signal.bits()))?;
        Input::ALL.iter().try_for_each(|signal| image.width(tx, signal.address(), signal.bits()))?;
        Ok(image)
    }

    /// The image of the process data that a model has at these mapping objects: 1600h and up, 1A00h and up.
    ///
    /// # Errors
    /// [`ImageError::NoPdo`], and those of [`new`](Self::new).
    pub fn of(model: &DriveModel<'m>, rx: u16, tx: u16) -> Result<Self, ImageError> {
        let entries = |index| match model.pdo(Address::new(index, 0)) {
            Some(pdo) => Ok(pdo.entries()),
            None => Err(ImageError::NoPdo { index }),
        };
        Self::new(entries(rx)?, entries(tx)?)
    }

    fn width(&self, layout: &[MapEntry], address: Address, expected: u8) -> Result<(), ImageError> {
        let address = self.at(address);
        match layout.iter().find(|entry| entry.address() == address) {
            Some(entry) if entry.bits() != expected => Err(ImageError::Width { entry: *entry, expected }),
            _ => Ok(()),
        }
    }

    /// The entry of this axis that is at `address` for the first one. Entries outside 6000h to 67FFh are those of the
    /// device, which all axes share.
    pub const fn at(&self, address: Address) -> Address {
        if address.index() < 0x6000 || address.index() > 0x67FF {
            return address;
        }
        let offset = AXIS_OFFSET.saturating_mul(self.axis as u16);
        Address::new(address.index().saturating_add(offset), address.sub())
    }

    /// What the drive receives.
    pub const fn rx(&self) -> &'m [MapEntry] {
        self.rx
    }

    /// What the drive sends.
    pub const fn tx(&self) -> &'m [MapEntry] {
        self.tx
    }

    /// Bytes that the drive receives.
    pub fn rx_bytes(&self) -> usize {
        bytes(self.rx)
    }

    /// Bytes that the drive sends.
    pub fn tx_bytes(&self) -> usize {
        bytes(self.tx)
    }

    /// Whether there are process data at all.
    pub const fn is_empty(&self) -> bool {
        self.rx.is_empty() && self.tx.is_empty()
    }

    /// The first byte of an output; `None` if it is not mapped.
    pub fn output(&self, signal: Output) -> Option<usize> {
        offset(self.rx, self.at(signal.address()))
    }

    /// The first byte of an input; `None` if it is not mapped.
    pub fn input(&self, signal: Input) -> Option<usize> {
        offset(self.tx, self.at(signal.address()))
    }

    /// Outputs that go by SDO.
    pub fn unmapped_outputs(&self) -> impl Iterator<Item = Output> + '_ {
        Output::ALL.iter().copied().filter(|signal| self.output(*signal).is_none())
    }

    /// Inputs that come by SDO.
    pub fn unmapped_inputs(&self) -> impl Iterator<Item = Input> + '_ {
        Input::ALL.iter().copied().filter(|signal| self.input(*signal).is_none())
    }

    /// Entries that the drive receives and that are no outputs of an axis: the program sets them, see
    /// [`place`](Self::place).
    pub fn others(&self) -> impl Iterator<Item = MapEntry> + '_ {
        let is_output =
            |entry: &MapEntry| Output::ALL.iter().any(|s| self.at(s.address()) == entry.address());
        self.rx.iter().copied().filter(move |entry| !is_output(entry))
    }

    /// Writes the outputs that are mapped; other bytes of `frame` stay.
    pub fn pack(&self, outputs: &Outputs, frame: &mut [u8]) {
        for signal in Output::ALL {
            if let Some(at) = self.output(*signal) {
                put(frame, at, signal.bits(), &signal.bytes(outputs));
            }
        }
    }

    /// Writes an entry that the drive receives; whether it is mapped.
    pub fn place(&self, address: Address, value: &[u8], frame: &mut [u8]) -> bool {
        let entry = self.rx.iter().find(|entry| entry.address() == address);
        match (entry, offset(self.rx, address)) {
            (Some(entry), Some(at)) => {
                put(frame, at, entry.bits(), value);
                true
            }
            _ => false,
        }
    }

    /// Reads the inputs that are mapped.
    ///
    /// # Errors
    /// [`ImageError::Length`] unless there are exactly as many bytes as the layout has.
    pub fn unpack(&self, frame: &[u8]) -> Result<Reading, ImageError> {
        let expected = self.tx_bytes();
        if frame.len() != expected {
            return Err(ImageError::Length { expected, found: frame.len() });
        }
        Ok(Input::ALL.iter().fold(Reading::default(), |reading, signal| {
            self.input(*signal)
                .and_then(|at| frame.get(at..at.saturating_add(usize::from(signal.bits() / 8))))
                .and_then(|bytes| reading.take(*signal, bytes))
                .unwrap_or(reading)
        }))
    }
}

fn put(frame: &mut [u8], at: usize, bits: u8, value: &[u8]) {
    let length = usize::from(bits / 8);
    let place = frame.get_mut(at..at.saturating_add(length));
    if let (Some(place), Some(value)) = (place, value.get(..length)) {
        place.copy_from_slice(value);
    }
}

fn bytes(layout: &[MapEntry]) -> usize {
    layout.iter().fold(0_usize, |bits, entry| bits.saturating_add(entry.bits().into())).div_ceil(8)
}

/// The first byte of an entry. Layouts of an image have whole bytes.
fn offset(layout: &[MapEntry], address: Address) -> Option<usize> {
    let before = layout.iter().position(|entry| entry.address() == address)?;
    Some(bytes(layout.get(..before)?))
}
