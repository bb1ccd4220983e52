"""The ten tasks for which people come to the studio (docs/studio-tasks.md), as steps on the page.

Each is begun on any page of the studio, and raises or times out where it cannot be done. `look(name)` is called after
each step, by whoever takes pictures of it.
"""

import shutil
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType

from playwright.sync_api import Page, ViewportSize, expect

from tests.studio.support.changing import performed, place_of, select
from tests.studio.support.serving import Theme
from tests.studio.support.waiting import wait_until
from understudy.files import resource_folder

WEBM = b"\x1a\x45\xdf\xa3"
FILM_PATIENCE_MS = 300_000
"""Every frame is drawn, by a processor in place of a graphics card: a busy machine takes long."""
PLAYED_S = "Number(document.querySelector('#stage-canvas').dataset.time)"


@dataclass(frozen=True, slots=True)
class Desk:
    """What a task is done with: the page, a scene that was performed, and a folder for one's own files."""

    page: Page
    scene: Path
    folder: Path
    look: Callable[[str], None]


def own_line(desk: Desk) -> None:
    """1. Perform a line of one's own."""
    page, example = desk.page, resource_folder("examples")
    files = [desk.folder / "my line.flac", desk.folder / "my line.txt"]
    for file in files:
        shutil.copyfile(example / f"example{file.suffix}", file)
    page.goto("/")
    expect(page.locator("#example")).to_be_visible()
    desk.look("start")
    page.set_input_files("#files", files)
    _ready(page)
    expect(page.locator("#project .title h2")).to_have_text("my line.flac")
    page.click("#play")
    wait_until(page, f"{PLAYED_S} > 0.5")
    page.click("#play")
    expect(page.locator("#play")).to_have_text("Play")
    desk.look("performed")


def moved_stroke(desk: Desk) -> None:
    """2. Move the stroke of a gesture to another word."""
    page = desk.page
    _example(page)
    select(page, "gesture NEGATION")
    field = page.locator("#selected input[data-mark=stroke]")
    before_s = float(field.input_value())
    desk.look("selected")
    drag_stroke(page, before_s, 1.6)
    expect(page.locator("#undo")).to_be_enabled()
    wait_until(page, "document.querySelector('#selected input[data-mark=stroke]').value > 1.4")
    performed(page)
    desk.look("moved")


def drag_stroke(page: Page, from_s: float, to_s: float) -> None:
    """Drags what is in the row of gestures at a time to another time, where the whole line is shown."""
    row = page.locator(".gutter [data-row=gesture]").bounding_box()
    canvas = page.locator("#timeline-canvas").bounding_box()
    assert row
    assert canvas
    start, end = (place_of(page, time_s, row["y"] - canvas["y"] + 8) for time_s in (from_s, to_s))
    page.mouse.move(*start)
    page.mouse.down()
    page.mouse.move(*end, steps=4)
    page.mouse.up()


def replaced_gesture(desk: Desk) -> None:
    """3. Replace a gesture by another."""
    page = desk.page
    _example(page)
    select(page, "gesture NEGATION")
    page.click("#replace")
    page.wait_for_selector("#gesture-browser canvas[data-played]")
    desk.look("choices")
    page.fill("#gesture-name", "stop")
    page.click("#gesture-browser button[data-lexeme=STOP]")
    expect(page.locator("#selected h3")).to_have_text("Stop")
    performed(page)
    desk.look("replaced")


def angrier(desk: Desk) -> None:
    """4. Make her angrier."""
    page = desk.page
    _example(page)
    page.select_option("#feeling", "angry")
    performed(page)
    page.get_by_label("Agitation").first.select_option("high")
    performed(page)
    expect(page.locator("#agitation option:checked")).to_have_text("Agitated")
    page.focus("#stage-canvas")
    for _half_second in range(2):
        page.keyboard.press("Shift+ArrowRight")
    wait_until(page, f"{PLAYED_S} === 1")
    desk.look("angry")


def compared_takes(desk: Desk) -> None:
    """5. Compare two takes."""
    page = desk.page
    _example(page)
    page.click("#tab-taken")
    page.click("#another-take")
    page.wait_for_selector("#stage-canvas[data-roles='speaker compared']")
    expect(page.locator(".name-tag").first).to_be_visible()
    expect(page.locator("#compared")).not_to_have_text("")
    desk.look("compared")


def listener(desk: Desk) -> None:
    """6. Have somebody listen."""
    page = desk.page
    _example(page)
    page.select_option("#listening", "beside")
    page.wait_for_selector("#stage-canvas[data-roles='speaker reserved']")
    page.select_option("#shot", "over_shoulder")
    performed(page)
    desk.look("listener")


def film(desk: Desk) -> None:
    """7. Take a film away, of a line that is not recorded yet."""
    page = desk.page
    page.goto("/")
    page.fill("#written", "No!")
    desk.look("written")
    page.click("#perform-written")
    _ready(page)
    page.click("#tab-exports")
    desk.look("exports")
    with page.expect_download(timeout=FILM_PATIENCE_MS) as saved:
        page.click("#exports button:has-text('Film')")
    assert Path(saved.value.path()).read_bytes().startswith(WEBM)
    desk.look("filmed")


def new_gesture(desk: Desk) -> None:
    """8. Compose a gesture of one's own."""
    page = desk.page
    page.goto("/")
    page.click("#views >> text=Gesture editor")
    page.wait_for_selector("#gesture-canvas[data-pose*='.']")
    desk.look("editor")
    pose = page.get_attribute("#gesture-canvas", "data-pose")
    page.click("#gesture_editor button:text-is('Far')")
    page.select_option("#hand-form", "form_flat")
    page.fill("#gesture-name", "my_gesture")
    page.press("#gesture-name", "Tab")
    expect(page.locator("#gesture-canvas")).not_to_have_attribute("data-pose", pose or "")
    wait_until(page, "document.querySelector('#gesture-text').value.includes('my_gesture')")
    desk.look("composed")
    with page.expect_download() as saved:
        page.click("#gesture-save")
    assert "GESTUREINSTANCE my_gesture" in Path(saved.value.path()).read_text()


def rule(desk: Desk) -> None:
    """9. Change a rule and see what it does."""
    page = desk.page
    _example(page)
    page.click("#views >> text=Rules")
    page.wait_for_selector("#rule-list li")
    desk.look("rules")
    page.fill("#rule-filter", "yes")
    page.click("#rule-list [data-name='yes']")
    wait_until(page, "document.querySelector('#rule-text').value.includes('      - yes\\n')")
    with page.expect_response("**/rules/check"):
        page.fill("#rule-text", page.input_value("#rule-text").replace("      - yes\n", "", 1))
    page.click("#rules-compare")
    page.wait_for_selector("#rules-compared .changed-line")
    desk.look("changes")


def table_read(desk: Desk) -> None:
    """10. Read a scene at the table."""
    page = desk.page
    page.goto("/")
    page.click("#views >> text=Table read")
    desk.look("choose")
    page.set_input_files("#scene-folder", desk.scene)
    page.wait_for_selector("#table-read-canvas[data-wrists]")
    page.click(".said:has-text('HENRY')")
    page.fill(".note >> nth=1", "Slower, and look up before “back”.")
    page.press(".note >> nth=1", "Tab")
    desk.look("scene")
    page.get_by_role("button", name="Open in Line: two").click()
    _ready(page)
    expect(page.locator("#project .title h2")).to_contain_text("two")
    desk.look("opened")


def _example(page: Page) -> None:
    page.goto("/")
    page.click("#example")
    _ready(page)
    if page.is_hidden("#items"):
        page.click("#list")


def _ready(page: Page) -> None:
    page.wait_for_selector("#stage-canvas[data-roles='speaker']")


TASKS: Mapping[str, Callable[[Desk], None]] = MappingProxyType(
    {
        task.__name__: task
        for task in (
            own_line,
            moved_stroke,
            replaced_gesture,
            angrier,
            compared_takes,
            listener,
            film,
            new_gesture,
            rule,
            table_read,
        )
    }
)
"""By name, in the order of the list."""

LOOKS: Mapping[str, tuple[ViewportSize, Theme]] = MappingProxyType(
    {
        "large-light": ({"width": 1440, "height": 900}, "light"),
        "small-dark": ({"width": 1024, "height": 700}, "dark"),
        "large-dark": ({"width": 1440, "height": 900}, "dark"),
        "small-light": ({"width": 1024, "height": 700}, "light"),
    }
)
"""The sizes and themes in which they are done."""
