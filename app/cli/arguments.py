"""The arguments of every command."""

import argparse
from collections.abc import Callable
from functools import partial
from typing import NoReturn

from ..bml.markup.documents import DialectName, TimeForm
from ..errors import InputError
from ..model import Hand, Level, Mode
from ..motion_formats import Keys
from ..realizer.body.motion import FRAME_RATES_HZ
from ..version import __version__
from .batch_arguments import add_batch
from .distinct_files import InputFile, OutputFile
from .files import STANDARD

Adding = Callable[[str, str], argparse.ArgumentParser]
"""Adds a command, given its name and what it does."""

MOTION_HELP = ".bvh, .glb, .vrma, .json, .csv (ARKit), .visemes.txt, .png (contact sheet) or .speed.png (wrist speeds)"
LARGEST_PORT = 65535
AUDIO_HELP = "WAV, FLAC or OGG file; - for standard input"


class _Parser(argparse.ArgumentParser):
    """Argparse that tells a mistake as every other mistake is told, and takes no abbreviations."""

    def error(self, message: str) -> NoReturn:
        raise InputError("usage", f"{message}; see {self.prog} --help")


def make_parser() -> argparse.ArgumentParser:
    """The parser of the whole command line; it raises InputError `usage`."""
    parser = _Parser(
        prog="understudy",
        description="Performs a spoken line in an actor's stead: audio and words in, BML out.",
        parents=[_voices()],
        allow_abbrev=False,
    )
    parser.add_argument("--version", action="version", version=__version__)
    add = partial(_add, parser.add_subparsers(dest="command", metavar="COMMAND", required=True).add_parser)
    _add_perform(add)
    _add_realize(add)
    add_batch(add, _add_manner, _add_form, _add_rate)
    _add_analyses(add)
    _add_rules(add)
    _add_gestures(add)
    _add_characters(add)
    _add_serve(add)
    return parser


def _add(add_parser: Callable[..., argparse.ArgumentParser], name: str, does: str) -> argparse.ArgumentParser:
    return add_parser(name, help=does, description=does, parents=[_voices()], allow_abbrev=False)


def _voices() -> argparse.ArgumentParser:
    """`--quiet` and `--json-log`, before or after the command's name; `understudy.cli.log` looks for them."""
    parser = argparse.ArgumentParser(add_help=False)
    voice = parser.add_mutually_exclusive_group()
    voice.add_argument("--quiet", action="store_true", help="say nothing on standard error but errors")
    voice.add_argument("--json-log", action="store_true", help="one JSON object a line on standard error")
    return parser


def _add_perform(add: Adding) -> None:
    parser = add("perform", "perform one line: audio and words in, BML out")
    _add_line(parser)
    _add_functions(parser)
    parser.add_argument(
        "--direction", metavar="FILE", type=InputFile, help="a director's notes: what the body should mean where, JSON"
    )
    parser.add_argument(
        "-o",
        "--output",
        metavar="OUT.bml",
        type=OutputFile,
        default=STANDARD,
        help="where the BML goes, OUT.json: as JSON (default: standard output)",
    )
    _add_manner(parser)
    _add_reference(parser)
    parser.add_argument(
        "--listener", metavar="NAME", action="append", default=[], help="who listens; his BML goes to OUT.NAME.bml"
    )
    _add_form(parser)
    parser.add_argument(
        "--trace", metavar="FILE", type=OutputFile, help="write the whole performance as JSON: every reason"
    )
    parser.add_argument(
        "--realize",
        metavar="FILE",
        type=OutputFile,
        action="append",
        default=[],
        help=f"the motion itself: {MOTION_HELP}; repeatable",
    )
    _add_motion(parser)


def _add_manner(parser: argparse.ArgumentParser) -> None:
    """How lines are performed."""
    parser.add_argument("--character", metavar="NAME", default="default", help="who performs (see characters list)")
    _add_agitation(parser)
    parser.add_argument("--seed", type=int, default=0, help="another number chooses other movements (default 0)")
    modes = [mode.value for mode in Mode]
    parser.add_argument(
        "--mode", choices=modes, default="semantic", help="gestures from the meaning, the stress, or chance"
    )
    parser.add_argument(
        "--lead-in",
        metavar="SECONDS",
        type=float,
        default=0.0,
        help="begin that long before the recording, so that the first words' gestures have time (0 to 3, default 0)",
    )
    _add_stillness(parser)
    _add_targets(parser)


def _add_realize(add: Adding) -> None:
    parser = add("realize", "BML in, motion out")
    parser.add_argument(
        "bml", metavar="FILE.bml", type=InputFile, help="BML 1.0 core or SmartBody's; - for standard input"
    )
    parser.add_argument(
        "--audio", metavar="AUDIO", type=InputFile, help="the recording of its speech, for lips and words"
    )
    parser.add_argument(
        "-o",
        "--output",
        metavar="OUT",
        type=OutputFile,
        action="append",
        required=True,
        help=f"{MOTION_HELP}; repeatable",
    )
    parser.add_argument("--character", metavar="NAME", help="who moves (default: whom the BML names)")
    _add_agitation(parser)
    parser.add_argument(
        "--seed", type=int, help="another number chooses other variants (default: that of the performance, or 0)"
    )
    _add_stillness(parser)
    _add_targets(parser)
    _add_motion(parser)


def _add_motion(parser: argparse.ArgumentParser) -> None:
    _add_rate(parser)
    parser.add_argument(
        "--avatar", metavar="FILE", type=InputFile, help="your own GLB or VRM, to wear the motion in .glb"
    )
    parser.add_argument(
        "--tail",
        metavar="SECONDS",
        type=float,
        default=0.0,
        help="go on so long after the recording, so that the hands come to rest (0 to 10, default 0)",
    )
    parser.add_argument("--t-pose", action="store_true", help="begin .bvh with a frame in the T-pose")
    parser.add_argument(
        "--root-at-origin", action="store_true", help="OFFSET 0 of the root in .bvh, for readers that add it: three.js"
    )
    keys = [each.value for each in Keys]
    told = "of .glb: one in every frame, or few that can be edited, with markers (default baked)"
    parser.add_argument("--keys", choices=keys, default="baked", help=told)


def _add_rate(parser: argparse.ArgumentParser) -> None:
    rates = FRAME_RATES_HZ
    parser.add_argument("--fps", type=int, choices=rates, default=max(rates), help="frames a second of the motion")
    parser.add_argument(
        "--skeleton", metavar="NAME", help="whose names joints go by (default: mixamo in BVH, vrm in JSON)"
    )


def _add_targets(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--target",
        metavar="NAME=X,Y,Z",
        action="append",
        default=[],
        help="where something or somebody is, to look and point at, such as door=1.2,1.4,2.0: metres, Y up, the "
        "character at 0,0,0 facing +Z, its left +X; repeatable",
    )


def _add_stillness(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--stillness",
        metavar="0…1",
        type=float,
        default=0.0,
        help="how much less than usual moves; at 1 only breath, blinks and lips (default 0)",
    )


def _add_form(parser: argparse.ArgumentParser) -> None:
    timings = [timing.value for timing in TimeForm]
    parser.add_argument(
        "--timing", choices=timings, default="absolute", help="times in seconds, or from the marks of the speech (sync)"
    )
    dialects = [dialect.value for dialect in DialectName]
    parser.add_argument(
        "--dialect", choices=dialects, default="bml", help="BML 1.0 core, or SmartBody's with lip sync (default bml)"
    )


def _add_analyses(add: Adding) -> None:
    analyze = add("analyze", "what a line says and does, as JSON, before any movement is chosen")
    _add_line(analyze)
    _add_functions(analyze)
    _add_agitation(analyze)
    _add_reference(analyze)
    analyze.add_argument("--plot", metavar="FILE", type=OutputFile, help="draw it too, as PNG (needs the extra `plot`)")
    align = add("align", "words and phones in time")
    _add_line(align)
    align.add_argument("--format", choices=("json", "textgrid", "ctm"), default="json")
    pitch = add("pitch", "pitch and energy every 10 ms")
    pitch.add_argument("audio", metavar="AUDIO", type=InputFile, help=AUDIO_HELP)
    pitch.add_argument("--format", choices=("csv",), default="csv")
    agitation = add("agitation", "the speaker's agitation, one JSON line a file")
    agitation.add_argument("audio", metavar="AUDIO", type=InputFile, nargs="+", help=AUDIO_HELP)
    _add_reference(agitation)
    reference = add("reference", "how a speaker usually sounds, for --reference")
    spoken = "recordings of one speaker in his various moods"
    reference.add_argument("audio", metavar="AUDIO", type=InputFile, nargs="+", help=spoken)
    target = "where it goes (default: standard output)"
    reference.add_argument("-o", "--output", metavar="REF.json", type=OutputFile, default=STANDARD, help=target)
    functions = add("functions", "what the words alone do; without --text, JSON lines in and out")
    functions.add_argument("--text", help='the words; without it, lines of {"id", "text"} from standard input')


def _add_line(parser: argparse.ArgumentParser) -> None:
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
    parser.set_defaults(functions=None, direction=None)


def _add_functions(parser: argparse.ArgumentParser) -> None:
    told = "what words do that you know already: a JSON list"
    parser.add_argument("--functions", metavar="FILE", type=InputFile, help=told)


def _add_agitation(parser: argparse.ArgumentParser) -> None:
    levels = [level.value for level in Level]
    parser.add_argument(
        "--agitation", choices=levels, help="how agitated the speaker is (default: as the voice sounds)"
    )


def _add_reference(parser: argparse.ArgumentParser) -> None:
    told = "other recordings of the speaker in various moods, or the REF.json that understudy reference made of them"
    parser.add_argument("--reference", metavar="FILE", type=InputFile, nargs="+", action="extend", help=told)


def _add_rules(add: Adding) -> None:
    actions = add("rules", "the rules, words, mappings and table entries").add_subparsers(
        dest="action", metavar="ACTION", required=True
    )
    check = _add(actions.add_parser, "check", "tell every mistake in rules, words, characters, gestures and tables")
    check.add_argument("paths", metavar="PATH", nargs="*", help="files or folders (default: those that are in use)")
    check.add_argument("--watch", action="store_true", help="check again whenever they are saved, until interrupted")
    listing = _add(actions.add_parser, "list", "list them")
    listing.add_argument("--json", action="store_true", help="as JSON")
    explain = _add(actions.add_parser, "explain", "what one of them does")
    explain.add_argument("name", metavar="NAME", help="a rule, a behaviour, a word or a phrase")
    trace = _add(actions.add_parser, "trace", "which rules a text makes fire, and which nearly, for want of what")
    trace.add_argument("--text", required=True, help="the words")
    trace.add_argument("--rule", metavar="NAME", help="only this rule: where it fires, or comes nearest")
    unused = _add(actions.add_parser, "unused", "rules and words that no line of a corpus uses")
    unused.add_argument("corpus", metavar="CORPUS", help='a file with an utterance a line, or {"id", "text"} a line')


def _add_gestures(add: Adding) -> None:
    actions = add("gestures", "the library of gestures").add_subparsers(dest="action", metavar="ACTION", required=True)
    check = _add(actions.add_parser, "check", "tell every mistake in gestures")
    check.add_argument("paths", metavar="PATH", nargs="*", help="files or folders (default: the library in use)")
    listing = _add(actions.add_parser, "list", "list them")
    listing.add_argument("--json", action="store_true", help="as JSON")
    show = _add(actions.add_parser, "show", "how one of them is written, and its times at each level of agitation")
    show.add_argument("name", metavar="NAME", help="a gesture, a category, or a .gesture file")
    render = _add(actions.add_parser, "render", "draw the key poses of one of them")
    render.add_argument("name", metavar="NAME", type=InputFile, help="a gesture, a category, or a .gesture file")
    target = "where the picture goes"
    render.add_argument("-o", "--output", metavar="SHEET.png", type=OutputFile, required=True, help=target)
    render.add_argument("--level", choices=[level.value for level in Level], default="medium", help="of agitation")
    render.add_argument("--hand", choices=[hand.value for hand in Hand], help="which makes it (default: as written)")


def _add_characters(add: Adding) -> None:
    actions = add("characters", "who can perform").add_subparsers(dest="action", metavar="ACTION", required=True)
    _add(actions.add_parser, "list", "list them")
    show = _add(actions.add_parser, "show", "show how one of them moves and looks")
    show.add_argument("name", metavar="NAME")
    render = _add(actions.add_parser, "render", "draw what they look like")
    render.add_argument("names", metavar="NAME", nargs="*", help="who is drawn (default: all)")
    render.add_argument(
        "-o", "--output", metavar="FILE.png", type=OutputFile, required=True, help="where the picture goes"
    )


def _add_serve(add: Adding) -> None:
    parser = add("serve", "answer over HTTP")
    parser.add_argument("--host", help="address to listen on (default: UNDERSTUDY_HOST, else 127.0.0.1)")
    parser.add_argument("--port", type=_port, help="port to listen on (default: UNDERSTUDY_PORT, else 8000)")
    parser.add_argument("--reload", action="store_true", help="read rules, words and characters again when saved")


def _port(text: str) -> int:
    if not text.isdecimal() or int(text) > LARGEST_PORT:
        raise argparse.ArgumentTypeError(f"{text!r} is not a port, which is a number from 0 to {LARGEST_PORT}")
    return int(text)
