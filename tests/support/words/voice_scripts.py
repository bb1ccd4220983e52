"""Three scripts as studios send them, of our own writing: a sheet from Windows with a title, a workbook of acts, and a
screenplay."""

import io
from collections.abc import Mapping

from openpyxl import Workbook

SHEET = """\
Projekt: Brückenwache;;;;
Stand 3. Mai, Regie: A. Wolf;;;;
;;;;
Line #;Character;Line;Delivery;Take
VO_001;Zoë;You can't cross here. Not tonight.;calm;2
VO_002;SÄNGERIN;And who will stop me – you?;laughs;
VO_003;Zoë;If I have to.;;1
;;;;
VO_004;Jörg Müller;Let her pass, Zoë.;tired;
""".encode("cp1252")
"""Separated by semicolons, in the encoding of Windows, with a title and empty rows; the words are under "Line"."""

SCREENPLAY = """\
Title: The Watch

INT. BRIDGE - NIGHT

ZOË
(not moving)
You can't cross here.

SÄNGERIN (CONT'D)
Then sing with me.

EXT. RIVER BANK - DAY

JÖRG MÜLLER
There was no bridge.
"""


Rows = list[list[object]]


def acts() -> bytes:
    """A workbook with a cover, two acts of the same headings, and a sheet of prices."""
    headings: list[object] = ["ID", "Character", "Line"]
    first: Rows = [headings, ["A1_01", "Zoë", "You can't cross here."], ["A1_02", "Ben", "Watch me."]]
    second: Rows = [headings, ["A2_01", "Zoë", "I told you."], ["A1_02", "Ben", "Twice."], ["A2_03", "Ben"]]
    cover: Rows = [["Bridge Watch"], ["recorded at", "Studio B"]]
    return workbook({"Info": cover, "Act 1": first, "Act 2": second, "Budget": [["Who", "Hours"], ["Zoë", 3]]})


def workbook(pages: Mapping[str, Rows]) -> bytes:
    """A workbook of these sheets."""
    book = Workbook()
    book.remove(book.worksheets[0])
    for title, rows in pages.items():
        sheet = book.create_sheet(title)
        for row in rows:
            sheet.append(row)
    content = io.BytesIO()
    book.save(content)
    return content.getvalue()
