"""The notes on a performance: those stored with the armature, and those that follow from the current strips."""

from collections.abc import Collection, Sequence
from typing import Any

from ..schedule.behaviors import Behavior
from ..schedule.notes import Done, Note, note_on, with_done
from .behavior_strips import changes_of, put_back, strips_of
from .performances import behaviors_in, order_of, trace_of


def notes_of(record: Any) -> tuple[Note, ...]:
    """The notes that are kept."""
    return tuple(Note.from_json(entry.content) for entry in record.notes)


def keep_notes(record: Any, notes: Sequence[Note]) -> None:
    """Keeps these notes, and no others."""
    record.notes.clear()
    for note in notes:
        entry = record.notes.add()
        entry.name, entry.content = note.label, note.to_json()


def notes_now(armature: Any, record: Any, rate_hz: float) -> tuple[Note, ...]:
    """The stored notes, with the changes to the strips since they were added."""
    behaviors = {each.id: each for each in behaviors_in(record)}
    changes = changes_of(armature, record.name, tuple(behaviors.values()), rate_hz)
    done = [
        Done(behaviors[name], change.shift_s, change.longer_s, omitted=change.removed)
        for name, change in changes.items()
    ]
    return _with(record, done)


def lock_selected(armature: Any, record: Any, rate_hz: float) -> int:
    """Makes notes that keep the selected strips unchanged; returns their number."""
    notes = notes_now(armature, record, rate_hz)
    keep_notes(record, notes)
    selected = [each for each in strips_of(armature, record.name) if each.strip.select and not each.muted]
    done = [Done(each.behavior) for each in selected if _note_on(each.behavior, notes, record) is None]
    keep_notes(record, _with(record, done))
    return len(selected)


def clear_notes(armature: Any, record: Any, numbers: Collection[int]) -> None:
    """Removes the notes with these numbers; strips that were moved for them and not yet played so go back."""
    notes = notes_of(record)
    for each in strips_of(armature, record.name):
        note = _note_on(each.behavior, notes, record)
        if note is not None and note.number in numbers:
            put_back(armature, each)
    keep_notes(record, [note for note in notes if note.number not in numbers])


def _note_on(behavior: Behavior, notes: Sequence[Note], record: Any) -> Note | None:
    return note_on(behavior, notes, trace_of(record), order_of(record).notes)


def _with(record: Any, done: Sequence[Done]) -> tuple[Note, ...]:
    return with_done(notes_of(record), done, trace_of(record), order_of(record).notes)
