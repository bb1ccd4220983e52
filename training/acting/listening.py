"""What the analysis hears of a delivery as it is written, so that the reader learns from what it will be told.

A delivery is guessed: the focus as likely found as the analysis finds it, from hardly to surely; affect and loudness
mostly as they were measured in some recording of the same tone and loudness (`training.acting.recordings`), else the
tone as one of the seven of the analysis or a mixture, with noise. Lines that were directed without a delivery are read
as words alone, or as said without any expression, or as their director seems to have imagined them (the focus on what
has the stroke, the tone that of the face). Whatever is told is dropped at random, so that the reader does without it
too.
"""

import random
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import TypeAlias

import numpy as np

from understudy.behavior.reading.encoder import WORDS_ALONE, Delivery, clear_focus
from understudy.model import Affect, LineAffect, Tone

from .directed import DirectedLine, gesture_choices

# fmt: off
TONES: Mapping[str, tuple[tuple[float, float, float], dict[Tone, float]]] = {
    "neutral": ((0.0, 0.0, 0.0), {Tone.NEUTRAL: 1.0}),
    "angry": ((0.6, -0.5, 0.5), {Tone.ANGRY: 1.0}),
    "sad": ((-0.5, -0.5, -0.4), {Tone.SAD: 1.0}),
    "happy": ((0.4, 0.5, 0.2), {Tone.HAPPY: 1.0}),
    "afraid": ((0.4, -0.5, -0.5), {Tone.AFRAID: 1.0}),
    "disgusted": ((0.0, -0.5, 0.2), {Tone.DISGUSTED: 1.0}),
    "amused": ((0.2, 0.4, 0.1), {Tone.HAPPY: 0.6, Tone.NEUTRAL: 0.3, Tone.SURPRISED: 0.1}),
    "tender": ((-0.4, 0.1, -0.2), {Tone.NEUTRAL: 0.5, Tone.SAD: 0.5}),
    "weary": ((-0.6, -0.2, -0.3), {Tone.SAD: 0.6, Tone.NEUTRAL: 0.4}),
    "excited": ((0.7, 0.5, 0.3), {Tone.HAPPY: 0.6, Tone.SURPRISED: 0.4}),
    "hesitant": ((-0.2, -0.1, -0.4), {Tone.NEUTRAL: 0.5, Tone.AFRAID: 0.25, Tone.SAD: 0.25}),
    "commanding": ((0.4, -0.2, 0.6), {Tone.NEUTRAL: 0.4, Tone.ANGRY: 0.6}),
}
# fmt: on
"""Activation, valence and dominance of the written tones, and what the seven tones of the analysis make of them."""

FACE_TONES = {"smile": "amused", "frown": "angry", "sad": "sad", "disgust": "disgusted", "wide_eyes": "excited"}
"""The tone in which a line is said with such a face, where nothing else is known of it."""

FOCUS_HEARD, CONTENT_HEARD, FOCUS_NOISE = (3.0, 8.0), 0.6, 1.0
"""How much stronger than other words a focused word, from least to most, or one of many letters, seems: with this noise
the likeliest word has the share that it has in recordings of deliveries, over .5 in nine of ten and over .9 in half."""

IMAGINED_FOCUS = 1.8
"""The same for words of which a director's stroke lets us guess that he heard them stressed."""

IMAGINED_TONE = 0.6
"""How often the tone is guessed from a director's faces."""

MEASURED_SHARE, FEWEST_MEASURED = 0.7, 5
TONE_MISHEARD = 0.25
DROPPED_WHOLE, DROPPED_PART = 0.2, 0.12
WORDS_ALONE_SHARE, FLAT_SHARE = 0.33, 0.42
"""Of the lines without a delivery, those read as words alone, and those read as said without expression."""


Voices: TypeAlias = Mapping[tuple[str, int], Sequence[Delivery]]
"""What was measured in recordings, by the written tone and loudness."""


def voices_of(measured: Mapping[str, Sequence[Delivery]], lines: Iterable[DirectedLine]) -> Voices:
    """What was measured, by the deliveries' tones and loudnesses; too few of a kind are left out."""
    found: dict[tuple[str, int], list[Delivery]] = {}
    for line in lines:
        if line.is_delivery:
            key = line.reading["tone"], line.reading["loudness"]
            found.setdefault(key, []).extend(measured.get(line.name, ()))
    return {key: deliveries for key, deliveries in found.items() if len(deliveries) >= FEWEST_MEASURED}


def heard(line: DirectedLine, voices: Voices, chance: random.Random) -> Delivery:
    """One way in which a line may be heard."""
    if line.is_delivery:
        return _dropped(as_written(line, voices, chance), chance)
    lot = chance.random()
    if lot < WORDS_ALONE_SHARE:
        return WORDS_ALONE
    flat = lot < WORDS_ALONE_SHARE + FLAT_SHARE
    return _dropped(_flat(line, voices, chance) if flat else _imagined(line, voices, chance), chance)


def as_written(line: DirectedLine, voices: Voices, chance: random.Random) -> Delivery:
    """A delivery as it may be measured, nothing dropped; the words alone for other lines."""
    if not line.is_delivery:
        return WORDS_ALONE
    stressed = dict.fromkeys(line.reading["focus"], chance.uniform(*FOCUS_HEARD))
    return _said(_focus(line, stressed, chance), (line.reading["tone"], line.reading["loudness"]), voices, chance)


def _said(focus: tuple[float, ...], manner: tuple[str, int], voices: Voices, chance: random.Random) -> Delivery:
    """A focus said in a tone and loudness."""
    if manner in voices and chance.random() < MEASURED_SHARE:
        voice = chance.choice(voices[manner])
        return Delivery(focus, LineAffect(voice.affect.line) if voice.affect else None, voice.loudness)
    tone, loudness = manner
    effort = 0.6 * loudness + 0.8 * TONES[tone][0][0]
    return Delivery(focus, _affect(tone, loudness, chance), _loudness(effort, chance))


def _flat(line: DirectedLine, voices: Voices, chance: random.Random) -> Delivery:
    """Said as a synthetic voice says it: an accent anywhere, no tone."""
    stressed = {chance.randrange(len(line.words)): chance.choice((0.0, 1.5))}
    return _said(_focus(line, stressed, chance), ("neutral", 0), voices, chance)


def _imagined(line: DirectedLine, voices: Voices, chance: random.Random) -> Delivery:
    """Said as the director's choices suggest."""
    moments = [each for each in line.reading["moments"] if gesture_choices(each) and each["stroke"] < len(line.words)]
    strongest = max((each["importance"] for each in moments), default=0)
    stressed = {each["stroke"]: IMAGINED_FOCUS for each in moments if each["importance"] == strongest}
    faces = [face for each in line.reading["moments"] for face in each.get("face") or () if face in FACE_TONES]
    tone = FACE_TONES[chance.choice(faces)] if faces and chance.random() < IMAGINED_TONE else "neutral"
    return _said(_focus(line, stressed, chance), (tone, 0), voices, chance)


def _focus(line: DirectedLine, strength: Mapping[int, float], chance: random.Random) -> tuple[float, ...]:
    scores = np.array(
        [
            strength.get(word, 0.0) + CONTENT_HEARD * (len(text.strip(".,;:!?")) > 3) + chance.gauss(0, FOCUS_NOISE)
            for word, text in enumerate(line.words)
        ]
    )
    shares = np.exp(chance.uniform(0.8, 1.6) * (scores - scores.max()))
    return tuple(float(share) for share in shares / shares.sum())


def _affect(tone: str, loudness: int, chance: random.Random) -> LineAffect:
    """The tone as heard: its shares mixed with noise and, at times, quite another one's."""
    taken = tone if chance.random() >= TONE_MISHEARD else chance.choice(("neutral", *TONES))
    dimensions, shares = TONES[taken]
    certainty, quiet = chance.uniform(0.8, 2.5), 0.06
    scores = np.array([certainty * np.log(shares.get(each, 0.0) + quiet) + chance.gauss(0, 0.5) for each in Tone])
    odds = np.exp(scores - scores.max())
    habit = chance.gauss(0, 0.15)
    activation, valence, dominance = (
        _clipped(value * chance.uniform(0.4, 1.2) + chance.gauss(0, noise))
        for value, noise in zip(dimensions, (0.15, 0.25, 0.2), strict=True)
    )
    return LineAffect(
        Affect(
            activation=_clipped(activation + 0.15 * loudness + habit),
            valence=valence,
            dominance=_clipped(dominance + 0.1 * loudness + habit),
            tones=tuple(float(share) for share in odds / odds.sum()),
        )
    )


def _loudness(effort: float, chance: random.Random) -> float:
    """How loud a line seems: speakers differ, and most synthetic voices seem lax when they say something neutrally."""
    return _clipped(effort + chance.uniform(-0.9, 0.2) + chance.gauss(0, 0.15))


def _dropped(delivery: Delivery, chance: random.Random) -> Delivery:
    """The delivery, or without some of its parts."""
    if chance.random() < DROPPED_WHOLE:
        return WORDS_ALONE
    delivery = replace(delivery, focus=clear_focus(delivery.focus) if delivery.focus else None)
    parts = [name for name in ("focus", "affect", "loudness") if chance.random() < DROPPED_PART]
    return replace(delivery, **dict.fromkeys(parts))


def _clipped(value: float) -> float:
    return max(-1.0, min(1.0, value))
