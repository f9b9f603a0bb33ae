#!/usr/bin/env python3
# tests/packages/forms.py -- does a description have the form that its tool asks for?
# SPDX-License-Identifier: MIT
"""usage: forms.py KIND PATH   for tools that are not in Debian

The rules are those that the tools publish: arduino-lint's schema of library.properties (1.5),
PlatformIO's manifest schema, pykwalify's schema in Zephyr's zephyr_module.py, the manifest of the
component manager of ESP-IDF, PACK.xsd 1.7 of Open-CMSIS-Pack. A field that they do not know is
refused, as is one that is missing or of another form.
"""
import configparser
import json
import os
import re
import sys
import xml.etree.ElementTree as xml

VERSION = r'\d+\.\d+\.\d+'


def refuse(what):
    sys.exit(f'forms.py: {what}')


def fields(found, needed, allowed, where):
    """Each field is known, has its form, and none that is needed is missing."""
    rules = {**needed, **allowed}
    for name in needed:
        if name not in found:
            refuse(f'{where}: {name} is missing')
    for name, value in found.items():
        if name not in rules:
            refuse(f'{where}: {name} is not a field')
        rule = rules[name]
        if isinstance(rule, str):
            if not isinstance(value, str) or not re.fullmatch(rule, value):
                refuse(f'{where}: {name}: {value!r} is not of the form {rule}')
        elif not rule(value):
            refuse(f'{where}: {name}: {value!r} is not of its form')


def some(pattern):
    return lambda v: isinstance(v, list) and all(isinstance(i, str) and re.fullmatch(pattern, i)
                                                for i in v)


def truth(value):
    return isinstance(value, bool)


def whole(low, high):
    return lambda v: isinstance(v, int) and low <= v <= high


def there(root, name):
    if not os.path.exists(os.path.join(root, name)):
        refuse(f'{name}: there is no such file')


def arduino(root):
    found = dict(line.rstrip('\n').split('=', 1)
                 for line in open(os.path.join(root, 'library.properties'), encoding='utf-8')
                 if line.strip() and not line.startswith('#'))
    categories = ['Display', 'Communication', 'Signal Input/Output', 'Sensors', 'Device Control',
                  'Timing', 'Data Storage', 'Data Processing', 'Other']
    fields(found, {
        'name': r'[a-zA-Z0-9][a-zA-Z0-9 ._-]{0,62}', 'version': VERSION, 'author': r'.+',
        'maintainer': r'(?!arduino).+', 'sentence': r'.*[^ ].*', 'paragraph': r'.*',
        'category': '|'.join(map(re.escape, categories)), 'url': r'https?://.+',
        'architectures': r'\*|[a-z0-9_]+(,[a-z0-9_]+)*',
    }, {'includes': r'[^,<>"]+(,[^,<>"]+)*', 'depends': r'.+', 'dot_a_linkage': 'true|false',
        'precompiled': 'true|full|false', 'ldflags': r'.+'}, 'library.properties')
    there(root, 'src/' + found['includes'])
    for line in open(os.path.join(root, 'keywords.txt'), encoding='utf-8'):
        if line.strip() and not re.fullmatch(r'\S+\t(KEYWORD[123]|LITERAL[12])\n', line):
            refuse(f'keywords.txt: {line!r}')
    for name in os.listdir(os.path.join(root, 'examples')):
        there(root, f'examples/{name}/{name}.ino')


def platformio(root):
    found = json.load(open(os.path.join(root, 'library.json'), encoding='utf-8'))
    names = r'[a-z\d_-]+|\*'

    def names_match(value):
        return re.fullmatch(r'[^:;/,@<>]{1,100}', value)

    def star_or_names(value):
        return value == '*' or some(names)(value)
    fields(found, {'name': r'[^:;/,@<>]{1,100}', 'version': VERSION}, {
        'description': r'.{1,1000}', 'keywords': some(r'[a-z\d+. -]{1,50}'), 'license': r'MIT',
        'frameworks': star_or_names, 'platforms': star_or_names, 'headers': r'\S+\.h',
        'homepage': r'https?://.+', 'dependencies': lambda v: all(map(names_match, v)),
        'build': lambda v: not set(v) - {'flags', 'unflags', 'includeDir', 'srcDir', 'srcFilter'},
    }, 'library.json')
    there(root, 'src/' + found['headers'])


def platformio_ini(root):
    found = configparser.ConfigParser()
    found.read(os.path.join(root, 'platformio.ini'))
    environments = [s[4:] for s in found.sections() if s.startswith('env:')]
    for section in found.sections():
        rules = {'default_envs': '|'.join(environments)} if section == 'platformio' else {
            'framework': r'[a-z]+', 'lib_deps': r'.+', 'platform': r'[a-z0-9]+',
            'board': r'[A-Za-z0-9_]+', 'build_flags': r'.+'}
        fields(dict(found[section]), {}, rules, section)
        if not re.fullmatch(r'platformio|env|env:[a-z0-9_]+', section):
            refuse(f'[{section}] is not a section')
    if not environments:
        refuse('platformio.ini: no environment')


def zephyr(root):
    import yaml
    found = yaml.safe_load(open(os.path.join(root, 'zephyr/module.yml'), encoding='utf-8'))
    fields(found, {}, {'name': r'[\w-]+', 'build': lambda v: isinstance(v, dict),
                       'tests': some('.+'), 'samples': some('.+'), 'boards': some('.+')},
           'module.yml')
    fields(found['build'], {}, {'cmake': r'.+', 'kconfig': r'.+', 'cmake-ext': truth,
                                'kconfig-ext': truth, 'depends': some(r'.+'),
                                'settings': lambda v: isinstance(v, dict)}, 'module.yml: build')
    there(root, found['build']['cmake'] + '/CMakeLists.txt')
    there(root, found['build']['kconfig'])
    for samples in found['samples']:
        for name in os.listdir(os.path.join(root, samples)):
            sample = os.path.join(samples, name)
            for file in ('CMakeLists.txt', 'prj.conf', 'sample.yaml'):
                there(root, os.path.join(sample, file))
            said = yaml.safe_load(open(os.path.join(root, sample, 'sample.yaml'),
                                       encoding='utf-8'))
            fields(said, {'sample': lambda v: 'name' in v, 'tests': lambda v: len(v) > 0},
                   {'common': lambda v: isinstance(v, dict)}, sample)


def esp_idf(root):
    import yaml
    found = yaml.safe_load(open(os.path.join(root, 'idf_component.yml'), encoding='utf-8'))
    fields(found, {'version': VERSION}, {
        'description': r'.+', 'license': 'MIT', 'url': r'https?://.+', 'tags': some(r'[\w-]{3,32}'),
        'targets': some(r'[a-z0-9]+'), 'dependencies': lambda v: isinstance(v, dict),
        'examples': lambda v: all(set(e) == {'path'} for e in v)}, 'idf_component.yml')
    for example in found['examples']:
        there(root, example['path'] + '/main/CMakeLists.txt')


def cmsis(root):
    name, = [f for f in os.listdir(root) if f.endswith('.pdsc')]
    package = xml.parse(os.path.join(root, name)).getroot()
    if package.tag != 'package' or not re.fullmatch(r'1\.7\.\d+', package.get('schemaVersion', '')):
        refuse(f'{name}: not a <package> of schema 1.7')
    order = ['vendor', 'name', 'description', 'url', 'supportContact', 'license', 'repository',
             'releases', 'keywords', 'generators', 'requirements', 'devices', 'boards', 'taxonomy',
             'apis', 'conditions', 'components', 'csolution', 'examples']
    here = [order.index(child.tag) if child.tag in order else refuse(f'{name}: <{child.tag}>')
            for child in package]
    for needed in ('vendor', 'name', 'description', 'url', 'license', 'releases'):
        if order.index(needed) not in here:
            refuse(f'{name}: <{needed}> is missing')
    if name != f'{package.findtext("vendor")}.{package.findtext("name")}.pdsc':
        refuse(f'{name}: must be VENDOR.NAME.pdsc')
    for release in package.iter('release'):
        fields(release.attrib, {'version': VERSION}, {'date': r'\d{4}-\d\d-\d\d'}, name)
    conditions = {c.get('id') for c in package.iter('condition')}
    kinds = 'doc|header|include|library|object|source|sourceC|sourceAsm|other|preIncludeGlobal'
    for component in package.iter('component'):
        fields(component.attrib, {'Cclass': r'.{3,32}', 'Cgroup': r'.{2,64}', 'Cversion': VERSION},
               {'Csub': r'.{2,64}', 'condition': '|'.join(map(re.escape, conditions))}, name)
        for file in component.iter('file'):
            fields(file.attrib, {'category': kinds, 'name': r'[^\\]+'}, {}, name)
            there(root, file.get('name'))
    there(root, package.findtext('license'))


if __name__ == '__main__':
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    {'arduino': arduino, 'platformio': platformio, 'platformio-ini': platformio_ini,
     'zephyr': zephyr, 'esp-idf': esp_idf, 'cmsis': cmsis}[sys.argv[1]](sys.argv[2])
