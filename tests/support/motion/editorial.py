"""A short performance made by hand, for tests of timelines: two functions, a gesture, overlapping faces, a blink."""

from types import MappingProxyType

from tests.support.words.by_hand import spoken
from understudy.model import Behavior, Channel, Function, Hand, Schedule, SyncPoints

LEAD_IN_S = 0.5
WORDS = spoken("No I have seen", start_s=1.5)
STROKE = SyncPoints(1.0, 2.6, ready=1.3, stroke_start=1.4, stroke=1.5, stroke_end=1.8, relax=2.2)
SCHEDULE = Schedule(
    behaviors=(
        Behavior("gesture1", Channel.GESTURE, "NEGATION", STROKE, 0, 0, 2.0, "show_negation", "f1", hand=Hand.RIGHT),
        Behavior("head1", Channel.HEAD, "SHAKE", STROKE, 1, 2, 1.0, "show_emphasis", "f2"),
        Behavior("face1", Channel.FACE, "RAISE_BROWS", SyncPoints(1.0, 2.0), 1, 2, 1.0, "show_emphasis", "f2"),
        Behavior("face2", Channel.FACE, "RAISE_MOUTH_CORNERS", SyncPoints(1.5, 2.5), 3, 3, 1.0),
        Behavior("eyes1", Channel.EYES, "BLINK", SyncPoints(2.7, 2.9), 0, 0, 0.0),
    ),
    duration_s=4.0,
    words=WORDS,
    lead_in_s=LEAD_IN_S,
    functions=(
        Function("f1", "negation", "plain", 0, 0, 3.0, "negation_by_word"),
        Function("f2", "emphasis", "voice", 1, 2, 1.0, "emphasis_by_voice"),
    ),
)
REALIZED = MappingProxyType({each.id: each.sync for each in SCHEDULE.behaviors})
