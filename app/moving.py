"""From communicative functions to scheduled behaviours, in order: plan, candidates, choice, schedule (paper §3.4,
§3.5), by the rules alone or with a speaker's gesture profile (NGS §3.3)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import partial, reduce
from types import MappingProxyType
from typing import Self

from .behavior.candidates.notes import directed, unplayed_notes
from .behavior.candidates.planned import candidates_of
from .behavior.candidates.targets import mentions, pointing_candidates, without_overlapped
from .behavior.characters.overlays import Character
from .behavior.choice.scheduling import numbered, schedule
from .behavior.idle.stillness import with_stillness
from .behavior.listeners.addressees import addressed, placed_listeners
from .behavior.listeners.listening import Listener, listen
from .behavior.reading.planning import Plan, Understood, meanings, plan
from .behavior.reading.player import Player
from .behavior.speaker_profiles.gesture_scripts import (
    gesture_script,
    repertoire_of,
    scripted_behaviors,
    without_chosen_gestures,
    without_planned_gestures,
)
from .behavior.speaker_profiles.habits import as_listener, as_speaker, listening_postures, speaking_postures
from .behavior.speech.visemes import visemes
from .bml.writing.writer import losses
from .edits.applying import edited
from .edits.values import WordMark
from .edits.words import marked, unmarked, with_marked
from .model import (
    DEFAULT_CHARACTER,
    Analysis,
    Behavior,
    BehaviorCandidates,
    Direction,
    Level,
    Listening,
    Moment,
    Notice,
    Performance,
)
from .model.lead_in import with_lead_in
from .models import BehaviorModels
from .options import Options
from .profiles.generation.script import GestureScript
from .profiles.profile import Profile
from .progress import Progress, no_progress
from .rules.mapping import offer_movements

QUANTITY = MappingProxyType({Level.LOW: 0.9, Level.MEDIUM: 1.0, Level.HIGH: 1.15})
"""How the amount of movement is scaled at each level of agitation (paper §1)."""

PLAIN_EMPHASIS = ("beat",)
"""The gesture families for an important word of which nothing else is known."""


@dataclass(frozen=True, slots=True)
class _Performer:
    """The performer and what the caller asked for; the character already has the habits of the profile."""

    behavior: BehaviorModels
    character: Character
    profile: Profile | None
    options: Options
    direction: Direction | None

    @classmethod
    def of(cls, behavior: BehaviorModels, level: Level, options: Options, direction: Direction | None) -> Self:
        """Raises InputError `unknown_character`, `unknown_profile`."""
        profile = behavior.profile(options.profile)
        character = behavior.performers.named(options.character, level)
        return cls(behavior, as_speaker(character, profile) if profile else character, profile, options, direction)


def move(
    behavior: BehaviorModels,
    analysis: Analysis,
    options: Options,
    direction: Direction | None = None,
    progress: Progress = no_progress,
) -> tuple[Performance, GestureScript | None]:
    """The performance of an analysed line, with a director's notes applied, and the gesture script that its hands
    follow if a profile is named.

    Raises InputError `unknown_character`, `unknown_profile`.
    """
    performer = _Performer.of(behavior, analysis.utterance.level, options, direction)
    progress("plan")
    player = _player(performer, analysis)
    line = _understood(performer, analysis)
    performer = replace(performer, direction=_with_marked(performer, analysis, line, player))
    planned = _planned(performer, line, player)
    analysis = replace(analysis, utterance=with_lead_in(analysis.utterance, options.lead_in_s))
    progress("mapping")
    candidates, moments = _offered(performer, analysis, planned, player, line)
    progress("schedule")
    behaviors, script = _scheduled(performer, analysis, candidates)
    return _told(performer, analysis, moments, behaviors), script


def _player(performer: _Performer, analysis: Analysis) -> Player:
    """The character as the choice sees it. How much it does depends on the speaker's agitation too (paper §1)."""
    character = performer.character
    quantity = QUANTITY[analysis.utterance.level] * character.liveliness
    return Player(performer.behavior.families, character.entries, performer.options.seed, quantity)


def _understood(performer: _Performer, analysis: Analysis) -> Understood:
    """The line, with what the mapping rules offer for it."""
    utterance, functions, facts = analysis.utterance, analysis.functions, analysis.facts
    offers = offer_movements(performer.behavior.rules, utterance, functions, seed=performer.options.seed, facts=facts)
    return Understood(utterance, functions, facts, offers)


def _planned(performer: _Performer, line: Understood, player: Player) -> Plan:
    """The plan of the line: what its phrases mean for gestures, with a director's notes first; the notes alone where
    functions choose by priority, as in the paper."""
    behavior, direction = performer.behavior, performer.direction
    planned = plan(behavior.planner, line, player) if behavior.settings.choice == "terms" else Plan()
    moments = planned.moments if direction is None else directed(direction, planned.moments)
    return replace(planned, moments=without_planned_gestures(moments) if performer.profile else moments)


def plan_line(behavior: BehaviorModels, analysis: Analysis, options: Options) -> Plan:
    """The plan of an analysed line, as it would be performed."""
    performer = _Performer.of(behavior, analysis.utterance.level, options, None)
    return _planned(performer, _understood(performer, analysis), _player(performer, analysis))


def _with_marked(performer: _Performer, analysis: Analysis, line: Understood, player: Player) -> Direction | None:
    """The director's notes, and one for each word that the author marked. An important word gets the meaning that the
    plan would give it; where nothing is planned, it is stressed with a beat."""
    edits, words, behavior = performer.options.edits.words, analysis.utterance.words, performer.behavior
    important = {index for mark, index in marked(edits, words) if mark is WordMark.IMPORTANT}
    meant: Mapping[int, tuple[str, ...]] = dict.fromkeys(important, PLAIN_EMPHASIS)
    if important and behavior.settings.choice == "terms":
        meant = meanings(behavior.planner, line, player, important)
    return with_marked(performer.direction, edits, words, meant)


def _offered(
    performer: _Performer, analysis: Analysis, planned: Plan, player: Player, line: Understood
) -> tuple[tuple[BehaviorCandidates, ...], tuple[Moment, ...]]:
    """The candidates for the functions or the moments, and those that point at things the words name."""
    candidates = _candidates(performer, planned, player, line)
    if performer.profile:
        candidates = tuple(without_chosen_gestures(candidates, performer.character.lexemes))
    named = mentions(analysis.utterance, performer.options.targets)
    pointing = tuple(pointing_candidates(named, analysis.functions))
    candidates = (*without_overlapped(candidates, named), *pointing)
    return candidates, planned.moments + tuple(each.moment for each in pointing if each.moment)


def _candidates(
    performer: _Performer, planned: Plan, player: Player, line: Understood
) -> tuple[BehaviorCandidates, ...]:
    """The candidates for the functions, or for the moments of a line that is planned."""
    if not planned.moments and performer.behavior.settings.choice != "terms":
        return tuple(line.offers)
    return candidates_of(player, line.utterance, planned, line.offers)


def _scheduled(
    performer: _Performer, analysis: Analysis, candidates: tuple[BehaviorCandidates, ...]
) -> tuple[tuple[Behavior, ...], GestureScript | None]:
    """The chosen behaviours with their times, those of a profile's gesture script among them, and that script."""
    options, script = performer.options, None
    behaviors = schedule(
        candidates,
        analysis.utterance,
        performer.character,
        seed=options.seed,
        mode=options.mode,
        several_listeners=len(options.listeners) > 1,
    )
    if performer.profile:
        repertoire = repertoire_of(performer.character, performer.behavior.families, performer.direction, behaviors)
        script = gesture_script(
            performer.profile, repertoire, analysis.utterance, analysis.functions, seed=options.seed
        )
        behaviors = (*behaviors, *speaking_postures(performer.profile))
        behaviors = numbered((*behaviors, *scripted_behaviors(script, analysis.functions, behaviors)))
    return behaviors, script


def _told(
    performer: _Performer,
    analysis: Analysis,
    moments: tuple[Moment, ...],
    behaviors: tuple[Behavior, ...],
) -> Performance:
    """The performance with lips, an author's edits, listeners and notices."""
    options, utterance = performer.options, analysis.utterance
    targets = placed_listeners(options.listeners, options.targets)
    behaviors = addressed(behaviors, options.listeners, targets)
    lips, lip_notices = visemes(utterance.words, utterance.duration_s or 0.0)
    performance = Performance(
        utterance=utterance,
        functions=analysis.functions,
        behaviors=behaviors,
        character=performer.character.name,
        seed=options.seed,
        notices=(
            *analysis.notices,
            *lip_notices,
            *unplayed_notes(moments, behaviors),
            *unmarked(options.edits.words, utterance.words),
        ),
        visemes=lips,
        moments=moments,
        targets=targets,
    )
    performance = edited(performance, options.edits.behaviors, performer.character)
    heard_by = partial(_heard_by, performer.behavior, options)
    performance = with_stillness(reduce(heard_by, options.listeners, performance), options.stillness)
    return replace(performance, notices=performance.notices + losses(performance, options.form))


def _heard_by(behavior: BehaviorModels, options: Options, performance: Performance, name: str) -> Performance:
    """The performance with one more listener: played by the character the options name, else by the character of that
    name, else by the default; with the head, posture and rests of the profile that the options name, if any.

    Raises InputError `unknown_profile`.
    """
    characters, notices = behavior.characters, performance.notices
    played = dict(options.played_by).get(name, name)
    if played not in characters.by_name:
        message = f"no character is called {name!r}; this listener moves as {DEFAULT_CHARACTER!r} does"
        notices = (*notices, Notice("listener_unknown", message))
    character = characters.by_name.get(played) or characters.named(DEFAULT_CHARACTER)
    profile = behavior.profile(dict(options.listener_profiles).get(name))
    rates = as_listener(behavior.head_rates, profile) if profile else behavior.head_rates
    listener = Listener(replace(character, name=name), rates, performance.character)
    behaviors = listen(performance.behaviors, performance.utterance, listener, seed=performance.seed)
    if profile:
        postures = listening_postures(profile, performance.utterance.duration_s or 0.0)
        behaviors = numbered((*postures, *behaviors))
    return replace(performance, listeners=(*performance.listeners, Listening(name, behaviors)), notices=notices)
