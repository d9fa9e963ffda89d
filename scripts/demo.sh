#!/usr/bin/env bash
# From a clean clone to the paper's verification model and its figures: installs what is missing,
# builds, runs. Takes a folder for the results; out/kgd if none is given.
#
#   scripts/demo.sh [FOLDER]
set -euo pipefail
cd "$(dirname "$0")/.."
out=${1:-out/kgd}

. scripts/packages.sh
# shellcheck disable=SC2086  # a list of words
scripts/install_packages.sh $programs

echo "Building (about two minutes) ..."
cmake --preset release -DHFDEM_TESTS=OFF -DHFDEM_BENCHMARKS=OFF >build.log 2>&1 &&
  cmake --build --preset release --target kgd kgd_reference toughness >>build.log 2>&1 || {
  cat build.log >&2
  exit 1
}
rm build.log

echo "A crack driven by uniform pressure through 10,000 bonded discs (some seconds) ..."
build/release/examples/kgd --out "$out" --toughness examples/data/toughness.toml
echo "As an address: file://$(realpath "$out")/report.html"
