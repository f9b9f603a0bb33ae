#!/bin/sh
# ports/packages/sysroot.sh -- unpack Debian packages of another architecture, with all that they
# depend on, into a folder; the system itself is not changed
# SPDX-License-Identifier: MIT
# usage: ports/packages/sysroot.sh ARCHITECTURE FOLDER PACKAGE..
set -eu
arch=$1 root=$2
shift 2
if [ -f "$root/complete" ] && [ "$(cat "$root/complete")" = "$arch $*" ]; then
    echo "$root: $arch packages are there: $*"
    exit 0
fi
rm -rf "$root"
mkdir -p "$root/apt/lists/partial" "$root/apt/archives/partial"
root=$(cd "$root" && pwd)
: >"$root/apt/status"
apt() {
    apt-get -qq -o Dir::State="$root/apt" -o Dir::State::status="$root/apt/status" \
        -o Dir::Cache="$root/apt" -o APT::Architecture="$arch" -o APT::Architectures="$arch" \
        -o APT::Sandbox::User=root -o Debug::NoLocking=1 "$@" >"$root/apt/log" 2>&1 ||
        {   tail -5 "$root/apt/log" >&2
            exit 1; }
}
apt update
apt install --download-only --no-install-recommends --yes "$@"
for package in "$root"/apt/archives/*.deb; do
    dpkg-deb -x "$package" "$root"
done
# links that begin at / would lead into this system
find "$root" -type l -lname '/*' | while read -r link; do
    ln -sfn "$root$(readlink "$link")" "$link"
done
rm -rf "$root/apt"
echo "$arch $*" >"$root/complete"
echo "$root: unpacked for $arch: $*"
