"""A live stream, step by step: sound, words and commands in, messages out.

The stream's clock is its sound: the seconds heard so far, announced silences included. Nothing here waits or reads
another clock, so the same input always gives the same messages. While known words are being spoken, the rules perform
them and the voice moves nothing but the mouth; before and after, the voice does.
"""

from collections.abc import Iterable, Iterator
from dataclasses import replace

import numpy as np

from ..behavior.characters.overlays import abstaining, never_shown
from ..errors import InputError
from ..model import Affect, Behavior, FloatArray, Word
from ..motion_models.playing import UnitPlayer
from ..options import Options
from .agenda import REMEMBERED_S, WORDED, Agenda, Placer
from .body import BodyFrame, BodyRequest, LiveBody, LiveBodyOptions
from .ear import Ear, RecentVoice, RunningFeeling
from .messages import LiveMessage, LiveOptions, MouthMessage, PhraseMessage
from .models import LiveModels
from .mouth import MouthShape, StreamingMouth
from .movements import Attention, LiveEvent, LiveEvents, Movements
from .words import PerformedPhrase, TimedText, paced_words, perform_words, timed_words

MOST_AHEAD_S = 120.0
MOST_WAITING = 100
"""Texts that may wait for a phrase."""

BESIDE_WORDS_S = 0.2
LONGEST_SILENCE_S = 60.0


class LiveSession:
    """One stream. Memory is bounded. Raises InputError `unknown_character`."""

    def __init__(self, models: LiveModels, options: LiveOptions) -> None:
        behavior = models.understudy.behavior
        self._models, self._options = models, options
        character = abstaining(behavior.characters.named(options.character), behavior.families)
        self._placer = Placer.of(character, options.seed)
        self._never = frozenset(never_shown(character, behavior.families))
        self._own, self._other = Ear(options.sample_rate_hz), Ear(options.sample_rate_hz)
        self._recent, self._feeling = RecentVoice(), RunningFeeling()
        self._events, self._mouth = LiveEvents(models.voice), StreamingMouth(models.mouth)
        self._movements = Movements(models.table, self._placer)
        self._attention = Attention(models.table, self._placer, behavior.head_rates)
        self._body = _body(models, options)
        self._player = None if models.motion is None else UnitPlayer(models.motion, options.search)
        self._agenda = Agenda()
        self._phrases: tuple[PerformedPhrase, ...] = ()
        self._waiting: tuple[str, ...] = ()
        self._shapes: list[MouthShape] = []
        self._heard = self._performed = 0
        self._listens = False

    @property
    def heard_s(self) -> float:
        """Now, on the stream's clock."""
        return self._heard / self._options.sample_rate_hz

    @property
    def affect(self) -> Affect | None:
        """The affect of the current phrase as far as it was heard, or of the one before."""
        began_s = self._own.phrase_began_s
        return self._feeling.of_phrase(
            self._models.understudy.acoustic, None if began_s is None else self.heard_s - began_s
        )

    def hear(self, own: FloatArray | None, other: FloatArray | None = None) -> tuple[LiveMessage, ...]:
        """Mono samples in [-1, 1] of the character's voice and of the other's; None is silence of the same length."""
        count = len(own) if own is not None else len(other) if other is not None else 0
        self._heard += count
        self._listens = self._listens or other is not None
        told = list(self._spoken(np.zeros(count) if own is None else own))
        if self._listens:
            told += self._listened(np.zeros(count) if other is None else other)
        if not self._is_worded():
            told += self._kept(self._attention.passed(self.heard_s))
        self._forget()
        return (*told, *self._frames())

    def silence(self, duration_s: float) -> tuple[LiveMessage, ...]:
        """A stretch without sound: lost chunks, or a microphone that is off."""
        if not 0 <= duration_s <= LONGEST_SILENCE_S:
            message = f"duration_s: {duration_s:g}; a silence is 0 to {LONGEST_SILENCE_S:g} s long"
            raise InputError("value_wrong", message, field="duration_s")
        return self.hear(np.zeros(round(duration_s * self._options.sample_rate_hz)))

    def words(self, timed: tuple[TimedText, ...]) -> tuple[LiveMessage, ...]:
        """Words of the character, with times. Raises InputError as `timed_words` does, `value_wrong` for times too far
        from now."""
        begin_s = timed[0].interval.start_s
        if abs(begin_s - self.heard_s) > MOST_AHEAD_S:
            message = f"words: they begin at {begin_s:g} s, too far from the stream's {self.heard_s:.2f} s"
            raise InputError("value_wrong", message, field="words")
        return tuple(self._perform(timed_words(self._models, timed, self._recent)))

    def text(self, text: str) -> tuple[LiveMessage, ...]:
        """Words of the character without times: those of the current phrase, or of the next one without words. Raises
        InputError as `paced_words` does, `words_waiting`."""
        began_s = self._own.phrase_began_s
        words = paced_words(self._models, text, began_s or 0.0)
        if began_s is not None and not self._is_worded():
            return tuple(self._perform(words))
        if len(self._waiting) == MOST_WAITING:
            raise InputError("words_waiting", f"{MOST_WAITING} texts wait for a voice; send the sound first")
        self._waiting = (*self._waiting, text)
        return ()

    def interrupt(self) -> tuple[LiveMessage, ...]:
        """Cancels everything current and planned."""
        self._phrases, self._waiting = (), ()
        self._movements.forget()
        told = tuple(self._agenda.give_up(self.heard_s))
        self._ask()
        return told

    def _spoken(self, samples: FloatArray) -> Iterator[LiveMessage]:
        """Messages from the character's own voice."""
        samples = self._own.resampled(samples)
        self._feeling.hear(samples)
        energy_db, f0_hz = self._own.contours(samples)
        self._recent.hear(energy_db, f0_hz)
        for shape in self._mouth.hear(samples):
            self._shapes.append(shape)
            yield MouthMessage(shape, self.heard_s)
        for edge in self._own.phrases(f0_hz):
            if edge.begins and self._waiting and not self._is_worded():
                text, *rest = self._waiting
                self._waiting = tuple(rest)
                yield from self._perform(paced_words(self._models, text, edge.at_s))
            if not edge.begins:
                self._movements.release()
            if not self._is_worded():
                yield from self._kept(self._attention.spoken(edge, self.heard_s))
        heard = () if self._player is None else self._player.hear(energy_db, f0_hz)
        yield from (PhraseMessage(phrase, self.heard_s) for phrase in heard)
        yield from self._moved_by_voice(self._events.hear(energy_db, f0_hz, self.heard_s))

    def _moved_by_voice(self, events: Iterable[LiveEvent]) -> Iterator[LiveMessage]:
        if self._is_worded():
            return
        for event in events:
            if not self._moves(event.part):
                yield from self._kept(self._movements.moved(event, self.heard_s))
        yield from self._kept(self._movements.passed(self.heard_s))

    def _listened(self, samples: FloatArray) -> Iterator[LiveMessage]:
        """Messages from the other's voice."""
        _, f0_hz = self._other.contours(self._other.resampled(samples))
        for edge in self._other.phrases(f0_hz):
            yield from self._kept(self._attention.listened(edge, self.heard_s))

    def _kept(self, behaviors: Iterable[Behavior]) -> Iterator[LiveMessage]:
        """Schedules what the voice alone asks for, except what the character never shows."""
        shown = [each for each in behaviors if (each.kind, each.lexeme) not in self._never]
        yield from self._agenda.keep(shown, self.heard_s)

    def _is_worded(self) -> bool:
        """Whether known words are being spoken."""
        spoken = (each.interval for each in self._phrases)
        return any(each.start_s - BESIDE_WORDS_S <= self.heard_s < each.end_s + BESIDE_WORDS_S for each in spoken)

    def _perform(self, words: tuple[Word, ...]) -> Iterator[LiveMessage]:
        """The rules take over for these words; movements from the voice end as they begin."""
        options = Options(character=self._options.character, seed=self._options.seed, stillness=self._options.stillness)
        phrase = perform_words(self._models.understudy, words, options, self.heard_s, self.affect)
        self._performed += 1
        named = (replace(each, id=f"{WORDED}{self._performed}.{each.id}") for each in phrase.behaviors)
        behaviors = self._agenda.beside(named)
        self._phrases = (*self._phrases, replace(phrase, behaviors=()))
        self._movements.forget()
        yield from self._agenda.make_way(behaviors, self.heard_s)
        yield from self._agenda.keep(behaviors, self.heard_s)
        self._ask()

    def _forget(self) -> None:
        until_s = self.heard_s - REMEMBERED_S
        self._agenda.forget(self.heard_s)
        self._phrases = tuple(each for each in self._phrases if each.interval.end_s >= until_s)
        while len(self._shapes) > 1 and self._shapes[1].at_s < until_s:
            self._shapes.pop(0)

    def _moves(self, part: str) -> bool:
        """Whether a motion model moves this part of the body."""
        return self._player is not None and (part == "hands" or part in self._player.joints)

    def _frames(self) -> tuple[BodyFrame, ...]:
        self._ask()
        frames = () if self._body is None else self._body.frames_until(self.heard_s, self._shapes)
        return frames if self._player is None else tuple(self._by_units(each, self._player) for each in frames)

    def _by_units(self, frame: BodyFrame, player: UnitPlayer) -> BodyFrame:
        """The frame with the joints that the motion model moves."""
        at, rotations = self._models.understudy.realizer.skeleton.chain(*player.joints), frame.rotations.copy()
        rotations[at] = player.pose(rotations[at], frame.at_s)
        return replace(frame, rotations=rotations)

    def _ask(self) -> None:
        if self._body is not None:
            visemes = tuple(viseme for phrase in self._phrases for viseme in phrase.visemes)
            self._body.ask(BodyRequest(self._agenda.behaviors, visemes))


def _body(models: LiveModels, options: LiveOptions) -> LiveBody | None:
    if options.frame_rate_hz is None:
        return None
    performing = LiveBodyOptions(options.character, options.seed, options.frame_rate_hz, options.stillness)
    return LiveBody(models.understudy.realizer, performing)
