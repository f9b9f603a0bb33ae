# tests/e2e/study.sh -- the study of patches and harmonic coordinates
# SPDX-License-Identifier: MIT

case_study_of_a_patch() {
    run 0 "$loft" study gb --fine 6 --brief
    says out ' numbers beside expected ones, 0 of them off; 0 without'
    run 0 "$loft" study gb --fine 4 --expected tests/vectors/ch4_numbers.csv
    says out '^4-3;P1_regular;B0 at the centre (vertex mean);H;0.2864;0.2864;'
    local ray='Z_tt on the centre-vertex ray at rho=0.5, 0.75, 0.9; dz=4.4'
    says out "^4-6..4-11;P3_irregular;$ray;MV;"
    sed 's/vertex mean);W;0.2864;/vertex mean);W;0.2865;/' tests/vectors/ch4_numbers.csv \
        >"$tmp/other.csv"
    run 65 "$loft" study gb --fine 4 --expected "$tmp/other.csv" --brief
    says out ';0.2864;0.2865;.*;off$'
    says out ' 1 of them off'
    one_line 64 'give `gb`' "$loft" study
    head -c 100000 /dev/urandom >"$tmp/random.bin"; : >"$tmp/nothing"
    for other in "$tmp/random.bin" "$tmp/nothing" tests/vectors/flatten.csv; do
        one_line 65 'no row of it is a number of this study' "$loft" study gb --fine 4 --brief \
            --expected "$other"
    done
    one_line 65 'cannot be read' "$loft" study gb --fine 4 --expected "$tmp"
    one_line 66 'none.csv: no such file' "$loft" study gb --expected "$tmp/none.csv"
    local command=$loft             # elsewhere: nothing is compared, so nothing passes
    [ "${command#/}" != "$command" ] || command=$PWD/$command
    one_line 66 'nothing to compare with: give --expected FILE' \
        env -C "$tmp" "$command" study gb --fine 4
    one_line 73 'name a place in a folder' "$loft" study gb --pictures-only -o "$tmp/none/deep"
}
case_harmonic_coordinates_as_a_table() {
    printf '0,0\n4,0 # a notch\n4,3\n2,1\n0,3\n' >"$tmp/notch.csv"
    run 0 "$loft" harmonic "$tmp/notch.csv" -o "$tmp/notch.h"; says out '^error at most [0-9.e-]*, '
    grep -q '^static const loft_harmonic_table ' "$tmp/notch.h" || job_fails "no table"
    printf '%s\n' '#include "polygon/harmonic.h"' '#include "notch.h"' \
        'int main(void) { return notch_table.sides != 5; }' >"$tmp/use.c"
    gcc -std=c99 -Wall -Wextra -Werror -Ilib -DLOFT_NUM=LOFT_Q16 -DLOFT_AXES=3 "$tmp/use.c" \
        -o "$tmp/use" 2>"$tmp/err" && "$tmp/use" || job_fails "$(head -3 "$tmp/err")"
    run 0 "$loft" harmonic "$tmp/notch.csv" --num f64 -o "$tmp/notch.csv.csv"
    says notch.csv.csv '^term,'
    run 0 "$loft" harmonic "$tmp/notch.csv" --at 2,0.5
    says out '^0\.[0-9]*,0\.[0-9]*,0\.[0-9]*,0\.[0-9]*,0\.[0-9]*$'
    printf '0,0\n1,1\n1,0\n0,1\n' >"$tmp/cross.csv"
    one_line 65 'cross.csv: .*cross' "$loft" harmonic "$tmp/cross.csv"
    one_line 65 'not 3 to 8' "$loft" harmonic /dev/null
    one_line 66 'none.csv' "$loft" harmonic "$tmp/none.csv"
    printf '0,0\n4,0\n4,3\n2.0005,3\n2,0.0005\n' >"$tmp/deep.csv"
    run 0 "$loft" harmonic "$tmp/deep.csv"; says out '^error at most [0-9.]*e-0[789], '
    printf '%s\n' 26.1,-0.468 27.149,0.755 2.026,-0.682 23.439,-0.811 29.516,-0.844 15.011,-0.323 \
        >"$tmp/blade.csv"
    run 0 "$loft" harmonic "$tmp/blade.csv"; says out '^error at most [0-9.]*e-0[789], '
    printf '0,0\n100,0.001\n200,0\n100,0.002\n' >"$tmp/needle.csv"
    run 65 "$loft" harmonic "$tmp/needle.csv"
    says err 'needle.csv: the error is above 1e-6, [0-9.e-]*: the polygon is too narrow somewhere'
}
