//! Gives a layout to a drive, in the order of the standard.

use core::fmt;

use super::plan::is_fixed;
use super::{assignment, Plan, PlanError};
use crate::address::Address;
use crate::client::message::{displays, Explain, Lines};
use crate::client::object::{taken, AccessError, Action};
use crate::client::tally::count;
use crate::model::DriveModel;
use crate::procedure::{Answer, Ask, Procedure};
use crate::time::Instant;

/// Writes a layout: nothing is assigned, nothing is mapped, the entries, their number, for every PDO; then the PDOs are
/// assigned, and last their number. The drive must be in a state that allows it: `PreOP` on EtherCAT.
///
/// Read it back before it is used.
#[derive(Clone, Copy, Debug)]
pub struct Write<'p, 'm> {
    plan: Plan<'p>,
    model: &'m DriveModel<'m>,
    step: usize,
    bytes: [u8; 4],
}

/// A layout that is written in part.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub struct WriteError {
    /// Which write failed, from 1.
    pub step: usize,
    /// How many there are.
    pub steps: usize,
    /// Why.
    pub error: AccessError,
}

/// One write: where, what, how many bytes.
type Step = (Address, u32, usize);

impl<'p, 'm> Write<'p, 'm> {
    /// The write of `plan`.
    ///
    /// # Errors
    /// Those of [`Plan::check`]; nothing was sent then.
    pub fn new(model: &'m DriveModel<'m>, plan: Plan<'p>) -> Result<Self, PlanError<'m>> {
        plan.check(model)?;
        Ok(Self { plan, model, step: 0, bytes: [0; 4] })
    }

    /// All writes, in order.
    pub fn steps(&self) -> impl Iterator<Item = (Address, u32, usize)> + '_ {
        let assign = |sub| assignment(self.plan.direction(), sub);
        let mapped = self.plan.pdos().iter().filter(|pdo| !self.is_fixed(pdo.index()));
        let maps = mapped.flat_map(|pdo| {
            let at = |sub| Address::new(pdo.index(), sub);
            let entries =
                (1..=u8::MAX).zip(pdo.entries()).map(move |(sub, entry)| (at(sub), entry.word(), 4));
            let none = core::iter::once((at(0), 0, 1));
            none.chain(entries).chain(core::iter::once((at(0), number(pdo.entries().len()), 1)))
        });
        let assigned = (1..=u8::MAX).zip(self.plan.pdos());
        let assigned = assigned.map(move |(sub, pdo)| (assign(sub), u32::from(pdo.index()), 2));
        let last = core::iter::once((assign(0), number(self.plan.pdos().len()), 1));
        core::iter::once((assign(0), 0, 1)).chain(maps).chain(assigned).chain(last)
    }

    fn is_fixed(&self, index: u16) -> bool {
        is_fixed(self.model.pdo(Address::new(index, 0)))
    }

    fn at(&self, step: usize) -> Option<Step> {
        self.steps().nth(step)
    }

    fn failed(&self, error: AccessError) -> WriteError {
        WriteError { step: self.step, steps: count(self.steps()), error }
    }
}

/// A number of entries; the plan has checked that there are few.
fn number(entries: usize) -> u32 {
    u32::try_from(entries).unwrap_or(u32::MAX)
}

impl Procedure for Write<'_, '_> {
    /// How many writes there were.
    type Output = Result<usize, WriteError>;

    fn next(&mut self, _: Instant, answer: Answer<'_>) -> Ask<'_, Self::Output> {
        if let Some((address, value, _)) = self.step.checked_sub(1).and_then(|step| self.at(step)) {
            if let Err(error) = taken(address, Some(value.into()), answer) {
                return Ask::Done(Err(self.failed(error)));
            }
        }
        let Some((address, value, width)) = self.at(self.step) else { return Ask::Done(Ok(self.step)) };
        self.step = self.step.saturating_add(1);
        self.bytes = value.to_le_bytes();
        Ask::Download(address, self.bytes.get(..width).unwrap_or(&[]))
    }
}

impl Explain for WriteError {
    fn code(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.error.code(f)
    }

    fn what(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.error.what(f)
    }

    fn details(&self, lines: &mut Lines<'_, '_>) -> fmt::Result {
        lines.line("step", format_args!("{} of {} of the layout", self.step, self.steps))?;
        if let Action::Write(Some(value)) = self.error.action {
            lines.line("raw", format_args!("{value:X}h"))?;
        }
        if self.step > 1 {
            lines.line("effect", "no PDO is assigned in this direction now")?;
        }
        self.error.details(lines)
    }

    fn why(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.error.why(f)
    }

    fn remedy(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.error.remedy(f)
    }
}

displays! {
    [] WriteError;
}
