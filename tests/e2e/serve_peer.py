# tests/e2e/serve_peer.py -- asks `loft serve` as pages do, and as those who should not come in
# SPDX-License-Identifier: MIT
# usage: serve_peer.py ADDRESS WHAT [FILE]
#   draw FILE    drop a drawing, start it, hold it, go on: prints the closing line
#   begin FILE   the same up to the hold, and leave
#   go-on        start what is there: prints the closing line
#   attack       foreign origins and names, wrong tokens, large and slow ones, noise: prints what
#                should not be
import base64
import json
import os
import random
import re
import socket
import struct
import sys
from urllib.parse import urlparse

URL = urlparse(sys.argv[1])
TOKEN = URL.fragment.removeprefix("token=")
HOST = "%s:%d" % (URL.hostname, URL.port)


def connect():
    return socket.create_connection((URL.hostname, URL.port), timeout=60)


def ask_http(method, path, headers=(), body=b"", host=HOST):
    """The status; 0: the connection ended without one."""
    with connect() as s:
        head = "%s %s HTTP/1.1\r\nHost: %s\r\n" % (method, path, host)
        head += "".join("%s: %s\r\n" % h for h in headers)
        try:
            s.sendall(head.encode() + b"\r\n" + body)
            answer = s.recv(65536)
        except OSError:
            return 0, b""
        while not is_whole(answer):
            try:
                more = s.recv(65536)
            except OSError:
                break
            if not more:
                break
            answer += more
        return int(answer.split()[1]) if answer else 0, answer


def is_whole(answer):
    """Its head, and as many bytes of its body as that says."""
    head, end, body = answer.partition(b"\r\n\r\n")
    size = re.search(rb"(?im)^content-length: *(\d+)", head)
    return bool(end) and len(body) >= (int(size[1]) if size else 0)


class Page:
    """A WebSocket (RFC 6455)."""

    def __init__(self, origin="http://" + HOST, host=HOST, protocol="loft"):
        self.s, self.had, self.number, self.state = connect(), b"", 0, {}
        head = ("GET / HTTP/1.1\r\nHost: %s\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: %s\r\n" %
                (host, base64.b64encode(os.urandom(16)).decode()))
        head += "Origin: %s\r\n" % origin if origin else ""
        head += "Sec-WebSocket-Protocol: %s\r\n" % protocol if protocol else ""
        self.s.sendall(head.encode() + b"\r\n")
        answer = b""
        while b"\r\n\r\n" not in answer:
            more = self.s.recv(4096)
            if not more:
                break
            answer += more
        self.had = answer.partition(b"\r\n\r\n")[2]
        self.open = b" 101 " in answer.split(b"\r\n")[0]

    def send(self, text, opcode=1, last=True):
        data = text if isinstance(text, bytes) else text.encode()
        size = len(data)
        head = bytes([(0x80 if last else 0) | opcode])
        head += bytes([0x80 | size]) if size < 126 else (
            bytes([0xfe]) + struct.pack(">H", size) if size < 65536 else
            bytes([0xff]) + struct.pack(">Q", size))
        self.s.sendall(head + bytes(4) + data)

    def take(self, count):
        while len(self.had) < count:
            more = self.s.recv(65536)
            if not more:
                raise EOFError
            self.had += more
        data, self.had = self.had[:count], self.had[count:]
        return data

    def text(self):
        whole = b""
        while True:
            first, size = self.take(2)
            if size == 126:
                size = struct.unpack(">H", self.take(2))[0]
            elif size == 127:
                size = struct.unpack(">Q", self.take(8))[0]
            data = self.take(size)
            if first & 15 == 8:
                raise EOFError
            if first & 15 == 9:
                self.send(data, 10)
            if first & 15 > 2:
                continue
            whole += data
            if first & 0x80:
                return json.loads(whole)

    def next(self):
        """The next text; the state follows what it says."""
        said = self.text()
        if said.get("method") == "state":
            self.state.update(said["params"]["changed"])
        self.state.update(said.get("result", {}).get("state", {}) if "id" in said else {})
        return said

    def ask(self, method, **params):
        self.number += 1
        self.send(json.dumps({"jsonrpc": "2.0", "id": self.number, "method": method,
                              "params": params}))
        while True:
            said = self.next()
            if said.get("id") == self.number:
                return said

    def hello(self):
        return self.ask("hello", protocol=1, token=TOKEN)

    def until(self, part, key, *words):
        while self.state.get(part, {}).get(key) not in words:
            self.next()
        return self.state[part]

    def ends(self):
        """True if the server lets this page go."""
        try:
            while True:
                self.next()
        except (EOFError, ConnectionError):
            return True


def upload(file):
    body = open(file, "rb").read()
    status, answer = ask_http("POST", "/upload?name=" + os.path.basename(file),
                              [("X-Loft-Token", TOKEN), ("Content-Length", len(body))], body)
    assert status == 200, answer
    return json.loads(answer.partition(b"\r\n\r\n")[2])["upload"]


def begin(file):
    page = Page()
    page.hello()
    number = page.ask("drawing.open", upload=upload(file))["result"]["plan"]
    while page.state["plan"]["number"] < number or page.state["plan"]["state"] != "ready":
        page.next()
    page.until("machine", "state", "idle")
    assert len(page.ask("plan.moves")["result"]["plan"]["moves"]) > 3
    assert "result" in page.ask("job.start")
    page.until("job", "state", "draws")
    page.ask("job.hold")
    page.until("job", "state", "held")
    return page


def finish(page):
    over = page.until("job", "state", "over")
    print(over["code"], over["result"])


def expect(what, is_so):
    if not is_so:
        print("not so: " + what)


def attack_http():
    expect("a foreign name is refused", ask_http("GET", "/", host="evil.example")[0] == 421)
    expect("a rebound name is refused",
           ask_http("GET", "/", host="127.0.0.1.evil.example:%d" % URL.port)[0] == 421)
    expect("a file above is refused", ask_http("GET", "/../../etc/passwd")[0] in (403, 404))
    expect("an upload of a foreign page is refused",
           ask_http("POST", "/upload?name=a", [("Origin", "http://evil.example"),
                                               ("X-Loft-Token", TOKEN),
                                               ("Content-Length", 1)], b"x")[0] == 403)
    expect("a large upload is refused",
           ask_http("POST", "/upload?name=a", [("X-Loft-Token", TOKEN),
                                               ("Content-Length", 1 << 30)])[0] == 413)
    expect("an upload without a size is refused",
           ask_http("POST", "/upload?name=a", [("X-Loft-Token", TOKEN)])[0] == 413)
    if TOKEN:
        for token in "", TOKEN[:-1], TOKEN[:-1] + "g":
            expect("a wrong token is refused",
                   ask_http("POST", "/upload?name=a", [("X-Loft-Token", token),
                                                       ("Content-Length", 1)], b"x")[0] == 401)


def attack_sockets():
    expect("a foreign page is refused", not Page(origin="http://evil.example").open)
    expect("another port is another page",
           not Page(origin="http://%s:%d" % (URL.hostname, URL.port ^ 1)).open)
    expect("a rebound name is refused", not Page(host="evil.example").open)
    expect("a socket without a protocol is refused", not Page(protocol="").open)
    expect("a program without an origin comes in", Page(origin="").open)
    page = Page()
    page.send(b"\x00\x01", 2)
    expect("bytes are no text", page.ends())
    page = Page()
    page.hello()
    page.send("[" * 70000)
    expect("a long text is refused", page.ends())
    page = Page()
    page.send('{"jsonrpc":"2.0","id":1,"method":"job.hold"}')
    expect("nothing comes before hello", page.ends())
    if TOKEN:
        page = Page()
        expect("a wrong token is refused",
               page.ask("hello", protocol=1, token="x" * len(TOKEN))["error"]["code"] == 1)
        expect("and its page is let go", page.ends())


def attack_noise():
    noise = random.Random(7)
    for n in range(200):
        page = Page()
        if n % 2:
            page.hello()
        data = noise.randbytes(noise.randrange(1, 60))
        try:
            if n % 3:
                page.s.sendall(data)
            else:
                page.send(data.decode("latin1"))
        except OSError:
            pass
        page.s.close()


def attack_slow():
    """Many who send half a header do not keep a page out."""
    slow = [connect() for _ in range(30)]
    for s in slow:
        s.sendall(b"GET / HTTP/1.1\r\nHost: ")
    page = Page()
    expect("slow ones keep nobody out", "result" in page.hello())
    many = [Page() for _ in range(25)]
    expect("some are too many", not all(one.open for one in many) or many[-1].ends())
    expect("a page that is in can hold", "result" in page.ask("job.hold"))
    for s in slow:
        s.close()
    for one in many:
        one.s.close()


what = sys.argv[2]
if what == "begin":
    begin(sys.argv[3])
elif what == "draw":
    drawn = begin(sys.argv[3])
    drawn.ask("job.override", percent=200)
    drawn.ask("job.resume")
    finish(drawn)
elif what == "go-on":
    again = Page()
    again.hello()
    again.until("machine", "state", "busy", "held", "idle")
    assert "result" in again.ask("job.start")
    finish(again)
else:
    attack_http()
    attack_sockets()
    attack_noise()
    attack_slow()
    last = Page()
    expect("it still answers", "result" in last.hello())
