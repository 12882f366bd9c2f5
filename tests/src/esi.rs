//! ESI files as ethercat-esi can read them.

/// The file without the PDOs that are not active by default: ethercat-esi demands the attribute `Sm` of each PDO, which
/// ETG.2000 leaves out where a PDO can only be chosen.
pub fn with_active_pdos(xml: &str) -> String {
    let mut out = xml.to_owned();
    for (start, end) in [("<RxPdo ", "</RxPdo>"), ("<TxPdo ", "</TxPdo>")] {
        let mut from = 0;
        while let Some(at) = out.get(from..).and_then(|rest| rest.find(start)).map(|at| from + at) {
            let tag = out[at..].split('>').next().unwrap_or_default().to_owned();
            let Some(length) = out[at..].find(end) else { break };
            if tag.contains(" Sm=") {
                from = at + length;
            } else {
                out.replace_range(at..at + length + end.len(), "");
            }
        }
    }
    out
}
