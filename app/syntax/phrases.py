"""Finds noun phrases, verb groups and clauses by rules over the dependency tree (paper §3.2).

A noun phrase is a nominal that does not itself modify another from within its phrase, with the contiguous determiners,
adjectives, numerals, compounds and possessives before it; prepositions, copulas, conjunctions and clauses end it. A
verb group is a verb with its auxiliaries, "to", negation, the adverbs between those, and a following particle; a
copula's group is its chain of auxiliaries. An auxiliary before the subject ("do you think") belongs to its verb, and
the group then includes the subject. Spans are words of the transcript, without punctuation.

A clause is headed by the root of a sentence or a predicate with a clausal dependency label. Each token belongs to the
clause of its nearest ancestor that heads one, so clauses are nested or disjoint in the tree. Heads are reliable (F 93
on test sentences), exact boundaries less so (F 73): refer to the head. Spans are words of the transcript, without
punctuation.
"""

from collections.abc import Iterator
from dataclasses import dataclass

from ..model import Clause, Phrase, Token

NOUN = "noun"
VERB = "verb"

_NOMINAL_PARTS = frozenset({"NOUN", "PROPN", "PRON"})
_NOMINAL_LABELS = frozenset({"nsubj", "obj", "iobj", "obl", "nmod", "expl", "appos", "vocative", "dislocated"})
_PARTS_USED_AS_NOMINALS = frozenset({"NUM", "DET", "ADJ", "SYM"})
_NAME_LABELS = frozenset({"flat", "goeswith", "fixed"})
_AUXILIARY_LABELS = frozenset({"aux", "cop"})


@dataclass(frozen=True, slots=True)
class Tree:
    """The tokens of an utterance, all sentences together, and the dependents of each, in order."""

    tokens: tuple[Token, ...]
    dependents: tuple[tuple[Token, ...], ...]

    @classmethod
    def of(cls, tokens: tuple[Token, ...]) -> "Tree":
        dependents: list[list[Token]] = [[] for _ in tokens]
        for token in tokens:
            if token.head != token.index:
                dependents[token.head].append(token)
        return cls(tokens, tuple(tuple(group) for group in dependents))

    def dependents_of(self, token: Token) -> tuple[Token, ...]:
        """The direct dependents of `token`, from left to right."""
        return self.dependents[token.index]

    def edges_of(self, token: Token) -> tuple[int, int]:
        """The first and last token of the subtree of `token`, itself included."""
        reached = [token]
        for governor in reached:
            reached.extend(self.dependents_of(governor))
        indices = [one.index for one in reached]
        return min(indices), max(indices)


def find_phrases(tree: Tree) -> tuple[Phrase, ...]:
    """The noun phrases and verb groups of an utterance in the order of their first words."""
    phrases = (*_noun_phrases(tree), *_verb_groups(tree))
    return tuple(sorted(phrases, key=lambda phrase: (phrase.first, phrase.last, phrase.kind)))


def _noun_phrases(tree: Tree) -> Iterator[Phrase]:
    for token in tree.tokens:
        if _is_nominal(token) and not is_inner(token):
            yield _phrase(tree, NOUN, first=_left_edge(tree, token), last=_right_edge(tree, token), head=token)


def _is_nominal(token: Token) -> bool:
    if token.part_of_speech in _NOMINAL_PARTS:
        return True
    return token.part_of_speech in _PARTS_USED_AS_NOMINALS and base_label(token.dependency) in _NOMINAL_LABELS


def _left_edge(tree: Tree, head: Token) -> int:
    """The first token of the contiguous modifiers before a nominal; a single comma between them is skipped."""
    edge = reached = head.index
    for dependent in reversed(tree.dependents_of(head)):
        first, last = tree.edges_of(dependent)
        if dependent.index > head.index:
            continue
        if last != reached - 1 or not (is_inner(dependent) or dependent.part_of_speech == "PUNCT"):
            break
        reached = first
        if dependent.part_of_speech != "PUNCT":
            edge = first
    return edge


def _right_edge(tree: Tree, head: Token) -> int:
    """The last token of a name that continues after its head: "John" in "John Smith"."""
    edge = head.index
    for dependent in tree.dependents_of(head):
        first, last = tree.edges_of(dependent)
        if first == edge + 1 and base_label(dependent.dependency) in _NAME_LABELS:
            edge = last
    return edge


def _verb_groups(tree: Tree) -> Iterator[Phrase]:
    for token in tree.tokens:
        dependents = tree.dependents_of(token)
        copulas = [dependent for dependent in dependents if dependent.dependency == "cop"]
        if _heads_verb_group(token):
            yield _verb_group(tree, token, dependents)
        elif copulas:
            yield _verb_group(tree, copulas[-1], dependents)


def _heads_verb_group(token: Token) -> bool:
    if token.part_of_speech == "VERB":
        return not is_inner(token)
    return token.part_of_speech == "AUX" and base_label(token.dependency) not in _AUXILIARY_LABELS


def _verb_group(tree: Tree, verb: Token, dependents: tuple[Token, ...]) -> Phrase:
    """The span from the first auxiliary, "to" or negation before the verb to its particle or negation after it."""
    first = last = verb.index
    for dependent in reversed(dependents):
        is_bound = dependent.index == first - 1 and _is_negation(dependent)
        if dependent.index < first and (is_bound or _is_auxiliary(dependent)):
            first = dependent.index
    for dependent in dependents:
        if dependent.index == last + 1 and _ends_group(dependent, verb):
            last = dependent.index
    return _phrase(tree, VERB, first=first, last=last, head=verb)


def _is_auxiliary(token: Token) -> bool:
    return base_label(token.dependency) in _AUXILIARY_LABELS or token.tag == "TO"


def _is_negation(token: Token) -> bool:
    return token.dependency == "advmod" and token.part_of_speech == "PART"


def _ends_group(token: Token, verb: Token) -> bool:
    """Whether the token is a particle ("give up") or the "not" of an auxiliary ("is not"); that of "guess not" stands
    for a clause."""
    return token.dependency == "compound:prt" or (verb.part_of_speech == "AUX" and _is_negation(token))


def _phrase(tree: Tree, kind: str, *, first: int, last: int, head: Token) -> Phrase:
    return Phrase(kind, tree.tokens[first].word, tree.tokens[last].word, head.word)


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


def base_label(label: str) -> str:
    """A dependency label without its subtype: `nsubj` of `nsubj:pass`."""
    return label.partition(":")[0]


def is_inner(token: Token) -> bool:
    """Whether the token modifies a noun from within its phrase, as "running" in "running shoes" does."""
    return base_label(token.dependency) in INNER_LABELS or token.dependency in INNER_SUBTYPES


INNER_LABELS = frozenset({"det", "amod", "nummod", "compound", "flat", "fixed", "goeswith"})
INNER_SUBTYPES = frozenset({"nmod:poss", "nmod:desc"})
