"""From communicative functions to scheduled behaviours, in order: plan, candidates, choice, schedule (paper §3.4,
§3.5), by the rules alone or with a speaker's gesture profile (NGS §3.3)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial, reduce
from types import MappingProxyType
from typing import Self

from .behavior.candidates.attitudes import attitude_candidates, without_faces
from .behavior.candidates.demands import banned_by, beside, demanded, kept_free, permitted, wherever_offered
from .behavior.candidates.notes import directed, unplayed_notes
from .behavior.candidates.planned import candidates_of
from .behavior.candidates.targets import mentions, pointing_candidates, without_overlapped
from .behavior.characters.abstaining import abstaining, forbidden
from .behavior.characters.overlays import Character
from .behavior.choice.offered import not_taken
from .behavior.choice.scheduling import numbered, schedule
from .behavior.idle.stillness import with_stillness
from .behavior.listeners.addressees import addressed, placed_listeners
from .behavior.listeners.listening import Listener, listen
from .behavior.reading.planning import Plan, Understood, meanings, plan, times_s_of
from .behavior.reading.player import Player
from .behavior.reading.supports import supports_of
from .behavior.speaker_profiles.gesture_scripts import (
    gesture_script,
    repertoire_of,
    scripted_behaviors,
    without_chosen_gestures,
    without_planned_gestures,
)
from .behavior.speaker_profiles.habits import as_listener, as_speaker, listening_postures, speaking_postures
from .behavior.speech.visemes import visemes
from .behavior.timing.manner import with_manner
from .bml.writing.writer import losses
from .edits.applying import edited
from .edits.values import WordMark
from .edits.words import marked, unmarked, with_marked
from .model import (
    DEFAULT_CHARACTER,
    Analysis,
    Behavior,
    BehaviorCandidates,
    Demand,
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
from .rules.mapping import map_functions

QUANTITY = MappingProxyType({Level.LOW: 0.85, Level.MEDIUM: 1.0, Level.HIGH: 1.2})
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
        character = abstaining(behavior.performers.named(options.character, level), behavior.families)
        return cls(behavior, as_speaker(character, profile) if profile else character, profile, options, direction)

    @property
    def reads(self) -> bool:
        """Whether the one choice is made, and not the paper's by priority alone: as the caller says, else the
        character, else the settings."""
        choice = self.options.choice or self.character.choice or self.behavior.settings.choice
        return choice == "terms"


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
    line, demands = _understood(performer, analysis)
    player = _player(performer, line, demands)
    performer = replace(performer, direction=_with_marked(performer, analysis, line, player))
    asked = demanded(player, demands)
    planned = _planned(performer, line, player, asked)
    held = attitude_candidates(behavior.attitudes, line.utterance, planned.moments, player) if performer.reads else ()
    planned, asked = replace(planned, moments=without_faces(planned.moments, held)), (*asked, *held)
    analysis = replace(analysis, utterance=with_lead_in(analysis.utterance, options.lead_in_s))
    progress("mapping")
    candidates, moments = _offered(performer, line, player, planned, asked)
    progress("schedule")
    behaviors, script = _scheduled(performer, analysis, candidates, player)
    if performer.reads:
        line = replace(line, utterance=analysis.utterance)
        behaviors = (*behaviors, *not_taken(line, planned, player, behaviors))
    return _told(performer, analysis, moments, behaviors), script


def _player(performer: _Performer, line: Understood, demands: Sequence[Demand]) -> Player:
    """The character as the choice sees it. How much it does depends on the speaker's agitation too (paper §1)."""
    character, families = performer.character, performer.behavior.families
    quantity = QUANTITY[line.utterance.level] * character.liveliness
    bans = tuple(banned_by(demands, families, character.entries))
    seed = performer.options.seed
    return Player(families, character.entries, seed, quantity, bans, character.stands_for)


def _understood(performer: _Performer, analysis: Analysis) -> tuple[Understood, tuple[Demand, ...]]:
    """The line, with what the mapping rules offer for it; and what they, the notes and the character demand."""
    utterance, functions, facts = analysis.utterance, analysis.functions, analysis.facts
    rules, seed, character = performer.behavior.rules, performer.options.seed, performer.character
    mapped = map_functions(rules, utterance, functions, seed=seed, facts=facts)
    always = wherever_offered(character.always, supports_of(mapped.offers), f"the character {character.name}")
    noted = performer.direction.demands if performer.direction else ()
    demands = (*mapped.demands, *always, *forbidden(character), *noted)
    return Understood(utterance, functions, facts, mapped.offers), demands


def _planned(performer: _Performer, line: Understood, player: Player, asked: Sequence[BehaviorCandidates] = ()) -> Plan:
    """The plan of the line: what its phrases mean for gestures, with a director's notes first; the notes alone where
    functions choose by priority, as in the paper. Beside what is `asked` for always."""
    behavior, direction = performer.behavior, performer.direction
    still = kept_free(asked, times_s_of(line.utterance))
    planned = plan(behavior.planner, line, player, still=still) if performer.reads else Plan()
    moments = beside(planned.moments, asked)
    moments = moments if direction is None else directed(direction, moments)
    return replace(planned, moments=without_planned_gestures(moments) if performer.profile else moments)


def _with_marked(performer: _Performer, analysis: Analysis, line: Understood, player: Player) -> Direction | None:
    """The director's notes, and one for each word that the author marked. An important word gets the meaning that the
    plan would give it; where nothing is planned, it is stressed with a beat."""
    edits, words, behavior = performer.options.edits.words, analysis.utterance.words, performer.behavior
    important = {index for mark, index in marked(edits, words) if mark is WordMark.IMPORTANT}
    meant: Mapping[int, tuple[str, ...]] = dict.fromkeys(important, PLAIN_EMPHASIS)
    if important and performer.reads:
        meant = meanings(behavior.planner, line, player, important)
    return with_marked(performer.direction, edits, words, meant)


def _offered(
    performer: _Performer, line: Understood, player: Player, planned: Plan, asked: tuple[BehaviorCandidates, ...]
) -> tuple[tuple[BehaviorCandidates, ...], tuple[Moment, ...]]:
    """The candidates for the functions or the moments, those that point at things the words name, and those asked for
    always."""
    candidates = _candidates(performer, line, player, planned)
    if performer.profile:
        candidates = tuple(without_chosen_gestures(candidates, performer.character.lexemes))
    named = mentions(line.utterance, performer.options.targets)
    pointing = tuple(pointing_candidates(named, line.functions))
    candidates = permitted((*without_overlapped(candidates, named), *pointing), player)
    own = tuple(each.moment for each in (*pointing, *asked) if each.moment)
    return (*candidates, *asked), planned.moments + own


def _candidates(
    performer: _Performer, line: Understood, player: Player, planned: Plan
) -> tuple[BehaviorCandidates, ...]:
    """The candidates for the functions, or for the moments of a line that is planned."""
    if not planned.moments and not performer.reads:
        return tuple(line.offers)
    return candidates_of(player, line.utterance, planned, line.offers)


def _scheduled(
    performer: _Performer, analysis: Analysis, candidates: tuple[BehaviorCandidates, ...], player: Player
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
        bans=player.bans,
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
    behaviors = addressed(with_manner(behaviors, utterance), options.listeners, targets)
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
