"""Makes requests from the settings: the line, its time, and the targets in the scene, as plain values for a thread."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import bpy

from ..performing.requests import Json, Line
from ..scene.armatures import bones_of
from ..scene.performances import Order, free_name, record_of
from ..scene.places import place_m, places_m, target_name
from ..scene.sounds import (
    NoRecordingError,
    frame_rate_hz,
    readable,
    recording_of,
    sound_strip,
    strips_of_scene,
    words_of,
)

LISTENER, CAMERA = "listener", "camera"


class NothingToPerformError(ValueError):
    """Settings with which no line can be performed; the message says what is missing."""


@dataclass(frozen=True, slots=True, eq=False)
class Request:
    """A line for a performer, and for a listener that performs too (its name as a target and its realization)."""

    performer: Any
    line: Line
    order: Order
    realizations: Mapping[str, Json]
    listener: Any = None
    new_sound: bool = False


@dataclass(frozen=True, slots=True)
class _Recording:
    """A recording to perform: its file, first frame, words and the name of the line."""

    path: Path
    zero_frame: float
    words: str
    name: str


def request_of(context: Any) -> Request:
    """The request for the scene's settings. Raises ValueError with what is missing or wrong."""
    performer = performer_of(context)
    return _request(context.scene, performer, _recording(context.scene))


def requests_of_strips(context: Any) -> tuple[list[Request], list[str]]:
    """A request for each sound strip that has words and was not performed yet, in order of time, and why others are
    left out. A strip's custom property `character` names the armature that performs it. Raises NothingToPerformError.
    """
    found, told = [], []
    strips = [each for each in strips_of_scene(context.scene) if each.type == "SOUND"]
    for strip in sorted(strips, key=lambda each: float(each.frame_final_start)):
        try:
            performer = performer_of_strip(context, strip)
            if record_of(performer, strip.name) is None:
                found.append(_request(context.scene, performer, _of_strip(context.scene, strip)))
        except ValueError as error:
            told.append(f"{strip.name} is left out: {error}")
    if not found:
        raise NothingToPerformError("; ".join(told) or "the sequencer has no sound strip that was not performed yet")
    return found, told


def performer_of_strip(context: Any, strip: Any) -> Any:
    """The armature that performs a strip: the one whose object or character is called as the strip's custom property
    `character`, else the one chosen. Raises NothingToPerformError."""
    name = str(strip.get("character", ""))
    if not name:
        return performer_of(context)
    armatures = [each for each in context.scene.objects if each.type == "ARMATURE"]
    wanted = target_name(name).casefold()
    by_object = [each for each in armatures if target_name(each.name).casefold() == wanted]
    by_character = [each for each in armatures if target_name(each.understudy.character).casefold() == wanted]
    if by_object or by_character:
        return (by_object or by_character)[0]
    raise NothingToPerformError(f"no armature is called {name!r}: name one so, or change the strip's 'character'")


def _request(scene: Any, performer: Any, recording: _Recording) -> Request:
    settings = scene.understudy
    text = " ".join(recording.words.split())
    if not text:
        raise NothingToPerformError("there are no words: write the text, or give the strip a property 'text'")
    listener = _listener(settings, performer)
    reacting = _reacting(settings, listener)
    options = _options(settings, performer, reacting)
    options["targets"] = _targets(settings, performer, listener)
    name = free_name(recording.name, performer)
    realizations = _realizations(settings, scene, performer, reacting)
    order = Order(name, recording.zero_frame, recording.path, text, options, realizations[""])
    line = Line(recording.path, text, options)
    return Request(performer, line, order, realizations, reacting, settings.source == "FILE")


def performer_of(context: Any) -> Any:
    """The armature that performs: the one chosen, else the active one. Raises NothingToPerformError."""
    chosen = context.scene.understudy.performer or context.object
    if chosen is None or chosen.type != "ARMATURE":
        raise NothingToPerformError("choose a performer: select an armature, or name one")
    return chosen


def realization(scene: Any, performer: Any, tail_s: float = 0.0) -> Json:
    """The options with which BML is realized for an armature: at 60 frames a second, unless the scene has 30."""
    fps = 30 if frame_rate_hz(scene) == 30 else 60
    found: Json = {"fps": fps, "character": performer.understudy.character or "default"}
    return found | ({"tail_s": tail_s} if tail_s else {})


def _recording(scene: Any) -> _Recording:
    """The recording that the settings name."""
    settings = scene.understudy
    if settings.source == "STRIP":
        if not settings.strip:
            raise NothingToPerformError("choose a sound strip, or a file")
        found = _of_strip(scene, sound_strip(scene, settings.strip))
        return replace(found, words=settings.text) if settings.text else found
    if not settings.audio:
        raise NoRecordingError("choose a recording")
    path = Path(bpy.path.abspath(settings.audio))
    return _Recording(readable(path), float(scene.frame_current), settings.text, path.stem)


def _of_strip(scene: Any, strip: Any) -> _Recording:
    return _Recording(recording_of(scene, strip), float(strip.frame_final_start), words_of(scene, strip), strip.name)


def _listener(settings: Any, performer: Any) -> Any:
    """The addressee: the listener of the settings, or the performer of the settings where the listener speaks."""
    chosen = settings.listener if settings.listener is not performer else settings.performer
    return chosen if chosen is not performer else None


def _reacting(settings: Any, listener: Any) -> Any:
    """The listener, if it is an armature that performs too."""
    if listener is None or listener.type != "ARMATURE" or not settings.listener_performs:
        return None
    bones_of(listener)
    return listener


def _options(settings: Any, performer: Any, listener: Any) -> Json:
    own = performer.understudy
    found: Json = {"seed": settings.seed, "character": own.character or "default"}
    if own.profile:
        found["profile"] = own.profile
    if settings.agitation != "HEARD":
        found["agitation"] = settings.agitation
    if settings.stillness:
        found["stillness"] = round(settings.stillness, 4)
    if settings.lead_in_s:
        found["lead_in_s"] = round(settings.lead_in_s, 4)
    if listener is not None:
        found["listener"] = [f"{target_name(listener.name)}={listener.understudy.character or 'default'}"]
    return found


def _targets(settings: Any, performer: Any, listener: Any) -> dict[str, tuple[float, float, float]]:
    """The things of the scene by the names that words and BML call them."""
    things = {target_name(each.thing.name): each.thing for each in settings.targets if each.thing is not None}
    if settings.camera is not None:
        things[CAMERA] = settings.camera
    spoken_to = listener if listener is not None else settings.camera
    if spoken_to is not None:
        reacting = _reacting(settings, listener) is not None
        things[target_name(spoken_to.name) if reacting else LISTENER] = spoken_to
    return places_m(performer, bones_of(performer), things)


def _realizations(settings: Any, scene: Any, performer: Any, listener: Any) -> dict[str, Json]:
    """How the speaker's and the listener's BML are realized; the listener's names the speaker by his character."""
    found = {"": realization(scene, performer, settings.tail_s)}
    if listener is not None:
        speaker = place_m(listener, bones_of(listener), performer)
        towards = {"targets": {performer.understudy.character or "default": speaker}}
        found[target_name(listener.name)] = realization(scene, listener, settings.tail_s) | towards
    return found
