"""Annotations for tests: a short one by hand, and the examples that are in the repository."""

from pathlib import Path

from understudy.profiles.annotation.tracks import Track, TrackSpan

EXAMPLES = Path(__file__).resolve().parents[2] / "examples" / "speakers"
SWEEPING, SPARING = EXAMPLES / "sweeping.json", EXAMPLES / "sparing.eaf"

WHERE = {"from": "XP YCC ZMiddle out", "to": "XC YUpperC ZFar normal"}


def small_tracks() -> dict[str, Track]:
    """Two units in one segment of speech: two gestures, the first with an after-stroke, then one."""
    words = ("I", "never", "said", "that", "you", "lied")
    tags = (("deixis.self", 0, 0), ("negation", 1, 1), ("deixis.addressee", 4, 4))
    hands = {"hand": "RH", "affiliate": "0", **WHERE}
    tracks = {
        "words": tuple(_word_span(number, number, text) for number, text in enumerate(words)),
        "tags": tuple(_word_span(first, last, tag) for tag, first, last in tags),
        "phases": (
            TrackSpan(0.2, 0.6, "preparation"),
            TrackSpan(0.6, 0.9, "stroke"),
            TrackSpan(0.9, 1.0, "hold"),
            TrackSpan(1.0, 1.3, "stroke"),
            TrackSpan(1.3, 1.6, "preparation"),
            TrackSpan(1.6, 1.8, "stroke"),
            TrackSpan(1.8, 2.1, "retraction"),
            TrackSpan(2.2, 2.4, "preparation"),
            TrackSpan(2.4, 2.6, "stroke"),
            TrackSpan(2.6, 3.0, "retraction"),
        ),
        "phrases": (
            TrackSpan(0.2, 1.3, "ME", hands),
            TrackSpan(1.3, 1.8, "NEGATION", {"hand": "2H", "path": "curved", "affiliate": "never"}),
            TrackSpan(2.2, 2.6, "YOU", {"hand": "LH", "affiliate": "4-5"}),
        ),
        "units": (TrackSpan(0.2, 2.1, "clasped"), TrackSpan(2.2, 3.0, "at_side")),
        "head": (TrackSpan(0.9, 1.3, "shake"),),
        "gaze": (TrackSpan(0.0, 2.25, "listener"), TrackSpan(2.25, 3.0, "away")),
        "posture": (TrackSpan(0.0, 3.0, "WEIGHT_ON_LEFT_LEG"),),
    }
    return {name: Track(name, spans) for name, spans in tracks.items()}


def _word_span(first: int, last: int, label: str) -> TrackSpan:
    """Words of .4 s each from .5 s on."""
    return TrackSpan(round(0.5 + 0.4 * first, 3), round(0.9 + 0.4 * last, 3), label)
