"""`understudy reference`: describes how a speaker usually sounds, from recordings, for `--reference`."""

import argparse

from ...library.hearing import AcousticModels, make_reference
from ...schemas.references import to_json
from ...settings import read_settings
from ..files import require_writable, write
from ..inputs.hearing import hear_file, require_files
from ..log import Log


def run(arguments: argparse.Namespace, log: Log) -> int:
    require_writable(arguments.output, field="output")
    settings = read_settings()
    require_files(arguments.audio, settings)
    acoustic = AcousticModels.load(settings)
    reference = make_reference(acoustic, [hear_file(acoustic, path, log) for path in arguments.audio])
    write(arguments.output, to_json(reference))
    return 0
