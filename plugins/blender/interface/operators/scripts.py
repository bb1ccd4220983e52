"""Adds a script to the sequencer: a sound strip for each line, with its words and its speaker."""

from pathlib import Path
from typing import Any

import bpy
from bpy_extras.io_utils import ImportHelper

from ...scene.script_strips import lay_script
from ...scripts.reading import read_script, recordings


class ImportScript(bpy.types.Operator, ImportHelper):
    """Add the recordings of a script (CSV, SRT, Fountain) as sound strips with their words"""

    bl_idname = "understudy.import_script"
    bl_label = "Import Script"
    bl_options = {"REGISTER", "UNDO"}

    filename_ext = ".csv"
    filter_glob: bpy.props.StringProperty(default="*.csv;*.tsv;*.srt;*.fountain", options={"HIDDEN"})
    recordings: bpy.props.StringProperty(
        name="Recordings", subtype="DIR_PATH", description="The folder of the recordings; if empty, the script's own"
    )
    pause_s: bpy.props.FloatProperty(
        name="Pause", default=0.5, min=0, unit="TIME_ABSOLUTE", description="Time between lines without times"
    )

    def execute(self, context: Any) -> set[str]:
        script = Path(self.filepath)
        folder = Path(bpy.path.abspath(self.recordings)) if self.recordings else script.parent
        try:
            lines = read_script(script)
            messages = lay_script(context.scene, lines, recordings(lines, script, folder), self.pause_s)
        except (ValueError, OSError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        for each in messages:
            self.report({"WARNING"}, each)
        return {"FINISHED"}


CLASSES = (ImportScript,)
