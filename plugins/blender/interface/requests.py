"""What the settings ask for: the line, its place in time, and the things of the scene, as plain values for a thread."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import bpy

from ..performing.requests import Json, Line
from ..scene.armatures import bones_of
from ..scene.performances import Order, free_name
from ..scene.places import place_m, places_m, target_name
from ..scene.sounds import NoRecordingError, frame_rate_hz, readable, recording_of, sound_strip, words_of

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


def request_of(context: Any) -> Request:
    """What the scene's settings ask for. Raises ValueError with what is missing or wrong."""
    scene, settings = context.scene, context.scene.understudy
    performer = performer_of(context)
    audio, zero_frame, spoken = _recording(scene)
    text = " ".join((settings.text or spoken).split())
    if not text:
        raise NothingToPerformError("there are no words: write the text, or give the strip a property 'text'")
    listener = settings.listener if settings.listener is not performer else None
    reacting = _reacting(settings, listener)
    options = _options(settings, performer, listener if reacting else None)
    options["targets"] = _targets(settings, performer, listener)
    name = free_name(_line_name(settings, audio), performer)
    realizations = _realizations(settings, scene, performer, listener if reacting else None)
    order = Order(name, zero_frame, audio, text, options, realizations[""])
    return Request(performer, Line(audio, text, options), order, realizations, reacting, settings.source == "FILE")


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


def _recording(scene: Any) -> tuple[Path, float, str]:
    """The recording, the frame at which it begins, and the words that the strip has."""
    settings = scene.understudy
    if settings.source == "STRIP":
        if not settings.strip:
            raise NothingToPerformError("choose a sound strip, or a file")
        strip = sound_strip(scene, settings.strip)
        return recording_of(scene, strip), float(strip.frame_final_start), words_of(scene, strip)
    if not settings.audio:
        raise NoRecordingError("choose a recording")
    return readable(Path(bpy.path.abspath(settings.audio))), float(scene.frame_current), ""


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
        found["listener"] = [_listener_name(performer, listener)]
    return found


def _listener_name(performer: Any, listener: Any) -> str:
    """What a listener that performs is called: as its character, so that it listens as that does, or by its own name
    where the speaker is the same character."""
    characters = {each: each.understudy.character or "default" for each in (performer, listener)}
    alike = characters[performer] == characters[listener]
    return target_name(listener.name if alike else characters[listener])


def _targets(settings: Any, performer: Any, listener: Any) -> dict[str, tuple[float, float, float]]:
    """The things of the scene by the names that words and BML call them."""
    things = {target_name(each.thing.name): each.thing for each in settings.targets if each.thing is not None}
    if settings.camera is not None:
        things[CAMERA] = settings.camera
    spoken_to = listener if listener is not None else settings.camera
    if spoken_to is not None:
        reacting = _reacting(settings, listener) is not None
        things[_listener_name(performer, spoken_to) if reacting else LISTENER] = spoken_to
    return places_m(performer, bones_of(performer), things)


def _realizations(settings: Any, scene: Any, performer: Any, listener: Any) -> dict[str, Json]:
    """How the speaker's and the listener's BML are realized; the listener's names the speaker by his character."""
    found = {"": realization(scene, performer, settings.tail_s)}
    if listener is not None:
        speaker = place_m(listener, bones_of(listener), performer)
        towards = {"targets": {performer.understudy.character or "default": speaker}}
        found[_listener_name(performer, listener)] = realization(scene, listener, settings.tail_s) | towards
    return found


def _line_name(settings: Any, audio: Path) -> str:
    return settings.strip if settings.source == "STRIP" else audio.stem
