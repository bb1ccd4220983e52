"""The arguments of the commands that take a line or a recording: `perform`, `realize` and the analyses."""

from ..distinct_files import InputFile, OutputFile
from ..files import STANDARD
from .command import Adding
from .shared import (
    AUDIO_HELP,
    MOTION_HELP,
    add_agitation,
    add_form,
    add_functions,
    add_line,
    add_manner,
    add_motion,
    add_output,
    add_reference,
    add_stillness,
    add_targets,
)


def add_perform(add: Adding) -> None:
    parser = add("perform", "perform one line: audio and words in, BML out")
    add_line(parser)
    add_functions(parser)
    parser.add_argument(
        "--direction", metavar="FILE", type=InputFile, help="a director's notes: what the body should mean where, JSON"
    )
    told = "what an author changed in the performance, made again: JSON (docs/edits.md)"
    parser.add_argument("--edits", metavar="FILE", type=InputFile, help=told)
    add_output(parser, "OUT.bml", "where the BML goes, OUT.json: as JSON (default: standard output)", default=STANDARD)
    add_manner(parser)
    add_reference(parser)
    parser.add_argument(
        "--listener", metavar="NAME", action="append", default=[], help="who listens; his BML goes to OUT.NAME.bml"
    )
    add_form(parser)
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
    add_motion(parser)


def add_script(add: Adding) -> None:
    parser = add("script", "what the hands do in a speaker's way, as a gesture script: JSON that realize plays")
    add_line(parser)
    add_functions(parser)
    parser.add_argument(
        "--profile", metavar="P", required=True, help="a gesture profile's name (see profiles list), or its .yaml file"
    )
    parser.add_argument("--character", metavar="NAME", default="default", help="who performs (see characters list)")
    add_agitation(parser)
    parser.add_argument("--seed", type=int, default=0, help="another number draws other gestures (default 0)")
    parser.add_argument(
        "--lead-in", metavar="SECONDS", type=float, default=0.0, help="begin that long before the recording (0 to 3)"
    )
    add_output(parser, "SCRIPT.json", "where the script goes (default: standard output)", default=STANDARD)


def add_realize(add: Adding) -> None:
    parser = add("realize", "BML in, motion out")
    parser.add_argument(
        "bml",
        metavar="FILE.bml",
        type=InputFile,
        help="BML 1.0 core or SmartBody's, or the gesture script of understudy script; - for standard input",
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
    add_agitation(parser)
    parser.add_argument(
        "--seed", type=int, help="another number chooses other variants (default: that of the performance, or 0)"
    )
    add_stillness(parser)
    add_targets(parser)
    add_motion(parser)


def add_live(add: Adding) -> None:
    parser = add("live", "speech as it comes, gestures as they are decided, without the words; one JSON object a line")
    heard = parser.add_mutually_exclusive_group(required=True)
    heard.add_argument("audio", metavar="FILE", type=InputFile, nargs="?", help=AUDIO_HELP)
    heard.add_argument("--microphone", action="store_true", help="hear the microphone (needs the extra `microphone`)")
    parser.add_argument(
        "--rate",
        metavar="HZ",
        type=int,
        help="FILE is raw: 16-bit little-endian samples, one channel, so many a second; from - as they come",
    )
    parser.add_argument("--frames", type=int, choices=(30, 60), help="tell the body's joints too, so often a second")
    parser.add_argument("--vmc", metavar="HOST:PORT", help="move an avatar there, as the sound is heard (port 39539)")
    parser.add_argument(
        "--vmc-face", choices=("presets", "arkit", "none"), default="presets", help="whose shapes of the face VMC has"
    )
    parser.add_argument("--vmc-without-head", action="store_true", help="leave neck, head and eyes to who tracks them")
    parser.add_argument("--character", metavar="NAME", default="default", help="who performs (see characters list)")
    parser.add_argument("--seed", type=int, default=0, help="another number chooses other movements (default 0)")
    add_output(parser, "OUT.jsonl", "where the lines go (default: standard output)", default=STANDARD)


def add_analyses(add: Adding) -> None:
    analyze = add("analyze", "what a line says and does, as JSON, before any movement is chosen")
    add_line(analyze)
    add_functions(analyze)
    add_agitation(analyze)
    add_reference(analyze)
    analyze.add_argument("--plot", metavar="FILE", type=OutputFile, help="draw it too, as PNG (needs the extra `plot`)")
    align = add("align", "words and phones in time")
    add_line(align)
    align.add_argument("--format", choices=("json", "textgrid", "ctm"), default="json")
    pitch = add("pitch", "pitch and energy every 10 ms")
    pitch.add_argument("audio", metavar="AUDIO", type=InputFile, help=AUDIO_HELP)
    pitch.add_argument("--format", choices=("csv",), default="csv")
    agitation = add("agitation", "the speaker's agitation, one JSON line a file")
    agitation.add_argument("audio", metavar="AUDIO", type=InputFile, nargs="+", help=AUDIO_HELP)
    add_reference(agitation)
    reference = add("reference", "how a speaker usually sounds, for --reference")
    spoken = "recordings of one speaker in his various moods"
    reference.add_argument("audio", metavar="AUDIO", type=InputFile, nargs="+", help=spoken)
    add_output(reference, "REF.json", "where it goes (default: standard output)", default=STANDARD)
    functions = add("functions", "what the words alone do; without --text, JSON lines in and out")
    functions.add_argument("--text", help='the words; without it, lines of {"id", "text"} from standard input')
