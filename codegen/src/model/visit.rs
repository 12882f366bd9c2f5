//! Every origin of a model, with the row that it belongs to.

use super::{Entry, Fact, Model, Origin};

/// A row of the model, named as messages name it, with the origins of its values.
pub struct RowOrigins<'a> {
    /// `607D:01`, `alarm OF`, `pdo 1600:1`, `enum NAME=1`, `bits NAME.4`, `drive`.
    pub row: String,
    /// One for each value that the row has.
    pub origins: Vec<&'a Origin>,
}

impl Model {
    /// Every row with its origins, table by table.
    pub fn row_origins(&self) -> Vec<RowOrigins<'_>> {
        let mut rows = vec![RowOrigins { row: "drive".to_owned(), origins: limits(self) }];
        rows.extend(
            self.entries.iter().map(|(_, e)| RowOrigins { row: e.address.to_string(), origins: entry(e) }),
        );
        for (_, table) in self.enums.iter() {
            rows.extend(table.values.iter().map(|v| RowOrigins {
                row: format!("enum {}={}", table.name, v.value),
                origins: vec![&v.name.origin],
            }));
        }
        for (_, table) in self.bits.iter() {
            rows.extend(table.fields.iter().map(|f| RowOrigins {
                row: format!("bits {}.{}", table.name, f.bit),
                origins: vec![&f.name.origin],
            }));
        }
        rows.extend(self.alarms.iter().map(|a| {
            RowOrigins {
                row: format!("alarm {}", a.display),
                origins: [&a.number.origin, &a.code.origin, &a.name.origin]
                    .into_iter()
                    .chain(origin(a.aux.as_ref()))
                    .chain(origin(a.reset.as_ref()))
                    .chain(a.causes.iter().chain(&a.remedies).map(|t| &t.origin))
                    .collect(),
            }
        }));
        for pdo in &self.pdos {
            rows.extend(pdo.entries.iter().map(|e| RowOrigins {
                row: format!("pdo {:04X}:{}", pdo.index, e.position),
                origins: vec![&e.origin, &e.bits.origin],
            }));
        }
        rows
    }
}

fn origin<T>(fact: Option<&Fact<T>>) -> Option<&Origin> {
    fact.map(|f| &f.origin)
}

fn limits(model: &Model) -> Vec<&Origin> {
    let limits = &model.drive.limits;
    origin(limits.pdo_entries.as_ref())
        .into_iter()
        .chain(origin(limits.pdo_bytes.as_ref()))
        .chain(origin(limits.pdos_per_direction.as_ref()))
        .collect()
}

fn entry(e: &Entry) -> Vec<&Origin> {
    [&e.name.origin, &e.ty.origin, &e.access.origin]
        .into_iter()
        .chain(origin(e.mapping.as_ref()))
        .chain(origin(e.unit.as_ref()))
        .chain(origin(e.min.as_ref()))
        .chain(origin(e.max.as_ref()))
        .chain(origin(e.allow.as_ref()))
        .chain(origin(e.default.as_ref()))
        .chain(origin(e.values.as_ref()))
        .chain(origin(e.bits.as_ref()))
        .collect()
}
