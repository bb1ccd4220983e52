"""Performs a line and imports its motion, in the editor of Unreal 5 (plugin Python Editor Script Plugin).

    import understudy_unreal
    understudy_unreal.perform_and_import("D:/lines/line.wav", "No, I have never seen those.", "/Game/Lines")

The motion comes as GLB, with the skeleton and face of Understudy's own body or of an avatar, and is imported by
Interchange; it is put on your characters with an IK Retargeter. Without Unreal, `perform` and `realize` work anywhere.
"""

import json
import tempfile
import urllib.error
import urllib.request
import uuid
from collections.abc import Mapping
from pathlib import Path

URL = "http://127.0.0.1:8000"
LONGEST_WAIT_S = 300.0


class UnderstudyError(Exception):
    """The service refused, or none answered; the message says why."""


def perform_and_import(audio: str, text: str, folder: str, url: str = URL, api_key: str = "") -> list[str]:
    """Performs a recording and imports the motion into a folder of the project; the paths of the new assets."""
    import unreal  # only the editor has it

    recording = Path(audio)
    bml = perform(recording, text, url=url, api_key=api_key)
    with tempfile.TemporaryDirectory() as place:
        path = Path(place) / f"{recording.stem}.glb"
        path.write_bytes(realize(bml, recording, url=url, api_key=api_key))
        task = unreal.AssetImportTask()
        task.set_editor_property("filename", str(path))
        task.set_editor_property("destination_path", folder)
        task.set_editor_property("automated", True)
        task.set_editor_property("save", True)
        unreal.AssetToolsHelpers.get_asset_tools().import_asset_tasks([task])
        return [str(each) for each in task.get_editor_property("imported_object_paths")]


def perform(
    audio: Path, text: str, options: Mapping[str, object] | None = None, *, url: str = URL, api_key: str = ""
) -> str:
    """The BML of a recording (WAV, FLAC or OGG) and its words. Raises UnderstudyError."""
    fields = {"text": text, "options": json.dumps(options or {})}
    return str(json.loads(_posted(f"{url}/perform", fields, audio, "application/json", api_key))["bml"])


def realize(bml: str, audio: Path, *, url: str = URL, api_key: str = "") -> bytes:
    """The motion of BML as a GLB file. Raises UnderstudyError."""
    return _posted(f"{url}/realize", {"bml": bml}, audio, "model/gltf-binary", api_key)


def _posted(url: str, fields: Mapping[str, str], audio: Path, accept: str, api_key: str) -> bytes:
    boundary = uuid.uuid4().hex
    headers = {"Accept": accept, "Content-Type": f"multipart/form-data; boundary={boundary}"}
    if api_key:
        headers["Authorization"] = f"Bearer {api_key}"
    request = urllib.request.Request(url, _form(fields, audio, boundary), headers)
    try:
        with urllib.request.urlopen(request, timeout=LONGEST_WAIT_S) as answer:
            return bytes(answer.read())
    except urllib.error.HTTPError as error:
        raise UnderstudyError(_detail(error.read()) or str(error)) from None
    except urllib.error.URLError as error:
        raise UnderstudyError(f"no service answers at {url}: {error.reason}") from None


def _form(fields: Mapping[str, str], audio: Path, boundary: str) -> bytes:
    parts = [f'name="{name}"\r\n\r\n{value}'.encode() for name, value in fields.items()]
    parts.append(f'name="audio"; filename="{audio.name}"\r\n\r\n'.encode() + audio.read_bytes())
    head = f"--{boundary}\r\nContent-Disposition: form-data; ".encode()
    return b"".join(head + part + b"\r\n" for part in parts) + f"--{boundary}--\r\n".encode()


def _detail(body: bytes) -> str:
    try:
        return str(json.loads(body)["detail"])
    except (ValueError, KeyError, TypeError):
        return ""
