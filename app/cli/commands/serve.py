"""`understudy serve`: the service, until it is told to stop.

Everything is loaded, and the bundled example performed once, before the first request is taken: a mistake in rules or
settings is told like any other, and no caller waits for what only the first line needs.
"""

import argparse
import signal
from contextlib import ExitStack

from ...api.admission.admission import Admission, require_keys
from ...api.application import create_app
from ...api.serving import serve
from ...api.workers.processes import Nursery
from ...settings import read_settings
from ..listening import bind, listen, shown_address
from ..log import Log


def run(arguments: argparse.Namespace, log: Log) -> int:
    """Raises KeyboardInterrupt, when all has ended, where that is what stopped it."""
    settings = read_settings()
    chosen = {"host": arguments.host, "port": arguments.port}
    settings = settings.model_copy(update={key: value for key, value in chosen.items() if value is not None})
    admission = Admission.of(settings)
    ports = [settings.port, *([settings.operations_port] if settings.operations_port else [])]
    with ExitStack() as stack:
        sockets = [stack.enter_context(each) for port in ports for each in bind(settings.host, port)]
        for each in sockets:
            require_keys(admission, each.getsockname()[0], settings)
        log_config = log.service_logging()
        nursery = stack.enter_context(Nursery.start(settings, logging=log_config))
        app = create_app(settings, nursery, reload=arguments.reload)
        listen(sockets)
        listening = "\n".join(f"listening on {shown_address(each)}" for each in sockets)
        stopped_by = serve(app, settings, sockets, log_config=log_config, when_started=lambda: log.note(listening))
    if stopped_by == signal.SIGINT:
        raise KeyboardInterrupt
    return 0
