#!/usr/bin/env python3
# tests/target/pins.py -- convert QEMU's log of a board's pins to positions
# SPDX-License-Identifier: MIT
"""usage: pins.py BOARD LOG > CSV

Rows `slot,x,y,z` as `loft simulate --record` writes them; QEMU's logs have no time, so `slot`
counts the pulses."""
import re
import sys

STORE = re.compile(r"(\w[\w-]*): unimplemented device write "
                   r"\(size 4, offset (0x\w+), value (0x\w+)\)")
NRF51 = re.compile(r"nrf51_gpio_write offset (0x\w+) value (0x\w+)")
NRF51_STEP, NRF51_DIR = (3, 2, 1), (18, 20, 16)     # as in ports/nrf51/port.c


def mps2(line, pins):
    found = STORE.match(line)
    if not found or found[2] != "0x004" or found[1] not in ("cmsdk-ahb-gpio", "gpio0"):
        return None
    return int(found[3], 16)


def nrf51(line, pins):
    found = NRF51.search(line)
    if not found or found[1] != "0x504":
        return None
    value = int(found[2], 16)
    return sum((value >> pin & 1) << i for i, pin in enumerate(NRF51_STEP + NRF51_DIR))


def riscv(line, pins):
    return int(line)


def main(board, path):
    readers = {"riscv-virt": riscv, "nrf51": nrf51}
    read = mps2 if board.startswith("mps2") else readers[board]
    pins, slot, at = 0, 0, [0, 0, 0]
    print("slot,x,y,z")
    for line in open(path):
        now = read(line, pins)
        if now is None:
            continue
        risen = now & 7 if board == "riscv-virt" else now & ~pins & 7
        pins = now
        if risen:
            slot += 1
            for i in range(3):
                at[i] += (risen >> i & 1) * (-1 if now >> (3 + i) & 1 else 1)
            print(slot, *at, sep=",")


if __name__ == "__main__":
    main(*sys.argv[1:3])
