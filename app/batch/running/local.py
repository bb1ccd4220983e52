"""The engine on this machine: processes that each load the models once."""

from concurrent.futures import Future

from ...model.voice.signal import SpeakerReference
from ...settings import Settings
from ..work.jobs import LineJob, LineOutcome
from ..work.speaking import ReferenceJob
from ..work.worker import learn_in_worker, perform_in_worker
from .processes import Processes


class LocalEngine:
    """Workers that read recordings and write outputs themselves."""

    def __init__(self, workers: int, settings: Settings) -> None:
        self._processes = Processes(workers)
        self._settings = settings

    @property
    def places(self) -> int:
        return self._processes.workers

    def submit(self, job: LineJob) -> "Future[LineOutcome]":
        return self._processes.call(perform_in_worker, job, self._settings)

    def learn(self, job: ReferenceJob) -> "Future[SpeakerReference | None]":
        return self._processes.call(learn_in_worker, job, self._settings)

    def close(self) -> None:
        self._processes.close()
