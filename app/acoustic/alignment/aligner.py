"""Forced alignment: the times of words and phones in a recording, given its transcript.

pocketsphinx aligns in two passes, words and then their phones, at 100 frames per second; then `boundaries` refines the
times. `benchmarks/acoustic/alignment.py` measures both. Phones are ARPABET without stress digits; their `stress` is
None, since the dictionary has none. A word that is not spoken ("—") keeps its index and has no interval and no phones.

If the aligner finds no path, the words are spread over the loud parts, with phones of equal length. Word boundaries are
then off by half a second on average, so there is always a notice, and each word is marked (`Word.spread`).
"""

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Self

import numpy as np

from ...errors import InputError
from ...model import Audio, Filler, FloatArray, Interval, Notice, Phone, Word
from ..pronunciation.normalisation import Normaliser
from ..pronunciation.pronouncer import Pronouncer, Pronunciation
from ..signal.spectrum import FRAME_S, frame_power
from .boundaries import BoundaryModel
from .decoder_process import FRAMES_PER_S, DecodedLine, DecodedPhone, DecoderProcess
from .fit import check_fit, check_found
from .pieces import decode_in_pieces

WINDOW_DELAY_S = 0.0078
"""The delay of a phone after the start of its first frame: half of the difference between window and frame shift."""


@dataclass(frozen=True, slots=True)
class Alignment:
    """The timed words, notices about them, and the fillers found between them."""

    words: tuple[Word, ...]
    notices: tuple[Notice, ...]
    fillers: tuple[Filler, ...] = ()


@dataclass(frozen=True, slots=True)
class PronouncedWords:
    """Words with the phones they are expected to have, none of them timed, and notices about them; which are
    `abbreviated`, with a full stop of their own, and which are `capitalized` for emphasis, by index."""

    words: tuple[Word, ...]
    notices: tuple[Notice, ...]
    abbreviated: frozenset[int]
    capitalized: frozenset[int]


@dataclass(frozen=True, slots=True)
class _Spoken:
    """A spoken word of the transcript, with the pronunciations of its tokens."""

    word: Word
    tokens: tuple[str, ...]
    pronunciations: tuple[Pronunciation, ...]


class Aligner:
    """Aligns transcripts; thread-safe. The decoder runs in a separate process, started for the first line."""

    def __init__(self, models: Path, lexicon: Path, *, refined: bool = True) -> None:
        """`models` contains `pronunciation/` and `alignment/`, `lexicon` contains `abbreviations.yaml`.

        Without `refined` the times are the decoder's own, as needed for training the refinement, and where models of
        free data alone may be used. Raises ServiceError if a model is missing or broken, AuthoringError for the
        abbreviations.
        """
        from pocketsphinx import get_model_path  # is loaded with the aligner, not with whoever names it

        dictionary = Path(get_model_path()) / "en-us" / "cmudict-en-us.dict"
        self._pronouncer = Pronouncer.load(dictionary, models / "pronunciation" / "graphones.npz")
        self._normaliser = Normaliser.load(lexicon / "abbreviations.yaml", self._pronouncer.dictionary.keys())
        self._boundaries = BoundaryModel.load(models / "alignment" / "boundaries.npz") if refined else None
        self._process = DecoderProcess()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_exception: object) -> None:
        self.close()

    def warm_up(self) -> None:
        """Start the decoder process, so that the first line need not wait for it."""
        self._process.start()

    def close(self) -> None:
        """Stop the decoder process; a later `align` starts a new one."""
        self._process.close()

    def interrupt(self) -> None:
        """End what another thread is aligning, which raises ServiceError `aligner_crashed` there."""
        self._process.interrupt()

    def align(self, audio: Audio, words: tuple[Word, ...]) -> tuple[tuple[Word, ...], tuple[Notice, ...]]:
        """The words with their intervals and phones in `audio`, and notices; see `listen`."""
        alignment = self.listen(audio, words)
        return alignment.words, alignment.notices

    def listen(self, audio: Audio, words: tuple[Word, ...]) -> Alignment:
        """The words with their intervals and phones in `audio`, and the fillers between them.

        Notices: `pronunciation_guessed`, `word_unreadable`, `transcript_suspect`, `alignment_low_confidence`. Raises
        InputError `transcript_unspoken` (nothing in it can be spoken) and `transcript_mismatch` (the text does not
        match the audio), ServiceError `aligner_crashed`.
        """
        spoken, notices = self._pronounced(words)
        decoded = self._decoded(audio.samples, spoken)
        if decoded is None:
            check_found(audio)
            timed, fit_notices = spread(audio, _expected(spoken))
            fillers: tuple[Filler, ...] = ()
        else:
            timed = _timed(spoken, decoded.words, audio.duration_s)
            timed = self._boundaries.refine(audio, timed) if self._boundaries else timed
            fit_notices = check_fit(audio, timed, decoded.words)
            fillers = tuple(Filler(each.label, _interval(each, audio.duration_s)) for each in decoded.fillers)
        in_time = {word.index: word for word in timed}
        return Alignment(tuple(in_time.get(word.index, word) for word in words), notices + fit_notices, fillers)

    def pronounce(self, words: tuple[Word, ...]) -> tuple[Word, ...]:
        """The words with the phones they are expected to have, none of them timed. Raises InputError
        `transcript_unspoken`."""
        return self.read(words).words

    def read(self, words: tuple[Word, ...]) -> PronouncedWords:
        """How the words are read where nobody is heard; raises as `pronounce` does. Notices: `pronunciation_guessed`,
        `word_unreadable`."""
        spoken, notices = self._pronounced(words)
        expected = {word.index: word for word in _expected(spoken)}
        return PronouncedWords(
            tuple(expected.get(word.index, word) for word in words),
            notices,
            self._normaliser.abbreviated(words),
            self._normaliser.capitalized(words),
        )

    def decode(self, audio: Audio, words: tuple[Word, ...]) -> DecodedLine | None:
        """The phones of the words where the decoder has them, whether they fit or not; None if it finds no path."""
        return self._decoded(audio.samples, self._pronounced(words)[0])

    def _decoded(self, samples: FloatArray, spoken: list[_Spoken]) -> DecodedLine | None:
        """The phones of the words; None if the decoder finds no path."""
        words = [[" ".join(phones) for phones in each.variants] for word in spoken for each in word.pronunciations]
        return decode_in_pieces(self._process, samples, words)

    def _pronounced(self, words: tuple[Word, ...]) -> tuple[list[_Spoken], tuple[Notice, ...]]:
        spoken, unreadable, guessed = [], [], []
        for word, tokens in zip(words, self._normaliser.spoken(words), strict=True):
            said = [(token, found) for token in tokens if (found := self._pronouncer.pronounce(token))]
            guessed += [token for token, found in said if found.guessed]
            if said:
                spoken.append(_Spoken(word, *zip(*said, strict=True)))
            elif any(map(str.isalnum, word.text)):
                unreadable.append(word)
        if not spoken:
            raise InputError(
                "transcript_unspoken",
                "nothing in the text can be spoken; send the English words of the line",
                field="text",
            )
        return spoken, (*_guessed(guessed), *_unreadable(unreadable))


def _timed(spoken: list[_Spoken], decoded: list[list[DecodedPhone]], duration_s: float) -> tuple[Word, ...]:
    remaining = iter(decoded)
    words = []
    for each in spoken:
        phones = tuple(_phone(phone, duration_s) for _ in each.tokens for phone in next(remaining))
        interval = Interval(phones[0].interval.start_s, phones[-1].interval.end_s)
        words.append(replace(each.word, interval=interval, phones=phones))
    return tuple(words)


def _phone(phone: DecodedPhone, duration_s: float) -> Phone:
    return Phone(phone.label, _interval(phone, duration_s))


def _interval(phone: DecodedPhone, duration_s: float) -> Interval:
    first = phone.first_frame
    return Interval(_seconds(first, duration_s), _seconds(first + phone.frames, duration_s))


def _seconds(frame: int, duration_s: float) -> float:
    """The start time of a frame, rounded to the millisecond."""
    time_s = round(frame / FRAMES_PER_S + WINDOW_DELAY_S, 3)
    return min(max(time_s, 0.0), duration_s)


def _expected(spoken: list[_Spoken]) -> tuple[Word, ...]:
    """The words with their expected phones, without times."""
    nowhere = Interval(0.0, 0.0)
    return tuple(
        replace(
            each.word,
            phones=tuple(Phone(label, nowhere) for said in each.pronunciations for label in said.variants[0]),
        )
        for each in spoken
    )


def _guessed(tokens: list[str]) -> tuple[Notice, ...]:
    if not tokens:
        return ()
    names = ", ".join(dict.fromkeys(tokens))
    return (Notice("pronunciation_guessed", f"not in the dictionary, pronunciation guessed: {names}"),)


def _unreadable(words: list[Word]) -> tuple[Notice, ...]:
    if not words:
        return ()
    names = ", ".join(f"{word.index} ({word.text})" for word in words)
    return (Notice("word_unreadable", f"not in the Latin alphabet, left without a time: word {names}"),)


BELOW_LOUDEST_DB = 30.0

MOST_PHONES_PER_S = 25.0
"""An upper limit of speaking rate."""


def spread(audio: Audio, words: tuple[Word, ...]) -> tuple[tuple[Word, ...], tuple[Notice, ...]]:
    """The words (with phones but no times) over the frames within 30 dB of the loudest, and the notice about it.

    Raises InputError `transcript_mismatch` if the audio is too short for the words.
    """
    power = frame_power(audio)
    loud_s = np.flatnonzero(power >= power.max() * 10 ** (-BELOW_LOUDEST_DB / 10)) * FRAME_S
    count = sum(len(word.phones) for word in words)
    if count > MOST_PHONES_PER_S * len(loud_s) * FRAME_S:
        raise InputError(
            "transcript_mismatch",
            f"the text has {count} speech sounds, too many for {len(loud_s) * FRAME_S:.2f} s of sound; "
            "send the words of this recording",
            field="text",
        )
    edges_s = np.interp(
        np.linspace(0, len(loud_s), count + 1), np.arange(len(loud_s) + 1), [*loud_s, loud_s[-1] + FRAME_S]
    )
    named = ", ".join(f"{word.index} ({word.text})" for word in words)
    notice = Notice(
        "alignment_low_confidence",
        f"the aligner found no path through the audio; times are guessed from loudness for word {named}",
    )
    return tuple(_placed(words, edges_s.round(3))), (notice,)


def _placed(words: tuple[Word, ...], edges_s: FloatArray) -> list[Word]:
    placed = []
    first = 0
    for word in words:
        edges = [float(edge) for edge in edges_s[first : first + len(word.phones) + 1]]
        phones = tuple(
            replace(phone, interval=Interval(start_s, end_s))
            for phone, start_s, end_s in zip(word.phones, edges, edges[1:], strict=False)
        )
        placed.append(replace(word, interval=Interval(edges[0], edges[-1]), phones=phones, spread=True))
        first += len(word.phones)
    return placed
