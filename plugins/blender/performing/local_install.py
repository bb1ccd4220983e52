"""Performs by the command of an Understudy installed on this machine, a process a request."""

import json
import subprocess
import tempfile
import threading
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

from ..motion.clip import Clip, read_clip
from .requests import Cancellation, CancelledError, Json, Line, Performed, PerformingError, Progress, Remark, Sheet
from .still import still_bml

_POLL_S = 0.05


@dataclass(frozen=True, slots=True)
class LocalInstall:
    """The command, a path or a name to be looked for."""

    command: str

    def perform(self, line: Line, progress: Progress, cancelled: Cancellation) -> Performed:
        """A line to BML."""
        with tempfile.TemporaryDirectory(prefix="understudy-") as name:
            folder = Path(name)
            text, bml, trace = folder / "line.txt", folder / "line.bml", folder / "line.json"
            text.write_text(line.text, encoding="utf-8")
            arguments = [str(line.audio), "--text-file", str(text), "-o", str(bml), "--trace", str(trace)]
            if line.edits is not None:
                edits = folder / "edits.json"
                edits.write_text(json.dumps(line.edits), encoding="utf-8")
                arguments += ["--edits", str(edits)]
            warnings = self._run(["perform", *arguments, *_options(line.options)], progress, cancelled)
            names = [each.partition("=")[0] for each in line.options.get("listener", ())]
            listeners = {who: (folder / f"line.{who}.bml").read_bytes() for who in names}
            return Performed(bml.read_bytes(), json.loads(trace.read_bytes()), warnings, listeners)

    def realize(self, sheet: Sheet, progress: Progress, cancelled: Cancellation) -> Clip:
        """BML to motion."""
        return read_clip(self._realized(sheet, "line.json", progress, cancelled))

    def mannequin(self, character: str) -> bytes:
        """A character's own body as GLB."""
        return self._realized(Sheet(still_bml(character)), "body.glb", lambda _stage: None, lambda: False)

    def _realized(self, sheet: Sheet, output: str, progress: Progress, cancelled: Cancellation) -> bytes:
        with tempfile.TemporaryDirectory(prefix="understudy-") as name:
            bml, written = Path(name) / "line.bml", Path(name) / output
            bml.write_bytes(sheet.bml)
            audio = ["--audio", str(sheet.audio)] if sheet.audio else []
            arguments = ["realize", str(bml), *audio, "-o", str(written), *_options(sheet.options)]
            self._run(arguments, progress, cancelled)
            return written.read_bytes()

    def _run(self, arguments: Sequence[str], progress: Progress, cancelled: Cancellation) -> tuple[Remark, ...]:
        """Runs the command, reports its stages, and ends it when the job is cancelled; returns its warnings."""
        try:
            process = subprocess.Popen(
                [self.command, *arguments, "--json-log"],
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.PIPE,
                encoding="utf-8",
            )
        except OSError as error:
            message = f"{self.command} cannot be run ({error.strerror}): name Understudy's command in the preferences"
            raise PerformingError(message) from None
        with process:
            events: list[Json] = []
            reader = threading.Thread(target=_read, args=(process.stderr or (), events, progress), daemon=True)
            reader.start()
            while _runs(process):
                if cancelled():
                    process.kill()
                    raise CancelledError
            reader.join()
        if process.returncode:
            raise PerformingError(_why(events) or f"{self.command} ended with code {process.returncode}")
        warnings = (each for each in events if each["event"] == "warning")
        return tuple(Remark(each.get("code", ""), each["message"].removeprefix("warning: ")) for each in warnings)


def _runs(process: "subprocess.Popen[str]") -> bool:
    try:
        process.wait(_POLL_S)
    except subprocess.TimeoutExpired:
        return True
    return False


def _read(lines: Iterable[str], events: list[Json], progress: Progress) -> None:
    for line in lines:
        try:
            event = json.loads(line)
        except ValueError:
            event = {"event": "error", "message": line.strip()}
        events.append(event)
        if event["event"] == "stage":
            progress(event["stage"])


def _why(events: Sequence[Json]) -> str:
    return next((each["message"] for each in reversed(events) if each["event"] == "error"), "")


def _options(options: Json) -> list[str]:
    """The options of a request as those of the command line, which go by nearly the same names."""
    found: list[str] = []
    for name, value in options.items():
        flag = "--" + name.removesuffix("_s").replace("_", "-")
        if name == "targets":
            for target, place in value.items():
                found += ["--target", f"{target}={','.join(format(part, '.6g') for part in place)}"]
        elif isinstance(value, (list, tuple)):
            found += [part for each in value for part in (flag, str(each))]
        elif value is not None:
            found += [flag, str(value)]
    return found
