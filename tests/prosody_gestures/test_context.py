"""Prosody in its context."""

import numpy as np
import pytest

from tests.prosody_gestures.test_prosody import spoken
from understudy.prosody_gestures.context import LOOKAHEAD_FRAMES, WIDTH, ProsodyContext, in_context
from understudy.prosody_gestures.prosody import features, raw_frames

MADE = features(raw_frames(*spoken()))


def test_a_row_holds_its_frame_and_the_one_heard_later() -> None:
    rows = in_context(MADE)
    assert rows.shape == (len(MADE), WIDTH)
    assert (rows[:, :6] == MADE).all()
    assert (rows[:-LOOKAHEAD_FRAMES, WIDTH // 2 : WIDTH // 2 + 6] == MADE[LOOKAHEAD_FRAMES:]).all()
    assert (rows[-LOOKAHEAD_FRAMES:, WIDTH // 2 : WIDTH // 2 + 6] == MADE[-1]).all(), "as if the last went on"


def test_means_are_of_what_was_heard_lately() -> None:
    rows = in_context(MADE)
    assert rows[40, 6:9] == pytest.approx(MADE[37:41, :3].mean(axis=0))
    assert rows[40, 15:18] == pytest.approx(MADE[9:41, :3].mean(axis=0))
    assert rows[0, 6:9] == pytest.approx(MADE[0, :3] / 4), "before the beginning there is nothing"


def test_a_pause_begins_a_phrase_anew() -> None:
    voiced, silent = np.array([0, 0, 1.0, 0, 0, 0]), np.array([-4, 0, -1.0, 0, 0, 0])
    rows = in_context(np.array([voiced] * 20 + [silent] * 8 + [voiced] * 3))
    since, silence = np.expm1(rows[:, 18]), np.expm1(rows[:, 19])
    assert since[[19, 26, 27, 30]] == pytest.approx([20, 27, 0, 3])
    assert silence[[19, 20, 27, 28]] == pytest.approx([0, 1, 8, 0])


def test_few_frames_are_enough() -> None:
    assert in_context(MADE[:1]).shape == (1, WIDTH)
    assert ProsodyContext().finish() == []
