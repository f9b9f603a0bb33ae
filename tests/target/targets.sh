# tests/target/targets.sh -- the microcontrollers that lib/ is compiled for;
# sourced by cross.sh and size.sh
# SPDX-License-Identifier: MIT

targets="m0plus m4 atmega328p rv32imac"
warnings="-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wstrict-prototypes"
warnings="$warnings -Wmissing-prototypes -Wundef -Werror"

compiler() {    # compiler TARGET: command and machine flags
    case $1 in
    m0plus)     echo arm-none-eabi-gcc -mthumb -mcpu=cortex-m0plus ;;
    m4)         echo arm-none-eabi-gcc -mthumb -mcpu=cortex-m4 -mfpu=fpv4-sp-d16 -mfloat-abi=hard ;;
    atmega328p) echo avr-gcc -mmcu=atmega328p ;;
    rv32imac)   echo riscv64-unknown-elf-gcc -march=rv32imac -mabi=ilp32 ;;
    esac
}

binutil() {     # binutil TARGET TOOL: its nm, size, objdump, ld
    case $1 in
    m0plus|m4)  echo "arm-none-eabi-$2" ;;
    atmega328p) echo "avr-$2" ;;
    rv32imac)   echo "riscv64-unknown-elf-$2" ;;
    esac
}

missing_tools() {
    for t in $targets; do
        command -v "$(compiler "$t" | cut -d' ' -f1)" >/dev/null ||
            echo "$(compiler "$t" | cut -d' ' -f1) is missing: make deps-target"
    done | sort -u
}

# compile_lib TARGET NUM AXES: what is not yet compiled of lib/, ports/template and ports/bare into
# build/cross/TARGET-NUMxAXES; errors on stdout. Objects of q16x3 are measured by footprint.sh too.
compile_lib() {
    out=build/cross/$1-$2x$3
    mkdir -p "$out"
    flags="-std=c99 -ffreestanding -Os -ffunction-sections -fdata-sections -fstack-usage"
    flags="$flags -Ilib -Iports $warnings"
    flags="$flags -DLOFT_NUM=LOFT_$(echo "$2" | tr a-z A-Z) -DLOFT_AXES=$3"
    header=$(find lib ports -name '*.h' -exec stat -c '%Y %n' {} + | sort -n | tail -1)
    : > "$out/made"
    for c in $(find lib -name '*.c' ! -path 'lib/examples/*' | LC_ALL=C sort) ports/template/*.c \
            ports/bare/memory.c; do
        [ -f "$c" ] || continue
        object=$out/$(echo "${c%.c}" | sed 's|^lib/||; s|/|-|g').o
        echo "$object" >> "$out/made"
        [ ! "$object" -nt "$c" ] || [ ! "$object" -nt "${header#* }" ] || continue
        # shellcheck disable=SC2046,SC2086
        $(compiler "$1") $flags -c "$c" -o "$object" 2>&1 || echo "$c does not compile"
    done
    for object in "$out"/*.o; do        # of a file that is gone, or has another name
        grep -qxF "$object" "$out/made" || rm -f "$object"
    done
}
