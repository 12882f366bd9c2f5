//! The drive behind a bus: a master as a thread and as a task, clocks, and what goes wrong on the way.

use std::future::Future;
use std::pin::pin;
use std::task::{Context, Poll, Waker};
use std::time::Duration;

use drivewright_runtime::model::EsmState;
use drivewright_runtime::sim::{Config, Disturbance, Disturbed, Link};
use drivewright_runtime::transport::{AsyncTransport, Refusal, Transport};

use crate::{Rig, at};

const CYCLE: Duration = Duration::from_millis(1);
const WITHIN: Duration = Duration::from_millis(500);

/// 6040h, 607Ah, 60FFh, 6071h, 6060h.
fn outputs(word: u8) -> [u8; 13] {
    let mut data = [0; 13];
    (data[0], data[12]) = (word, 3);
    data
}

#[test]
fn a_thread_and_a_task_see_the_same_drive() {
    let mut rig = Rig::new();
    let mut link = Link::new(&mut rig.drive, CYCLE);
    link.start().unwrap();
    let mut inputs = [0; 13];
    for (word, status) in [(6, 0x31), (7, 0x33), (15, 0x37)] {
        assert_eq!(Transport::exchange(&mut link, &outputs(word), &mut inputs), Ok(13));
        assert_eq!(inputs[0], status);
    }
    let task = async {
        let mut data = [0; 4];
        let length = AsyncTransport::upload(&mut link, at(0x6041, 0), &mut data, WITHIN).await.unwrap();
        let before = AsyncTransport::now(&mut link);
        AsyncTransport::wait(&mut link, before.after(CYCLE * 3)).await;
        (length, data[0], AsyncTransport::now(&mut link).since(before))
    };
    let ready = pin!(task).poll(&mut Context::from_waker(Waker::noop()));
    assert_eq!(ready, Poll::Ready((2, 0x37, CYCLE * 3)), "nothing waits: time is virtual");
}

#[test]
fn a_drive_that_starts_up_answers_late_or_not_at_all() {
    let mut rig = Rig::new();
    rig.drive.power_cycle();
    let mut link = Link::new(&mut rig.drive, CYCLE);
    let mut data = [0; 2];
    let soon = Transport::upload(&mut link, at(0x6041, 0), &mut data, Duration::from_millis(20));
    assert_eq!(soon, Err(Refusal::NoAnswer));
    assert_eq!(Transport::upload(&mut link, at(0x6041, 0), &mut data, WITHIN), Ok(2));
    assert_eq!(data, [0x50, 0x02]);
}

#[test]
fn a_dip_of_the_main_supply_is_an_alarm_and_one_of_the_control_supply_a_start() {
    let mut rig = Rig::new();
    let mut link = Link::new(&mut rig.drive, CYCLE);
    link.start().unwrap();
    let mut bus = Disturbed::new(link);
    let mut inputs = [0; 13];
    for word in [6, 7, 15] {
        Transport::exchange(&mut bus, &outputs(word), &mut inputs).unwrap();
    }
    assert!(bus.disturb(Disturbance::MainsDip, 0, 1));
    for _ in 0..3 {
        Transport::exchange(&mut bus, &outputs(15), &mut inputs).unwrap();
    }
    assert_eq!((inputs[0] & 0x4F, bus.drive().alarms().next().unwrap().alarm.display()), (0x08, "LuP"));
    for word in [0, 0x80] {
        Transport::exchange(&mut bus, &outputs(word), &mut inputs).unwrap();
    }
    assert_eq!(inputs[0] & 0x4F, 0x40, "the supply is back");
    assert!(bus.disturb(Disturbance::SupplyDip, 0, 2));
    for _ in 0..3 {
        assert_eq!(Transport::exchange(&mut bus, &outputs(0), &mut inputs), Err(Refusal::NoAnswer));
    }
    assert_eq!(bus.drive().bus_state(), EsmState::PreOp, "the master has to bring it up again");
}

#[test]
fn distributed_clocks_show_in_their_objects() {
    let mut config = Config::default();
    config.distributed_clocks = true;
    let mut rig = Rig::with(config, drivewright_runtime::sim::plant::PlantConfig::default());
    rig.drive.request(EsmState::SafeOp).unwrap();
    assert_eq!((rig.read(0x1C32, 1), rig.read(0x1C32, 10)), (2, 1_000_000));
    let mut rig = Rig::new();
    rig.drive.request(EsmState::SafeOp).unwrap();
    assert_eq!((rig.read(0x1C32, 1), rig.read(0x1C32, 10)), (0, 0), "free run");
}
