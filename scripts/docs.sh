#!/usr/bin/env bash
# Builds the reference, installing what is missing: open build/docs/index.html in a browser.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/install_packages.sh doxygen python3

rm -rf build/docs
mkdir -p build/docs
(cat docs/Doxyfile && echo "WARN_AS_ERROR = NO") | doxygen -
echo "Open in a browser: $PWD/build/docs/index.html"
