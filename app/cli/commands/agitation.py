"""`understudy agitation`: the speaker's agitation in each file, one JSON line a file, in order."""

import argparse

from app.answers import AgitationAnswer
from app.cli.files import write_standard
from app.cli.hearing import hear_file, shown, speaker_reference
from app.cli.log import Log
from app.performance import Ears
from app.settings import read_settings


def run(arguments: argparse.Namespace, log: Log) -> int:
    ears = Ears.load(read_settings())
    reference = speaker_reference(ears, arguments.reference, log)
    for path in arguments.audio:
        heard = hear_file(ears, path, log, reference)
        write_standard(AgitationAnswer.of(shown(path), heard.agitation).to_json() + b"\n")
    return 0
