"""Adds omitted annotations to asserted facts, as 0, so that any other rule's claim prevails."""

from collections.abc import Collection, Sequence
from dataclasses import replace

from ..language.tree import Assertion, Atom, Block, Constant, PredicateTree, RuleFile, RuleTree

OMITTED = 0


def with_annotations(files: Sequence[RuleFile]) -> tuple[RuleFile, ...]:
    """The files, with an annotation in every asserted fact of an annotated predicate."""
    annotated = {
        block.tree.name: len(block.tree.parameters)
        for file in files
        for block in file.blocks
        if isinstance(block.tree, PredicateTree) and any(parameter.merged for parameter in block.tree.parameters)
    }
    lacking = frozenset((name, length - 1) for name, length in annotated.items())
    return tuple(replace(file, blocks=tuple(_filled_block(block, lacking) for block in file.blocks)) for file in files)


def _filled_block(block: Block, lacking: Collection[tuple[str, int]]) -> Block:
    if not isinstance(block.tree, RuleTree):
        return block
    conclusions = tuple(
        replace(part, facts=tuple(_filled(atom, lacking) for atom in part.facts))
        if isinstance(part, Assertion)
        else part
        for part in block.tree.conclusions
    )
    return replace(block, tree=replace(block.tree, conclusions=conclusions))


def _filled(atom: Atom, lacking: Collection[tuple[str, int]]) -> Atom:
    if (atom.name, len(atom.arguments)) not in lacking:
        return atom
    return replace(atom, arguments=(*atom.arguments, Constant(OMITTED, atom.place)))
