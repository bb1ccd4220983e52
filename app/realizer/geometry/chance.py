"""Generators of what chance decides in a motion, by seeds.

A line draws from some twenty generators, most of which other lines, or the same line a moment ago, have drawn from as
well: the usual seed, a gesture that is asked about again. Nearly all that NumPy takes to make one is turning its seed
into a state, so the last states are kept. What is drawn is the same.
"""

from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray


def generator_of(*seed: int) -> np.random.Generator:
    """`np.random.default_rng(seed)`, at the beginning of its numbers; others are not to be spawned from it."""
    return np.random.Generator(np.random.PCG64(_state_of(seed)))


class _KnownState(np.random.SeedSequence):
    """A seed that knows the words for which `PCG64` asks it."""

    def __init__(self, seed: int | tuple[int, ...]) -> None:
        super().__init__(seed)
        self._words = super().generate_state(4, np.uint64)

    def generate_state(
        self,
        n_words: int,
        dtype: Any = np.uint32,  # noqa: ANN401 - numpy's signature
    ) -> NDArray[np.uint32 | np.uint64]:
        if n_words == len(self._words) and dtype is np.uint64:
            return self._words
        return super().generate_state(n_words, dtype)


@lru_cache(maxsize=1024)
def _state_of(seed: tuple[int, ...]) -> _KnownState:
    """Cached; never mutated."""
    return _KnownState(seed if len(seed) > 1 else seed[0])
