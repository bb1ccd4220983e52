"""What the analysis measures in recordings of deliveries: `python -m training.acting.recordings AUDIO … OUT.json`

AUDIO are folders with recordings ID.flac or ID.VOICE.flac of the deliveries that `directed.py` reads. OUT.json has, by
the delivery's name, one `Delivery` for each recording; `training.acting.encoder` learns from them.
"""

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from understudy.behavior.reading.delivery import Delivery
from understudy.model import Affect, LineAffect, PhraseAffect


def read_measured(path: Path) -> dict[str, Sequence[Delivery]]:
    """The deliveries that were measured, by name."""
    stored = json.loads(path.read_text(encoding="utf-8"))
    return {name: [_delivery(each) for each in deliveries] for name, deliveries in stored.items()}


def _delivery(stored: dict[str, Any]) -> Delivery:
    affect = stored["affect"]
    return Delivery(
        focus=tuple(stored["focus"]) if stored["focus"] is not None else None,
        affect=LineAffect(
            _affect(affect["line"]),
            tuple(PhraseAffect(each["first"], each["last"], _affect(each["affect"])) for each in affect["phrases"]),
        )
        if affect
        else None,
        loudness=stored["loudness"],
    )


def _affect(stored: dict[str, Any]) -> Affect:
    return Affect(stored["activation"], stored["valence"], stored["dominance"], tuple(stored["tones"]))
