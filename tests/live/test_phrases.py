"""Where phrases begin and end."""

import numpy as np

from understudy.live.ear import BEGIN_FRAMES, PAUSE_FRAMES, PhraseEdge, Phrases


def edges(*voiced: tuple[int, bool]) -> list[PhraseEdge]:
    """Of stretches of so many frames, voiced or not."""
    f0_hz = np.concatenate([np.full(count, 120.0 if is_voiced else 0.0) for count, is_voiced in voiced])
    phrases = Phrases()
    return [edge for f0 in f0_hz for edge in phrases.hear(np.array([f0]))]


def test_a_phrase_begins_with_its_first_voice_and_ends_with_its_last() -> None:
    assert edges((50, False), (100, True), (60, False)) == [PhraseEdge(0.5, begins=True), PhraseEdge(1.5, begins=False)]


def test_a_short_pause_parts_nothing_and_a_click_is_no_voice() -> None:
    assert len(edges((20, True), (PAUSE_FRAMES - 1, False), (20, True))) == 1
    assert not edges((40, False), (BEGIN_FRAMES - 1, True), (40, False))


def test_the_next_phrase_begins_anew() -> None:
    found = edges((20, True), (PAUSE_FRAMES, False), (20, True))
    assert [edge.begins for edge in found] == [True, False, True]
