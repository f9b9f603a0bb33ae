#!/usr/bin/env python3
# tests/house/tour.py -- the commands of host-tools/README.md, in the order of the page
# SPDX-License-Identifier: MIT
"""usage: tour.py [--run LOFT [FIRST-LAST]]

Each file that a command reads is made before it on the page, or is one of the checkout. With --run
the commands run in a folder of their own; one fails that does not end with 0, or does not make the
file that it names; a simulated machine that the page starts runs on to the end. Without
ALL=1 those that compute for long are left out. The last line is `N passed, N failed`.
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time

PAGE = 'host-tools/README.md'
NAME = r'[\w./-]+\.(?:svg|csv|nc|loft|txt)'
PORT = '/tmp/machine'
# a second of a processor or more each, or as long as the machine draws
SLOW = re.compile(r'loft (figures -o|study|harmonic|mill|plot --curvature)|--(fill c|port|order)|'
                  r'loft (stream|plan) drawing.svg|--tol 0.01 -o')


def commands():
    """Each command of the page: [its line, its text]."""
    lines = open(PAGE, encoding='utf-8').read().split('\n')
    number = 0
    while number < len(lines):
        line = lines[number]
        if line.strip() == '```sh':
            number += 1
            text, here = '', None
            while lines[number].strip() != '```':
                text += lines[number] + '\n'
                begins = re.search(r"<<'(\w+)'", lines[number])
                here = begins.group(1) if begins and not here else here
                if lines[number] == here:
                    here = None
                whole = subprocess.run(['bash', '-n'], input=text, text=True, check=False,
                                       capture_output=True)
                if not here and not whole.returncode and not re.search(r'[\\|]$', text.rstrip()):
                    yield number + 1, text
                    text = ''
                number += 1
        elif line.startswith('|'):
            for row in re.findall(r'`(build/loft[^`]*)`', line):
                yield number + 1, row
        number += 1


def made_by(text):
    names = re.findall(r'(?:>|-o |--csv \d+ >)\s*(%s)' % NAME, text)
    names += re.findall(r'^cp \S+ (%s)' % NAME, text)
    for folder in re.findall(r'^cp (\S+)/\*\.loft \.', text):
        names += [n for n in os.listdir(folder) if n.endswith('.loft')]
    return names


def check():
    made, wrong = set(), 0
    for number, text in commands():
        head = re.sub(r'\s#.*', '', text.split('\n')[0])
        new = made_by(text)
        for name in re.findall(r'(?<![\w./*-])' + NAME, head):
            if name not in made and name not in new and not os.path.exists(name):
                print('%s:%d: %s: nothing before makes it: %s' % (PAGE, number, name, head))
                wrong += 1
        made.update(new)
    return wrong


def run(loft, first, last):
    passed = failed = left = 0
    with tempfile.TemporaryDirectory() as folder:
        os.makedirs(os.path.join(folder, 'build'))
        shutil.copy2(loft, os.path.join(folder, 'build/loft'))      # the build may go on
        for name in ('tests', 'host-tools', 'lib', 'ports'):
            os.symlink(os.path.abspath(name), os.path.join(folder, name))
        env = dict(os.environ, XDG_STATE_HOME=folder)
        held = []
        for number, text in commands():
            behind = re.sub(r'\s#.*', '', text).rstrip().endswith('&')
            outside = not first <= number <= last and not behind
            if 'make demo' in text or ('build/loft' in text and outside):
                continue
            if SLOW.search(text) and not os.environ.get('ALL'):
                left += 1
                continue
            text = text.replace(PORT, folder + '/machine')
            if behind:
                machine = subprocess.Popen(['bash', '-c', 'exec ' + text.replace('&', '')],
                                           cwd=folder, env=env, stdout=subprocess.PIPE)
                machine.stdout.readline()           # it says where it is
                held.append(machine)
                continue
            begun = time.monotonic()
            got = subprocess.run(['bash', '-c', text], cwd=folder, env=env, check=False, text=True,
                                 stdin=subprocess.DEVNULL, capture_output=True)
            missing = [n for n in made_by(text) if not os.path.exists(os.path.join(folder, n))]
            if got.returncode or missing:
                failed += 1
                print('FAIL %s:%d: %s ends with %d; not made: %s; %s' % (
                    PAGE, number, text.strip(), got.returncode, ', '.join(missing) or 'nothing',
                    got.stderr[-300:]), flush=True)
            passed += not (got.returncode or missing)
            if os.environ.get('TIMES'):
                print('%s:%d: %.1f s' % (PAGE, number, time.monotonic() - begun), flush=True)
        for machine in held:
            machine.kill()
    if left:
        print('left to make check-all: %d commands of the tour that compute for long' % left)
    print('%d passed, %d failed' % (passed, failed))
    return failed


if len(sys.argv) > 2 and sys.argv[1] == '--run':
    span = [int(n) for n in (sys.argv[3:] or ['0-99999'])[0].split('-')]
    faults = run(sys.argv[2], span[0], span[-1])
else:
    faults = check()
sys.exit(faults > 0)
