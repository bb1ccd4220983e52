"""A body of somebody else's: a VRM 1.0 and a VRM 0 file, whose bones have other names, axes and fronts, stand and move
as our own body does, and speak and blink by their expressions."""

from base64 import b64encode
from pathlib import Path
from typing import Literal

import numpy as np
import pytest
from playwright.sync_api import Page

from tests.studio.support.vrm_files import vrm_of_the_mannequin
from tests.studio.support.waiting import wait_until
from understudy.realizer.mannequin.face import FACE_SHAPES

FACE = """
async ([base64, visemes, shapes]) => {
  const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
  const { Bodies } = await import(new URL("studio/stage/bodies.js", document.baseURI));
  const { showOnVrm } = await import(new URL("studio/stage/vrm_face.js", document.baseURI));
  const { root, vrm } = await new Bodies(null).avatar(new File([bytes], "body.vrm"));
  showOnVrm(vrm, { visemes: new Map(Object.entries(visemes)), shapes: new Map(Object.entries(shapes)) }, 0);
  const found = [];
  root.getObjectByName("Face").traverse(({ morphTargetInfluences }) => found.push(morphTargetInfluences ?? []));
  return found.filter(({ length }) => length > 0);
}
"""


def _wrists(page: Page) -> list[float]:
    return [float(metres) for metres in (page.get_attribute("#stage-canvas", "data-pose") or "").split()]


def _poses(page: Page) -> list[list[float]]:
    """Where the wrists are at a few times of the line."""
    poses = []
    page.focus("#stage-canvas")
    page.keyboard.press("Home")
    for step in range(1, 5):
        page.keyboard.press("Shift+ArrowRight")
        wait_until(page, f"Number(document.querySelector('#stage-canvas').dataset.time) === {0.5 * step}")
        poses.append(_wrists(page))
    return poses


@pytest.mark.parametrize("version", [1, 0])
def test_a_vrm_moves_as_our_body_does(opened: Page, tmp_path: Path, version: Literal[0, 1]) -> None:
    ours = _poses(opened)
    file = tmp_path / f"body{version}.vrm"
    file.write_bytes(vrm_of_the_mannequin(version))
    casts = opened.get_attribute("#stage-canvas", "data-casts")
    opened.set_input_files("#files", file)
    wait_until(opened, f"document.querySelector('#stage-canvas').dataset.casts > {casts}")
    theirs = _poses(opened)
    assert opened.is_hidden("#problem")
    assert np.ptp(ours, axis=0).max() > 0.1, "the line has a gesture"
    np.testing.assert_allclose(theirs, ours, atol=0.005)


@pytest.mark.parametrize("version", [1, 0])
def test_its_expressions_are_visemes_and_lids(page: Page, version: Literal[0, 1]) -> None:
    page.goto("/")
    shown = [{"aa": 0.75, "PP": 0.2}, {"eyeBlinkRight": 0.5}]
    primitives = page.evaluate(FACE, [b64encode(vrm_of_the_mannequin(version)).decode(), *shown])
    assert primitives
    for weights in primitives:
        of_shapes = dict(zip(FACE_SHAPES, weights, strict=True))
        assert {name: weight for name, weight in of_shapes.items() if weight} == {
            "viseme_aa": 0.75,
            "eyeBlinkRight": 0.5,
        }
