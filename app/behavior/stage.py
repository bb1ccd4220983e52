"""The behaviour stage: from functions, the voice and a reading of the words to scheduled behaviours (paper §3.4, §3.5),
by the rules alone or with a speaker's gesture profile (NGS §3.3).

In order: `plan_line` plans the moments of a line, `offer_candidates` says what could show them, `schedule_line` decides
and times, `assemble` makes the performance, `with_listeners` adds whoever listens.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial, reduce
from types import MappingProxyType
from typing import Protocol

from ..model import (
    DEFAULT_CHARACTER,
    Analysis,
    Behavior,
    BehaviorCandidates,
    Demand,
    Direction,
    Level,
    Listening,
    MappedFunctions,
    Moment,
    Notice,
    Performance,
    Tone,
)
from ..options import Options
from ..profiles.generation.script import GestureScript
from ..profiles.profile import Profile
from ..settings import Settings
from .candidates.attitudes import Attitude, attitude_candidates, without_faces
from .candidates.demands import (
    banned_by,
    beside,
    check_demands,
    demanded,
    kept_free,
    overruled,
    permitted,
    wherever_offered,
)
from .candidates.notes import directed, unplayed_notes
from .candidates.planned import candidates_of
from .candidates.targets import mentions, pointing_candidates, without_overlapped
from .characters.gesture_forms import FormedCharacters
from .characters.overlays import Character, Characters, abstaining, forbidden
from .choice.offered import NEAR, not_taken
from .choice.scheduling import numbered, schedule
from .listeners.listening import HeadRates, Listener, addressed, listen, placed_listeners
from .reading.families import Families
from .reading.planner import Planner
from .reading.planning import Plan, Understood, meanings, plan
from .reading.player import Ban, Player, banned
from .reading.supports import supports_of
from .reading.word_times import times_s_of
from .slots.gestures import with_slots
from .slots.table import SlotTable
from .speaker_profiles import (
    as_listener,
    as_speaker,
    gesture_script,
    listening_postures,
    repertoire_of,
    scripted_behaviors,
    speaking_postures,
    without_chosen_gestures,
    without_planned_gestures,
)
from .speech import expanded_in_rhemes, visemes
from .timing.phases import with_manner

QUANTITY = MappingProxyType({Level.LOW: 0.8, Level.MEDIUM: 1.0, Level.HIGH: 1.4})
"""How many gestures are made at each level of agitation, relative to medium (paper §1). Heads and faces are not fewer
where a voice is calm: directors name as many of them."""

PLAIN_EMPHASIS = ("beat",)
"""The gesture families for an important word of which nothing else is known."""


class BehaviorStage(Protocol):
    """What the stage needs of the models that are loaded once, such as `understudy.models.BehaviorModels`."""

    @property
    def settings(self) -> Settings: ...

    @property
    def characters(self) -> Characters: ...

    @property
    def families(self) -> Families: ...

    @property
    def attitudes(self) -> Mapping[Tone, Attitude]: ...

    @property
    def planner(self) -> Planner: ...

    @property
    def slots(self) -> SlotTable: ...

    @property
    def head_rates(self) -> HeadRates: ...

    @property
    def performers(self) -> FormedCharacters: ...

    def profile(self, profile: Profile | str | None) -> Profile | None: ...


@dataclass(frozen=True, slots=True)
class Performer:
    """Who performs a line, and what the line, the rules, the notes and the caller ask for; the character already has
    the habits of the profile. What was offered and is not shown is reported if it came so `near` (`choice.offered`)."""

    models: BehaviorStage
    character: Character
    profile: Profile | None
    options: Options
    line: Understood
    player: Player
    demands: tuple[Demand, ...] = ()
    direction: Direction | None = None
    near: float = NEAR

    @property
    def reads(self) -> bool:
        """Whether the one choice is made, and not the paper's by priority alone."""
        return not chooses_by_priority(self.models, self.options)


def chooses_by_priority(models: BehaviorStage, options: Options) -> bool:
    """Whether movements are chosen by priority alone, as in the paper: as the caller says, else the character, else the
    settings. Raises InputError `unknown_character`."""
    character = models.characters.named(options.character)
    return (options.choice or character.choice or models.settings.choice) == "priority"


@dataclass(frozen=True, slots=True)
class PlannedLine:
    """The moments of a line, and the candidates that are shown whatever else is: those asked for always, and attitudes
    held over phrases."""

    plan: Plan
    held: tuple[BehaviorCandidates, ...]


def performer_of(
    models: BehaviorStage,
    analysis: Analysis,
    options: Options,
    *,
    mapped: MappedFunctions,
    direction: Direction | None = None,
    near: float = NEAR,
) -> Performer:
    """The performer of an analysed line; `mapped` is what the mapping rules say of it (paper §3.4).

    Raises InputError `unknown_character`, `unknown_profile`.
    """
    profile = models.profile(options.profile)
    character = abstaining(models.performers.named(options.character, analysis.utterance.level), models.families)
    character = as_speaker(character, profile) if profile else character
    noted = direction.demands if direction else ()
    check_demands(noted, models.families, character.entries)
    demands = (*mapped.demands, *forbidden(character), *noted)
    line = Understood(analysis.utterance, analysis.functions, analysis.facts, mapped.offers)
    player = _player(models, character, line, options, demands)
    always = wherever_offered(character.always, supports_of(mapped.offers), player, f"the character {character.name}")
    return Performer(models, character, profile, options, line, player, (*demands, *always), direction, near)


def _player(
    models: BehaviorStage, character: Character, line: Understood, options: Options, demands: Sequence[Demand]
) -> Player:
    """The character as the choice sees it. How much its hands do depends on the speaker's agitation too (paper §1)."""
    return Player(
        models.families,
        character.entries,
        options.seed,
        quantity=character.liveliness,
        by_agitation=QUANTITY[line.utterance.level],
        bans=tuple(banned_by(demands, models.families, character.entries)),
        stands_for=character.stands_for,
    )


def meanings_at(performer: Performer, words: Collection[int]) -> Mapping[int, tuple[str, ...]]:
    """The gesture families that suit each of these words: what the plan would show there; a beat where functions choose
    by priority."""
    if words and performer.reads:
        return meanings(performer.models.planner, performer.line, performer.player, words)
    return dict.fromkeys(words, PLAIN_EMPHASIS)


def plan_line(performer: Performer) -> PlannedLine:
    """The plan of the line: what its phrases mean for gestures, heads and faces, with a director's notes first; the
    notes alone where functions choose by priority, as in the paper."""
    asked = demanded(performer.player, performer.demands, performer.line.utterance)
    planned = _planned(performer, asked)
    if not performer.reads:
        return PlannedLine(planned, asked)
    utterance, attitudes = performer.line.utterance, performer.models.attitudes
    held = attitude_candidates(attitudes, utterance, planned.moments, performer.player)
    return PlannedLine(replace(planned, moments=without_faces(planned.moments, held)), (*asked, *held))


def _planned(performer: Performer, asked: Sequence[BehaviorCandidates]) -> Plan:
    """The plan beside what is `asked` for always."""
    line, direction = performer.line, performer.direction
    still = kept_free(asked, times_s_of(line.utterance))
    planned = plan(performer.models.planner, line, performer.player, still=still) if performer.reads else Plan()
    moments = beside(planned.moments, asked)
    moments = moments if direction is None else directed(direction, moments)
    return replace(planned, moments=without_planned_gestures(moments) if performer.profile else moments)


def offer_candidates(
    performer: Performer, planned: PlannedLine
) -> tuple[tuple[BehaviorCandidates, ...], tuple[Moment, ...]]:
    """The candidates for the functions or the moments, those that point at things the words name, and those asked for
    always; and all moments."""
    line, player = performer.line, performer.player
    candidates = _candidates(performer, planned.plan)
    if performer.profile:
        candidates = tuple(without_chosen_gestures(candidates, performer.character.lexemes))
    named = mentions(line.utterance, performer.options.targets)
    pointing = tuple(pointing_candidates(named, line.functions))
    candidates = permitted((*without_overlapped(candidates, named), *pointing), player)
    own = tuple(each.moment for each in (*pointing, *planned.held) if each.moment)
    return (*candidates, *planned.held), planned.plan.moments + own


def _candidates(performer: Performer, planned: Plan) -> tuple[BehaviorCandidates, ...]:
    """The candidates for the functions, or for the moments of a line that is planned."""
    if not planned.moments and not performer.reads:
        return tuple(performer.line.offers)
    return candidates_of(performer.player, performer.line.utterance, planned, performer.line.offers)


def schedule_line(
    performer: Performer, analysis: Analysis, planned: PlannedLine, candidates: Sequence[BehaviorCandidates]
) -> tuple[tuple[Behavior, ...], GestureScript | None]:
    """The chosen behaviours with their times, those of a profile's gesture script among them, what was offered and not
    taken, and that script; the analysis is on the clock of the performance."""
    options, profile = performer.options, performer.profile
    behaviors = schedule(
        tuple(candidates),
        analysis.utterance,
        performer.character,
        seed=options.seed,
        mode=options.mode,
        several_listeners=len(options.listeners) > 1,
        bans=performer.player.bans,
    )
    if profile is None:
        return (*behaviors, *_not_taken(performer, analysis, planned, behaviors)), None
    repertoire = repertoire_of(performer.player, performer.character, performer.direction, behaviors)
    script = gesture_script(profile, repertoire, analysis.utterance, analysis.functions, seed=options.seed)
    habits = _permitted(speaking_postures(profile), performer.player.bans, performer.character)
    behaviors = (*behaviors, *habits)
    behaviors = numbered((*behaviors, *scripted_behaviors(script, analysis.functions, behaviors)))
    return (*behaviors, *_not_taken(performer, analysis, planned, behaviors)), script


def _permitted(postures: Iterable[Behavior], bans: Collection[Ban], character: Character) -> Iterator[Behavior]:
    """The postures of a profile that the character is not forbidden."""
    for posture in postures:
        names = (name for name, (_channel, lexeme) in character.lexemes.items() if lexeme == posture.lexeme)
        if not any(banned(bans, name, posture.first, posture.last) for name in names):
            yield posture


def _not_taken(
    performer: Performer, analysis: Analysis, planned: PlannedLine, behaviors: tuple[Behavior, ...]
) -> Sequence[Behavior]:
    if not performer.reads:
        return ()
    line = replace(performer.line, utterance=analysis.utterance)
    forbidden_there = overruled(performer.player, performer.demands, analysis.utterance)
    plan = replace(planned.plan, moments=(*planned.plan.moments, *forbidden_there))
    return tuple(not_taken(line, plan, performer.player, behaviors, near=performer.near))


def assemble(
    performer: Performer, analysis: Analysis, moments: tuple[Moment, ...], behaviors: tuple[Behavior, ...]
) -> Performance:
    """The performance: behaviours with the manner of the voice, addressees and slots, lips, targets and notices."""
    options, utterance = performer.options, analysis.utterance
    targets = placed_listeners(options.listeners, options.targets)
    behaviors = addressed(with_manner(behaviors, utterance), options.listeners, targets)
    behaviors = with_slots(behaviors, analysis, moments, performer.models.slots, options.listeners)
    behaviors = expanded_in_rhemes(behaviors, utterance.words, analysis.functions)
    lips, lip_notices = visemes(utterance.words, utterance.duration_s or 0.0)
    return Performance(
        utterance=utterance,
        functions=analysis.functions,
        behaviors=behaviors,
        character=performer.character.name,
        seed=options.seed,
        notices=(*analysis.notices, *lip_notices, *unplayed_notes(moments, behaviors)),
        visemes=lips,
        moments=moments,
        targets=targets,
    )


def with_listeners(models: BehaviorStage, performance: Performance, options: Options) -> Performance:
    """The performance with everybody who listens (paper §3.6). Raises InputError `unknown_profile`."""
    return reduce(partial(_heard_by, models, options), options.listeners, performance)


def _heard_by(models: BehaviorStage, options: Options, performance: Performance, name: str) -> Performance:
    """The performance with one more listener: played by the character the options name, else by the character of that
    name, else by the default; with the head, posture and rests of the profile that the options name, if any.

    Raises InputError `unknown_profile`.
    """
    characters, notices = models.characters, performance.notices
    played = dict(options.played_by).get(name, name)
    if played not in characters.by_name:
        message = f"no character is called {played!r}; this listener moves as {DEFAULT_CHARACTER!r} does"
        notices = (*notices, Notice("listener_unknown", message))
    character = abstaining(characters.by_name.get(played) or characters.named(DEFAULT_CHARACTER), models.families)
    bans = tuple(banned_by(forbidden(character), models.families, character.entries))
    profile = models.profile(dict(options.listener_profiles).get(name))
    rates = as_listener(models.head_rates, profile) if profile else models.head_rates
    listener = Listener(replace(character, name=name), rates, performance.character, bans)
    behaviors = listen(performance.behaviors, performance.utterance, listener, seed=performance.seed)
    if profile:
        postures = listening_postures(profile, performance.utterance.duration_s or 0.0)
        behaviors = numbered((*_permitted(postures, bans, character), *behaviors))
    return replace(performance, listeners=(*performance.listeners, Listening(name, behaviors)), notices=notices)
