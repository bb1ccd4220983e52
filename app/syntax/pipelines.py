"""Loads spaCy pipelines at less than half of what spaCy takes to load them.

Two things are left out that no pipeline needs to parse. `import spacy` brings its command line with it, and with that
five HTTP, terminal and template libraries, a third of the time: here an empty module stands in its place until the
import is over, after which `spacy.cli` can be imported as usual. And a tokenizer is first made with all the exceptions
of its language, which are then replaced by those of the pipeline's folder: here it begins with none.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from spacy.language import Language
    from spacy.tokenizer import Tokenizer  # type: ignore[import-not-found]

_COMMAND_LINE = ("spacy.cli", "spacy.cli.info")
_USUAL_TOKENIZER = '[nlp.tokenizer]\n@tokenizers = "spacy.Tokenizer.v1"\n'
_EMPTY_TOKENIZER = "understudy.EmptyTokenizer.v1"


def load_pipeline(where: Path | str, *, without: tuple[str, ...]) -> Language:
    """The pipeline in a folder, or installed under a name, without some of its components.

    Raises what spaCy raises: OSError, ValueError, ImportError, LookupError.
    """
    with _no_command_line():
        import spacy
    changes = {"nlp.tokenizer": _no_exceptions_yet()} if _brings_its_exceptions(Path(where)) else {}
    return spacy.load(where, exclude=without, config=changes)


def _brings_its_exceptions(folder: Path) -> bool:
    """Whether the folder's pipeline has spaCy's usual tokenizer, and the file of what it makes exceptions of."""
    config = folder / "config.cfg"
    return (folder / "tokenizer").is_file() and config.is_file() and _USUAL_TOKENIZER in config.read_text("utf-8")


def _no_exceptions_yet() -> dict[str, str]:
    """The section of a configuration that makes a tokenizer without exceptions, known to spaCy from now on."""
    from spacy.tokenizer import Tokenizer
    from spacy.util import registry

    def make() -> Callable[[Language], Tokenizer]:
        return lambda pipeline: Tokenizer(pipeline.vocab)

    registry.tokenizers.register(_EMPTY_TOKENIZER, func=make)
    return {"@tokenizers": _EMPTY_TOKENIZER}


@contextmanager
def _no_command_line() -> Iterator[None]:
    """While spaCy is imported for the first time."""
    absent = [] if "spacy" in sys.modules else [name for name in _COMMAND_LINE if name not in sys.modules]
    for name in absent:
        stand_in = ModuleType(name)
        stand_in.__dict__["info"] = _info
        sys.modules[name] = stand_in
    try:
        yield
    finally:
        for name in absent:
            del sys.modules[name]


def _info(*arguments: Any, **options: Any) -> object:  # noqa: ANN401  # whatever it takes
    """`spacy.info` as it is, imported when somebody calls it."""
    from spacy.cli.info import info

    return info(*arguments, **options)
