"""Measured deliveries are kept in a file and read from it."""

from pathlib import Path

from training.acting.recordings import read_measured, write_measured
from understudy.behavior.reading.encoder import WORDS_ALONE, Delivery
from understudy.model import Affect, LineAffect, PhraseAffect

SAD = Affect(-0.4, -0.3, -0.2, (0.3, 0.0, 0.7, 0.0, 0.0, 0.0, 0.0))
SPOKEN = Delivery((0.2, 0.8), LineAffect(SAD, (PhraseAffect(0, 1, SAD),)), -0.5)


def test_deliveries_are_read_as_they_were_written(tmp_path: Path) -> None:
    path = tmp_path / "measured.json"
    write_measured([("P01-a", SPOKEN), ("P01-b", WORDS_ALONE), ("P01-a", WORDS_ALONE)], path)
    assert read_measured(path) == {"P01-a": [SPOKEN, WORDS_ALONE], "P01-b": [WORDS_ALONE]}
