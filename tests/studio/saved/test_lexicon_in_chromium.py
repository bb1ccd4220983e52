"""What authors write on the page is saved into their folder (`--lexicon DIR`), in place."""

import json
from pathlib import Path

from playwright.sync_api import Browser, expect

from tests.studio.conftest import opened_page
from tests.studio.support.waiting import wait_until
from tests.support.served import served
from understudy.api.workers.processes import Nursery


def test_what_is_written_and_a_new_character_are_saved_in_the_folder(
    browser: Browser, nursery: Nursery, tmp_path: Path
) -> None:
    folder = tmp_path / "own"
    folder.mkdir()
    with served(nursery, author_folder=folder) as running, opened_page(browser, running.url) as page:
        page.goto("/")
        page.click("#views >> text=Gesture editor")
        page.wait_for_selector("#gesture-canvas[data-pose*='.']")
        page.fill("#gesture-name", "my_own")
        page.press("#gesture-name", "Tab")
        page.click("#gesture-save")
        expect(page.locator("#gesture-saved")).to_contain_text("gestures/my_own.gesture")
        [saved] = folder.rglob("my_own.gesture")
        assert "GESTUREINSTANCE my_own" in saved.read_text(encoding="utf-8")
        page.click("#views >> text=Rules")
        for name, of, before, after in (
            ("yes", "word", "      - yes\n", ""),
            ("weights", "file", "terms:\n", "# Mine.\nterms:\n"),
        ):
            page.select_option("#rule-kind", of)
            page.fill("#rule-filter", name)
            page.click(f"#rule-list [data-name='{name}']")
            wait_until(page, f"document.querySelector('#rule-text').value.includes({json.dumps(before)})")
            with page.expect_response("**/rules/check"):
                page.fill("#rule-text", page.input_value("#rule-text").replace(before, after, 1))
            with page.expect_response(lambda response: response.request.method == "PUT") as answered:
                page.click("#rules-save")
            assert answered.value.ok, answered.value.text()
        page.click("text=New character…")
        page.fill("#character-name", "old_sailor")
        page.select_option(".new-character select", "lexicon/characters/reserved.yaml")
        page.click("#character-make")
        wait_until(page, "document.querySelector('#rule-text').value.includes('description: Says much')")
        with page.expect_response(lambda response: response.request.method == "PUT") as answered:
            page.click("#rules-save")
        assert answered.value.ok, answered.value.text()
        [sailor] = folder.rglob("characters/old_sailor.yaml")
        assert "height_m: 1.90" in sailor.read_text(encoding="utf-8")
        [words] = folder.rglob("affirmation.yaml")
        assert "      - yes\n" not in words.read_text(encoding="utf-8")
        [weights] = folder.rglob("weights.yaml")
        assert "# Mine." in weights.read_text(encoding="utf-8")
