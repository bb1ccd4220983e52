"""A batch in the process of the tests, with models that are loaded already."""

from concurrent.futures import Future

from understudy.batch.work.jobs import LineJob, LineOutcome, ReferenceJob
from understudy.batch.work.performing import perform_job
from understudy.batch.work.worker import learn_reference
from understudy.errors import UnderstudyError
from understudy.model.voice.signal import SpeakerReference
from understudy.models import Understudy


class ThisProcess:
    """An engine that does jobs here, with models that are loaded already."""

    places = 1

    def __init__(self, models: Understudy) -> None:
        self.models = models
        self.performed: list[str] = []

    def submit(self, job: LineJob) -> "Future[LineOutcome]":
        self.performed.append(job.id)
        future: Future[LineOutcome] = Future()
        try:
            future.set_result(perform_job(job, self.models))
        except UnderstudyError as error:
            future.set_exception(error)
        return future

    def learn(self, job: ReferenceJob) -> "Future[SpeakerReference | None]":
        future: Future[SpeakerReference | None] = Future()
        future.set_result(learn_reference(job, self.models.acoustic))
        return future

    def close(self) -> None:
        pass
