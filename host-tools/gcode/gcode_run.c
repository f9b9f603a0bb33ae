/* host-tools/gcode/gcode_run.c -- runs a line of G-code: its words in their order of execution
 * SPDX-License-Identifier: MIT
 *
 * NIST RS274/NGC version 3, table 8, gives the order, and table 4 the groups of words of which a
 * line may hold one.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/tool.h"       /* tool_error, tool_grow */
#include "gcode/gcode_state.h"

#define INCH 25.4

enum group {
    NONMODAL,
    MOTION,
    PLANE,
    DISTANCE,
    CENTRE,
    FEED_MODE,
    UNITS,
    RADIUS,
    LENGTH,
    RETRACT,
    SYSTEM,
    PATH,
    SPINDLE,
    LATHE,
    GROUPS,
    UNKNOWN
};

static const short codes[GROUPS][24] = {
    [NONMODAL]  = { 40, 100, 280, 281, 300, 301, 520, 530, 920, 921, 922, 923 },
    [MOTION] = { 0,   10,  20,  30,  50,  51,  52,  53,  730, 740,
                 800, 810, 820, 830, 840, 850, 860, 870, 880, 890 },
    [PLANE]     = { 170, 180, 190 },
    [DISTANCE]  = { 900, 910 },
    [CENTRE]    = { 901, 911 },
    [FEED_MODE] = { 930, 940, 950 },
    [UNITS]     = { 200, 210 },
    [RADIUS]    = { 400, 410, 411, 420, 421 },
    [LENGTH]    = { 430, 431, 432, 490 },
    [RETRACT]   = { 980, 990 },
    [SYSTEM]    = { 540, 550, 560, 570, 580, 590, 591, 592, 593 },
    [PATH]      = { 610, 611, 640 },
    [SPINDLE]   = { 960, 970 },
    [LATHE]     = { 70, 80 },
};

static enum group group_of(int code)
{
    if (code == 0)
        return MOTION;
    for (int into = 0; into < GROUPS; into++)
        for (int i = 0; i < 24; i++)
            if (codes[into][i] == code)
                return (enum group)into;
    return UNKNOWN;
}

static int wrong_code(const gcode_program *g, char letter, int code, const char *name,
                      const char *what, const char *remedy)
{
    char words[96];

    snprintf(words, sizeof words, "%c%g: %s", letter, code / 10.0, what);
    return gcode_fails(g, name, words, remedy);
}


// Codes
// -----

/* The others mean something else to Marlin, or nothing: G42 goes to a point of the mesh, G61 back
 * to a place that G60 saved. */
static bool printer_knows(enum group into)
{
    return into == NONMODAL || into == MOTION || into == PLANE || into == DISTANCE ||
           into == UNITS || into == SYSTEM;
}

/* The G words of the line by their groups. */
static int sort_codes(gcode_program *g, int of[GROUPS])
{
    for (int i = 0; i < GROUPS; i++)
        of[i] = GCODE_NONE;
    for (unsigned i = 0; i < g->b.gs; i++) {
        const int code        = g->b.g[i];
        const enum group into = group_of(code);
        if (g->printer && !printer_knows(into)) {
            gcode_leave_out(g, 'G', code);
            continue;
        }
        if (code / 10 == 38)
            return wrong_code(g, 'G', code, "gcode.probe",
                              "a file cannot probe: what follows would depend on it",
                              "probe before, with `loft probe z- --at 0`, and leave G38 out");
        if (into == UNKNOWN)
            return wrong_code(g, 'G', code, "gcode.g-unknown", "is not known here",
                              "write it out in plain motions, in the CAM's post-processor");
        if (into == MOTION && of[into] == GCODE_CANCEL)
            of[into] = GCODE_NONE;      /* G80 G81: the new motion counts */
        if (into == MOTION && of[into] != GCODE_NONE && code == GCODE_CANCEL)
            continue;
        if (of[into] != GCODE_NONE)
            return wrong_code(g, 'G', code, "gcode.group-twice",
                              "a second word of its kind in the line", "split the line");
        of[into] = code;
    }
    return 0;
}

static bool is_polar(const gcode_block *b)
{
    return (b->has & (GCODE_BIT(GCODE_RADIUS) | GCODE_BIT(GCODE_ANGLE))) != 0;
}

static bool has_axes(const gcode_block *b)
{
    return (b->has & (GCODE_BIT('X') | GCODE_BIT('Y') | GCODE_BIT('Z'))) != 0 || is_polar(b);
}

/* M67 and M68 set the output E: they are left out and reported. */
static bool has_output(const gcode_block *b)
{
    for (unsigned i = 0; i < b->ms; i++)
        if (b->m[i] == 670 || b->m[i] == 680)
            return true;
    return false;
}

static int check_words(const gcode_program *g)
{
    static const char others[] = "ABCUVW";
    char what[64];

    if (gcode_has(&g->b, 'E') && !g->printer && !has_output(&g->b))
        return gcode_fails(g, "gcode.extruder", "E: an extruder",
                           "for a 3-D printer's file give --dialect marlin");
    for (const char *at = others; *at != '\0' && !g->printer; at++)
        if (gcode_has(&g->b, *at)) {
            snprintf(what, sizeof what, "%c: this machine has the axes X, Y and Z", *at);
            return gcode_fails(g, "gcode.axis-unknown", what,
                               "take a post-processor for three axes");
        }
    return 0;
}

static int set_feed(gcode_program *g, int mode)
{
    if (mode != GCODE_NONE && mode != g->feed_mode) {
        g->feed_mode = mode;
        g->feed      = 0;
        g->fed       = false;
    }
    if (gcode_has(&g->b, 'F')) {
        const double said = gcode_value(&g->b, 'F');
        if (!(said >= 0) && !g->printer)
            return gcode_fails(g, "gcode.feed-negative", "F below 0", "give a feed above 0");
        if (said > 0 || !g->printer) {          /* a printer goes on with the feed before */
            g->feed = said;
            g->fed  = true;
        }
    }
    if (gcode_has(&g->b, 'S')) {
        if (!(gcode_value(&g->b, 'S') >= 0))
            return gcode_fails(g, "gcode.speed-negative", "S below 0", "give a speed of 0 or more");
        g->speed = gcode_value(&g->b, 'S');
        g->timed = true;
    }
    return 0;
}

/* M words of which a line may hold one, as rs274 groups them; 0: any number of them. */
static int group_of_m(int m)
{
    static const short first[][3] = { { 0, 2, 1 },   { 30, 30, 1 }, { 60, 60, 1 }, { 99, 99, 1 },
                                      { 3, 5, 2 },   { 19, 19, 2 }, { 70, 73, 2 }, { 6, 6, 3 },
                                      { 61, 61, 3 }, { 7, 9, 4 },   { 48, 53, 5 }, { 62, 68, 6 },
                                      { 98, 98, 7 }, { 100, 199, 8 } };

    for (size_t i = 0; i < sizeof first / sizeof first[0]; i++)
        if (m >= first[i][0] && m <= first[i][1])
            return first[i][2];
    return 0;
}

static int check_m_words(const gcode_program *g)
{
    unsigned seen = 0;

    for (unsigned i = 0; i < g->b.ms && !g->printer; i++) {
        const int group = group_of_m(g->b.m[i] / 10);
        if (group > 0 && (seen & 1u << group))
            return wrong_code(g, 'M', g->b.m[i], "gcode.group-twice",
                              "a second word of its kind in the line", "split the line");
        seen |= 1u << group;
    }
    return 0;
}

/* The numbers of a word that is left out are left out with it. */
static void leave_out_m(gcode_program *g, int code)
{
    static const struct {
        short first, last;
        const char *letters;
    } numbers[] = { { 19, 19, "PQR" }, { 50, 53, "P" },  { 62, 65, "P" },
                    { 66, 66, "PELQ" }, { 67, 68, "EQ" }, { 100, 199, "PQ" } };

    gcode_leave_out(g, 'M', code);
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++)
        if (code / 10 >= numbers[i].first && code / 10 <= numbers[i].last)
            for (const char *at = numbers[i].letters; *at != '\0'; at++)
                (void)gcode_value(&g->b, *at);
}

/* All letters of the line had a use. A printer's firmware does not look at those that it has none
 * for. */
static int check_used(const gcode_program *g)
{
    const uint32_t idle = g->b.has & ~g->used & ~GCODE_BIT('N');
    char what[64];

    for (char c = 'A'; c <= GCODE_ANGLE && !g->printer; c++)
        if (idle & GCODE_BIT(c)) {
            snprintf(what, sizeof what, "%c: no word of the line uses it", GCODE_SHOWN(c));
            return gcode_fails(g, "gcode.word-unused", what,
                               "leave it out, or give the word that it belongs to");
        }
    return 0;
}

/* Where this machine has no output of its own, such words are left out and reported. */
static int run_outputs(gcode_program *g)
{
    for (unsigned i = 0; i < g->b.ms; i++) {
        const int m = g->b.m[i] / 10;
        switch (m) {
        case 0:
        case 1:
        case 2:
        case 30:
        case 60:
        case 61:
        case 6:
        case 3:
        case 4:
        case 5:
        case 7:
        case 8:
        case 9:
        case 70:
        case 71:
        case 72: break;
        case 48:
        case 49:
        case 50:
        case 51:
        case 52:
        case 53:
        case 56:
        case 19:
        case 62:
        case 63:
        case 64:
        case 65:
        case 66:
        case 67:
        case 68:
        case 73: leave_out_m(g, g->b.m[i]); break;
        case 98: {
            const int code = g->printer ? 0 : gcode_flow_m98(g);
            if (code != 0)
                return code;
            break;
        }
        case 99: g->wants = GCODE_RETURNS; break;
        default:
            if (!g->printer && (m < 100 || m > 199))
                return wrong_code(
                    g, 'M', g->b.m[i], "gcode.m-unknown", "is not known here",
                    "leave it out, or for a 3-D printer's file give --dialect marlin");
            leave_out_m(g, g->b.m[i]);
        }
    }
    return 0;
}

/* M3 M4 M5, M7 M8 M9, and S while the spindle turns. */
static int run_spindle(gcode_program *g)
{
    gcode_event spindle = { .kind = GCODE_SPINDLE }, coolant = { .kind = GCODE_COOLANT };
    bool spins = gcode_has(&g->b, 'S') && g->spindle != 0, cools = false;
    int code   = 0;

    for (unsigned i = 0; i < g->b.ms; i++) {
        const int m = g->b.m[i] / 10;
        if (m >= 3 && m <= 5) {
            g->spindle = m == 5 ? 0 : m;
            spins      = true;
        } else if (m >= 7 && m <= 9) {
            g->coolant = m != 9;
            cools      = true;
        }
    }
    spindle.way   = g->spindle;
    spindle.speed = g->timed ? g->speed : NAN;
    coolant.way   = g->coolant;
    if (spins)
        code = gcode_give(g, &spindle, 0);
    return code == 0 && cools ? gcode_give(g, &coolant, 0) : code;
}

static int run_tools(gcode_program *g)
{
    int code = gcode_tool_select(g);

    for (unsigned i = 0; i < g->b.ms && code == 0; i++)
        if (g->b.m[i] == 60 || g->b.m[i] == 610)
            code = gcode_tool_change(g, g->b.m[i] / 10);
    return code;
}

/* Of a printer: S in seconds, P in their thousandths. */
static double wait_of(const gcode_program *g)
{
    const double p = gcode_value(&g->b, 'P'), s = gcode_value(&g->b, 'S');

    return gcode_has(&g->b, 'S') ? s : gcode_has(&g->b, 'P') ? p / 1000 : 0;
}

static int run_stops(gcode_program *g)
{
    int code = 0;

    for (unsigned i = 0; i < g->b.ms && code == 0; i++) {
        const int m = g->b.m[i] / 10;
        const double most = g->printer && m <= 1 ? wait_of(g) : 0;
        if (most > 0)
            code = gcode_wait(g, most);
        else if (m == 0 || m == 1 || m == 60)
            code = gcode_simple(g, GCODE_STOP);
        else if ((m == 2 || m == 30) && !g->printer)
            g->ended = true;
    }
    return code;
}

static int run_wait(gcode_program *g)
{
    const gcode_block *b = &g->b;

    if (!gcode_has(b, 'P') && !g->printer)
        return gcode_fails(g, "gcode.wait-no-time", "G4 without P",
                           "give the seconds to wait, as G4 P0.5");
    const double seconds = g->printer ? wait_of(g) : gcode_value(b, 'P');
    if (seconds < 0)
        return gcode_fails(g, "gcode.wait-negative", "G4 waits less than nothing",
                           "give a time of 0 or more");
    return gcode_wait(g, seconds);
}

/* G61 and G61.1 stop at corners; G64 P leaves the path by as much as P. */
static int use_path(gcode_program *g, int code)
{
    const double p = code == 640 && gcode_has(&g->b, 'P') ? gcode_value(&g->b, 'P') : 0;

    if (!(p >= 0))
        return gcode_fails(g, "gcode.blend-negative", "G64 with P below 0",
                           "give the tolerance in units of the program");
    if (code == 640)
        (void)gcode_value(&g->b, 'Q');  /* how short lines are joined: a plan keeps P for all */
    g->exact  = code != 640;
    g->within = p * g->frame.unit;
    return 0;
}

static int set_modes(gcode_program *g, const int of[GROUPS])
{
    int code = 0;

    if (of[PLANE] != GCODE_NONE)
        g->plane = of[PLANE] == 170 ? 2 : of[PLANE] == 180 ? 1 : 0;
    if (of[UNITS] != GCODE_NONE)
        code = gcode_use_units(g, of[UNITS] == 200 ? INCH : 1);
    if (code == 0 && of[RADIUS] != GCODE_NONE)
        code = of[RADIUS] == 400 ? gcode_radius_off(g) : gcode_tool_side(g, of[RADIUS]);
    if (code == 0 && of[LENGTH] != GCODE_NONE)
        code = gcode_use_tool(g, of[LENGTH]);
    if (code == 0 && of[PATH] != GCODE_NONE)
        code = use_path(g, of[PATH]);
    if (code == 0 && of[SYSTEM] != GCODE_NONE)
        code = gcode_use_system(g,
                                of[SYSTEM] < 591 ? (of[SYSTEM] - 530) / 10 : 6 + of[SYSTEM] - 590);
    if (code == 0 && of[LATHE] == 70)
        code = wrong_code(g, 'G', 70, "gcode.lathe-diameter", "lathe diameters are not supported",
                          "give radii (G8)");
    if (of[SPINDLE] == 960) {           /* the speed is that of the cut, of a lathe */
        gcode_leave_out(g, 'G', 960);
        (void)gcode_value(&g->b, 'D');
    }
    if (of[DISTANCE] != GCODE_NONE)
        g->incremental = of[DISTANCE] == 910;
    if (of[CENTRE] != GCODE_NONE)
        g->centre_absolute = of[CENTRE] == 901;
    if (of[RETRACT] != GCODE_NONE)
        g->retract_to_r = of[RETRACT] == 990;
    return code;
}

/* @ and ^ are polar coordinates around the origin of the program, and stand for X and Y. */
static int check_polar(const gcode_program *g, int once)
{
    if (gcode_has(&g->b, 'X') || gcode_has(&g->b, 'Y'))
        return gcode_fails(g, "gcode.polar-and-axes", "@ or ^ with X or Y",
                           "give one or the other");
    if (g->plane != 2)
        return gcode_fails(g, "gcode.polar-plane", "@ and ^ outside of the plane of x and y",
                           "give G17 before");
    if (once != GCODE_NONE && once != 40)
        return wrong_code(g, 'G', once, "gcode.polar-code", "with @ or ^", "give X and Y");
    if (!gcode_has(&g->b, GCODE_ANGLE) && !(hypot(g->at[0], g->at[1]) > 0))
        return gcode_fails(g, "gcode.polar-no-angle", "@ without ^ where the angle is not known",
                           "give ^, the angle");
    return 0;
}

/* G28, G92 and the like take the axis words for themselves. */
static int run_motion(gcode_program *g, const int of[GROUPS])
{
    const int once  = of[NONMODAL];
    const bool axes = has_axes(&g->b);
    int code        = is_polar(&g->b) ? check_polar(g, once) : 0;

    if (code != 0)
        return code;
    if (once != GCODE_NONE && once != 40 && once != 530 && (code = gcode_nonmodal(g, once)) != 0)
        return code;
    const bool taken = once == 100 || once == 280 || once == 300 || once == 520 || once == 920;
    if (of[MOTION] != GCODE_NONE && taken && axes && of[MOTION] != 800)
        return wrong_code(g, 'G', once, "gcode.axes-taken", "takes the axes that the motion wants",
                          "split the line");
    if (of[MOTION] != GCODE_NONE)
        g->motion = of[MOTION];
    if (once == 530 && g->motion != 0 && g->motion != 10)
        return wrong_code(g, 'G', 530, "gcode.machine-place-motion", "is for straight motions",
                          "give G0 or G1 with it");
    if (taken || (!axes && of[MOTION] == GCODE_NONE && g->poles == 0))
        return 0;
    return gcode_move(g);
}

/* What a path beside another one cannot go over to. */
static int check_radius(const gcode_program *g, const int of[GROUPS])
{
    static const enum group fixed[] = { PLANE, UNITS, LENGTH, SYSTEM };
    const int once = of[NONMODAL];

    if (g->radius.side == 0)
        return 0;
    for (size_t i = 0; i < sizeof fixed / sizeof fixed[0]; i++) {
        const int code  = of[fixed[i]];
        const bool same = (fixed[i] == PLANE && code == 190 - 10 * g->plane) ||
                          (fixed[i] == UNITS && (code == 210) == (g->frame.unit < 2));
        if (code != GCODE_NONE && !same)
            return wrong_code(g, 'G', code, "gcode.compensation-code", "in G41 or G42",
                              "give G40 before");
    }
    if (once != GCODE_NONE && once != 40)
        return wrong_code(g, 'G', once, "gcode.compensation-code", "in G41 or G42",
                          "give G40 before");
    return 0;
}

static int run_block(gcode_program *g)
{
    int of[GROUPS], code = sort_codes(g, of);

    if (g->printer && gcode_has(&g->b, 'E'))
        gcode_leave_out(g, 'E', -1);
    if (code == 0)
        code = check_words(g);
    if (code == 0)
        code = check_m_words(g);
    if (code == 0)
        code = check_radius(g, of);
    if (code == 0)
        code = set_feed(g, of[FEED_MODE]);
    if (code == 0)
        code = run_tools(g);
    if (code == 0)
        code = run_outputs(g);
    if (code == 0)
        code = run_spindle(g);
    for (unsigned i = 0; i < g->b.ms && code == 0 && !g->printer; i++)
        code = gcode_modes_word(g, g->b.m[i] / 10);
    if (code == 0 && of[NONMODAL] == 40)
        code = run_wait(g);
    if (code == 0)
        code = set_modes(g, of);
    if (code == 0)
        code = run_motion(g, of);
    if (code == 0)
        code = check_used(g);
    return code == 0 ? run_stops(g) : code;
}


// Lines
// -----

gcode_program *gcode_open(host *h, const char *file, enum gcode_dialect d, gcode_sink *sink,
                          void *context)
{
    gcode_program *g = memory_grow(NULL, sizeof *g);

    memset(g, 0, sizeof *g);
    g->file    = file;
    g->dialect = d;
    g->printer = d == GCODE_MARLIN;
    g->sink    = sink;
    g->context = context;
    g->b = (gcode_block){
        .host = h, .file = file, .printer = g->printer, .at = &g->all, .used = &g->used, .of = g
    };
    g->frame.unit = 1;
    g->motion     = d == GCODE_LINUXCNC || d == GCODE_ANY ? GCODE_CANCEL : 0;
    g->plane      = 2;
    g->feed_mode  = 940;
    g->system     = 1;
    g->selected = g->loaded = -1;
    g->all.number[5220] = 1;
    g->loose = 7;
    gcode_use_offsets(g);
    return g;
}

void gcode_set_tools(gcode_program *g, const struct machine_tools *tools) { g->tools = tools; }

/* grbl's own commands, as $H, and FluidNC's, as $SD/Run; real-time characters. */
static bool is_command(const char *text, size_t length)
{
    while (length > 0 && (*text == ' ' || *text == '\t'))
        text++, length--;
    return length > 0 && (*text == '$' || *text == '?' || *text == '!' || *text == '~');
}

static int run_percent(gcode_program *g)
{
    g->percents++;
    g->ended = g->percents > 1 || g->begun;
    return 0;
}

int gcode_line(gcode_program *g, const char *text, size_t length)
{
    int code;

    if (is_command(text, length)) {
        gcode_leave_out(g, '$', 0);
        return 0;
    }
    g->used = 0;
    code = gcode_block_read(&g->b, text, length);
    if (code == 0 && g->b.unknown[0] != '\0')
        gcode_leave_name(g, g->b.unknown);
    if (code == 0 && g->b.percent)
        return g->b.file == g->file ? run_percent(g) : 0;
    if (code == 0 && g->b.say != NULL)
        code = gcode_simple(g, GCODE_SAY);
    g->begun = g->begun || g->b.has != 0 || g->b.gs + g->b.ms > 0;
    return code == 0 && (g->b.has & ~GCODE_BIT('N')) + g->b.gs + g->b.ms > 0 ? run_block(g) : code;
}

const option gcode_rows[] = {
    OPTION_HEADING("programs of G-code"),
    { "dialect", OPTION_CHOICE(gcode_choice, dialect), .value = "NAME",
      .choices = "any|linuxcnc|grbl|fluidnc|marlin",
      .remedy = "give linuxcnc, grbl, fluidnc or marlin", .standard = "any",
      .help = "of G-code: linuxcnc, grbl, fluidnc or marlin, for 3-D printers (found)" },
    { "from-line", OPTION_INTEGER(gcode_choice, from_line), .least = 1, .most = 4000000000u,
      .value = "N",
      .help = "of G-code: read all, but move from this line on; the way there is above all of the "
              "program" },
    { 0 }
};

bool gcode_ended(const gcode_program *g) { return g->ended; }

int gcode_finish(gcode_program *g)
{
    int code = g->flow != NULL ? gcode_flow_run(g) : 0;

    if (code == 0)
        code = gcode_radius_off(g);
    if (code != 0)
        return code;
    if (g->poles > 0)
        return host_error(g->b.host, EX_DATAERR, "gcode.nurbs-open",
                          (host_place){ g->file, g->pole_line }, "end the NURBS",
                          "G5.2 without G5.3");
    gcode_tell_left(g);
    return 0;
}

void gcode_bound(gcode_program *g, unsigned lines) { g->most_lines = lines; }

void gcode_close(gcode_program *g)
{
    gcode_flow_free(g);
    free(g);
}

/* A line ends with LF, CR LF or CR. */
const char *gcode_line_end(const char *text, const char *end)
{
    const char *stop = memchr(text, '\n', (size_t)(end - text));

    stop = stop ? stop : end;
    const char *back = memchr(text, '\r', (size_t)(stop - text));
    return back ? back : stop;
}

const char *gcode_next_line(const char *stop, const char *end)
{
    const bool two = stop + 1 < end && stop[0] == '\r' && stop[1] == '\n';

    return stop < end ? stop + 1 + two : end;
}

int gcode_lines(gcode_program *g, const char *text, size_t size)
{
    const char *end = text + size;
    int code        = 0;

    if (g->b.line == 0 && size >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0)
        text += 3;
    while (text < end && code == 0 && !g->ended && g->flow == NULL) {
        const char *stop = gcode_line_end(text, end);
        g->main_line     = ++g->b.line;
        if (gcode_flow_steers(g, text, (size_t)(stop - text))) {
            gcode_flow_open(g, g->b.line);
            break;
        }
        code = gcode_line(g, text, (size_t)(stop - text));
        text = gcode_next_line(stop, end);
        if (g->wants == GCODE_CALLS)
            gcode_flow_open(g, g->b.line + 1);
        g->ended = g->ended || g->wants == GCODE_RETURNS;
    }
    return code == 0 && g->flow != NULL ? gcode_flow_keep(g, text, (size_t)(end - text)) : code;
}

int gcode_read(gcode_program *g, const char *text, size_t size)
{
    const int code = gcode_lines(g, text, size);

    return code == 0 ? gcode_finish(g) : code;
}
