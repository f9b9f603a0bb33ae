#!/bin/bash
# tests/packages/python.sh -- pip install from the tree with Debian's Python, its tests, the example
# SPDX-License-Identifier: MIT
# usage: tests/packages/python.sh
row=python
. tests/packages/row.sh
python=/usr/bin/python3
needs $python
mkdir "$work/module"
cp ports/packages/python/test_loft.py ports/packages/python/example.py "$work/module"
installed() {   # in a copy of the tree: setup.py makes files beside itself
    mkdir -p "$work/tree/ports/packages" && cp -r lib LICENSE "$work/tree" &&
        cp -r ports/packages/python ports/packages/amalgam "$work/tree/ports/packages" &&
        $python -m pip install --no-build-isolation --no-deps --no-index --quiet \
            --target "$work/site" "$work/tree/ports/packages/python"
}
verdict "pip install ports/packages/python, with Debian's cffi and setuptools" installed
export PYTHONPATH=$work/site
cd "$work" || exit
tested() { $python module/test_loft.py; }
verdict "10 tests against numpy, in f64" tested
drawn() {
    [ "$($python module/example.py plan.png | sed 's/^[0-9]* //')" = \
        "ticks, ends at [40.0, 40.0]" ] && [ "$(head -c 4 plan.png | tail -c 3)" = PNG ]
}
verdict "example.py plots a plan" drawn
ended
