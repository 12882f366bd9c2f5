//! A compiled profile as the runtime executes it: the tables that a generated crate has as statics, made at run time.
//!
//! The [`DriveModel`] is the same type with the same rows, so that a client or a virtual drive cannot tell whether its
//! drive was compiled or loaded. A test compares the two.
//!
//! ```
//! # use drivewright_codegen::{live, compile, source::Source};
//! # let text = include_str!("../../tests/fixtures/drive.toml").to_owned();
//! # let compiled = compile(vec![Source { path: "drive.toml".into(), text }]);
//! # let profile = compiled.model.as_ref().unwrap();
//! let arena = live::Arena::default();
//! let live = live::tables(profile, &arena);
//! assert_eq!(live.model().identity().id(), profile.drive.id);
//! assert_eq!(live.model().check(), Ok(()));
//! ```

mod alarms;
mod behaviour;
mod dictionary;
mod homing;

use bumpalo::Bump;
use drivewright_runtime::model::{AlarmDesc, AlarmText, DriveModel, Identity};
use drivewright_runtime::rule::RuleDesc;

use crate::model::{Address, Model, Origin};

/// Where the tables of a drive lie, as long as somebody uses them. One may hold those of several drives.
#[derive(Default, Debug)]
pub struct Arena(Bump);

impl Arena {
    fn slice<T: Copy>(&self, rows: impl IntoIterator<Item = T>) -> &[T] {
        let rows: Vec<T> = rows.into_iter().collect();
        self.0.alloc_slice_copy(&rows)
    }
}

/// A drive as the runtime executes it.
#[derive(Clone, Copy, Debug)]
pub struct Live<'a> {
    profile: &'a Model,
    model: &'a DriveModel<'a>,
    alarm_texts: &'a [AlarmText<'a>],
}

/// The tables of a profile without errors.
pub fn tables<'a>(profile: &'a Model, arena: &'a Arena) -> Live<'a> {
    let model = DriveModel::new(identity(profile));
    let model = dictionary::tables(profile, arena, &model);
    let model = behaviour::tables(profile, arena, &model)
        .with_alarms(alarms::table(profile, arena))
        .with_homing(homing::table(profile, arena));
    Live { profile, model: arena.0.alloc(model), alarm_texts: alarms::texts(profile, arena) }
}

impl<'a> Live<'a> {
    /// The drive as data.
    pub fn model(&self) -> &'a DriveModel<'a> {
        self.model
    }

    /// Causes and remedies of its alarms.
    pub fn alarm_texts(&self) -> &'a [AlarmText<'a>] {
        self.alarm_texts
    }

    /// What it was made from.
    pub fn profile(&self) -> &'a Model {
        self.profile
    }

    /// Where an entry comes from, for the last line of a message: `6.2 T6-2 L1236`, or `standard: cia402`.
    pub fn object_source(&self, address: drivewright_runtime::Address) -> Option<String> {
        let (_, entry) = self.profile.entry(Address::from(address))?;
        entry.name.origin.source()
    }

    /// Where an alarm comes from.
    pub fn alarm_source(&self, alarm: &AlarmDesc<'_>) -> Option<String> {
        let row = self.profile.alarms.iter().find(|row| alarm.is(&row.display, row.number.value))?;
        row.name.origin.source()
    }

    /// Where a rule comes from.
    pub fn rule_source(&self, rule: &RuleDesc<'_>) -> Option<String> {
        let row = self.profile.rules.iter().find(|row| row.id == rule.id())?;
        Origin::source(&row.text.origin)
    }
}

fn identity(profile: &Model) -> Identity<'_> {
    let drive = &profile.drive;
    let [vendor, product, revision, _] = profile.identity();
    let identity = Identity::new(&drive.id, &drive.vendor, &drive.name);
    let identity = vendor.map_or(identity, |id| identity.with_vendor_id(id));
    let identity = product.map_or(identity, |code| identity.with_product_code(code));
    revision.map_or(identity, |number| identity.with_revision(number))
}
