//! Breadth first over all that can happen.

use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, VecDeque};
use std::hash::{DefaultHasher, Hash, Hasher};

use drivewright_runtime::cia402::State;
use drivewright_runtime::client::axis::Axis;

use super::drive::{Drive, Event, Homing};
use super::goal::{Goal, plans, policy};
use super::world::{Choice, Client, FAIR, Message, World, real};

/// What a search has to go through.
pub(crate) struct Search {
    pub(crate) plan: Vec<Goal>,
    /// 605Ah keeps quick stop active.
    pub(crate) stays: bool,
    pub(crate) outputs: &'static [Message],
    pub(crate) samples: &'static [Message],
    /// How many faults there may be.
    pub(crate) faults: u8,
    /// A goal may be given up for the next one at any time.
    pub(crate) anytime: bool,
    pub(crate) client: Client,
}

/// What was found.
#[derive(Debug, Default)]
pub(crate) struct Found {
    states: usize,
    steps: usize,
    /// The longest way to the end where everything works.
    pub(crate) longest: usize,
    /// What does not hold, and how it came to that.
    pub(crate) broken: Option<(&'static str, Vec<Choice>)>,
}

/// A state, as its number: where it was reached from, and how.
struct Seen {
    from: Option<(u64, Choice)>,
    /// Where it leads if everything works; `None` where all is over.
    fair: Option<u64>,
}

fn number(world: &World) -> u64 {
    let mut hasher = DefaultHasher::new();
    world.hash(&mut hasher);
    hasher.finish()
}

impl Search {
    /// A drive in any state, at home or not where that matters.
    fn starts(&self) -> impl Iterator<Item = World> + '_ {
        let homing =
            if self.plan.contains(&Goal::Home) { &[Homing::Not, Homing::Found][..] } else { &[Homing::Not] };
        let drives = State::ALL
            .iter()
            .flat_map(move |state| homing.iter().map(|h| Drive::new(*state, self.stays, *h)));
        let strict = !self.outputs.contains(&Message::Old) && !self.samples.contains(&Message::Old);
        drives.map(move |drive| World::new(Axis::new(policy(self.stays)), drive, self.faults, strict))
    }

    fn choices(&self, world: &World) -> Vec<Choice> {
        let mut events = vec![Event::Obeys];
        events.extend(world.drive.is_busy().then_some(Event::Waits));
        events.extend((world.faults > 0).then_some(Event::Faults));
        let mut choices = Vec::new();
        for event in events {
            for outputs in self.outputs {
                choices.extend(self.samples.iter().map(|s| Choice {
                    outputs: *outputs,
                    event,
                    sample: *s,
                    next: false,
                }));
            }
        }
        if self.anytime && world.begun < self.plan.len() {
            choices.push(Choice { next: true, ..FAIR });
        }
        choices
    }

    pub(crate) fn run(&self) -> Found {
        let (mut seen, mut queue, mut found) = (BTreeMap::new(), VecDeque::new(), Found::default());
        for world in self.starts() {
            let id = number(&world);
            seen.insert(id, Seen { from: None, fair: None });
            queue.push_back((id, world));
        }
        while let Some((id, world)) = queue.pop_front() {
            if world.is_over(&self.plan) {
                continue;
            }
            for choice in self.choices(&world) {
                let mut next = world.clone();
                found.steps += 1;
                if let Err(why) = next.step(&self.plan, choice, self.client) {
                    found.broken = Some((why, way(&seen, id, choice)));
                    return found;
                }
                let to = number(&next);
                if choice == FAIR {
                    seen.get_mut(&id).expect("it was seen").fair = Some(to);
                }
                if let Entry::Vacant(unseen) = seen.entry(to) {
                    unseen.insert(Seen { from: Some((id, choice)), fair: None });
                    queue.push_back((to, next));
                }
            }
        }
        found.states = seen.len();
        found.longest = longest(&seen);
        found
    }
}

/// How a state was reached.
fn way(seen: &BTreeMap<u64, Seen>, mut at: u64, last: Choice) -> Vec<Choice> {
    let mut way = vec![last];
    while let Some((from, choice)) = seen.get(&at).and_then(|s| s.from) {
        way.push(choice);
        at = from;
    }
    way.reverse();
    way
}

/// The longest way to the end where everything works from now on; `usize::MAX` where there is none.
fn longest(seen: &BTreeMap<u64, Seen>) -> usize {
    let mut known: BTreeMap<u64, usize> = BTreeMap::new();
    for start in seen.keys() {
        let (mut path, mut at) = (Vec::new(), *start);
        let end = loop {
            if let Some(length) = known.get(&at) {
                break *length;
            }
            // On the way already: a way that comes back to itself has no end.
            known.insert(at, usize::MAX);
            path.push(at);
            match seen.get(&at).and_then(|s| s.fair) {
                Some(next) => at = next,
                None => break 0,
            }
        };
        for (steps, at) in path.into_iter().rev().enumerate() {
            known.insert(at, end.saturating_add(steps));
        }
    }
    known.into_values().max().unwrap_or(0)
}

pub(crate) const LOSSY: &[Message] = &[Message::Arrives, Message::Lost];
const WILD: &[Message] = &[Message::Arrives, Message::Lost, Message::Old];

/// More cycles than all time limits of a plan together.
const BOUND: usize = 60;

/// 605Ah keeps quick stop active or not, where that matters: also to who finds a drive in that state.
fn with_options(plan: &[Goal]) -> Vec<(Vec<Goal>, bool)> {
    let matters = [Goal::QuickStop, Goal::Resume, Goal::Reach(State::SwitchedOn), Goal::Enable(9)];
    let both = matters.iter().any(|goal| plan.contains(goal));
    [false, true].into_iter().filter(|stays| both || !stays).map(|stays| (plan.to_vec(), stays)).collect()
}

/// Searches all plans; gives the number of states and of steps between them.
fn searched(plans: &[Vec<Goal>], messages: &'static [Message], faults: u8, anytime: bool) -> (usize, usize) {
    let (mut states, mut steps) = (0, 0);
    for (plan, stays) in plans.iter().flat_map(|plan| with_options(plan)) {
        let search =
            Search { plan, stays, outputs: messages, samples: messages, faults, anytime, client: real };
        let found = search.run();
        let what = (&search.plan, stays);
        assert_eq!(found.broken, None, "{what:?}");
        assert!(found.longest <= BOUND, "{what:?}: {} cycles to the end", found.longest);
        states += found.states;
        steps += found.steps;
    }
    (states, steps)
}

#[test]
fn nothing_goes_wrong_with_lost_messages_and_a_fault() {
    let (states, steps) = searched(&plans(), LOSSY, 1, false);
    println!("{states} states, {steps} steps");
    assert!(states > 200_000 && steps > 1_000_000, "{states}, {steps}");
}

#[test]
fn nothing_goes_wrong_with_lost_and_repeated_messages() {
    let (states, steps) = searched(&plans(), WILD, 0, false);
    println!("{states} states, {steps} steps");
    assert!(states > 100_000 && steps > 500_000, "{states}, {steps}");
}

/// Every goal is given up for every other one.
#[test]
fn nothing_goes_wrong_with_goals_that_are_given_up() {
    use Goal::{Disable, Enable, Home, Move, QuickStop, Reset, Select};
    let goals = [Enable(8), Enable(9), Disable, QuickStop, Reset, Select(6)];
    let mut plans: Vec<Vec<Goal>> = goals.iter().flat_map(|a| goals.map(|b| vec![*a, b])).collect();
    plans.extend([vec![Enable(6), Home, Disable], vec![Enable(6), Home, Home], vec![Enable(1), Move, Move]]);
    plans.push(vec![Enable(1), Move, QuickStop]);
    let (states, steps) = searched(&plans, LOSSY, 0, true);
    println!("{states} states, {steps} steps");
    assert!(states > 100_000 && steps > 500_000, "{states}, {steps}");
}
