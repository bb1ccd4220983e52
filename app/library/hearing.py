"""What a recording says: its contours, the speaker's agitation, the times of words, a speaker's usual voice (§3.1)."""

from collections.abc import Sequence

from ..acoustic.models import AcousticModels
from ..acoustic.signal.decoding import decode
from ..acoustic.stage import align as _align
from ..acoustic.stage import analyze_signal, audio_limits
from ..acoustic.stage import make_reference as _make_reference
from ..errors import InputError
from ..model import AlignedLine, Audio, Notice, SignalAnalysis, Timings
from ..model.voice.signal import SpeakerReference
from ..models import Understudy
from ..settings import Settings
from .sources import FileSource, content_of, line_of

__all__ = ["AcousticModels", "align", "analyze_signal", "audio_limits", "make_reference", "read_audio"]


def align(
    models: Understudy | AcousticModels, audio: FileSource, text: str, *, words: FileSource | Timings | None = None
) -> AlignedLine:
    """The times of a line's words and phones, and of the fillers ("um") between them (§3.1). `AcousticModels` suffice;
    with `words`, timed elsewhere, nothing is aligned.

    Raises InputError for audio or text that cannot be used.
    """
    return _align(_acoustic(models), line_of(audio, text, words))


def make_reference(
    models: Understudy | AcousticModels, recordings: Sequence[FileSource | SignalAnalysis]
) -> SpeakerReference:
    """How the speaker of these recordings, one or more, usually sounds: the baseline for the speaker's agitation
    (§3.1.4). A recording that is analysed already is not analysed again.

    Raises InputError for audio that cannot be used, and `value_wrong` when there is none.
    """
    if not recordings:
        raise InputError("value_wrong", "recordings: give at least one", field="recordings")
    acoustic = _acoustic(models)
    heard = (
        each if isinstance(each, SignalAnalysis) else analyze_signal(acoustic, content_of(each)) for each in recordings
    )
    return _make_reference(acoustic, list(heard))


def read_audio(content: bytes, settings: Settings) -> tuple[Audio, tuple[Notice, ...]]:
    """The samples of a recording, and what was guessed; raises InputError for audio that cannot be used."""
    return decode(content, audio_limits(settings))


def _acoustic(models: Understudy | AcousticModels) -> AcousticModels:
    return models.acoustic if isinstance(models, Understudy) else models
