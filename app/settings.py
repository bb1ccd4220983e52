"""The settings of an operator, from the environment (`UNDERSTUDY_…`); docs/settings.md lists them all."""

import os
import sys
from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Literal

from pydantic import BaseModel, ConfigDict, Field, SecretStr, ValidationError, field_validator, model_validator

from .authored_folders import layers_of
from .errors import InputError, did_you_mean
from .model.limits import MotionLimits

PREFIX = "UNDERSTUDY_"

PART_BYTES: Mapping[str, int] = MappingProxyType(
    {
        "audio": 32 << 20,
        "reference": 32 << 20,
        "text": 100_000,
        "options": 256 << 10,
        "words": 4 << 20,
        "functions": 1 << 20,
        "direction": 2 << 20,
        "rules": 1 << 20,
        "edits": 512 << 10,
        "profile": 256 << 10,
        "bml": 2 << 20,
        "avatar": 32 << 20,
        "motion_model": 64,
        "scenario": 64,
        "json": 512 << 10,
        "live": 256 << 10,
    }
)
"""The most bytes of each part of a form, of a JSON body and of a message of a live stream, unless `part_bytes` says
otherwise."""

CLOSEABLE = ("metrics", "docs", "studio")
MOST_FRAMES_PER_S = 60
"""The frames of the longest motion that is answered."""

_REMOVED: Mapping[str, str] = MappingProxyType(
    {
        **{f"max_{part}_bytes": f"set {PREFIX}PART_BYTES={part}=BYTES" for part in PART_BYTES if part != "live"},
        "max_text_characters": "20,000 characters are accepted",
        "live_message_bytes": f"set {PREFIX}PART_BYTES=live=BYTES",
        "live_message_s": f"a message may take a sixth of {PREFIX}DEADLINE_S",
        "live_streams_per_caller": f"a key may have three quarters of {PREFIX}LIVE_STREAMS",
        **dict.fromkeys(CLOSEABLE, f"list it in {PREFIX}CLOSED to turn it off"),
        **dict.fromkeys(("min_sample_rate_hz", "max_sample_rate_hz"), "8000 to 192000 Hz are accepted"),
        "max_channels": "8 are accepted",
        "max_motion_behaviors": "1000 are played",
        "max_motion_frames": f"set {PREFIX}MAX_MOTION_S, of which each second has {MOST_FRAMES_PER_S}",
        "max_motion_bytes": "32 MiB are answered",
        "worker_jobs": "workers are replaced after 1000 requests",
        "header_s": f"headers may take twice {PREFIX}IDLE_S",
    }
)
"""Settings of former versions, and what to do instead."""


class Settings(BaseModel):
    """Limits and places; the limits hold for the command line and the service alike. Fields that are not given are read
    from the environment."""

    model_config = ConfigDict(defer_build=True, frozen=True, extra="ignore")

    max_audio_s: float = Field(default=120.0, gt=0, description="longest audio accepted, seconds")
    max_body_bytes: int = Field(
        default=40 * 1024 * 1024, gt=0, description="largest HTTP request accepted, bytes, audio and words together"
    )
    parser: Path | str | None = Field(
        default=None, description="another spaCy pipeline, by name or folder (ClearNLP or UD labels); ours if unset"
    )
    emphasis: Literal["prominence", "ratio"] = Field(
        default="prominence", description="what makes a word emphasised: our prominence, or the paper's stressed ratio"
    )
    agitation_features: Literal["paper", "full"] = Field(
        default="full", description="features from which agitation is judged: the paper's 12 MFCC, or our full set"
    )
    affect_model: Path | None = Field(
        default=None, description="your own ONNX model from the waveform to activation and valence; ours if unset"
    )
    model_data: Literal["all", "free"] = Field(
        default="all",
        description="what our models that judge a voice were trained on: all corpora, or those free for any use",
    )
    agitation_model: Path | None = Field(
        default=None, description="a model that understudy agitation train wrote, in place of ours"
    )
    lexicon: str | None = Field(
        default=None,
        description="an author's folders of words, rules, gestures, characters and profiles, laid over the bundled "
        "ones, separated as in PATH",
    )
    choice: Literal["terms", "priority"] = Field(
        default="terms",
        description="how movements are chosen: by weighted terms, or by priority as in the paper",
    )
    cache: str | None = Field(
        default=None, description='where compiled rules are kept between processes, "off" for nowhere'
    )
    blender: str | None = Field(
        default=None, description="the Blender that writes FBX, or a Python that has bpy; blender in the PATH if unset"
    )
    physics: bool = Field(default=False, description="move bodies with physics by default (needs understudy[physics])")
    host: str = Field(default="127.0.0.1", description="address the service listens on")
    port: int = Field(default=8000, ge=0, le=65535, description="port the service listens on; 0 picks a free one")
    api_keys: SecretStr | None = Field(
        default=None, description="accepted API keys, separated by commas; no key is needed if unset"
    )
    api_keys_file: Path | None = Field(default=None, description="a file with further keys, one a line")
    api_key: SecretStr | None = Field(
        default=None, description="the key that `understudy batch --service` sends to another's service"
    )
    allow_anonymous: bool = Field(
        default=False, description="listen on addresses that others can reach without requiring a key"
    )
    allowed_hosts: str | None = Field(
        default=None, description="host names that the service accepts, separated by commas; any if unset"
    )
    allowed_origins: str | None = Field(
        default=None,
        description="origins whose pages may call the service, separated by commas; its own alone if unset",
    )
    operations_port: int | None = Field(
        default=None,
        ge=1,
        le=65535,
        description="a separate port for metrics and docs, which then need no key",
    )
    closed: str | None = Field(
        default=None, description="pages to turn off: metrics, docs, studio, separated by commas"
    )
    workers: int | None = Field(
        default=None, gt=0, description="processes that perform lines, one line each at a time; one a core if unset"
    )
    queue: int | None = Field(
        default=None, ge=0, description="requests that may wait, 503 beyond; four a worker if unset"
    )
    queue_s: float = Field(default=10.0, gt=0, description="a request that waits longer for a worker is answered 503")
    deadline_s: float = Field(default=60.0, gt=0, description="a request that takes longer is answered 504")
    grace_s: float = Field(default=10.0, ge=0, description="how long running requests may go on when the service stops")
    worker_memory_bytes: int = Field(
        default=384 * 1024 * 1024, gt=0, description="memory that a worker may take for a request; 413 beyond"
    )
    part_bytes: str | None = Field(
        default=None,
        description="largest parts of a request, where they differ from `PART_BYTES`, as bml=4194304, rules=2097152",
    )
    max_motion_s: float = Field(default=150.0, gt=0, description="longest motion answered, seconds")
    max_uploads_bytes: int = Field(
        default=256 * 1024 * 1024, gt=0, description="all request bodies in memory together, bytes; 503 beyond"
    )
    upload_s: float = Field(default=30.0, gt=0, description="a body that takes longer to arrive is answered 408")
    idle_s: float = Field(default=5.0, gt=0, description="a connection idle for longer is closed")
    max_connections: int = Field(default=512, gt=0, description="concurrent connections; 503 beyond, if all work")
    live_streams: int | None = Field(
        default=None, ge=0, description="concurrent live streams, refused beyond; eight a core if unset"
    )
    live_s: float = Field(
        default=14_400.0, gt=0, description="longest live stream, seconds of sound and of wall-clock time"
    )
    live_idle_s: float = Field(
        default=30.0, gt=0, description="a live stream to which nothing is sent for longer is closed"
    )
    live_ahead_s: float = Field(
        default=10.0,
        ge=0,
        description="seconds by which the sound of a live stream may run ahead of real time",
    )
    rate_per_minute: int = Field(
        default=0, ge=0, description="requests for work a minute from one address, 429 beyond; 0 for any number"
    )

    @model_validator(mode="before")
    @classmethod
    def _from_environment(cls, given: dict[str, object]) -> dict[str, object]:
        names = {name.lower(): value for name, value in os.environ.items()}
        found = {field: names.get(f"{PREFIX}{field}".lower()) for field in cls.model_fields}
        return {field: value for field, value in found.items() if value is not None} | given

    @field_validator("part_bytes")
    @classmethod
    def _check_parts(cls, given: str | None) -> str | None:
        read_part_bytes(given or "")
        return given

    @field_validator("closed")
    @classmethod
    def _check_closed(cls, given: str | None) -> str | None:
        for name in _listed(given):
            if name not in CLOSEABLE:
                raise ValueError(f"{name!r} cannot be closed; give some of {', '.join(CLOSEABLE)}")
        return given

    @property
    def part_limits(self) -> Mapping[str, int]:
        """The most bytes of each part of a request."""
        return {**PART_BYTES, **read_part_bytes(self.part_bytes or "")}

    @property
    def max_audio_bytes(self) -> int:
        """The largest recording accepted, bytes."""
        return self.part_limits["audio"]

    @property
    def closed_pages(self) -> tuple[str, ...]:
        """Those of `CLOSEABLE` that are not answered."""
        return _listed(self.closed)

    @property
    def lexicon_folders(self) -> tuple[Path, ...]:
        """The author's folders, the last one on top."""
        return layers_of(self.lexicon)

    @property
    def worker_count(self) -> int:
        """The number of worker processes."""
        return self.workers or processor_count()

    @property
    def live_stream_count(self) -> int:
        """The most live streams at the same time."""
        return 8 * processor_count() if self.live_streams is None else self.live_streams

    @property
    def live_streams_each(self) -> int:
        """The most live streams of one caller: three quarters of all, or all where no keys tell callers apart."""
        return max(1, 3 * self.live_stream_count // 4) if self.has_keys else self.live_stream_count

    @property
    def live_message_s(self) -> float:
        """The processor time that a message of a live stream may take, seconds."""
        return self.deadline_s / 6

    @property
    def host_names(self) -> tuple[str, ...]:
        """The names that the service may be called by; any if there are none."""
        return _listed(self.allowed_hosts)

    @property
    def origins(self) -> tuple[str, ...]:
        """The origins of pages that may call the service besides its own."""
        return _listed(self.allowed_origins)

    @property
    def has_keys(self) -> bool:
        """Whether callers are asked for a key."""
        return self.api_keys is not None or self.api_keys_file is not None

    @property
    def motion_limits(self) -> MotionLimits:
        """The limits on the motion in one response of the service."""
        return MotionLimits(duration_s=self.max_motion_s, frames=round(MOST_FRAMES_PER_S * self.max_motion_s))

    @property
    def queue_length(self) -> int:
        """The most requests that may wait."""
        return 4 * self.worker_count if self.queue is None else self.queue


def processor_count() -> int:
    """The processors that this process may use; all of them where the system sets no limit."""
    if sys.platform == "linux":
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def read_settings() -> Settings:
    """The settings of the environment; raises InputError `setting_wrong` naming every variable that is wrong, or that
    only former versions had."""
    names = {name.upper() for name in os.environ}
    wrong = [
        f"{variable}: is no longer a setting; {instead}"
        for variable, instead in ((f"{PREFIX}{name}".upper(), instead) for name, instead in _REMOVED.items())
        if variable in names
    ]
    try:
        settings = Settings()
    except ValidationError as error:
        wrong += [f"{PREFIX}{found['loc'][0]}".upper() + f": {found['msg']}" for found in error.errors()]
    if wrong:
        raise InputError("setting_wrong", f"{'; '.join(wrong)}; docs/settings.md lists what may be set")
    return settings


def read_part_bytes(text: str) -> Mapping[str, int]:
    """The limits in a list such as "bml=4194304, rules=2097152". Raises ValueError."""
    limits = {}
    for each in text.replace(",", " ").split():
        name, _, number = each.partition("=")
        if name not in PART_BYTES:
            raise ValueError(
                f"no part is called {name!r}{did_you_mean(name, PART_BYTES)}; there are {', '.join(PART_BYTES)}"
            )
        if not number.isdecimal() or not int(number):
            raise ValueError(f"{each!r} has no number of bytes; write {name}=BYTES")
        limits[name] = int(number)
    return limits


def _listed(names: str | None) -> tuple[str, ...]:
    """Names in lower case that are separated by commas or white space."""
    return tuple((names or "").lower().replace(",", " ").split())
