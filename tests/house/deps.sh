#!/bin/sh
# tests/house/deps.sh -- install Debian packages that are missing, in one transaction, and say which
# SPDX-License-Identifier: MIT
# usage: tests/house/deps.sh PACKAGE..
set -eu
if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    echo "this system has no apt; install what corresponds to these Debian packages:"
    echo "  $*"
    exit 0
fi
missing=
for package in "$@"; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' ||
        missing="$missing $package"
done
if [ -z "$missing" ]; then
    echo "all packages are there: $*"
    exit 0
fi
echo "installing:$missing"
root=
[ "$(id -u)" = 0 ] || root=sudo
export DEBIAN_FRONTEND=noninteractive
# shellcheck disable=SC2086
$root apt-get install -y -qq --no-install-recommends $missing >/dev/null 2>&1 ||
    {   $root apt-get update -qq &&
        $root apt-get install -y -qq --no-install-recommends $missing >/dev/null; }
echo "installed:$missing"
