"""How long jobs have taken lately, so that those who are sent away are told truly when to come again."""

_WEIGHT = 0.1
"""Of the newest job in the mean: some ten of them make it."""

_FIRST_GUESS_S = 0.5


class ServiceTimes:
    """The exponentially weighted mean of the times that jobs took, in seconds."""

    def __init__(self) -> None:
        self._mean_s: float | None = None

    @property
    def mean_s(self) -> float:
        return _FIRST_GUESS_S if self._mean_s is None else self._mean_s

    def add(self, took_s: float) -> None:
        self._mean_s = took_s if self._mean_s is None else self._mean_s + _WEIGHT * (took_s - self._mean_s)
