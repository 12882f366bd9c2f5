//! The language of `simulate`: a command a line. This reads it; nothing here knows how it is executed.

use std::time::Duration;

use drivewright_runtime::Address;

use super::words::{address, duration, number, usual};

/// What can be asked of a virtual drive.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum Command {
    /// An SDO upload.
    Read(Address),
    /// An SDO download of a number, as wide as the entry is.
    Write(Address, i128),
    /// An SDO download of these bytes.
    Send(Address, Vec<u8>),
    /// Sets values of the process data and exchanges them once; from now on they are exchanged in each cycle.
    Exchange(Vec<(Address, i128)>),
    /// Process data are not exchanged any more.
    ExchangeOff,
    /// Time goes on.
    Run(Duration),
    /// It must be so now.
    Expect(Condition),
    /// Time goes on until it is so.
    Until(Condition, Duration),
    /// The state of the network.
    Bus(Bus),
    /// An alarm, by display, or by display and number.
    Raise(String, Option<u16>),
    /// An alarm whose cause stays.
    Hold(String, Option<u16>),
    /// The cause of an alarm is gone.
    Clear(String, Option<u16>),
    /// A fault of the wires or the drive, with its number.
    Fault(String, Option<u64>),
    /// What follows is refused by the drive, with this abort code where one is given.
    Refused(Option<u32>, Box<Command>),
    /// The supply.
    Power(Supply, bool),
    /// A load on the axis, in percent of rated torque.
    Load(i32),
    /// State, mode, position, alarms.
    State,
    /// A line in the trace.
    Note(String),
    /// What the simulation assumes.
    Assumptions,
    /// What can be said.
    Help,
    /// The end.
    Quit,
}

/// What must hold.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum Condition {
    /// An entry, masked, beside a number.
    Entry { at: Address, mask: Option<i128>, is: Comparison, value: i128 },
    /// The state, as CiA 402 calls it, in lower case.
    State(String),
}

/// How two numbers compare.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Comparison {
    Equal,
    NotEqual,
    Less,
    LessOrEqual,
    Greater,
    GreaterOrEqual,
}

impl Comparison {
    const ALL: [(&'static str, Self); 6] = [
        ("==", Self::Equal),
        ("!=", Self::NotEqual),
        ("<", Self::Less),
        ("<=", Self::LessOrEqual),
        (">", Self::Greater),
        (">=", Self::GreaterOrEqual),
    ];

    pub(super) fn holds(self, a: i128, b: i128) -> bool {
        match self {
            Self::Equal => a == b,
            Self::NotEqual => a != b,
            Self::Less => a < b,
            Self::LessOrEqual => a <= b,
            Self::Greater => a > b,
            Self::GreaterOrEqual => a >= b,
        }
    }
}

/// States of the network.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Bus {
    Init,
    PreOp,
    SafeOp,
    Op,
}

/// Supplies.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Supply {
    /// Of the electronics.
    Control,
    /// Of the power stage.
    Main,
    /// The input that allows torque.
    Torque,
}

/// Why a line is no command: what is wrong, and what to do.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Refused {
    pub(super) what: String,
    pub(super) help: String,
}

/// A command, how it is written, and what it does.
struct Form {
    name: &'static str,
    usage: &'static str,
    does: &'static str,
    read: fn(&[&str]) -> Result<Command, String>,
}

const FORMS: &[Form] = &[
    Form {
        name: "read",
        usage: "read 6041:00",
        does: "reads an entry over SDO",
        read: |w| Ok(Command::Read(address(one(w)?)?)),
    },
    Form { name: "write", usage: "write 6040:00 0x06", does: "writes a number over SDO", read: write },
    Form {
        name: "send",
        usage: "send 6040:00 06 00",
        does: "writes bytes over SDO, of any length",
        read: send,
    },
    Form { name: "bus", usage: "bus op", does: "goes to init, preop, safeop or op", read: bus },
    Form {
        name: "exchange",
        usage: "exchange 6040:00=15 60FF:00=1000",
        does: "sets what the master sends and exchanges process data, from now on in each cycle; `exchange` alone shows what comes, `exchange off` ends it",
        read: exchange,
    },
    Form {
        name: "run",
        usage: "run 100ms",
        does: "time goes on",
        read: |w| Ok(Command::Run(duration(one(w)?)?)),
    },
    Form {
        name: "expect",
        usage: "expect 6041:00 & 0x6F == 0x27",
        does: "ends with 1 if it is not so; also `expect state Fault`",
        read: |w| Ok(Command::Expect(condition(w)?)),
    },
    Form {
        name: "refused",
        usage: "refused 06090030h write 6060:00 2",
        does: "ends with 1 if the drive does not refuse it, with this abort code if one is given",
        read: refused,
    },
    Form {
        name: "until",
        usage: "until 6041:00 & 0x6F == 0x27 within 1s",
        does: "time goes on until it is so; ends with 1 if it takes longer, than 10 s where nothing is said",
        read: until,
    },
    Form {
        name: "raise",
        usage: "raise OF",
        does: "raises an alarm, by display; `raise OF 0x25` where several have it",
        read: |w| alarm(w, Command::Raise),
    },
    Form {
        name: "hold",
        usage: "hold OF",
        does: "raises an alarm whose cause stays until `clear OF`: a fault reset does not clear it before",
        read: |w| alarm(w, Command::Hold),
    },
    Form {
        name: "clear",
        usage: "clear OF",
        does: "takes the cause of an alarm away",
        read: |w| alarm(w, Command::Clear),
    },
    Form {
        name: "fault",
        usage: "fault lost-pdo 5",
        does: "disturbs from now on; `fault` alone lists what there is, `fault calm` ends it",
        read: fault,
    },
    Form {
        name: "power",
        usage: "power off",
        does: "control supply off or on; `power main off` for that of the motor, `power torque off` for an input that allows torque",
        read: power,
    },
    Form {
        name: "load",
        usage: "load -20",
        does: "pushes the axis, in percent of rated torque; positive in positive direction",
        read: load,
    },
    Form {
        name: "state",
        usage: "state",
        does: "tells state, mode, position and alarms",
        read: |w| nothing(w, Command::State),
    },
    Form {
        name: "note",
        usage: "note the gripper is closed",
        does: "writes a line into the trace",
        read: |w| Ok(Command::Note(w.join(" "))),
    },
    Form {
        name: "assumptions",
        usage: "assumptions",
        does: "lists what is assumed where manuals are silent",
        read: |w| nothing(w, Command::Assumptions),
    },
    Form { name: "help", usage: "help", does: "lists this", read: |w| nothing(w, Command::Help) },
    Form { name: "quit", usage: "quit", does: "ends", read: |w| nothing(w, Command::Quit) },
];

/// The command of a line; `None` where there is none. What follows `#` is a comment.
pub(super) fn command(line: &str) -> Result<Option<Command>, Refused> {
    let line = line.split_once('#').map_or(line, |(before, _)| before);
    let mut words = line.split_whitespace();
    let Some(name) = words.next() else { return Ok(None) };
    let Some(form) = FORMS.iter().find(|form| form.name == name) else {
        let what = format!("there is no command `{}`", name.escape_debug());
        return Err(Refused { what, help: "`help` lists the commands".to_owned() });
    };
    let words: Vec<&str> = words.collect();
    (form.read)(&words)
        .map(Some)
        .map_err(|what| Refused { what, help: format!("write it like this: {}", form.usage) })
}

/// What can be said, for `help`.
pub(super) fn help() -> String {
    let width = FORMS.iter().map(|form| form.usage.len()).max().unwrap_or(0);
    let line = |form: &Form| format!("  {:<width$}  {}\n", form.usage, form.does);
    let rest = "Addresses are hexadecimal. Numbers are decimal, or hexadecimal as 0x1F or 1Fh. Times: 10ms, 2s; time goes\non in cycles of a millisecond.\n";
    FORMS.iter().map(line).collect::<String>() + rest
}

fn one<'w>(words: &[&'w str]) -> Result<&'w str, String> {
    match words {
        [one] => Ok(one),
        [] => Err("something is missing".to_owned()),
        [_, rest @ ..] => Err(format!("`{}` is too much", rest.join(" ").escape_debug())),
    }
}

fn nothing(words: &[&str], command: Command) -> Result<Command, String> {
    match words {
        [] => Ok(command),
        words => Err(format!("`{}` is too much", words.join(" ").escape_debug())),
    }
}

fn write(words: &[&str]) -> Result<Command, String> {
    match words {
        [at, value] => Ok(Command::Write(address(at)?, number(value)?)),
        _ => Err("an address and one number are wanted".to_owned()),
    }
}

fn send(words: &[&str]) -> Result<Command, String> {
    let [at, bytes @ ..] = words else { return Err("an address is wanted".to_owned()) };
    let byte = |word: &&str| {
        let known = u8::from_str_radix(word, 16).ok().filter(|_| word.len() == 2);
        known.ok_or_else(|| format!("`{}` is no byte of two hexadecimal digits", word.escape_debug()))
    };
    Ok(Command::Send(address(at)?, bytes.iter().map(byte).collect::<Result<_, _>>()?))
}

fn bus(words: &[&str]) -> Result<Command, String> {
    Ok(Command::Bus(match usual(one(words)?).as_str() {
        "init" => Bus::Init,
        "preop" => Bus::PreOp,
        "safeop" => Bus::SafeOp,
        "op" => Bus::Op,
        other => return Err(format!("`{}` is no state of the network", other.escape_debug())),
    }))
}

fn exchange(words: &[&str]) -> Result<Command, String> {
    if words == ["off"] {
        return Ok(Command::ExchangeOff);
    }
    let value = |word: &&str| {
        let (at, value) =
            word.split_once('=').ok_or_else(|| format!("`{}` has no `=`", word.escape_debug()))?;
        Ok((address(at)?, number(value)?))
    };
    Ok(Command::Exchange(words.iter().map(value).collect::<Result<_, String>>()?))
}

/// `6041:00 & 0x6F == 0x27`, `state Operation enabled`
fn condition(words: &[&str]) -> Result<Condition, String> {
    let (at, mask, is, value) = match words {
        ["state", words @ ..] if !words.is_empty() => {
            let words: Vec<&str> = words.iter().copied().filter(|word| *word != "==").collect();
            return Ok(Condition::State(state(&words.join(" "))?));
        }
        [at, "&", mask, is, value] => (at, Some(number(mask)?), is, value),
        [at, is, value] => (at, None, is, value),
        _ => return Err("this is no comparison".to_owned()),
    };
    let known = Comparison::ALL.iter().find(|(sign, _)| sign == is);
    let (_, is) = known.ok_or_else(|| format!("`{}` does not compare", is.escape_debug()))?;
    Ok(Condition::Entry { at: address(at)?, mask, is: *is, value: number(value)? })
}

/// The name of a state of CiA 402, in the usual form.
fn state(name: &str) -> Result<String, String> {
    use drivewright_runtime::cia402::State;
    let known = State::ALL.iter().find(|state| usual(state.word()) == usual(name));
    known.map(|state| state.word().to_owned()).ok_or_else(|| {
        let names: Vec<&str> = State::ALL.iter().map(|state| state.word()).collect();
        format!("`{}` is no state; there are {}", name.escape_debug(), names.join(", "))
    })
}

/// `06090030h write 6060:00 2`, `read 5FFF`, `bus op`
fn refused(words: &[&str]) -> Result<Command, String> {
    let code = words.first().and_then(|word| abort(word));
    let rest = if code.is_some() { words.get(1..).unwrap_or(&[]) } else { words };
    let inner = command(&rest.join(" ")).map_err(|refused| refused.what)?;
    match inner {
        Some(inner @ (Command::Read(_) | Command::Write(..) | Command::Send(..) | Command::Bus(_))) => {
            Ok(Command::Refused(code, Box::new(inner)))
        }
        _ => Err("read, write, send or bus is wanted".to_owned()),
    }
}

/// An abort code: eight hexadecimal digits.
fn abort(word: &str) -> Option<u32> {
    let digits = word.strip_prefix("0x").unwrap_or(word);
    let digits = digits.strip_suffix(['h', 'H']).unwrap_or(digits);
    u32::from_str_radix(digits, 16).ok().filter(|_| digits.len() == 8)
}

const PATIENCE: Duration = Duration::from_secs(10);

fn until(words: &[&str]) -> Result<Command, String> {
    match words {
        [rest @ .., "within", span] => Ok(Command::Until(condition(rest)?, duration(span)?)),
        words => Ok(Command::Until(condition(words)?, PATIENCE)),
    }
}

fn alarm(words: &[&str], command: fn(String, Option<u16>) -> Command) -> Result<Command, String> {
    match words {
        [display] => Ok(command((*display).to_owned(), None)),
        [display, n] => {
            let n = u16::try_from(number(n)?).map_err(|_| "the number of an alarm has 16 bits".to_owned())?;
            Ok(command((*display).to_owned(), Some(n)))
        }
        _ => Err("the display of an alarm is wanted".to_owned()),
    }
}

fn fault(words: &[&str]) -> Result<Command, String> {
    match words {
        [] => Ok(Command::Fault(String::new(), None)),
        [kind] => Ok(Command::Fault((*kind).to_owned(), None)),
        [kind, n] => {
            let n = u64::try_from(number(n)?).map_err(|_| "the number must not be negative".to_owned())?;
            Ok(Command::Fault((*kind).to_owned(), Some(n)))
        }
        _ => Err("a kind and a number are wanted".to_owned()),
    }
}

fn power(words: &[&str]) -> Result<Command, String> {
    match words {
        ["main", state] => Ok(Command::Power(Supply::Main, switched(state)?)),
        ["torque", state] => Ok(Command::Power(Supply::Torque, switched(state)?)),
        words => Ok(Command::Power(Supply::Control, switched(one(words)?)?)),
    }
}

fn load(words: &[&str]) -> Result<Command, String> {
    let percent = i32::try_from(number(one(words)?)?).ok().filter(|n| (-1000..=1000).contains(n));
    percent.map(Command::Load).ok_or_else(|| "a load is -1000 to 1000 % of rated torque".to_owned())
}

fn switched(word: &str) -> Result<bool, String> {
    match word {
        "on" => Ok(true),
        "off" => Ok(false),
        word => Err(format!("`{}` is neither on nor off", word.escape_debug())),
    }
}

#[cfg(test)]
mod tests;
