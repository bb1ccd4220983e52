"""Converts spaCy documents to `Token`s with Universal Dependencies labels.

Labels of a Universal Dependencies pipeline are taken as they are; those of a ClearNLP pipeline, as in spaCy's English
models, are converted with the tree.

Converts ClearNLP dependency labels, used by spaCy's English pipelines, to Universal Dependencies.

Most labels translate one to one. Two constructions have a different structure and are reattached: in ClearNLP a
preposition governs its noun and depends on the verb, here the verb governs the noun and the noun the preposition
(`case`); in ClearNLP "be" governs the predicate, here the predicate governs "be" (`cop`).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from enum import StrEnum
from typing import TYPE_CHECKING

from ..model import Token

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


_LABELS = {
    "acomp": "xcomp",
    "attr": "xcomp",
    "auxpass": "aux:pass",
    "csubjpass": "csubj:pass",
    "dative": "iobj",
    "dobj": "obj",
    "intj": "discourse",
    "meta": "dep",
    "neg": "advmod",
    "nn": "compound",
    "npadvmod": "obl:unmarked",
    "nsubjpass": "nsubj:pass",
    "num": "nummod",
    "number": "nummod",
    "oprd": "xcomp",
    "pobj": "obl",
    "poss": "nmod:poss",
    "possessive": "case",
    "preconj": "cc:preconj",
    "predet": "det:predet",
    "prt": "compound:prt",
    "quantmod": "advmod",
    "rcmod": "acl:relcl",
    "relcl": "acl:relcl",
}
_PREPOSITION_LABELS = frozenset({"prep", "agent", "dative"})
_PREDICATE_LABELS = ("attr", "acomp")
_NOMINAL_PARTS = frozenset({"NOUN", "PROPN", "PRON", "NUM", "DET"})


def to_universal(tokens: tuple[Token, ...]) -> tuple[Token, ...]:
    """The same tokens with Universal Dependencies labels and heads."""
    rehung = list(tokens)
    for token in tokens:
        if token.dependency in _PREPOSITION_LABELS:
            _rehang_preposition(rehung, tokens, token.index)
    for token in tokens:
        if token.lemma == "be" and token.dependency not in ("aux", "auxpass"):
            _rehang_copula(rehung, token.index)
    return tuple(replace(token, dependency=_LABELS.get(token.dependency, token.dependency)) for token in rehung)


def _rehang_preposition(rehung: list[Token], tokens: tuple[Token, ...], index: int) -> None:
    """Put the object of preposition `index` in its place; without an object it becomes an adverbial of its head."""
    preposition = rehung[index]
    of_preposition = (token for token in tokens if token.head == index and token.dependency in ("pobj", "pcomp"))
    governed = next(of_preposition, None)
    if governed is None:
        if preposition.dependency != "dative":
            rehung[index] = replace(preposition, dependency="advmod")
        return
    label = _oblique_label(preposition, tokens[preposition.head], governed)
    rehung[governed.index] = replace(governed, head=preposition.head, dependency=label)
    mark = "mark" if governed.dependency == "pcomp" else "case"
    rehung[index] = replace(preposition, head=governed.index, dependency=mark)


def _oblique_label(preposition: Token, head: Token, governed: Token) -> str:
    if governed.dependency == "pcomp":
        return "acl" if head.part_of_speech in _NOMINAL_PARTS else "advcl"
    if preposition.dependency == "agent":
        return "obl:agent"
    return "nmod" if head.part_of_speech in _NOMINAL_PARTS else "obl"


def _rehang_copula(rehung: list[Token], index: int) -> None:
    """Put the predicate of "be" in its place, with all its dependents."""
    copula = rehung[index]
    of_copula = [token for token in rehung if token.head == index and token.index != index]
    predicate = next((token for token in of_copula if token.dependency in _PREDICATE_LABELS), None)
    if predicate is None:
        return
    for token in of_copula:
        rehung[token.index] = replace(token, head=predicate.index)
    is_root = copula.head == index
    rehung[predicate.index] = replace(
        predicate, head=predicate.index if is_root else copula.head, dependency=copula.dependency
    )
    rehung[index] = replace(copula, head=predicate.index, dependency="cop")
