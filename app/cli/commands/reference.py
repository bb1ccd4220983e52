"""`understudy reference`: how a speaker usually sounds, from recordings of his, for `--reference`."""

import argparse

from app.cli.files import STANDARD, require_writable, write
from app.cli.hearing import hear_file
from app.cli.log import Log
from app.performance import Ears, refer
from app.references import to_json
from app.settings import read_settings


def run(arguments: argparse.Namespace, log: Log) -> int:
    output = arguments.output or STANDARD
    require_writable(output, field="output")
    ears = Ears.load(read_settings())
    reference = refer(ears, [hear_file(ears, path, log) for path in arguments.audio])
    write(output, to_json(reference))
    return 0
