"""A text that is to be spoken, without its marks, and what they say."""

from dataclasses import dataclass

from ..model import PLAINLY_SPOKEN, Demand, GivenFunction, Speaking


@dataclass(frozen=True, slots=True)
class SpokenText:
    """The words alone in `text`; how they are spoken, and the functions and behaviours that tags ask for."""

    text: str
    speaking: Speaking = PLAINLY_SPOKEN
    functions: tuple[GivenFunction, ...] = ()
    demands: tuple[Demand, ...] = ()
