"""Gestures as values: unchanged by writing and reading, and mistakes are found in the text."""

import pytest

from understudy.authoring.catalogue import load_gestures
from understudy.authoring.gesture_texts import NAME
from understudy.errors import InputError
from understudy.realizer.gestures.library import parse_definitions
from understudy.realizer.gestures.writing import write_gesture
from understudy.schemas.gestures.definitions import GestureValues, read_gesture_check


def test_every_gesture_of_the_library_is_the_same_as_values_and_as_text() -> None:
    for definition in load_gestures().definitions:
        values = GestureValues.of(definition)
        again = GestureValues.model_validate_json(values.model_dump_json(by_alias=True))
        assert again == values
        [read] = parse_definitions(again.to_text(), NAME)
        assert GestureValues.of(read) == values
        assert again.to_text() == write_gesture(definition)


def test_values_that_contradict_each_other_are_written_for_the_checker_to_tell() -> None:
    values = GestureValues.of(load_gestures().definitions[0]).model_dump(mode="json", by_alias=True)
    values["frames"][0]["leading"]["wrist"] = {"finger_base": ["Up"], "palm": ["Up", "Down"]}
    values["name"] = "two\nENDFRAME words"
    text = read_gesture_check({"gestures": [values]}).written(load_gestures())
    assert "  WRIST FBUp PalmUpDown\n" in text
    assert "GESTUREINSTANCE two ENDFRAME words\n" in text


def test_a_gesture_of_the_library_is_asked_for_by_its_name() -> None:
    library = load_gestures()
    definition = library.definitions[3]
    assert read_gesture_check({"library": definition.name}).written(library) == write_gesture(definition)


@pytest.mark.parametrize("fields", [{}, {"text": "", "gestures": []}, {"text": 3}, {"gestures": [{}]}, {"txt": ""}])
def test_a_request_has_a_text_or_gestures(fields: dict[str, object]) -> None:
    with pytest.raises(InputError) as caught:
        read_gesture_check(fields).written(load_gestures())
    assert caught.value.code == "value_wrong"
