//! The same calls in a plain loop and on two executors, with a bus that is not `Send` and is pending in every call.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test")]

use std::convert::Infallible;
use std::future::{Future, poll_fn};
use std::marker::PhantomData;
use std::rc::Rc;
use std::task::Poll;
use std::time::Duration;

use drivewright_runtime::cia402::{Mode, State};
use drivewright_runtime::client::axis::AxisPolicy;
use drivewright_runtime::client::drive::{AsyncDrive, Drive};
use drivewright_runtime::client::image::Image;
use drivewright_runtime::client::moves::MoveTo;
use drivewright_runtime::client::session::{Client, Operation, Plan};
use drivewright_runtime::prelude::*;
use drivewright_runtime::procedure::{Answer, Ask, Procedure};
use drivewright_runtime::sim::{Config, Link, VirtualDrive, cells};
use drivewright_runtime::time::Instant;
use drivewright_runtime::transport::{AsyncTransport, Refusal, Transport};
use savch_sdv3_e::MODEL;

const CYCLE: Duration = Duration::from_millis(1);

fn client() -> Client<'static> {
    Client::new(&MODEL, Image::of(&MODEL, 0x1600, 0x1A00).unwrap(), AxisPolicy::default())
}

fn virtual_drive() -> &'static mut VirtualDrive<'static, 'static> {
    let memory = vec![0; cells(&MODEL)].leak();
    Box::leak(Box::new(VirtualDrive::new(&MODEL, memory, Config::default()).unwrap()))
}

fn link() -> Link<'static, 'static, 'static> {
    let mut link = Link::new(virtual_drive(), CYCLE);
    link.start().unwrap();
    link
}

/// Pending once in every call, and not `Send`.
struct Slow {
    link: Link<'static, 'static, 'static>,
    not_send: PhantomData<Rc<()>>,
}

impl Slow {
    fn new() -> Self {
        Self { link: link(), not_send: PhantomData }
    }
}

fn once() -> impl Future<Output = ()> {
    let mut done = false;
    poll_fn(move |context| {
        if std::mem::replace(&mut done, true) {
            return Poll::Ready(());
        }
        context.waker().wake_by_ref();
        Poll::Pending
    })
}

type Outcome<T> = Result<T, Refusal<Infallible>>;

impl AsyncTransport for Slow {
    type Error = Infallible;

    async fn upload(&mut self, address: Address, into: &mut [u8], within: Duration) -> Outcome<usize> {
        once().await;
        Transport::upload(&mut self.link, address, into, within)
    }

    async fn download(&mut self, address: Address, data: &[u8], within: Duration) -> Outcome<()> {
        once().await;
        Transport::download(&mut self.link, address, data, within)
    }

    async fn exchange(&mut self, outputs: &[u8], inputs: &mut [u8]) -> Outcome<usize> {
        once().await;
        Transport::exchange(&mut self.link, outputs, inputs)
    }

    fn now(&mut self) -> Instant {
        Transport::now(&mut self.link)
    }

    async fn wait(&mut self, until: Instant) {
        once().await;
        Transport::wait(&mut self.link, until);
    }
}

/// Position in user units and state at the end.
type End = (i32, State);

async fn there_and_off() -> End {
    let mut drive = AsyncDrive::new(client(), Slow::new());
    drive.enable(Mode::PROFILE_POSITION).await.unwrap();
    drive.move_to(MoveTo::to(8_192).velocity(Value::rpm(300))).await.unwrap();
    drive.disable().await.unwrap();
    let sample = drive.cycle().await.unwrap().unwrap();
    (sample.position.unwrap(), sample.statusword.state().unwrap())
}

/// A revolution, within the window of 6067h, 100 user units as the drive ships.
fn is_there(end: End) -> bool {
    (8_092..=8_292).contains(&end.0) && end.1 == State::SwitchedOn
}

#[test]
fn on_the_executor_of_tokio_in_one_thread() {
    let runtime = tokio::runtime::Builder::new_current_thread().build().unwrap();
    let end = tokio::task::LocalSet::new().block_on(&runtime, there_and_off());
    assert!(is_there(end), "{end:?}");
}

#[test]
fn on_a_local_executor_with_another_task_beside_it() {
    let executor = async_executor::LocalExecutor::new();
    let beside = executor.spawn(async {
        let mut turns = 0;
        while turns < 10 {
            once().await;
            turns += 1;
        }
        turns
    });
    let drive = executor.spawn(there_and_off());
    let (end, turns) = pollster::block_on(executor.run(async { (drive.await, beside.await) }));
    assert!(is_there(end) && turns == 10, "{end:?}");
}

#[test]
fn on_a_bus_that_blocks_it_is_the_same() {
    let mut drive = Drive::new(client(), link());
    drive.enable(Mode::PROFILE_POSITION).unwrap();
    drive.move_to(MoveTo::to(8_192).velocity(Value::rpm(300))).unwrap();
    drive.disable().unwrap();
    let sample = drive.cycle().unwrap().unwrap();
    let end = (sample.position.unwrap(), sample.statusword.state().unwrap());
    assert!(is_there(end), "{end:?}");
    assert_eq!(end, pollster::block_on(there_and_off()), "virtual time is the same for all");
}

#[test]
fn in_a_loop_of_the_program_every_request_is_answered_by_hand() {
    let (mut client, mut link) = (client(), link());
    let plan = Plan::goal(drivewright_runtime::client::axis::Request::Enable(Mode::CYCLIC_VELOCITY));
    let mut operation = Operation::new(&mut client, plan);
    let (mut bytes, mut answered) = ([0; 64], Reply::Begin);
    let result = loop {
        let answer = match answered {
            Reply::Begin => Answer::Begin,
            Reply::Data(length) => Answer::Data(&bytes[..length]),
            Reply::Inputs(length) => Answer::Inputs(&bytes[..length]),
            Reply::Written => Answer::Written,
        };
        answered = match operation.next(Transport::now(&mut link), answer) {
            Ask::Upload(address) => {
                Reply::Data(Transport::upload(&mut link, address, &mut bytes, CYCLE).unwrap())
            }
            Ask::Download(address, data) => {
                Transport::download(&mut link, address, data, CYCLE).unwrap();
                Reply::Written
            }
            Ask::Exchange(outputs) => {
                Reply::Inputs(Transport::exchange(&mut link, outputs, &mut bytes).unwrap())
            }
            Ask::Done(result) => break result,
            other => panic!("{other:?}"),
        };
    };
    result.unwrap();
    drop(operation);
    assert!(client.axis().is_enabled());
    assert_eq!(link.drive().state(), State::OperationEnabled);
}

/// What was answered, with the length of what is in the buffer.
enum Reply {
    Begin,
    Data(usize),
    Inputs(usize),
    Written,
}
