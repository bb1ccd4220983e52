"""What the page saves is what the command line writes; a project opens again as it was."""

import base64
import io
import json
import math
import zipfile
from collections.abc import Iterator
from pathlib import Path

import pytest
import soundfile
from playwright.sync_api import Page, expect

from tests.studio.support.tasks import FILM_PATIENCE_MS
from tests.support.python_page import ROOT
from understudy.cli.main import main

AUDIO, TEXT = ROOT / "examples/example.flac", ROOT / "examples/example.txt"


SHOWN = """
async (film) => {
  const bytes = Uint8Array.from(atob(film), (letter) => letter.charCodeAt(0));
  const video = document.createElement("video");
  video.src = URL.createObjectURL(new Blob([bytes], { type: "video/webm" }));
  const told = (name) => new Promise((resolve, reject) => {
    video.addEventListener(name, resolve, { once: true });
    video.addEventListener("error", () => reject(video.error), { once: true });
  });
  await told("loadeddata");
  const sought = told("seeked");
  video.currentTime = 0.1;
  await sought;
  const heard = await new OfflineAudioContext(1, 1, 48000).decodeAudioData(bytes.buffer);
  const size = [video.videoWidth, video.videoHeight];
  return { size, seconds: video.duration, sought_s: video.currentTime, heard_s: heard.duration };
}
"""


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with what the command line makes of the example."""
    folder = tmp_path_factory.mktemp("written")
    bml, trace = folder / "example.bml", folder / "example.json"
    line = [str(AUDIO), "--text-file", str(TEXT)]
    assert main(["perform", *line, "-o", str(bml), "--trace", str(trace), "--quiet"]) == 0
    (folder / "smartbody").mkdir()  # of its own, for what SmartBody wants beside the recording is called example.bml
    smartbody = ["--dialect", "smartbody", "-o", str(folder / "smartbody" / "line.bml")]
    assert main(["perform", *line, *smartbody, "--quiet"]) == 0
    (folder / "smartbody" / "line.bml").rename(folder / "example.smartbody.bml")
    motions = [f"-o{folder / f'example{ending}'}" for ending in (".glb", ".bvh", ".otio", ".csv")]
    assert main(["realize", str(bml), "--audio", str(AUDIO), *motions, "--quiet"]) == 0
    return folder


def _saved(page: Page, ending: str) -> bytes:
    page.click("#tab-exports")
    page.select_option("#format", ending)
    with page.expect_download() as download:
        page.click("#export")
    assert download.value.suggested_filename == f"example{ending}"
    return Path(download.value.path()).read_bytes()


def _made(page: Page, button: str) -> bytes:
    page.click("#tab-exports")
    with page.expect_download(timeout=FILM_PATIENCE_MS) as download:
        page.click(f"#exports button:has-text('{button}')")
    return Path(download.value.path()).read_bytes()


def _pictures_of(film: bytes) -> int:
    """How many blocks of its first track a film has (Matroska: a name, a size of eight bytes, the content)."""
    segment = dict(_elements(film))["18538067"]
    clusters = [content for name, content in _elements(segment) if name == "1f43b675"]
    blocks = [content for cluster in clusters for name, content in _elements(cluster) if name == "a3"]
    return sum(block[0] == 0x81 for block in blocks)


def _elements(content: bytes) -> Iterator[tuple[str, bytes]]:
    while content:
        wide = 9 - content[0].bit_length()
        size = int.from_bytes(content[wide : wide + 8], "big") & (1 << 56) - 1
        yield content[:wide].hex(), content[wide + 8 : wide + 8 + size]
        content = content[wide + 8 + size :]


@pytest.mark.parametrize("ending", [".bml", ".smartbody.bml", ".glb", ".bvh", ".csv"])
def test_bytes_are_those_of_the_command_line(looked_at: Page, written: Path, ending: str) -> None:
    assert _saved(looked_at, ending) == (written / f"example{ending}").read_bytes()


def test_the_performance_is_that_of_the_command_line(looked_at: Page, written: Path) -> None:
    assert json.loads(_saved(looked_at, ".json")) == json.loads((written / "example.json").read_bytes())


def test_a_project_has_all_and_opens_again(opened: Page, tmp_path: Path) -> None:
    opened.fill("#seed", "7")
    opened.press("#seed", "Enter")
    opened.wait_for_selector("#state:has-text('movements')")
    opened.click("#tab-taken")
    opened.click("#keep-version")
    kept = tmp_path / "kept.studio.zip"
    kept.write_bytes(_made(opened, "Project"))
    with zipfile.ZipFile(kept) as opened_zip:
        assert set(opened_zip.namelist()) == {"audio/example.flac", "text.txt", "options.json", "takes.json"}
        assert opened_zip.read("audio/example.flac") == AUDIO.read_bytes()
        assert json.loads(opened_zip.read("options.json")) == {"seed": 7}
    opened.goto("/")
    opened.set_input_files("#files", str(kept))
    opened.wait_for_selector("#state:has-text('7.18 s')")
    assert opened.input_value("#seed") == "7"
    opened.click("#tab-taken")
    assert opened.locator(".takes li").count() == 1


def test_stills_are_a_picture_of_the_strokes(looked_at: Page) -> None:
    assert _made(looked_at, "Still sheet").startswith(b"\x89PNG")


def test_a_film_shows_how_far_it_is_and_can_be_given_up(looked_at: Page) -> None:
    looked_at.click("#tab-exports")
    film = looked_at.locator("#exports button", has_text="Film")
    film.click()
    expect(looked_at.locator("#making progress")).to_be_visible()
    expect(film).to_be_disabled()
    looked_at.click("#cancel-export")
    expect(looked_at.locator("#exported")).to_have_text("Cancelled")
    expect(looked_at.locator("#making")).to_be_hidden()
    expect(film).to_be_enabled()
    expect(looked_at.locator("#problem")).to_be_hidden()


def test_a_film_has_each_frame_and_the_sound_and_frames_are_as_many(opened: Page, tmp_path: Path) -> None:
    samples, rate_hz = soundfile.read(AUDIO)
    short = tmp_path / "short.wav"
    soundfile.write(short, samples[: int(0.25 * rate_hz)], rate_hz)
    opened.goto("/")
    opened.set_input_files("#files", str(short))
    opened.fill("#text", "No.")
    opened.press("#text", "Tab")
    opened.wait_for_selector("#stage-canvas[data-roles='speaker']")
    seconds = opened.evaluate("document.querySelector('audio').duration")
    film = _made(opened, "Film")
    shown = opened.evaluate(SHOWN, base64.b64encode(film).decode())
    assert shown["size"] == [1920, 1080]
    assert shown["seconds"] == pytest.approx(seconds, abs=0.001)
    assert shown["sought_s"] == pytest.approx(0.1, abs=0.001)
    assert shown["heard_s"] == pytest.approx(seconds, abs=0.03)
    assert _pictures_of(film) == math.ceil(30 * seconds)
    with zipfile.ZipFile(io.BytesIO(_made(opened, "Frames"))) as frames:
        assert abs(len(frames.namelist()) - 30 * seconds) <= 1
        assert frames.read("00000.png").startswith(b"\x89PNG")
