"""Converts the arguments that several commands share to the input and the options of a performance.

`--affect` is a tone, three numbers, or a track in a CSV file; a gesture profile is a name in the lexicon, or a file
that ends in .yaml. The schemas of what few lines have are imported where they are needed: each takes a hundredth of a
second.
"""

import argparse
from pathlib import PurePath

from ...errors import InputError
from ...model import AffectTrack, Direction, GivenFunction, Level, Line, Mode, Timings
from ...model.edits import NO_EDITS, Edits
from ...model.formats import CORE_FORM, BmlForm, DialectName, TimeForm, VisemeNames
from ...model.targets import read_targets
from ...models import load_characters, load_profile, usable_profile
from ...options import Options
from ...profiles.profile import Profile
from ...schemas.options import listener_characters, listener_names
from ...schemas.requests import read_functions, read_timings, spoken_line
from ...settings import Settings
from ...text.transcript import MAX_CHARACTERS
from ..files import STANDARD, read_bytes, read_text


def performance_options(arguments: argparse.Namespace) -> Options:
    """The options among the arguments; those that the command does not have keep their defaults.

    Raises InputError and AuthoringError for values that cannot be used. The speaker's usual voice is computed from
    files and requires models: see `hearing.speaker_reference`.
    """
    given = vars(arguments)
    return Options(
        character=arguments.character,
        agitation=level_of(arguments),
        affect=optional_affect(given.get("affect")),
        seed=arguments.seed,
        choice=arguments.choice,
        mode=Mode(given.get("mode", Mode.SEMANTIC)),
        listeners=listener_names(given.get("listener", ())),
        played_by=listener_characters(given.get("listener", ())),
        form=bml_form(arguments) if "dialect" in given else CORE_FORM,
        lead_in_s=arguments.lead_in,
        stillness=given.get("stillness", 0.0),
        targets=read_targets(given.get("target", ())),
        profile=optional_profile(arguments.profile),
    )


def level_of(arguments: argparse.Namespace) -> Level | None:
    """The level of agitation that is given."""
    return Level(arguments.agitation) if arguments.agitation else None


def bml_form(arguments: argparse.Namespace) -> BmlForm:
    """The BML's form; its audio is the recording, or named after the output if there is none, or it comes from
    standard input. The lines of a batch have recordings of their own, and no output."""
    names = () if "output" not in arguments else (arguments.audio, arguments.output)
    named = [name for name in names if name not in (None, STANDARD)]
    return BmlForm(
        DialectName(arguments.dialect),
        TimeForm(arguments.timing),
        PurePath(named[0]).name if named else None,
        arguments.bmlt_audio,
        VisemeNames(arguments.visemes),
    )


LARGEST_TRACK_BYTES = 8 << 20


def optional_affect(told: str | None) -> AffectTrack | None:
    """The feeling that is given; None where the option is missing.

    Raises InputError `affect_wrong`, and as `read_bytes` does.
    """
    if told is None:
        return None
    from ...schemas.affect import read_affect, read_affect_track

    if not told.lower().endswith(".csv"):
        return read_affect(told)
    return read_affect_track(read_bytes(told, limit=LARGEST_TRACK_BYTES, field="affect"), told)


def named_profile(name: str) -> Profile:
    """The profile of that name, or in the file of that name.

    Raises InputError `unknown_profile`, and AuthoringError with every mistake in its file.
    """
    found = usable_profile(name)
    return load_profile(found, load_characters().gesture_lexemes) if isinstance(found, str) else found


def optional_profile(name: str | None) -> Profile | str | None:
    """The profile named by an option, None if it is not given; raises as `named_profile` does."""
    return None if name is None else usable_profile(name)


def read_line(arguments: argparse.Namespace, settings: Settings) -> Line:
    """The line of AUDIO, if the command hears one, `--text` or `--text-file`, `--words`, `--functions` and
    `--direction`.

    Raises InputError for what cannot be read.
    """
    parts = ("audio", "text_file", "words", "functions", "direction", "edits")
    if [getattr(arguments, part) for part in parts].count(STANDARD) > 1:
        raise InputError(
            "usage", "only one of audio, text, words, functions, direction and edits can come from standard input (-)"
        )
    text = _text(arguments)
    timings = None if arguments.words is None else _timings(arguments.words, settings)
    functions = () if arguments.functions is None else _functions(arguments.functions, settings)
    direction = None if arguments.direction is None else _direction(arguments.direction, settings)
    if arguments.audio is None:
        return spoken_line(text, timings, functions, direction)
    audio = read_bytes(arguments.audio, limit=settings.max_audio_bytes, field="audio")
    return Line(audio, text, timings, functions, direction)


def edits_of(arguments: argparse.Namespace, settings: Settings) -> Edits:
    """The edits of `--edits`; raises InputError for what cannot be read."""
    if arguments.edits is None:
        return NO_EDITS
    from ...schemas.edits import read_edits

    return read_edits(read_bytes(arguments.edits, limit=settings.part_limits["edits"], field="edits"))


def _text(arguments: argparse.Namespace) -> str:
    if arguments.text is not None:
        return str(arguments.text)
    return read_text(arguments.text_file, max_characters=MAX_CHARACTERS, field="text")


def _timings(name: str, settings: Settings) -> Timings:
    return read_timings(name, read_bytes(name, limit=settings.max_body_bytes, field="words"))


def _functions(name: str, settings: Settings) -> tuple[GivenFunction, ...]:
    return read_functions(read_bytes(name, limit=settings.max_body_bytes, field="functions"))


def _direction(name: str, settings: Settings) -> Direction:
    from ...schemas.direction import read_direction

    return read_direction(read_bytes(name, limit=settings.max_body_bytes, field="direction"))
