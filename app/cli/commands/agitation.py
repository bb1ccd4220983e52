"""`understudy agitation`: the speaker's agitation and feeling in each file, one JSON line a file, in order."""

import argparse

from ...library.hearing import AcousticModels
from ...schemas.responses import AgitationResponse
from ...settings import read_settings
from ..files import write_standard
from ..inputs.hearing import hear_file, require_files, require_reference, shown, speaker_reference
from ..log import Log


def run(arguments: argparse.Namespace, log: Log) -> int:
    settings = read_settings()
    require_files(arguments.audio, settings)
    require_reference(arguments.reference, settings)
    acoustic = AcousticModels.load(settings)
    reference = speaker_reference(acoustic, arguments.reference, log)
    for path in arguments.audio:
        heard = hear_file(acoustic, path, log, reference)
        write_standard(AgitationResponse.of(shown(path), heard).to_json() + b"\n")
    return 0
