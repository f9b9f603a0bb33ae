#!/bin/sh
# host-tools/page/embed.sh -- prints the files of the page as C, packed by gzip
# SPDX-License-Identifier: MIT
# usage: host-tools/page/embed.sh FOLDER ; without it the list is empty
set -eu
printf '#include "serve/site.h"\n\n'
n=0 rows=
for file in "$1"/*.*; do
    [ -f "$file" ] || continue
    n=$((n + 1))
    printf 'static const unsigned char file_%d[] = {\n' $n
    gzip -9nc "$file" | od -An -v -tu1 | sed 's/  */,/g; s/^,//; s/$/,/'
    printf '};\n'
    rows="$rows    { \"${file##*/}\", file_$n, sizeof file_$n },
"
done
printf 'const site_file site_files[] = {\n%s    { 0 }\n};\n' "$rows"
