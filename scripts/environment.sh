#!/bin/sh
# Makes an empty virtual environment with Python 3.11, the one Python that Blender's module is built for: with an
# installed one, else with uv, which fetches it. Where there is neither, says the line that installs it here.
# Usage: environment.sh PYTHON FOLDER [OS_RELEASE]
set -eu
python=$1 folder=$2 release=${3:-/etc/os-release}

if command -v "$python" >/dev/null 2>&1; then
    "$python" -c 'import ensurepip' >/dev/null 2>&1 || {
        echo "StoryBlender: $python comes without venv here. Install it with: sudo apt-get install -y python3.11-venv"
        exit 2
    }
    exec "$python" -m venv "$folder"
fi
if command -v uv >/dev/null 2>&1; then
    exec uv venv --quiet --seed --python 3.11 "$folder"
fi

ID= ID_LIKE= VERSION_ID=
if [ -r "$release" ]; then . "$release"; fi
case "$(uname -s) $ID $VERSION_ID" in
    Darwin*) line="brew install python@3.11" ;;
    MINGW* | MSYS* | CYGWIN*) line="winget install Python.Python.3.11" ;;
    *" debian 12") line="sudo apt-get install -y python3.11 python3.11-venv" ;;
    *" ubuntu 22.04") line="sudo apt-get install -y python3.11 python3.11-venv" ;;
    *" ubuntu "*)
        line="sudo add-apt-repository -y ppa:deadsnakes/ppa && sudo apt-get install -y python3.11 python3.11-venv" ;;
    *" fedora "*) line="sudo dnf install -y python3.11" ;;
    *) line="" ;;
esac
uv="install uv (https://docs.astral.sh/uv), which fetches Python 3.11 by itself"
if [ -n "$line" ]; then
    echo "StoryBlender needs Python 3.11. Install it with: $line"
    echo "Or $uv. Then run the same command again."
else
    echo "StoryBlender needs Python 3.11, which this system does not have: $uv, and run the same command again."
fi
echo "If Python 3.11 is somewhere else on this machine: make PYTHON=/path/to/python3.11"
exit 2
