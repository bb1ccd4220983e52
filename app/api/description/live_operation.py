"""`WS /live` in the OpenAPI document, which has no words for WebSockets: the request that opens one, and the schemas of
the messages that a client sends on it.
"""

from pydantic import BaseModel

from ...schemas.live import CommandMessage, ListenMessage, SilenceMessage, StartMessage, WordsMessage
from .answers import Json, errors

LIVE = "/live"
LIVE_MESSAGES: tuple[type[BaseModel], ...] = (
    StartMessage,
    WordsMessage,
    SilenceMessage,
    ListenMessage,
    CommandMessage,
)
"""What a client sends as text; what it sends as binary is sound."""

_TOLD = (
    "A WebSocket: speech in, movements out, as it goes on. The client sends `StartMessage` first, then binary messages "
    "of 16-bit little-endian samples, and `WordsMessage`, `SilenceMessage`, `ListenMessage` and `CommandMessage` as "
    "JSON in text. The service answers JSON in text, each with a `type`: `ready`, the behaviours (`gesture`, `head`, "
    "`face`, `gaze`, `eyes`, `posture`), `withdrawn`, `mouth`, `frame`, `frames_skipped`, `error`, `done`. A browser "
    "offers its key as the protocol `understudy.key.` and the key as base64url, beside `understudy`. docs/live.md has "
    "all of it."
)


def live_operation() -> Json:
    """The operation's object in an OpenAPI document."""
    switched = {"101": {"description": "The connection is a WebSocket from now on."}}
    named = {"operationId": "live", "tags": ["Live"], "summary": "Speech in, movements out, while it is spoken"}
    return {**named, "description": _TOLD, "responses": switched | errors({401, 403, 421, 429})}
