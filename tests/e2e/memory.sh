# tests/e2e/memory.sh -- memory of long jobs
# SPDX-License-Identifier: MIT

# peak COMMAND..: run it, and append the most memory that it had, in kB, to most[]
peak() {
    run 0 python3 -c 'import resource, subprocess, sys
code = subprocess.run(sys.argv[1:]).returncode
print("most", resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)
sys.exit(code)' "$@"
    most+=("$(sed -n 's/^most //p' "$tmp/out")")
}
long_rows() {                           # long_rows N: each takes 13 s at 15 mm/s
    awk -v n="$1" 'BEGIN { for (i = 0; i < n; i++) {
            a = i % 2 ? 200 : 0
            printf "%g,%g,%g,%g,%g,%g,%g,%g\n",
                a, i / 9, a, i / 9, 200 - a, i / 9, 200 - a, i / 9
        } }' >"$tmp/rows.csv"
}
case_memory_of_a_long_job() {           # 800 thousand points, each of which took 48 bytes
    local most=()
    for rows in 10 60; do
        long_rows $rows
        machine "rows$rows" --speed fast --once
        peak "$plain" stream "$tmp/rows.csv" --feed 15 --points --port "$tmp/rows$rows"
        gone "$machine"; says out 'as commanded$'
    done
    # 131072 items are kept at most
    [ $((most[1] - most[0])) -lt 12000 ] || job_fails "${most[*]} kB"
}
case_memory_of_a_long_plan() {          # 6 more minutes of motion, each of which took 1600 kB
    local most=()
    for rows in 6 30; do
        long_rows $rows
        peak "$plain" plan "$tmp/rows.csv" --feed 15 --jerk 0 --spans -o "$tmp/spans.csv"
        [ "$(wc -l <"$tmp/spans.csv")" -gt $((50 * rows)) ] || job_fails "spans are missing"
    done
    [ $((most[1] - most[0])) -lt 2048 ] || job_fails "${most[*]} kB"
}
case_memory_of_a_long_program() {       # each line took 300 bytes
    local what most
    for what in "plan --total" "stream --dry-run"; do
        most=()
        for lines in 30000 100000; do
            awk -v n=$lines 'BEGIN { print "G21 G90\nG0 X50 Y0\nF18000"
                for (i = 1; i <= n; i++)
                    printf "G1 X%.5f Y%.5f\n", 50 * cos(i / 1000), 50 * sin(i / 1000)
                print "M30" }' >"$tmp/long.nc"
            # shellcheck disable=SC2086
            peak "$plain" $what "$tmp/long.nc" --feed 300 --accel 30000 --jerk 0
        done
        [ $((most[1] - most[0])) -lt 2048 ] || job_fails "$what: ${most[*]} kB"
    done
    most=()                             # lines that stay lines: each took 300 bytes more
    for lines in 20000 200000; do
        awk -v n=$lines 'BEGIN { print "G21 G90\nG0 X50 Y0\nF18000"
            for (i = 1; i <= n; i++)
                printf "G1 X%d Y%d\n", i % 2 * 2, i % 97
            print "M30" }' >"$tmp/hatch.nc"
        peak "$plain" stream --grbl --dry-run "$tmp/hatch.nc"
        [ "$(wc -l <"$tmp/out")" -gt $lines ] || job_fails "lines are missing"
    done
    [ $((most[1] - most[0])) -lt 4096 ] || job_fails "lines: ${most[*]} kB"
}
