//! Writes the dictionary: units, data types, objects.

use super::lower::{Dictionary, Info, ObjectDef};
use super::types::{Body, DataType, Flags, Item};
use super::value::Values;
use super::xml::{Xml, hex};

/// The element `Dictionary`.
pub(super) fn write(dictionary: &Dictionary, xml: &mut Xml) {
    xml.group("Dictionary", |xml| {
        if !dictionary.units.is_empty() {
            xml.group("UnitTypes", |xml| {
                for unit in &dictionary.units {
                    xml.group("UnitType", |xml| {
                        xml.text("NotationIndex", hex(unit.notation, 2));
                        xml.text("Name", unit.name);
                        xml.text("Symbol", unit.symbol);
                    });
                }
            });
        }
        xml.group("DataTypes", |xml| dictionary.types.iter().for_each(|ty| data_type(ty, xml)));
        xml.group("Objects", |xml| dictionary.objects.iter().for_each(|object| one(object, xml)));
    });
}

fn data_type(ty: &DataType, xml: &mut Xml) {
    xml.group("DataType", |xml| {
        xml.text("Name", &ty.name);
        if let Some(base) = &ty.base {
            xml.text("BaseType", base);
        }
        xml.text("BitSize", ty.bits);
        match &ty.body {
            Body::Plain => {}
            Body::Array(elements) => xml.group("ArrayInfo", |xml| {
                xml.text("LBound", 1);
                xml.text("Elements", elements);
            }),
            Body::Enumeration(values) => values.iter().for_each(|(text, value)| {
                xml.group("EnumInfo", |xml| {
                    xml.english("Text", text);
                    xml.text("Enum", value);
                });
            }),
            Body::Record(items) => items.iter().for_each(|item| sub_item(item, xml)),
        }
    });
}

fn sub_item(item: &Item, xml: &mut Xml) {
    xml.group("SubItem", |xml| {
        if let Some(sub) = item.sub {
            xml.text("SubIdx", sub);
        }
        xml.text("Name", &item.name);
        xml.text("Type", &item.ty.name);
        xml.text("BitSize", item.ty.bits);
        xml.text("BitOffs", item.offset);
        flags(item.flags, xml);
    });
}

fn flags(flags: Flags, xml: &mut Xml) {
    xml.group("Flags", |xml| {
        xml.text("Access", flags.access);
        if let Some(mapping) = flags.mapping {
            xml.text("PdoMapping", mapping);
        }
    });
}

fn one(object: &ObjectDef, xml: &mut Xml) {
    xml.group("Object", |xml| {
        xml.text("Index", hex(object.index, 4));
        xml.text("Name", &object.name);
        xml.text("Type", &object.ty.name);
        xml.text("BitSize", object.ty.bits);
        info(&object.info, xml);
        flags(object.flags, xml);
    });
}

fn info(info: &Info, xml: &mut Xml) {
    match info {
        Info::One(value) if value.is_empty() => {}
        Info::One(value) => xml.group("Info", |xml| values(value, xml)),
        Info::Each(list) if list.iter().all(|(_, value)| value.is_empty()) => {}
        Info::Each(list) => xml.group("Info", |xml| {
            for (name, value) in list {
                xml.group("SubItem", |xml| {
                    xml.text("Name", name);
                    if value.is_empty() {
                        xml.empty("Info", &[]);
                    } else {
                        xml.group("Info", |xml| values(value, xml));
                    }
                });
            }
        }),
    }
}

fn values(values: &Values, xml: &mut Xml) {
    let texts = [
        ("DefaultString", &values.text),
        ("MinData", &values.min),
        ("MaxData", &values.max),
        ("DefaultData", &values.default),
    ];
    for (name, text) in texts {
        if let Some(text) = text {
            xml.text(name, text);
        }
    }
    if let Some(unit) = values.unit {
        xml.text("Unit", hex(unit, 8));
    }
}
