"""Viterbi decoding of a complete recording (RTS §2.3, AHG §3.6)."""

from math import isfinite

from ..errors import InputError
from ..model import FloatArray
from .semi_markov import Segment, SemiMarkovModel
from .trellis import EVERYTHING, Search, Trellis


def decode(model: SemiMarkovModel, log_likelihoods: FloatArray, search: Search = EVERYTHING) -> tuple[Segment, ...]:
    """The most likely segments for `log_likelihoods` (frames × states); the last ends with the recording, as printed.

    With `EVERYTHING` the search is exact. Raises InputError `undecodable` if no path is possible.
    """
    if not len(log_likelihoods):
        return ()
    trellis = Trellis(model, search, capacity=len(log_likelihoods))
    for frame in log_likelihoods:
        trellis.push(frame)
    score, state = trellis.closed()
    if not isfinite(score):
        raise InputError("undecodable", f"no path of the model fits these {len(log_likelihoods)} frames")
    last = trellis.last_segment(state)
    return (*trellis.back_to(0, last.start, last.state), last)
