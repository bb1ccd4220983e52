"""Understudy in Blender: performs a recorded line on an armature, and plays BML.

The add-on talks to Understudy over HTTP or by its command, and shares no code with it. What needs no Blender stands in
`retargeting` (another rig's bones), `performing` (the service, its answers) and `schedule` (BML and its strips), and
is tested without it; `scene` reads and writes Blender's data, `interface` has what is seen and pressed.
"""


def register() -> None:
    """Called by Blender when the add-on is switched on."""
    from .interface import registration

    registration.register()


def unregister() -> None:
    """Called by Blender when the add-on is switched off."""
    from .interface import registration

    registration.unregister()
