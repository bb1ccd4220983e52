"""Rules at hand: found, explained, edited with the checker's messages, tried on the line and on all examples."""

from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.studio.support.accessibility import serious_findings
from tests.studio.support.waiting import wait_until

AFFIRMATION = "lexicon/en/affirmation.yaml"


@pytest.fixture
def rules(opened: Page) -> Page:
    opened.click("#views >> text=Rules")
    opened.wait_for_selector("#rule-list li")
    return opened


def _choose(page: Page, name: str, kind: str) -> None:
    page.select_option("#rule-kind", kind)
    page.fill("#rule-filter", name)
    page.click(f"#rule-list [data-name='{name}']")
    shown = "({ disabled, value }, name) => !disabled && value.includes(name)"
    wait_until(page, f"({shown})(document.querySelector('#rule-text'), {name!r})")


def _edit(page: Page, before: str, after: str) -> None:
    text = page.input_value("#rule-text")
    assert before in text
    with page.expect_response("**/rules/check"):
        page.fill("#rule-text", text.replace(before, after, 1))


def test_a_rule_is_found_and_explained_and_its_file_is_shown_at_its_line(rules: Page) -> None:
    """Before that there is nothing to try."""
    assert rules.is_hidden("#rules-run")
    _choose(rules, "show_affirmation", "behavior")
    assert rules.is_visible("#rules-run")
    assert "agreement.rules:" in rules.inner_text("#rule-file")
    rules.wait_for_selector("#rule-explained pre")
    assert "Big nod" in rules.inner_text("#rule-explained")
    start = rules.evaluate("document.querySelector('#rule-text').selectionStart")
    assert rules.input_value("#rule-text")[start:].startswith("rule show_affirmation")


def test_an_edited_word_changes_examples_and_the_diff_is_shown(rules: Page) -> None:
    _choose(rules, "yes", "word")
    _edit(rules, "      - yes\n", "")
    with rules.expect_response("**/rules/compare"):
        rules.click("#rules-compare")
    rules.wait_for_selector("#rules-compared .changed-line")
    told = rules.inner_text("#rules-compared")
    assert " lines change" in told
    assert "is no longer read as a yes" in told
    technical = rules.get_attribute("#rules-compared .gone >> nth=0", "title") or ""
    assert technical.endswith("priority 5 (affirmation_word)")
    rules.click("#rules-back")
    assert rules.is_disabled("#rules-compare")
    assert "      - yes\n" in rules.input_value("#rule-text")


def test_a_mistake_shows_its_line_and_wrong_rules_cannot_be_run(rules: Page) -> None:
    _choose(rules, "show_affirmation", "behavior")
    _edit(rules, "big_nod(", "bigger_nod(")
    rules.wait_for_selector("#rule-mistakes .wrong")
    text = rules.input_value("#rule-text")
    line = text[: text.index("bigger_nod(")].count("\n") + 1
    assert f"agreement.rules:{line}:" in rules.inner_text("#rule-mistakes")
    assert rules.is_disabled("#rules-run")
    assert rules.is_disabled("#rules-compare")
    rules.click("#rule-mistakes button")
    start = rules.evaluate("document.querySelector('#rule-text').selectionStart")
    assert text[start:].startswith("bigger_nod(")


def test_an_edited_rule_changes_the_line_and_undo_takes_it_back(rules: Page) -> None:
    """The rules that the line's functions rest on are renamed: what is performed says so."""
    with rules.expect_response("**/perform") as first:
        rules.click("#views >> text=Line")
        rules.click("#stage-canvas")
        rules.fill("#seed", "1")
        rules.press("#seed", "Tab")
    before = first.value.json()["performance"]["functions"]
    rule = before[0]["rule"]
    rules.click("#views >> text=Rules")
    _choose(rules, rule, "function")
    _edit(rules, f"rule {rule}\n", "rule renamed_here\n")
    with rules.expect_response("**/perform") as edited:
        rules.click("#rules-run")
    assert "renamed_here" in {function["rule"] for function in edited.value.json()["performance"]["functions"]}
    with rules.expect_response("**/perform") as undone:
        rules.click("#undo")
    assert [each["rule"] for each in undone.value.json()["performance"]["functions"]] == [
        each["rule"] for each in before
    ]


def test_nothing_is_saved_by_a_service_without_a_folder_for_it(rules: Page) -> None:
    _choose(rules, "yes", "word")
    assert rules.is_hidden("#rules-save")
    root = Path(__file__).parents[3]
    assert "- yes" in (root / AFFIRMATION).read_text(encoding="utf-8")


def test_a_reason_leads_to_its_rule(opened: Page) -> None:
    opened.click("#items li[title*='gesture'] >> nth=0")
    opened.click("#numbers > summary")
    link = opened.locator("#reasons button.link", has_text="_").first
    name = link.inner_text()
    link.click()
    expect(opened.locator("#rules")).to_be_visible(timeout=1000)
    opened.wait_for_selector("#rules:not([hidden]) #rule-explained h2")
    assert (opened.get_attribute("#rule-explained h2 >> nth=0", "title") or "?") in name


def test_nobody_stumbles_over_the_rules(rules: Page) -> None:
    """A word with what its loss changes in examples, then a rule with a mistake."""
    _choose(rules, "yes", "word")
    _edit(rules, "      - yes\n", "")
    rules.click("#rules-compare")
    rules.wait_for_selector("#rules-compared .changed-line")
    assert serious_findings(rules) == []
    _choose(rules, "show_affirmation", "behavior")
    _edit(rules, "big_nod(", "bigger_nod(")
    rules.wait_for_selector("#rule-mistakes .wrong")
    assert serious_findings(rules) == []
