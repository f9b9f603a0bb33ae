#!/usr/bin/env python3
# ports/packages/amalgam/amalgam.py -- each library as two files: loft.h, .c and loft_surfaces.h, .c
# SPDX-License-Identifier: MIT
"""usage: amalgam.py [--num q16|f32|f64] [--rooms ROOM,..] [--out FOLDER]

loft.h has every header of the rooms and of those before them that they need, in the order in which
they include each other; loft.c the sources behind each other. loft_surfaces.h and loft_surfaces.c
are the same for the rooms of surfaces, if some are wanted; they include loft.h. A program includes
loft/surfaces.h, as anywhere, which is made beside them. What a source keeps to itself is
`static`: where two sources use one name, each gets the name of its file as an ending. LOFT_NUM
and LOFT_AXES can still be set on the command line; --num is the default.
"""
import argparse
import os
import re
import sys

LIBRARIES = {
    'loft': ['num', 'geom', 'basis', 'curve', 'kinematics', 'path', 'motion', 'wire', 'machine'],
    'loft_surfaces': ['surface', 'polygon', 'toolpath'],
}
ROOMS = [room for rooms in LIBRARIES.values() for room in rooms]
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*"([^"]+)"[^\n]*\n', re.M)
SYSTEM = re.compile(r'^[ \t]*#[ \t]*include[ \t]*<([^>]+)>[^\n]*\n', re.M)
WORD = re.compile(r'"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])*\'|/\*.*?\*/|//[^\n]*|[A-Za-z_]\w*'
                  r'|\d[\w.]*|->|\s+|.', re.S)
# these stand where they are included: behind an #if, or behind what they ask for
CHOSEN = {'names.h', 'num/q16.h', 'num/f32.h', 'num/f64.h', 'num/floats.h', 'num/avr.h'}
# functions of C that a compiler knows without a header
KNOWN = {'finite'}


def fail(what):
    sys.exit('amalgam.py: ' + what)


def read(name):
    with open(os.path.join('lib', name), encoding='utf-8') as file:
        return file.read()


def sources(room):
    found = []
    for folder, _, names in os.walk(os.path.join('lib', room)):
        found += [os.path.relpath(os.path.join(folder, n), 'lib') for n in names]
    return sorted(found)


def plain(text):
    """Without comments, with as many lines."""
    return re.sub(r'/\*.*?\*/|//[^\n]*', lambda m: '\n' * m.group().count('\n') or ' ', text,
                  flags=re.S)


def headers_in_order(names):
    """Each header behind those that it includes."""
    order, seen = [], set()

    def visit(name):
        if name in seen:
            return
        seen.add(name)
        for other in INCLUDE.findall(read(name)):
            visit(other)
        order.append(name)

    for name in names:
        visit(name)
    return [n for n in order if n not in CHOSEN]


def header_text(name, system):
    """A header without its includes: those of the house came before, those of C go to the top."""
    text = read(name)
    system.update(SYSTEM.findall(text))

    def put(match):
        inner = match.group(1)
        return header_text(inner, system) if inner in CHOSEN else ''

    return SYSTEM.sub('', INCLUDE.sub(put, text))


def own_names(text):
    """What a source defines for itself at file scope: functions, tables, types, enumerators."""
    bare = plain(text)
    names = set(re.findall(r'^static[^;={(]*?\b(\w+)\s*[(\[=;]', bare, re.M))
    names |= set(re.findall(r'^(?:typedef\s+)?(?:struct|enum|union)\s+(\w+)\s*\{', bare, re.M))
    names |= set(re.findall(r'^typedef[^;{]*?\b(\w+);', bare, re.M))
    names |= set(re.findall(r'^typedef[^;{]*?\(\s*\*?(\w+)\)?\s*\([^;]*\);', bare, re.M))
    names |= set(re.findall(r'^\}\s*(\w+);', bare, re.M))
    for body in re.findall(r'^(?:typedef\s+)?enum(?:\s+\w+)?\s*\{(.*?)\}', bare, re.M | re.S):
        names |= set(re.findall(r'(?:^|,)\s*(\w+)', body))
    return names


def macros(text):
    return re.findall(r'^[ \t]*#[ \t]*define[ \t]+(\w+)', plain(text), re.M)


def renamed(text, names, ending):
    """The same source with these names ended; members of structs keep theirs."""
    words = WORD.findall(text)
    out, before, depth, fields = [], '', 0, []
    for i, word in enumerate(words):
        if word == '{':
            depth += 1
            back = ''.join(words[max(0, i - 12):i])
            if re.search(r'\b(struct|union)(\s+\w+)?\s*$', back):
                fields.append(depth)
        elif word == '}':
            if fields and fields[-1] == depth:
                fields.pop()
            depth -= 1
        if word in names and before not in ('.', '->'):
            after = next((w for w in words[i + 1:i + 4] if not w.isspace()), '')
            if not (fields and after in (';', ',', '[', ':', ')')):
                word += ending
        if not word.isspace() and not word.startswith(('/*', '//')):
            before = word
        out.append(word)
    return ''.join(out)


def wanted_of(rooms):
    """The files of the rooms, and of others what these include."""
    wanted, todo = set(), ['config.h'] + [f for r in ROOMS if r in rooms for f in sources(r)]
    while todo:
        name = todo.pop()
        if name in wanted:
            continue
        wanted.add(name)
        todo += INCLUDE.findall(read(name))
        if name.endswith('.h') and os.path.exists('lib/' + name[:-1] + 'c'):
            todo.append(name[:-1] + 'c')
        # a header may be implemented in several files of its name: walk.h in walk_start.c
        if name.endswith('.h') and '/' in name:
            todo += [f for f in sources(os.path.dirname(name))
                     if f.endswith('.c') and '"' + name + '"' in read(f)
                     and f.startswith(name[:-2])]
    rank = {room: i for i, room in enumerate(ROOMS)}
    return sorted(wanted - {'config.h', 'names.h'}, key=lambda f: (rank[f.split('/')[0]], f))


def code_text(code):
    """The sources behind each other, names that two of them use for themselves apart."""
    texts = {c: read(c) for c in code}
    users = {}
    for c in code:
        for name in own_names(texts[c]):
            users.setdefault(name, set()).add(c)
    out = []
    for c in code:
        clash = {n for n in own_names(texts[c]) if len(users[n]) > 1 or n in KNOWN}
        ending = '__' + os.path.basename(c)[:-2]
        text = SYSTEM.sub('', INCLUDE.sub('', texts[c]))
        out.append(f'\n/* ---- lib/{c} ---- */\n' + renamed(text, clash, ending))
        out += [f'#undef {name}\n' for name in dict.fromkeys(macros(text))]
    return ''.join(out)


def written(folder, library, files, headers, num, before):
    """LIBRARY.h with these headers, LIBRARY.c with the sources among these files."""
    system = set()
    body = ''.join(f'\n/* ---- lib/{h} ---- */\n' + header_text(h, system) for h in headers)
    body = body.replace('#  define LOFT_NUM LOFT_Q16', f'#  define LOFT_NUM LOFT_{num.upper()}')
    includes = ''.join(f'#include <{s}>\n' for s in sorted(system))
    license_text = open('LICENSE', encoding='utf-8').read().strip().replace('\n', '\n * ')
    taken = [r for r in ROOMS if any(f.startswith(r + '/') for f in files)]
    said = ('made by ports/packages/amalgam/amalgam.py: change lib/, not this file\n'
            f' * rooms: {" ".join(taken)}')
    guard = library.upper() + '_ONE_H'
    with open(os.path.join(folder, library + '.h'), 'w', encoding='utf-8') as out:
        out.write(f'/* {library}.h -- {said}\n * SPDX-License-Identifier: MIT\n *\n'
                  f' * {license_text}\n */\n#ifndef {guard}\n#define {guard}\n\n'
                  + includes + '\n' + before + body + '\n#endif\n')
    with open(os.path.join(folder, library + '.c'), 'w', encoding='utf-8') as out:
        out.write(f'/* {library}.c -- {said}\n * SPDX-License-Identifier: MIT\n */\n'
                  f'#include "{library}.h"\n' + code_text([f for f in files if f.endswith('.c')]))


def main():
    given = argparse.ArgumentParser(usage=__doc__.split('\n', 1)[0][7:])
    given.add_argument('--num', choices=['q16', 'f32', 'f64'], default='q16')
    given.add_argument('--rooms', default='all')
    given.add_argument('--out', default='.')
    o = given.parse_args()
    rooms = ROOMS if o.rooms == 'all' else o.rooms.split(',')
    for room in rooms:
        if room not in ROOMS:
            fail(f'--rooms {room}: give some of {",".join(ROOMS)}')

    files = wanted_of(rooms)
    headers = headers_in_order(['config.h'] + [f for f in files if f.endswith('.h')])
    os.makedirs(o.out, exist_ok=True)
    top = read('loft.h')
    before = top[top.index('/* The version of'):top.index('#include')]
    for library, its_rooms in LIBRARIES.items():
        def own(name):
            return ('num' if name == 'config.h' else name.split('/')[0]) in its_rooms
        its_files = [f for f in files if own(f)]
        if its_files:
            written(o.out, library, its_files, [h for h in headers if own(h)], o.num, before)
        before = '#include "loft.h"\n'
    # in the same folder as in lib/
    if its_files:
        os.makedirs(os.path.join(o.out, 'loft'), exist_ok=True)
        with open(os.path.join(o.out, 'loft', 'surfaces.h'), 'w', encoding='utf-8') as out:
            out.write('/* loft/surfaces.h -- surfaces, under the name that they have in lib/\n'
                      ' * SPDX-License-Identifier: MIT\n */\n#include "../loft_surfaces.h"\n')


if __name__ == '__main__':
    main()
