"""What is told of a request to a path that does not exist, or by a method that the path does not support."""

from collections.abc import Sequence

from starlette.exceptions import HTTPException
from starlette.requests import Request

from ..errors import LONGEST_SHOWN
from ..suggestions import nearest_names


def unknown_path(path: str, known: Sequence[str] = ()) -> str:
    """That there is no such path, and which of the known ones is near."""
    near = nearest_names(path, known)
    return f"no such path: {path[:LONGEST_SHOWN]!r}{f'; did you mean {near[0]}?' if near else ''}"


def unknown_method(request: Request, error: HTTPException) -> str:
    """That the path does not support the method, and which it does."""
    supported = (error.headers or {}).get("Allow", "")
    return f"{request.url.path[:LONGEST_SHOWN]!r} does not support {request.method[:LONGEST_SHOWN]!r}; send {supported}"
