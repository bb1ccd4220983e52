"""`understudy pitch`: f0 and energy every 10 ms, as CSV; f0 is 0 where the voice is silent or unvoiced."""

import argparse

from ...library.hearing import AcousticModels, analyze_signal
from ...model import FRAME_SHIFT_S, Contours
from ...settings import read_settings
from ..files import read_bytes, write_standard
from ..log import Log

HEADER = "time_s,f0_hz,energy_db"


def run(arguments: argparse.Namespace, log: Log) -> int:
    settings = read_settings()
    audio = read_bytes(arguments.audio, limit=settings.max_audio_bytes, field="audio")
    heard = analyze_signal(AcousticModels.load(settings), audio, log.stage)
    write_standard(_csv(heard.contours).encode())
    log.warnings(heard.notices)
    return 0


def _csv(contours: Contours) -> str:
    measures = zip(contours.f0_hz, contours.energy_db, strict=True)
    rows = (f"{frame * FRAME_SHIFT_S:.2f},{f0:.2f},{energy:.2f}" for frame, (f0, energy) in enumerate(measures))
    return "\n".join((HEADER, *rows, ""))
