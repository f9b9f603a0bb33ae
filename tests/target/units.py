#!/usr/bin/env python3
# tests/target/units.py -- the tests of tests/ on emulated chips: a row for each test and board, and
# the reason where a test is left out
# SPDX-License-Identifier: MIT
"""usage: tests/target/units.py FOLDER [BOARD..] ; FOLDER is what units.mk has made, a BOARD is NAME
or, with its number type, NAME-NUM. Without one all boards are run, the first always.

As many tests go into an image as memory holds. What a test takes on a small board is known from the
first, which has room for all: its own data, and the stack that it was seen to use."""
import glob
import os
import re
import shutil
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor

ARM, RISCV = "arm-none-eabi-", "riscv64-unknown-elf-"
RISCV_CORE = ["-march=rv32imac", "-mabi=ilp32", "-mcmodel=medany"]
M0 = ["-mthumb", "-mcpu=cortex-m0"]
M3 = ["-mthumb", "-mcpu=cortex-m3"]     # only integers: any core from M3 up links like this one
M4F = ["-mthumb", "-mcpu=cortex-m4", "-mfpu=fpv4-sp-d16", "-mfloat-abi=hard"]
K, M = 1024, 1024 * 1024

# name, core, number type;
# machine of QEMU, set of objects, library;
# flags of the linker, flash and RAM (where, how much), most tests left out besides those
# of NOWHERE
BOARDS = [
    ("mps2-an385", "M3", "q16", "mps2-an385", "v7m-q16", "mps2-an385",
     M3, (0, 4 * M), (0x21000000, 16 * M), 2),
    ("riscv-virt", "rv32imac", "q16", "virt", "rv32-q16", "riscv-virt",
     RISCV_CORE, (0x80000000, 120 * M), (0x80000000, 120 * M), 1),
    ("nrf51", "M0", "q16", "microbit", "v6m-q16", "nrf51",
     M0, (0, 256 * K), (0x20000000, 16 * K), 47),
    ("stm32f405", "M4F", "q16", "netduinoplus2", "v7m-q16", "stm32f405",
     M3, (0x08000000, M), (0x20000000, 128 * K), 17),
    ("stm32f405", "M4F", "f32", "netduinoplus2", "v7em-f32", "stm32f405-f32",
     M4F, (0x08000000, M), (0x20000000, 128 * K), 17),
    ("mps2-an500", "M7", "q16", "mps2-an500", "v7m-q16", "mps2-an500",
     M3, (0, 4 * M), (0x60000000, 16 * M), 2),
    ("mps2-an505", "M33", "q16", "mps2-an505", "v7m-q16", "mps2-an505",
     M3, (0x10000000, 4 * M), (0x80000000, 16 * M), 2),
]
# bytes of RAM of an image besides its tests: the line of text, and data that the library's
# functions leave out
OWN = 1200
NOWHERE = {
    "flash_log": "it tests a memory of the boards, nothing of lib/",
    "slow": "chips plan with little effort, which has no slow runs",
    "cruise": "chips plan with little effort, which has no slow runs",
    "harmonic": "its tables are solved by code of the command, with a heap",
    "wire_page": "it reads a page of text",
    "yardstick": "it tests what other tests measure with, nothing of lib/",
    "text": "it compares with the printf and strtold of a whole C library",
    "topp": "it tests what other tests measure with, nothing of lib/",
}
NOT_HERE = {("nrf51", test): "this board's firmware does not plan"
            for test in ("planner", "patches")}
SECONDS = 600           # until we give up a chip that hangs, on a busy computer


def run(*command):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          errors="replace")


class Board:
    def __init__(self, made, row):
        self.made = made
        self.name, self.core, self.num, self.machine, self.set, self.library = row[:6]
        self.flags, self.flash, self.ram, self.most_left = row[6:]
        self.prefix = RISCV if self.set.startswith("rv32") else ARM
        self.label = f"{self.name} ({self.core}) {self.num}"
        self.rows, self.stack, self.data, self.text = [], {}, {}, {}
        self.failed = self.passed = self.properties = self.left = 0

    def row(self, good, text):
        self.rows.append(("ok   " if good else "FAIL ") + text)
        self.passed += good
        self.failed += not good

    def measure(self, tests):
        """Bytes of code and of data of each test's object."""
        objects = [f"{self.made}/{self.set}/test_{t}.o" for t in tests]
        for line in run(self.prefix + "size", *objects).stdout.splitlines()[1:]:
            text, data, bss, *_, name = line.split()
            test = re.search(r"test_(\w+)\.o", name)[1]
            self.text[test], self.data[test] = int(text) + int(data), int(data) + int(bss)

    def leave(self, test, why):
        self.rows.append(f"left {self.label} {test}: {why}")
        self.left += 1

    def images(self, tests, stack):
        """Rows of tests that fit in memory together."""
        images = []
        for test in sorted(tests, key=lambda t: self.data[t]):
            take, room = self.data[test] + stack.get(test, 64 * K), self.ram[1] - OWN
            if take > room:
                self.leave(test, f"it takes {take} bytes of RAM "
                           f"({stack.get(test, 0)} of them stack), there are {room}")
                continue
            for image in images:
                tests_in = image + [test]
                most_stack = max(stack.get(t, 64 * K) for t in tests_in)
                if (sum(self.data[t] for t in tests_in) + most_stack <= room
                        and sum(self.text[t] for t in tests_in) <= 0.45 * self.flash[1]):
                    image.append(test)
                    break
            else:
                images.append([test])
        return images

    def link(self, image, number):
        base = f"{self.made}/{self.name}-{self.num}/image{number}"
        os.makedirs(os.path.dirname(base), exist_ok=True)
        with open(base + ".c", "w") as f:
            f.write('#include "units.h"\n' + "".join(f"int main_{t}(void);\n" for t in image))
            rows = "".join(f'    {{ "{t}", main_{t} }},\n' for t in image)
            f.write("const struct unit units[] = {\n" + rows + "    { 0, 0 }\n};\n")
        arm = self.prefix == ARM
        script = "ports/cortex-m/cortex.ld.in" if arm else "ports/riscv-virt/virt.ld.in"
        memory = [f"-DFLASH={self.flash[0]}", f"-DFLASH_SIZE={self.flash[1]}",
                  f"-DRAM={self.ram[0]}", f"-DRAM_SIZE={self.ram[1]}"]
        said = run(self.prefix + "gcc", "-E", "-P", "-x", "c", *memory, script,
                   "-o", base + ".ld").stdout
        objects = f"{self.made}/{self.set}"
        support = sorted(glob.glob(f"{objects}/libc/*.o"))
        support += [f"{objects}/alarm.o", f"{objects}/units.o"]
        if arm:
            support += [f"{objects}/start_cortex.o", f"{self.made}/arm-semihost.o",
                        "-Wl,--no-warn-mismatch"]
        else:
            support += [f"{self.made}/riscv-start.o", f"{self.made}/riscv-semihost.o"]
        linked = run(self.prefix + "gcc", *self.flags, "-Itests/target", "-nostdlib",
                     "-Wl,--gc-sections", "-Wl,--no-warn-rwx-segments", "-T", base + ".ld",
                     *support, base + ".c", *[f"{objects}/test_{t}.o" for t in image],
                     f"{self.made}/{self.library}/libloft.a", "-lgcc", "-o", base + ".elf")
        return base + ".elf", "" if linked.returncode == 0 else said + linked.stdout

    def run_image(self, image, number):
        elf, wrong = self.link(image, number)
        if wrong:
            self.row(False, f"{self.label}: {' '.join(image)} cannot be linked")
            self.rows += ["     " + line for line in wrong.splitlines()[-6:]]
            return
        arm, riscv = ["qemu-system-arm"], ["qemu-system-riscv32", "-bios", "none"]
        qemu = arm if self.prefix == ARM else riscv
        said = run("timeout", str(SECONDS), *qemu, "-M", self.machine, "-nographic",
                   "-monitor", "none", "-serial", "none",
                   "-semihosting-config", "enable=on,target=native", "-kernel", elf)
        with open(elf[:-4] + ".log", "w") as f:
            f.write(said.stdout)
        self.judge(image, said)

    def judge(self, image, said):
        pending, begun = list(image), []
        for line in said.stdout.splitlines():
            ended = re.match(r"== (\w+) (\d+) (\d+)$", line)
            if not ended:
                begun.append(line)
                continue
            test, code, self.stack[ended[1]] = ended[1], int(ended[2]), int(ended[3])
            done = sum(b.startswith("ok ") for b in begun)
            good = code == 0 and done > 0 and not any(b.startswith("FAIL") for b in begun)
            self.properties += done
            self.row(good, f"{self.label} {test}: {done} properties, "
                     f"{self.data[test]} bytes of data, {self.stack[test]} of stack")
            self.rows += ["     " + b for b in begun if b.startswith("left") or not good]
            pending.remove(test)
            begun = []
        for test in pending:
            self.row(False, f"{self.label} {test}: no answer, QEMU ended with {said.returncode}")
            self.rows += ["     " + b for b in begun[-12:]]
            begun = []

    def work(self, tests, stack):
        begun = time.time()
        here = []
        for test in tests:
            why = NOWHERE.get(test) or NOT_HERE.get((self.name, test))
            if why:
                self.leave(test, why)
            else:
                here.append(test)
        self.measure(here)
        for number, image in enumerate(self.images(here, stack)):
            self.run_image(image, number)
        seen = self.passed + self.failed + self.left
        most = self.most_left + len(NOWHERE)
        self.row(self.left <= most and seen == len(tests),
                 f"{self.label}: {self.properties} properties of {self.passed} tests hold, "
                 f"{self.left} of {len(tests)} tests left out (at most {most}), "
                 f"{time.time() - begun:.0f} s")
        return self


def main(made, *only):
    tools = "qemu-system-arm", "qemu-system-riscv32", ARM + "gcc", RISCV + "gcc", "clang"
    missing = [t for t in tools if not shutil.which(t)]
    if missing:
        print(f"{', '.join(missing)} missing: make deps deps-target\n0 passed, 1 failed")
        return 1
    # loops that headers print run on a host: they call what other tests hold here
    tests = ["libc"] + sorted(re.search(r"test_(\w+)\.c", t)[1]
                              for t in glob.glob("tests/lib/**/test_*.c", recursive=True)
                              if not t.endswith("_loops.c"))
    first, *others = [Board(made, row) for row in BOARDS]
    known = {name for b in (first, *others) for name in (b.name, f"{b.name}-{b.num}")}
    unknown = sorted(set(only) - known)
    if unknown:
        print(f"UNIT_BOARDS: no {', '.join(unknown)}; there are {', '.join(sorted(known))}\n"
              "0 passed, 1 failed")
        return 1
    others = [b for b in others if not only or {b.name, f"{b.name}-{b.num}"} & set(only)]
    quad = run(f"{made}/quad_check")
    print(quad.stdout, end="")
    passed, failed = quad.returncode == 0, quad.returncode != 0
    boards = [first] + others
    small = [board for board in others if board.ram[1] < M]
    with ThreadPoolExecutor(2) as pool:
        jobs = {board: pool.submit(board.work, tests, {t: 64 * K for t in tests})
                for board in boards if board not in small}
        jobs[first].result()
        jobs.update({board: pool.submit(board.work, tests, first.stack) for board in small})
        for board in boards:
            print("\n".join(jobs[board].result().rows), flush=True)
    for board in boards:
        passed, failed = passed + board.passed, failed + board.failed
    print(f"{passed} passed, {failed} failed")
    return failed > 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
