"""The one adapter from spaCy's documents to our records: a `Doc` in, `Token`s with Universal Dependencies labels out.

The labels of the token's governor are read as they are from a pipeline with Universal Dependencies labels; those of a
ClearNLP pipeline, spaCy's own for English, are translated, tree and all (`understudy.syntax.clearnlp`).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from enum import StrEnum
from typing import TYPE_CHECKING

from ..model import Token
from .clearnlp import to_universal

if TYPE_CHECKING:
    from spacy.tokens import Doc

ROOT = "root"


class Scheme(StrEnum):
    """Which dependency labels a pipeline gives."""

    UNIVERSAL = "universal"
    CLEARNLP = "clearnlp"


def scheme_of(labels: Iterable[str]) -> Scheme | None:
    """The scheme a parser's labels belong to, told by how it names objects; None when it names them in no known way."""
    known = frozenset(labels)
    if {"dobj", "pobj"} & known:
        return Scheme.CLEARNLP
    if {"obj", "obl"} & known:
        return Scheme.UNIVERSAL
    return None


def read_tokens(document: Doc, words: Sequence[int], scheme: Scheme) -> tuple[Token, ...]:
    """The tokens of a parsed document; `words` gives the transcript word of each.

    A token without dependency, as none of a whole pipeline is, counts as a root.
    """
    tokens = tuple(
        Token(
            index=token.i,
            word=word,
            text=token.text,
            lemma=token.lemma_,
            part_of_speech=token.pos_,
            tag=token.tag_,
            dependency=ROOT if token.head.i == token.i else token.dep_,
            head=token.head.i,
        )
        for token, word in zip(document, words, strict=True)
    )
    return to_universal(tokens) if scheme is Scheme.CLEARNLP else tokens
