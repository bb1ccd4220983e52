"""Gives each gesture the manner of the voice at its stroke: how big, how fast, how tense it is."""

from dataclasses import replace

from ...model import Behavior, Channel, Utterance


def with_manner(behaviors: tuple[Behavior, ...], utterance: Utterance) -> tuple[Behavior, ...]:
    """The behaviours, those gestures with a manner that are stroked while words are spoken whose manner is known."""
    if not utterance.manners:
        return behaviors
    return tuple(_in_manner(each, utterance) if each.kind is Channel.GESTURE else each for each in behaviors)


def _in_manner(gesture: Behavior, utterance: Utterance) -> Behavior:
    """The gesture with the manner of the word that is nearest to its stroke."""
    stroke_s = next(
        time_s for time_s in (gesture.sync.stroke, gesture.sync.stroke_end, gesture.sync.start) if time_s is not None
    )
    timed = [(word.index, word.interval) for word in utterance.words if word.interval]
    if not timed:
        return gesture
    nearest, _ = min(timed, key=lambda each: max(each[1].start_s - stroke_s, stroke_s - each[1].end_s, 0.0))
    return replace(gesture, manner=utterance.manners[nearest])
