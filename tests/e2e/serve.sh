# tests/e2e/serve.sh -- loft serve: jobs of a page, pages that should not come in
# SPDX-License-Identifier: MIT

# serves NAME OPTIONS..: a server, its address in $address
serves() {
    local name=$1; shift
    rm -f "$tmp/$name.log"
    XDG_STATE_HOME=$tmp/served "$loft" serve --listen 127.0.0.1:0 "$@" >"$tmp/$name.log" 2>&1 &
    served=$!; children+=("$served"); disown "$served"
    until_log "$name" '^page: '
    address=$(sed -n 's/^page: //p' "$tmp/$name.log")
}
visitor() { python3 "${0%/*}/serve_peer.py" "$address" "$@" 2>&1; }

case_serve_draws() {
    machine m
    serves page --port "$tmp/m"
    visitor draw "$tmp/small.csv" >"$tmp/out"
    says out '^0 drawn: .* as commanded$'
    kill -INT "$served"; gone "$served"
    grep -q . <(grep -v '^page: ' "$tmp/page.log") && job_fails "$(cat "$tmp/page.log")"
    counted m
}

# The machine is held when the server is killed; the next one knows the drawing.
case_serve_killed() {
    machine m
    serves page --port "$tmp/m"
    visitor begin "$tmp/small.csv" >"$tmp/out" || job_fails "$(cat "$tmp/out")"
    kill -9 "$served"; gone "$served"
    serves again --port "$tmp/m"
    visitor go-on >"$tmp/out"
    says out '^0 drawn: .* as commanded$'
    counted m
}

case_serve_attacked() {
    serves page
    local said; said=$(visitor attack)
    [ -z "$said" ] || job_fails "$said"
    kill -INT "$served"; gone "$served"
    serves open --listen 0.0.0.0:0
    [[ $address == *'#token='* ]] || job_fails "no token: $address"
    address=${address/0.0.0.0/127.0.0.1}
    said=$(visitor attack)
    [ -z "$said" ] || job_fails "$said"
    grep -q "${address##*=}" <(grep -v '^page: ' "$tmp/open.log") && job_fails "the token is told"
}
