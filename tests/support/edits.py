"""What an author would write of a behaviour that a performance has."""

from understudy.model import Behavior, Performance
from understudy.model.edits import BehaviorReference, MarkPlace, WordReference


def reference_to(behavior: Behavior, performance: Performance) -> BehaviorReference:
    """The reference that means this behaviour."""
    functions = {each.id: each.class_name for each in performance.functions}
    families = {each.id: each.families[0] for each in performance.moments}
    word = performance.utterance.words[behavior.first]
    start_s = word.interval.start_s if word.interval else 0.0
    return BehaviorReference(
        channel=behavior.kind,
        at=WordReference(word.index, word.text),
        function=functions.get(behavior.function or ""),
        family=families.get(behavior.moment or ""),
        lexeme=behavior.lexeme,
        offset_s=behavior.sync.start - start_s,
    )


def place_of(at_s: float, behavior: Behavior, performance: Performance) -> MarkPlace:
    """A moment of the line, told by the first word of a behaviour."""
    word = performance.utterance.words[behavior.first]
    assert word.interval is not None, "the word is spoken"
    return MarkPlace(WordReference(word.index, word.text), at_s - word.interval.start_s)
