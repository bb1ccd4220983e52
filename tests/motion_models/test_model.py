"""A file of a motion model that is none, or whose arrays do not go together, is refused."""

import io

import numpy as np
import pytest

from understudy.errors import InputError
from understudy.files import resource_folder
from understudy.model import FloatArray
from understudy.motion_models.model import MotionModel


@pytest.fixture(scope="module")
def arrays() -> dict[str, FloatArray]:
    (path,) = (resource_folder("models") / "motion").glob("*.npz")
    return dict(np.load(path))


def packed(arrays: dict[str, FloatArray]) -> bytes:
    written = io.BytesIO()
    np.savez(written, **arrays)  # type: ignore[arg-type]
    return written.getvalue()


@pytest.mark.parametrize("content", [b"", b"hello", b"\x93NUMPY\x01\x00", b"PK\x03\x04", b"\x80\x04K\x01."])
def test_what_is_no_model_is_told(content: bytes) -> None:
    with pytest.raises(InputError) as caught:
        MotionModel.read(content, "a.npz")
    assert caught.value.code == "motion_model"


@pytest.mark.parametrize(
    ("name", "told"),
    [
        ("log_initial", "one row for each kind"),
        ("log_duration", "one row for each kind"),
        ("motion", "not as long as its motion"),
        ("joints", "not a rotation of each joint"),
    ],
)
def test_arrays_that_do_not_go_together_are_told(arrays: dict[str, FloatArray], name: str, told: str) -> None:
    with pytest.raises(InputError, match=told):
        MotionModel.read(packed({**arrays, name: arrays[name][:-1]}), "a.npz")


def test_numbers_that_are_none_are_told(arrays: dict[str, FloatArray]) -> None:
    with pytest.raises(InputError, match="mean has values that are not finite numbers"):
        MotionModel.read(packed({**arrays, "mean": arrays["mean"] * np.nan}), "a.npz")
    with pytest.raises(InputError, match="no kind or no frame"):
        MotionModel.read(packed({**arrays, "unit_state": arrays["unit_state"] + 1000}), "a.npz")
