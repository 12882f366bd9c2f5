//! Modes, states, commands, abort codes, emergency message, terminals, rules, and when written values take effect.

use drivewright_runtime::AbortCode;
use drivewright_runtime::model::{
    AbortDesc, CommandDesc, DriveModel, EffectDesc, EmcyDesc, ModeDesc, StateDesc, TerminalDesc,
};
use drivewright_runtime::rule::RuleDesc;

use super::Arena;
use crate::model::{Command, Entry, Mode, Model, Rule, State, Terminal};

pub(super) fn tables<'a>(profile: &'a Model, arena: &'a Arena, model: &DriveModel<'a>) -> DriveModel<'a> {
    let aborts = profile.aborts.iter().map(|a| AbortDesc::new(AbortCode(a.code.value), &a.name.value));
    let emcy = profile.emcy.iter().map(|e| EmcyDesc::new(e.byte, e.bytes.value, e.holds.value));
    model
        .with_effects(arena.slice(profile.entries.as_slice().iter().filter_map(effect)))
        .with_modes(arena.slice(profile.modes.iter().map(|m| mode(m, arena))))
        .with_states(arena.slice(profile.states.iter().map(state)))
        .with_commands(arena.slice(profile.commands.iter().map(command)))
        .with_aborts(arena.slice(aborts))
        .with_emcy(arena.slice(emcy))
        .with_terminals(arena.slice(profile.terminals.iter().map(|t| terminal(t, profile))))
        .with_rules(arena.slice(profile.rules.iter().map(rule)))
}

fn effect(entry: &Entry) -> Option<EffectDesc> {
    Some(EffectDesc::new(entry.address.into(), entry.effect.as_ref()?.value))
}

fn mode<'a>(mode: &'a Mode, arena: &'a Arena) -> ModeDesc<'a> {
    let row = ModeDesc::new(mode.number, mode.name.value.original());
    let objects = |list: &[crate::model::Address]| arena.slice(list.iter().map(|at| (*at).into()));
    mode.objects.as_ref().map_or(row, |list| row.with_objects(objects(&list.value)))
}

fn state(state: &State) -> StateDesc<'_> {
    StateDesc::new(state.name.value.original(), state.mask.value, state.value.value)
}

fn command(command: &Command) -> CommandDesc<'_> {
    let row = CommandDesc::new(command.name.value.original(), command.mask.value, command.value.value);
    let row = if command.edge.as_ref().is_some_and(|edge| edge.value) { row.on_edge() } else { row };
    command.transitions.as_ref().map_or(row, |list| row.with_transitions(&list.value))
}

fn terminal<'a>(terminal: &'a Terminal, profile: &Model) -> TerminalDesc<'a> {
    let row = TerminalDesc::new(&terminal.name, terminal.kind.value);
    let row = terminal.object.as_ref().map_or(row, |object| row.with_object(object.value.into()));
    let row = terminal.bit.as_ref().map_or(row, |bit| row.with_bit(bit.value));
    profile.function_of(terminal).map_or(row, |function| row.with_function(function.into()))
}

fn rule(rule: &Rule) -> RuleDesc<'_> {
    let row = RuleDesc::new(&rule.id, &rule.text.value);
    let row = rule.on.as_ref().map_or(row, |on| row.with_on(on.value));
    let row = rule.when.as_ref().map_or(row, |when| row.with_when(&when.value.terms));
    rule.require.as_ref().map_or(row, |require| row.with_require(&require.value.terms))
}
