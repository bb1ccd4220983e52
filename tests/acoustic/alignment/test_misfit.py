"""The effect of each piece of evidence on the misfit of a text."""

import pytest

from understudy.acoustic.alignment.decoder_process import DecodedPhone
from understudy.acoustic.alignment.misfit import EVIDENCE, WEIGHTS, evidence, misfit


def phones(*scored: tuple[int, float]) -> list[DecodedPhone]:
    """Phones of so many frames, with a score per frame."""
    return [DecodedPhone("AH", 0, frames, round(frames * score)) for frames, score in scored]


SPOKEN = phones(*[(6, -10.0), (10, -20.0), (8, -15.0), (12, -12.0)] * 5)


def test_the_evidence_is_what_it_is_called() -> None:
    found = dict(zip(EVIDENCE, evidence(phones((10, -10.0), (30, -50.0))), strict=True))
    assert found["mean score of frames"] == pytest.approx(-40.0)
    assert found["share of phones that fit poorly"] == 0.5
    assert found["score of the quarter of the phones that fits worst"] == pytest.approx(-40.0)
    assert evidence(phones((3, -10.0)))[5] == 1.0
    assert len(WEIGHTS) == len(EVIDENCE)


def test_plain_speech_fits() -> None:
    assert misfit(SPOKEN) < -3


@pytest.mark.parametrize(
    "worse",
    [
        phones(*[(6, -50.0), (10, -60.0), (8, -55.0), (12, -52.0)] * 5),
        phones(*[(3, -10.0), (40, -20.0), (3, -15.0), (60, -12.0)] * 5),
    ],
    ids=["sounds that do not fit", "squeezed and stretched"],
)
def test_what_speaks_against_a_text(worse: list[DecodedPhone]) -> None:
    assert misfit(worse) > misfit(SPOKEN) + 2
