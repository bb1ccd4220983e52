"""What a motion is of, for programs that play it: when each behaviour's sync points fall, and what was decided."""

from ..body.motion import Motion
from .gltf import Json


def described(motion: Motion) -> dict[str, Json]:
    """Events by BML id, in seconds from the first frame, which is at `audio_offset_s` of the audio (before
    it, with a lead-in); and decisions."""
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
