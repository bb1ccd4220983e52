"""A pipeline that is loaded quickly is the pipeline: the same tokens, and a spaCy with all its parts."""

import json
import subprocess
import sys

import spacy

from understudy.resources import resource_folder
from understudy.syntax.pipelines import load_pipeline

PARSER = resource_folder("models") / "parser"


def _in_a_new_process(code: str) -> list[object]:
    """What the code prints, as JSON."""
    printed = subprocess.run([sys.executable, "-c", code], capture_output=True, check=True).stdout
    answer: list[object] = json.loads(printed)
    return answer


def test_the_command_line_is_left_out_and_can_be_imported_afterwards() -> None:
    code = (
        "import json, sys; from pathlib import Path; from understudy.syntax.pipelines import load_pipeline\n"
        f"load_pipeline(Path({str(PARSER)!r}), without=())\n"
        "import spacy; lean = sorted({'typer', 'requests', 'spacy.cli', 'spacy.cli.info'} & {*sys.modules})\n"
        "version = spacy.info()['spacy_version']; import spacy.cli\n"
        "print(json.dumps([lean, version == spacy.__version__, callable(spacy.cli.setup_cli)]))"
    )
    assert _in_a_new_process(code) == [[], True, True]


def test_a_spacy_that_was_imported_before_stays_as_it_is() -> None:
    code = (
        "import json, sys, spacy, spacy.cli; before = sys.modules['spacy.cli']\n"
        "from pathlib import Path; from understudy.syntax.pipelines import load_pipeline\n"
        f"load_pipeline(Path({str(PARSER)!r}), without=())\n"
        "print(json.dumps([sys.modules['spacy.cli'] is before]))"
    )
    assert _in_a_new_process(code) == [True]


def test_it_cuts_tokens_as_spacy_loads_it() -> None:
    ours, theirs = load_pipeline(PARSER, without=()), spacy.load(PARSER)
    assert ours.tokenizer.to_bytes() == theirs.tokenizer.to_bytes()  # type: ignore[union-attr]
    for text in ("I can't, e.g. in the U.S., y'all're gonna…", "(uh) well-known? :-) 5pm, don't!"):
        assert [token.text for token in ours(text)] == [token.text for token in theirs(text)]
        assert [(token.head.i, token.dep_, token.lemma_) for token in ours(text)] == [
            (token.head.i, token.dep_, token.lemma_) for token in theirs(text)
        ]
