//! A table: in Markdown for pages, in columns of text for a terminal. A column in which no row has a value is left out.

/// Headings and rows.
pub(super) struct Table {
    head: Vec<&'static str>,
    rows: Vec<Vec<String>>,
}

impl Table {
    /// A table of `rows`.
    pub(super) fn of<const N: usize>(
        head: &[&'static str; N],
        rows: impl IntoIterator<Item = [String; N]>,
    ) -> Self {
        Self { head: head.to_vec(), rows: rows.into_iter().map(Into::into).collect() }
    }

    /// As Markdown, or as columns for a terminal; nothing where there is no row.
    pub(super) fn text(&self, plain: bool) -> String {
        let used: Vec<usize> =
            (0..self.head.len()).filter(|n| self.rows.iter().any(|row| !row[*n].is_empty())).collect();
        if used.is_empty() {
            return String::new();
        }
        if plain { self.columns(&used) } else { self.markdown(&used) }
    }

    fn markdown(&self, used: &[usize]) -> String {
        let mut out = String::new();
        let mut line = |cells: &mut dyn Iterator<Item = &str>| {
            for cell in cells {
                out.push_str("| ");
                out.push_str(cell);
                out.push_str(if cell.is_empty() { "" } else { " " });
            }
            out.push_str("|\n");
        };
        line(&mut used.iter().map(|n| self.head[*n]));
        line(&mut used.iter().map(|_| "---"));
        for row in &self.rows {
            line(&mut used.iter().map(|n| row[*n].as_str()));
        }
        out
    }

    fn columns(&self, used: &[usize]) -> String {
        let width = |n: usize| {
            let cells = self.rows.iter().map(|row| row[n].chars().count());
            cells.chain([self.head[n].chars().count()]).max().unwrap_or(0)
        };
        let widths: Vec<usize> = used.iter().map(|n| width(*n)).collect();
        let line = |cells: &mut dyn Iterator<Item = &str>| {
            let padded: Vec<String> =
                cells.zip(&widths).map(|(cell, width)| format!("{cell:<width$}")).collect();
            padded.join("  ").trim_end().to_owned() + "\n"
        };
        let mut out = line(&mut used.iter().map(|n| self.head[*n]));
        for row in &self.rows {
            out += &line(&mut used.iter().map(|n| row[*n].as_str()));
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table() -> Table {
        let rows = [
            ["1".to_owned(), String::new(), "a".to_owned()],
            ["22".to_owned(), String::new(), String::new()],
        ];
        Table::of(&["Bit", "Mode", "Name"], rows)
    }

    #[test]
    fn empty_columns_are_left_out() {
        assert_eq!(table().text(false), "| Bit | Name |\n| --- | --- |\n| 1 | a |\n| 22 | |\n");
        assert_eq!(table().text(true), "Bit  Name\n1    a\n22\n");
        assert_eq!(Table::of(&["Bit"], []).text(false), "");
    }
}
