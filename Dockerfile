# The service in a container: `docker build -t understudy .`,
# `docker run --read-only -p 8000:8000 -e UNDERSTUDY_API_KEYS=KEY understudy`; it does not start without a key.
# Nothing is written but caches of compiled code and rules in /dev/shm, which is memory. Settings: docs/settings.md.

FROM python:3.11-slim-bookworm AS build
RUN python -m venv /opt/understudy
ENV PATH=/opt/understudy/bin:$PATH PIP_NO_CACHE_DIR=1 PIP_DISABLE_PIP_VERSION_CHECK=1
WORKDIR /build
COPY requirements.lock ./
RUN pip install --require-hashes -r requirements.lock
COPY pyproject.toml hatch_build.py README.md LICENSE NOTICE ./
COPY app app
COPY src src
COPY lexicon lexicon
COPY models models
COPY examples examples
RUN pip wheel --no-deps --wheel-dir dist . \
    && pip install --no-deps dist/*.whl \
    && python -m compileall -q /opt/understudy/lib

FROM python:3.11-slim-bookworm
RUN useradd --system --uid 10001 --no-create-home --shell /usr/sbin/nologin understudy
COPY --from=build /opt/understudy /opt/understudy
ENV PATH=/opt/understudy/bin:$PATH \
    PYTHONDONTWRITEBYTECODE=1 \
    PYTHONUNBUFFERED=1 \
    NUMBA_CACHE_DIR=/dev/shm/numba \
    OMP_NUM_THREADS=1 \
    UNDERSTUDY_CACHE=/dev/shm/understudy \
    UNDERSTUDY_HOST=0.0.0.0 \
    UNDERSTUDY_PORT=8000
USER 10001
EXPOSE 8000
HEALTHCHECK --interval=30s --timeout=5s --start-period=60s --retries=3 \
    CMD ["python", "-c", "import os, urllib.request as r; r.urlopen(f\"http://127.0.0.1:{os.environ['UNDERSTUDY_PORT']}/readyz\", timeout=4)"]
CMD ["understudy", "--json-log", "serve"]
