#!/usr/bin/env bash
# check.sh BUILD WORK COMPILER: installs BUILD into a prefix below WORK, and builds and runs the project beside this script against it.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
build=$1 work=$2 compiler=$3
rm -rf "$work"
mkdir -p "$work"
cmake --install "$build" --prefix "$work/prefix" >"$work/install.log"
cmake -G Ninja -S "$here" -B "$work/build" -DCMAKE_PREFIX_PATH="$work/prefix" -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=Debug
cmake --build "$work/build"
"$work/build/consumer"
for file in bin/lancer share/lancer/scenes share/lancer/lancer.schema.json share/doc/lancer/LICENSE; do
    [ -e "$work/prefix/$file" ] || { echo "not installed: $file"; exit 1; }
done
"$work/prefix/bin/lancer" --version
