//! XML schema of a profile file, made from the same list of tables as the JSON schema.
//!
//! A key may be an attribute or an element, which XSD 1.0 cannot require in either form: that a key must be there is left
//! to the compiler. So are ranges of numbers, since a number has several notations.

use std::fmt::Write;

use crate::emit::escape;
use crate::limits;
use crate::rows::{FieldInfo, Kind, Rows, TableInfo};

/// Types that keys share: numbers in the notations of TOML, and the kinds of value that an element can be marked with.
const SHARED: &str = r#"  <xs:simpleType name="number">
    <xs:restriction base="xs:string">
      <xs:pattern value="[+\-]?(0|[1-9](_?[0-9])*)|0x[0-9A-Fa-f](_?[0-9A-Fa-f])*|0o[0-7](_?[0-7])*|0b[01](_?[01])*"/>
    </xs:restriction>
  </xs:simpleType>
  <xs:simpleType name="bool">
    <xs:restriction base="xs:string">
      <xs:enumeration value="true"/>
      <xs:enumeration value="false"/>
    </xs:restriction>
  </xs:simpleType>
  <xs:simpleType name="kind">
    <xs:restriction base="xs:string">
      <xs:enumeration value="text"/>
      <xs:enumeration value="number"/>
      <xs:enumeration value="bool"/>
      <xs:enumeration value="list"/>
    </xs:restriction>
  </xs:simpleType>
  <xs:complexType name="item">
    <xs:simpleContent>
      <xs:extension base="xs:string"><xs:attribute name="kind" type="kind"/></xs:extension>
    </xs:simpleContent>
  </xs:complexType>
  <xs:complexType name="value" mixed="true">
    <xs:sequence><xs:element name="item" type="item" minOccurs="0" maxOccurs="unbounded"/></xs:sequence>
    <xs:attribute name="kind" type="kind"/>
  </xs:complexType>
"#;

/// The schema as XML text, ending with a line feed.
pub fn profile_xsd() -> String {
    let mut out = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    out.push_str("<!-- drivewright profile, format 1. Written by drivewright from its list of tables. -->\n");
    out.push_str(
        "<xs:schema xmlns:xs=\"http://www.w3.org/2001/XMLSchema\" elementFormDefault=\"qualified\">\n",
    );
    out.push_str("  <xs:element name=\"profile\">\n    <xs:complexType>\n      <xs:all>\n");
    for table in Rows::TABLES {
        let name = table.name;
        let _ = writeln!(out, "        <xs:element name=\"{name}\" type=\"{name}\" minOccurs=\"0\"/>");
    }
    out.push_str("      </xs:all>\n    </xs:complexType>\n  </xs:element>\n");
    for rows in Rows::TABLES {
        table(rows, &mut out);
    }
    out.push_str(SHARED);
    out.push_str("</xs:schema>\n");
    out
}

/// The types of a table: `drive` is a row, any other holds rows.
fn table(table: &TableInfo, out: &mut String) {
    let name = table.name;
    let row = if name == "drive" { name.to_owned() } else { format!("{name}_row") };
    if name != "drive" {
        let _ = writeln!(out, "  <xs:complexType name=\"{name}\">\n    <xs:sequence>");
        let _ = writeln!(
            out,
            "      <xs:element name=\"row\" type=\"{row}\" minOccurs=\"0\" maxOccurs=\"unbounded\"/>"
        );
        out.push_str("    </xs:sequence>\n  </xs:complexType>\n");
    }
    let _ = writeln!(out, "  <xs:complexType name=\"{row}\">");
    documentation(table.doc, "    ", out);
    out.push_str("    <xs:all>\n");
    for field in table.fields {
        let _ = writeln!(out, "      <xs:element name=\"{}\" minOccurs=\"0\"{}", field.key, element(field));
    }
    out.push_str("    </xs:all>\n");
    for field in table.fields {
        attribute(field, out);
    }
    out.push_str("  </xs:complexType>\n");
}

fn documentation(doc: &str, indent: &str, out: &mut String) {
    let doc = escape::xml(&escape::one_line(doc.trim()));
    let _ =
        writeln!(out, "{indent}<xs:annotation><xs:documentation>{doc}</xs:documentation></xs:annotation>");
}

/// The rest of an element that is a key.
fn element(field: &FieldInfo) -> String {
    match &field.kind {
        Kind::List(item) => {
            let item = typed(item);
            let most = limits::LIST_VALUES;
            format!(
                "><xs:complexType><xs:sequence><xs:element name=\"item\" minOccurs=\"0\" maxOccurs=\"{most}\"{item}</xs:sequence></xs:complexType></xs:element>"
            )
        }
        kind => typed(kind),
    }
}

/// A key as an attribute; no attribute can be a list.
fn attribute(field: &FieldInfo, out: &mut String) {
    let ty = match &field.kind {
        Kind::List(_) => return,
        Kind::Int(..) => " type=\"number\"".to_owned(),
        Kind::Bool => " type=\"bool\"".to_owned(),
        Kind::Scalar => " type=\"xs:string\"".to_owned(),
        Kind::Text(_) | Kind::Words(_) => String::new(),
    };
    let _ = writeln!(out, "    <xs:attribute name=\"{}\"{ty}>", field.key);
    documentation(field.doc, "      ", out);
    if let Kind::Text(_) | Kind::Words(_) = &field.kind {
        let _ = writeln!(out, "      {}", restriction(&field.kind));
    }
    out.push_str("    </xs:attribute>\n");
}

/// The rest of an element with a value of that kind.
fn typed(kind: &Kind) -> String {
    match kind {
        Kind::Int(..) => " type=\"number\"/>".to_owned(),
        Kind::Bool => " type=\"bool\"/>".to_owned(),
        Kind::Scalar | Kind::List(_) => " type=\"value\"/>".to_owned(),
        Kind::Text(_) | Kind::Words(_) => format!(">{}</xs:element>", restriction(kind)),
    }
}

/// Texts of a pattern, of some words, or of bounded length.
fn restriction(kind: &Kind) -> String {
    let facets = match kind {
        Kind::Words(words) => {
            let word = |word: &&str| format!("<xs:enumeration value=\"{}\"/>", escape::xml(word));
            words().iter().map(word).collect()
        }
        Kind::Text(Some(pattern)) => format!("<xs:pattern value=\"{}\"/>", escape::xml(&whole(pattern))),
        _ => format!("<xs:minLength value=\"1\"/><xs:maxLength value=\"{}\"/>", limits::TEXT_BYTES),
    };
    format!("<xs:simpleType><xs:restriction base=\"xs:string\">{facets}</xs:restriction></xs:simpleType>")
}

/// A pattern of JSON schema, which matches anywhere without anchors, as one of XSD, which always matches the whole.
fn whole(pattern: &str) -> String {
    let (begun, ended) = (pattern.strip_prefix('^'), pattern.strip_suffix('$'));
    let inner = begun.unwrap_or(pattern);
    let inner = inner.strip_suffix('$').unwrap_or(inner);
    let any = |anchored: Option<&str>| if anchored.is_some() { "" } else { ".*" };
    format!("{}{inner}{}", any(begun), any(ended))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patterns_match_the_whole() {
        assert_eq!(whole("^a$"), "a");
        assert_eq!(whole("L[0-9]+"), ".*L[0-9]+.*");
    }

    #[test]
    fn every_table_and_key_is_there() {
        let xsd = profile_xsd();
        for table in Rows::TABLES {
            assert!(xsd.contains(&format!("<xs:element name=\"{0}\" type=\"{0}\"", table.name)));
            for field in table.fields {
                let list = matches!(field.kind, Kind::List(_));
                assert!(xsd.contains(&format!("<xs:element name=\"{}\" ", field.key)));
                assert!(list || xsd.contains(&format!("<xs:attribute name=\"{}\"", field.key)));
            }
        }
    }
}
