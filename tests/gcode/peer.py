#!/usr/bin/env python3
# tests/gcode/peer.py -- compares the G-code reader with LinuxCNC's stand-alone interpreter
# SPDX-License-Identifier: MIT
"""usage: peer.py CANON [--cases N] [--seed N] [FILE|FOLDER..]

Each program is run by rs274 (Debian's linuxcnc-uspace) and by CANON (tests/gcode/canon.c). All
motions must agree in every printed digit: ends, centres, turns; and in mm of the machine and in
feed to the four printed digits. Without files, programs are made from a seed. The last line is
`N passed, N failed`. LOFT_RS274 names another rs274.
"""
import math
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile

CALL = re.compile(r'\s*\d+\s+N(?:\d+|\.+)\s*([A-Z0-9_]+)\((.*)\)\s*$')
TOOLS = {1: (6.0, 12.5), 2: (3.0, 20.0), 3: (0.25, 1.0)}     # diameter and length, mm
MOTIONS = ('STRAIGHT_TRAVERSE', 'STRAIGHT_FEED', 'ARC_FEED', 'NURBS_FEED', 'DWELL')
# what this reader does not run, and says so
NOT_RUN = re.compile(r': ([ABCUVW]: this machine|'
                     r'G\S+: is not known here|M\S+: is not known here|'
                     r'G10 without L2|G7: diam|G\S+: a file cannot probe)')
# rs274 alone does otherwise: it refuses what no program of a machine stands for, and G1 without F;
# it confuses the axes of a tap in other planes, and after M6 it forgets the tool's new length
PEER_ALONE = re.compile(r'Unknown m code used: M1\d\d|with zero feed rate')
PEER_CORNER = re.compile(r'Arc move in concave corner')
PEER_WRONG = re.compile(r'G0?18\b.*G84|G0?19\b.*G84|M0?6\s*G43', re.DOTALL | re.IGNORECASE)


def numbers(text):
    return [float(n) for n in re.findall(r'-?\d+\.\d+|-?\d+', text)]


class Peer:
    """The machine behind rs274's canonical functions."""

    def __init__(self):
        self.unit, self.degrees, self.feed = 1.0, 0.0, 0.0
        self.g5x, self.g92, self.tool = [0.0] * 3, [0.0] * 3, [0.0] * 3
        self.per_turn = False

    def take(self, name, args):
        values = numbers(args)
        if name == 'USE_LENGTH_UNITS':
            unit = 25.4 if 'INCHES' in args else 1.0
            for held in (self.g5x, self.g92, self.tool):
                held[:] = [n * self.unit / unit for n in held]
            self.feed *= self.unit / unit
            self.unit = unit
        elif name == 'SET_G5X_OFFSET':
            self.g5x = values[1:4]
        elif name == 'SET_G92_OFFSET':
            self.g92 = values[:3]
        elif name == 'SET_XY_ROTATION':
            self.degrees = values[0]
        elif name == 'USE_TOOL_LENGTH_OFFSET':
            self.tool = values[:3]
        elif name == 'SET_FEED_MODE':
            self.per_turn = args.strip().endswith('1')
        elif name == 'SET_FEED_RATE':
            self.feed = values[0]

    def place(self, at):
        x, y = at[0] + self.g92[0], at[1] + self.g92[1]
        c, s = math.cos(math.radians(self.degrees)), math.sin(math.radians(self.degrees))
        where = [c * x - s * y, s * x + c * y, at[2] + self.g92[2]]
        return [(w + o + t) * self.unit for w, o, t in zip(where, self.g5x, self.tool)]


def run_peer(rs274, table, name, folder):
    """The motions: [function with its numbers, place in mm or None, feed in mm/min], or None."""
    var = os.path.join(folder, 'peer.var')
    for old in (var, var + '.bak'):
        if os.path.exists(old):
            os.remove(old)
    open(var, 'w').close()
    got = subprocess.run([rs274, '-t', table, '-v', var, '-g', name], capture_output=True,
                         text=True, errors='replace', timeout=300, cwd=folder, check=False)
    machine, out, plane = Peer(), [], 2
    for line in got.stdout.splitlines():
        match = CALL.match(line)
        if not match:
            continue
        call, args = match.groups()
        if call == 'SELECT_PLANE':
            plane = {'XY': 2, 'XZ': 1, 'YZ': 0}[args[-2:]]
        if call not in MOTIONS:
            machine.take(call, args)
            continue
        values = [n.strip() for n in args.split(',')]
        place = None
        if call.startswith('STRAIGHT'):
            values = values[:3]
            place = machine.place([float(n) for n in values])
        elif call == 'ARC_FEED':
            values = values[:6]
            end = [0.0] * 3
            end[(plane + 1) % 3], end[(plane + 2) % 3] = float(values[0]), float(values[1])
            end[plane] = float(values[5])
            place = machine.place(end)
        elif call == 'NURBS_FEED':
            values = values[:1]
        said = re.sub(r'-0\.0000\b', '0.0000', '%s(%s)' % (call, ', '.join(values)))
        if said != 'DWELL(0.0000)':
            out.append([said, place, None if machine.per_turn else machine.feed * machine.unit])
    # it ends with code 0 also after an error: that is one line on standard error
    bad = [n for n in got.stderr.splitlines()
           if n.strip() and not n.startswith(('executing', 'link (', 'rename'))]
    return out, got.returncode != 0 or bool(bad), ' '.join(bad[-2:])


def run_own(canon, name, machine):
    got = subprocess.run([canon, name, machine], capture_output=True, text=True, errors='replace',
                         timeout=300, check=False)
    out = []
    for line in got.stdout.splitlines():
        said, place = line.rsplit(' | ', 1)
        number, call = said.split(' ', 1)
        if call.startswith(MOTIONS) and call != 'DWELL(0.0000)':
            place = [float(n) for n in place.split()]
            out.append([re.sub(r'-0\.0000\b', '0.0000', call), place[:3], place[3], number])
    return out, got.returncode, got.stderr.strip()


def differ(peer, own):
    """None, or the first difference."""
    for n, (a, b) in enumerate(zip(peer, own)):
        if a[0] != b[0]:
            return 'motion %d, line %s: %s, not %s' % (n + 1, b[3], b[0], a[0])
        # four digits in inches, of three sums
        if a[1] and max(abs(x - y) for x, y in zip(a[1], b[1])) > 0.0051:
            return 'motion %d, line %s: at %s mm, not %s' % (n + 1, b[3], b[1], a[1])
        fed = a[0].startswith(('STRAIGHT_FEED', 'ARC')) and b[2] > 0 and a[2] is not None
        if fed and abs(a[2] - b[2]) > 0.003 + 1e-6 * a[2]:
            return 'motion %d, line %s: feed %g, not %g' % (n + 1, b[3], b[2], a[2])
    if len(peer) != len(own):
        rest = (peer if len(peer) > len(own) else own)[min(len(peer), len(own))]
        return '%d motions, not %d: %s' % (len(own), len(peer), rest[0])
    return None


def goes_around(own, n):
    """Does the tool leave arc n without a bend, and turn around a corner at its radius? A rapid
    goes straight instead."""
    if len(own) > n + 1 and own[n + 1][0].startswith('STRAIGHT_TRAVERSE'):
        return own[n][0].startswith('ARC_FEED')
    if len(own) < n + 2 or not all(m[0].startswith('ARC_FEED') for m in own[n:n + 2]):
        return False
    x, y, cx, cy, turn = numbers(own[n][0])[:5]
    ex, ey, ox, oy, back = numbers(own[n + 1][0])[:5]
    sides = turn * back             # both turn to the same side, or not
    away, arm, end = (x - cx, y - cy), (x - ox, y - oy), (ex - ox, ey - oy)
    sizes = [math.hypot(*v) for v in (away, arm, end)]
    bend = (away[0] * arm[1] - away[1] * arm[0]) / (sizes[0] * sizes[1])
    along = away[0] * arm[0] + away[1] * arm[1]
    turned = (arm[0] * end[1] - arm[1] * end[0]) * back
    # four digits of each number
    return abs(bend) < 3e-4 / min(sizes) and sides * along > 0 and \
        abs(sizes[1] - sizes[2]) < 3e-4 and turned > 0


class Maker:
    """A random program of what both run."""

    def __init__(self, seed):
        self.r, self.odd = random.Random(seed), seed % 2

    def number(self, most=50):
        return round(self.r.uniform(-most, most), self.r.choice((0, 1, 2, 3, 4)))

    def axes(self, some=True):
        words = [a + str(self.number()) for a in 'XYZ' if self.r.random() < 0.6]
        return ' '.join(words) or ('X' + str(self.number()) if some else '')

    def arc(self, state):
        """A full arc in the plane that the state names, incremental centre, exact ends."""
        a, b = {'G17': 'XY', 'G18': 'ZX', 'G19': 'YZ'}[state['plane']]
        ia, ib = {'X': 'I', 'Y': 'J', 'Z': 'K'}[a], {'X': 'I', 'Y': 'J', 'Z': 'K'}[b]
        # quarters and halves of circles have exact ends in any unit
        r = round(self.r.uniform(0.5, 20), 3)
        i, j = self.r.choice(((r, 0), (0, r), (-r, 0), (0, -r)))
        turn = self.r.choice(('G2', 'G3'))
        quarter = self.r.choice(((i + j, j - i), (i - j, i + j), (2 * i, 2 * j), (0, 0)))
        other = ({'X', 'Y', 'Z'} - {a, b}).pop()
        helix = ' %s%s' % (other, self.number(5)) if self.r.random() < 0.3 else ''
        turns = ' P%d' % self.r.randint(1, 3) if self.r.random() < 0.2 else ''
        words = '%s%.4f %s%.4f' % (a, quarter[0], b, quarter[1])
        if self.r.random() < 0.3 and quarter != (0, 0):
            size = math.hypot(*quarter) * self.r.uniform(0.51, 3)
            return 'G91 %s %s%s%s R%.4f' % (turn, words, helix, turns,
                                            self.r.choice((1, -1)) * size)
        return 'G91 %s %s%s%s %s%.4f %s%.4f' % (turn, words, helix, turns, ia, i, ib, j)

    def drill(self):
        code = self.r.choice(('G81', 'G82', 'G83', 'G73', 'G85', 'G89', 'G84', 'G74', 'G86', 'G87'))
        plane, a, b, up = self.r.choice((('G17', 'X', 'Y', 'Z'), ('G17', 'X', 'Y', 'Z'),
                                         ('G18', 'Z', 'X', 'Y'), ('G19', 'Y', 'Z', 'X')))
        if code in ('G84', 'G74'):      # this rs274 confuses their axes in other planes
            plane, a, b, up = 'G17', 'X', 'Y', 'Z'
        words = '%s G90 %s %s %s%s %s%s %s%s R%s' % (
            plane, self.r.choice(('G98', 'G99')), code, a, self.number(), b, self.number(),
            up, round(self.r.uniform(-9, 0), 2), round(self.r.uniform(0, 5), 2))
        if code in ('G82', 'G89', 'G84', 'G74', 'G86'):
            words += ' P%s' % round(self.r.uniform(0.1, 3), 2)
        if code in ('G83', 'G73'):
            words += ' Q%s' % round(self.r.uniform(0.5, 3), 2)
        if code == 'G87':
            words += ' I%s J%s K%s' % (self.number(2), self.number(2),
                                       round(self.r.uniform(0, 3), 2))
        lines = ['%s S100' % ('M4' if code == 'G74' else 'M3'), words]
        for _ in range(self.r.randint(0, 3)):
            again = '' if code == 'G74' else ' L2'      # which this rs274 refuses
            lines.append(self.r.choice((a + '%s', b + '%s', a + '%s' + again,
                                        up + '-9 ' + a + '%s')) % self.number())
        if self.r.random() < 0.4:
            lines = [n.replace('G90', 'G91') for n in lines]
        return lines + ['G80 G90 M5']

    def line(self, state):
        kind = self.r.random()
        if kind < 0.3:
            return [self.r.choice(('G0 ', 'G1 ', 'G1', 'g 1 ')) + self.axes()]
        if kind < 0.5:
            return [self.arc(state), self.r.choice(('G90', 'G91'))]
        if kind < 0.56:
            state['plane'] = self.r.choice(('G17', 'G18', 'G19'))
            return [state['plane']]
        if kind < 0.6:
            # this rs274 keeps a tool's length as a number when the unit changes: none is set then
            return ['G49', self.r.choice(('G20', 'G21'))]
        if kind < 0.65:
            return [self.r.choice(('G90', 'G91'))]
        # this rs274 leaves G92's shift out when it turns its own place: a program has one of them
        if kind < 0.69 and not state['turns']:
            return [self.r.choice(('G92 ', 'G52 ')) + self.axes()]
        if kind < 0.72 and not state['turns']:
            return [self.r.choice(('G92.1', 'G92.2', 'G92.3'))]
        if kind < 0.77:
            if self.r.random() < 0.5:
                return ['G10 L20 P%d %s' % (self.r.randint(0, 9), self.axes())]
            turn = ' R%s' % self.number(90) if state['turns'] and self.r.random() < 0.5 else ''
            return ['G10 L2 P%d %s%s' % (self.r.randint(0, 9), self.axes(), turn)]
        if kind < 0.82:
            return ['G' + self.r.choice('54 55 56 57 58 59 59.1 59.2 59.3'.split())]
        if kind < 0.85:
            return ['F%.2f' % self.r.uniform(1, 2000)]
        if kind < 0.88:
            return ['G4 P%.2f' % self.r.uniform(0, 2)]
        if kind < 0.91:
            return [self.r.choice(('G43.1 Z%s' % self.number(9), 'G43 H%d' % self.r.randint(1, 3),
                                   'G49'))]
        if kind < 0.93:
            return [self.r.choice(('G28', 'G30', 'G28.1', 'G30.1', 'G28 Z%s' % self.number()))]
        if kind < 0.97:
            back = state['plane']
            return self.drill() + [back]
        if kind < 0.975:
            # this rs274 saves that there is a tool's length, and brings it back as that of the tool
            return ['F%.1f' % self.r.uniform(1, 2000), 'G49', 'M70']
        if kind < 0.98:
            return ['M72', state['plane']]
        if kind < 0.985:
            return ['G93 G1 F%.2f %s' % (self.r.uniform(0.5, 10), self.axes()), 'G94 F300']
        p = self.r.randint(1, 99)
        return ['#%d = [%s * 2 + ABS[%s]]' % (p, self.number(9), self.number(9)),
                'G1 X#%d Y[#%d / 3 - 1] Z[SIN[#%d] ** 2]' % (p, p, p)]

    def beside(self):
        """Lines and arcs at the side of which the tool goes, and a way out."""
        at = [0.0, 0.0]
        r = self.r
        side = r.choice(('G41', 'G42'))
        tool = r.choice((' D1', ' D2', '.1 D2.5', ''))
        lines = [r.choice(('G17', 'G18')), 'G0 X0 Y0 Z0', 'T%d M6' % r.randint(1, 2),
                 side + tool]
        first, second = ('X', 'Y') if lines[0] == 'G17' else ('Z', 'X')
        arms = ('I', 'J') if lines[0] == 'G17' else ('K', 'I')
        across = 'Z' if lines[0] == 'G17' else 'Y'
        way = r.uniform(0, 360)
        for n in range(r.randint(2, 12)):
            way += r.choice((0, 90, -90, 180, 45, 1, -1, r.uniform(-180, 180)))
            back = list(at)
            if n > 0 and r.random() < 0.4:
                size, turn = r.uniform(1, 20), r.choice((1, -1))
                centre = [at[i] + size * turn * f(math.radians(way)) for i, f in
                          enumerate((lambda a: -math.sin(a), math.cos))]
                sweep = r.choice((90, 180, 360, r.uniform(5, 350))) * turn
                c, s = math.cos(math.radians(sweep)), math.sin(math.radians(sweep))
                arm = [at[i] - centre[i] for i in range(2)]
                at = [centre[0] + c * arm[0] - s * arm[1], centre[1] + s * arm[0] + c * arm[1]]
                at = back if abs(sweep) == 360 else [round(x, 6) for x in at]
                centre = [round(centre[i] - back[i], 6) for i in range(2)]
                lines.append('%s %s%.6f %s%.6f %s%.6f %s%.6f' % (
                    'G3' if turn > 0 else 'G2', first, at[0], second, at[1], arms[0], centre[0],
                    arms[1], centre[1]))
                way += sweep
            else:
                size = r.uniform(5, 40) if n == 0 else r.uniform(0.2, 40)
                at = [round(at[0] + size * math.cos(math.radians(way)), 6),
                      round(at[1] + size * math.sin(math.radians(way)), 6)]
                lines.append('%s %s%.6f %s%.6f' % (r.choice(('G1', 'G1', 'G1', 'G0')), first,
                                                   at[0], second, at[1]))
            if r.random() < 0.2:
                lines.append(r.choice(('G4 P0.5', 'G1 %s%s' % (across, self.number(5)))))
        lines.append('G40')
        return lines + ['G1 %s%s %s%s' % (first, self.number(), second, self.number()), 'G17']

    def expression(self):
        """Of parameters that are set everywhere; small."""
        r = self.r
        return r.choice(('#1', '#2', '#3', '[#31 + %s]' % self.number(5), '#<own>', '#<_all>',
                         '[#<own> * 0.5 - #1]', '[ABS[#2] MOD 7]', '[#<_all> + #3 / 3]',
                         '[[#1 LT #2] + 2 * [#3 GE #<own>]]', '#5420',
                         '[FIX[#<own>] + ROUND[#3]]', '[EXISTS[#<own>] + EXISTS[#<none>]]',
                         '#<_call_level>', str(self.number(9))))

    def assignment(self):
        return '%s = [%s MOD 20]' % (self.r.choice(('#1', '#2', '#3', '#31', '#<own>', '#<_all>')),
                                     self.expression())

    def condition(self):
        return '[%s %s %s]' % (self.expression(), self.r.choice('LT GT LE GE EQ NE'.split()),
                               self.expression())

    def label(self):
        self.labels += 1
        return self.r.choice(('o%d', 'O%d', 'o<l_%d>', 'o <L_%d>', ' o %d')) % self.labels

    def branch(self, depth, loops):
        o = self.label()
        lines = ['%s if %s' % (o, self.condition())] + self.steps(depth, loops)
        for _ in range(self.r.choice((0, 0, 1, 2))):
            lines += ['%s elseif %s' % (o, self.condition())] + self.steps(depth, loops)
        if self.r.random() < 0.5:
            lines += ['%s else (or)' % o] + self.steps(depth, loops)
        return lines + ['%s endif' % o]

    def loop(self, depth, loops):
        o, n = self.label(), 100 + self.labels
        head, most = '#%d = 0' % n, self.r.randint(0, 4)
        kind = self.r.choice((0, 2) if self.breaks else (0, 1, 2))
        # rs274 knows no break of a repeat, and a return or a break of a loop around it leaves its
        # count behind; where a program has breaks, it counts `do` wrongly
        outside, self.inside = self.inside, None if kind == 2 else self.inside
        inner = ['#%d = [#%d + 1]' % (n, n)] + self.steps(depth, loops + [o] if kind < 2 else [])
        self.inside = outside
        if kind == 0:
            return [head, '%s while [#%d LT %d]' % (o, n, most)] + inner + [o + ' endwhile']
        if kind == 1:
            return [head, o + ' do'] + inner + ['%s while [#%d LT %d]' % (o, n, most)]
        return [head, '%s repeat [%s]' % (o, self.r.choice((most, most + 0.3, '#31 MOD 4')))] + \
            inner + [o + ' endrepeat']

    def steps(self, depth, loops):
        r, lines = self.r, []
        for _ in range(r.randint(0, 4)):
            kind = r.random()
            if kind < 0.3:
                lines.append('G%d %s%s' % (r.randint(0, 1), r.choice('XYZ'), self.expression()))
            elif kind < 0.5:
                lines.append(self.assignment())
            elif kind < 0.6 and depth < 3:
                lines += self.branch(depth + 1, loops)
            elif kind < 0.7 and depth < 3:
                lines += self.loop(depth + 1, loops)
            elif kind < 0.75 and loops and self.breaks:
                o = self.label()
                lines += ['%s if %s' % (o, self.condition()),
                          r.choice(loops[-1:] + loops) + r.choice((' break', ' continue')),
                          o + ' endif']
            elif kind < 0.85 and self.subs:
                name, plain = r.choice(self.subs)
                given = ' '.join('[%s]' % self.expression() for _ in range(r.randint(0, 4)))
                lines.append('M98 P%d%s' % (name, r.choice(('', ' L2'))) if plain else
                             '%s call %s' % (name, given))
                if r.random() < 0.5:    # rs274 sets it also where it only looks for an O-word
                    lines.append('G1 X#<_value> Y#<_value_returned>')
            elif kind < 0.9 and self.inside:
                o = self.label()
                lines += ['%s if %s' % (o, self.condition()),
                          self.inside + ' return' + r.choice(('', ' [%s]' % self.expression())),
                          o + ' endif']
        return lines

    def structured(self):
        """Subroutines, branches and loops. A subroutine calls those before it alone."""
        r = self.r
        self.labels, self.subs, self.inside, parts = 0, [], None, []
        self.breaks = r.random() < 0.5
        for n in range(r.randint(0, 4)):
            plain = r.random() < 0.3
            name  = 900 + n if plain else r.choice(('o<sub_%d>', 'o80%d')) % n
            self.inside = None if plain else name
            body = ['#<own> = #1'] + self.steps(1, []) + self.steps(1, [])
            end = r.choice(('', ' [%s]' % self.expression()))
            parts.append(['O%d' % name] + body + ['M99'] if plain else
                         [name + ' sub'] + body + ['%s endsub%s' % (name, end)])
            self.subs.append((name, plain))
        self.inside = None
        behind = any(plain for _, plain in self.subs) or r.random() < 0.5
        start = ['(a program from a seed)', 'G21 G17 G90 G94 F500', '#<own> = 1', '#<_all> = 2',
                 '#1 = 3', '#2 = 4', '#3 = 5', '#31 = 6', 'G0 X0 Y0 Z10']
        main = sum((self.steps(0, []) for _ in range(r.randint(1, 5))), [])
        # it looks for a subroutine behind the call, unless it has met it before
        subs = sum(reversed(parts) if behind else parts, [])
        return '\n'.join(start + ([] if behind else subs) + main + ['M2'] +
                         (subs if behind else []) + [''])

    def program(self):
        if self.odd:
            return self.structured()
        state = {'plane': 'G17', 'turns': self.r.random() < 0.5}
        lines = ['(a program from a seed)', 'G21 G17 G90 G94 F500', 'G0 X0 Y0 Z10']
        for _ in range(self.r.randint(5, 60)):
            lines += self.line(state)
            if self.r.random() < 0.03:
                lines += ['G54 G49 G90 G94 F300'] + self.beside() + [state['plane']]
        return '\n'.join(lines + ['M2', ''])


def main():
    args, cases, seed = sys.argv[1:], 300, int(os.environ.get('LOFT_SEED', '1'))
    canon = args.pop(0)
    while args and args[0].startswith('--'):
        option, value = args.pop(0), int(args.pop(0))
        cases, seed = (value, seed) if option == '--cases' else (cases, value)
    rs274 = os.environ.get('LOFT_RS274') or shutil.which('rs274')
    if not rs274:
        print('rs274 is not installed: make deps-gcode')
        print('0 passed, 1 failed')
        return 1
    passed = failed = motions = gouges = 0
    refused = {}
    with tempfile.TemporaryDirectory() as folder:
        table = os.path.join(folder, 'tool.tbl')
        with open(table, 'w', encoding='ascii') as out:
            out.write(''.join('T%d P%d D%.12f Z%.12f ;\n' % (n, n, d / 25.4, z / 25.4)
                              for n, (d, z) in TOOLS.items()))
        machine = os.path.join(folder, 'machine.txt')
        with open(machine, 'w', encoding='ascii') as out:
            out.write(''.join('tool.%d.diameter = %g\ntool.%d.length = %g\n' % (n, d, n, z)
                              for n, (d, z) in TOOLS.items()))
        names = []
        for arg in args:
            names += sorted(os.path.join(top, n) for top, _, files in os.walk(arg) for n in files
                            if n.endswith(('.ngc', '.nc')) and
                            os.path.exists(os.path.join(top, n))) if os.path.isdir(arg) else [arg]
        for n in range(0 if args else cases):
            names.append(os.path.join(folder, 'seed-%d.ngc' % (seed + n)))
            with open(names[-1], 'w', encoding='ascii') as out:
                out.write(Maker(seed + n).program())
        for name in names:
            full = os.path.abspath(name)
            own, code, said = run_own(canon, full, machine)
            if code != 0 and NOT_RUN.search(said):
                what = NOT_RUN.search(said).group(1)[:24]
                refused.setdefault(what, []).append(name)
                continue
            peer, bad, why = run_peer(rs274, table, full, folder)
            with open(full, encoding='ascii', errors='replace') as text:
                alone = PEER_ALONE.search(why) or (args and PEER_WRONG.search(text.read()))
            if alone:
                refused.setdefault('(rs274 does otherwise)', []).append(name)
                continue
            if bad and code != 0:
                passed += 1
                continue
            # rs274 takes some outer corners behind an arc for inner ones
            if bad and code == 0 and PEER_CORNER.search(why) and \
                    differ(peer, own[:len(peer)]) is None and goes_around(own, len(peer)):
                refused.setdefault('(rs274 refuses an outer corner)', []).append(name)
                continue
            # rs274 lets some motions pass that a corner turns around
            stricter = not bad and code != 0 and 'does not fit' in said
            wrong = differ(peer[:len(own)] if stricter else peer, own)
            if stricter and wrong is None:
                gouges += 1
                bad = True
            # a part of a program, as a subroutine, has no end: rs274 alone complains
            bad = bad and not why.startswith('File ended with no percent sign')
            if wrong is None and bad != (code != 0):
                wrong = ('refused here: ' + said) if code else 'refused there: ' + why
            if wrong:
                failed += 1
                print('FAIL %s: %s %s' % (name, wrong, said if code else why))
                if not args:
                    shutil.copy(full, '/tmp')
            else:
                passed += 1
                motions += len(peer)
    for what, which in sorted(refused.items()):
        print('not run, and said so: %s: %d, as %s' % (what, len(which), which[0]))
    if gouges:
        print('%d refused here alone: the tool does not fit' % gouges)
    print('%d motions agree' % motions)
    print('%d passed, %d failed' % (passed, failed))
    return failed > 0 or passed == 0


sys.exit(main())
