"""Finds every mistake of rule files that are written well but make no sense."""

from collections.abc import Collection, Iterable

from app.errors import Mistake
from app.rules.tree import RuleFile


def check(files: Iterable[RuleFile], behaviors: Collection[str] | None) -> list[Mistake]:
    """Every mistake in `files`, in no particular order; `behaviors` may be called by choose-rules (None: any)."""
    return []
