"""Dependency trees written by hand, one token a line, as spaCy's documents and as our records."""

from spacy.tokens import Doc
from spacy.vocab import Vocab

from understudy.model import Token
from understudy.syntax.tokens import Scheme, read_tokens

FORMS_OF_BE = frozenset({"is", "was", "+'s"})


def read_tree(table: str, scheme: Scheme = Scheme.UNIVERSAL) -> tuple[Token, ...]:
    """Tokens from lines "text part-of-speech tag label head"; "+" before a text joins it to the word before.

    Heads count the lines from 0; a root governs itself.
    """
    rows = [line.split() for line in table.strip().splitlines()]
    texts = [row[0] for row in rows]
    joined = [text.startswith("+") for text in texts]
    document = Doc(
        Vocab(),
        words=[text.removeprefix("+") for text in texts],
        lemmas=[
            "be" if text.lower() in {"is", "was", "+'s", "are"} else text.removeprefix("+").lower() for text in texts
        ],
        pos=[row[1] for row in rows],
        tags=[row[2] for row in rows],
        deps=[row[3] for row in rows],
        heads=[int(row[4]) for row in rows],
    )
    words = [index - sum(joined[: index + 1]) for index in range(len(rows))]
    return read_tokens(document, words, scheme)
