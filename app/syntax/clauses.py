"""Clauses: the root of a sentence, and every predicate that a clausal label joins to its governor (paper §3.2).

Each token belongs to the clause of the nearest clause head above it, so an inner clause lies within the span of the
outer one or beside it, never half over its edge in the tree. Heads are dependable (F 93 on test sentences), exact
edges are not (F 73): anchor on the head. Spans are words of the transcript; punctuation never counts.
"""

from ..model import Clause, Token
from .tree import Tree, base_label

_CLAUSAL_LABELS = frozenset({"csubj", "ccomp", "xcomp", "advcl", "acl", "parataxis", "conj"})
_PREDICATE_PARTS = frozenset({"VERB", "AUX"})
_PREDICATE_DEPENDENTS = frozenset({"cop", "nsubj", "csubj", "aux"})


def find_clauses(tree: Tree) -> tuple[Clause, ...]:
    """The clauses of an utterance, in the order of their first words; a longer one before those it holds."""
    members: dict[int, list[int]] = {}
    for token in tree.tokens:
        if token.part_of_speech != "PUNCT":
            members.setdefault(_clause_head(tree, token).index, []).append(token.word)
    clauses = (
        Clause(tree.tokens[head].dependency, min(words), max(words), tree.tokens[head].word)
        for head, words in members.items()
    )
    return tuple(sorted(clauses, key=lambda clause: (clause.first, -clause.last, clause.head)))


def _clause_head(tree: Tree, token: Token) -> Token:
    while not _heads_clause(tree, token):
        token = tree.tokens[token.head]
    return token


def _heads_clause(tree: Tree, token: Token) -> bool:
    if token.head == token.index:
        return True
    if base_label(token.dependency) not in _CLAUSAL_LABELS:
        return False
    return token.part_of_speech in _PREDICATE_PARTS or any(
        base_label(dependent.dependency) in _PREDICATE_DEPENDENTS for dependent in tree.dependents_of(token)
    )
