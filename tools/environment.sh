#!/bin/sh
# Make .venv afresh with exactly what the lock file names:  tools/environment.sh PYTHON LOCK
set -eu
python=$1 lock=$2

if ! "$python" -c 'import sys; sys.exit(sys.version_info < (3, 11))'; then
  echo "Armillary needs Python 3.11 or newer, and $python is $("$python" --version 2>&1)." >&2
  echo "Name another one: make PYTHON=python3.12" >&2
  exit 1
fi
if ! "$python" -c 'import ensurepip, venv' 2>/dev/null; then
  echo "$python cannot make virtual environments: the modules venv and ensurepip are missing." >&2
  echo "On Debian and Ubuntu: apt-get install python3-venv   (as root, or with sudo)" >&2
  exit 1
fi

echo "Making .venv and installing $(grep -c == "$lock") packages (1.5 GB; a minute or more the first time)."
"$python" -m venv --clear .venv
.venv/bin/python -m pip install -qq --disable-pip-version-check --require-hashes -r "$lock"
