"""The neck reaches forward, and the head stays as it is turned."""

import numpy as np
import pytest

from tests.support.motion.movements import BODY, TIMES_S, schedule
from understudy.realizer.body.movement_style import IdleLife
from understudy.realizer.body.skeleton import forward
from understudy.realizer.geometry.rotations import angle_between
from understudy.realizer.torso.idle import idle_motion
from understudy.realizer.torso.neck import with_neck_reaching

LIFE = IdleLife(neck_forward_deg=10.0)


def test_the_head_comes_forward_and_down_and_keeps_its_orientation() -> None:
    before = idle_motion(BODY, TIMES_S, schedule(), seed=1)
    after = with_neck_reaching(BODY, before, schedule(), np.zeros(len(TIMES_S)), seed=1, life=LIFE)
    head = BODY.index["head"]
    (before_m, before_turned), (after_m, after_turned) = (
        forward(BODY, each.rotations, each.hips_m) for each in (before, after)
    )
    assert angle_between(before_turned[:, head], after_turned[:, head]).max() < 1e-6
    moved_m = (after_m - before_m)[:, head]
    assert moved_m[:, 2].mean() == pytest.approx(0.1 * np.sin(np.radians(10)), abs=0.004)
    assert moved_m[:, 1].max() < 0


def test_strokes_move_it_too() -> None:
    before = idle_motion(BODY, TIMES_S, schedule(), seed=1)
    strokes = np.radians(np.where(TIMES_S > 1.0, 6.0, 0.0))
    after = with_neck_reaching(BODY, before, schedule(), strokes, seed=1, life=IdleLife())
    turned = np.degrees(angle_between(before.rotations, after.rotations)[:, BODY.index["neck"]])
    assert turned == pytest.approx(np.degrees(strokes), abs=1e-6)
