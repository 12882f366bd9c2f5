//! Counting without the check for overflow that `Iterator::count` has, which would be a reachable panic.

/// How many items there are; `usize::MAX` at most.
pub(crate) fn count<T>(items: impl Iterator<Item = T>) -> usize {
    items.fold(0, |sum: usize, _| sum.saturating_add(1))
}

/// The sum; `usize::MAX` at most.
pub(crate) fn sum(items: impl Iterator<Item = usize>) -> usize {
    items.fold(0, usize::saturating_add)
}
