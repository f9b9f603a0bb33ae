#!/usr/bin/env python3
# tests/lib/wire/wire_peer.py -- a peer written from lib/wire/WIRE.md alone: decodes its examples,
# and says each as the page does
# SPDX-License-Identifier: MIT
"""usage: wire_peer.py [PAGE]

Exits with 1 if an example's bytes do not say what stands above them."""
import re
import struct
import sys

AXES = 3
HOST = {1: ('HELLO', 'min_version:B max_version:B nonce:X'),
        2: ('JOB', 'nonce:X id:X kind:B away:H start:A'), 5: ('END', 'total:I'),
        6: ('CONTROL', 'number:B verb:B value:B'), 7: ('POLL', ''),
        15: ('SET', 'at:H bytes:Z')}
STANDING = 'next:I limit:I executed:I state:B flags:B refusal:B control:B '
MACHINE = {0: ('KEPT', 'at:H room:H origin:B bytes:Z'),
           8: ('WELCOME', 'version:B nonce:X boot:X job:X ' + STANDING +
               'axes:B num:B frame_max:B queue:H tick_hz:H slots:H '
               'kinds:B curves:H points:H closed:H outputs:B columns:H'),
           9: ('AXIS', 'number:B steps_per_mm:i max_speed:i max_accel:i position:i start:i'),
           10: ('ACK', STANDING),
           11: ('STATUS', STANDING + 'ticks:I elapsed:I slowed:I damaged:I dropped:I '
                'override:B closed:H position:A'),
           12: ('REPORT', 'job:X items:I ticks:I elapsed:I slowed:I '
                'state:B ended_by:H position:A')}
LIMITS = 'corner:i tol:i ' + 'limits:L ' * AXES
ITEMS = {3: 'SPANS', 4: 'POINTS', 13: 'FINE', 14: 'CURVES'}
WORD = 0xFFFFFFFF


def crc32c(data, crc=WORD):
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = crc >> 1 ^ (0x82F63B78 if crc & 1 else 0)
    return crc


def signed(x):
    return (x & WORD) - (1 << 32 if x & 0x80000000 else 0)


class Decoder:
    """position, change and bend per axis, and ticks: where the next item is expected"""

    def job(self, start):
        self.position, self.change, self.bend = list(start), [0] * AXES, [0] * AXES
        self.ticks = 0

    def seal(self):
        words = [x & WORD for a in zip(self.position, self.change, self.bend) for x in a]
        return crc32c(struct.pack('<%dI' % (3 * AXES + 1), *words, self.ticks))

    def varint(self, data):
        x = shift = 0
        while True:
            b = data.pop(0)
            x, shift = x | (b & 127) << shift, shift + 7
            if b < 128:
                return x

    def residual(self, data):
        z = self.varint(data)
        return z >> 1 if z % 2 == 0 else -(z + 1 >> 1)

    def spans(self, data, _):
        while data:
            if data[0] == 0:
                yield self.action(data)
                continue
            before, self.ticks = self.ticks, self.varint(data)
            form, points = self.varint(data), []
            rest = [self.residual(data) if form >> k & 1 else 0 for k in range(3 * AXES)]
            for i in range(AXES):
                p0 = self.position[i]
                p1 = p0 + self.stretched(self.change[i], before) + rest[2 * AXES + i]
                bend = self.stretched(self.stretched(self.bend[i], before), before)
                p2 = 2 * p1 - p0 + bend + rest[AXES + i]
                p3 = rest[i] + 3 * p2 - 3 * p1 + p0
                points.append([signed(p) for p in (p1, p2, p3)])
                self.position[i], self.change[i] = signed(p3), signed(p3 - p2)
                self.bend[i] = signed(p3 - 2 * p2 + p1)
            p1, p2, p3 = (','.join(map(str, p)) for p in zip(*points))
            yield 'ticks=%d p1=%s p2=%s p3=%s' % (self.ticks, p1, p2, p3)

    def stretched(self, x, before):
        if before in (0, self.ticks):
            return x
        size = (abs(x) * self.ticks + before // 2 & WORD) // before
        return signed(size if x >= 0 else -size)

    def action(self, data):
        what = data[1]
        del data[:2]
        power = self.varint(data)
        for i in range(AXES):
            self.position[i], self.change[i] = self.position[i] + self.residual(data), 0
            self.bend[i] = 0
        self.ticks = 0
        return 'what=%d level=%d feed=%d p3=%s' % (
            what, power & 65535, power >> 16, ','.join(map(str, self.position)))

    def curves(self, data, _):
        feed = self.ticks
        while data:
            form, points = data.pop(0), []
            feed = self.varint(data) if form & 128 else feed
            if form & 128 and feed == 0:
                feed = 1
                yield self.part(data, form)
                continue
            for i in range(AXES):
                p0 = p1 = p2 = p3 = self.position[i]
                if form >> i & 1 and form & 64:
                    e = signed(self.residual(data))
                    third = (2 * abs(e) + 3) // 6 * (1 if e > 0 else -1)        # to the nearest
                    p1, p2, p3 = p0 + third, p0 + e - third, p0 + e
                elif form >> i & 1:
                    p1 = self.residual(data) + p0 + self.change[i]
                    p2 = self.residual(data) + 2 * p1 - p0
                    p3 = self.residual(data) + 3 * p2 - 3 * p1 + p0
                points.append([signed(p) for p in (p1, p2, p3)])
                self.position[i], self.change[i], self.bend[i] = signed(p3), signed(p3 - p2), 0
            self.ticks = feed
            p1, p2, p3 = (','.join(map(str, p)) for p in zip(*points))
            yield 'feed=%d p1=%s p2=%s p3=%s' % (feed, p1, p2, p3)

    def part(self, data, form):
        """of a patch: a head, or two of its points"""
        points = []
        for i in range(AXES):
            p0 = self.position[i]
            e1, e2 = [self.residual(data) if form >> i & 1 else 0 for _ in range(2)]
            p1 = signed(p0 + self.change[i] + e1)
            p2 = signed(p1 + e2)
            points.append([p1, p2, p0])
            self.change[i], self.bend[i] = signed(p2 - p0), 0
        self.ticks = 1
        return 'feed=0 p1=%s p2=%s p3=%s' % tuple(','.join(map(str, p)) for p in zip(*points))

    def group(self, data, axes):
        b = data.pop(0)
        if b < 125:
            return [b % 5 - 2, b // 5 % 5 - 2, b // 25 - 2][:axes]
        form = {125: 'b', 126: 'h', 127: 'i'}[b]
        size = struct.calcsize(form)
        return [struct.unpack('<' + form, bytes(data.pop(0) for _ in range(size)))[0]
                for _ in range(axes)]

    def points(self, data, kind):
        while data:
            runs = data.pop(0) - 127 if data[0] >= 128 else 0
            for _ in range(max(runs, 1)):
                r = [0] * AXES if runs else [x for first in range(0, AXES, 3)
                                             for x in self.group(data, min(3, AXES - first))]
                for i in range(AXES):
                    self.bend[i] = r[i] + (self.bend[i] if kind == 13 else 0)
                    self.change[i] += self.bend[i]
                    self.position[i] = signed(self.position[i] + self.change[i])
                yield 'point=' + ','.join(map(str, self.position))

    def frame(self, wire):
        """the text of one frame, as on the page; ValueError if it is damaged, or not sealed for
        where this decoder stands"""
        wire, data = wire.lstrip(b'\0').rstrip(b'\0'), bytearray()
        while wire:
            data, wire = data + wire[1:wire[0]] + b'\0', wire[wire[0]:]
        content, check = data[:-5], struct.unpack('<I', data[-5:-1])[0]
        kind, session, payload = content[0] >> 4, content[1], bytearray(content[2:])
        expected = crc32c(b'loft' + content) ^ WORD ^ (self.seal() if kind in ITEMS else 0)
        if check != expected:
            raise ValueError('check %08X, expected %08X' % (check, expected))
        if kind in ITEMS:
            first, count = struct.unpack('<HB', payload[:3])
            items = list({3: self.spans, 14: self.curves}.get(kind, self.points)(payload[3:], kind))
            if len(items) != count:
                raise ValueError('%d items, %d announced' % (len(items), count))
            head = '%s session=%d first=%d count=%d' % (ITEMS[kind], session, first, count)
            return ' '.join([head] + items)
        name, fields = (HOST if kind in HOST else MACHINE)[kind]
        said = [name] + (['session=%d' % session] if kind != 1 else [])
        if kind == 2 and payload[8] & 127 == 4:
            fields += ' ' + LIMITS
        if kind == 2 and payload[8] & 128:
            fields = fields.replace('start:', 'guard:G start:')
        if kind == 6 and payload[1] >= 6:
            fields += ' position:A'
        if kind == 12 and len(payload) > 23 + 4 * AXES:
            fields += ' latched:A'
        for field in fields.split():
            label, form = field.split(':')
            if form == 'Z':
                said.append('%s=%s' % (label, payload.hex().upper()))
                payload = bytearray()
                continue
            n = AXES if form == 'A' else 1
            form = {'X': 'I', 'A': 'i', 'L': 'iiI', 'G': 'HBB'}.get(form, form)
            form = '<' + form * n
            size = struct.calcsize(form)
            value, payload = struct.unpack(form, payload[:size]), payload[size:]
            if kind == 2 and label == 'start':
                self.job(value)
            text = '0x%08X' % value if field.endswith('X') else ','.join(map(str, value))
            said.append('%s=%s' % (label, text))
        if payload:
            raise ValueError('%d bytes too many' % len(payload))
        return ' '.join(said)


def main(name='lib/wire/WIRE.md'):
    decoder, bad, count = Decoder(), 0, 0
    for block in re.findall(r'```\n(.*?)```', open(name, encoding='utf-8').read(), re.S):
        for text, wire in re.findall(r'((?:^(?!    [0-9A-F]{2} ).+\n)+)'
                                     r'((?:^    (?:[0-9A-F]{2} ?)+\n)+)', block, re.M):
            count += 1
            try:
                said = decoder.frame(bytes.fromhex(wire))
            except (ValueError, KeyError, IndexError, struct.error) as error:
                said = 'refused: %s' % error
            if said != ' '.join(text.split()):
                bad += 1
                print('FAIL wire page: %s\n     bytes: %s' % (' '.join(text.split()), said))
    good = 'ok   wire page: a peer written from it decodes its examples'
    print(good if count and not bad else '%d examples' % count)
    print('%d passed, %d failed' % (count - bad, bad or not count))
    return bad or not count


if __name__ == '__main__':
    sys.exit(1 if main(*sys.argv[1:]) else 0)
