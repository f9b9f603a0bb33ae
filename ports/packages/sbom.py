#!/usr/bin/env python3
# ports/packages/sbom.py -- what loft is made of, as SPDX 2.3
# SPDX-License-Identifier: MIT
"""usage: sbom.py VERSION DATE ARCHIVE FILE..   prints JSON

The package is ARCHIVE with each FILE in it; the command is linked with the libraries that the
Makefile names. The same sources give the same bytes.
"""
import hashlib
import json
import sys


def digest(name, kind):
    with open(name, 'rb') as file:
        return hashlib.new(kind, file.read()).hexdigest()


def main():
    if len(sys.argv) < 5:
        sys.exit(__doc__)
    version, date, archive, names = sys.argv[1], sys.argv[2], sys.argv[3], sorted(sys.argv[4:])
    files = [{
        'SPDXID': f'SPDXRef-File-{i}', 'fileName': './' + name,
        'checksums': [{'algorithm': 'SHA1', 'checksumValue': digest(name, 'sha1')},
                      {'algorithm': 'SHA256', 'checksumValue': digest(name, 'sha256')}],
        'licenseConcluded': 'MIT', 'licenseInfoInFiles': ['MIT'],
        'copyrightText': '2026 the loft authors',
    } for i, name in enumerate(names)]
    sums = ''.join(sorted(f['checksums'][0]['checksumValue'] for f in files))
    needs = {'libxml2': 'MIT', 'zlib': 'Zlib', 'cairo': 'LGPL-2.1-only OR MPL-1.1',
             'pango': 'LGPL-2.0-or-later', 'geos': 'LGPL-2.1-or-later',
             'libserialport': 'LGPL-3.0-or-later', 'ncurses': 'X11', 'libwebsockets': 'MIT',
             'json-c': 'MIT'}
    packages = [{
        'SPDXID': 'SPDXRef-loft', 'name': 'loft', 'versionInfo': version,
        'downloadLocation': 'NOASSERTION', 'filesAnalyzed': True,
        'packageFileName': archive.split('/')[-1],
        'packageVerificationCode': {
            'packageVerificationCodeValue': hashlib.sha1(sums.encode()).hexdigest()},
        'checksums': [{'algorithm': 'SHA256', 'checksumValue': digest(archive, 'sha256')}],
        'licenseConcluded': 'MIT', 'licenseDeclared': 'MIT', 'licenseInfoFromFiles': ['MIT'],
        'copyrightText': '2026 the loft authors', 'supplier': 'Organization: the loft authors',
    }] + [{
        'SPDXID': 'SPDXRef-' + name, 'name': name, 'downloadLocation': 'NOASSERTION',
        'filesAnalyzed': False, 'licenseConcluded': 'NOASSERTION', 'licenseDeclared': licence,
        'copyrightText': 'NOASSERTION',
        'comment': 'linked by the command loft; the library needs none',
    } for name, licence in needs.items()]
    relations = [('SPDXRef-DOCUMENT', 'DESCRIBES', 'SPDXRef-loft')]
    relations += [('SPDXRef-loft', 'CONTAINS', f['SPDXID']) for f in files]
    relations += [('SPDXRef-loft', 'DYNAMIC_LINK', 'SPDXRef-' + name) for name in needs]
    json.dump({
        'spdxVersion': 'SPDX-2.3', 'dataLicense': 'CC0-1.0', 'SPDXID': 'SPDXRef-DOCUMENT',
        'name': f'loft-{version}',
        'documentNamespace': f'https://example.org/spdx/loft-{version}-{digest(archive, "sha256")}',
        'creationInfo': {'created': f'{date}T00:00:00Z',
                         'creators': ['Tool: ports/packages/sbom.py']},
        'packages': packages, 'files': files,
        'relationships': [{'spdxElementId': a, 'relationshipType': kind, 'relatedSpdxElement': b}
                          for a, kind, b in relations],
    }, sys.stdout, indent=1, sort_keys=True)
    print()


main()
