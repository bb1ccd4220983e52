"""The names that the paper prints for two classes of functions are ours by other names (paper, Figure 3)."""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from types import MappingProxyType

from ..language.tree import Assertion, Atom, Block, Constant, Pattern, RuleFile, RuleTree

PRINTED: Mapping[str, str] = MappingProxyType({"quantifier": "quantification", "comparative": "comparison"})
"""The class that is meant, by the name in the figure."""


def with_known_classes(files: Iterable[RuleFile], printed: Mapping[str, str]) -> list[RuleFile]:
    """The files with functions of printed classes as functions of the classes that are meant."""
    return [replace(file, blocks=tuple(_block(block, printed) for block in file.blocks)) for file in files]


def _block(block: Block, printed: Mapping[str, str]) -> Block:
    tree = block.tree
    if not isinstance(tree, RuleTree):
        return block
    statements = tuple(
        replace(part, fact=_atom(part.fact, printed)) if isinstance(part, Pattern) else part for part in tree.statements
    )
    conclusions = tuple(
        replace(part, facts=tuple(_atom(fact, printed) for fact in part.facts)) if isinstance(part, Assertion) else part
        for part in tree.conclusions
    )
    return replace(block, tree=replace(tree, statements=statements, conclusions=conclusions))


def _atom(atom: Atom, printed: Mapping[str, str]) -> Atom:
    kind = atom.arguments[0] if atom.name == "fcn" and atom.arguments else None
    if isinstance(kind, Constant) and kind.value in printed:
        return replace(atom, arguments=(replace(kind, value=printed[str(kind.value)]), *atom.arguments[1:]))
    return atom
