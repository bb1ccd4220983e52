"""How big, fast and tense movements are, from the voice: of a whole line against others, and of a word in it.

A line's size and speed are linear in its agitation, its feeling, how fast it is spoken and how far its pitch moves; the
weights were fitted to what a director asked of spoken deliveries (`python -m training.affect.manner`).
A word that is louder than the others of its line gets a larger and quicker movement, by a factor that was chosen.
Tension was chosen too: people tense with anger and fear, and slacken with sadness (affect-expressive gesture, Bozkurt
et al., §3, has it as activation against valence).
"""

from collections.abc import Collection, Iterator, Sequence
from math import exp, isfinite

import numpy as np

from ...model import FRAME_SHIFT_S, Affect, Agitation, FloatArray, LineAffect, Manner, Tone, Word
from ..agitation.utterance_features import PITCH_RANGE_OCTAVES, SYLLABLES_A_SECOND
from ..signal.frames import percentiles
from .line_affect import Stretch

MEASURES = ("arousal", "sadness", "syllables a second", "pitch range in octaves")
USUAL = (-0.014, 0.118, 5.265, 0.634)
SIZE = (0.505, -0.722, 0.113, 0.207)
SPEED = (0.529, -0.749, 0.123, -0.114)
"""The mean of each measure, and what a unit of it adds to the size and the speed asked for, of which 1 is "larger" or
"faster" and -1 the contrary."""

IN_SPEECH = ((3.0, 8.0), (0.1, 1.4))
"""What the last two measures are in speech; what is beyond is noise."""

AMPLITUDE_STEP, SPEED_STEP, TENSION_STEP = 1.25, 0.25, 0.5
"""The logs of the factors for "larger", "faster" and all that makes tense. A larger stroke is a faster one already, and
a stroke that would be too fast is made smaller (paper §3.8), so that speed must leave room for size."""

WORD_STEP = 0.1
"""The log of the factor for a word that is 6 dB louder than half of the line's."""

LIMITS = {"amplitude": (0.35, 2.0), "speed": (0.75, 1.3), "tension": (0.6, 1.5)}
_DOUBLE_DB = 6.0
_MOST_DOUBLINGS = 1.5
_LOUD_PERCENT = 90


def measures(features: FloatArray, agitation: Agitation, affect: Affect) -> tuple[float, ...]:
    """The measures of a line in the order of `MEASURES`; `features` are those of affect. Unknown ones are usual.

    Arousal is half the agitation and the activation, so that an author may give either.
    """
    heard = (features[SYLLABLES_A_SECOND], features[PITCH_RANGE_OCTAVES])
    return (
        (agitation.high - agitation.low) / 2 + affect.activation,
        affect.share(Tone.SAD),
        *(
            min(max(float(value), low), high) if isfinite(value) else usual
            for value, usual, (low, high) in zip(heard, USUAL[-2:], IN_SPEECH, strict=True)
        ),
    )


def line_manner(measured: Sequence[float], affect: Affect) -> Manner:
    """How movements are made in a line of these measures."""
    apart = np.subtract(measured, USUAL)
    tense = apart[0] + affect.share(Tone.ANGRY) + affect.share(Tone.AFRAID) / 2 - affect.share(Tone.SAD)
    return _within(
        exp(AMPLITUDE_STEP * float(np.dot(SIZE, apart))),
        exp(SPEED_STEP * float(np.dot(SPEED, apart))),
        exp(TENSION_STEP * tense),
    )


def word_manners(
    stretch: Stretch, words: tuple[Word, ...], agitation: Agitation, affect: LineAffect
) -> tuple[Manner, ...]:
    """How a movement is made on each word of a recorded line."""
    features = stretch.features()
    lines = {phrase.affect for phrase in affect.phrases} | {affect.line}
    by_affect = {each: line_manner(measures(features, agitation, each), each) for each in lines}
    return tuple(
        _within(manner.amplitude * factor, manner.speed * factor, manner.tension)
        for word, factor in zip(words, _loud_factors(stretch, words), strict=True)
        for manner in (by_affect[affect.at(word.index)],)
    )


def unheard_manners(
    words: tuple[Word, ...], agitation: Agitation, affect: LineAffect, emphasized: Collection[int]
) -> tuple[Manner, ...]:
    """How a movement is made on each word of a line that nobody has spoken: at a usual pace and pitch, an emphasized
    word as one that is twice as loud."""
    by_affect = {
        each: line_manner(
            ((agitation.high - agitation.low) / 2 + each.activation, each.share(Tone.SAD), *USUAL[-2:]), each
        )
        for each in {phrase.affect for phrase in affect.phrases} | {affect.line}
    }
    return tuple(
        _within(manner.amplitude * factor, manner.speed * factor, manner.tension)
        for word in words
        for manner, factor in ((by_affect[affect.at(word.index)], exp(WORD_STEP * (word.index in emphasized))),)
    )


def _loud_factors(stretch: Stretch, words: tuple[Word, ...]) -> Iterator[float]:
    """The factor of each word for its loudness beside the others; 1 where it has no time."""
    levels_db = [_level_db(stretch, word) for word in words]
    known = [level_db for level_db in levels_db if level_db is not None]
    usual_db = float(np.median(known)) if known else 0.0
    for level_db in levels_db:
        doublings = 0.0 if level_db is None else (level_db - usual_db) / _DOUBLE_DB
        yield exp(WORD_STEP * min(max(doublings, -_MOST_DOUBLINGS), _MOST_DOUBLINGS))


def _level_db(stretch: Stretch, word: Word) -> float | None:
    """The level of a word's loud frames."""
    if word.interval is None:
        return None
    first, last = (round(time_s / FRAME_SHIFT_S) for time_s in (word.interval.start_s, word.interval.end_s))
    frames = stretch.contours.energy_db[first : last + 1]
    return percentiles(frames, _LOUD_PERCENT)[0] if len(frames) else None


def _within(amplitude: float, speed: float, tension: float) -> Manner:
    """The manner within its limits, in hundredths."""
    values = {"amplitude": amplitude, "speed": speed, "tension": tension}
    return Manner(**{name: round(min(max(values[name], low), high), 2) for name, (low, high) in LIMITS.items()})
