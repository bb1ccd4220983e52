"""Deciding while the recording goes on: the full decode without a bound, valid paths and the stated delay with one."""

import numpy as np
import pytest

from tests.prosody_gestures.models import drawn_likelihoods, drawn_model, three_frames_at_least
from tests.prosody_gestures.test_voice_model import score
from understudy.errors import InputError
from understudy.model import FloatArray
from understudy.prosody_gestures.live_decoder import Commitment, LiveDecoder, Piece
from understudy.prosody_gestures.semi_markov import Segment, SemiMarkovModel, similarity, states_by_frame
from understudy.prosody_gestures.trellis import EVERYTHING, Search
from understudy.prosody_gestures.voice_model import decode


def lived(
    model: SemiMarkovModel, likelihoods: FloatArray, search: Search, commitment: Commitment
) -> tuple[list[Piece], int]:
    """All pieces, and the longest that a frame waited."""
    decoder, pieces, longest = LiveDecoder(model, search, commitment), list[Piece](), 0
    for heard, frame in enumerate(likelihoods, start=1):
        pieces += decoder.push(frame)
        longest = max(longest, heard - decoder.decided)
    return [*pieces, *decoder.finish()], longest


def joined(pieces: list[Piece]) -> tuple[Segment, ...]:
    """The segments that pieces make."""
    whole: list[Segment] = []
    for piece in pieces:
        if piece.begins:
            whole.append(piece.segment)
        else:
            before = whole.pop()
            assert before.state == piece.segment.state
            assert before.end == piece.segment.start
            whole.append(Segment(before.state, before.start, before.frames + piece.segment.frames))
    return tuple(whole)


@pytest.mark.parametrize("seed", range(8))
def test_without_a_bound_it_is_the_full_decode(seed: int) -> None:
    """m = 1 and n = all; pieces leave only when no other path can win."""
    model = drawn_model(seed, states=4, longest=5)
    likelihoods = 6 * drawn_likelihoods(model, seed, frames=150)
    pieces, waited = lived(model, likelihoods, EVERYTHING, Commitment())
    assert joined(pieces) == decode(model, likelihoods)
    assert waited < 150, "some of it was shared by all survivors before the end"


@pytest.mark.parametrize("at_once", [1, 3])
@pytest.mark.parametrize("search", [EVERYTHING, Search(2, 3)])
def test_nothing_waits_longer_than_the_bound(search: Search, at_once: int) -> None:
    model = drawn_model(5, states=6, longest=12)
    likelihoods = drawn_likelihoods(model, 5, frames=200)
    pieces, waited = lived(model, likelihoods, search, Commitment(8, at_once, beam=4.0))
    path = joined(pieces)
    assert waited == 8
    assert sum(segment.frames for segment in path) == 200
    assert all(segment.frames % search.step == 1 % search.step for segment in path)
    assert np.isfinite(score(model, likelihoods, path))


def test_a_longer_delay_decides_better() -> None:
    """Of one model's paths those decided later are on the whole nearer to the full decode; unbounded they are it."""
    model = drawn_model(2, states=5, longest=10)
    likelihoods = drawn_likelihoods(model, 2, frames=600)
    full = states_by_frame(decode(model, likelihoods))
    alike = [
        similarity(states_by_frame(joined(lived(model, likelihoods, EVERYTHING, Commitment(bound, 2))[0])), full)
        for bound in (2, 10, 60)
    ]
    assert alike == sorted(alike)
    assert alike[-1] == 1.0


def test_what_is_decided_is_forgotten() -> None:
    """A long stream needs no more columns than a short one."""
    model = drawn_model(1, states=3, longest=6)
    decoder = LiveDecoder(model, EVERYTHING, Commitment(6, 2))
    sizes = set()
    for frame in drawn_likelihoods(model, 1, frames=2000):
        decoder.push(frame)
        sizes.add(decoder._trellis._columns)
    assert len(sizes) == 1


def test_silence_is_no_path() -> None:
    assert LiveDecoder(drawn_model(0, states=2, longest=3)).finish() == ()


def test_what_no_path_fits_is_refused() -> None:
    model = three_frames_at_least()
    decoder = LiveDecoder(model)
    decoder.push(drawn_likelihoods(model, 0, frames=1)[0])
    with pytest.raises(InputError, match="no path"):
        decoder.finish()
