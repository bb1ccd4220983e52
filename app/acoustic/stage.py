"""The acoustic stage: from a recording and its words to contours (all frame-wise measurements of a signal), agitation,
and word times (paper §3.1).
"""

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor, wait
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import partial

from ..model import (
    Affect,
    AffectTrack,
    Agitation,
    AlignedLine,
    Audio,
    Contours,
    Filler,
    Level,
    Line,
    LineAffect,
    Manner,
    Notice,
    Parse,
    SignalAnalysis,
    StressThresholds,
    Timings,
    Utterance,
    Word,
)
from ..model.performance import Progress, no_progress
from ..model.voice.signal import SpeakerReference
from ..settings import Settings
from ..text.transcript import read_transcript
from .affect.line_affect import Stretch, given_line, line_affect
from .affect.manner import word_manners
from .agitation.utterance_features import full_features
from .agitation.voice_quality import voice_quality
from .alignment.aligner import Alignment
from .alignment.timings import read_fillers, read_timings
from .models import AcousticModels
from .pitch.tracking import track_f0
from .signal.decoding import AudioLimits, decode
from .signal.spectrum import doubts, energy_db, mel_db, mfcc
from .stress import Measure, prominence, stress, with_emphasis, with_listeners
from .unheard import UnheardLine, pace_words, unheard_utterance


def contours_of(audio: Audio) -> Contours:
    """The contours of `audio` (paper §3.1.1 to §3.1.3)."""
    f0_hz = track_f0(audio)  # first, since it needs the most memory
    levels_db = mel_db(audio)
    return Contours(energy_db=energy_db(audio), f0_hz=f0_hz, mfcc=mfcc(levels_db), mel_db=levels_db)


RETRY_S = 0.05
"""How long until an interrupted alignment that had not reached its process is interrupted again."""


@dataclass(frozen=True, slots=True, eq=False)
class HeardLine:
    """A recorded line: its words in time, what the signal says, and how the speaker usually sounds."""

    words: tuple[Word, ...]
    signal: SignalAnalysis
    notices: tuple[Notice, ...]
    fillers: tuple[Filler, ...]
    reference: SpeakerReference | None = None

    @property
    def duration_s(self) -> float:
        return self.signal.audio.duration_s


def hear(
    acoustic: AcousticModels, line: Line, progress: Progress = no_progress, *, reference: SpeakerReference | None = None
) -> HeardLine | UnheardLine:
    """The words of a line in time, with what its recording says; without one they are timed as they are usually spoken
    (`pace_words`).

    Raises InputError for audio, text and timings that cannot be used.
    """
    transcript = read_transcript(line.text)
    if line.audio is None:
        progress("align")
        return pace_words(acoustic, transcript, line.speaking, line.timings)
    progress("decode")
    audio, notices = decode(line.audio, audio_limits(acoustic.settings))
    with _at_the_same_time(partial(align_words, acoustic, audio, transcript, line.timings), acoustic) as aligned:
        signal = _measured(acoustic, audio, progress, reference)
        progress("align")
        timed = aligned.result()
    notices += signal.notices + timed.notices
    return HeardLine(timed.words, signal, notices, timed.fillers, reference)


@contextmanager
def _at_the_same_time(align: Callable[[], Alignment], acoustic: AcousticModels) -> Iterator[Future[Alignment]]:
    """The alignment, which waits for the aligner's process, while the block works; what ends the block early ends that
    process too. The thread is gone after the block, so that a process may be forked."""
    with ThreadPoolExecutor(1, thread_name_prefix="align") as beside:
        aligned = beside.submit(align)
        try:
            yield aligned
        finally:
            while not aligned.done():
                acoustic.interrupt()
                wait([aligned], timeout=RETRY_S)


def with_prosody(
    acoustic: AcousticModels,
    line: HeardLine | UnheardLine,
    parse: Parse,
    *,
    agitation: Level | None = None,
    affect: AffectTrack | None = None,
) -> Utterance:
    """The utterance: the words with their stress and focus, the speaker's agitation and feeling, as given, else as
    heard."""
    if isinstance(line, UnheardLine):
        return unheard_utterance(acoustic, line, parse, agitation=agitation, affect=affect)
    signal = line.signal
    words, thresholds = measure_stress(acoustic, line.words, signal.contours, signal.audio)
    level = Agitation.certain(agitation) if agitation else signal.agitation
    if affect is None:
        feeling = line_affect(acoustic.affect, _stretch(signal), signal.affect, words, line.reference)
    else:
        feeling = given_line(affect, words, line.duration_s)
    return Utterance(
        words=words,
        parse=parse,
        agitation=level,
        thresholds=thresholds,
        duration_s=line.duration_s,
        fillers=line.fillers,
        affect=feeling,
        manners=hear_manners(signal, words, level, feeling),
    )


def analyze_signal(
    acoustic: AcousticModels,
    audio: bytes,
    progress: Progress = no_progress,
    *,
    reference: SpeakerReference | None = None,
) -> SignalAnalysis:
    """Measures the signal alone: its contours, the speaker's agitation (paper §3.1.1 to §3.1.4) and feeling."""
    progress("decode")
    signal, notices = decode(audio, audio_limits(acoustic.settings))
    measured = _measured(acoustic, signal, progress, reference)
    return replace(measured, notices=notices + measured.notices)


def _measured(
    acoustic: AcousticModels, signal: Audio, progress: Progress, reference: SpeakerReference | None
) -> SignalAnalysis:
    progress("contours")
    contours = contours_of(signal)
    progress("agitation")
    quality = voice_quality(signal, contours.f0_hz)
    features = full_features(contours, quality)
    agitation = acoustic.agitation.agitation(features, reference)
    affect = acoustic.affect.affect_of(Stretch(signal, contours, quality, features), reference)
    return SignalAnalysis(signal, contours, quality, features, agitation, affect, doubts(contours.energy_db))


def hear_sound(acoustic: AcousticModels, sound: Audio) -> Affect:
    """The feeling of a sound that is heard as it comes."""
    contours = contours_of(sound)
    return acoustic.affect.affect_of(Stretch(sound, contours, voice_quality(sound, contours.f0_hz)))


def hear_manners(
    heard: SignalAnalysis, words: tuple[Word, ...], agitation: Agitation, affect: LineAffect
) -> tuple[Manner, ...]:
    """How a movement is made on each of the timed words, by the voice there."""
    return word_manners(_stretch(heard), words, agitation, affect)


def _stretch(heard: SignalAnalysis) -> Stretch:
    return Stretch(heard.audio, heard.contours, heard.quality, heard.features)


def align_words(
    acoustic: AcousticModels,
    audio: Audio,
    transcript: tuple[Word, ...],
    timings: Timings | None = None,
) -> Alignment:
    """The words with the times that the caller gave, else with the aligner's."""
    if timings is None:
        return acoustic.aligner.listen(audio, transcript)
    words = read_timings(timings.content, timings.format, transcript, duration_s=audio.duration_s)
    return Alignment(words, (), read_fillers(timings.content, timings.format, duration_s=audio.duration_s))


def measure_stress(
    acoustic: AcousticModels, words: tuple[Word, ...], contours: Contours, audio: Audio | None = None
) -> tuple[tuple[Word, ...], StressThresholds]:
    """Timed words with their stress, prominence, emphasis and focus, and the utterance's own thresholds (paper §3.1.5).
    Prominence and focus are surer with the recording itself."""
    listeners = acoustic.listeners.heard(audio, words) if audio else {}
    stressed, thresholds = stress(with_listeners(prominence(words, contours), listeners), contours)
    focused = acoustic.focus.with_focus(stressed, contours, listeners) if acoustic.focus else stressed
    return with_emphasis(focused, Measure(acoustic.settings.emphasis)), thresholds


def make_reference(acoustic: AcousticModels, recordings: Sequence[SignalAnalysis]) -> SpeakerReference:
    """How the speaker of these recordings, one or more, usually sounds."""
    features = [acoustic.agitation.describe(heard.features) for heard in recordings]
    return SpeakerReference.of(acoustic.agitation.feature_set, features)


def align(acoustic: AcousticModels, line: Line) -> AlignedLine:
    """The times of the words and phones of a line."""
    transcript = read_transcript(line.text)
    signal, notices = decode(line.recording, audio_limits(acoustic.settings))
    timed = align_words(acoustic, signal, transcript, line.timings)
    return AlignedLine(timed.words, signal.duration_s, notices + timed.notices, timed.fillers)


def audio_limits(settings: Settings) -> AudioLimits:
    """The limits that the settings put on audio."""
    return AudioLimits(max_duration_s=settings.max_audio_s, max_bytes=settings.max_audio_bytes)
