"""Runs the service until it is stopped.

Everything is loaded, and the bundled example performed once, before the first request is accepted: a mistake in rules
or settings is reported like any other, and no caller waits for what only the first line needs.
"""

import signal
from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path

from ..api.admission.admission import Admission, require_keys
from ..api.application import create_app
from ..api.serving import serve
from ..api.workers.processes import Nursery
from ..settings import Settings
from ..studio.pages import OpenedLine
from ..studio.scenes import OpenedScene
from .listening import bind, listen, shown_address
from .log import Log


def _nothing(_address: str) -> None:
    """The default of `when_started`: does nothing."""


def run_service(
    settings: Settings,
    log: Log,
    *,
    reload: bool = False,
    opened: OpenedLine | OpenedScene | None = None,
    rules_folder: Path | None = None,
    when_started: Callable[[str], None] = _nothing,
) -> int:
    """Listens on the address in the settings; `when_started` is called with the first address, as a URL. Rules edited
    in the page can be saved in `rules_folder`.

    Raises KeyboardInterrupt, after everything has ended, if that is what stopped it; InputError `address_unusable`,
    `key_missing` and `setting_wrong`.
    """
    admission = Admission.of(settings)
    ports = [settings.port, *([settings.operations_port] if settings.operations_port else [])]
    with ExitStack() as stack:
        sockets = [stack.enter_context(each) for port in ports for each in bind(settings.host, port)]
        for each in sockets:
            require_keys(admission, each.getsockname()[0], settings)
        log_config = log.service_logging()
        nursery = stack.enter_context(Nursery.start(settings, logging=log_config))
        app = create_app(settings, nursery, reload=reload, opened=opened, rules_folder=rules_folder)
        listen(sockets)
        addresses = [shown_address(each) for each in sockets]

        def told() -> None:
            log.note("\n".join(f"listening on {address}" for address in addresses))
            when_started(addresses[0])

        stopped_by = serve(app, settings, sockets, log_config=log_config, when_started=told)
    if stopped_by == signal.SIGINT:
        raise KeyboardInterrupt
    return 0
