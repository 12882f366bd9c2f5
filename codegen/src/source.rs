//! Input texts and places in them.
//!
//! Every value that a profile states keeps a [`Span`], so that each diagnostic can point at it. Nothing here touches the
//! file system: [`crate::load`] does, and hands texts over.

use std::fmt;

/// A file of the run, by its position in the [`SourceMap`].
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct FileId(u32);

/// A place in a file: bytes `start..end`.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Span {
    /// The file.
    pub file: FileId,
    /// First byte.
    pub start: u32,
    /// One past the last byte.
    pub end: u32,
}

impl Span {
    /// A span of `file` over `range` of bytes.
    pub fn new(file: FileId, range: std::ops::Range<usize>) -> Self {
        let clamp = |n: usize| u32::try_from(n).unwrap_or(u32::MAX);
        Self { file, start: clamp(range.start), end: clamp(range.end) }
    }

    /// The empty span at the start of `file`, for findings that concern a file as a whole.
    pub fn whole(file: FileId) -> Self {
        Self { file, start: 0, end: 0 }
    }

    /// No place at all, for a profile without files.
    pub fn nowhere() -> Self {
        Self::whole(FileId(u32::MAX))
    }

    /// The bytes covered.
    pub fn range(self) -> std::ops::Range<usize> {
        self.start as usize..self.end as usize
    }
}

/// A value and where it stands. Equality and order look at the value only: two equal facts from two places are equal.
#[derive(Clone, Copy, Debug)]
pub struct Sp<T> {
    /// The value.
    pub value: T,
    /// Where it stands.
    pub span: Span,
}

impl<T> Sp<T> {
    /// Joins a value with its place.
    pub fn new(value: T, span: Span) -> Self {
        Self { value, span }
    }

    /// Keeps the place and changes the value.
    pub fn map<U>(self, f: impl FnOnce(T) -> U) -> Sp<U> {
        Sp { value: f(self.value), span: self.span }
    }

    /// Borrows the value.
    pub fn as_ref(&self) -> Sp<&T> {
        Sp { value: &self.value, span: self.span }
    }
}

impl<T: PartialEq> PartialEq for Sp<T> {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl<T: Eq> Eq for Sp<T> {}

/// One input text.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Source {
    /// Path with `/` between its parts, relative to the profile's folder (`objects.toml`) or, for a base,
    /// `standard/<base>/<file>`. Diagnostics print it; output never holds it.
    pub path: String,
    /// The whole text.
    pub text: String,
}

/// All texts of a run. Ids are given in the order of adding.
#[derive(Clone, Default, Debug)]
pub struct SourceMap {
    files: Vec<Source>,
    /// First byte of each line of each file.
    lines: Vec<Vec<usize>>,
}

impl SourceMap {
    /// Adds a text.
    pub fn add(&mut self, path: impl Into<String>, text: impl Into<String>) -> FileId {
        let id = FileId(u32::try_from(self.files.len()).unwrap_or(u32::MAX));
        let source = Source { path: path.into(), text: text.into() };
        let breaks = source.text.bytes().enumerate().filter(|(_, b)| *b == b'\n').map(|(at, _)| at + 1);
        self.lines.push(std::iter::once(0).chain(breaks).collect());
        self.files.push(source);
        id
    }

    /// The text of `file`.
    pub fn text(&self, file: FileId) -> &str {
        self.files.get(file.0 as usize).map_or("", |f| f.text.as_str())
    }

    /// The path of `file`.
    pub fn path(&self, file: FileId) -> &str {
        self.files.get(file.0 as usize).map_or("", |f| f.path.as_str())
    }

    /// Every file with its id.
    pub fn iter(&self) -> impl Iterator<Item = (FileId, &Source)> {
        (0..).map(FileId).zip(&self.files)
    }

    /// Line and column of a byte, both from 1; the column counts characters.
    pub fn line_column(&self, file: FileId, byte: u32) -> LineColumn {
        let (text, byte) = (self.text(file), byte as usize);
        let starts = self.lines.get(file.0 as usize).map_or(&[][..], Vec::as_slice);
        let line = starts.partition_point(|start| *start <= byte).max(1);
        let start = starts.get(line - 1).copied().unwrap_or(0);
        let before = text.get(start..byte).or_else(|| text.get(start..)).unwrap_or("");
        LineColumn { line, column: before.chars().count() + 1 }
    }

    /// The whole lines that a span touches, without the last line feed, and the byte at which they start.
    pub fn lines_of(&self, span: Span) -> (usize, &str) {
        let text = self.text(span.file);
        let start = (span.start as usize).min(text.len());
        let end = (span.end as usize).clamp(start, text.len());
        let from = text
            .as_bytes()
            .get(..start)
            .and_then(|t| t.iter().rposition(|b| *b == b'\n'))
            .map_or(0, |at| at + 1);
        let rest = text.as_bytes().get(end..).unwrap_or_default();
        let to = rest.iter().position(|b| *b == b'\n').map_or(text.len(), |at| end + at);
        (from, text.get(from..to).unwrap_or(""))
    }

    /// `path:line:column` of a span's start.
    pub fn place(&self, span: Span) -> String {
        format!("{}:{}", self.path(span.file), self.line_column(span.file, span.start))
    }
}

/// A human's place in a text, counted from 1.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct LineColumn {
    /// Line.
    pub line: usize,
    /// Column, in characters.
    pub column: usize,
}

impl fmt::Display for LineColumn {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}", self.line, self.column)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_count_characters() {
        let mut map = SourceMap::default();
        let file = map.add("a.toml", "x = 1\nµé = 2\n");
        assert_eq!(map.place(Span::new(file, 11..12)), "a.toml:2:4");
    }

    #[test]
    fn equality_ignores_the_place() {
        let mut map = SourceMap::default();
        let file = map.add("a", "");
        assert_eq!(Sp::new(1, Span::new(file, 0..1)), Sp::new(1, Span::new(file, 5..6)));
    }
}
