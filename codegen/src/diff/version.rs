//! Which version the generated crate needs, as Cargo reads version numbers.

use std::fmt;

/// Three numbers.
#[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Version(pub u64, pub u64, pub u64);

impl Version {
    /// Reads `0.1.0`.
    pub fn parse(text: &str) -> Option<Self> {
        let mut parts = text.split('.').map(|part| part.parse().ok());
        let version = Self(parts.next()??, parts.next()??, parts.next()??);
        parts.next().is_none().then_some(version)
    }

    /// The lowest version that tells users of this one what the level says.
    fn raised(self, level: Level) -> (Self, Bump) {
        let Self(major, minor, patch) = self;
        match (level, self) {
            (Level::Nothing, _) => (self, Bump::None),
            (Level::Breaking, Self(1.., ..)) => (Self(major + 1, 0, 0), Bump::Major),
            (Level::Addition, Self(1.., ..)) => (Self(major, minor + 1, 0), Bump::Minor),
            (Level::Breaking, Self(0, 1.., _)) => (Self(0, minor + 1, 0), Bump::Minor),
            _ => (Self(major, minor, patch + 1), Bump::Patch),
        }
    }
}

impl fmt::Display for Version {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{}.{}", self.0, self.1, self.2)
    }
}

/// What a release is for those who use the crate.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Level {
    /// Nothing but the profile's own versions and dates differs.
    Nothing,
    /// Texts.
    Texts,
    /// There is more than before, and all of before.
    Addition,
    /// Code may not compile, or an axis may do something else.
    Breaking,
}

/// Which number is raised.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Bump {
    /// None.
    None,
    /// The third.
    Patch,
    /// The second.
    Minor,
    /// The first.
    Major,
}

impl Bump {
    /// `none`, `patch`, `minor` or `major`.
    pub fn word(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Patch => "patch",
            Self::Minor => "minor",
            Self::Major => "major",
        }
    }
}

/// Which version the new crate needs, and whether it has it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Verdict {
    /// What the release is.
    pub level: Level,
    /// Which number has to be raised.
    pub bump: Bump,
    /// The lowest version that is high enough; `None` when the old version cannot be read.
    pub needs: Option<Version>,
    /// Whether the new version is high enough.
    pub enough: bool,
    /// The rule of Cargo that applies.
    pub rule: &'static str,
}

/// Judges a release of `level` that goes from version `old` to `new`. Without an old version the drive is new.
pub(super) fn judge(level: Level, old: &str, new: &str) -> Verdict {
    let (was, is) = (Version::parse(old), Version::parse(new));
    if old.is_empty() {
        let rule = "the drive is new: any version is right";
        return Verdict { level, bump: Bump::None, needs: None, enough: true, rule };
    }
    if new.is_empty() {
        let rule = "the drive is gone";
        return Verdict { level, bump: Bump::None, needs: None, enough: true, rule };
    }
    let (needs, bump) = was.map(|version| version.raised(level)).unzip();
    Verdict {
        level,
        bump: bump.unwrap_or(Bump::None),
        needs,
        enough: needs.is_some() && is >= needs,
        rule: rule(level, was.unwrap_or_default()),
    }
}

fn rule(level: Level, was: Version) -> &'static str {
    match (level, was) {
        (Level::Nothing, _) => "nothing that users see has changed",
        (_, Version(0, 0, _)) => "Cargo takes every 0.0.z as incompatible with the one before",
        (Level::Breaking, Version(0, ..)) => "Cargo takes 0.y as incompatible with the y before",
        (Level::Breaking, _) => "Cargo takes another first number as incompatible",
        (Level::Addition, Version(0, ..)) => "Cargo takes 0.y.z as compatible within y: additions raise z",
        (Level::Addition, _) => "an addition raises the second number",
        (Level::Texts, _) => "texts raise the third number",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// From the chapter "`SemVer` Compatibility" of the Cargo book: the left-most number that is not zero counts.
    #[test]
    fn what_cargo_takes_as_compatible() {
        for (old, level, needs, bump) in [
            ("1.2.3", Level::Breaking, "2.0.0", Bump::Major),
            ("1.2.3", Level::Addition, "1.3.0", Bump::Minor),
            ("1.2.3", Level::Texts, "1.2.4", Bump::Patch),
            ("0.2.3", Level::Breaking, "0.3.0", Bump::Minor),
            ("0.2.3", Level::Addition, "0.2.4", Bump::Patch),
            ("0.2.3", Level::Texts, "0.2.4", Bump::Patch),
            ("0.0.3", Level::Breaking, "0.0.4", Bump::Patch),
            ("0.0.3", Level::Addition, "0.0.4", Bump::Patch),
            ("0.2.3", Level::Nothing, "0.2.3", Bump::None),
        ] {
            let verdict = judge(level, old, old);
            assert_eq!(verdict.needs.map(|v| v.to_string()).as_deref(), Some(needs), "{old} {level:?}");
            assert_eq!((verdict.bump, verdict.enough), (bump, level == Level::Nothing), "{old} {level:?}");
            assert!(judge(level, old, needs).enough, "{old} {level:?}");
        }
    }

    #[test]
    fn too_little_is_not_enough() {
        assert!(!judge(Level::Breaking, "0.1.9", "0.1.10").enough);
        assert!(judge(Level::Breaking, "0.1.9", "0.2.0").enough);
        assert!(judge(Level::Texts, "0.9.0", "0.10.0").enough, "10 is more than 9");
        assert!(!judge(Level::Texts, "0.2.0", "0.1.9").enough, "never downwards");
        assert!(!judge(Level::Texts, "new", "0.1.0").enough);
        assert_eq!(Version::parse("1.2.3.4"), None);
    }
}
