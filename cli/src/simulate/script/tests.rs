//! Lines and what they mean.

use super::*;

fn of(line: &str) -> Command {
    command(line).unwrap().unwrap()
}

fn wrong(line: &str) -> String {
    let refused = command(line).unwrap_err();
    format!("{}: {}", refused.what, refused.help.trim_start_matches("write it like this: "))
}

fn at(index: u16, sub: u8) -> Address {
    Address::new(index, sub)
}

#[test]
fn every_usage_is_a_command() {
    for form in FORMS {
        assert!(command(form.usage).unwrap().is_some(), "{}", form.usage);
        assert!(form.usage.starts_with(form.name));
        assert!(help().contains(form.does), "{}", form.name);
    }
}

#[test]
fn commands_are_read() {
    assert_eq!(of("read 6041"), Command::Read(at(0x6041, 0)));
    assert_eq!(of("  read\t0x607D:1 # the lower limit"), Command::Read(at(0x607D, 1)));
    assert_eq!(of("write 6060h -3"), Command::Write(at(0x6060, 0), -3));
    assert_eq!(of("write 6040 0Fh"), Command::Write(at(0x6040, 0), 15));
    assert_eq!(of("send 6040:00 06 fF"), Command::Send(at(0x6040, 0), vec![6, 255]));
    assert_eq!(of("exchange"), Command::Exchange(vec![]));
    assert_eq!(of("exchange 6040=6"), Command::Exchange(vec![(at(0x6040, 0), 6)]));
    assert_eq!(of("run 1.5s"), Command::Run(Duration::from_millis(1500)));
    assert_eq!(of("run 250us"), Command::Run(Duration::from_micros(250)));
    assert_eq!(of("bus SafeOP"), Command::Bus(Bus::SafeOp));
    assert_eq!(of("power main off"), Command::Power(Supply::Main, false));
    assert_eq!(of("raise OF 25h"), Command::Raise("OF".into(), Some(0x25)));
    assert_eq!(command("   # nothing"), Ok(None));
    assert_eq!(command(""), Ok(None));
}

#[test]
fn conditions_are_read() {
    let is = |mask, is, value| Condition::Entry { at: at(0x6041, 0), mask, is, value };
    assert_eq!(of("expect 6041 & 0x6F == 0x27"), Command::Expect(is(Some(0x6F), Comparison::Equal, 0x27)));
    assert_eq!(of("expect 6041 >= -1"), Command::Expect(is(None, Comparison::GreaterOrEqual, -1)));
    let enabled = Condition::State("Operation enabled".into());
    assert_eq!(of("expect state operation-enabled"), Command::Expect(enabled.clone()));
    assert_eq!(
        of("until state == Operation enabled within 20ms"),
        Command::Until(enabled, Duration::from_millis(20))
    );
    for (comparison, holds) in Comparison::ALL.iter().zip([false, true, true, true, false, false]) {
        assert_eq!(comparison.1.holds(1, 2), holds, "1 {} 2", comparison.0);
    }
}

#[test]
fn what_is_wrong_is_named() {
    assert_eq!(wrong("raed 6041"), "there is no command `raed`: `help` lists the commands");
    assert_eq!(wrong("read"), "something is missing: read 6041:00");
    assert_eq!(wrong("read 6041 6042"), "`6042` is too much: read 6041:00");
    assert_eq!(wrong("read 60410"), "`60410` is no address, such as 6041:00: read 6041:00");
    assert_eq!(wrong("read -041"), "`-041` is no address, such as 6041:00: read 6041:00");
    assert!(wrong("write 6040 1.5").starts_with("`1.5` is no number"));
    assert!(wrong("write 6040 0x-5").starts_with("`0x-5` is no number"));
    assert!(wrong("write 6040 99999999999999999999").contains("64 bits"));
    assert!(wrong("run 5").starts_with("`5` is no time"));
    assert!(
        wrong("run 99999999999s").contains("a day at most") || wrong("run 99999999999s").contains("no time")
    );
    assert!(wrong("run 25h").starts_with("`25h` is no time"));
    assert!(wrong("expect 6041 = 5").starts_with("`=` does not compare"));
    assert!(wrong("expect state asleep").contains("there are Not ready to switch on, Switch on disabled"));
    assert!(wrong("send 6040 6").starts_with("`6` is no byte"));
    assert!(wrong("exchange 6040").starts_with("`6040` has no `=`"));
    assert!(wrong("power up").starts_with("`up` is neither on nor off"));
    assert!(wrong("bus run").starts_with("`run` is no state of the network"));
    assert!(wrong("re\u{202e}ad").contains("\\u{202e}"), "what hides is shown");
}
