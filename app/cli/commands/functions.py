"""`understudy functions`: communicative functions of words alone; without `--text`, line by line, with exit code 2 if
one was wrong."""

import argparse
import gc
import sys
from io import BufferedIOBase
from typing import cast

from ...loading import uncollected
from ...settings import read_settings
from ...text.transcript import read_transcript
from ..files import write_standard
from ..log import Log


def run(arguments: argparse.Namespace, _log: Log) -> int:
    settings = read_settings()
    if arguments.text is not None:
        read_transcript(arguments.text)  # before models are loaded
    from ...library.language import find_functions
    from ...models import LanguageModels

    with uncollected():
        language = LanguageModels.load(settings)
    if arguments.text is not None:
        from ...schemas.responses import FunctionsResponse

        write_standard(FunctionsResponse.of(find_functions(language, arguments.text)).to_json() + b"\n")
        return 0
    from ..inputs.function_lines import answer_lines

    gc.freeze()  # what is loaded stays; collecting garbage in it takes a tenth of the time
    answer_lines(language, cast(BufferedIOBase, sys.stdin.buffer))
    return 0
