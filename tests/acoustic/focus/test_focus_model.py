"""The shares of the focus: what they sum to, who has them, and on what words they fall."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from understudy.acoustic.focus.cues import CUES
from understudy.acoustic.focus.focus_model import INPUTS, FocusModel
from understudy.errors import ServiceError
from understudy.files import resource_folder
from understudy.model import Contours, Interval, Word

WORDS = tuple(
    Word(index, text, Interval(index * 0.3, (index + 1) * 0.3)) for index, text in enumerate(["so", "it", "is", "here"])
)
FRAMES = 130


def looks_at(column: int) -> FocusModel:
    """A network that scores each word by one of its inputs."""
    first = np.zeros((1, 1, INPUTS, 5))
    first[0, 0, column, 2] = 1.0
    second = np.zeros((1, 1, 1, 3))
    second[0, 0, 0, 1] = 1.0
    return FocusModel({}, first, np.zeros((1, 1)), second, np.zeros((1, 1)), np.ones((1, 1, 1, 1)), np.zeros((1, 1)))


def contours(loud: slice = slice(0, 0)) -> Contours:
    energy_db = np.full(FRAMES, -20.0)
    energy_db[loud] = -8.0
    return Contours(energy_db, np.full(FRAMES, 120.0), np.zeros((FRAMES, 12)), np.zeros((FRAMES, 40), np.float32))


def shares(words: tuple[Word, ...]) -> list[float]:
    return [-1 if word.focus is None else word.focus for word in words]


def test_the_shares_of_a_line_sum_to_one_and_a_level_line_has_them_spread() -> None:
    assert shares(looks_at(CUES.index("level")).with_focus(WORDS, contours())) == [0.25] * 4


def test_the_word_that_stands_out_has_most() -> None:
    found = shares(looks_at(CUES.index("level")).with_focus(WORDS, contours(slice(60, 90))))
    assert found.index(max(found)) == 2
    assert sum(found) == pytest.approx(1, abs=0.001)


def test_listeners_have_a_say_where_the_recording_was_heard() -> None:
    found = shares(looks_at(len(CUES)).with_focus(WORDS, contours(), {0: -2.0, 1: 1.5, 2: -2.0, 3: -2.0}))
    assert found.index(max(found)) == 1


def test_words_that_are_not_spoken_have_no_share_and_nothing_spoken_has_none() -> None:
    model = looks_at(0)
    dash = replace(WORDS[1], interval=None)
    assert shares(model.with_focus((WORDS[0], dash), contours())) == [1.0, 0.0]
    assert shares(model.with_focus((dash,), contours())) == [-1]


def test_the_shipped_model_hears_which_word_is_raised_and_louder() -> None:
    model = FocusModel.load(resource_folder("models") / "focus" / "focus.npz")
    for place, word in enumerate(WORDS):
        inside = slice(place * 30, place * 30 + 30)
        heard = contours(inside)
        heard.f0_hz[inside] *= 1 + 0.4 * np.sin(np.linspace(0, np.pi, 30))
        found = shares(model.with_focus(WORDS, heard))
        assert found.index(max(found)) == word.index


def test_a_file_that_is_no_such_model_is_refused(tmp_path: Path) -> None:
    for name, content in (("gone.npz", None), ("text.npz", b"not a model")):
        if content:
            (tmp_path / name).write_bytes(content)
        with pytest.raises(ServiceError) as caught:
            FocusModel.load(tmp_path / name)
        assert caught.value.code == "model_unreadable"
