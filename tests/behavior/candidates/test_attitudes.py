"""The face and posture that a tone of voice holds over a phrase."""

from dataclasses import replace
from pathlib import Path

import pytest

from tests.behavior.candidates.test_demands import spoken
from understudy.behavior.candidates.attitudes import load_attitudes
from understudy.errors import AuthoringError
from understudy.model import Affect, Behavior, Channel, LineAffect, PhraseAffect, Tone
from understudy.model.voice.affect import PLACES
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform_analysis

NEUTRAL_LINE = "Kids are talking by the door."


def toned(tone: Tone, share: float) -> Affect:
    rest: dict[Tone, float] = {Tone.NEUTRAL: 1 - share, tone: share if tone is not Tone.NEUTRAL else 1.0}
    activation, valence, dominance = (share * value for value in PLACES[tone])
    return Affect(activation, valence, dominance, tuple(rest.get(each, 0.0) for each in Tone))


def faces(understudy: Understudy, text: str, affect: LineAffect) -> list[Behavior]:
    analysis = spoken(understudy, text)
    analysis = replace(analysis, utterance=replace(analysis.utterance, affect=affect))
    kept = [each for each in perform_analysis(understudy, analysis, Options()).behaviors if each.kept]
    return [each for each in kept if each.kind is Channel.FACE and each.moment]


@pytest.mark.parametrize(
    ("tone", "shown"),
    [
        (Tone.HAPPY, {"RAISE_MOUTH_CORNERS", "RAISE_CHEEKS"}),
        (Tone.ANGRY, {"LOWER_BROWS", "NARROW_EYES", "PRESS_LIPS"}),
        (Tone.SAD, {"OBLIQUE_BROWS", "LOWER_MOUTH_CORNERS"}),
        (Tone.AFRAID, {"OBLIQUE_BROWS", "WIDEN_EYES", "STRETCH_LIPS"}),
    ],
)
def test_one_expression_is_held_in_brows_lids_and_mouth(understudy: Understudy, tone: Tone, shown: set[str]) -> None:
    found = faces(understudy, NEUTRAL_LINE, LineAffect(toned(tone, 0.99)))
    assert {each.lexeme for each in found} == shown
    assert all(each.sync.end - each.sync.start > 1.5 for each in found)
    assert {part.name for each in found for part in each.decided_by} == {f"tone of the voice: {tone}"}


def test_where_the_words_contradict_the_voice_has_the_face(understudy: Understudy) -> None:
    found = faces(understudy, "I love it, thank you so much, this is wonderful!", LineAffect(toned(Tone.ANGRY, 0.9)))
    assert not {"RAISE_MOUTH_CORNERS", "RAISE_CHEEKS"} & {each.lexeme for each in found}
    assert "LOWER_BROWS" in {each.lexeme for each in found}


def test_an_unsure_tone_holds_nothing(understudy: Understudy) -> None:
    found = faces(understudy, NEUTRAL_LINE, LineAffect(toned(Tone.ANGRY, 0.3)))
    assert not [each for each in found if each.moment and each.moment.startswith("attitude")]


def test_a_sad_face_asks_for_an_unpleasant_voice_too(understudy: Understudy) -> None:
    sad = toned(Tone.SAD, 0.7)
    held, calm = (faces(understudy, NEUTRAL_LINE, LineAffect(each)) for each in (sad, replace(sad, valence=0.0)))
    assert {"OBLIQUE_BROWS", "LOWER_MOUTH_CORNERS"} <= {each.lexeme for each in held}
    assert not {"OBLIQUE_BROWS", "LOWER_MOUTH_CORNERS"} & {each.lexeme for each in calm}


def test_each_phrase_has_its_own(understudy: Understudy) -> None:
    phrases = (PhraseAffect(0, 3, toned(Tone.ANGRY, 0.9)), PhraseAffect(4, 9, toned(Tone.NEUTRAL, 1.0)))
    affect = LineAffect(toned(Tone.NEUTRAL, 1.0), phrases)
    found = faces(understudy, "I told you that, but the train is in the station.", affect)
    held = [each for each in found if each.moment and each.moment.startswith("attitude")]
    assert {(each.first, each.last) for each in held} == {(0, 3)}


def test_mistakes_are_told_with_their_places(tmp_path: Path) -> None:
    path = tmp_path / "attitudes.yaml"
    path.write_text("happy: {surely: 0.5, shows: [smil], reads: grin}\n")
    with pytest.raises(AuthoringError) as raised:
        load_attitudes(path, {"smile"}, {"smile"})
    told = [mistake.message for mistake in raised.value.mistakes]
    assert told[0] == "no behaviour is called 'smil'; did you mean 'smile'?"
    assert told[1].startswith("'grin' is not a kind of face")
