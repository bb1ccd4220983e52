"""Summarizes for people what the character does and why."""

from collections import Counter
from collections.abc import Iterator

from ...model import PLAIN, Behavior, Function, Performance

WORDS_WIDTH = 28


def summary(performance: Performance) -> str:
    """The line's behaviours in order of time, each with its words, the function it shows and the rule that chose it,
    or what spoke most for it."""
    return "\n".join(_lines(performance))


def _lines(performance: Performance) -> Iterator[str]:
    utterance = performance.utterance
    kept = sorted((behavior for behavior in performance.behaviors if behavior.kept), key=lambda one: one.sync.start)
    functions = {function.id: function for function in performance.functions}
    level = utterance.agitation.level if utterance.agitation else "unknown"
    duration_s = utterance.duration_s or 0.0
    begins = f", the recording begins at {utterance.lead_in_s:.2f} s" if utterance.lead_in_s else ""
    yield f"{performance.character} performs {duration_s:.2f} s{begins}, agitation {level}, seed {performance.seed}"
    for behavior in kept:
        if not _is_idle(behavior):
            yield _movement(performance, behavior, functions.get(behavior.function or ""))
    own = Counter(behavior.lexeme.lower() for behavior in kept if _is_idle(behavior))
    if own:
        yield "idle: " + ", ".join(f"{count} × {lexeme}" for lexeme, count in own.items())
    dropped = len(performance.behaviors) - len(kept)
    if dropped:
        yield f"not shown: {dropped} (--trace says why)"


def _movement(performance: Performance, behavior: Behavior, function: Function | None) -> str:
    words = " ".join(word.text for word in performance.utterance.words[behavior.first : behavior.last + 1])
    shown = words if len(words) <= WORDS_WIDTH else words[: WORDS_WIDTH - 1] + "…"
    movement = behavior.lexeme.lower() + (f" ({behavior.hand})" if behavior.hand else "")
    return (
        f"{behavior.sync.start:6.2f}–{behavior.sync.end:5.2f} s  {behavior.kind:7s} {movement:24s} "
        f"{shown:{WORDS_WIDTH}s}  {_why(behavior, function)}"
    )


def _why(behavior: Behavior, function: Function | None) -> str:
    authored = "" if behavior.edit is None else f"the author's edit {behavior.edit}"
    if function is None:
        return authored or _decided(behavior)
    chosen = f"{_name(function)} by {function.rule} → {behavior.rule or behavior.reason}"
    return f"{chosen}; {authored}" if authored else chosen


def _is_idle(behavior: Behavior) -> bool:
    """Whether the body does it by itself: for no function, no moment of the plan and no edit."""
    return behavior.function is None and behavior.moment is None and behavior.edit is None


def _decided(behavior: Behavior) -> str:
    """The part that spoke most for it, and its rule."""
    part = max(behavior.decided_by, key=lambda each: each.weight, default=None)
    chosen = behavior.rule or behavior.reason or ""
    return f"{part.name} ({part.weight:+.1f}) → {chosen}" if part else chosen


def _name(function: Function) -> str:
    return function.class_name if function.subtype == PLAIN else f"{function.class_name} ({function.subtype})"
