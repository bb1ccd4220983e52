"""The options of a performance and of a motion, each once: name, type, range, default and help.

Every door takes its own from these tables: the command line its arguments (`cli/arguments/options.py`), the service and
the Python interface the fields of a request (`schemas/options.py`). Where a type must be written out for a type checker
or in another language (the keywords of `library`, the panels of the studio and of Blender), a test compares it
(`tests/test_option_table.py`).
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType

from .errors import InputError
from .model import DEFAULT_CHARACTER, Level, Mode, Tone
from .model.formats import BapVersion, DialectName, Keys, TimeForm, VisemeNames

LARGEST_SEED = 2**63 - 1
MOST_LISTENERS = 16

Value = str | int | float | bool | None | tuple[str, ...] | Mapping[str, tuple[float, float, float]]
"""The value of an option in a request."""


@dataclass(frozen=True, slots=True)
class Option:
    """An option, with the name that it has in requests and in Python.

    `help` is a sentence without capital and full stop. `kind` is the type of its value, or of each of several; a value
    of None means `unset`. `limits` are the least and the greatest number, `choices` all values there are.
    `default_told` replaces the default in help texts.

    On the command line it is called `flag` (by default its name with hyphens) and `metavar` stands for its value;
    `command_help` and `request_help` are what only users of the command line or of requests need to know.
    """

    name: str
    help: str
    kind: type[str] | type[int] | type[float] | type[bool] = str
    default: Value = None
    unset: str = ""
    limits: tuple[float, float] | None = None
    choices: tuple[str | int, ...] = ()
    flag: str = ""
    metavar: str | None = None
    default_told: str = ""
    command_help: str = ""
    request_help: str = ""
    examples: tuple[object, ...] = ()

    @property
    def argument(self) -> str:
        """The option on the command line, with its hyphens."""
        return f"--{self.flag or self.name.replace('_', '-')}"

    def told_in_command(self) -> str:
        """The help on the command line, with the range and the default."""
        default_text = self.default_told
        if not default_text and isinstance(self.default, (str, int, float)) and not isinstance(self.default, bool):
            default_text = f"{self.default:g}" if isinstance(self.default, float) else str(self.default)
        default = f"default: {self.unset}" if self.unset else f"default {default_text}" if default_text else ""
        limits = "{:g} to {:g}".format(*self.limits) if self.limits and self.kind is float else ""
        remarks = ", ".join(part for part in (limits, default) if part)
        return f"{self.help}{self.command_help}" + (f" ({remarks})" if remarks else "")

    def told_in_request(self) -> str:
        """The description in the interface description of the service."""
        sentence = f"{self.help[0].upper()}{self.help[1:]}{self.request_help}."
        return sentence + (f" Omitted or null: {self.unset}." if self.unset else "")

    def check(self, value: float) -> None:
        """Raises InputError `value_wrong` for a number outside the range."""
        if self.limits and not self.limits[0] <= value <= self.limits[1]:
            message = f"{self.name}: {value:g}; give {self.limits[0]:g} to {self.limits[1]:g}: {self.help}"
            raise InputError("value_wrong", message, field=self.name)


def _table(options: Iterable[Option]) -> Mapping[str, Option]:
    return MappingProxyType({option.name: option for option in options})


_CHARACTER = Option(
    "character",
    "the performing character",
    default=DEFAULT_CHARACTER,
    default_told="`default`",
    metavar="NAME",
    command_help=", see characters list",
    request_help=", one of `GET /characters`",
    examples=("reserved",),
)
_AGITATION = Option(
    "agitation",
    "the speaker's level of agitation",
    choices=tuple(Level),
    unset="as measured in the voice",
    examples=("high",),
)
_SEED = Option(
    "seed",
    "random seed; every value gives another take",
    int,
    0,
    limits=(-LARGEST_SEED, LARGEST_SEED),
    default_told="0, the best",
    request_help="; 0 is the best one",
    examples=(7,),
)
_STILLNESS = Option(
    "stillness",
    "reduce all movement; at 1 only breathing, blinks and lips remain",
    float,
    0.0,
    limits=(0, 1),
    metavar="0…1",
)
_TARGETS = Option(
    "targets",
    "where something or somebody is, to look and point at: metres, Y up, the character at 0,0,0 facing +Z, its left +X",
    float,
    MappingProxyType({}),
    flag="target",
    metavar="NAME=X,Y,Z",
    command_help="; such as door=1.2,1.4,2.0; repeatable",
    examples=({"door": (1.2, 1.4, 2.0)},),
)

PERFORMANCE = _table(
    (
        _CHARACTER,
        _AGITATION,
        _SEED,
        Option(
            "choice",
            "how movements are chosen: by weighted terms, or by priority as in the paper",
            choices=("terms", "priority"),
            unset="as the character or UNDERSTUDY_CHOICE says",
        ),
        Option(
            "reference",
            "how the speaker usually sounds",
            metavar="FILE",
            unset="as an average speaker",
            command_help=": other recordings in various moods, or the REF.json that understudy reference made of them",
            request_help=": what `understudy reference` writes",
        ),
        Option("mode", "source of gestures: meaning, stress or chance", default=Mode.SEMANTIC, choices=tuple(Mode)),
        Option(
            "listener",
            "name of a listener, with =CHARACTER if its character has another name",
            default=(),
            metavar="NAME[=CHARACTER]",
            command_help="; the listener's BML goes to OUT.NAME.bml (.xml for OUT.xml); repeatable",
            request_help="; each listener has BML of its own, in JSON responses only",
        ),
        Option(
            "dialect",
            "BML 1.0 core, or SmartBody's with lip sync",
            default=DialectName.BML,
            choices=tuple(DialectName),
        ),
        Option(
            "timing",
            "times in seconds, or as sync points of the speech",
            default=TimeForm.ABSOLUTE,
            choices=tuple(TimeForm),
        ),
        Option(
            "visemes",
            "viseme names used in SmartBody's files",
            default=VisemeNames.SMARTBODY,
            choices=tuple(VisemeNames),
        ),
        Option(
            "bmlt_audio",
            "add an element to BML 1.0 that makes ASAP play the recording; strict readers reject it",
            bool,
            False,
        ),
        Option(
            "lead_in_s",
            "seconds by which the performance begins before the recording, so that the first gestures have time",
            float,
            0.0,
            limits=(0, 3),
            flag="lead-in",
            metavar="SECONDS",
        ),
        _STILLNESS,
        _TARGETS,
        Option(
            "profile",
            "gesture profile to use, by name",
            metavar="P",
            unset="the character's own",
            command_help=" (see profiles list), or its .yaml file",
            examples=("sweeping",),
        ),
        Option("contours", "add f0 and energy every 10 ms to JSON", bool, False),
        Option(
            "affect",
            f"the feeling in the voice: a tone ({', '.join(Tone)}), activation, valence and dominance from -1 to 1, or "
            "a track of these",
            unset="as heard",
            metavar="TONE|A,V,D|FILE.csv",
            command_help=" as CSV (time_s,activation,valence,dominance)",
            request_help=" with their times, rows of [time_s, activation, valence, dominance]",
            examples=("sad", (0.6, -0.5, 0.3)),
        ),
    )
)
"""How a line is performed and its BML is written, by name."""

MOTION = _table(
    (
        replace(_AGITATION, unset="as recorded in the BML, or as measured in the voice"),
        replace(
            _CHARACTER,
            help="the character that moves",
            default=None,
            default_told="",
            unset="the character named in the BML",
        ),
        Option("fps", "frames per second of the motion", int, 60, choices=(30, 60)),
        replace(
            _SEED,
            help="random seed for the choice of variants",
            default=None,
            default_told="",
            request_help="",
            unset="that of the performance, or 0",
        ),
        Option(
            "skeleton",
            "the rig whose joint names are used",
            metavar="NAME",
            unset="mixamo in BVH, vrm in JSON",
            examples=("mixamo", "vrm"),
        ),
        _STILLNESS,
        _TARGETS,
        Option(
            "tail_s",
            "seconds of motion after the recording, in which the hands come to rest",
            float,
            0.0,
            limits=(0, 10),
            flag="tail",
            metavar="SECONDS",
        ),
        Option(
            "physics",
            "move with momentum: arms swing, wrists overshoot (needs understudy[physics])",
            bool,
            unset="as UNDERSTUDY_PHYSICS says",
        ),
        Option("t_pose", "begin BVH with a frame in the T-pose", bool, False),
        Option(
            "root_at_origin",
            "give the root of BVH an OFFSET of zero, for readers that add it, such as three.js",
            bool,
            False,
        ),
        Option(
            "keys",
            "keyframes of GLB: one in every frame, or a few that can be edited, with markers",
            default=Keys.BAKED,
            choices=tuple(Keys),
        ),
        Option(
            "bap_version",
            "version of BAP and FAP files: MPEG-4's (3.1), or Greta's (2.1), whose signs and order differ",
            default=BapVersion.MPEG4,
            choices=tuple(BapVersion),
        ),
    )
)
"""How BML is played and motion files are written, by name."""
