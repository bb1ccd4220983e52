"""Registers the add-on's classes with Blender, and takes them out in the opposite order."""

from typing import Any

import bpy

from . import panels, properties
from .operators import CLASSES as OPERATORS
from .preferences import UnderstudyPreferences

_CLASSES = (UnderstudyPreferences, *OPERATORS, *panels.CLASSES)


def register() -> None:
    properties.register()
    for each in _CLASSES:
        bpy.utils.register_class(each)
    bpy.types.TOPBAR_MT_file_import.append(_import_entry)
    bpy.types.TOPBAR_MT_file_export.append(_export_entry)


def unregister() -> None:
    bpy.types.TOPBAR_MT_file_export.remove(_export_entry)
    bpy.types.TOPBAR_MT_file_import.remove(_import_entry)
    for each in reversed(_CLASSES):
        bpy.utils.unregister_class(each)
    properties.unregister()


def _import_entry(menu: Any, _context: Any) -> None:
    menu.layout.operator("understudy.import_bml", text="Behavior Markup Language (.bml, .xml)")
    menu.layout.operator("understudy.import_script", text="Script of Spoken Lines (.csv, .srt, .fountain)")


def _export_entry(menu: Any, _context: Any) -> None:
    menu.layout.operator("understudy.export_bml", text="Behavior Markup Language (.bml)")
    menu.layout.operator("understudy.export_otio", text="Understudy Timeline (.otio)")
