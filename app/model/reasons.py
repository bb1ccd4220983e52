"""Why something was chosen: named parts of a sum."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Term:
    """One reason for or against a choice: a fact about the words, the voice, a rule or the author, and its weight
    (log-odds)."""

    name: str
    weight: float
