# tests/e2e/pauses.py -- stops processes of whole jobs for moments, as a busy computer does
# SPDX-License-Identifier: MIT
"""usage: pauses.py SEED LONGEST; until it is killed

Each 20 ms a random process of the tests/e2e/e2e.sh that run in this folder (the command, its
helpers, the cases themselves) is stopped for up to LONGEST seconds. A case that needs one process
to be quicker than another fails in few runs. A process that its case has stopped stays so.
"""
import heapq
import os
import random
import signal
import sys
import time

CASES = b'build/e2e/', b'tests/e2e/'
AROUND = b'stress.sh', b'pauses.py'

def ours():
    """the processes whose command line names the folder of the helpers or that of the cases"""
    for pid in filter(str.isdigit, os.listdir('/proc')):
        try:
            words = open(f'/proc/{pid}/cmdline', 'rb').read()
            folder = os.readlink(f'/proc/{pid}/cwd')
        except OSError:
            continue
        if folder == os.getcwd() and any(w in words for w in CASES) \
                and not any(w in words for w in AROUND):
            yield int(pid)


def main():
    draw = random.Random(int(sys.argv[1]))
    longest = float(sys.argv[2])
    stopped, known, looked = [], [], 0
    while True:
        now = time.monotonic()
        while stopped and stopped[0][0] <= now:
            send(heapq.heappop(stopped)[1], signal.SIGCONT)
        if now - looked > 0.3:
            known, looked = list(ours()), now
        held = {pid for _, pid in stopped}
        pid = draw.choice(known) if known else None
        if pid and pid not in held and is_running(pid) and send(pid, signal.SIGSTOP):
            heapq.heappush(stopped, (now + longest * draw.random() ** 3, pid))
        time.sleep(0.02)


def is_running(pid):
    try:
        return open(f'/proc/{pid}/stat').read().rsplit(')', 1)[1].split()[0] not in 'TZ'
    except (OSError, IndexError):
        return False


def send(pid, number):
    try:
        os.kill(pid, number)
        return True
    except OSError:
        return False


main()
