# tests/support/appears.sh -- wait for a file that another program makes; sourced
# SPDX-License-Identifier: MIT

# appears FILE: it is there; the limit of 10 minutes is against hanging alone
appears() {
    for _ in $(seq 30000); do [ -e "$1" ] && return; sleep 0.02; done
    echo "$1 did not appear" >&2
    return 1
}
