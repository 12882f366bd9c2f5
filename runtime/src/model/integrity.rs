//! Whether the tables of a model fit together. Generated tables do; ones built at run time had better be asked.

use core::fmt;

use super::{DriveModel, Meaning, ObjectDesc};
use crate::address::Address;
use crate::mapping::Direction;

/// The first place where the tables of a model do not fit together.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum ModelError {
    /// A row that is found by its address does not come after the one before it, so lookups would miss rows.
    NotAscending {
        /// The later row.
        address: Address,
    },
    /// An entry refers to a unit, a value table or a bit table that is not there.
    NoSuchRow {
        /// The entry.
        address: Address,
    },
    /// Process data carries an entry that the dictionary does not have.
    NotInDictionary {
        /// The mapping object.
        pdo: Address,
        /// What it carries.
        entry: Address,
    },
    /// Process data carries an entry that cannot be mapped in its direction.
    NotMappable {
        /// The mapping object.
        pdo: Address,
        /// What it carries.
        entry: Address,
        /// Direction of the process data, seen from the drive.
        direction: Direction,
    },
    /// Process data carries an entry with another length than that of its type.
    OtherLength {
        /// The mapping object.
        pdo: Address,
        /// What it carries.
        entry: Address,
    },
    /// Process data carries more than it can hold.
    TooLong {
        /// The mapping object.
        pdo: Address,
    },
    /// A homing method does not come after the one before it, or is the same as one without a program.
    Homing {
        /// The method.
        number: i8,
    },
    /// The conditions of a rule cannot be evaluated.
    Rule {
        /// Its place in the table, from 0.
        place: usize,
    },
}

impl fmt::Display for ModelError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotAscending { address } => {
                write!(f, "row {address} does not come after the one before it")
            }
            Self::NoSuchRow { address } => {
                write!(f, "{address} refers to a row that its table does not have")
            }
            Self::NotInDictionary { pdo, entry } => {
                write!(f, "{pdo} maps {entry}, which the dictionary does not have")
            }
            Self::NotMappable { pdo, entry, direction } => {
                write!(f, "{pdo} maps {entry}, which cannot be mapped as {direction:?}")
            }
            Self::OtherLength { pdo, entry } => {
                write!(f, "{pdo} maps {entry} with another length than that of its type")
            }
            Self::Homing { number } => {
                write!(f, "homing method {number} is out of order or the same as one without a program")
            }
            Self::Rule { place } => write!(f, "the conditions of rule {place} cannot be evaluated"),
            Self::TooLong { pdo } => write!(f, "{pdo} maps more than it can hold"),
        }
    }
}

impl core::error::Error for ModelError {}

impl<'m> DriveModel<'m> {
    /// That the tables fit together: rows ascend, references lead somewhere, process data is possible.
    ///
    /// # Errors
    /// The first place where they do not.
    pub fn check(&self) -> Result<(), ModelError> {
        ascending(self.objects().iter().map(ObjectDesc::address))?;
        ascending(self.allowed().iter().map(super::Allowed::address))?;
        ascending(self.texts().iter().map(super::TextDefault::address))?;
        ascending(self.effects().iter().map(super::EffectDesc::address))?;
        self.homing_fits()?;
        if let Some(place) = self.rules().iter().position(|rule| !rule.is_sound()) {
            return Err(ModelError::Rule { place });
        }
        self.objects().iter().try_for_each(|object| self.references_lead_somewhere(object))?;
        self.pdos().iter().try_for_each(|pdo| self.pdo_is_possible(pdo))
    }

    fn homing_fits(&self) -> Result<(), ModelError> {
        let mut last = None;
        for method in self.homing_methods() {
            let number = method.number();
            let program =
                method.same().map_or(true, |_| self.homing(number).is_some_and(|m| !m.cases().is_empty()));
            holds(last < Some(number) && program, ModelError::Homing { number })?;
            last = Some(number);
        }
        Ok(())
    }

    fn references_lead_somewhere(&self, object: &ObjectDesc<'m>) -> Result<(), ModelError> {
        let unit = object.unit_index().is_some() == self.unit_of(object).is_some();
        let meaning = match object.meaning() {
            Meaning::Plain => true,
            Meaning::Enum(_) => self.enum_of(object).is_some(),
            Meaning::Bits(_) => self.bits_of(object).is_some(),
        };
        holds(unit && meaning, ModelError::NoSuchRow { address: object.address() })
    }

    fn pdo_is_possible(&self, pdo: &super::PdoDesc<'m>) -> Result<(), ModelError> {
        for entry in pdo.entries().iter().filter(|e| !is_dummy(e.address())) {
            let (at, entry, bits) = (pdo.address(), entry.address(), entry.bits());
            let object = self.object(entry).ok_or(ModelError::NotInDictionary { pdo: at, entry })?;
            let direction = pdo.direction();
            let refused = object.mapping().allows(direction) == Some(false);
            holds(!refused, ModelError::NotMappable { pdo: at, entry, direction })?;
            let length = object.data_type().bits();
            holds(length == 0 || length == bits.into(), ModelError::OtherLength { pdo: at, entry })?;
        }
        let entries = pdo.max_entries().map_or(true, |max| pdo.entries().len() <= max.into());
        let bytes = pdo.max_bytes().map_or(true, |max| pdo.bits() <= usize::from(max) * 8);
        holds(entries && bytes, ModelError::TooLong { pdo: pdo.address() })
    }
}

/// Gaps: indexes up to 001Fh are data types, and 0000h stands for nothing.
fn is_dummy(address: Address) -> bool {
    address.index() < 0x20
}

fn ascending(addresses: impl Iterator<Item = Address>) -> Result<(), ModelError> {
    let mut last = None;
    for address in addresses {
        holds(last < Some(address), ModelError::NotAscending { address })?;
        last = Some(address);
    }
    Ok(())
}

fn holds(fact: bool, error: ModelError) -> Result<(), ModelError> {
    if fact {
        Ok(())
    } else {
        Err(error)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::prelude::*;
    use crate::rule::{Op, RuleDesc, Term};

    fn row(index: u16, sub: u8) -> ObjectDesc<'static> {
        ObjectDesc::new(Address::new(index, sub), DataType::UNSIGNED16, Access::Rw, Mapping::Rx, "x")
    }

    fn model<'m>(objects: &'m [ObjectDesc<'m>]) -> DriveModel<'m> {
        DriveModel::new(Identity::new("x", "y", "z")).with_objects(objects)
    }

    #[test]
    fn rows_ascend() {
        assert_eq!(model(&[]).check(), Ok(()));
        assert_eq!(model(&[row(1, 0), row(1, 1), row(2, 0)]).check(), Ok(()));
        let address = Address::new(1, 0);
        assert_eq!(model(&[row(1, 0), row(1, 0)]).check(), Err(ModelError::NotAscending { address }));
        assert_eq!(model(&[row(2, 0), row(1, 0)]).check(), Err(ModelError::NotAscending { address }));
    }

    #[test]
    fn references_lead_to_rows() {
        let error = Err(ModelError::NoSuchRow { address: Address::new(1, 0) });
        assert_eq!(model(&[row(1, 0).unit(0)]).check(), error);
        assert_eq!(model(&[row(1, 0).values(0)]).check(), error);
        assert_eq!(model(&[row(1, 0).bits(0)]).check(), error);
    }

    #[test]
    fn homing_methods_ascend_and_lead_to_programs() {
        let cases = [HomingCase::new(&[], &[])];
        let check = |methods: &[HomingDesc<'_>]| {
            DriveModel::new(Identity::new("x", "y", "z")).with_homing(methods).check()
        };
        let (one, two) = (HomingDesc::new(1).with_cases(&cases), HomingDesc::new(2).with_same(1));
        assert_eq!(check(&[one, two]), Ok(()));
        assert_eq!(check(&[two, one]), Err(ModelError::Homing { number: 1 }));
        assert_eq!(check(&[one, one]), Err(ModelError::Homing { number: 1 }));
        assert_eq!(check(&[HomingDesc::new(1), two]), Err(ModelError::Homing { number: 2 }));
        assert_eq!(check(&[two]), Err(ModelError::Homing { number: 2 }));
    }

    #[test]
    fn rules_can_be_evaluated() {
        let check =
            |rules: &[RuleDesc<'_>]| DriveModel::new(Identity::new("x", "y", "z")).with_rules(rules).check();
        let sound = RuleDesc::new("R1", "").with_require(&[Term::Number(1)]);
        let lost = RuleDesc::new("R2", "").with_when(&[Term::Number(1), Term::Apply(Op::Add)]);
        assert_eq!(check(&[sound]), Ok(()));
        assert_eq!(check(&[sound, lost]), Err(ModelError::Rule { place: 1 }));
    }

    #[test]
    fn effects_ascend() {
        let at = |index| EffectDesc::new(Address::new(index, 0), Effect::AtStop);
        let check = |effects: &[EffectDesc]| {
            DriveModel::new(Identity::new("x", "y", "z")).with_effects(effects).check()
        };
        assert_eq!(check(&[at(1), at(2)]), Ok(()));
        let address = Address::new(1, 0);
        assert_eq!(check(&[at(2), at(1)]), Err(ModelError::NotAscending { address }));
    }

    #[test]
    fn process_data_is_possible() {
        let pdo = Address::new(0x1600, 0);
        let entry = Address::new(0x6040, 0);
        let objects = [row(0x6040, 0)];
        let check = |word: u32, direction, most| {
            let entries = [MapEntry::from_word(word), MapEntry::from_word(0x0005_0008)];
            let pdos = [PdoDesc::new(pdo, direction, &entries).with_max_bytes(most).with_max_entries(2)];
            model(&objects).with_pdos(&pdos).check()
        };
        assert_eq!(check(0x6040_0010, Direction::Rx, 3), Ok(()));
        assert_eq!(check(0x6040_0010, Direction::Rx, 2), Err(ModelError::TooLong { pdo }));
        assert_eq!(check(0x6040_0020, Direction::Rx, 8), Err(ModelError::OtherLength { pdo, entry }));
        let direction = Direction::Tx;
        assert_eq!(check(0x6040_0010, direction, 8), Err(ModelError::NotMappable { pdo, entry, direction }));
        let entry = Address::new(0x6040, 1);
        assert_eq!(check(0x6040_0110, Direction::Rx, 8), Err(ModelError::NotInDictionary { pdo, entry }));
    }
}
