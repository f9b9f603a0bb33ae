# tests/house/mutate.py -- change lib/ a little, and look whether the tests of the room see it
# SPDX-License-Identifier: MIT
"""usage: python3 tests/house/mutate.py [--rooms R,..] [--sample N] [--seed N] [--all] [--page]
       [--only TEXT] [--verbose]

Of each room (path, or path:60 with a sample of its own) it takes a sample of the mutants that
mutants.py finds, compiles the changed file alone as the library is compiled, and runs the room's
tests with it, the fastest first, until one fails.
It runs them in q16; with --all what survives in f64 and f32, with little effort, and sanitized too.
A mutant with the same object code is equivalent, and so is one that mutants.txt lists with a
reason. What is known from before (build/mutate) is not done again; a survivor is if tests changed.
--only takes the mutants whose line in the output contains the text. --page writes tests/MUTANTS.md.
"""
import argparse
import atexit
import collections
import fcntl
import glob
import hashlib
import json
import os
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, os.path.dirname(__file__))
import mutants

OUT = "build/mutate"
os.makedirs(OUT, exist_ok=True)
WORK = tempfile.mkdtemp(prefix="run-", dir=OUT)
atexit.register(shutil.rmtree, WORK)
LIST = "tests/house/mutants.txt"
SAMPLE, SEED = 20, 1
SLOWER, LEAST = 10, 2           # a mutant may take this many times as long, and these seconds
ALL_SECONDS = 3                 # a test that takes longer runs a share of its seeds
MEMORY = 4 << 30                # of a test that is not sanitized
ROOMS = ["num", "geom", "basis", "curve", "kinematics", "path", "motion", "wire", "machine",
         "surface", "polygon", "toolpath"]
EFFORT_TESTS = {"path": ["path", "corner", "tube"], "motion": ["plan", "timing", "any"],
                "machine": ["planner"]}
CC = [word for word in os.environ.get("CC", "cc").split() if "ccache" not in word]
CACHED_CC = os.environ.get("CC", "cc").split()
SANITIZE = ["-fsanitize=address,undefined", "-fno-sanitize-recover=all"]
Done = collections.namedtuple("Done", "code seconds")


class Build:
    """A way to compile: its flags, and what make has built that way."""
    def __init__(self, name, num, flags, libraries=(), objects=None):
        self.name, self.objects = name, objects
        self.sanitized = SANITIZE[0] in flags
        self.flags = ["-std=c99", "-w", "-Ilib", "-DLOFT_NUM=LOFT_" + num.upper()] + flags
        self.libraries, self.ready = list(libraries), False

    def prepare(self):
        if not self.ready:
            wanted = self.libraries or objects_of(self.objects, None)
            make(wanted)
        self.ready = True

    def others(self, path):
        """What a changed file is linked with."""
        return self.libraries or objects_of(self.objects, path)


def objects_of(folder, without):
    rooms = ["num", "geom", "basis", "curve", "kinematics", "path", "motion", "wire", "machine"]
    return ["%s/%s.o" % (folder, path[:-2]) for room in rooms
            for path in sorted(glob.glob("lib/%s/*.c" % room)) if path != without]


def libraries(folder):
    return [folder + "/libloft-surfaces.a", folder + "/libloft.a"]


PLAIN = ["-O2", "-DLOFT_AXES=3"]
CHECKED = ["-Og", "-DLOFT_AXES=3", *SANITIZE]
BUILDS = [Build("q16", "q16", PLAIN, libraries("build/q16x3")),
          Build("effort 1", "q16", ["-Og", "-DLOFT_PLAN_EFFORT=1", *SANITIZE],
                objects="build/effort"),
          Build("f64", "f64", PLAIN, libraries("build/f64x3")),
          Build("f32", "f32", PLAIN, libraries("build/f32x3")),
          Build("q16 sanitized", "q16", CHECKED, libraries("build/test/q16"))]


def make(targets):
    environment = {k: v for k, v in os.environ.items() if not k.startswith("MAKE")}
    subprocess.run(["make", "-s", "-j%d" % os.cpu_count(), *targets], check=True,
                   stdout=sys.stderr, env=environment)


def held_elsewhere():
    """The rows of tests/README.md: which test holds a header that has no test of its name."""
    rows = re.findall(r"^\| `(\w+)/(\w+)\.h` \| `(lib/[\w/]+\.c)` \|",
                      open("tests/README.md", encoding="utf-8").read(), re.M)
    found = collections.defaultdict(dict)
    for room, header, test in rows:
        found[room][header] = "tests/" + test
    return found


def tests_of(room):
    own = glob.glob("tests/lib/%s/test_*.c" % room) + glob.glob("tests/lib/%s/*/test_*.c" % room)
    return sorted(set(own) | set(held_elsewhere()[room].values()))


class Test:
    """A test, compiled one way, and how long it takes."""
    def __init__(self, build, path):
        self.build, self.path = build, path
        self.name = os.path.basename(path)[5:-2]
        self.object = "%s/%s/%s.o" % (WORK, build.name.replace(" ", "-"), self.name)
        os.makedirs(os.path.dirname(self.object), exist_ok=True)
        also = solver() if "harmonic" in self.name else []
        subprocess.run([*CACHED_CC, *build.flags, "-Itests", "-Ihost-tools", "-Iports", "-c", path,
                        "-o", self.object], check=True)
        self.also = also
        self.hash = hashlib.sha1(open(self.object, "rb").read()).hexdigest()
        self.seconds, self.share = None, 1

    def measure(self, known):
        """The seconds of processor that it takes; of a long one, a share of its seeds."""
        at = "%s %s %s" % (self.build.name, self.hash, ALL_SECONDS)
        if at not in known:
            program = self.link([], "unchanged")
            done = run(program, 1, 3600)
            share = max(1, round(done.seconds / ALL_SECONDS))
            if share > 1:
                done = run(program, share, 3600)
            if done.code != 0:
                raise SystemExit("mutate: %s fails unchanged, in %s" % (self.path, self.build.name))
            known[at] = [done.seconds, share]
        self.seconds, self.share = known[at]

    def link(self, changed, path):
        program = "%s/program" % WORK
        sanitize = SANITIZE if self.build.sanitized else []
        subprocess.run([*CC, *sanitize, *changed, self.object, *self.also,
                        *self.build.others(path), "-lm", "-o", program], check=True)
        return program

    def sees(self, changed, path):
        """Does it fail?"""
        done = run(self.link([changed], path), self.share,
                   self.seconds * SLOWER + LEAST, not self.build.sanitized)
        return done.code != 0


def solver():
    sources = glob.glob("host-tools/engine/harmonic*.c") + glob.glob("host-tools/base/least*.c") + \
        ["host-tools/base/memory.c"]
    objects = ["build/solver/%s.o" % path[:-2] for path in sorted(sources)]
    make(objects)
    return objects


def run(program, share, most, bounded=False):
    """Run a test; its exit code, and its seconds of processor."""
    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (int(most) + 1, int(most) + 2))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        if bounded:
            resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    environment = {k: v for k, v in os.environ.items() if not k.startswith("LOFT_")}
    try:
        done = subprocess.run([program], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                              env=dict(environment, LOFT_SHARE=str(share)), preexec_fn=limit,
                              timeout=20 * most + 60)
        code = done.returncode
    except subprocess.TimeoutExpired:
        code = -1
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return Done(code, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)


def compiled(build, text, to):
    """Compile a text; its object code, or None."""
    done = subprocess.run([*CC, *build.flags, "-ffreestanding", "-x", "c", "-", "-c", "-o", to],
                          input=text.encode(), stderr=subprocess.DEVNULL)
    return open(to, "rb").read() if done.returncode == 0 else None


class Room:
    def __init__(self, name, known):
        self.name, self.known = name, known
        self.tests, self.codes = {}, {}
        self.texts, self.found = {}, []
        for path in sorted(glob.glob("lib/%s/*.c" % name) + glob.glob("lib/%s/*/*.c" % name)):
            self.texts[path], found = mutants.find(
                path, ["-Ilib", "-DLOFT_NUM=LOFT_Q16", "-DLOFT_AXES=3"])
            self.found += found

    def tests_in(self, build):
        """Its tests built one way, the fastest first."""
        if build.name not in self.tests:
            build.prepare()
            paths = tests_of(self.name)
            if build.objects:
                names = EFFORT_TESTS.get(self.name, [])
                paths = [p for p in paths if os.path.basename(p)[5:-2] in names]
            tests = [Test(build, path) for path in paths]
            for test in tests:
                test.measure(self.known.times)
            self.known.save()
            self.tests[build.name] = sorted(tests, key=lambda t: t.seconds)
        return self.tests[build.name]

    def tests_hash(self):
        text = "".join(open(path, encoding="utf-8").read() for path in tests_of(self.name))
        return hashlib.sha1(text.encode()).hexdigest()

    def in_order(self, seed):
        """The mutants in an order by chance, which a change elsewhere does not alter."""
        def rank(mutant):
            return hashlib.sha1(("%s %s" % (seed, mutant.key)).encode()).hexdigest()
        return sorted(self.found, key=rank)

    def code_of(self, path):
        if path not in self.codes:
            self.codes[path] = compiled(BUILDS[0], self.texts[path], WORK + "/same.o")
        return self.codes[path]

    def judge(self, mutant, builds):
        """`killed by ..`, `same code`, `no code`, `survived ..`"""
        text = mutant.apply(self.texts[mutant.path])
        for build in builds:
            tests = self.tests_in(build)
            changed = WORK + "/changed.o"
            if not tests:
                continue
            code = compiled(build, text, changed)
            if code is None:
                return "no code"
            if build is BUILDS[0]:
                if code == self.code_of(mutant.path):
                    return "same code"
            own = [t for t in tests if t.name == os.path.basename(mutant.path)[:-2]]
            for test in own + [t for t in tests if t not in own]:
                if test.sees(changed, mutant.path):
                    return "killed by %s, %s" % (test.name, build.name)
        return "survived by %d" % len(builds)


class Known:
    """What is known from before."""
    def __init__(self):
        self.at = OUT + "/known.json"
        self.verdicts, self.times = {}, {}
        self.save()

    def save(self):
        """Write it, with what another run has found."""
        with open(self.at + ".lock", "w", encoding="utf-8") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            if os.path.exists(self.at):
                with open(self.at, encoding="utf-8") as file:
                    verdicts, times = json.load(file)
                self.verdicts = {**verdicts, **self.verdicts}
                self.times = {**times, **self.times}
            with open(self.at + ".new", "w", encoding="utf-8") as file:
                json.dump([self.verdicts, self.times], file)
            os.replace(self.at + ".new", self.at)


def reasons():
    """Mutants that no test can see: {line: reason}"""
    found, line = {}, None
    text = open(LIST, encoding="utf-8").read() if os.path.exists(LIST) else ""
    for part in re.sub(r" \\\n +", " ", text).split("\n"):
        if part.startswith("    "):
            found[line] = (found[line] + " " + part.strip()).strip()
        elif part.strip() and not part.startswith("#"):
            line = part.strip()
            found[line] = ""
    return found


def verdict_of(room, mutant, known, listed, builds):
    if mutant.name in listed:
        return "equivalent"
    verdict, tests = known.verdicts.get(mutant.key, ("", ""))
    if not verdict or verdict.startswith("survived") and (
            tests != room.tests_hash() or verdict < "survived by %d" % len(builds)):
        verdict = room.judge(mutant, builds)
        known.verdicts[mutant.key] = (verdict, room.tests_hash())
        known.save()
    return verdict


def mutate(room, size, listed, known, options):
    """Judge a sample; how many of each verdict, and the survivors."""
    counts, survivors = collections.Counter(), []
    builds = BUILDS if options.all else BUILDS[:1]
    names = {mutant.name for mutant in room.found}
    for name in sorted(n for n in listed if n.startswith(room.name + "/") and n not in names):
        print("%s: there is no such mutant: %s" % (LIST, name))
    for mutant in room.in_order(options.seed):
        if options.only and options.only not in "%s:%d: %s" % (mutant.path, mutant.line,
                                                               mutant.name):
            continue
        if size and counts["killed"] + counts["survived"] + counts["equivalent"] >= size:
            break
        began = time.time()
        verdict = verdict_of(room, mutant, known, listed, builds)
        kind, survived = verdict.split(" by ")[0], verdict.startswith("survived")
        counts[kind] += 1
        if survived:
            survivors.append(mutant)
        if survived or options.verbose:
            print("%s:%d: %s: %s" % (mutant.path, mutant.line, mutant.name.split(" ", 1)[1],
                                     verdict if options.verbose else kind),
                  "(%.1f s)" % (time.time() - began) if options.verbose else "", flush=True)
    return counts, survivors


def row(name, found, counts):
    """Of those that can be seen, which part was?"""
    seen, missed = counts["killed"], counts["survived"]
    part = "%.1f %%" % (100 * seen / (seen + missed)) if seen + missed else "-"
    return (name, str(found), str(seen + missed + counts["equivalent"] + counts["same code"]),
            str(counts["same code"]), str(counts["equivalent"]), str(seen), str(missed), part)


HEAD = ("room", "mutants", "tried", "same code", "equivalent", "killed", "survived", "score")
PAGE = """# What tests see of small changes

Do not edit: this is written by

    make mutate PAGE=1 SAMPLE=%d SEED=%d \\
        ROOM=%s

A mutant is a small change of a file of `lib/`: an operator, a constant, a condition, a statement
left out. It is killed if a test of the room fails with it. Same code: the compiler makes the same
of it. Equivalent: no test can see it; [house/mutants.txt](house/mutants.txt) says why. The score is
killed of killed and survived.
"""


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--rooms", default=",".join(ROOMS))
    parser.add_argument("--sample", type=int, default=SAMPLE)
    parser.add_argument("--seed", type=int, default=SEED)
    parser.add_argument("--only", default="")
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--page", action="store_true")
    parser.add_argument("--verbose", action="store_true")
    options = parser.parse_args()
    known, listed = Known(), reasons()
    rows, survivors = [HEAD], []
    for word in options.rooms.split(","):
        name, _, size = word.partition(":")
        room = Room(name, known)
        counts, missed = mutate(room, int(size or options.sample), listed, known, options)
        rows.append(row(name, len(room.found), counts))
        survivors += missed
    print_rows(rows)
    if options.page:
        write_page(rows, survivors, options)


def print_rows(rows):
    wide = [max(len(r[k]) for r in rows) for k in range(len(HEAD))]
    for r in rows:
        print("  ".join(word.ljust(wide[k]) if k == 0 else word.rjust(wide[k])
                        for k, word in enumerate(r)))


def write_page(rows, survivors, options):
    with open("tests/MUTANTS.md", "w", encoding="utf-8") as page:
        page.write(PAGE % (options.sample, options.seed, options.rooms))
        page.write("\n| %s |\n|%s\n" % (" | ".join(HEAD), "---|" * len(HEAD)))
        for r in rows[1:]:
            page.write("| %s |\n" % " | ".join(r))
        if survivors:
            page.write("\nSurvivors:\n\n")
        for mutant in survivors:
            page.write("    %s\n" % mutant.name[:95])


if __name__ == "__main__":
    main()
