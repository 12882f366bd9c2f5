//! Each handle of the Rust crate, written a second time from the model as tokens and compared with what the backend
//! wrote: name, type, access, mapping, quantity, address, limits, listed values and scale.
//!
//! The backend writes text, a row a line; here `quote` makes the tokens, so that the two have no code in common.

#![allow(clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use std::collections::BTreeMap;

use drivewright_codegen::backend::rust::Rust;
use drivewright_codegen::model::{Access, Entry, Model, Type};
use drivewright_codegen::name::Case;
use drivewright_codegen::{compile_folder, emit};
use drivewright_tests::cases::golden_cases;
use drivewright_tests::drives;
use proc_macro2::{Group, Ident, Literal, Span, TokenStream, TokenTree};
use quote::{ToTokens, quote};

/// Type and value of each constant of `od.rs`, by name.
fn written(model: &Model) -> BTreeMap<String, String> {
    let (files, _) = emit(model, &[&Rust]);
    let text = std::str::from_utf8(files.get("src/od.rs").expect("od.rs")).expect("UTF-8");
    let items = syn::parse_file(text).expect("Rust").items.into_iter();
    let consts = items.filter_map(|item| match item {
        syn::Item::Const(item) => Some(item),
        _ => None,
    });
    consts.map(|c| (c.ident.to_string(), said(c.ty.to_token_stream(), c.expr.to_token_stream()))).collect()
}

fn said(ty: TokenStream, value: TokenStream) -> String {
    format!("{}: {}", plain(ty), plain(value))
}

/// Numbers in decimal without groups: how a number is written is no part of what it says.
fn plain(tokens: TokenStream) -> TokenStream {
    let one = |token| match token {
        TokenTree::Literal(literal) => match syn::parse_str::<syn::LitInt>(&literal.to_string()) {
            Ok(n) => TokenTree::Literal(Literal::u128_unsuffixed(n.base10_parse().expect("a number"))),
            Err(_) => TokenTree::Literal(literal),
        },
        TokenTree::Group(group) => TokenTree::Group(Group::new(group.delimiter(), plain(group.stream()))),
        other => other,
    };
    tokens.into_iter().map(one).collect()
}

fn number(n: i128) -> TokenStream {
    let digits = Literal::u128_unsuffixed(n.unsigned_abs());
    if n < 0 { quote!(-#digits) } else { quote!(#digits) }
}

fn expected(entry: &Entry, model: &Model) -> String {
    let (value, access, mapping) = (value(entry, model), access(entry.access.value), mapping(entry));
    let quantity =
        word(&entry.unit.as_ref().map_or_else(|| "Raw".to_owned(), |u| format!("{:?}", u.value.quantity)));
    let (index, sub) = (number(entry.address.index.into()), number(entry.address.sub.into()));
    let (limits, allow, scale) = (limits(entry), allow(entry), scale(entry));
    let call = match (limits, scale) {
        (Limits::Both(range), Some(scale)) => quote!(ranged_scaled(#index, #sub, #range, #scale)),
        (Limits::Both(range), None) => quote!(ranged(#index, #sub, #range)),
        (Limits::Builder(limit), Some(scale)) => quote!(scaled(#index, #sub, #scale) #limit),
        (Limits::Builder(limit), None) => quote!(object(#index, #sub) #limit),
    };
    said(quote!(Object<#value, #access, #mapping, #quantity>), quote!(#call #allow))
}

fn word(text: &str) -> Ident {
    Ident::new(text, Span::call_site())
}

/// The type of named values or bits where its width is that of the entry: which one that is, other tests look at.
fn value(entry: &Entry, model: &Model) -> TokenStream {
    let primitive = word(&match entry.ty.value {
        Type::Bool => "bool".to_owned(),
        Type::Int { signed, bits } => {
            let odd = !matches!(bits, 8 | 16 | 32 | 64);
            let letter = if signed { "i" } else { "u" };
            format!("{}{bits}", if odd { letter.to_uppercase() } else { letter.to_owned() })
        }
        Type::Real { bits } => format!("f{bits}"),
        other => format!("{other:?}"),
    });
    let first = |same: &dyn Fn(&Entry) -> bool, signed: bool| {
        let fits = |e: &&Entry| matches!(e.ty.value, Type::Int { signed: s, bits } if matches!(bits, 8 | 16 | 32 | 64) && (signed || !s));
        model.entries.as_slice().iter().filter(fits).find(|e| same(e)).map(|e| e.ty.value)
    };
    let named = entry.values.as_ref().map(|v| v.value).map(|id| {
        let uses = |e: &Entry| e.values.as_ref().is_some_and(|v| v.value == id);
        ("enums", &model.enums[id].name, first(&uses, true))
    });
    let bits = entry.bits.as_ref().map(|b| b.value).map(|id| {
        let uses = |e: &Entry| e.bits.as_ref().is_some_and(|b| b.value == id);
        ("bits", &model.bits[id].name, first(&uses, false))
    });
    match named.or(bits) {
        Some((module, name, Some(ty))) if ty == entry.ty.value => {
            let (module, name) = (word(module), ident(&name.to_identifier(Case::Pascal)));
            quote!(#module::#name)
        }
        _ => quote!(#primitive),
    }
}

/// A keyword gets `_` behind it.
fn ident(text: &str) -> Ident {
    syn::parse_str(text).unwrap_or_else(|_| word(&format!("{text}_")))
}

fn access(access: Access) -> Ident {
    word(match access {
        Access::Ro => "Ro",
        Access::Rw => "Rw",
        Access::Wo => "Wo",
        Access::Const => "Const",
    })
}

fn mapping(entry: &Entry) -> Ident {
    word(match entry.mapping.as_ref().map(|m| m.value.word()) {
        None => "MapNotStated",
        Some("no") => "Unmapped",
        Some("rx") => "Rx",
        Some("tx") => "Tx",
        Some(_) => "RxTx",
    })
}

enum Limits {
    /// Arguments of the call.
    Both(TokenStream),
    /// What stands behind the call, if anything.
    Builder(TokenStream),
}

/// A handle holds what lies between the ends of 64 signed bits.
fn limits(entry: &Entry) -> Limits {
    let inside = |n: &i128| *n > i128::from(i64::MIN) && *n < i128::from(i64::MAX);
    let of = |n: Option<i128>| n.filter(inside).map(number);
    match (of(entry.min.as_ref().map(|f| f.value)), of(entry.max.as_ref().map(|f| f.value))) {
        (Some(min), Some(max)) => Limits::Both(quote!(#min, #max)),
        (Some(min), None) => Limits::Builder(quote!(.at_least(#min))),
        (None, Some(max)) => Limits::Builder(quote!(.at_most(#max))),
        (None, None) => Limits::Builder(quote!()),
    }
}

fn allow(entry: &Entry) -> TokenStream {
    let Some(list) = &entry.allow else { return quote!() };
    if list.value.iter().any(|n| i64::try_from(*n).is_err()) {
        return quote!();
    }
    let list = list.value.iter().map(|n| number(*n));
    quote!(.allow(&[#(#list),*]))
}

fn scale(entry: &Entry) -> Option<TokenStream> {
    let unit = entry.unit.as_ref().filter(|u| u.value.num != u.value.den)?;
    let (num, den) = (number(unit.value.num.into()), number(unit.value.den.into()));
    Some(quote!(#num, #den))
}

fn compare(name: &str, model: &Model) -> usize {
    let written = written(model);
    let entries = model.entries.as_slice();
    for entry in entries {
        let handle = ident(&entry.handle.to_identifier(Case::UpperSnake)).to_string();
        let found = written.get(&handle).unwrap_or_else(|| panic!("{name}: no handle {handle}"));
        assert_eq!(*found, expected(entry, model), "{name}: {handle}");
    }
    assert_eq!(written.len(), entries.len(), "{name}: handles of no entry");
    entries.len()
}

#[test]
fn handles_say_what_the_model_says() {
    let cases = golden_cases();
    let golden: usize = cases.iter().map(|case| compare(&case.name, &case.model())).sum();
    let drives = drives::all();
    let real: usize = drives
        .iter()
        .map(|folder| {
            let (compiled, _) = compile_folder(folder);
            compare(&folder.display().to_string(), compiled.sound().expect("a sound profile"))
        })
        .sum();
    assert!(golden > 100 && real > 600, "{golden} and {real} handles were compared");
}

/// The comparison sees one changed sign.
#[test]
fn a_changed_handle_is_seen() {
    let handle = |text: &str| plain(syn::parse_str(text).expect("tokens")).to_string();
    let right = handle("ranged_scaled(0x6081, 0x00, 0, 60_000, 1, 10)");
    assert_eq!(right, handle("ranged_scaled(24705, 0, 0, 60000, 1, 10)"));
    for wrong in ["ranged_scaled(0x6081, 0x00, 0, 60_000, 10, 1)", "object(0x6081, 0x01)"] {
        assert_ne!(right, handle(wrong));
    }
}
