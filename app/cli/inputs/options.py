"""The options of a performance, from the arguments of a command line.

`--affect` is a tone, three numbers, or a track in a CSV file; a gesture profile is a name in the lexicon, or a file
that ends in .yaml.
"""

import argparse
from pathlib import PurePath

from ...model import AffectTrack, Level, Mode
from ...model.formats.bml_form import CORE_FORM, BmlForm, DialectName, TimeForm, VisemeNames
from ...model.targets import read_targets
from ...models import load_characters, load_profile, usable_profile
from ...options import Options
from ...profiles.profile import Profile
from ...schemas.affect import read_affect, read_affect_track
from ...schemas.options import listener_characters, listener_names
from ..files import STANDARD, read_bytes


def performance_options(arguments: argparse.Namespace) -> Options:
    """The options among the arguments; those that the command does not have keep their defaults.

    Raises InputError and AuthoringError for values that cannot be used. The speaker's usual voice is made of files, for
    which models are needed: see `hearing.speaker_reference`.
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
