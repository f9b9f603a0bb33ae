#!/usr/bin/env python3
# tests/e2e/grbl_peer.py -- a controller behind a pseudo terminal that speaks grbl's protocol as its
# documentation describes it
# SPDX-License-Identifier: MIT
"""usage: grbl_peer.py LINK PATH_FILE [--g5] [--locked] [--error LINE] [--alarm LINE] [--reset LINE]
                    [--mute LINE] [--mpos] [--nowco] [--late COUNT] [--twice] [--babble]
                    [--table MM] [--corner] [--inches] [--words] [--coloured] [--held LINE]
                    [--paced]

Written from grbl's wiki (Interface, Commands, Configuration) alone. A line takes a millisecond to
be read, the machine draws at 40 times the feed; 15 moves are planned ahead, then lines wait in a
buffer of 128 bytes: one more and the job has failed.
--words: errors are words, as some firmware writes them; --coloured: its greeting has control bytes.
--late: as a boot loader it hears nothing until it has been asked for its status so often; --twice:
it answers, and is reset when it is first asked for $I; --held: it stands before this line until it
has been held and released; --paced: a line is read when its status was asked for since the line
before; --nowco: MPos, and WCO never; --babble: another baud rate.
--table: x and y have MM of travel and soft limits, and the work coordinates begin 10 mm from the
lowest corner; --corner: that corner is 0 (HOMING_FORCE_SET_ORIGIN); --inches: reports them ($13=1).
At the end (a hang-up or SIGTERM) PATH_FILE has the places that were drawn, and a last line
`# lines N overflow N most N`.
"""
import math
import os
import pty
import re
import select
import signal
import sys
import time
import tty

RX, BLOCKS, SPEED = 128, 15, 40.0
WORD = re.compile(r"([A-Z])(-?\d*\.?\d+)")


class Peer:
    def __init__(self, master, options):
        self.master, self.o = master, options
        self.buffer, self.lines, self.overflow, self.most = b"", 0, 0, 0
        self.at, self.feed, self.motion, self.path = [0.0, 0.0, 0.0], 0.0, None, [(0.0, 0.0, 0.0)]
        self.blocks, self.polls, self.rate = [], 0, 100
        self.state = "Alarm" if options.get("locked") else "Idle"
        self.released, self.stands, self.seen = False, False, 0
        if not (self.o.get("late") or self.o.get("babble")):
            self.greet()

    def say(self, text):
        os.write(self.master, (text + "\r\n").encode())

    def greet(self):
        self.say("")
        colour = "\x1b]0;owned\x07\x1b[31m" if self.o.get("coloured") else ""
        self.say("Grbl 1.1h" + colour + " ['$' for help]")

    def offset(self):
        """Where the work zero is for the machine."""
        if not self.o.get("table"):
            return [10.0, 10.0, 10.0]
        low = 0.0 if self.o.get("corner") else -float(self.o["table"])
        return [low + 10.0, low + 10.0, -5.0]

    def settings(self):
        table = self.o.get("table")
        size = float(table or 200)
        lines = ["$0=10", "$10=0", f"$13={int(bool(self.o.get('inches')))}",
                 f"$20={int(bool(table))}", "$22=1", "$23=3", "$24=25.000", "$27=1.000",
                 "$100=250.000", "$101=250.000", "$102=100.000", "$110=1200.000", "$111=1200.000",
                 "$112=300.000", "$120=80.000", "$121=80.000", "$122=20.000",
                 f"$130={size:.3f}", f"$131={size:.3f}", "$132=60.000"]
        for line in lines:
            self.say(line)

    # bytes that act at once
    def realtime(self, byte):
        if byte == ord("?"):
            self.polls += 1
            machine = self.o.get("mpos") or self.o.get("nowco")
            offset = self.offset()
            place = [a + b for a, b in zip(self.at, offset)] if machine else self.at
            unit = 25.4 if self.o.get("inches") else 1.0
            place = [a / unit for a in place]
            name = "MPos" if machine else "WPos"
            moving = "Run" if self.blocks or self.stands else "Idle"
            state = self.state if self.state in ("Alarm", "Hold:0") else moving
            text = (f"<{state}|{name}:{place[0]:.3f},{place[1]:.3f},{place[2]:.3f}"
                    f"|FS:{self.feed if self.blocks else 0:.0f},0")
            if self.polls % 10 == 1 and not self.o.get("nowco"):
                text += "|WCO:" + ",".join(f"{b / unit:.3f}" for b in offset)
            self.say(text + (f"|Ov:{self.rate},100,100>" if self.polls % 10 == 2 else ">"))
        elif byte == ord("!"):
            self.state = "Hold:0"
        elif byte == ord("~"):
            self.released = self.released or self.state == "Hold:0"
            self.state = "Idle"
        elif byte == 0x18:
            self.buffer, self.blocks, self.state = b"", [], "Idle"
            self.greet()
        elif byte in (0x90, 0x91, 0x92):
            step = 10 if byte == 0x91 else -10
            self.rate = 100 if byte == 0x90 else min(200, max(10, self.rate + step))
        else:
            return False
        return True

    def booting(self, data):
        """Is it not there yet?"""
        if self.o.get("late", 0) > 0:
            self.o["late"] -= data.count(b"?")
            if self.o["late"] <= 0:
                self.greet()
            return True
        return False

    def take(self, data):
        if self.o.get("babble"):
            os.write(self.master, bytes(b ^ 0x96 for b in data) + b"\r\n")
            return
        if self.booting(data):
            return
        for byte in data:
            if byte in b"?!~" or byte == 0x18 or byte >= 0x80:
                self.realtime(byte)
            else:
                self.buffer += bytes([byte])
        self.most = max(self.most, len(self.buffer))
        self.overflow += len(self.buffer) > RX

    # one line
    def work(self):
        while self.blocks and self.state != "Hold:0" and self.blocks[0] <= time.monotonic():
            self.blocks.pop(0)
        if b"\n" not in self.buffer or len(self.blocks) >= BLOCKS or self.state == "Hold:0":
            return
        self.stands = (self.lines + 1 == self.o.get("held") and not self.released
                       or self.o.get("paced") and self.lines > 0 and self.seen == self.polls)
        if self.stands:
            return
        self.seen = self.polls
        line, self.buffer = self.buffer.split(b"\n", 1)
        text = line.decode("ascii", "replace").strip().upper()
        if text == "$I" and self.o.pop("twice", False):
            self.realtime(0x18)
            return
        if text == "$I":
            self.say("[VER:1.1h.20190830:]")
            self.say(f"[OPT:V{'Z' if self.o.get('corner') else ''},{BLOCKS},{RX}]")
            self.say("ok")
            return
        if text == "$$":
            self.settings()
            self.say("ok")
            return
        if not text:
            self.say("ok")
            return
        self.lines += 1
        if self.o.get("alarm") == self.lines:
            self.state, self.blocks = "Alarm", []
            self.say("ALARM:2")
            return
        if self.o.get("reset") == self.lines:
            self.realtime(0x18)
            return
        answer = self.obey(text)
        if self.o.get("mute") != self.lines:        # otherwise the answer is lost on the line
            self.say(answer)
        time.sleep(0.001)

    def obey(self, text):
        if self.state == "Alarm":
            return "error:9"
        if self.o.get("error") == self.lines:
            return "error:Unsupported command\x1b[2J" if self.o.get("words") else "error:2"
        words = WORD.findall(text)
        if "".join(a + b for a, b in words) != text:
            return "error:2"
        value = {}
        for letter, number in words:
            if letter == "G":
                if number in ("21", "90", "94", "17"):
                    continue
                if number not in ("0", "1", "2", "3") and not (number == "5" and self.o.get("g5")):
                    return "error:20"
                self.motion = number
            elif letter in value or letter not in "XYZIJPQF":
                return "error:25"
            else:
                value[letter] = float(number)
        self.feed = value.pop("F", self.feed)
        if not value:
            return "ok"
        if self.motion is None or self.feed <= 0:
            return "error:22"
        return self.move(value)

    def move(self, v):
        start, end = list(self.at), [v.get("XYZ"[i], self.at[i]) for i in range(3)]
        if self.motion in "23":
            points = self.arc(v, start, end)
            if points is None:
                return "error:33"
        elif self.motion == "5":
            c = [start[:2], [start[0] + v["I"], start[1] + v["J"]],
                 [end[0] + v["P"], end[1] + v["Q"]], end[:2]]
            points = []
            for k in range(1, 65):
                t = k / 64
                b = ((1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3)
                point = tuple(sum(b[j] * c[j][i] for j in range(4)) for i in (0, 1))
                points.append(point + (end[2],))
        else:
            points = [tuple(end)]
        length = 0.0
        for p in points:
            length += math.dist(self.path[-1], p)
            self.path.append(p)
        self.at = end
        begin = self.blocks[-1] if self.blocks else time.monotonic()
        self.blocks.append(begin + length / self.feed * 60 / SPEED)
        return "ok"

    def arc(self, v, start, end):
        cx, cy = start[0] + v.get("I", 0), start[1] + v.get("J", 0)
        r, s = math.hypot(start[0] - cx, start[1] - cy), math.hypot(end[0] - cx, end[1] - cy)
        if abs(r - s) > 0.005 and abs(r - s) > 0.001 * r:
            return None
        a, b = math.atan2(start[1] - cy, start[0] - cx), math.atan2(end[1] - cy, end[0] - cx)
        turn = (b - a) % (2 * math.pi) if self.motion == "3" else -((a - b) % (2 * math.pi))
        n = max(2, int(abs(turn) * r / 0.05))
        angles = [a + turn * k / n for k in range(1, n)]
        return [(cx + r * math.cos(t), cy + r * math.sin(t), end[2]) for t in angles] + [tuple(end)]


def main():
    link, out = sys.argv[1:3]
    options, words = {}, sys.argv[3:]
    while words:
        name = words.pop(0)[2:]
        options[name] = int(words.pop(0)) if words and words[0].isdigit() else True
    master, slave = pty.openpty()
    tty.setraw(slave)
    os.symlink(os.ttyname(slave), link)
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(0))
    peer = Peer(master, options)
    try:
        while True:
            if select.select([master], [], [], 0.001)[0]:
                peer.take(os.read(master, 1024))
            peer.work()
    finally:
        with open(out, "w") as f:
            for p in peer.path:
                f.write("%.4f,%.4f,%.4f\n" % p)
            f.write(f"# lines {peer.lines} overflow {peer.overflow} most {peer.most}\n")


if __name__ == "__main__":
    main()
