"""Directed lines as what a reader is trained towards."""

import numpy as np

from training.acting.directed import CHANNELS, FACE, FAMILIES, HEAD, OUTPUTS, DirectedLine, avoided


def test_what_a_director_forbids_is_found_at_its_words_and_nowhere_else() -> None:
    forbidden = [{"first": 1, "last": 2, "what": ["point_there", "nod", "smile", "hands"]}]
    line = DirectedLine("one", ("you", "two", "there"), {"moments": [], "avoid": forbidden})
    columns = [
        FAMILIES.index("point"),
        CHANNELS["head"].start + HEAD.index("nod"),
        CHANNELS["face"].start + FACE.index("smile"),
    ]
    expected = np.zeros((3, OUTPUTS), bool)
    expected[1:, columns] = True
    assert np.array_equal(avoided(line), expected)
