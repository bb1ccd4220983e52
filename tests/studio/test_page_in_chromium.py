"""The page as a whole: what it says of mistakes, keys, and to those who do not see it."""

from pathlib import Path

from playwright.sync_api import Page, expect

from tests.studio.support.accessibility import serious_findings


def test_a_wrong_file_shows_the_services_own_words(opened: Page, tmp_path: Path) -> None:
    """What was there goes as another recording is opened; the page says what is missing, then what is wrong."""
    wrong = tmp_path / "song.wav"
    wrong.write_bytes(b"This is a letter.")
    opened.set_input_files("#files", str(wrong))
    opened.wait_for_selector("#state:has-text('Type the words that are spoken in song.wav.')")
    opened.wait_for_selector("#stage-canvas[data-roles='']")
    assert opened.locator("#items li").count() == 0
    assert opened.is_hidden("#timeline-canvas")
    opened.fill("#text", "No, never.")
    opened.press("#text", "Tab")
    told = opened.wait_for_selector("#problem code")
    assert told
    assert told.inner_text() == "audio_format_unsupported"
    assert "wav" in opened.inner_text("#problem").lower()
    opened.fill("#text", "")
    opened.press("#text", "Tab")
    opened.wait_for_selector("#problem", state="hidden")
    opened.click("#open-another")
    opened.click("#example")
    opened.wait_for_selector("#stage-canvas[data-roles='speaker']")


def test_a_new_line_is_typed_at_once_and_nothing_is_said_to_be_heard(opened: Page) -> None:
    opened.click("#new-line")
    expect(opened.locator("#written")).to_be_focused()
    opened.fill("#written", "No, I have never seen them!")
    opened.click("#perform-written")
    expect(opened.locator("#project h2").first).to_have_text("No, I have never…")
    expect(opened.locator("#agitation option").first).to_contain_text("By itself: ")


def test_a_body_that_is_none_is_told_and_ours_stays(looked_at: Page, tmp_path: Path) -> None:
    wrong = tmp_path / "body.glb"
    wrong.write_bytes(b"no body")
    looked_at.set_input_files("#files", str(wrong))
    looked_at.wait_for_selector(
        "#problem:has-text('body.glb is not a body in GLB or VRM: it does not begin with “glTF”')"
    )
    expect(looked_at.locator("#project button:has-text('Use the default body')")).to_be_hidden()


def test_a_zip_that_is_no_project_is_told(page: Page, tmp_path: Path) -> None:
    wrong = tmp_path / "other.zip"
    wrong.write_bytes(b"PK")
    page.goto("/")
    page.set_input_files("#files", str(wrong))
    page.wait_for_selector("#problem:has-text('other.zip is not a zip that can be opened')")


def test_gestures_are_those_of_a_profile_and_another_name_is_told(opened: Page) -> None:
    opened.fill("#profile", "sweepng")
    opened.press("#profile", "Tab")
    opened.wait_for_selector("#problem:has-text('sweeping')")
    opened.fill("#profile", "sweeping")
    with opened.expect_response("**/perform") as answered:
        opened.press("#profile", "Tab")
    assert answered.value.ok
    opened.wait_for_selector("#problem", state="hidden")


def test_the_views_are_changed_by_keyboard(looked_at: Page) -> None:
    looked_at.focus("#views button:has-text('Rules')")
    looked_at.keyboard.press("Enter")
    assert looked_at.is_visible("main#rules") or looked_at.get_attribute("main#rules", "hidden") is None
    assert not looked_at.is_visible("main#line")


def test_nothing_serious_is_in_the_way_of_anybody(page: Page) -> None:
    """An empty page, one that tells a problem, and everything that the side of a line can show."""
    page.goto("/")
    assert serious_findings(page) == []
    page.click("#example")
    page.wait_for_selector("#stage-canvas[data-roles='speaker']")
    page.fill("#profile", "sweepng")
    page.press("#profile", "Tab")
    page.wait_for_selector("#problem code")
    page.click("#items li[title*='gesture NEGATION']")
    assert serious_findings(page) == []
    page.fill("#profile", "")
    page.press("#profile", "Tab")
    page.select_option("#listening", "beside")
    page.wait_for_selector("#stage-canvas[data-roles='speaker reserved']")
    page.click("#alternatives")
    for each in ("li.dropped >> nth=0", "li[title^='functions'] >> nth=0", "li[title='word lights']"):
        page.click(f"#items {each}")
        assert serious_findings(page) == []
    page.click("#add-gesture")
    page.wait_for_selector("#gesture-browser canvas[data-played]")
    assert serious_findings(page) == []


def test_every_view_fits_a_small_screen(opened: Page) -> None:
    """At 1024 × 700 nothing is cut off at the side; what a view is for is in reach, and why something is there."""
    opened.set_viewport_size({"width": 1024, "height": 700})
    opened.click("#items li[title*='gesture NEGATION']")
    for selector in ("#why", "#mute", "#replace", "#play"):
        assert _bottom(opened, selector) <= 700, selector
    primary = {"Gesture editor": "#gesture-save", "Rules": "#rules-run", "Table read": "#table_read .file.primary"}
    for view, selector in primary.items():
        opened.click(f"#views >> text='{view}'")
        if view == "Rules":
            opened.click(".beginnings button >> nth=0")
        opened.wait_for_selector(selector)
        assert opened.evaluate("document.documentElement.scrollWidth") <= 1024
        assert _bottom(opened, selector) <= 700, view


def _bottom(page: Page, selector: str) -> float:
    """How far down something ends that is whole in the width of the page."""
    box = page.locator(selector).bounding_box()
    assert box
    assert box["x"] >= 0
    assert box["x"] + box["width"] <= 1024
    return box["y"] + box["height"]
