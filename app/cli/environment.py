"""Settings that a command is given as options, for it and for the processes that it starts."""

import argparse
import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

from ..authored_folders import VARIABLE as LEXICON
from ..authored_folders import layers_of

AGITATION_MODEL = "UNDERSTUDY_AGITATION_MODEL"


@contextmanager
def set_by(arguments: argparse.Namespace) -> Iterator[None]:
    """Within the block the environment has what `--lexicon` and `--agitation-model` say."""
    told = dict(_told(arguments))
    before = {name: os.environ.get(name) for name in told}
    os.environ.update(told)
    try:
        yield
    finally:
        for name, value in before.items():
            if value is None:
                del os.environ[name]
            else:
                os.environ[name] = value


def _told(arguments: argparse.Namespace) -> Iterator[tuple[str, str]]:
    given: Mapping[str, object] = vars(arguments)
    folders, model = given.get("lexicon"), given.get("agitation_model")
    if isinstance(folders, list):
        named = (*layers_of(os.environ.get(LEXICON)), *map(Path, folders))
        yield LEXICON, os.pathsep.join(str(each.absolute()) for each in named)
    if isinstance(model, str):
        yield AGITATION_MODEL, str(Path(model).absolute())
