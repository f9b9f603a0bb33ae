# ports/packages/python/setup.py -- pip install ports/packages/python: loft in double, by cffi
# SPDX-License-Identifier: MIT
import os
import re
import subprocess
import sys

from setuptools import setup

here = os.path.dirname(os.path.abspath(__file__))
top = os.path.abspath(os.path.join(here, '..', '..', '..'))
os.chdir(here)


def made():
    """loft.h and loft.c, and the comments of the headers as docstrings."""
    subprocess.check_call([sys.executable, 'ports/packages/amalgam/amalgam.py', '--num', 'f64',
                           '--out', os.path.join(here, 'made')], cwd=top)
    text = open(os.path.join(here, 'made', 'loft.h'), encoding='utf-8').read()
    documents = {}
    documented = r'/\*((?:[^*]|\*(?!/))*)\*/\n[a-z][\w \n*]*?\b(loft_\w+)\('
    for comment, name in re.findall(documented, text):
        lines = [re.sub(r'^ ?\*? ?', '', line) for line in comment.strip().split('\n')]
        documents[name] = '\n'.join(lines)
    with open(os.path.join(here, 'loft', '_documents.py'), 'w', encoding='utf-8') as out:
        out.write('# made by setup.py from the headers of loft\nDOCUMENTS = {\n')
        for name in sorted(documents):
            out.write(f'    {name!r}: {documents[name]!r},\n')
        out.write('}\n')
    return dict(re.findall(r'#define LOFT_VERSION_(MAJOR|MINOR|PATCH) (\d+)', text))


version = made()
setup(
    name='loft',
    version='{MAJOR}.{MINOR}.{PATCH}'.format(**version),
    description='Curves and motion, exactly',
    license='MIT',
    packages=['loft'],
    setup_requires=['cffi'],
    install_requires=['cffi', 'numpy'],
    cffi_modules=['build_loft.py:builder'],
)
