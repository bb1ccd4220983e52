"""`understudy serve`: the service, until it is told to stop.

Everything is loaded, and the bundled example performed once, before the first request is taken: a mistake in rules or
settings is told like any other, and no caller waits for what only the first line needs.
"""

import argparse
from contextlib import ExitStack

import uvicorn

from ...api.admission.admission import Admission, require_keys
from ...api.application import create_app
from ...performance import Line, Options, Understudy, perform
from ...resources import resource_folder
from ...settings import read_settings
from ..listening import bind, listen, shown_address
from ..log import Log

GRACE_S = 10
"""How long requests under way may go on when the service stops."""


def run(arguments: argparse.Namespace, log: Log) -> int:
    settings = read_settings()
    chosen = {"host": arguments.host, "port": arguments.port}
    settings = settings.model_copy(update={key: value for key, value in chosen.items() if value is not None})
    admission = Admission.of(settings)
    ports = [settings.port, *([settings.operations_port] if settings.operations_port else [])]
    with ExitStack() as stack:
        sockets = [stack.enter_context(each) for port in ports for each in bind(settings.host, port)]
        for each in sockets:
            require_keys(admission, each.getsockname()[0], settings)
        understudy = stack.enter_context(Understudy.load(settings))
        understudy.load_rest()
        perform(understudy, _example(), Options(), log.stage)
        server = uvicorn.Config(
            create_app(settings, understudy, reload=arguments.reload),
            host=settings.host,
            port=settings.port,
            server_header=False,
            log_config=log.service_logging(),
            timeout_graceful_shutdown=GRACE_S,
        )
        listen(sockets)
        log.note("\n".join(f"listening on {shown_address(each)}" for each in sockets))
        uvicorn.Server(server).run(sockets)
    return 0


def _example() -> Line:
    examples = resource_folder("examples")
    return Line((examples / "example.flac").read_bytes(), (examples / "example.txt").read_text(encoding="utf-8"))
