"""The figures of agreement with directors that score.py prints, as they are recorded."""

from collections.abc import Mapping
from typing import Any

from benchmarks.figures import record

Bars = Mapping[str, tuple[str | None, str | None]]
"""Of the figures that are recorded, what each must reach and what we want."""


def agreement(score: Any, counts: Mapping[str, int | float], lines: int) -> dict[str, float]:  # noqa: ANN401
    """The figures by name, with as many digits as score.py prints."""
    made, wanted = max(counts["n"], 1), max(counts["weight"], 1e-9)

    def share(part: str, whole: str) -> float:
        return round(counts[part] / max(counts[whole], 1), 2)

    return {
        "F": round(score.f_of(counts["worth"] / made, counts["given"] / wanted), 3),
        "accepted F": round(score.f_of(counts["right"] / made, counts["got"] / wanted), 3),
        "forbidden": round(counts["bad"] / made, 3),
        "strokes within a word, F": round(
            score.f_of(counts["placed"] / made, counts["met"] / max(counts["moments"], 1)), 3
        ),
        "gestures a line": round(counts["n"] / lines, 2),
        "head done": share("head_done", "head_asked"),
        "face done": share("face_done", "face_asked"),
        "tones right": share("face_toned_right", "face_toned"),
    }


def record_all(of: str, figures: Mapping[str, float], bars: Bars) -> None:
    """Records those that `bars` names, under the name of what they are of."""
    for name, (bar, aim) in bars.items():
        record("choice", f"{of}: {name}", figures[name], bar=bar, aim=aim)
