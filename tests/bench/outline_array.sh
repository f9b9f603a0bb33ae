#!/bin/sh
# tests/bench/outline_array.sh -- tests/drawings/outline12.csv as a C array of raw Q16.16, for
# programs on a chip
# SPDX-License-Identifier: MIT
set -eu
awk -F, 'function raw(x) { return x < 0 ? -int(0.5 - x * 65536) : int(x * 65536 + 0.5) }
         BEGIN { print "static const int32_t outline[12][4][2] = {" }
         !/^#/ {
             printf "    {"
             for (k = 1; k < 8; k += 2) printf " { %d, %d },", raw($k), raw($(k + 1))
             print " },"
         }
         END   { print "};" }' tests/drawings/outline12.csv
