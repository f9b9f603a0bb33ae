#!/bin/sh
# tests/e2e/page.sh -- the commands of ports/README.md from one section to before another
# SPDX-License-Identifier: MIT
# usage: tests/e2e/page.sh FROM TO LOFT PORT ; FROM and TO are how the headings begin.
# What opens in place of closing is set and set back.
awk -v from="### $1" -v to="### $2" '
    index($0, from) == 1 { on = 1 }
    index($0, to) == 1 { on = 0 }
    on && /^```sh$/ { sh = 1; next }
    /^```$/ { sh = 0 }
    on && sh
    on && sh && /limit=opens/ { sub(/limit=opens/, "limit=closes x.reversed=no"); print }
' ports/README.md | sed "s|build/loft|$(realpath "$3")|g; s|/dev/ttyACM0|$4|g"
