"""Answers authors' questions about rules and words: why a line was interpreted as it was, and what a corpus never uses;
and reloads authored files.

Without a recording, conditions on stress, pauses or agitation do not hold (agitation counts as medium), and words have
usual times.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from math import inf

from ..behavior.reading.word_times import usual_times_s
from ..errors import InputError, did_you_mean
from ..loading import OnDemand
from ..model import Analysis, Behavior, Fact, Function, Interval, Level, Line, Moment, Utterance
from ..model.schedule import DEFAULT_CHARACTER
from ..models import BehaviorModels, LanguageModels, Understudy, load_function_rules, load_realizer
from ..options import Options
from ..performance import perform_line
from ..rules.chaining.chainer import Derivation, derive
from ..rules.chaining.matching import FactBase
from ..rules.chaining.tracing import NearMiss, RuleFiring, RuleTrace, ShownStatement, fires, trace_rule, trace_rules
from ..rules.derivation import FunctionRules, derive_facts, understand
from ..rules.lexicon import LexicalEntry
from ..rules.mapping import MappingRules
from ..rules.program.loading import Program, Rule
from ..rules.stage import find_functions
from ..text.transcript import read_transcript

__all__ = [
    "NearMiss",
    "Rule",
    "RuleFiring",
    "RuleTrace",
    "ShownStatement",
    "Trace",
    "UnusedEntries",
    "find_unused",
    "read_again",
    "trace",
    "trace_heard",
    "trace_one",
]

LEAD_S = 1.0


@dataclass(frozen=True, slots=True)
class Trace:
    """A text, the traces of the function rules and mapping rules on it, the moments that are planned, and what was and
    was not shown."""

    utterance: Utterance
    functions: RuleTrace
    mappings: RuleTrace
    moments: tuple[Moment, ...] = ()
    behaviors: tuple[Behavior, ...] = ()


@dataclass(frozen=True, slots=True)
class UnusedEntries:
    """Rules that never fired and lexicon entries that never matched, in the order of their files."""

    rules: tuple[Rule, ...]
    words: tuple[LexicalEntry, ...]


def trace(understudy: Understudy, text: str, character: str = DEFAULT_CHARACTER) -> Trace:
    """The rules that fired, those that nearly did, the plan, and what is shown at usual times. Raises InputError for an
    unusable text and an unknown character."""
    return trace_heard(understudy, _at_usual_times(find_functions(understudy.language, text)), character)


def trace_heard(understudy: Understudy, analysis: Analysis, character: str = DEFAULT_CHARACTER) -> Trace:
    """The same for an analysed recording."""
    language, behavior, utterance = understudy.language, understudy.behavior, analysis.utterance
    found = derive_facts(language.rules, utterance)
    mapped = _mapped(behavior.rules, utterance, language.rules)
    options = Options(character=character)
    performance = perform_line(understudy, Line(None, ""), options, analysis=analysis, near=inf).performance
    return Trace(
        utterance,
        trace_rules(language.rules.program, found.facts),
        trace_rules(behavior.rules.program, mapped.facts),
        performance.moments,
        performance.behaviors,
    )


def _at_usual_times(analysis: Analysis) -> Analysis:
    """The analysis of words alone as if they had been said, after a second in which hands can be raised."""
    words = analysis.utterance.words
    times_s = usual_times_s(len(words) + 1)
    timed = tuple(
        replace(word, interval=Interval(LEAD_S + begin_s, LEAD_S + end_s))
        for word, (begin_s, end_s) in zip(words, pairwise(times_s), strict=True)
    )
    return replace(analysis, utterance=replace(analysis.utterance, words=timed, duration_s=LEAD_S + times_s[-1]))


def trace_one(understudy: Understudy, text: str, *, rule: str) -> Trace:
    """Where one rule fired, or came nearest to it. Raises InputError `unknown_name` if there is no such rule."""
    language, behavior = understudy.language, understudy.behavior
    of_functions, of_mappings = language.rules.program, behavior.rules.program
    program, chosen = _named(rule, (of_functions, of_mappings))
    utterance, found, mapped = _derived(language, behavior, text)
    nothing = RuleTrace((), ())
    if program is of_functions:
        return Trace(utterance, trace_rule(program, chosen, found.facts), nothing)
    return Trace(utterance, nothing, trace_rule(program, chosen, mapped.facts))


def find_unused(language: LanguageModels, behavior: BehaviorModels, texts: Iterable[str]) -> UnusedEntries:
    """The rules and words that none of the texts uses. An entry that only occurs within a longer one of its class
    counts as unused."""
    waiting = (list(language.rules.program.rules), list(behavior.rules.program.rules))
    words = {id(entry): entry for entry in language.rules.lexicon.entries if entry.subtype is not None}
    for text in texts:
        utterance, *derived = _derived(language, behavior, text)
        for match in language.rules.lexicon.matches(utterance):
            words.pop(id(match.entry), None)
        for rules, derivation in zip(waiting, derived, strict=True):
            rules[:] = _still_unused(rules, derivation)
    return UnusedEntries(tuple(rule for rules in waiting for rule in rules), tuple(words.values()))


def read_again(understudy: Understudy) -> Understudy:
    """The same models with rules, words, tables, characters and gestures reloaded from their files.

    The aligner keeps its abbreviations. Raises AuthoringError if a file has mistakes.
    """
    realizer = load_realizer()
    return replace(
        understudy,
        language=replace(understudy.language, rules=load_function_rules()),
        behavior=BehaviorModels.load(understudy.behavior.settings),
        when_realizing=OnDemand(lambda: realizer),
    )


def _still_unused(rules: Sequence[Rule], derivation: Derivation) -> list[Rule]:
    """The rules that did not fire; those that are not the first reason of any fact are checked one by one."""
    fired = {reason.rule for reason in derivation.reasons.values()} | {choice.rule for choice in derivation.choices}
    base = FactBase.of(derivation.facts)
    silent = (rule for rule in rules if rule.name not in fired)
    return [rule for rule in silent if rule.kind == "choose" or not fires(rule, base)]


def _derived(language: LanguageModels, behavior: BehaviorModels, text: str) -> tuple[Utterance, Derivation, Derivation]:
    words = read_transcript(text)
    utterance = Utterance(words=words, parse=language.parser.parse(words))
    return utterance, derive_facts(language.rules, utterance), _mapped(behavior.rules, utterance, language.rules)


def _mapped(mappings: MappingRules, utterance: Utterance, rules: FunctionRules) -> Derivation:
    """The derivation of the mapping rules from the functions that are kept."""
    known = understand(rules, utterance)
    kept = {_fact(function): function.priority for function in known.functions if function.kept}
    asked = (fact for fact in known.facts if fact.predicate in mappings.asked and fact.predicate != "fcn")
    given = (*asked, Fact("agitation", (Level.MEDIUM.value,)), *kept)
    return derive(mappings.program, given, annotations=kept)


def _fact(function: Function) -> Fact:
    return Fact("fcn", (function.class_name, function.subtype, function.first, function.last + 1))


def _named(name: str, programs: Iterable[Program]) -> tuple[Program, Rule]:
    rules = {rule.name: (program, rule) for program in programs for rule in program.rules}
    if name not in rules:
        hint = did_you_mean(name, rules, most=3, otherwise="; see rules list")
        raise InputError("unknown_name", f"no rule is called {name!r}{hint}", field="rule")
    return rules[name]
