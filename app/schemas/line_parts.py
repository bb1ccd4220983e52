"""The parts of a line in JSON, each converted from its value in `understudy.model`.

A key is absent if there is no value (a time without audio, the winner where no conflict was lost).
"""

from collections.abc import Sequence
from typing import Annotated, Self

import numpy as np
from pydantic import AliasPath, BeforeValidator, Field

from ..model import FRAME_SHIFT_S, PLAIN, Affect, Contours, Function, LineAffect, Tone, Word
from .response_model import Number, ResponseModel, Times


def _if_so(flag: bool) -> bool | None:
    return flag or None


class WarningResponse(ResponseModel):
    """A notice about something degraded, dropped or guessed."""

    code: str
    message: str


class PhoneResponse(ResponseModel):
    """A phone: ARPABET without stress digit; the stress is separate and known only for some input formats."""

    label: str
    start_s: Number = Field(validation_alias=AliasPath("interval", "start_s"))
    end_s: Number = Field(validation_alias=AliasPath("interval", "end_s"))
    stress: int | None = None


class WordResponse(ResponseModel):
    """A word of the transcript; one that is not spoken, such as a lone dash, has no times.

    `spread` is present, and true, if the times are estimated from loudness.
    """

    index: int
    text: str
    start_s: Number | None = Field(default=None, validation_alias=AliasPath("interval", "start_s"))
    end_s: Number | None = Field(default=None, validation_alias=AliasPath("interval", "end_s"))
    stressed_ratio: Number | None = None
    prominence: Number | None = None
    emphasis: Number | None = None
    focus: Number | None = None
    spread: Annotated[bool | None, BeforeValidator(_if_so)] = None
    phones: list[PhoneResponse]


class FocusResponse(ResponseModel):
    """A word's share of the line's narrow focus; the shares of a line sum to 1."""

    word: int = Field(validation_alias="index")
    share: Number = Field(validation_alias="focus")


class FillerResponse(ResponseModel):
    """A hesitation sound that is not a word of the transcript."""

    text: str
    start_s: Number = Field(validation_alias=AliasPath("interval", "start_s"))
    end_s: Number = Field(validation_alias=AliasPath("interval", "end_s"))


class AudioResponse(ResponseModel):
    """The recording."""

    duration_s: Number


class StressResponse(ResponseModel):
    """The utterance's stress thresholds; a frame above either is stressed."""

    energy_db: Number
    f0_hz: Number | None = None


class ContoursResponse(ResponseModel):
    """The contours of the recording every `frame_shift_s`, from its start, as `understudy pitch` writes them: f0 (0
    where the voice is silent or unvoiced) and energy."""

    frame_shift_s: Number
    f0_hz: list[float]
    energy_db: list[float]

    @classmethod
    def of(cls, contours: Contours) -> Self:
        f0_hz, energy_db = (np.round(values, 2).tolist() for values in (contours.f0_hz, contours.energy_db))
        return cls(frame_shift_s=FRAME_SHIFT_S, f0_hz=f0_hz, energy_db=energy_db)


class MembershipsResponse(ResponseModel):
    """The fuzzy memberships of the voice in the levels of agitation; they sum to 1."""

    low: Number
    medium: Number
    high: Number


class TonesResponse(ResponseModel):
    """The share of each tone of voice; they sum to 1."""

    neutral: Number
    happy: Number
    sad: Number
    angry: Number
    afraid: Number
    disgusted: Number
    surprised: Number


class AffectResponse(ResponseModel):
    """How the voice sounds: activation, valence and dominance from -1 to 1, and the shares of tones."""

    activation: Number
    valence: Number
    dominance: Number
    tones: TonesResponse

    @classmethod
    def of(cls, affect: Affect) -> Self:
        return cls.model_validate(_affect_fields(affect))


class PhraseAffectResponse(AffectResponse):
    """How the words `first` to `last` sound, between two pauses."""

    first: int
    last: int


class LineAffectResponse(AffectResponse):
    """How the line sounds, and each phrase between pauses; `given` is present, and true, if the author gave it."""

    phrases: list[PhraseAffectResponse]
    given: Annotated[bool | None, BeforeValidator(_if_so)] = None

    @classmethod
    def of_line(cls, affect: LineAffect) -> Self:
        phrases = [
            _affect_fields(phrase.affect) | {"first": phrase.first, "last": phrase.last} for phrase in affect.phrases
        ]
        return cls.model_validate(_affect_fields(affect.line) | {"phrases": phrases, "given": affect.given})


def _affect_fields(affect: Affect) -> dict[str, object]:
    dimensions = {name: getattr(affect, name) for name in ("activation", "valence", "dominance")}
    return {**dimensions, "tones": dict(zip(Tone, affect.tones, strict=True))}


class TokenResponse(ResponseModel):
    """A token of the parser: `word` is the index of its transcript word, `head` the index of its governor."""

    index: int
    word: int
    text: str
    lemma: str
    part_of_speech: str
    tag: str
    dependency: str
    head: int


class PhraseResponse(ResponseModel):
    """A noun phrase or verb group, by word indices."""

    kind: str
    first: int
    last: int
    head: int


class ClauseResponse(ResponseModel):
    """A clause, by word indices."""

    label: str
    first: int
    last: int
    head: int


class ParseResponse(ResponseModel):
    """The syntactic structure."""

    tokens: list[TokenResponse]
    phrases: list[PhraseResponse]
    clauses: list[ClauseResponse]


class BecauseResponse(ResponseModel):
    """One support of a function: a word of the transcript, or a fact with the rule that derived it."""

    word: int | None = None
    rule: str | None = None
    fact: str | None = None


class FunctionResponse(ResponseModel):
    """A communicative function of the words `first` to `last`."""

    id: str
    class_name: str = Field(serialization_alias="class")
    subtype: str
    first: int
    last: int
    text: str
    start_s: Number | None = None
    end_s: Number | None = None
    priority: Number
    rule: str
    because: list[BecauseResponse]
    kept: bool
    lost_to: str | None = None

    @classmethod
    def of(cls, function: Function, words: Sequence[Word]) -> Self:
        """`words` are those of the whole transcript, for the function's text and times."""
        spanned = words[function.first : function.last + 1]
        intervals = [word.interval for word in spanned if word.interval]
        return cls(
            id=function.id,
            class_name=function.class_name,
            subtype="" if function.subtype == PLAIN else function.subtype,
            first=function.first,
            last=function.last,
            text=" ".join(word.text for word in spanned),
            start_s=intervals[0].start_s if intervals else None,
            end_s=intervals[-1].end_s if intervals else None,
            priority=function.priority,
            rule=function.rule,
            because=[BecauseResponse.model_validate(because) for because in function.because],
            kept=function.kept,
            lost_to=function.lost_to,
        )


class TermResponse(ResponseModel):
    """A reason for a choice, and its weight in log-odds."""

    name: str
    weight: Number


class StrokeMannerResponse(ResponseModel):
    """How a movement is made, from the voice at its stroke; 1 is usual."""

    amplitude: Number
    speed: Number
    tension: Number


class SlotsResponse(ResponseModel):
    """What the words of a gesture say of size and place; sides are the performer's own, elevation is above (below, if
    negative) the level of the eyes. The `_m` are metres as said, else usual for the class."""

    height: str | None = None
    height_m: Number | None = None
    size: str | None = None
    size_m: Number | None = None
    count: int | None = None
    side: str | None = None
    distance: str | None = None
    elevation_deg: Number | None = None
    which: str | None = None
    referent: str | None = None
    listener: str | None = None


class BehaviorResponse(ResponseModel):
    """A scheduled behaviour; the times of `sync` are seconds from the start of the audio. `edit` is the number of the
    author's edit that made or changed it; the stroke of a gesture that is `curved` is an arc. `decided_by`
    are the named parts of its worth, the largest first; `limit` is what forbade one that was offered."""

    id: str
    kind: str
    lexeme: str
    hand: str | None = None
    amount: Number | None = None
    target: str | None = None
    direction: str | None = None
    repetitions: int | None = None
    sync: Times
    first: int
    last: int
    priority: Number
    rule: str | None = None
    function: str | None = None
    moment: str | None = None
    kept: bool
    lost_to: str | None = None
    reason: str | None = None
    after_strokes_s: list[Number] | None = None
    curved: bool = False
    edit: int | None = None
    decided_by: list[TermResponse] = Field(default_factory=list)
    limit: str | None = None
    manner: StrokeMannerResponse | None = None
    slots: SlotsResponse | None = None


class RejectedResponse(ResponseModel):
    """Families that a moment does not show, their expected worth, and why they lost."""

    families: list[str]
    worth: Number
    reason: str


class MomentResponse(ResponseModel):
    """Words during which hands, head or face express something: the families that would be right, the likeliest first,
    the terms that made the first one win, and what lost. `note` is the number of the director's note, `set_against` the
    word of the stroke that shows the other side of a contrast."""

    id: str
    channel: str
    first: int
    last: int
    stroke: int
    families: list[str]
    shares: list[Number]
    importance: Number
    terms: list[TermResponse]
    rejected: list[RejectedResponse]
    note: int | None = None
    set_against: int | None = None
    demanded: bool = False


class VisemeResponse(ResponseModel):
    """A viseme: `articulation` is how far its shape is reached, `opening` how wide the jaw opens."""

    label: str
    start_s: Number = Field(validation_alias=AliasPath("interval", "start_s"))
    end_s: Number = Field(validation_alias=AliasPath("interval", "end_s"))
    articulation: Number
    opening: Number
