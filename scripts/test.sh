#!/usr/bin/env bash
# From a clean clone through the whole test suite: installs what is missing, builds, tests.
set -euo pipefail
cd "$(dirname "$0")/.."

. scripts/packages.sh
# shellcheck disable=SC2086  # a list of words
scripts/install_packages.sh $tests

cmake --preset release -DHFDEM_TESTS=ON -DHFDEM_BENCHMARKS=ON
cmake --build --preset release
ctest --preset release -j "$(nproc)"
