"""The options of a performance, from the arguments of a command line."""

import argparse
from pathlib import PurePath

from ...model import Level, Mode
from ...model.formats.bml_form import CORE_FORM, BmlForm, DialectName, TimeForm, VisemeNames
from ...model.targets import read_targets
from ...options import Options
from ...schemas.options import listener_characters, listener_names
from ..files import STANDARD
from .affect import optional_affect
from .profiles import optional_profile


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
