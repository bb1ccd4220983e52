"""The vocabulary of directors' notes, with what each word asks for (docs/directing.md).

A family of gestures is what an audience reads in the hands, whatever their form; head, face and gaze have kinds of
their own.
"""

from collections.abc import Mapping
from types import MappingProxyType

from ...model import Channel

STILL = "still"
NEUTRAL = "neutral"

GESTURES: Mapping[str, str] = MappingProxyType(
    {
        "self": "a hand to one's own chest",
        "addressee": "a point or an open hand towards the listener",
        "group": "we, all of us",
        "point_here": "this place, or a thing at hand",
        "point_there": "that place, or a thing in the scene",
        "point_up": "what is above",
        "negation": "a shake of the hand, a sweep, the palm down wiping something away",
        "stop_refuse": "the palm out: stop, no further, not me",
        "question": "the palms up and open",
        "shrug": "not knowing, being uncertain",
        "present": "an idea on the open palm; the commonest gesture of conversation",
        "offer_give": "a thing or a favour held out or handed over",
        "size_big": "how big",
        "size_small": "how small",
        "shape": "length, height, roundness, flatness or weight",
        "count": "a number, on the fingers",
        "list_item": "the next item of a list",
        "all_sweep": "everyone, everything, the whole",
        "none_empty": "nothing, emptiness",
        "precision": "a ring or pinch: exactly, just that, a little",
        "beat": "plain emphasis",
        "chop": "insistence, firmness",
        "fist": "force, determination, threat",
        "contrast_sides": "this on one side, that on the other",
        "compare_levels": "one higher than the other",
        "up": "upwards, rising, more",
        "down": "downwards, falling, less",
        "left": "to the speaker's left",
        "right": "to the speaker's right",
        "forward": "forwards, onwards",
        "back": "backwards, behind",
        "approach": "coming nearer",
        "away": "going or sending away",
        "through_path": "motion along a path, across or through something",
        "cycle": "a process, again and again, rolling on",
        "turn_over_change": "turning over, becoming something else",
        "begin": "a start, an opening",
        "end_cut": "an end, a cut",
        "join": "bringing together",
        "separate": "taking apart",
        "contain_in": "in something, holding, containing",
        "out": "out of something",
        "past": "back in time",
        "future": "ahead in time",
        "now": "at this moment",
        "think": "a hand to the head: the mind",
        "heart": "feeling, sincerity",
        "accept": "taking, agreeing, letting it be",
        "dismiss": "waving it away",
        "greet": "a greeting",
        "farewell": "a good-bye",
        "thanks": "thanking",
        "apologise": "apologising",
        "please": "asking, begging",
        "quote": "quotation marks, another's words",
        "word_search": "looking for a word",
        "weigh": "the hands as scales",
        "emblem_other": "another gesture with a meaning of its own, or a mime; `idea` names it",
        STILL: "the hands deliberately at rest",
    }
)

HEADS: Mapping[str, str] = MappingProxyType(
    {
        "nod": "a nod",
        "shake": "a shake",
        "tilt": "to one side",
        "toss": "a toss back or up",
        "turn": "turned aside",
        "lean_in": "the trunk towards the listener",
        "lean_back": "the trunk away from the listener",
        STILL: "deliberately at rest",
    }
)

FACES: Mapping[str, str] = MappingProxyType(
    {
        "brows_up": "the brows raised",
        "frown": "the brows drawn together",
        "smile": "a smile",
        "sad": "the inner brows raised, the corners of the mouth down",
        "squint": "the eyes narrowed",
        "wide_eyes": "the eyes wide open",
        "lips_pressed": "the lips pressed together",
        "disgust": "the nose wrinkled",
        NEUTRAL: "no expression",
    }
)

GAZES: Mapping[str, str] = MappingProxyType(
    {
        "listener": "at the listener",
        "away": "aside",
        "up": "up",
        "down": "down",
        "target": "at the thing or place that is pointed at",
    }
)

KINDS: Mapping[Channel, Mapping[str, str]] = MappingProxyType(
    {Channel.GESTURE: GESTURES, Channel.HEAD: HEADS, Channel.FACE: FACES, Channel.GAZE: GAZES}
)
"""What can be asked for on each channel of a director's note."""

HANDS, ANYTHING = "hands", "any"
"""What else can be avoided: every gesture; every gesture, movement of the head, face and look."""

BANNABLE = frozenset({*(kind for kinds in KINDS.values() for kind in kinds), HANDS, ANYTHING, *Channel})
"""What an author may forbid besides behaviours and lexemes: a family of gestures, a kind of movement of head, face or
eyes, a channel, the hands, everything."""

DEMANDABLE = frozenset({kind for kinds in KINDS.values() for kind in kinds} - {STILL, NEUTRAL})
"""What an author may ask for always besides behaviours and lexemes: a family of gestures, or a kind of movement of
head, face or eyes."""

AVOIDABLE = frozenset({*GESTURES, *HEADS, *FACES, *GAZES, HANDS, ANYTHING})
