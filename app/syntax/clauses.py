"""Finds clauses: the root of each sentence, and every predicate with a clausal dependency label (paper §3.2).

Each token belongs to the clause of its nearest ancestor that heads one, so clauses are nested or disjoint in the tree.
Heads are reliable (F 93 on test sentences), exact boundaries less so (F 73): refer to the head. Spans are words of the
transcript, without punctuation.
"""

from ..model import Clause, Token
from .tree import Tree, base_label

_CLAUSAL_LABELS = frozenset({"csubj", "ccomp", "xcomp", "advcl", "acl", "parataxis", "conj"})
_PREDICATE_PARTS = frozenset({"VERB", "AUX"})
_PREDICATE_DEPENDENTS = frozenset({"cop", "nsubj", "csubj", "aux"})


def find_clauses(tree: Tree) -> tuple[Clause, ...]:
    """The clauses of an utterance in the order of their first words; a longer one before those it contains."""
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
