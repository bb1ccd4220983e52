"""Opens the senders by which `understudy live` moves avatars in other programs, from the command's arguments."""

import argparse
from contextlib import ExitStack, closing

from ...errors import InputError
from ...live.avatars import live_link_face, vmc
from ...live.avatars.sending import FrameSender, FrameWriter
from ...models import Understudy

AVATAR_FRAME_RATE_HZ = 60
Address = tuple[str, int]


def avatar_addresses(arguments: argparse.Namespace) -> tuple[Address | None, Address | None]:
    """The addresses for VMC and for Live Link Face, if given. Raises InputError `value_wrong`."""
    asked = (("vmc", arguments.vmc, vmc.PORT), ("live-link-face", arguments.live_link_face, live_link_face.PORT))
    body, face = (_address(text, port, f"--{name}") if text else None for name, text, port in asked)
    return body, face


def avatar_senders(
    arguments: argparse.Namespace, understudy: Understudy, frame_rate_hz: int, stack: ExitStack
) -> tuple[FrameSender, ...]:
    """The senders of frames, closed with the stack. Raises InputError `value_wrong`, `address_unusable`."""
    body, face = avatar_addresses(arguments)
    parts = vmc.VmcParts(head=not arguments.vmc_without_head, face=vmc.VmcFace(arguments.vmc_face))
    skeleton = understudy.realizer.performer(arguments.character).skeleton
    writers: list[tuple[Address | None, FrameWriter]] = [
        (body, vmc.VmcWriter(skeleton, parts)),
        (face, live_link_face.LiveLinkFaceWriter(frame_rate_hz)),
    ]
    return tuple(stack.enter_context(closing(FrameSender(to, writer))) for to, writer in writers if to)


def _address(text: str, port: int, option: str) -> Address:
    host, _, given = text.rpartition(":") if ":" in text else (text, "", str(port))
    if not host or not given.isdecimal() or not 0 < int(given) < 65536:
        message = f"{option} {text}; give HOST:PORT, as 127.0.0.1:{port}"
        raise InputError("value_wrong", message, field=option.removeprefix("--"))
    return host.strip("[]"), int(given)
