#!/bin/bash
# tests/target/gpio_get.sh -- download and build, once, the parts of a Linux with simulated GPIO
# chips; prints the folder
# SPDX-License-Identifier: MIT
# usage: tests/target/gpio_get.sh [FOLDER] ; ~/.cache/loft/gpio if none is named.
# No root, nothing is installed.
#
# Debian's kernel with configfs; gpio-sim, which Debian does not build, from the same source as a
# module; libgpiod 1.x of Debian 12 and 2.x of Debian 13, static.
# 225 MB are downloaded, 9 MB are kept.
set -euo pipefail
keep=${1:-${XDG_CACHE_HOME:-$HOME/.cache}/loft/gpio}
mirror=${DEBIAN_MIRROR:-http://deb.debian.org}
keys=/usr/share/keyrings/debian-archive-keyring.gpg
made=(vmlinuz configfs.ko gpio-sim.ko {v1,v2}/gpiod.h {v1,v2}/libgpiod.a)

complete() { for f in "${made[@]}"; do [ -s "$keep/$f" ] || return 1; done; }
if complete; then echo "$keep"; exit 0; fi

for tool in apt-get dpkg-deb gcc-12 make xz strip; do
    command -v $tool >/dev/null || {
        echo "$tool is missing, without which no kernel can be got: make deps-target, on Debian 12"
        exit 1
    } >&2
done
mkdir -p "$keep"
work=$(mktemp -d "$keep/work.XXXXXX"); trap 'rm -rf "$work"' EXIT
cd "$work"

# archive NAME "URI SUITE".. : from now on apt-get and apt-cache see only these
archive() {
    local name=$work/apt-$1
    shift
    mkdir -p "$name/lists/partial" "$name/archives/partial"
    printf "deb [signed-by=$keys] %s main\n" "$@" > "$name/sources.list"
    cat > "$name/apt.conf" <<E
Dir::Etc::sourcelist "$name/sources.list";
Dir::Etc::sourceparts "/dev/null"; Dir::Etc::preferencesparts "/dev/null";
Dir::State "$name"; Dir::State::status "/dev/null"; Dir::Cache "$name";
APT::Sandbox::User "$(id -un)"; APT::Architecture "amd64";
Acquire::Languages "none"; Acquire::Retries "3";
E
    export APT_CONFIG=$name/apt.conf
    apt-get update -qq || { echo "no Debian archive at $mirror" >&2; exit 1; }
}
get() { apt-get download -qq "$@" || { echo "cannot download $*" >&2; exit 1; }; }
unpack() { dpkg-deb --fsys-tarfile "$work/"$1_*.deb | tar -x -C "$work" "${@:2}"; }

# libgpiod VERSION: header and library into a folder of their own
libgpiod() {
    get libgpiod-dev
    unpack libgpiod-dev
    mkdir -p "$keep/v$1"
    cp usr/include/gpiod.h usr/lib/*/libgpiod.a "$keep/v$1/"
    rm libgpiod-dev_*.deb
}

archive new "$mirror/debian trixie"
libgpiod 2
archive old "$mirror/debian bookworm" "$mirror/debian-security bookworm-security"
libgpiod 1
kernel=$(apt-cache depends linux-image-amd64 | sed -n 's/.*Depends: linux-image-//p' | head -1)
series=$(echo "$kernel" | cut -d. -f1,2)
parts=("linux-headers-$kernel" "linux-headers-${kernel%-amd64}-common" "linux-kbuild-$series")
get "linux-image-$kernel-unsigned" "${parts[@]}" "linux-source-$series"

unpack "linux-image-$kernel-unsigned" --wildcards './boot/vmlinuz-*' '*/fs/configfs/configfs.ko'
for part in "${parts[@]}"; do unpack "$part"; done

# gpio-sim and its dependencies; modules cannot use irq_to_desc, but the function behind it
source=linux-source-$series
dpkg-deb --fsys-tarfile "$source"_*.deb | tar -xO "./usr/src/$source.tar.xz" |
    tar -xJ --strip-components=1 "$source/drivers/gpio/gpio-sim.c" \
        "$source/drivers/gpio/gpiolib.h" "$source/kernel/irq/irq_sim.c"
mkdir module
cp drivers/gpio/gpio-sim.c module/gpio-sim-main.c
cp drivers/gpio/gpiolib.h kernel/irq/irq_sim.c module/
sed -i -e 's/irq_to_desc(irqnum)/irq_data_to_desc(irq_get_irq_data(irqnum))/' \
    -e 's/#include <linux\/irq.h>/&\n#include <linux\/irqdesc.h>/' module/irq_sim.c
printf 'obj-m := gpio-sim.o\ngpio-sim-y := gpio-sim-main.o irq_sim.o\n' > module/Makefile
sed -i "s|/usr/src/|$work/usr/src/|" "usr/src/linux-headers-$kernel/Makefile"
make -s -C "$work/usr/src/linux-headers-$kernel" M="$work/module" modules >build.log 2>&1 ||
    { cat build.log >&2; exit 1; }

# gpio-sim.ko last: it completes the folder
cp boot/vmlinuz-* "$keep/vmlinuz"
strip --strip-debug -o "$keep/configfs.ko" lib/modules/*/kernel/fs/configfs/configfs.ko
strip --strip-debug -o "$work/gpio-sim.ko" module/gpio-sim.ko
mv "$work/gpio-sim.ko" "$keep/gpio-sim.ko"
echo "$keep"
