"""What holds for every form of a motion: one frame is enough, the same motion gives the same bytes."""

from collections.abc import Callable
from pathlib import Path

import pytest

from tests.support.motion.hand_made_motion import BODY, still, waving
from understudy.realizer.body.motion import Motion
from understudy.realizer.exporting.bvh import to_bvh
from understudy.realizer.exporting.clip_json import to_clip_json
from understudy.realizer.exporting.face_lists import to_arkit_csv
from understudy.realizer.exporting.glb import to_glb
from understudy.realizer.exporting.retargeting import load_rigs
from understudy.realizer.exporting.vrma import to_vrma

RIGS = load_rigs(Path(__file__).parents[3] / "lexicon" / "retarget", BODY)
EXPORTS: dict[str, Callable[[Motion], bytes]] = {
    "bvh": lambda motion: to_bvh(motion, BODY, RIGS["mixamo"]),
    "glb": lambda motion: to_glb(motion, BODY),
    "vrma": lambda motion: to_vrma(motion, BODY),
    "json": lambda motion: to_clip_json(motion, BODY, RIGS["vrm"]),
    "csv": lambda motion: to_arkit_csv(motion, BODY),
}


@pytest.mark.parametrize("form", EXPORTS)
def test_a_single_frame_can_be_written(form: str) -> None:
    assert len(EXPORTS[form](still(1))) > 500


@pytest.mark.parametrize("form", EXPORTS)
def test_the_same_motion_gives_the_same_bytes_and_is_left_as_it_was(form: str) -> None:
    motion, untouched = waving(0.5), waving(0.5)
    first = EXPORTS[form](motion)
    assert EXPORTS[form](motion) == first == EXPORTS[form](untouched)
    assert (motion.body.rotations == untouched.body.rotations).all()
    assert (motion.shapes == untouched.shapes).all()


@pytest.mark.parametrize("form", EXPORTS)
def test_nothing_of_the_machine_or_the_hour_is_written(form: str) -> None:
    content = EXPORTS[form](waving(0.2))
    assert b"/tmp" not in content
    assert b"\r" not in content or form in {"glb", "vrma"}
