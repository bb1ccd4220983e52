"""Panels are drawn on a layout that checks what they ask for: every property and operator must be there."""

import importlib
from pathlib import Path
from typing import Any

import pytest

from tests.plugins.blender.in_blender.conftest import ADDON
from tests.plugins.blender.in_blender.tracks import id_of

Bpy = Any


class Layout:
    """Stands in for Blender's layout, of which a Blender without windows has none."""

    def __init__(self, bpy: Bpy, drawn: list[str]) -> None:
        self.bpy, self.drawn = bpy, drawn

    def prop(self, owner: Any, name: str, **_look: Any) -> None:
        assert name in owner.bl_rna.properties, f"{owner} has no {name}"
        self.drawn.append(name)

    def prop_search(self, owner: Any, name: str, among: Any, collection: str, **_look: Any) -> None:
        self.prop(owner, name)
        assert hasattr(among, collection)

    def operator(self, name: str, **_look: Any) -> Any:
        group, _, short = name.partition(".")
        found = getattr(getattr(self.bpy.ops, group), short)
        self.drawn.append(name)
        return type("Settings", (), {})() if found.get_rna_type() else None

    def template_list(
        self, kind: str, _id: str, owner: Any, items: str, active_owner: Any, active: str, **_look: Any
    ) -> None:
        assert hasattr(self.bpy.types, kind)
        assert items in owner.bl_rna.properties
        assert active in active_owner.bl_rna.properties
        self.drawn.append(items)

    def label(self, text: str = "", **_look: Any) -> None:
        self.drawn.append(text)

    def progress(self, factor: float, text: str, **_look: Any) -> None:
        assert 0 <= factor <= 1
        self.drawn.append(text)

    def row(self, **_look: Any) -> "Layout":
        return Layout(self.bpy, self.drawn)

    column = box = split = row


def drawn(blender: Bpy, name: str) -> list[str]:
    """What a panel shows now."""
    panel = getattr(importlib.import_module(f"{ADDON}.interface.panels"), name)
    found: list[str] = []
    panel.draw(type("Panel", (), {"layout": Layout(blender, found)})(), blender.context)
    return found


@pytest.mark.parametrize("name", ["LineView3D", "LineSequencer", "Scene", "Bones"])
def test_panels_of_an_empty_scene(blender: Bpy, name: str) -> None:
    assert drawn(blender, name)


def test_what_is_under_way_is_shown_with_a_cross(blender: Bpy) -> None:
    state = blender.context.window_manager.understudy
    state.running, state.stage, state.done = True, "align", 0.5
    shown = drawn(blender, "LineView3D")
    state.running = False
    assert "align" in shown
    assert "understudy.cancel" in shown
    assert "understudy.perform" not in shown


def test_a_performance_and_its_selected_strips_are_shown_with_their_reasons(
    blender: Bpy, mannequin: Bpy, line: Bpy
) -> None:
    assert line.text
    blender.ops.understudy.perform()
    for track in mannequin.animation_data.nla_tracks:
        for strip in track.strips:
            strip.select = id_of(strip) == "gesture1"
    shown = drawn(blender, "Performances")
    assert "gesture: negation (right hand)" in shown
    assert any("negation by" in text for text in shown)
    assert {"understudy.play_strips", "understudy.export_bml", "understudy.forget"} <= set(shown)
    assert {"character", "profile", "seed"} <= set(drawn(blender, "LineView3D"))


def test_bones_are_listed_once_they_are_found(blender: Bpy, mannequin: Bpy) -> None:
    assert mannequin.name
    assert "bones" not in drawn(blender, "Bones")
    blender.ops.understudy.find_bones()
    assert "bones" in drawn(blender, "Bones")


def test_preferences_ask_for_a_url_or_a_command(blender: Bpy, extension: Path) -> None:
    assert extension.exists()
    chosen = blender.context.preferences.addons[ADDON].preferences
    draw = importlib.import_module(f"{ADDON}.interface.preferences").UnderstudyPreferences.draw
    for performer, names in (("SERVICE", {"url", "key"}), ("LOCAL", {"command"})):
        found: list[str] = []
        stub = type(
            "Preferences", (), {"layout": Layout(blender, found), "performer": performer, "bl_rna": chosen.bl_rna}
        )
        draw(stub(), blender.context)
        assert names <= set(found)
