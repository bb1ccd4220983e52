"""The add-on's preferences: who performs."""

from typing import Any

import bpy
from bpy.props import EnumProperty, StringProperty

from ..performing.local_install import LocalInstall
from ..performing.requests import Connection, PerformingError
from ..performing.service import Service, is_local

PACKAGE = __package__.rpartition(".")[0]


class UnderstudyPreferences(bpy.types.AddonPreferences):
    """A service, or an install on this machine."""

    bl_idname = PACKAGE

    performer: EnumProperty(
        name="Perform By",
        items=[
            ("SERVICE", "Service", "A service at a URL (understudy serve)"),
            ("LOCAL", "Local Install", "The understudy command on this machine"),
        ],
    )
    url: StringProperty(name="URL", default="http://127.0.0.1:8000")
    key: StringProperty(name="Key", subtype="PASSWORD", description="The API key of the service")
    command: StringProperty(name="Command", default="understudy", subtype="FILE_PATH")

    def draw(self, _context: Any) -> None:
        column = self.layout.column()
        column.use_property_split = True
        column.row().prop(self, "performer", expand=True)
        for name in ("url", "key") if self.performer == "SERVICE" else ("command",):
            column.prop(self, name)


def preferences(context: Any) -> Any:
    return context.preferences.addons[PACKAGE].preferences


def connection(context: Any) -> Connection:
    """Whoever performs. Raises PerformingError where Blender may not use the network."""
    chosen = preferences(context)
    if chosen.performer == "LOCAL":
        return LocalInstall(bpy.path.abspath(chosen.command) if "//" in chosen.command[:2] else chosen.command)
    if not is_local(chosen.url) and not bpy.app.online_access:
        raise PerformingError("Blender may not go online: allow it in Preferences, System, or use a local install")
    return Service(chosen.url, chosen.key)
