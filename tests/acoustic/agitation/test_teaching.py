"""A classifier taught on one's own actors: clouds of features by hand, several speakers or one."""

import numpy as np
import pytest

from understudy.acoustic.agitation.teaching import LabelledRecordings, left_out, teach
from understudy.errors import InputError


def _clouds(count: int = 48, speakers: int = 4, apart: float = 2.0) -> LabelledRecordings:
    """Three clouds, one a level, spoken by so many speakers."""
    random = np.random.default_rng(0)
    levels = np.arange(count) % 3
    features = random.normal(0, 1, (count, 12)) + (levels[:, np.newaxis] - 1) * apart
    features[0, 3] = np.nan
    names = np.array([f"speaker {(number // 3) % speakers}" for number in range(count)])
    return LabelledRecordings(features, np.eye(3)[levels], names)


def test_levels_that_lie_apart_are_told_apart_for_speakers_left_out() -> None:
    found = left_out(_clouds(24, speakers=3), "paper")
    assert (found.by, found.recordings, found.speakers) == ("speaker", 24, 3)
    assert found.balanced > 0.9
    model = teach(_clouds(), "paper")
    assert model.judge(np.full(12, 2.0)).level == "high"
    assert model.judge(np.full(12, -2.0)).level == "low"


def test_levels_that_do_not_differ_are_at_chance() -> None:
    assert left_out(_clouds(apart=0.0), "paper").balanced < 0.6


def test_of_one_speaker_recordings_are_left_out_and_that_is_told() -> None:
    found = left_out(_clouds(15, speakers=1), "paper")
    assert (found.by, found.speakers) == ("recording", 1)
    assert found.balanced > 0.8


def test_a_recording_between_levels_belongs_to_both() -> None:
    taught = _clouds()
    memberships = taught.memberships.copy()
    memberships[1::3] = (0.0, 0.5, 0.5)
    memberships[1] = (0.0, 1.0, 0.0)
    model = teach(LabelledRecordings(taught.features, memberships, taught.speakers), "paper")
    assert model.judge(np.zeros(12)).high > teach(taught, "paper").judge(np.zeros(12)).high


def test_too_few_recordings_of_a_level_are_told() -> None:
    taught = _clouds(9)
    with pytest.raises(InputError, match=r"low: 3, medium: 3, high: 3\); give 4 at least"):
        teach(taught, "paper")
