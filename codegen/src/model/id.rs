//! Typed ids and the arenas they index.

use std::fmt;
use std::marker::PhantomData;
use std::ops::Index;

/// Index and sub-index of a dictionary entry.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Address {
    /// Index.
    pub index: u16,
    /// Sub-index.
    pub sub: u8,
}

impl Address {
    /// The entry `index:sub`.
    pub const fn new(index: u16, sub: u8) -> Self {
        Self { index, sub }
    }
}

impl fmt::Display for Address {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:04X}:{:02X}", self.index, self.sub)
    }
}

impl From<Address> for drivewright_runtime::Address {
    fn from(at: Address) -> Self {
        Self::new(at.index, at.sub)
    }
}

impl From<drivewright_runtime::Address> for Address {
    fn from(at: drivewright_runtime::Address) -> Self {
        Self::new(at.index(), at.sub())
    }
}

/// A place in an [`Arena`].
pub trait Id: Copy {
    /// The id of place `n`.
    fn at(n: usize) -> Self;
    /// The place.
    fn place(self) -> usize;
}

macro_rules! ids {
    ($($(#[$doc:meta])* $name:ident)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        pub struct $name(u32);

        impl Id for $name {
            fn at(n: usize) -> Self {
                Self(u32::try_from(n).unwrap_or(u32::MAX))
            }
            fn place(self) -> usize {
                self.0 as usize
            }
        }
    )*};
}

ids! {
    /// An object (an index).
    ObjectId
    /// An entry (an index and sub-index).
    EntryId
    /// A value table.
    EnumId
    /// A bit table.
    BitsId
    /// An erratum.
    ErratumId
}

/// A list whose places are typed ids.
#[derive(Clone, PartialEq, Debug)]
pub struct Arena<I, T> {
    items: Vec<T>,
    id: PhantomData<fn() -> I>,
}

impl<I: Id, T> Arena<I, T> {
    /// An arena of `items`.
    pub fn new(items: Vec<T>) -> Self {
        Self { items, id: PhantomData }
    }

    /// Adds an item.
    pub fn push(&mut self, item: T) -> I {
        self.items.push(item);
        I::at(self.items.len() - 1)
    }

    /// Items with their ids, in order.
    pub fn iter(&self) -> impl DoubleEndedIterator<Item = (I, &T)> + ExactSizeIterator {
        self.items.iter().enumerate().map(|(n, item)| (I::at(n), item))
    }

    /// The items.
    pub fn as_slice(&self) -> &[T] {
        &self.items
    }

    /// The items, to change them.
    pub fn as_mut_slice(&mut self) -> &mut [T] {
        &mut self.items
    }

    /// How many items there are.
    pub fn len(&self) -> usize {
        self.items.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.items.is_empty()
    }
}

impl<I: Id, T> Default for Arena<I, T> {
    fn default() -> Self {
        Self::new(Vec::new())
    }
}

impl<I: Id, T> Index<I> for Arena<I, T> {
    type Output = T;

    fn index(&self, id: I) -> &T {
        &self.items[id.place()]
    }
}
