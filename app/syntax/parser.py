"""Parses lines with a spaCy pipeline, our own or another, into our own data classes (paper §3.2).

The paper used Charniak's constituent parser and notes its problems with spoken language. We use a dependency parser
trained on speech (training/parser), and derive noun phrases, verb groups and clauses from the dependencies. spaCy is
imported with the first pipeline, to save memory and time where nothing is parsed (60 MB, half a second).

The parser is told where sentences begin, since parsers find that badly in unpunctuated speech (F about 40): at
punctuation or, in a line without any, after long pauses. In a punctuated line a pause is a hesitation and ends nothing.

Pipelines are loaded in less than half of the time that spaCy takes, because four things are left out that no pipeline
needs to parse. `import spacy` brings its command line with it, and with that five HTTP, terminal and template
libraries, a third of the time: here an empty module replaces it until the import is over, after which `spacy.cli` can
be imported as usual. A tokenizer is first made with all the exceptions of its language, which are then replaced by
those of the pipeline's folder: here it begins with none. spaCy's registries search all installed entry points a
hundred times: here they look them up. And its configurations may have schemas of pydantic's first version, if that can
be imported: here it cannot be until spaCy is.
"""

from __future__ import annotations

import re
import sys
import threading
from bisect import bisect_right
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import accumulate, pairwise
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

from ..errors import ServiceError
from ..model import Parse, Token, Word
from ..text.transcript import with_short_runs
from .phrases import Tree, find_clauses, find_phrases
from .tokens import Scheme, read_tokens, scheme_of

if TYPE_CHECKING:
    from spacy.language import Language
    from spacy.tokenizer import Tokenizer  # type: ignore[import-not-found]

_COMMAND_LINE = ("spacy.cli", "spacy.cli.info")
_FIRST_PYDANTIC = "pydantic.v1"
_USUAL_TOKENIZER = '[nlp.tokenizer]\n@tokenizers = "spacy.Tokenizer.v1"\n'
_EMPTY_TOKENIZER = "understudy.EmptyTokenizer.v1"


def load_pipeline(where: Path | str, *, without: tuple[str, ...]) -> Language:
    """The pipeline in a folder, or installed under a name, without some of its components.

    Raises what spaCy raises: OSError, ValueError, ImportError, LookupError.
    """
    _group_entry_points()
    with _no_command_line(), _no_first_pydantic():
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


@contextmanager
def _no_first_pydantic() -> Iterator[None]:
    """Within the block `pydantic.v1` counts as not installed, unless it is imported already."""
    if _FIRST_PYDANTIC in sys.modules:
        yield
        return
    sys.modules[_FIRST_PYDANTIC] = None  # type: ignore[assignment]  # what Python's import takes for "there is none"
    try:
        yield
    finally:
        del sys.modules[_FIRST_PYDANTIC]


def _group_entry_points() -> None:
    """Groups the installed entry points for spaCy's registries, which accept such a mapping too."""
    import catalogue  # type: ignore[import-untyped]

    found = catalogue.AVAILABLE_ENTRY_POINTS
    if hasattr(found, "select"):
        catalogue.AVAILABLE_ENTRY_POINTS = {group: found.select(group=group) for group in found.groups}


def _info(*arguments: Any, **options: Any) -> object:  # noqa: ANN401  # whatever it takes
    """`spacy.info` as it is, imported when somebody calls it."""
    from spacy.cli.info import info

    return info(*arguments, **options)


if TYPE_CHECKING:
    from spacy.language import Language
    from spacy.tokens import Doc


_PROBE = "I must have seen those signals."
_UNUSED_PIPES = ("ner", "senter", "textcat", "entity_linker")


@dataclass(frozen=True, slots=True)
class Parser:
    """A loaded pipeline; thread-safe (threads take turns), and its memory does not grow with use."""

    _pipeline: Language
    _scheme: Scheme
    _turn: threading.Lock

    @classmethod
    def load(cls, where: Path | str) -> Parser:
        """Load a pipeline from a folder or by the name of an installed package; its labels are Universal Dependencies
        or ClearNLP.

        Raises ServiceError: `parser_missing` if spaCy cannot load it, `parser_labels` for other dependency labels,
        `parser_incomplete` if it does not provide parts of speech, tags, lemmas or heads.
        """
        pipeline, probe = _load_pipeline(where)
        scheme = scheme_of(pipeline.pipe_labels.get("parser", ()))
        if scheme is None:
            raise ServiceError(
                "parser_labels",
                f"the pipeline {str(where)!r} has no parser with Universal Dependencies labels (obj, obl) or ClearNLP "
                "labels (dobj, pobj); name one that has",
            )
        missing = _missing_annotations(probe)
        if missing:
            raise ServiceError(
                "parser_incomplete", f"the pipeline {str(where)!r} gives no {', no '.join(missing)}; name one that does"
            )
        return cls(pipeline, scheme, threading.Lock())

    def parse(self, words: tuple[Word, ...]) -> Parse:
        """Tokens, phrases and clauses of a line, each with the indices of its words; all empty without words.

        Runs of punctuation are shortened for the tokenizer (`understudy.text.transcript`). The result is
        deterministic, and depends on words and pauses only.
        """
        [parse] = self.parse_all([words])
        return parse

    def parse_all(self, lines: Sequence[tuple[Word, ...]]) -> tuple[Parse, ...]:
        """The same parses as line by line, but faster, since lines are processed in batches."""
        with self._turn, self._pipeline.memory_zone():
            made = [self._document(words) for words in lines]
            documents = self._pipeline.pipe((document for document, _ in made), batch_size=max(1, len(lines)))
            read = [
                read_tokens(document, numbers, self._scheme)
                for document, (_, numbers) in zip(documents, made, strict=True)
            ]
        return tuple(map(_with_structure, read))

    def _document(self, words: tuple[Word, ...]) -> tuple[Doc, list[int]]:
        """The words as a spaCy document with tokens and sentence starts, and the transcript word of each token."""
        texts = [with_short_runs(word.text) for word in words]
        document = self._pipeline.make_doc(" ".join(texts))
        numbers = _word_numbers(document, texts, words)
        _begin_sentences(document, numbers, sentence_starts(words))
        return document, numbers


def _with_structure(tokens: tuple[Token, ...]) -> Parse:
    tree = Tree.of(tokens)
    return Parse(tokens, find_phrases(tree), find_clauses(tree))


def _load_pipeline(where: Path | str) -> tuple[Language, Doc]:
    """The pipeline, and its parse of a test sentence, since some defects show only there."""
    try:
        pipeline = load_pipeline(where, without=_UNUSED_PIPES)
        return pipeline, pipeline(_PROBE)
    except (OSError, ValueError, ImportError, LookupError) as error:
        reason = str(error).splitlines()[0] if str(error) else type(error).__name__
        raise ServiceError(
            "parser_missing", f"no spaCy pipeline can be loaded from {str(where)!r} ({reason}); give its folder or name"
        ) from error


def _missing_annotations(document: Doc) -> tuple[str, ...]:
    needed = {"parts of speech": "POS", "tags": "TAG", "lemmas": "LEMMA", "heads": "HEAD"}
    return tuple(name for name, annotation in needed.items() if not document.has_annotation(annotation))


def _word_numbers(document: Doc, texts: list[str], words: tuple[Word, ...]) -> list[int]:
    """The index of the transcript word of each token, by the token's offset in the text."""
    begins = list(accumulate((len(text) + 1 for text in texts[:-1]), initial=0))
    return [words[bisect_right(begins, token.idx) - 1].index for token in document]


def _begin_sentences(document: Doc, numbers: list[int], starts: frozenset[int]) -> None:
    """Set the sentence starts; the parser may add others between words, but none within a word."""
    previous = None
    for token, number in zip(document, numbers, strict=True):
        if number == previous:
            token.is_sent_start = False
        elif number in starts:
            token.is_sent_start = True
        previous = number


LONG_PAUSE_S = 0.5
"""The shortest pause between two words that ends a sentence in an unpunctuated line."""

_CLOSING = "\"'”’)]*"
_ENDS = (".", "!", "?", "…")
_TRAILS_OFF = ("..", "…")
_ABBREVIATION = re.compile(r"\W*((?i:mr|mrs|ms|dr|prof|st|sr|jr|vs|lt|sgt|capt)|[A-HJ-Z]|(\w\.)+\w)\.")
_CAPITAL_FIRST = re.compile(r"[^\w]*[A-Z0-9]")


def sentence_starts(words: tuple[Word, ...]) -> frozenset[int]:
    """The indices of the words that begin a sentence; the first word always does."""
    pairs = tuple(pairwise(words))
    by_punctuation = {following.index for word, following in pairs if _ends_sentence(word.text, following.text)}
    by_pause = {following.index for word, following in pairs if _pause_s(word, following) >= LONG_PAUSE_S}
    is_punctuated = by_punctuation or any(_without_closing(word.text).endswith(_ENDS) for word in words[-1:])
    return frozenset({word.index for word in words[:1]} | (by_punctuation if is_punctuated else by_pause))


def _ends_sentence(text: str, following: str) -> bool:
    """Whether the punctuation after a word ends a sentence; an ellipsis does only before a capital."""
    last = _without_closing(text)
    if not last.endswith(_ENDS) or _ABBREVIATION.fullmatch(text):
        return False
    return not last.endswith(_TRAILS_OFF) or bool(_CAPITAL_FIRST.match(following))


def _without_closing(text: str) -> str:
    """The word without the quotation marks and brackets that close after it."""
    return text.rstrip(_CLOSING)


def _pause_s(word: Word, following: Word) -> float:
    if word.interval is None or following.interval is None:
        return 0.0
    return following.interval.start_s - word.interval.end_s
