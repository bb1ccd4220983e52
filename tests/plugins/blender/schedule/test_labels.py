"""Names of behaviours that an artist reads."""

import pytest

from plugins.blender.schedule.bml_document import described
from plugins.blender.schedule.labels import label_of

BLINK = b"""<bml xmlns="http://www.bml-initiative.org/bml/bml-1.0" id="bml1">
<gaze id="gaze1" target="listener" offsetDirection="UPLEFT" start="0"/><gazeShift id="gaze2" target="door" start="1"/>
<faceFacs xmlns="http://www.bml-initiative.org/bml/coreextensions-1.0" id="eyes1" au="45" start="2.0" end="2.2"/>
<faceFacs xmlns="http://www.bml-initiative.org/bml/coreextensions-1.0" id="face1" au="12" start="2.0" end="2.2"/>
<gesture id="gesture1" lexeme="NOT_POSSIBLE" mode="BOTH_HANDS" start="2.0" end="2.2"/></bml>"""


def test_behaviours_of_bml_are_called_by_what_they_are() -> None:
    """A blink is one of the eyes, for listeners, whose BML is all that is known of them, as for speakers."""
    found = {
        each.id: label_of(each.kind, each.lexeme, hand=each.hand, target=each.target, direction=each.direction)
        for each in described(BLINK)
    }
    assert found == {
        "gaze1": "gaze: up left",
        "gaze2": "gaze: door",
        "eyes1": "eyes: blink",
        "face1": "face: smile (AU 12)",
        "gesture1": "gesture: not possible (both hands)",
    }


@pytest.mark.parametrize(
    ("lexeme", "label"), [("AU 99", "face: AU 99"), ("RAISE_BROWS", "face: raise brows"), ("AU x", "face: AU x")]
)
def test_units_that_are_not_known_keep_their_numbers(lexeme: str, label: str) -> None:
    assert label_of("face", lexeme) == label
