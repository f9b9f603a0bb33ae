#!/usr/bin/env python3
# ports/packages/inkscape/loft_inkscape.py -- draws the selection of Inkscape with loft
# SPDX-License-Identifier: MIT
"""Inkscape calls it with --id=.. for each selected object, the parameters of loft.inx and the
document. The document comes back unchanged; what there is to say goes to standard error, which
Inkscape shows. A drawing runs in a process of its own, so that Inkscape stays free: its files are
in $XDG_STATE_HOME/loft."""
import argparse
import json
import os
import shlex
import shutil
import signal
import subprocess
import sys
import time
import xml.etree.ElementTree as ElementTree

KEPT = {'defs', 'style', 'clipPath', 'mask', 'symbol', 'marker', 'pattern', 'linearGradient',
        'radialGradient', 'filter', 'namedview', 'metadata'}
STATE = os.path.join(os.environ.get('XDG_STATE_HOME') or os.path.expanduser('~/.local/state'),
                     'loft')
LOFT = os.environ.get('LOFT', 'loft')


def state(name):
    return os.path.join(STATE, name)


def tell(text):
    print(text, file=sys.stderr)


def select(document, ids, to):
    """Write the document with only the objects of these ids, all without any."""
    tree = ElementTree.parse(document)
    wanted = set(ids)

    def keep(node):
        """Is it selected, or is something in it? What is neither is removed from it."""
        name = node.tag.split('}')[-1] if isinstance(node.tag, str) else ''
        if name in KEPT or node.get('id') in wanted:
            return True
        some = False
        for child in list(node):
            if not keep(child):
                node.remove(child)
            elif child.tag.split('}')[-1] not in KEPT:
                some = True
        return some

    if wanted:
        keep(tree.getroot())
    tree.write(to, encoding='utf-8', xml_declaration=True)


def command(args):
    line = [LOFT, 'stream', state('drawing.svg')]
    if args.machine:
        line += ['--machine', args.machine]
    return line + shlex.split(args.options or '')


def running():
    """The process that draws, or None."""
    try:
        with open(state('pid'), encoding='utf-8') as file:
            pid = int(file.read())
        os.kill(pid, 0)
        with open(f'/proc/{pid}/stat', encoding='utf-8') as file:
            return None if file.read().rpartition(')')[2].split()[0] == 'Z' else pid
    except (OSError, ValueError):
        return None


def last_words():
    try:
        with open(state('log'), encoding='utf-8', errors='replace') as file:
            return ''.join(file.readlines()[-4:]).strip() or 'it has said nothing yet'
    except OSError:
        return 'nothing was drawn yet'


def preview(args):
    select(args.document, args.id, state('drawing.svg'))
    done = subprocess.run(command(args) + ['--dry-run'], capture_output=True, text=True,
                          check=False, stdin=subprocess.DEVNULL)
    text = done.stdout + done.stderr
    picture = state('preview.png')
    layout = [LOFT, 'plot', state('drawing.svg'), '-o', picture]
    if done.returncode == 0 and subprocess.run(layout, capture_output=True, check=False,
                                               stdin=subprocess.DEVNULL).returncode == 0:
        text += f'picture: {picture}\n'
        if os.environ.get('DISPLAY') and shutil.which('xdg-open'):
            subprocess.Popen(['xdg-open', picture], stdout=subprocess.DEVNULL,
                             stderr=subprocess.DEVNULL, start_new_session=True)
    with open(state('preview.txt'), 'w', encoding='utf-8') as file:
        file.write(text)
    tell(text.strip())


def run_shown(line):
    """In a terminal of its own: the bar and the keys of loft; the window stays until Enter."""
    child = subprocess.Popen(line)
    with open(state('pid'), 'w', encoding='utf-8') as file:
        file.write(str(child.pid))
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    code = child.wait()
    with open(state('log'), 'w', encoding='utf-8') as file:
        file.write(f'ended with code {code}\n')
    input(f'loft ended with code {code}. Enter closes this window. ')


def draw(args):
    if running():
        return tell('a drawing is under way: hold it, or wait')
    select(args.document, args.id, state('drawing.svg'))
    line = command(args) + ['--port', args.port]
    terminal = shutil.which('x-terminal-emulator')
    if args.terminal == 'true' and terminal and os.environ.get('DISPLAY'):
        subprocess.Popen([terminal, '-e', sys.executable, os.path.abspath(__file__), '--run',
                          json.dumps(line)], start_new_session=True)
        return tell('loft draws in its terminal: h holds, r resumes, a gives up')
    with open(state('log'), 'w', encoding='utf-8') as log:
        child = subprocess.Popen(line, stdin=subprocess.DEVNULL, stdout=log,
                                 stderr=subprocess.STDOUT, start_new_session=True)
    with open(state('pid'), 'w', encoding='utf-8') as file:
        file.write(str(child.pid))
    time.sleep(1)
    if child.poll() is None:
        return tell(f'loft draws {len(args.id) or "all"} objects on {args.port}')
    return tell(last_words())


def hold():
    """TERM holds the machine on the path; drawing again goes on."""
    pid = running()
    if pid is None:
        return tell('nothing is under way: ' + last_words())
    os.kill(pid, signal.SIGTERM)
    for _ in range(150):
        if running() is None:
            return tell(last_words())
        time.sleep(0.1)
    return tell('the machine has not stopped yet: look at it, and hold again')


def abort(args):
    if running():
        hold()
    done = subprocess.run([LOFT, 'stream', '--abort', '--port', args.port], capture_output=True,
                          text=True, check=False, stdin=subprocess.DEVNULL)
    tell((done.stdout + done.stderr).strip())


def main():
    os.makedirs(STATE, exist_ok=True)
    if sys.argv[1:2] == ['--run']:
        return run_shown(json.loads(sys.argv[2]))
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--id', action='append', default=[])
    parser.add_argument('--action', default='preview',
                        choices=['preview', 'draw', 'hold', 'abort', 'state'])
    parser.add_argument('--port', default='/dev/ttyUSB0')
    parser.add_argument('--machine', default='')
    parser.add_argument('--options', default='')
    parser.add_argument('--terminal', default='true')
    parser.add_argument('document')
    args = parser.parse_args()
    # with an empty file name Inkscape gives the folder of the extension
    if os.path.isdir(args.machine):
        args.machine = ''
    try:
        {'preview': preview, 'draw': draw, 'abort': abort, 'hold': lambda _: hold(),
         'state': lambda _: tell(('drawing; ' if running() else '') + last_words())
         }[args.action](args)
    except FileNotFoundError as missing:
        tell(f'{missing.filename}: not found: install loft, or set LOFT to the command')
    with open(args.document, 'rb') as file:
        shutil.copyfileobj(file, sys.stdout.buffer)
    return None


if __name__ == '__main__':
    main()
