//! Every origin of a model, with the row that it belongs to.

use super::{Entry, Fact, HomingMethod, Model, Origin};

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
            self.entries.iter().map(|(_, e)| RowOrigins { row: e.address.to_string(), origins: e.origins() }),
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
                    .chain(origin(a.detection.esm.as_ref()))
                    .chain(origin(a.detection.esm_after.as_ref()))
                    .chain(origin(a.detection.sync.as_ref()))
                    .chain(origin(a.detection.al_status.as_ref()))
                    .chain(origin(a.detection.led.as_ref()))
                    .collect(),
            }
        }));
        for pdo in &self.pdos {
            rows.extend(pdo.entries.iter().map(|e| RowOrigins {
                row: format!("pdo {:04X}:{}", pdo.index, e.position),
                origins: vec![&e.origin, &e.bits.origin],
            }));
        }
        for method in &self.homing {
            rows.push(RowOrigins { row: format!("homing {}", method.number), origins: homing(method) });
        }
        rows.extend(
            behaviour(self)
                .map(|(row, origins)| RowOrigins { row, origins: origins.into_iter().flatten().collect() }),
        );
        rows
    }
}

fn homing(method: &HomingMethod) -> Vec<&Origin> {
    let columns = [
        Some(&method.status.origin),
        origin(method.same.as_ref()),
        origin(method.start.as_ref()),
        origin(method.approach.as_ref()),
        origin(method.reference.as_ref()),
        origin(method.side.as_ref()),
        origin(method.edge.as_ref()),
    ];
    let cases = method.cases.iter().flat_map(|c| {
        [Some(&c.when.origin), Some(&c.moves.origin), origin(c.abort.as_ref()), origin(c.mask.as_ref())]
    });
    columns.into_iter().chain(cases).flatten().collect()
}

/// Rows of the small tables, with the origins of the values that they may have.
fn behaviour(model: &Model) -> impl Iterator<Item = (String, Vec<Option<&Origin>>)> {
    let by_mode = model
        .modes
        .iter()
        .map(|m| (format!("mode {}", m.number), vec![Some(&m.name.origin), origin(m.objects.as_ref())]));
    let states = model
        .states
        .iter()
        .map(|s| (format!("state {}", s.name.value), vec![Some(&s.mask.origin), Some(&s.value.origin)]));
    let commands = model.commands.iter().map(|c| {
        let numbers = [Some(&c.mask.origin), Some(&c.value.origin)];
        let rest = [origin(c.edge.as_ref()), origin(c.transitions.as_ref())];
        (format!("command {}", c.name.value), numbers.into_iter().chain(rest).collect())
    });
    let aborts =
        model.aborts.iter().map(|a| (format!("abort {:08X}", a.code.value), vec![Some(&a.name.origin)]));
    let terminals = model.terminals.iter().map(|t| {
        let facts = vec![
            Some(&t.kind.origin),
            origin(t.pin.as_ref()),
            origin(t.object.as_ref()),
            origin(t.bit.as_ref()),
            origin(t.parameter.as_ref()),
        ];
        (format!("terminal {}", t.name), facts)
    });
    let emcy = model
        .emcy
        .iter()
        .map(|e| (format!("emcy {}", e.byte), vec![Some(&e.bytes.origin), Some(&e.holds.origin)]));
    let rules = model.rules.iter().map(|r| {
        let parts = [origin(r.require.as_ref()), origin(r.when.as_ref()), origin(r.on.as_ref())];
        (format!("rule {}", r.id), std::iter::once(Some(&r.text.origin)).chain(parts).collect())
    });
    let examples = model.examples.iter().map(|e| {
        let facts = vec![
            origin(e.write.as_ref()),
            origin(e.entry.as_ref()),
            origin(e.bits.as_ref()),
            origin(e.parameter.as_ref()),
            origin(e.value.as_ref()),
            origin(e.min.as_ref()),
            origin(e.max.as_ref()),
        ];
        (format!("example {}", e.label()), facts)
    });
    by_mode
        .chain(states)
        .chain(commands)
        .chain(aborts)
        .chain(terminals)
        .chain(ethercat(model))
        .chain(emcy)
        .chain(rules)
        .chain(examples)
}

fn ethercat(model: &Model) -> Vec<(String, Vec<Option<&Origin>>)> {
    let whole = &model.ethercat;
    let mut rows = vec![(
        "ethercat".to_owned(),
        vec![
            origin(whole.product_type.as_ref()),
            origin(whole.group.as_ref()),
            origin(whole.physics.as_ref()),
            origin(whole.revision_check.as_ref()),
            origin(whole.mailbox.as_ref()),
            origin(whole.config.as_ref()),
            origin(whole.bootstrap.as_ref()),
            origin(whole.eeprom_bytes.as_ref()),
        ],
    )];
    rows.extend(model.sync_managers.iter().map(|s| {
        let facts = vec![
            Some(&s.carries.origin),
            origin(s.start.as_ref()),
            origin(s.size.as_ref()),
            origin(s.min_size.as_ref()),
            origin(s.max_size.as_ref()),
            origin(s.control.as_ref()),
            origin(s.enable.as_ref()),
        ];
        (format!("sync manager {}", s.number), facts)
    }));
    rows.extend(model.fmmus.iter().map(|f| (format!("fmmu {}", f.number), vec![Some(&f.maps.origin)])));
    rows.extend(
        model.coe.iter().map(|c| (format!("coe {}", c.feature.word()), vec![Some(&c.supported.origin)])),
    );
    rows.extend(model.dc_modes.iter().map(|d| {
        let facts = vec![
            Some(&d.name.origin),
            Some(&d.sync.origin),
            origin(d.assign_activate.as_ref()),
            origin(d.cycle0.as_ref()),
            origin(d.shift0.as_ref()),
            origin(d.cycle1.as_ref()),
            origin(d.shift1.as_ref()),
        ];
        (format!("dc mode {}", d.number), facts)
    }));
    rows.extend(model.startup.iter().map(|s| {
        let facts = [&s.transition.origin, &s.write.origin, &s.value.origin];
        (format!("startup {}", s.number), facts.map(Some).to_vec())
    }));
    rows
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

impl Entry {
    /// One for each value that it has.
    pub fn origins(&self) -> Vec<&Origin> {
        [&self.name.origin, &self.ty.origin, &self.access.origin]
            .into_iter()
            .chain(origin(self.mapping.as_ref()))
            .chain(origin(self.unit.as_ref()))
            .chain(origin(self.min.as_ref()))
            .chain(origin(self.max.as_ref()))
            .chain(origin(self.allow.as_ref()))
            .chain(origin(self.default.as_ref()))
            .chain(origin(self.values.as_ref()))
            .chain(origin(self.bits.as_ref()))
            .chain(origin(self.parameter.as_ref()))
            .chain(origin(self.effect.as_ref()))
            .collect()
    }
}
