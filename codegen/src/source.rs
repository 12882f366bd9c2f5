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

/// A format of profile files. Files of both may lie in one folder.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Format {
    /// `*.toml`
    Toml,
    /// `*.xml`
    Xml,
}

impl Format {
    /// Every format.
    pub const ALL: [Self; 2] = [Self::Toml, Self::Xml];

    /// How names of its files end, without the full stop.
    pub const fn extension(self) -> &'static str {
        match self {
            Self::Toml => "toml",
            Self::Xml => "xml",
        }
    }

    /// The format of the file at `path`, if it is one of a profile.
    pub fn of(path: &str) -> Option<Self> {
        let (_, extension) =
            path.rsplit_once('.').filter(|(name, _)| !name.is_empty() && !name.ends_with('/'))?;
        Self::ALL.into_iter().find(|format| format.extension() == extension)
    }
}

/// Bytes between two places up to which the characters of a text are counted beforehand.
const STRIDE: usize = 1 << 10;

/// A text with what finds places in it, so that no question takes longer in a long line or file.
#[derive(Clone, Debug)]
struct File {
    source: Source,
    /// First byte of each line.
    lines: Vec<usize>,
    /// Characters that begin before each multiple of [`STRIDE`].
    characters: Vec<usize>,
}

impl File {
    fn new(source: Source) -> Self {
        let breaks = source.text.match_indices('\n').map(|(at, _)| at + 1);
        let lines = std::iter::once(0).chain(breaks).collect();
        let sum = |before: &mut usize, part: &[u8]| {
            let here = *before;
            *before += begun(part);
            Some(here)
        };
        let characters = source.text.as_bytes().chunks(STRIDE).scan(0, sum).collect();
        Self { source, lines, characters }
    }

    /// The line of a byte, from 0, and the line's first byte.
    fn line(&self, byte: usize) -> (usize, usize) {
        let line = self.lines.partition_point(|start| *start <= byte).saturating_sub(1);
        (line, self.lines.get(line).copied().unwrap_or(0))
    }

    /// One past the last byte of the line that holds `byte`, without its line feed.
    fn line_end(&self, byte: usize) -> usize {
        let next = self.lines.get(self.lines.partition_point(|start| *start <= byte));
        next.map_or(self.source.text.len(), |next| next - 1)
    }

    /// How many characters begin before a byte.
    fn characters_before(&self, byte: usize) -> usize {
        let text = self.source.text.as_bytes();
        let byte = byte.min(text.len());
        let counted = (byte / STRIDE).min(self.characters.len().saturating_sub(1));
        let rest = text.get(counted * STRIDE..byte).unwrap_or_default();
        self.characters.get(counted).copied().unwrap_or(0) + begun(rest)
    }
}

/// How many characters begin in a part of a text.
fn begun(part: &[u8]) -> usize {
    if part.is_ascii() {
        return part.len();
    }
    part.iter().filter(|b| !(0x80..0xC0).contains(*b)).count()
}

/// A part of a text that shows a span.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Excerpt<'a> {
    /// The lines that the span touches, or what is near it in them.
    pub text: &'a str,
    /// The byte of the file at which it starts.
    pub from: usize,
    /// Whether text of the first line is left out before it.
    pub cut_before: bool,
    /// Whether text of the last line, or more of the span, is left out after it.
    pub cut_after: bool,
}

/// All texts of a run. Ids are given in the order of adding.
#[derive(Clone, Default, Debug)]
pub struct SourceMap {
    files: Vec<File>,
}

impl SourceMap {
    /// Adds a text.
    pub fn add(&mut self, path: impl Into<String>, text: impl Into<String>) -> FileId {
        let id = FileId(u32::try_from(self.files.len()).unwrap_or(u32::MAX));
        self.files.push(File::new(Source { path: path.into(), text: text.into() }));
        id
    }

    fn file(&self, id: FileId) -> Option<&File> {
        self.files.get(id.0 as usize)
    }

    /// The text of `file`.
    pub fn text(&self, file: FileId) -> &str {
        self.file(file).map_or("", |f| f.source.text.as_str())
    }

    /// The path of `file`.
    pub fn path(&self, file: FileId) -> &str {
        self.file(file).map_or("", |f| f.source.path.as_str())
    }

    /// Every file with its id.
    pub fn iter(&self) -> impl Iterator<Item = (FileId, &Source)> {
        (0..).map(FileId).zip(self.files.iter().map(|f| &f.source))
    }

    /// Line and column of a byte, both from 1; the column counts characters.
    pub fn line_column(&self, file: FileId, byte: u32) -> LineColumn {
        let Some(file) = self.file(file) else { return LineColumn { line: 1, column: 1 } };
        let (line, start) = file.line(byte as usize);
        let column = file.characters_before(byte as usize) - file.characters_before(start);
        LineColumn { line: line + 1, column: column + 1 }
    }

    /// The lines that a span touches, without the last line feed. Where these have more than `most` bytes, an eighth of
    /// that before the start of the span and as much after it.
    pub fn excerpt(&self, span: Span, most: usize) -> Excerpt<'_> {
        let nothing = Excerpt { text: "", from: 0, cut_before: false, cut_after: false };
        let Some(file) = self.file(span.file) else { return nothing };
        let text = file.source.text.as_str();
        let start = (span.start as usize).min(text.len());
        let end = (span.end as usize).clamp(start, text.len());
        let ((_, first), last) = (file.line(start), file.line_end(end));
        let margin = if last - first <= most { most } else { most / 8 };
        let from = boundary(text, first.max(start.saturating_sub(margin)));
        let to = boundary(text, last.min(start.saturating_add(margin)));
        let part = text.get(from..to).unwrap_or("");
        Excerpt { text: part, from, cut_before: from > first, cut_after: to < last }
    }

    /// `path:line:column` of a span's start.
    pub fn place(&self, span: Span) -> String {
        format!("{}:{}", self.path(span.file), self.line_column(span.file, span.start))
    }
}

/// The next start of a character at or after `byte`.
fn boundary(text: &str, byte: usize) -> usize {
    (byte..=text.len()).find(|at| text.is_char_boundary(*at)).unwrap_or(text.len())
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
    fn columns_of_long_lines() {
        let mut map = SourceMap::default();
        let text = format!("{}\n{}", "µ".repeat(STRIDE), "µx".repeat(STRIDE));
        let file = map.add("a.toml", text.as_str());
        for (at, _) in text.char_indices().skip(STRIDE + 1) {
            let column = text[2 * STRIDE + 1..at].chars().count() + 1;
            let found = map.line_column(file, u32::try_from(at).unwrap());
            assert_eq!((found.line, found.column), (2, column));
        }
        let end = map.line_column(file, u32::try_from(text.len()).unwrap());
        assert_eq!((end.line, end.column), (2, 2 * STRIDE + 1));
    }

    #[test]
    fn excerpts_are_whole_lines_or_what_is_near() {
        let mut map = SourceMap::default();
        let file = map.add("a.toml", "one\nµtwo = 2\nthree\n");
        let excerpt = |range, most| {
            let e = map.excerpt(Span::new(file, range), most);
            (e.text, e.from, e.cut_before, e.cut_after)
        };
        assert_eq!(excerpt(6..9, 100), ("µtwo = 2", 4, false, false));
        assert_eq!(excerpt(1..9, 100), ("one\nµtwo = 2", 0, false, false));
        assert_eq!(excerpt(8..9, 8), ("wo", 7, true, true));
        assert_eq!(excerpt(6..6, 8), ("t", 6, true, true), "no half of a character");
        assert_eq!(excerpt(20..20, 100), ("", 20, false, false), "behind the last line feed");
        assert_eq!(excerpt(30..40, 100), ("", 20, false, false), "behind the end");
    }

    #[test]
    fn equality_ignores_the_place() {
        let mut map = SourceMap::default();
        let file = map.add("a", "");
        assert_eq!(Sp::new(1, Span::new(file, 0..1)), Sp::new(1, Span::new(file, 5..6)));
    }
}
