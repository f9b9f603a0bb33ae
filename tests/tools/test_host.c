/* tests/tools/test_host.c -- what a call tells its program: messages, progress; and memory
 * SPDX-License-Identifier: MIT
 */
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/host.h"
#include "base/memory.h"
#include "check.h"
#include "gcode/gcode_draw.h"
#include "read/csv.h"
#include "read/drawing_curves.h"
#include "readers.h"
#include "svg/svg_file.h"

typedef struct {
    char text[8192];            /* the messages as lines, and as JSON */
    char json[8192];
    unsigned calls, most;       /* of progress; that many, then stop: 0: all */
    double clock, done, total;
    unsigned ends;
} listener;

static void put(char *to, size_t size, const host_message *m, bool json)
{
    const size_t used = strlen(to);
    FILE *out         = fmemopen(to + used, size - used, "w");

    if (json)
        host_put_json(out, m);
    else
        host_put_line(out, m, "loft: ", "");
    fclose(out);
}

static void keep(void *context, const host_message *m)
{
    listener *l = context;

    put(l->text, sizeof l->text, m, false);
    put(l->json, sizeof l->json, m, true);
}

static bool count(void *context, const host_progress *p)
{
    listener *l = context;

    if (p->doing == NULL) {
        l->ends++;
        return true;
    }
    l->done  = p->done;
    l->total = p->total;
    return ++l->calls != l->most;
}

static double tell_time(void *context) { return ((const listener *)context)->clock; }

static host host_of(listener *l)
{
    *l = (listener){ .calls = 0 };
    return (host){ .message = keep, .progress = count, .now = tell_time, .context = l };
}


// Messages
// --------

static void a_message_is_one_line(arb *a)
{
    listener l;
    host h = host_of(&l);

    (void)a;
    CHECK(host_error(&h, EX_DATAERR, "x.a", (host_place){ "f.nc", 3 }, "do it", "%d is\nwrong",
                     7) == EX_DATAERR);
    host_warn(&h, "x.b", (host_place){ "f.nc", 0 }, NULL, "odd");
    (void)host_error(&h, EX_USAGE, "x.c", (host_place){ NULL, 0 }, "give it", "no port");
    CHECK(strcmp(l.text, "loft: f.nc:3: 7 is\\x0awrong: do it\nloft: f.nc: odd\n"
                         "loft: no port: give it\n") == 0);
    CHECK(h.errors == 2 && h.warnings == 1);
}

static void a_message_is_one_object(arb *a)
{
    listener l;
    host h = host_of(&l);

    (void)a;
    (void)host_error(&h, EX_DATAERR, "x.a", (host_place){ "a\"\x1b.nc", 3 }, "do", "\xff\n\\");
    CHECK(strcmp(l.json, "{\"code\":65,\"name\":\"x.a\",\"file\":\"a\\u0022\\u001b.nc\",\"line\":3,"
                         "\"what\":\"\\u00ff\\u000a\\u005c\",\"remedy\":\"do\"}") == 0);
    host_warn(&h, "x.b", (host_place){ NULL, 0 }, NULL, "odd");
    CHECK(strstr(l.json, "{\"code\":0,\"name\":\"x.b\",\"file\":null,\"line\":0,\"what\":\"odd\","
                         "\"remedy\":null}") != NULL);
}

/* Also one that is longer than any buffer. */
static void words_are_whole(arb *a)
{
    const unsigned length = arb_below(a, 4000);
    char words[4001];
    listener l;
    host h = host_of(&l);

    memset(words, 'w', length);
    words[length] = '\0';
    (void)host_error(&h, EX_DATAERR, "x.a", (host_place){ NULL, 0 }, NULL, "%s", words);
    CHECK(strlen(l.text) == length + strlen("loft: \n"));
}

/* All warnings are given, then a strict call fails; one that does not warn does not. */
static void strict_looks_at_the_end(arb *a)
{
    static const char left[] = "G21 F9\nG1 X1\nM48\nG1 X2\nM50 P1\n", plain[] = "G21 F9\nG1 X1\n";
    char name[] = "/tmp/loft-host-XXXXXX";

    for (int strict = 0; strict < 2; strict++)
        for (int warns = 0; warns < 2; warns++) {
            const int file = mkstemp(name);
            listener l;
            host h    = host_of(&l);
            drawing d = { .dialect = 0 };
            const char *text = warns ? left : plain;
            (void)a;
            h.strict   = strict;
            h.warnings = arb_below(a, 3);       /* of calls before */
            const unsigned before = h.warnings;
            CHECK(write(file, text, strlen(text)) == (ssize_t)strlen(text) && close(file) == 0);
            CHECK(drawing_read(&h, &d, name) == (strict && warns ? EX_DATAERR : 0));
            CHECK(h.warnings - before == (warns ? 2u : 0u) && h.errors == 0);
            drawing_free(&d);
            (void)unlink(name);
            strcpy(name, "/tmp/loft-host-XXXXXX");
        }
}

/* Who listens to nothing gets the code. */
static void nobody_has_to_listen(arb *a)
{
    host h    = { .message = NULL };
    drawing d = { .dialect = 0 };

    (void)a;
    CHECK(drawing_read_gcode(&h, &d, "f.nc", "G1 X\n", 5) == EX_DATAERR && h.errors == 1);
    drawing_free(&d);
}


// Progress
// --------

static void progress_comes_ten_times_a_second(arb *a)
{
    const unsigned turns = 1 + arb_below(a, 1000);
    listener l;
    host h = host_of(&l);

    for (unsigned n = 0; n < turns; n++) {
        l.clock = n * 0.01;
        CHECK(host_goes_on(&h, &(host_progress){ "counting", n, turns, false }));
    }
    CHECK(l.calls >= turns / 11 && l.calls <= 1 + turns / 10 && l.total >= turns);
    host_has_done(&h);
    host_has_done(&h);
    CHECK(l.ends == 1);
}

/* A file of several parts. Without a clock, each part is told; any answer ends it cleanly. */
static void a_reading_stops_when_it_is_told_to(arb *a)
{
    char name[]    = "/tmp/loft-host-XXXXXX";
    const int file = mkstemp(name);
    FILE *out      = fdopen(file, "w");
    drawing d      = { .dialect = 0 };
    listener l;
    host h = host_of(&l);

    h.now = NULL;
    fputs("G21 F900\n", out);
    for (int n = 0; n < 100000; n++)
        fprintf(out, "G1 X%d Y%d\n", n % 97, n % 89);
    fclose(out);
    l.most = 1 + arb_below(a, 4);
    const int code = drawing_read(&h, &d, name);
    CHECK(l.calls == l.most ? code == EX_TEMPFAIL : code == 0 && d.count > 0);
    CHECK(l.calls >= 2 || l.most < 2);
    CHECK(l.text[0] == '\0' && l.ends == 1 && l.done <= l.total);
    drawing_free(&d);
    (void)unlink(name);
}


// Memory
// ------

static unsigned left;           /* pieces of memory that there are */

static void *few(void *old, size_t bytes)
{
    if (left == 0)
        return NULL;
    left--;
    return realloc(old, bytes);
}

static void leave(size_t bytes) { _exit(bytes > 0 ? EX_OSERR : EX_SOFTWARE); }

static void read_all(host *h)
{
    static const char svg[] = "<svg xmlns='http://www.w3.org/2000/svg' width='9mm' height='9mm'>"
                              "<style>path { stroke: red }</style><path d='M1 1C2 3 4 5 6 7'/>"
                              "<rect width='5' height='5' stroke='red'/></svg>";
    static const char nc[]   = "G21 F9\no1 sub\nG2 X5 I2.5\no1 endsub\no1 call\nG0 X0\n";
    static const char loft[] = "nurbs 3\n0 0\n1 2 : 2\n3 3\n5 1\n6 0\n";
    static const char csv[]  = "0,0,1,1,2,1,3,0\n";
    drawing d[4] = { { .count = 0 } };

    if (drawing_read_svg(h, &d[0], "f.svg", svg, sizeof svg - 1) != 0 ||
        drawing_read_gcode(h, &d[1], "f.nc", nc, sizeof nc - 1) != 0 ||
        drawing_read_curves(h, &d[2], "f.loft", loft) != 0 ||
        drawing_read_csv(h, &d[3], "f.csv", csv, sizeof csv - 1) != 0)
        _exit(EX_DATAERR);
    for (int i = 0; i < 4; i++)
        drawing_free(&d[i]);
}

/* Whichever piece of memory is the first that is refused: the program's handler is called, once. */
static void without_memory_the_program_decides(arb *a)
{
    const unsigned many = 1000000;
    host h     = { .message = NULL };
    int status = 0;

    memory_take_by(few);
    left = many;
    read_all(&h);
    memory_take_by(NULL);
    const unsigned needed = many - left, pieces = arb_below(a, needed + 2);
    const pid_t child     = fork();
    if (child == 0) {
        memory_take_by(few);
        memory_is_out(leave);
        left = pieces;
        read_all(&h);
        _exit(0);
    }
    CHECK(child > 0 && waitpid(child, &status, 0) == child && WIFEXITED(status));
    CHECK(needed > 10 && WEXITSTATUS(status) == (pieces < needed ? EX_OSERR : 0));
}

int main(void)
{
    PROPERTY(a_message_is_one_line, 1);
    PROPERTY(a_message_is_one_object, 1);
    PROPERTY(words_are_whole, 50);
    PROPERTY(strict_looks_at_the_end, 5);
    PROPERTY(nobody_has_to_listen, 1);
    PROPERTY(progress_comes_ten_times_a_second, 50);
    PROPERTY(a_reading_stops_when_it_is_told_to, 6);
    PROPERTY(without_memory_the_program_decides, 40);
    return check_failures();
}
