"""Recordings in the sequencer: what a sound strip plays, its words, and a recording placed as a strip."""

import tempfile
from pathlib import Path
from typing import Any

import bpy

READABLE = {".wav", ".flac", ".ogg"}
"""What Understudy reads as it is; everything else is written as WAV first."""

_RATE_HZ = 16_000


class NoRecordingError(ValueError):
    """A strip or file that cannot be performed; the message says why."""


def strips_of_scene(scene: Any) -> Any:
    """All strips of a sequencer, those inside meta strips too; they were called sequences before Blender 4.4."""
    editor = scene.sequence_editor
    if editor is None:
        return ()
    return editor.strips_all if hasattr(editor, "strips_all") else editor.sequences_all


def sound_strip(scene: Any, name: str) -> Any:
    """The sound strip of this name. Raises NoRecordingError."""
    found = next((each for each in strips_of_scene(scene) if each.name == name and each.type == "SOUND"), None)
    if found is None:
        raise NoRecordingError(f"the sequencer has no sound strip {name!r}: choose one, or a file")
    return found


def recording_of(scene: Any, strip: Any) -> Path:
    """A file with what the strip plays: its own, unless it is cut or of a kind that Understudy does not read."""
    path = _file_of(strip)
    if strip.frame_offset_start == 0 and strip.frame_offset_end == 0:
        return readable(path)
    rate_hz = frame_rate_hz(scene)
    start_s = strip.frame_offset_start / rate_hz
    return _written(path, start_s, start_s + strip.frame_final_duration / rate_hz)


def readable(path: Path) -> Path:
    """The file, or what it plays as WAV. Raises NoRecordingError."""
    if not path.is_file():
        raise NoRecordingError(f"there is no file {path}")
    return path if path.suffix.lower() in READABLE else _written(path)


def words_of(scene: Any, strip: Any) -> str:
    """The words of a strip: its custom property `text`, else what text strips say while it plays."""
    if strip.get("text"):
        return str(strip["text"])
    first, last = strip.frame_final_start, strip.frame_final_end
    texts = [each for each in strips_of_scene(scene) if each.type == "TEXT"]
    spoken = [each for each in texts if each.frame_final_start < last and first < each.frame_final_end]
    return " ".join(each.text for each in sorted(spoken, key=lambda each: float(each.frame_final_start)))


def place_sound(scene: Any, path: Path, frame: int, name: str) -> tuple[str, ...]:
    """Places a recording on the first channel that has room for it; why not, where this Blender plays no sounds."""
    try:
        place_strip(scene, path, frame, name)
    except NoRecordingError as error:
        return (str(error),)
    return ()


def place_strip(scene: Any, path: Path, frame: int, name: str, part_s: tuple[float, float] | None = None) -> Any:
    """A sound strip of a recording or a part of it (seconds), heard from `frame` on, on the first channel that has room
    for it. Raises NoRecordingError where this Blender cannot play it."""
    editor = scene.sequence_editor or scene.sequence_editor_create()
    strips = editor.strips if hasattr(editor, "strips") else editor.sequences
    try:
        strip = strips.new_sound(name, str(path), 1, frame)
    except RuntimeError as error:
        raise NoRecordingError(f"{path.name} was not placed: {error}") from None
    if part_s is not None:
        first, last = (round(each * frame_rate_hz(scene)) for each in part_s)
        strip.frame_offset_start = first
        strip.frame_offset_end = max(strip.frame_duration - last, 0)
        strip.frame_start = frame - first
    busy = {each.channel for each in strips if each != strip and _together(each, strip)}
    strip.channel = next(number for number in range(1, 129) if number not in busy)
    strip.show_waveform = True
    return strip


def frame_rate_hz(scene: Any) -> float:
    """Frames a second of a scene."""
    return float(scene.render.fps / scene.render.fps_base)


def _together(one: Any, other: Any) -> bool:
    return bool(one.frame_final_start < other.frame_final_end and other.frame_final_start < one.frame_final_end)


def _file_of(strip: Any) -> Path:
    """The strip's file; one that is packed into the blend is unpacked."""
    sound = strip.sound
    path = Path(bpy.path.abspath(sound.filepath, library=sound.library))
    if sound.packed_file is None:
        return path
    unpacked = _new_file(path.name)
    unpacked.write_bytes(sound.packed_file.data)
    return unpacked


def _written(path: Path, start_s: float = 0.0, end_s: float | None = None) -> Path:
    """A WAV file with a sound or a part of it."""
    try:
        import aud  # Blender may have been built without it
    except ImportError:
        raise NoRecordingError(
            f"this Blender converts no sounds: give {path.name} as WAV, FLAC or OGG, uncut"
        ) from None
    written = _new_file("recording.wav")
    try:
        sound = aud.Sound(str(path))
        part = sound if end_s is None else sound.limit(start_s, end_s)
        mono = part.rechannel(1).resample(_RATE_HZ, 4)
        mono.write(str(written), _RATE_HZ, 1, aud.FORMAT_S16, aud.CONTAINER_WAV, aud.CODEC_PCM)
    except aud.error as error:
        raise NoRecordingError(f"{path.name} cannot be read: {error}") from None
    return written


def _new_file(name: str) -> Path:
    """A file that stays for as long as Blender's own temporary files."""
    return Path(tempfile.mkdtemp(prefix="understudy-", dir=bpy.app.tempdir or None)) / name
