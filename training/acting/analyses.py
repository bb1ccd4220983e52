"""Derives the terms of directed lines with rules and parser: `python -m training.acting.analyses OUT.pkl [--directing
FOLDER]`

The terms that `app/behavior/reading/terms.py` names, a frozenset for each word, by the line's name. There is no audio,
so there are no terms of the voice. Takes some two minutes; the file is for `training.acting.weights` and the benchmark
only.
"""

import argparse
import pickle
from collections.abc import Sequence
from pathlib import Path

from understudy.behavior.reading.terms import TermTable, terms_of
from understudy.files import resource_folder
from understudy.models import LanguageModels
from understudy.rules.stage import find_functions_in_all
from understudy.settings import Settings
from understudy.text.transcript import read_transcript

from .directed import DirectedLine, read_lines

TOGETHER = 200
"""Lines parsed at a time."""


def terms_by_line(lines: Sequence[DirectedLine]) -> dict[str, tuple[frozenset[str], ...]]:
    """The terms of each word of each line."""
    language, found = LanguageModels.load(Settings()), dict[str, tuple[frozenset[str], ...]]()
    table = TermTable.load(resource_folder("lexicon") / "acting" / "terms.yaml", language.rules.program.argument_counts)
    for first in range(0, len(lines), TOGETHER):
        batch = lines[first : first + TOGETHER]
        words = [read_transcript(" ".join(line.words), max_characters=100_000) for line in batch]
        for line, analysis in zip(batch, find_functions_in_all(language, words), strict=True):
            found[line.name] = terms_of(analysis.utterance, analysis.functions, table.of_facts(analysis.facts))
    return found


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output", type=Path)
    parser.add_argument("--directing", type=Path, default=Path("../shared/directing"))
    arguments = parser.parse_args()
    arguments.output.write_bytes(pickle.dumps(terms_by_line(read_lines(arguments.directing))))


if __name__ == "__main__":
    main()
