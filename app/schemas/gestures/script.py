"""The gesture script as JSON, which `understudy script` writes and `understudy realize` plays (docs/profiles.md).

Times are seconds on the performance's clock. Besides the gestures it has the timed words, so that it can be played
alone; lips move where the words' phones are known.
"""

from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise
from typing import Annotated, Any, Literal

from pydantic import AfterValidator, BaseModel, ConfigDict, Field, ValidationError

from ...behavior.speech import visemes
from ...errors import InputError, UndecodableError
from ...model import Agitation, Hand, Interval, Level, Notice, Parse, Performance, Phone, Utterance, Word
from ...profiles.annotation.model import PathForm, Position, Swivel
from ...profiles.annotation.spans import DEPTHS, HEIGHTS, SIDEWAYS
from ...profiles.generation.script import GestureScript, ScriptedGesture, ScriptedUnit, behaviors_of
from ...realizer.gestures.specifiers import track_of
from ..options import Seed

MOST_GESTURES = 5000
MOST_TRACKS = 20
DECIMALS = 3
LONGEST_S = 3600.0

_Time = Annotated[float, Field(ge=-LONGEST_S, le=LONGEST_S, allow_inf_nan=False)]
_Name = Annotated[str, Field(pattern=r"^[A-Za-z][A-Za-z0-9_.]*$", max_length=100)]
_Index = Annotated[int, Field(ge=0, le=10**6)]


class _ScriptForm(BaseModel):
    model_config = ConfigDict(defer_build=True, frozen=True, extra="forbid")


def _sectors(text: str) -> str:
    """Checks a place: a sector across, one in height, one away from the body, and perhaps a swivel."""
    words = text.split()
    counts = [sum(word in known for word in words) for known in (SIDEWAYS, HEIGHTS, DEPTHS)]
    swivels = sum(word in set(Swivel) for word in words)
    if counts != [1, 1, 1] or swivels > 1 or len(words) != 3 + swivels:
        raise ValueError(f"{text!r} is not a place; give one sector each of {_known()}, such as 'XC YCC ZMiddle'")
    return text


def _known() -> str:
    return "; ".join(" ".join(words) for words in (SIDEWAYS, HEIGHTS, DEPTHS))


def _track(text: str) -> str:
    """Checks an offset track, in the words of the gesture language without its keyword."""
    track_of(text)
    return text


_Position = Annotated[str, AfterValidator(_sectors)]
_Track = Annotated[str, AfterValidator(_track)]


def _position(text: str | None) -> Position | None:
    if text is None:
        return None
    words = text.split()
    across, height, depth = (next(word for word in words if word in known) for known in (SIDEWAYS, HEIGHTS, DEPTHS))
    return Position(across, height, depth, next((each for each in Swivel if each in words), Swivel.NORMAL))


class StretchForm(_ScriptForm):
    """An interval of time."""

    start_s: _Time
    end_s: _Time

    def interval(self) -> Interval:
        return Interval(self.start_s, self.end_s)


class PhoneForm(StretchForm):
    """A speech sound, as `understudy align` has it."""

    label: str
    stress: Annotated[int, Field(ge=0, le=2)] | None = None


class WordForm(_ScriptForm):
    """A word; one that is not spoken has no times."""

    text: str
    start_s: _Time | None = None
    end_s: _Time | None = None
    phones: tuple[PhoneForm, ...] = ()


class ScriptGestureForm(_ScriptForm):
    """A gesture; its first stroke is the main one."""

    id: _Name
    lexeme: _Name
    hand: Hand
    strokes: Annotated[tuple[StretchForm, ...], Field(min_length=1, max_length=50)]
    start_s: _Time
    relax_s: _Time
    end_s: _Time
    tag: str = ""
    first: _Index = 0
    last: _Index = 0
    word: _Index = 0
    held: bool = False
    emphasis_s: _Time | None = None
    amount: Annotated[float, Field(ge=0, le=1)] | None = None
    start: _Position | None = Field(default=None, alias="from")
    end: _Position | None = Field(default=None, alias="to")
    path: PathForm = PathForm.STRAIGHT
    tracks: Annotated[tuple[_Track, ...], Field(max_length=MOST_TRACKS)] = ()
    kept: bool = True
    reason: str | None = None

    def gesture(self) -> ScriptedGesture:
        """The gesture, with the places from and to which its stroke leads."""
        said = self.model_dump(exclude={"strokes", "start", "end"})
        strokes = tuple(each.interval() for each in self.strokes)
        return ScriptedGesture(strokes=strokes, start=_position(self.start), end=_position(self.end), **said)


class ScriptUnitForm(StretchForm):
    """A unit: the ids of its gestures, and the rest after it."""

    gestures: tuple[str, ...]
    rest: Literal["clasped", "at_side", "in_pockets", "folded", "behind_back", "on_hips", "open"]


class GestureScriptForm(_ScriptForm):
    """A whole script."""

    profile: _Name
    character: str = "default"
    seed: Seed = 0
    agitation: Level = Level.MEDIUM
    duration_s: Annotated[float, Field(gt=0, le=LONGEST_S)]
    words: tuple[WordForm, ...] = ()
    gestures: Annotated[tuple[ScriptGestureForm, ...], Field(max_length=MOST_GESTURES)]
    units: Annotated[tuple[ScriptUnitForm, ...], Field(max_length=MOST_GESTURES)] = ()


def script_json(script: GestureScript, utterance: Utterance, character: str) -> bytes:
    """The script with the words of its line."""
    form = {
        "profile": script.profile,
        "character": character,
        "seed": script.seed,
        "agitation": utterance.level,
        "duration_s": utterance.duration_s or 0.0,
        "words": [_word_form(word) for word in utterance.words],
        "gestures": [_gesture_form(gesture) for gesture in script.gestures],
        "units": [_unit_form(unit) for unit in script.units],
    }
    checked = GestureScriptForm.model_validate(form)
    return checked.model_dump_json(by_alias=True, exclude_none=True, indent=2).encode() + b"\n"


def read_script(content: bytes) -> Performance:
    """The behaviours of a script, as a performance of its words in which only the hands move.

    Raises UndecodableError `not_json` and InputError `script_wrong`, which reports every mistake.
    """
    try:
        form = GestureScriptForm.model_validate_json(content)
    except ValidationError as error:
        first = error.errors()[0]
        if first["type"] == "json_invalid":
            raise UndecodableError("not_json", f"the script is not JSON: {first['msg']}", field="bml") from None
        listed = "; ".join(f"{'.'.join(map(str, each['loc']))}: {each['msg']}" for each in error.errors())
        raise InputError("script_wrong", f"the gesture script: {listed}", field="bml") from None
    script = _script(form)
    words = tuple(_word(number, word) for number, word in enumerate(form.words))
    lips, notices = visemes(words, form.duration_s)
    return Performance(
        utterance=Utterance(words, Parse((), (), ()), Agitation.certain(form.agitation), duration_s=form.duration_s),
        functions=(),
        behaviors=behaviors_of(_matched(script), {}, led=True),
        character=form.character,
        seed=form.seed,
        notices=(*_moved_starts(script), *notices),
        visemes=lips,
    )


def _matched(script: GestureScript) -> GestureScript:
    """The script with each stroke that has no preparation beginning where the one before it in its unit ended (NGS
    §3.3: the start must match the previous end)."""
    begins = {gesture.id: before.end for before, gesture in _unprepared(script)}
    gestures = (replace(each, start=begins.get(each.id, each.start)) for each in script.gestures)
    return replace(script, gestures=tuple(gestures))


def _unprepared(script: GestureScript) -> Iterator[tuple[ScriptedGesture, ScriptedGesture]]:
    """Each gesture whose stroke has no preparation, after the one before it in its unit, whose end is known."""
    made = {gesture.id: gesture for gesture in script.made}
    for unit in script.units:
        for before, gesture in pairwise([made[name] for name in unit.gestures if name in made]):
            if before.end is not None and gesture.strokes[0].start_s <= gesture.start_s:
                yield before, gesture


def _moved_starts(script: GestureScript) -> Iterator[Notice]:
    for before, gesture in _unprepared(script):
        if gesture.start is not None and _differ(gesture.start, before.end):
            message = f"{gesture.id} has no preparation: its stroke begins where {before.id} ended, at {before.end}"
            yield Notice("script_start", f"{message}, not at {gesture.start}")


def _differ(one: Position, other: Position | None) -> bool:
    return other is not None and replace(one, swivel=other.swivel) != other


def _script(form: GestureScriptForm) -> GestureScript:
    known = {gesture.id for gesture in form.gestures}
    for unit in form.units:
        unknown = [name for name in unit.gestures if name not in known]
        if unknown or not unit.gestures:
            message = (
                f"the gesture script: a unit has {', '.join(unknown) or 'no gesture'}; name gestures of the script"
            )
            raise InputError("script_wrong", message, field="bml")
    units = (ScriptedUnit(each.gestures, each.start_s, each.end_s, each.rest) for each in form.units)
    return GestureScript(form.profile, form.seed, tuple(each.gesture() for each in form.gestures), tuple(units))


def _word(number: int, form: WordForm) -> Word:
    phones = tuple(Phone(each.label, each.interval(), each.stress) for each in form.phones)
    timed = form.start_s is not None and form.end_s is not None
    return Word(number, form.text, Interval(form.start_s or 0.0, form.end_s or 0.0) if timed else None, phones)


def _word_form(word: Word) -> dict[str, Any]:
    times = _stretch(word.interval.start_s, word.interval.end_s) if word.interval else {}
    phones = [
        {"label": phone.label, "stress": phone.stress, **_stretch(phone.interval.start_s, phone.interval.end_s)}
        for phone in word.phones
    ]
    return {"text": word.text, "phones": phones, **times}


def _gesture_form(gesture: ScriptedGesture) -> dict[str, Any]:
    times = {
        name: None if (time_s := getattr(gesture, name)) is None else round(time_s, DECIMALS)
        for name in ("start_s", "relax_s", "end_s", "emphasis_s", "amount")
    }
    names = ("id", "lexeme", "hand", "tag", "first", "last", "word", "held", "path", "tracks", "kept", "reason")
    return {
        **{name: getattr(gesture, name) for name in names},
        **times,
        "strokes": [_stretch(stroke.start_s, stroke.end_s) for stroke in gesture.strokes],
        "from": str(gesture.start) if gesture.start else None,
        "to": str(gesture.end) if gesture.end else None,
    }


def _unit_form(unit: ScriptedUnit) -> dict[str, Any]:
    return {**_stretch(unit.start_s, unit.end_s), "gestures": unit.gestures, "rest": unit.rest}


def _stretch(start_s: float, end_s: float) -> dict[str, Any]:
    return {"start_s": round(start_s, DECIMALS), "end_s": round(end_s, DECIMALS)}
