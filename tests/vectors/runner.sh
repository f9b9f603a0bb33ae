#!/bin/sh
# tests/vectors/runner.sh -- does the runner of exact results notice what it must?
# Folders with one fault each.
# SPDX-License-Identifier: MIT
# usage: tests/vectors/runner.sh PROGRAM KNOWN ; PROGRAM is build/vectors/q16
set -u
program=$1 known=$2
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
passed=0 failed=0

# case NAME CODE PATTERN FILE TEXT: the run over FILE holding TEXT ends with CODE and prints PATTERN
case_is() {
    rm -f "$folder"/*
    [ -z "$4" ] || printf "$5" > "$folder/$4"
    output=$($program "$folder" "$known" 2>&1); code=$?
    if [ $code = "$2" ] && printf '%s\n' "$output" | grep -qE "$3"; then
        passed=$((passed + 1)); echo "ok   runner $1"
    else
        failed=$((failed + 1)); echo "FAIL runner $1: code $code, wanted $2 and /$3/"
        printf '%s\n' "$output" | sed 's/^/     /'
    fi
}
eval='# bezier_eval: a test\nn,d,P_q16,t_q16,point\n'
horner='# horner: a test\nn,c_q16,x_q16,value,deriv\n'

case_is "passes what is right"             0 '^bezier_eval 1 0.5 0.50001 ok$' \
    bezier_eval.csv "${eval}1,1,0;1,32768,0.00000762939453125\n"
case_is "reads a file with another name"   0 '^bezier_eval 1 ' \
    renamed.csv "${eval}1,1,0;65536,65536,1\n"
case_is "takes the columns by name"        0 '^bezier_eval 1 0 .* ok$' \
    bezier_eval.csv "# bezier_eval: x\nd,note,n,t_q16,point,P_q16\n1,hm,1,65536,1,0;65536\n"
case_is "takes a carriage return"          0 '^bezier_eval 1 ' \
    bezier_eval.csv "${eval}1,1,0;65536,65536,1\r\n"
case_is "fails on an excess"               1 \
    'bezier_eval.csv:4: column point, value 1: 0\.6 wanted, 0\.5 given' \
    bezier_eval.csv "${eval}1,1,0;0,0,0\n1,2,0 0;65536 65536,32768,0.5 0.6\n"
case_is "fails on an unreadable number"    1 'bezier_eval.csv:3: column P_q16: no whole' \
    bezier_eval.csv "${eval}1,1,0;x,0,0\n"
case_is "fails on an unreadable result"    1 'bezier_eval.csv:3: column point: no number' \
    bezier_eval.csv "${eval}1,1,0;1,0,zero\n"
case_is "fails on nan"                     1 'bezier_eval.csv:3: column point: no number' \
    bezier_eval.csv "${eval}1,1,0;1,0,nan\n"
case_is "fails on a point too few"         1 'bezier_eval.csv:3: column P_q16' \
    bezier_eval.csv "${eval}2,1,0;1,0,0\n"
case_is "fails on a point too many"        1 'bezier_eval.csv:3: column P_q16: more' \
    bezier_eval.csv "${eval}1,1,0;1;2,0,0\n"
case_is "fails on a result too few"        1 'bezier_eval.csv:3: column point has 1 val' \
    bezier_eval.csv "${eval}1,2,0 0;1 1,0,0\n"
case_is "fails on a missing column"        1 'bezier_eval.csv:3: 4 columns of 5' \
    bezier_eval.csv "${eval}1,1,0;1,0\n"
case_is "fails on a degree too high"       1 'bezier_eval.csv:3: column n' \
    bezier_eval.csv "${eval}10,1,0,0,0\n"
case_is "fails on a parameter refused"     1 \
    'bezier_eval.csv:3: refused with status -1' \
    bezier_eval.csv "${eval}1,1,0;0,131073,0\n"
case_is "fails on column names without one" 1 'bezier_eval.csv:2: no column t_q16' \
    bezier_eval.csv "# bezier_eval: x\nn,d,P_q16,point\n"
case_is "fails on a file without rows"     1 '^bezier_eval 0 .* FAIL: no rows' \
    bezier_eval.csv "${eval}"
case_is "wants a large result reported"    0 '^horner 1 .* ok$' \
    horner.csv "${horner}1,65536 2147483647,131072,65536.99996948242187500,32767.9999847412109375\n"
case_is "fails on an overflow not there"   1 'horner.csv:3: an overflow was reported' \
    horner.csv "${horner}1,65536 2147483647,131072,1,5\n"
case_is "fails on an overflow unreported"  1 'horner.csv:3: .* no overflow was reported' \
    horner.csv "${horner}1,65536 65536,65536,40000,1\n"
case_is "takes either at the very end"       0 '^horner 1 .* ok$' \
    horner.csv "${horner}1,0 2147483647,65536,32767.99999,32767.99999\n"
# a folder that knows a system for which there is no reader yet
real=$known known=$(mktemp -d)
: > "$known/someday.csv"
case_is "names a system to come"           0 '^someday 2 - - no reader$' \
    someday.csv "# someday: x\na,b\n1,2\n3,4\n"
rm -r "$known"
known=$real
case_is "fails on a system never heard of" 1 '^spline9 1 - - no reader: unknown system$' \
    spline9.csv "# spline9: x\na,b\n1,2\n"
case_is "fails on a file without a title"  1 'x.csv:1: the first line does not say' \
    x.csv "a,b\n1,2\n"
case_is "fails on an empty folder"        66 'no CSV file'                                 "" ""

echo "$passed passed, $failed failed"
[ $failed = 0 ]
