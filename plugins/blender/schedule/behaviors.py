"""What the body does, behaviour by behaviour: from a performance's record, or from BML and its realized times.

Times are seconds of the recording, points go by the names that Understudy's JSON has (`start`, `ready`, `stroke_start`,
`stroke`, `stroke_end`, `relax`, `end`).
"""

import json
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from typing import Any

from ..motion.clip import Clip, Event
from .bml_document import described
from .labels import label_of

LAYERS = {"gesture": "body", "posture": "body", "head": "head", "gaze": "gaze", "face": "face", "eyes": "face"}
"""The action that shows a kind of behaviour."""


@dataclass(frozen=True, slots=True)
class Behavior:
    """A behaviour: its id in the BML, its kind and lexeme, when it was realized, the words that it goes with, why it is
    there, what an audience reads in it (`families`), what of it was not played as asked (`decisions`), the hand that
    makes it, what is looked at and by which way from it (`target`, `direction`), and the number of the edit that made
    it, if one did."""

    id: str
    kind: str
    lexeme: str
    points_s: Mapping[str, float]
    first: int | None = None
    last: int | None = None
    words: str = ""
    function: str = ""
    rule: str = ""
    reason: str = ""
    families: tuple[str, ...] = ()
    decisions: tuple[str, ...] = ()
    hand: str = ""
    target: str = ""
    direction: str = ""
    edit: int | None = None

    @property
    def label(self) -> str:
        """Its label."""
        return label_of(self.kind, self.lexeme, hand=self.hand, target=self.target, direction=self.direction)

    @property
    def start_s(self) -> float:
        return min(self.points_s.values())

    @property
    def end_s(self) -> float:
        return max(self.points_s.values())

    @property
    def stroke_s(self) -> float:
        """When it is fully seen."""
        return next(
            (self.points_s[name] for name in ("stroke", "ready", "start") if name in self.points_s), self.start_s
        )

    @property
    def why(self) -> str:
        """The function that it shows and the rule that chose it, or the reason that it has without."""
        return " by ".join(part for part in (self.function, self.rule) if part) or self.reason

    def to_json(self) -> str:
        return json.dumps(asdict(self))

    @classmethod
    def from_json(cls, text: str) -> "Behavior":
        written = json.loads(text)
        return cls(**written | {name: tuple(written[name]) for name in ("families", "decisions")})


@dataclass(frozen=True, slots=True)
class Reasons:
    """What a performance's record knows beyond its BML."""

    trace: Mapping[str, Any] = field(default_factory=dict)

    def behaviors(self) -> dict[str, Mapping[str, Any]]:
        return {each["id"]: each for each in self.trace.get("behaviors", ()) if each["kept"]}

    def function(self, name: str | None) -> str:
        """A function's class and subtype."""
        found = next((each for each in self.trace.get("functions", ()) if each["id"] == name), None)
        if found is None:
            return ""
        return f"{found['class']} ({found['subtype']})" if found["subtype"] else str(found["class"])

    def families(self, moment: str | None) -> tuple[str, ...]:
        """What a moment may mean, the likeliest first."""
        return next((tuple(each["families"]) for each in self.trace.get("moments", ()) if each["id"] == moment), ())

    def words(self, first: int | None, last: int | None) -> str:
        if first is None or last is None:
            return ""
        return " ".join(each["text"] for each in self.trace.get("words", ())[first : last + 1])


def behaviors_of(bml: bytes, clip: Clip, trace: Mapping[str, Any] | None = None) -> tuple[Behavior, ...]:
    """The behaviours of a BML file that were realized, in order of time. Raises WrongBmlError."""
    realized = _by_behavior(clip.events)
    reasons = Reasons(trace or {})
    found = (_decided(behavior, clip) for behavior in _behaviors(bml, realized, reasons))
    return tuple(sorted(found, key=lambda each: (each.start_s, each.id)))


def _decided(behavior: Behavior, clip: Clip) -> Behavior:
    decisions = tuple(each.message for each in clip.decisions if each.behavior == behavior.id)
    return replace(behavior, decisions=decisions)


def _behaviors(bml: bytes, realized: Mapping[str, Mapping[str, float]], reasons: Reasons) -> Iterator[Behavior]:
    known = reasons.behaviors()
    for each in described(bml):
        points = realized.get(each.id)
        if not points:
            continue
        trace = known.get(each.id, {})
        first, last = trace.get("first"), trace.get("last")
        yield Behavior(
            each.id,
            trace.get("kind", each.kind),
            trace.get("lexeme", each.lexeme),
            points,
            first,
            last,
            reasons.words(first, last),
            reasons.function(trace.get("function")),
            trace.get("rule") or "",
            trace.get("reason") or "",
            reasons.families(trace.get("moment")),
            hand=trace.get("hand") or each.hand,
            target=trace.get("target") or each.target,
            direction=trace.get("direction") or each.direction,
            edit=trace.get("edit"),
        )


def _by_behavior(events: Sequence[Event]) -> dict[str, dict[str, float]]:
    found: dict[str, dict[str, float]] = defaultdict(dict)
    for event in events:
        found[event.behavior][event.point] = event.time_s
    return found


def gestures_in(written: str) -> str:
    """The gestures of a take, in order of time, by which it is told from others; `written` is the JSON list of its
    behaviours."""
    kinds = [each for each in json.loads(written or "[]") if each["kind"] == "gesture"]
    return ", ".join(each["lexeme"].replace("_", " ").lower() for each in kinds)
