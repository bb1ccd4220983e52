"""The gesture script as JSON, which `understudy script` writes and `understudy realize` plays (docs/profiles.md).

Times are seconds on the performance's clock. Besides the gestures it has the timed words, so that it can be played
alone; lips move where the words' phones are known.
"""

from typing import Annotated, Any, Literal

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from ...behavior.speech.visemes import visemes
from ...errors import InputError, UndecodableError
from ...model import Agitation, Hand, Interval, Level, Parse, Performance, Phone, Utterance, Word
from ...profiles.annotation.model import PathForm
from ...profiles.generation.behaviors import behaviors_of
from ...profiles.generation.script import GestureScript, ScriptedGesture, ScriptedUnit
from ..options import Seed

MOST_GESTURES = 5000
DECIMALS = 3
LONGEST_S = 3600.0

_Time = Annotated[float, Field(ge=-LONGEST_S, le=LONGEST_S, allow_inf_nan=False)]
_Name = Annotated[str, Field(pattern=r"^[A-Za-z][A-Za-z0-9_.]*$", max_length=100)]
_Index = Annotated[int, Field(ge=0, le=10**6)]


class _Form(BaseModel):
    model_config = ConfigDict(frozen=True, extra="forbid")


class StretchForm(_Form):
    """An interval of time."""

    start_s: _Time
    end_s: _Time

    def interval(self) -> Interval:
        return Interval(self.start_s, self.end_s)


class PhoneForm(StretchForm):
    """A speech sound, as `understudy align` has it."""

    label: str
    stress: Annotated[int, Field(ge=0, le=2)] | None = None


class WordForm(_Form):
    """A word; one that is not spoken has no times."""

    text: str
    start_s: _Time | None = None
    end_s: _Time | None = None
    phones: tuple[PhoneForm, ...] = ()


class GestureForm(_Form):
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
    start: str | None = Field(default=None, alias="from")
    end: str | None = Field(default=None, alias="to")
    path: PathForm = PathForm.STRAIGHT
    kept: bool = True
    reason: str | None = None

    def gesture(self) -> ScriptedGesture:
        """The gesture without its places, which its amount reflects."""
        said = self.model_dump(exclude={"strokes", "start", "end"})
        return ScriptedGesture(strokes=tuple(each.interval() for each in self.strokes), **said)


class UnitForm(StretchForm):
    """A unit: the ids of its gestures, and the rest after it."""

    gestures: tuple[str, ...]
    rest: Literal["clasped", "at_side", "in_pockets", "folded", "behind_back", "on_hips", "open"]


class GestureScriptForm(_Form):
    """A whole script."""

    profile: _Name
    character: str = "default"
    seed: Seed = 0
    agitation: Level = Level.MEDIUM
    duration_s: Annotated[float, Field(gt=0, le=LONGEST_S)]
    words: tuple[WordForm, ...] = ()
    gestures: Annotated[tuple[GestureForm, ...], Field(max_length=MOST_GESTURES)]
    units: Annotated[tuple[UnitForm, ...], Field(max_length=MOST_GESTURES)] = ()


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
            raise UndecodableError("not_json", f"the script is no JSON: {first['msg']}", field="bml") from None
        told = "; ".join(f"{'.'.join(map(str, each['loc']))}: {each['msg']}" for each in error.errors())
        raise InputError("script_wrong", f"the gesture script: {told}", field="bml") from None
    script = _script(form)
    words = tuple(_word(number, word) for number, word in enumerate(form.words))
    lips, notices = visemes(words, form.duration_s)
    return Performance(
        utterance=Utterance(words, Parse((), (), ()), _certain(form.agitation), duration_s=form.duration_s),
        functions=(),
        behaviors=behaviors_of(script, {}),
        character=form.character,
        seed=form.seed,
        notices=notices,
        visemes=lips,
    )


def _certain(level: Level) -> Agitation:
    return Agitation(**{each.value: float(each is level) for each in Level})


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
    names = ("id", "lexeme", "hand", "tag", "first", "last", "word", "held", "path", "kept", "reason")
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
