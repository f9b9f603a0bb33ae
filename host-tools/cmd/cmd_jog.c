/* host-tools/cmd/cmd_jog.c -- loft jog: moves the tool by keys, or by lines
 * SPDX-License-Identifier: MIT
 *
 * A terminal does not say when a key is released; it repeats a held one some 30 times a second. So
 * a key that comes again within HELD is held: then the tool moves towards the end of the table
 * until no repetition has come for HELD, and slows down on the path.
 */
#include <ctype.h>
#include <math.h>
#include <poll.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "cmd/commands.h"
#include "cmd/run.h"            /* run_until */
#include "cmd/run_move.h"       /* run_mover, run_told */
#include "cmd/keys.h"           /* keys_next */
#include "base/say.h"
#include "base/scan.h"           /* scan_number */
#include "send/hand.h"

#define HELD 0.15               /* s between two repetitions of a held key, at most */
#define LINE 200                /* bytes of a line at most */

static const double sizes[] = { 0.01, 0.1, 1, 10 };
#define SIZES ((int)(sizeof sizes / sizeof sizes[0]))

/* Keys that move: +-(axis + 1). */
typedef struct {
    mover v;
    double feed;                /* mm/s */
    int size;                   /* of sizes[] */
    int escape;                 /* bytes of an arrow key that have come */
    int key, other;             /* the key that moves; another one that came meanwhile */
    double last;                /* the clock when `key` last came */
    unsigned taps;              /* of `key`, which are still to be moved */
    bool run;                   /* it is held */
} jog;

static int letter_of(int key)
{
    static const char letters[] = "adswfr";
    const char *at = key ? strchr(letters, tolower(key)) : NULL;

    return at ? ((at - letters) % 2 ? 1 : -1) * (int)((at - letters) / 2 + 1) : 0;
}

/* An arrow, or a key for pages, is ESC [ and a letter or digit. */
static int arrow_of(int key)
{
    switch (key) {
    case 'C': return 1;
    case 'D': return -1;
    case 'A': return 2;
    case 'B': return -2;
    case '5': return 3;
    case '6': return -3;
    default:  return 0;
    }
}

/* The next key: a direction, a character above 6, or 0. */
static int next_key(jog *g)
{
    for (int key; (key = keys_next()) != 0;) {
        const int before = g->escape;
        g->escape = key == 27 ? 1 : before == 1 && key == '[' ? 2 : 0;
        if (g->escape || key == '~')
            continue;
        const int way = before == 2 ? arrow_of(key) : letter_of(key);
        if (way != 0 || before != 2)
            return way ? way : key;
    }
    return 0;
}

/* While the tool moves: the same key holds or taps, any other one ends the move. */
static bool ends_now(void *context)
{
    jog *g = context;

    for (int key; (key = next_key(g)) != 0;) {
        const double now = tool_clock();
        if (key != g->key) {
            g->other = key;
            return true;
        }
        g->taps += !g->run && now - g->last > HELD;
        g->last = now;
    }
    return g->run && tool_clock() - g->last > HELD;
}

static void show_place(const jog *g)
{
    char text[96];

    if (!isatty(STDERR_FILENO))
        return;
    fputs("\r", stderr);
    (void)say(stderr, "%s  step %g mm  (arrows or wasd: x y, page or r f: z, 1-4 step, q ends)",
              mover_text(g->v.at, text), sizes[g->size]);
    fputs("\033[K", stderr);
}

/* Errors that the user can move away from do not end jogging. */
static bool fatal(int code)
{
    return code == EX_IOERR || code == EX_SOFTWARE || keys_interrupted();
}

static int move_by_key(jog *g)
{
    const int axis   = (g->key < 0 ? -g->key : g->key) - 1;
    const double way = g->run ? HUGE_VAL : sizes[g->size];
    hand m;

    mover_ready(&g->v);
    hand_jog(&m, &g->v, axis, g->key < 0 ? -way : way, g->v.p.feed, ends_now, g);
    return run_until(hand_task(&m));
}

/* The key may come again while it moves. */
static int obey_key(jog *g, int key)
{
    const double now = tool_clock();
    int code = 0;

    g->run  = key == g->key && now - g->last <= HELD;
    g->key  = key;
    g->last = now;
    for (g->taps = 1; g->taps > 0 && code == 0 && g->other == 0; g->taps--) {
        code = move_by_key(g);
        show_place(g);
    }
    return fatal(code) ? code : 0;
}

static int jog_by_keys(jog *g)
{
    int code = 0;

    show_place(g);
    while (code == 0 && !keys_interrupted()) {
        struct pollfd p = { .fd = STDIN_FILENO, .events = POLLIN };
        const int key   = g->other ? g->other : next_key(g);
        g->other = 0;
        if (key == 'q')
            break;
        if (key >= -ENGINE_AXES && key <= ENGINE_AXES && key != 0)
            code = obey_key(g, key);
        else if (key >= '1' && key < '1' + SIZES)
            g->size = key - '1';
        if (key != 0)
            show_place(g);
        else
            (void)poll(&p, 1, 50);
    }
    fputs(isatty(STDERR_FILENO) ? "\n" : "", stderr);
    return code;
}


// Without a terminal
// ------------------

/* `x10 y-2.5`: by how much each axis moves. */
static bool take_line(const char *s, double by[ENGINE_AXES])
{
    bool any = false;

    for (int i = 0; i < ENGINE_AXES; i++)
        by[i] = 0;
    for (s += strspn(s, " \t\r\n"); *s != '\0'; s += strspn(s, " \t\r\n")) {
        const char *axis = strchr("xyz", *s++);
        double number;
        if (axis == NULL || by[axis - "xyz"] != 0 || !scan_number(&s, &number) ||
            !(fabs(number) <= 16383) || !strchr(" \t\r\n", *s))
            return false;
        by[axis - "xyz"] = number;
        any = true;
    }
    return any;
}

static int move_by_line(jog *g, const double by[ENGINE_AXES])
{
    hand m;

    mover_ready(&g->v);
    hand_go(&m, &g->v, by, true, g->feed);
    return run_told(&g->v, run_until(hand_task(&m)));
}

static int jog_by_lines(jog *g)
{
    char line[LINE];
    double by[ENGINE_AXES];
    int code = 0;

    for (unsigned n = 1; code == 0 && fgets(line, sizeof line, stdin) != NULL; n++) {
        if (line[strspn(line, " \t\r\n")] == '\0')
            continue;
        code = take_line(line, by)
                   ? move_by_line(g, by)
                   : tool_error(EX_DATAERR, "-:%u: not a move: give axes and mm, as x10 y-2.5", n);
    }
    return code;
}

typedef struct {
    mover_options move;
    double feed;                /* mm/s */
} jog_options;

static const option jog_rows[] = {
    OPTION_GROUP(jog_options, move, mover_rows),
    { "feed", OPTION_NUMBER(jog_options, feed), .least = 0.016, .most = 1000, .unit = "mm/s",
      .standard = "30", .help = "mm/s, or as 1200mm/min" },
    OPTION_NO_WORDS("jog takes keys, or lines as x10 on standard input: `loft go X,Y --by` is one "
                    "move"),
    OPTION_EXCLUDES("port=-", "", "both the moves and the port are standard input: name a port"),
    { 0 }
};

static int run_jog(void *options)
{
    const jog_options *o = options;
    jog g                = { .size = 2, .feed = o->feed };
    const bool keys      = isatty(STDIN_FILENO);
    int code             = run_mover(&g.v, &o->move, keys);

    if (code == 0 && keys) {
        code = jog_by_keys(&g);
        (void)run_told(&g.v, 0);
    } else if (code == 0) {
        code = jog_by_lines(&g);
    }
    mover_close(&g.v);
    return code;
}

const command command_jog = {
    .name = "jog",
    .arguments = "--port PORT",
    .summary = "move the tool by keys, or by lines as x10",
    .detail =
        "On a terminal: arrows, or a d s w, move x and y; page up and down, or r f, move z; 1 to "
        "4\n"
        "choose steps of 0.01, 0.1, 1 and 10 mm; q ends. A held key moves the tool on; when it is\n"
        "released, the tool slows down on its way and stops. Any other key stops it as well. "
        "Otherwise\n"
        "lines on standard input are moves: x10 y-2.5, in mm from where the tool is. The table of "
        "the\n"
        "machine file is not left.\n",
    .options = jog_rows,
    .size = sizeof(jog_options),
    .run = run_jog,
    .talks = true,
};
