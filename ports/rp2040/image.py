#!/usr/bin/env python3
# ports/rp2040/image.py -- the bytes of an RP2040's or RP2350's flash as a UF2 file, with the CRC
# that the boot ROM of the first wants
# SPDX-License-Identifier: MIT
"""usage: ports/rp2040/image.py CHIP LOFT.bin LOFT.uf2 ; LOFT.bin begins at the begin of the flash.

The last 4 of the first 256 bytes are the CRC of the others (RP2040 datasheet, 2.8.1.3.1). UF2 is
a row of blocks (github.com/microsoft/uf2)."""
import struct
import sys

FLASH, FAMILY = 0x10000000, {"rp2040": 0xE48BFF56, "rp2350": 0xE48BFF59}


def crc32(data):
    """Of polynomial 0x04C11DB7, from all ones, no bit turned round."""
    crc = 0xFFFFFFFF
    for byte in data:
        crc ^= byte << 24
        for _ in range(8):
            crc = (crc << 1 ^ (0x04C11DB7 if crc & 0x80000000 else 0)) & 0xFFFFFFFF
    return crc


def main():
    chip, source, target = sys.argv[1:]
    with open(source, "rb") as f:
        image = f.read()
    if chip == "rp2040":
        image = image[:252].ljust(252, b"\0") + struct.pack("<I", crc32(image[:252])) + image[256:]
    blocks = [image[at:at + 256].ljust(256, b"\0") for at in range(0, len(image), 256)]
    with open(target, "wb") as f:
        for number, block in enumerate(blocks):
            f.write(struct.pack("<8I", 0x0A324655, 0x9E5D5157, 0x2000, FLASH + 256 * number, 256,
                                number, len(blocks), FAMILY[chip]))
            f.write(block.ljust(476, b"\0") + struct.pack("<I", 0x0AB16F30))


main()
