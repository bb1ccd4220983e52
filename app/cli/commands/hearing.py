"""The analyses of recordings: `understudy agitation`, `align`, `pitch` and `reference`, which load the acoustic models
only; and `understudy analyze`, the analysis of a line as JSON and optionally as a picture.
"""

import argparse
from pathlib import PurePath

from ...library.checks import check_line
from ...library.hearing import AcousticModels, analyze_signal, make_reference
from ...library.hearing import align as align_line
from ...library.writing import write_ctm, write_json, write_textgrid
from ...model import FRAME_SHIFT_S, AlignedLine, Contours
from ...schemas.references import to_json
from ...schemas.responses import AgitationResponse
from ...settings import read_settings
from ..files import read_bytes, require_writable, write, write_standard
from ..inputs.hearing import hear_file, require_files, require_reference, shown, speaker_reference
from ..inputs.lines import level_of, optional_affect, read_line
from ..log import Log
from ..outputs.plot import plot, require_plot

PITCH_HEADER = "time_s,f0_hz,energy_db"


def agitation(arguments: argparse.Namespace, log: Log) -> int:
    """The speaker's agitation and feeling in each file, as one line of JSON per file, in order."""
    settings = read_settings()
    require_files(arguments.audio, settings)
    require_reference(arguments.reference, settings)
    acoustic = AcousticModels.load(settings)
    reference = speaker_reference(acoustic, arguments.reference, log)
    for path in arguments.audio:
        heard = hear_file(acoustic, path, log, reference)
        write_standard(AgitationResponse.of(shown(path), heard).to_json() + b"\n")
    return 0


def align(arguments: argparse.Namespace, log: Log) -> int:
    """The times of words and phones, as JSON, Praat TextGrid or CTM."""
    settings = read_settings()
    line = read_line(arguments, settings)
    check_line(line, settings)
    assert line.audio is not None, "the command takes a recording"
    with AcousticModels.load(settings) as acoustic:
        aligned = align_line(acoustic, line.audio, line.text, words=line.timings)
    write_standard(_formatted(aligned, arguments))
    log.warnings(aligned.notices)
    return 0


def _formatted(aligned: AlignedLine, arguments: argparse.Namespace) -> bytes:
    if arguments.format == "textgrid":
        return write_textgrid(aligned)
    if arguments.format == "ctm":
        return write_ctm(aligned, PurePath(arguments.audio).stem)
    return write_json(aligned, indent=2) + b"\n"


def pitch(arguments: argparse.Namespace, log: Log) -> int:
    """f0 and energy every 10 ms, as CSV; f0 is 0 where the voice is silent or unvoiced."""
    settings = read_settings()
    audio = read_bytes(arguments.audio, limit=settings.max_audio_bytes, field="audio")
    heard = analyze_signal(AcousticModels.load(settings), audio, log.stage)
    write_standard(_csv(heard.contours).encode())
    log.warnings(heard.notices)
    return 0


def _csv(contours: Contours) -> str:
    measures = zip(contours.f0_hz, contours.energy_db, strict=True)
    rows = (f"{frame * FRAME_SHIFT_S:.2f},{f0:.2f},{energy:.2f}" for frame, (f0, energy) in enumerate(measures))
    return "\n".join((PITCH_HEADER, *rows, ""))


def reference(arguments: argparse.Namespace, log: Log) -> int:
    """Describes how a speaker usually sounds, from recordings, for `--reference`."""
    require_writable(arguments.output, field="output")
    settings = read_settings()
    require_files(arguments.audio, settings)
    acoustic = AcousticModels.load(settings)
    found = make_reference(acoustic, [hear_file(acoustic, path, log) for path in arguments.audio])
    write(arguments.output, to_json(found))
    return 0


def analyze(arguments: argparse.Namespace, log: Log) -> int:
    settings = read_settings()
    line = read_line(arguments, settings)
    if arguments.plot:
        require_plot(arguments.plot)
        require_writable(arguments.plot, field="plot")
    level = level_of(arguments)
    affect = optional_affect(arguments.affect)
    require_reference(arguments.reference, settings)
    check_line(line, settings)
    from ...library.performing import analyze_line
    from ...library.writing import write_json
    from ...models import Understudy
    from ...options import Options  # imported late: arguments are checked before the models load

    with Understudy.load(settings) as understudy:
        reference = speaker_reference(understudy.acoustic, arguments.reference, log)
        options = Options(agitation=level, affect=affect, reference=reference)
        analysis = analyze_line(understudy, line, options, log.stage)
    if arguments.plot and analysis.heard is not None:
        write(arguments.plot, plot(analysis, analysis.heard))
    write_standard(write_json(analysis, indent=2) + b"\n")
    log.warnings(analysis.notices)
    return 0
