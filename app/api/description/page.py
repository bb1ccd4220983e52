"""`/docs`: the OpenAPI document as a page without external resources; swagger-ui is in the folder beside this module.

Its two files are kept compressed, and sent so to whoever takes that, as every browser does.
"""

import gzip
from pathlib import Path

from fastapi import APIRouter, Request
from starlette.exceptions import HTTPException
from starlette.responses import FileResponse, Response

FOLDER = Path(__file__).parent / "swagger"
MEDIA_TYPES = {"swagger-ui.css": "text/css", "swagger-ui-bundle.js": "text/javascript", "page.js": "text/javascript"}
CONTENT_POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data:; "
    "connect-src 'self'; base-uri 'none'; form-action 'self'; frame-ancestors 'none'"
)

_KEPT = {"Cache-Control": "max-age=86400", "Vary": "Accept-Encoding"}

router = APIRouter(include_in_schema=False)


@router.get("/docs")
def get_docs() -> Response:
    """The page."""
    return FileResponse(
        FOLDER / "page.html", media_type="text/html", headers={"Content-Security-Policy": CONTENT_POLICY}
    )


@router.get("/docs/{name}")
def get_docs_file(name: str, request: Request) -> Response:
    """What the page loads. Raises HTTPException 404."""
    if name not in MEDIA_TYPES:
        raise HTTPException(404)
    compressed = FOLDER / f"{name}.gz"
    if not compressed.exists():
        return FileResponse(FOLDER / name, media_type=MEDIA_TYPES[name], headers=_KEPT)
    if "gzip" in request.headers.get("accept-encoding", ""):
        return FileResponse(compressed, media_type=MEDIA_TYPES[name], headers=_KEPT | {"Content-Encoding": "gzip"})
    return Response(gzip.decompress(compressed.read_bytes()), media_type=MEDIA_TYPES[name], headers=_KEPT)
