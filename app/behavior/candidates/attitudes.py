"""The attitude of a phrase: the expression that is held while it is said, brows, lids and mouth together, and posture.

It follows the tone of the voice, with what the words suggest for a part; where the two contradict, the voice has the
face, for that is what sarcasm is. An attitude is held only where the tone is sure (`lexicon/acting/attitudes.yaml`). It
takes the place of the faces that the reading would have on its words.
"""

from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass
from math import log
from pathlib import Path
from types import MappingProxyType
from typing import Annotated

from pydantic import Field, RootModel

from ...errors import AuthoringError, did_you_mean
from ...model import (
    Affect,
    Alternative,
    BehaviorCandidates,
    Channel,
    Moment,
    Movement,
    PhraseAffect,
    Term,
    Tone,
    Utterance,
)
from ...yaml_files import Entry, Source
from ..reading.player import Player

WORDS_SHARE = 0.3
"""How much a face that the words suggest with certainty adds to the share of its tone."""

PRIORITY = 9.0
"""Beside a moment whose importance is nearly 1."""

_MOST = 0.99


@dataclass(frozen=True, slots=True)
class Attitude:
    """How a tone is shown: the behaviours, the share from which it is `surely` heard, the kind of face as which the
    words suggest it, and the valence of the voice above which it is not shown."""

    shows: tuple[str, ...]
    surely: float
    reads: str
    most_valence: float


class _AttitudeLine(Entry):
    shows: Annotated[tuple[str, ...], Field(min_length=1)]
    surely: float = Field(gt=0, le=1)
    reads: str
    most_valence: float = Field(default=1.0, ge=-1, le=1)


class _AttitudesFile(RootModel[dict[Tone, _AttitudeLine]]):
    pass


def load_attitudes(path: Path, behaviors: Collection[str], faces: Collection[str]) -> Mapping[Tone, Attitude]:
    """The attitudes in a file; raises AuthoringError for behaviours and kinds of face that do not exist."""
    source = Source(path)
    file = source.validated(_AttitudesFile).root
    mistakes = [
        source.mistake((tone, "shows"), f"no behaviour is called {name!r}{did_you_mean(name, behaviors)}")
        for tone, line in file.items()
        for name in line.shows
        if name not in behaviors
    ]
    mistakes += [
        source.mistake((tone, "reads"), f"{line.reads!r} is not a kind of face{did_you_mean(line.reads, faces)}")
        for tone, line in file.items()
        if line.reads not in faces
    ]
    if mistakes:
        raise AuthoringError(tuple(mistakes))
    return MappingProxyType(
        {tone: Attitude(each.shows, each.surely, each.reads, each.most_valence) for tone, each in file.items()}
    )


def attitude_candidates(
    attitudes: Mapping[Tone, Attitude], utterance: Utterance, moments: Collection[Moment], player: Player
) -> tuple[BehaviorCandidates, ...]:
    """The candidates for the attitudes of the line's phrases, each part a moment of its own; `moments` are the planned
    ones, whose faces say what the words suggest."""
    found = (
        _candidate(phrase, tone, name, player)
        for phrase, tone in _surely(attitudes, utterance, moments)
        for name in attitudes[tone].shows
        if not player.banned(name, phrase.first, phrase.last)
    )
    return tuple(found)


def without_faces(moments: Iterable[Moment], held: Collection[BehaviorCandidates]) -> tuple[Moment, ...]:
    """The planned moments without faces on the words over which an attitude is held; a director's are kept."""
    spans = [each.moment for each in held if each.moment and each.moment.channel is Channel.FACE]
    return tuple(
        moment
        for moment in moments
        if moment.channel is not Channel.FACE
        or moment.note is not None
        or not any(each.first <= moment.last and moment.first <= each.last for each in spans)
    )


def _surely(
    attitudes: Mapping[Tone, Attitude], utterance: Utterance, moments: Collection[Moment]
) -> Iterator[tuple[PhraseAffect, Tone]]:
    """The phrases whose tone is sure enough to be shown."""
    affect, last = utterance.affect, len(utterance.words) - 1
    if affect is None or last < 0:
        return
    for phrase in affect.phrases or (PhraseAffect(0, last, affect.line),):
        tone = _tone(phrase.affect)
        attitude = attitudes.get(tone)
        if attitude is None or phrase.affect.valence > attitude.most_valence:
            continue
        heard = phrase.affect.share(tone)
        if heard + WORDS_SHARE * _suggested(attitude, phrase, moments) >= attitude.surely:
            yield phrase, tone


def _tone(affect: Affect) -> Tone:
    """The tone with the largest share but neutral."""
    return max((tone for tone in Tone if tone is not Tone.NEUTRAL), key=affect.share)


def _suggested(attitude: Attitude, phrase: PhraseAffect, moments: Collection[Moment]) -> float:
    """How surely the words suggest the attitude's face on the phrase."""
    return max(
        (
            max(moment.shares, default=0.0)
            for moment in moments
            if moment.channel is Channel.FACE
            and attitude.reads in moment.families
            and moment.first <= phrase.last
            and phrase.first <= moment.last
        ),
        default=0.0,
    )


def _candidate(phrase: PhraseAffect, tone: Tone, name: str, player: Player) -> BehaviorCandidates:
    share = min(phrase.affect.share(tone), _MOST)
    moment = Moment(
        id=f"attitude.{tone}.{name}.{phrase.first}",
        channel=player.behaviors[name].channel,
        first=phrase.first,
        last=phrase.last,
        stroke=phrase.first,
        families=(name,),
        importance=1.0,
        terms=(Term(f"tone of the voice: {tone}", round(log(share / (1 - share)), 2)),),
    )
    movement = Movement(
        name=name,
        first=phrase.first,
        last=phrase.last,
        priority=PRIORITY,
        rule=f"attitude_{tone}",
        function=None,
        moment=moment.id,
        decided_by=moment.terms,
    )
    return BehaviorCandidates(None, (Alternative((movement,), 1.0, 1.0),), moment)
