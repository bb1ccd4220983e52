"""Options that several commands take."""

import argparse

from ...model import Level, Mode, Tone
from ...model.formats.bml_form import DialectName, TimeForm, VisemeNames
from ...model.formats.motion_formats import BapVersion, Keys
from ...realizer.body.motion import FRAME_RATES_HZ
from ..distinct_files import InputFile, OutputFile

MOTION_HELP = (
    ".bvh, .glb, .vrma, .json, .csv (ARKit), .visemes.txt, .usda, .usdc, .usdz, .fbx (by Blender), .otio, "
    ".TextGrid, .eaf, .events.csv, .bap, .fap, "
    ".png (contact sheet) or .speed.png (wrist speeds)"
)
AUDIO_HELP = "WAV, FLAC or OGG file; - for standard input"


def add_manner(parser: argparse.ArgumentParser) -> None:
    """How lines are performed."""
    parser.add_argument("--character", metavar="NAME", default="default", help="who performs (see characters list)")
    add_agitation(parser)
    add_affect(parser)
    parser.add_argument("--seed", type=int, default=0, help="another number draws another take (default 0, the best)")
    add_choice(parser)
    parser.add_argument(
        "--profile", metavar="P", help="whose gestures: a profile's name (see profiles list), or its .yaml file"
    )
    modes = [mode.value for mode in Mode]
    parser.add_argument(
        "--mode", choices=modes, default="semantic", help="gestures from the meaning, the stress, or chance"
    )
    parser.add_argument(
        "--lead-in",
        metavar="SECONDS",
        type=float,
        default=0.0,
        help="begin this long before the recording, so that the first words' gestures have time (0 to 3, default 0)",
    )
    add_stillness(parser)
    add_targets(parser)


def add_motion(parser: argparse.ArgumentParser) -> None:
    add_rate(parser)
    parser.add_argument("--avatar", metavar="FILE", type=InputFile, help="your own GLB or VRM, to be animated in .glb")
    parser.add_argument(
        "--tail",
        metavar="SECONDS",
        type=float,
        default=0.0,
        help="go on this long after the recording, so that the hands come to rest (0 to 10, default 0)",
    )
    parser.add_argument("--t-pose", action="store_true", help="begin .bvh with a frame in the T-pose")
    parser.add_argument(
        "--root-at-origin", action="store_true", help="OFFSET 0 of the root in .bvh, for readers that add it: three.js"
    )
    versions = [each.value for each in BapVersion]
    told = "who plays .bap: players of MPEG-4 (3.1), or Greta (2.1), with other signs and order (default 3.1)"
    parser.add_argument("--bap-version", choices=versions, default=BapVersion.MPEG4.value, help=told)
    keys = [each.value for each in Keys]
    told = "of .glb: one in every frame, or few that can be edited, with markers (default baked)"
    parser.add_argument("--keys", choices=keys, default="baked", help=told)


def add_rate(parser: argparse.ArgumentParser) -> None:
    rates = FRAME_RATES_HZ
    parser.add_argument("--fps", type=int, choices=rates, default=max(rates), help="frames a second of the motion")
    parser.add_argument(
        "--skeleton", metavar="NAME", help="the rig whose joint names are used (default: mixamo in BVH, vrm in JSON)"
    )
    told = "move with momentum: arms swing, wrists overshoot (needs understudy[physics])"
    parser.add_argument("--physics", action=argparse.BooleanOptionalAction, help=told)


def add_targets(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--target",
        metavar="NAME=X,Y,Z",
        action="append",
        default=[],
        help="where something or somebody is, to look and point at, such as door=1.2,1.4,2.0: metres, Y up, the "
        "character at 0,0,0 facing +Z, its left +X; repeatable",
    )


def add_choice(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--choice",
        choices=("terms", "priority"),
        help="how movements are chosen: the one choice, or the paper's by priority (default: as the character or "
        "UNDERSTUDY_CHOICE says)",
    )


def add_stillness(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--stillness",
        metavar="0…1",
        type=float,
        default=0.0,
        help="reduce movement; at 1 only breath, blinks and lips are left (default 0)",
    )


def add_form(parser: argparse.ArgumentParser) -> None:
    timings = [timing.value for timing in TimeForm]
    parser.add_argument(
        "--timing", choices=timings, default="absolute", help="times in seconds, or as sync points of the speech (sync)"
    )
    dialects = [dialect.value for dialect in DialectName]
    parser.add_argument(
        "--dialect", choices=dialects, default="bml", help="BML 1.0 core, or SmartBody's with lip sync (default bml)"
    )
    names = [name.value for name in VisemeNames]
    parser.add_argument(
        "--visemes", choices=names, default="smartbody", help="the names of visemes for SmartBody (default: its own)"
    )
    parser.add_argument(
        "--bmlt-audio",
        action="store_true",
        help="in BML 1.0, add an element with which ASAP plays the recording; strict readers refuse it",
    )


def add_line(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("audio", metavar="AUDIO", type=InputFile, help=AUDIO_HELP)
    text = parser.add_mutually_exclusive_group(required=True)
    text.add_argument("--text", help="the words that are spoken")
    text.add_argument(
        "--text-file", metavar="FILE", type=InputFile, help="a file that holds them; - for standard input"
    )
    parser.add_argument(
        "--words",
        metavar="FILE",
        type=InputFile,
        help="the words' times, made elsewhere: .json, .TextGrid or .ctm; nothing is aligned",
    )
    parser.set_defaults(functions=None, direction=None, edits=None)


def add_functions(parser: argparse.ArgumentParser) -> None:
    told = "communicative functions that you know already: a JSON list"
    parser.add_argument("--functions", metavar="FILE", type=InputFile, help=told)


def add_agitation(parser: argparse.ArgumentParser) -> None:
    levels = [level.value for level in Level]
    parser.add_argument(
        "--agitation", choices=levels, help="how agitated the speaker is (default: as the voice sounds)"
    )


def add_affect(parser: argparse.ArgumentParser) -> None:
    tones = ", ".join(Tone)
    told = (
        f"how the voice sounds: a tone ({tones}), activation,valence,dominance from -1 to 1, or a track as CSV "
        "(time_s,activation,valence,dominance) (default: as heard)"
    )
    parser.add_argument("--affect", metavar="TONE|A,V,D|FILE.csv", help=told)


def add_reference(parser: argparse.ArgumentParser) -> None:
    told = "other recordings of the speaker in various moods, or the REF.json that understudy reference made of them"
    parser.add_argument("--reference", metavar="FILE", type=InputFile, nargs="+", action="extend", help=told)


def add_output(parser: argparse.ArgumentParser, metavar: str, told: str, *, default: str | None = None) -> None:
    """Adds the option for the output file, which is required if there is no default."""
    needed = default is None
    parser.add_argument("-o", "--output", metavar=metavar, type=OutputFile, required=needed, default=default, help=told)
