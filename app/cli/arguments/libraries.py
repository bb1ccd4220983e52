"""The arguments of the commands that show, check and make authored resources: `rules`, `gestures`, `characters` and
`profiles`."""

from ...model import Hand, Level
from ...option_table import PERFORMANCE
from ..files import STANDARD, InputFile, OutputName
from .options import Adding, actions_of, add_options, add_output

PAIRS_HELP = "recordings with motion: NAME.bvh with NAME.wav, or NAME.npz; NAME.affect.csv beside them is their affect"


def add_rules(add: Adding) -> None:
    add_action = actions_of(add("rules", "check, list and explain rules, words, mappings and table entries"))
    check = add_action("check", "report every mistake in rules, words, characters, gestures and tables")
    check.add_argument("paths", metavar="PATH", nargs="*", help="files or folders (default: those that are in use)")
    check.add_argument("--watch", action="store_true", help="check again whenever they are saved, until interrupted")
    listing = add_action("list", "list them")
    listing.add_argument("--json", action="store_true", help="as JSON")
    explain = add_action("explain", "explain a rule, a behaviour, a word or a phrase")
    explain.add_argument("name", metavar="NAME", help="a rule, a behaviour, a word or a phrase")
    trace = add_action("trace", "show which rules fire on a text, which nearly do, and what those lack")
    trace.add_argument("--text", required=True, help="the words")
    trace.add_argument("--audio", metavar="FILE", type=InputFile, help="the recording of the words (default: none)")
    add_options(trace, PERFORMANCE, "character")
    trace.add_argument("--rule", metavar="NAME", help="only this rule: where it fires, or comes closest to firing")
    unused = add_action("unused", "report the rules and words that no line of a corpus uses")
    unused.add_argument(
        "corpus", metavar="CORPUS", help='a file with one utterance on each line, as text or as {"id", "text"}'
    )


def add_gestures(add: Adding) -> None:
    add_action = actions_of(add("gestures", "check, list, show and draw the gestures of the library"))
    check = add_action("check", "report every mistake in gestures")
    check.add_argument("paths", metavar="PATH", nargs="*", help="files or folders (default: the library in use)")
    listing = add_action("list", "list them")
    listing.add_argument("--json", action="store_true", help="as JSON")
    show = add_action("show", "show how a gesture is written, and its times at each level of agitation")
    show.add_argument("name", metavar="NAME", help="a gesture, a category, or a .gesture file")
    render = add_action("render", "draw the key poses of a gesture")
    render.add_argument("name", metavar="NAME", type=InputFile, help="a gesture, a category, or a .gesture file")
    add_output(render, "SHEET.png", "output file")
    render.add_argument(
        "--level",
        choices=[level.value for level in Level],
        default="medium",
        help="level of agitation (default medium)",
    )
    render.add_argument(
        "--hand", choices=[hand.value for hand in Hand], help="the hand that makes it (default: as written)"
    )


def add_characters(add: Adding) -> None:
    add_action = actions_of(add("characters", "list, show and draw the characters"))
    add_action("list", "list them")
    show = add_action("show", "show how a character moves and looks")
    show.add_argument("name", metavar="NAME")
    render = add_action("render", "draw the characters")
    render.add_argument("names", metavar="NAME", nargs="*", help="the characters to draw (default: all)")
    add_output(render, "FILE.png", "output file")


def add_profiles(add: Adding) -> None:
    add_action = actions_of(add("profiles", "learn, mix, list and show speakers' gesture profiles"))
    learn = add_action("learn", "learn a profile from annotated recordings of a speaker")
    formats = ".anvil, .eaf, .TextGrid, .csv or .json (docs/profiles.md)"
    learn.add_argument("files", metavar="FILE", nargs="+", type=InputFile, help=formats)
    learn.add_argument(
        "--description", metavar="TEXT", default="", help="description of the speaker, for profiles list"
    )
    add_output(learn, "P.yaml", "output file (default: standard output)", default=STANDARD)
    propose = add_action("propose", "draft an annotation of recorded motion, to be corrected in ELAN")
    propose.add_argument(
        "motion",
        metavar="MOTION.bvh",
        type=InputFile,
        nargs="?",
        help="the speaker's motion; without it phases, phrases and units are left to be annotated",
    )
    propose.add_argument(
        "--words", metavar="FILE", type=InputFile, help="an annotation with the words: .TextGrid, .eaf, …"
    )
    add_output(propose, "OUT.eaf", "output file: .eaf or .json")
    mix = add_action("mix", "mix two profiles")
    profile = "a profile's name, or its .yaml file"
    mix.add_argument("profiles", metavar="PROFILE", nargs=2, type=InputFile, help=profile)
    mix.add_argument(
        "--share", metavar="0…1", type=float, default=0.5, help="share of the second profile (default 0.5)"
    )
    add_output(mix, "P.yaml", "output file (default: standard output)", default=STANDARD)
    add_action("list", "list them")
    show = add_action("show", "show what is characteristic of a profile")
    show.add_argument("name", metavar="PROFILE", help=profile)


def add_motion_models(add: Adding) -> None:
    add_action = actions_of(
        add("motion-model", "train and score motion models, learnt from recordings of speech and motion")
    )
    train = add_action(
        "train", "train a model: kinds of movement, when they occur in speech, and the movements themselves"
    )
    train.add_argument("folder", metavar="FOLDER", help=PAIRS_HELP)
    train.add_argument(
        "--kinds", metavar="N", type=int, help="number of kinds of movement (default: as many as preserve affect)"
    )
    train.add_argument("--seed", type=int, default=0, help="random seed of the clustering (default 0)")
    add_output(train, "MODEL", "output file (.npz), for --motion-model")
    score = add_action("score", "compare a model's motion with recorded motion, leaving out each session in turn")
    score.add_argument("folder", metavar="FOLDER", help=PAIRS_HELP)
    score.add_argument(
        "--kinds", metavar="N", type=int, help="number of kinds of movement (default: as many as preserve affect)"
    )
    score.add_argument("--seed", type=int, default=0, help="random seed of the clustering (default 0)")
    help_text = "one of S1 … S6 or RTS (default: all); repeatable"
    score.add_argument("--scenario", metavar="S1…S6", action="append", default=[], help=help_text)
    score.add_argument(
        "--search",
        action="store_true",
        help="also measure the speed of RTS' searches and how similar their results are",
    )
    score.add_argument(
        "--plot", metavar="FILE", type=OutputName, help="also plot the results beside the papers', as PNG"
    )
    add_output(score, "OUT.json", "also write the figures as JSON", default="")
