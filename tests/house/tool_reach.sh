#!/bin/sh
# tests/house/tool_reach.sh -- prints the files of lib/ that the command reaches by its includes, so
# that a fresh machine compiles no others for it
# SPDX-License-Identifier: MIT
#
# A file of lib/ belongs to the header that it includes first. It is reached when that header is.
# loft.h includes all of them, and is there for the version only.
grep -H '^#include "' host-tools/*.c host-tools/*/*.[ch] ports/*.h ports/host/*.[ch] \
    lib/*/*.[ch] lib/*/*/*.[ch] |
    awk -F '[:"]' '
        $1 ~ /^lib\/examples\// || $3 == "loft.h" { next }
        {
            name = $1; sub(/^[^\/]*\//, "", name)
            beside = name; sub(/[^\/]*$/, "", beside)
            to[name] = to[name] " " $3 " " beside $3
            if ($1 ~ /\.c$/ && $1 !~ /^lib\//) start[name]
            if ($1 ~ /^lib\/.*\.c$/ && !(name in path)) {
                path[name] = $1
                to[$3] = to[$3] " " name
            }
        }
        END {
            for (name in start) queue[n++] = name
            for (k = 0; k < n; k++) {
                if (queue[k] in seen) continue
                seen[queue[k]]
                if (queue[k] in path) print path[queue[k]]
                count = split(to[queue[k]], next_one, " ")
                for (i = 1; i <= count; i++) if (!(next_one[i] in seen)) queue[n++] = next_one[i]
            }
        }' | LC_ALL=C sort
