#!/usr/bin/env bash
# Lints and tests the client, its example and the studio page. Needs node and npm, and the npm registry at the first run; where one of
# them is missing it says so and leaves the tests out.
set -euo pipefail
root="$(cd "$(dirname "$0")/.." && pwd)"
export UNDERSTUDY_PYTHON="${UNDERSTUDY_PYTHON:-$root/.venv/bin/python}" OMP_NUM_THREADS=1

skip() {
    echo "clients: skipped: $1"
    exit 0
}

# Installs what the lock file of a folder says, unless it is there already, and checks the folder.
check() {
    cd "$root/$1"
    if ! cmp -s package-lock.json node_modules/.installed; then
        npm ci --silent --no-audit --no-fund || skip "the packages of $1 cannot be installed from the npm registry"
        cp package-lock.json node_modules/.installed
    fi
    npm run --silent check
}

command -v npm >/dev/null || skip "node with npm is not installed"
node -e 'process.exit(Number(process.versions.node.split(".")[0]) >= 20 ? 0 : 1)' || skip "node is older than 20"

check clients/typescript
check examples/npc
check tests/studio
