"""`understudy serve`: runs the service until it is stopped."""

import argparse

from ...settings import read_settings
from ..log import Log
from ..service import run_service


def run(arguments: argparse.Namespace, log: Log) -> int:
    """Raises KeyboardInterrupt, after everything has ended, if that is what stopped it."""
    settings = read_settings()
    origins = ", ".join(arguments.allow_origin) if arguments.allow_origin else None
    chosen = {"host": arguments.host, "port": arguments.port, "allowed_origins": origins}
    settings = settings.model_copy(update={key: value for key, value in chosen.items() if value is not None})
    return run_service(settings, log, reload=arguments.reload)
