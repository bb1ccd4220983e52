"""What is told of a request to a path that does not exist, or by a method that the path does not support."""

from collections.abc import Sequence
from difflib import get_close_matches

from starlette.exceptions import HTTPException
from starlette.requests import Request

from ..errors import LONGEST_SHOWN


def unknown_path(path: str, known: Sequence[str] = ()) -> str:
    """That there is no such path, and which of the known ones is near."""
    near = get_close_matches(path[:LONGEST_SHOWN], known, n=1)
    return f"no such path: {path[:LONGEST_SHOWN]!r}{f'; did you mean {near[0]}?' if near else ''}"


def unknown_method(request: Request, error: HTTPException) -> str:
    """That the path does not support the method, and which it does."""
    supported = (error.headers or {}).get("Allow", "")
    return f"{request.url.path[:LONGEST_SHOWN]!r} does not support {request.method[:LONGEST_SHOWN]!r}; send {supported}"
