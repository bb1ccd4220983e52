"""Converts spaCy documents to `Token`s with Universal Dependencies labels.

Labels of a Universal Dependencies pipeline are taken as they are; those of a ClearNLP pipeline, as in spaCy's English
models, are converted with the tree (`understudy.syntax.clearnlp`).
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
    """The dependency scheme of a pipeline."""

    UNIVERSAL = "universal"
    CLEARNLP = "clearnlp"


def scheme_of(labels: Iterable[str]) -> Scheme | None:
    """The scheme of a parser's labels, identified by its label for objects; None if unknown."""
    known = frozenset(labels)
    if {"dobj", "pobj"} & known:
        return Scheme.CLEARNLP
    if {"obj", "obl"} & known:
        return Scheme.UNIVERSAL
    return None


def read_tokens(document: Doc, words: Sequence[int], scheme: Scheme) -> tuple[Token, ...]:
    """The tokens of a parsed document; `words` is the index of each token's transcript word.

    A token without a dependency, which complete pipelines do not produce, counts as a root.
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
