"""Speaks every line of the dialogue with flite 2.2 (Debian's `flite`, voice slt), as ID.flac beside this file.

Run from the root of the checkout: `python examples/npc/lines/make_lines.py`.
"""

import json
import subprocess
import tempfile
from pathlib import Path

import numpy as np
import soundfile

FOLDER = Path(__file__).parent
PEAK = 0.8


def main() -> None:
    """Writes all recordings."""
    dialogue = json.loads((FOLDER.parent / "dialogue.json").read_text(encoding="utf-8"))
    with tempfile.TemporaryDirectory() as folder:
        wav = Path(folder) / "line.wav"
        for line in dialogue["lines"]:
            subprocess.run(["flite", "-voice", "slt", "-t", line["text"], "-o", str(wav)], check=True)
            samples, rate_hz = soundfile.read(wav)
            soundfile.write(FOLDER / f"{line['id']}.flac", samples * (PEAK / np.abs(samples).max()), rate_hz, "PCM_16")


if __name__ == "__main__":
    main()
