"""A motion's sync points and decisions as JSON, for programs that play it."""

from ..body.motion import Motion
from .gltf import Json


def events_json(motion: Motion) -> dict[str, Json]:
    """The sync points by BML id, in seconds from the first frame, which is at `audio_offset_s` of the audio (negative
    with a lead-in), and the decisions."""
    start_s = float(motion.body.times_s[0])
    return {
        "frame_rate_hz": motion.frame_rate_hz,
        "audio_offset_s": round(start_s - motion.lead_in_s, 6),
        "events": [
            {"behavior": event.behavior, "point": event.point, "time_s": round(event.time_s - start_s, 6)}
            for event in motion.events()
        ],
        "decisions": [
            {"behavior": each.behavior, "action": each.action, "reason": each.reason} for each in motion.decisions
        ],
    }
