"""The author's folders that a command is given, for it and for the processes that it starts."""

import os
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from ..authored_folders import VARIABLE, layers_of


@contextmanager
def own_lexicon(folders: Sequence[str]) -> Iterator[None]:
    """Within the block `UNDERSTUDY_LEXICON` names these folders too, on top of its own."""
    before = os.environ.get(VARIABLE)
    if folders:
        named = (*map(str, layers_of(before)), *(str(Path(folder).absolute()) for folder in folders))
        os.environ[VARIABLE] = os.pathsep.join(named)
    try:
        yield
    finally:
        if before is None:
            os.environ.pop(VARIABLE, None)
        else:
            os.environ[VARIABLE] = before
