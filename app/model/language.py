"""The syntactic structure of a line (paper §3.2), and the utterance: all that is known before functions are derived."""

from dataclasses import dataclass

from .voice.affect import LineAffect, Manner
from .voice.speech import Agitation, Filler, Level, StressThresholds, Word


@dataclass(frozen=True, slots=True)
class Token:
    """A unit of the parser: a transcript word or a part of one ("do" and "n't" both have the word of "don't"). `head`
    is the index of the governing token (its own index at a root); labels are Universal Dependencies'."""

    index: int
    word: int
    text: str
    lemma: str
    part_of_speech: str
    tag: str
    dependency: str
    head: int


@dataclass(frozen=True, slots=True)
class Phrase:
    """A noun phrase or verb group: words `first` to `last`, `head` the word that governs it."""

    kind: str
    first: int
    last: int
    head: int


@dataclass(frozen=True, slots=True)
class Clause:
    """A clause: words `first` to `last`, `head` its predicate, `label` its relation to its parent."""

    label: str
    first: int
    last: int
    head: int


@dataclass(frozen=True, slots=True)
class Parse:
    """The syntactic structure of an utterance (paper §3.2), phrases and clauses in order of `first`."""

    tokens: tuple[Token, ...]
    phrases: tuple[Phrase, ...]
    clauses: tuple[Clause, ...]


@dataclass(frozen=True, slots=True)
class Utterance:
    """All that is known of a line before functions are derived; `agitation` and `affect` are None without audio.
    `manners` has for each word how the voice has a movement on it made; none without audio. `fillers` are in order of
    time, each between two words or at an end of the line.

    Where a performance begins `lead_in_s` before the recording, all times are on its clock and `duration_s` includes
    both.
    """

    words: tuple[Word, ...]
    parse: Parse
    agitation: Agitation | None = None
    thresholds: StressThresholds | None = None
    duration_s: float | None = None
    fillers: tuple[Filler, ...] = ()
    lead_in_s: float = 0.0
    affect: LineAffect | None = None
    manners: tuple[Manner, ...] = ()

    @property
    def level(self) -> Level:
        """The level of agitation; medium where none was measured."""
        return self.agitation.level if self.agitation else Level.MEDIUM
