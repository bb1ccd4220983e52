"""A performance on an armature: adds its motion and strips, and stores its record with the armature.

The BML and the record are texts of the file, so that they are saved with it, can be read, and undo brings them back.
"""

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import bpy

from ..performing.lines import PlayedLine
from ..performing.requests import Json
from ..schedule.behaviors import Behavior
from .armatures import apply_properties, bones_of
from .behavior_strips import lay_behaviors
from .layers import lay_clip, mark_behaviors, take_away
from .takes import begin_take, forget_take, keep_in_take, shown_take


@dataclass(frozen=True, slots=True)
class Order:
    """The request for a performance: its name, the scene's frame of second 0 of the recording, the recording (None:
    BML alone), its words, the options of performing and of realizing, and the numbers of the notes that were sent."""

    name: str
    zero_frame: float
    audio: Path | None = None
    text: str = ""
    options: Json | None = None
    realization: Json | None = None
    notes: tuple[int, ...] = ()


def lay_performance(
    armature: Any, played: PlayedLine, order: Order, rate_hz: float, *, new_take: bool = False
) -> tuple[str, ...]:
    """Adds a performance in place of the one of the same name, which is lost unless this is a new take of it; returns
    the warnings to show. Raises NoHumanoidError."""
    found = bones_of(armature)
    messages = [f"{each} was set" for each in apply_properties(armature, found.table)]
    if new_take:
        begin_take(armature, record_of(armature, order.name))
    else:
        take_away(armature, order.name)
    clip = played.clip.at_rate(rate_hz)
    first_frame = round(order.zero_frame + clip.start_s * rate_hz)
    actions = lay_clip(armature, found, clip, order.name, first_frame)
    mark_behaviors(actions, played.behaviors, rate_hz, clip.start_s)
    lay_behaviors(armature, played.behaviors, order.name, order.zero_frame, rate_hz)
    _remember(armature, played, order)
    if armature.animation_data.action is not None:
        messages.append(f"{armature.name} has an active action, which plays over the strips: unlink or push it down")
    return (*messages, *(each.message for each in played.warnings), *clip.notices)


def record_of(armature: Any, name: str) -> Any:
    """What the armature remembers of the performance of this name; None if there is none."""
    return next((each for each in armature.understudy.performances if each.name == name), None)


def order_of(record: Any) -> Order:
    """The request for a stored performance."""
    written = json.loads(record.order)
    audio = Path(written["audio"]) if written["audio"] else None
    return Order(
        record.name,
        record.zero_frame,
        audio,
        written["text"],
        written["options"],
        written["realization"],
        tuple(written.get("notes", ())),
    )


def bml_of(record: Any) -> bytes:
    """The BML of a remembered performance."""
    return str(record.bml.as_string()).encode()


def trace_of(record: Any) -> Mapping[str, Any]:
    """All that is known of a remembered performance; empty where only its BML is."""
    return json.loads(record.trace.as_string()) if record.trace else {}


def behaviors_in(record: Any) -> tuple[Behavior, ...]:
    """The behaviours as they were added."""
    return tuple(Behavior.from_json(json.dumps(each)) for each in json.loads(record.behaviors))


def forget(armature: Any, name: str) -> None:
    """Takes a performance away, with its takes and texts."""
    take_away(armature, name)
    performances = armature.understudy.performances
    index = performances.find(name)
    if index >= 0:
        shown_take(performances[index])
        for take in performances[index].takes:
            forget_take(take)
        performances.remove(index)


def free_name(wanted: str, armature: Any) -> str:
    """A name that no performance of the armature has yet."""
    taken = {each.name for each in armature.understudy.performances}
    numbered = (f"{wanted} {number}" for number in range(2, len(taken) + 3))
    return wanted if wanted not in taken else next(name for name in numbered if name not in taken)


def _remember(armature: Any, played: PlayedLine, order: Order) -> None:
    record = record_of(armature, order.name) or armature.understudy.performances.add()
    record.name, record.zero_frame = order.name, order.zero_frame
    take = shown_take(record)
    title = f"{armature.name} {order.name}" + ("" if take.name == "Take 1" else f" {take.name.lower()}")
    record.bml = _text(take.bml, f"{title}.bml", played.bml.decode())
    if played.trace:
        record.trace = _text(take.trace, f"{title}.json", json.dumps(played.trace, indent=1))
    record.behaviors = json.dumps([json.loads(each.to_json()) for each in played.behaviors])
    record.order = json.dumps(
        {
            "audio": str(order.audio) if order.audio else "",
            "text": order.text,
            "options": order.options,
            "realization": order.realization,
            "notes": order.notes,
        }
    )
    keep_in_take(record)


def _text(there: Any, name: str, content: str) -> Any:
    text = there or bpy.data.texts.new(name)
    text.from_string(content)
    return text
