"""Treebanks as sentences of CoNLL-U rows, and the changes that make written sentences look like transcribed speech.

A sentence is a tuple of rows numbered from 1; `head` is the number of the governing row, 0 at the root. Features,
enhanced dependencies and comments are left out: nothing we train reads them.
"""

from dataclasses import dataclass, replace
from pathlib import Path


@dataclass(frozen=True, slots=True)
class Row:
    """One syntactic word; `space_after` is false where the next word is written against it."""

    form: str
    lemma: str
    universal_tag: str
    penn_tag: str
    head: int
    relation: str
    space_after: bool


Sentence = tuple[Row, ...]


def read_treebank(path: Path) -> list[Sentence]:
    """The sentences of a CoNLL-U file, without empty nodes and the ranges of multiword tokens."""
    blocks = path.read_text(encoding="utf-8").strip().split("\n\n")
    return [tuple(_read_row(line) for line in block.splitlines() if _is_word(line)) for block in blocks]


def lower_cased(sentence: Sentence) -> Sentence:
    """The sentence in lower case, its lemmas too, but for "I", which is the lemma however the pronoun is written."""
    return tuple(
        replace(row, form=row.form.lower(), lemma="I" if row.lemma == "I" else row.lemma.lower()) for row in sentence
    )


def without_punctuation(sentence: Sentence) -> Sentence:
    """The sentence without its PUNCT rows; what hung on one hangs on its nearest kept ancestor.

    Where the root was punctuation, the first row that lost its head becomes the root and governs the others that did.
    Empty when nothing but punctuation was there.
    """
    kept = [number for number, row in enumerate(sentence, 1) if row.universal_tag != "PUNCT"]
    position = {number: place for place, number in enumerate(kept, 1)}
    heads = [position.get(_kept_head(sentence, number), 0) for number in kept]
    root = heads.index(0) + 1 if heads else 0
    return tuple(
        _rehung(sentence[number - 1], place=place, head=head, root=root, written_against=number + 1 in position)
        for place, (number, head) in enumerate(zip(kept, heads, strict=True), 1)
    )


def _is_word(line: str) -> bool:
    return line.partition("\t")[0].isdigit()


def _read_row(line: str) -> Row:
    _, form, lemma, universal_tag, penn_tag, _, head, relation, _, miscellaneous = line.split("\t")
    space_after = "SpaceAfter=No" not in miscellaneous.split("|")
    return Row(form, lemma, universal_tag, penn_tag, int(head), relation, space_after)


def _kept_head(sentence: Sentence, number: int) -> int:
    head = sentence[number - 1].head
    while head and sentence[head - 1].universal_tag == "PUNCT":
        head = sentence[head - 1].head
    return head


def _rehung(row: Row, *, place: int, head: int, root: int, written_against: bool) -> Row:
    space_after = row.space_after or not written_against
    if place == root:
        return replace(row, head=0, relation="root", space_after=space_after)
    if head == 0:
        return replace(row, head=root, relation="parataxis", space_after=space_after)
    return replace(row, head=head, space_after=space_after)
