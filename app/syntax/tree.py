"""Dependency tree navigation: dependents and subtree spans of tokens."""

from dataclasses import dataclass

from ..model import Token


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


def base_label(label: str) -> str:
    """A dependency label without its subtype: `nsubj` of `nsubj:pass`."""
    return label.partition(":")[0]


def is_inner(token: Token) -> bool:
    """Whether the token modifies a noun from within its phrase, as "running" in "running shoes" does."""
    return base_label(token.dependency) in INNER_LABELS or token.dependency in INNER_SUBTYPES


INNER_LABELS = frozenset({"det", "amod", "nummod", "compound", "flat", "fixed", "goeswith"})
INNER_SUBTYPES = frozenset({"nmod:poss", "nmod:desc"})
