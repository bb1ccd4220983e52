"""Three numbers stand for the tones near them."""

import pytest

from understudy.model import Tone
from understudy.model.voice.affect import PLACES, affect_of_dimensions, affect_of_tone


@pytest.mark.parametrize("tone", Tone)
def test_a_tones_own_numbers_are_most_of_all_that_tone(tone: Tone) -> None:
    affect = affect_of_dimensions(*PLACES[tone])
    assert affect.tone is tone
    assert sum(affect.tones) == pytest.approx(1)


def test_a_tone_is_itself_alone() -> None:
    affect = affect_of_tone(Tone.ANGRY)
    assert affect.share(Tone.ANGRY) == 1
    assert (affect.activation, affect.valence, affect.dominance) == PLACES[Tone.ANGRY]
