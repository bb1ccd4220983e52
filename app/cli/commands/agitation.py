"""`understudy agitation`: the speaker's agitation in each file, one JSON line a file, in order."""

import argparse

from ...performance import AcousticModels
from ...schemas.responses import AgitationResponse
from ...settings import read_settings
from ..files import write_standard
from ..hearing import hear_file, shown, speaker_reference
from ..log import Log


def run(arguments: argparse.Namespace, log: Log) -> int:
    acoustic = AcousticModels.load(read_settings())
    reference = speaker_reference(acoustic, arguments.reference, log)
    for path in arguments.audio:
        heard = hear_file(acoustic, path, log, reference)
        write_standard(AgitationResponse.of(shown(path), heard.agitation).to_json() + b"\n")
    return 0
