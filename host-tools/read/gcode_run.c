/* host-tools/read/gcode_run.c -- runs a line of G-code: its words in their order of execution
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
#include "read/gcode_state.h"

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

static enum group group_of(int code)
{
    switch (code) {
    case 40:
    case 100:
    case 280:
    case 300:
    case 520:
    case 530:
    case 920:
    case 921:
    case 922:
    case 923:                                           return NONMODAL;
    case 0:
    case 10:
    case 20:
    case 30:
    case 50:
    case 51:
    case 52:
    case 53:
    case 730:
    case 740:
    case 800:
    case 810:
    case 820:
    case 830:
    case 840:
    case 850:
    case 860:
    case 880:
    case 890: return MOTION;
    case 170:
    case 180:
    case 190: return PLANE;
    case 900:
    case 910: return DISTANCE;
    case 901:
    case 911: return CENTRE;
    case 930:
    case 940:
    case 950: return FEED_MODE;
    case 200:
    case 210: return UNITS;
    case 400:
    case 410:
    case 411:
    case 420:
    case 421: return RADIUS;
    case 430:
    case 431:
    case 432:
    case 490: return LENGTH;
    case 980:
    case 990: return RETRACT;
    case 540:
    case 550:
    case 560:
    case 570:
    case 580:
    case 590:
    case 591:
    case 592:
    case 593: return SYSTEM;
    case 610:
    case 611:
    case 640: return PATH;
    case 960:
    case 970: return SPINDLE;
    case 70:
    case 80: return LATHE;
    default:                                            return UNKNOWN;
    }
}

static int wrong_code(const gcode_program *g, char letter, int code, const char *what,
                      const char *remedy)
{
    char words[96];

    snprintf(words, sizeof words, "%c%g: %s", letter, code / 10.0, what);
    return gcode_fails(g, words, remedy);
}

/* A word that this machine has no use for: it is told once, at the end. */
static void leave_out(gcode_program *g, char letter, int code)
{
    for (unsigned i = 0; i < g->lefts; i++)
        if (g->left[i].letter == letter && g->left[i].code == code) {
            g->left[i].count++;
            return;
        }
    if (g->lefts < sizeof g->left / sizeof g->left[0]) {
        g->left[g->lefts].letter  = letter;
        g->left[g->lefts].code    = code;
        g->left[g->lefts].line    = g->b.line;
        g->left[g->lefts++].count = 1;
    }
}


// Events
// ------

void gcode_place(const gcode_frame *f, const double at[3], double out[3])
{
    const double x = at[0] + f->shift[0], y = at[1] + f->shift[1];
    const double c = cos(f->degrees * 3.14159265358979323846 / 180),
                 s = sin(f->degrees * 3.14159265358979323846 / 180);

    out[0] = (fabs(f->degrees) > 0 ? c * x - s * y : x) + f->origin[0];
    out[1] = (fabs(f->degrees) > 0 ? s * x + c * y : y) + f->origin[1];
    out[2] = at[2] + f->shift[2] + f->origin[2];
    for (int i = 0; i < 3; i++)
        out[i] *= f->unit;
}

/* The feed of a motion in mm/s; 0 if none is set. */
static double feed_of(const gcode_program *g, double length)
{
    switch (g->feed_mode) {
    case 930: return length * g->frame.unit * g->feed / 60;
    case 950: return g->feed * g->frame.unit * g->speed / 60;
    default:  return g->feed * g->frame.unit / 60;
    }
}

int gcode_give(gcode_program *g, gcode_event *e, double length)
{
    const bool moves = e->kind <= GCODE_NURBS;

    memcpy(e->from, g->at, sizeof e->from);
    e->line  = g->b.line;
    e->loose[0] = e->loose[1] = g->loose;
    if (moves)
        e->loose[1] = g->loose = g->homing ? g->homed : gcode_loose_there(g);
    e->frame = &g->frame;
    e->plane = g->plane;
    e->feed  = e->kind != GCODE_RAPID || g->printer ? feed_of(g, length) : 0;
    if (moves && e->kind != GCODE_RAPID && g->feed_mode == 930 && !gcode_has(&g->b, 'F'))
        return gcode_fails(g, "no F: in G93 each line has its time",
                           "give F with each motion, or G94");
    const int code = g->sink(g->context, e);
    if (moves)
        memcpy(g->at, e->to, sizeof g->at);
    return code;
}

int gcode_go(gcode_program *g, enum gcode_kind kind, const double to[3])
{
    gcode_event e = { .kind = kind };

    memcpy(e.to, to, sizeof e.to);
    return gcode_give(g, &e, hypot(hypot(to[0] - g->at[0], to[1] - g->at[1]), to[2] - g->at[2]));
}

int gcode_wait(gcode_program *g, double seconds)
{
    gcode_event e = { .kind = GCODE_WAIT, .seconds = seconds };

    return gcode_give(g, &e, 0);
}

static int give_simple(gcode_program *g, enum gcode_kind kind)
{
    gcode_event e = { .kind = kind, .text = g->b.say, .length = g->b.say_length };

    return gcode_give(g, &e, 0);
}


// Codes
// -----

/* The G words of the line by their groups. */
static int sort_codes(gcode_program *g, int of[GROUPS])
{
    for (int i = 0; i < GROUPS; i++)
        of[i] = GCODE_NONE;
    for (unsigned i = 0; i < g->b.gs; i++) {
        const int code        = g->b.g[i];
        const enum group into = group_of(code);
        if (into == UNKNOWN && g->printer) {
            leave_out(g, 'G', code);
            continue;
        }
        if (into == UNKNOWN)
            return wrong_code(g, 'G', code, "is not known here",
                              "write it out in plain motions, in the CAM's post-processor");
        if (into == MOTION && of[into] == GCODE_CANCEL)
            of[into] = GCODE_NONE;      /* G80 G81: the new motion counts */
        if (into == MOTION && of[into] != GCODE_NONE && code == GCODE_CANCEL)
            continue;
        if (of[into] != GCODE_NONE)
            return wrong_code(g, 'G', code, "a second word of its kind in the line",
                              "split the line");
        of[into] = code;
    }
    return 0;
}

static bool has_axes(const gcode_block *b)
{
    return (b->has & (GCODE_BIT('X') | GCODE_BIT('Y') | GCODE_BIT('Z'))) != 0;
}

static int check_words(const gcode_program *g)
{
    static const char others[] = "ABCUVW";
    char what[64];

    if (gcode_has(&g->b, 'E') && !g->printer)
        return gcode_fails(g, "E: an extruder", "for a 3-D printer's file give --dialect marlin");
    for (const char *at = others; *at != '\0' && !g->printer; at++)
        if (gcode_has(&g->b, *at)) {
            snprintf(what, sizeof what, "%c: this machine has the axes X, Y and Z", *at);
            return gcode_fails(g, what, "take a post-processor for three axes");
        }
    return 0;
}

static int set_feed(gcode_program *g, int mode)
{
    if (mode != GCODE_NONE && mode != g->feed_mode) {
        g->feed_mode = mode;
        g->feed      = 0;
    }
    if (gcode_has(&g->b, 'F')) {
        if (!(gcode_value(&g->b, 'F') >= 0))
            return gcode_fails(g, "F below 0", "give a feed above 0");
        g->feed = gcode_value(&g->b, 'F');
    }
    if (gcode_has(&g->b, 'S')) {
        if (!(gcode_value(&g->b, 'S') >= 0))
            return gcode_fails(g, "S below 0", "give a speed of 0 or more");
        g->speed = gcode_value(&g->b, 'S');
    }
    return 0;
}

/* Where this machine has no output of its own, such words are left out, and told. */
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
        case 6: break;
        case 3:
        case 4:
        case 5:
        case 7:
        case 8:
        case 9:
        case 48:
        case 49:
        case 50:
        case 51:
        case 52:
        case 53:
        case 19:
        case 61:
        case 62:
        case 63:
        case 64:
        case 65:
        case 66:
        case 67:
        case 68:
        case 70:
        case 71:
        case 72:
        case 73: leave_out(g, 'M', g->b.m[i]); break;
        case 98:
        case 99:
            return wrong_code(g, 'M', g->b.m[i], "subroutines are not run",
                              "write the program out in the CAM's post-processor");
        default:
            if (!g->printer && (m < 100 || m > 199))
                return wrong_code(
                    g, 'M', g->b.m[i], "is not known here",
                    "leave it out, or for a 3-D printer's file give --dialect marlin");
            leave_out(g, 'M', g->b.m[i]);
        }
    }
    return 0;
}

static int run_tool_change(gcode_program *g)
{
    for (unsigned i = 0; i < g->b.ms; i++)
        if (g->b.m[i] == 60)
            return give_simple(g, GCODE_STOP);
    return 0;
}

static int run_stops(gcode_program *g)
{
    int code = 0;

    for (unsigned i = 0; i < g->b.ms && code == 0; i++) {
        const int m = g->b.m[i] / 10;
        if (m == 0 || m == 1 || m == 60)
            code = give_simple(g, GCODE_STOP);
        else if ((m == 2 || m == 30) && !g->printer)
            g->ended = true;
    }
    return code;
}

static int run_wait(gcode_program *g)
{
    const gcode_block *b = &g->b;

    if (g->printer)
        return gcode_wait(g, gcode_has(b, 'S')   ? gcode_value(b, 'S')
                             : gcode_has(b, 'P') ? gcode_value(b, 'P') / 1000
                                                 : 0);
    if (!gcode_has(b, 'P') || gcode_value(b, 'P') < 0)
        return gcode_fails(g, "G4 without P", "give the seconds to wait, as G4 P0.5");
    return gcode_wait(g, gcode_value(b, 'P'));
}

static int set_modes(gcode_program *g, const int of[GROUPS])
{
    int code = 0;

    if (of[PLANE] != GCODE_NONE)
        g->plane = of[PLANE] == 170 ? 2 : of[PLANE] == 180 ? 1 : 0;
    if (of[UNITS] != GCODE_NONE)
        code = gcode_use_units(g, of[UNITS] == 200 ? INCH : 1);
    if (code == 0 && of[RADIUS] != GCODE_NONE && of[RADIUS] != 400)
        code = wrong_code(g, 'G', of[RADIUS], "the radius of the tool is not known here",
                          "let the CAM compute the path of the tool's centre");
    if (code == 0 && of[LENGTH] != GCODE_NONE)
        code = gcode_use_tool(g, of[LENGTH]);
    if (of[PATH] == 640 && gcode_has(&g->b, 'P'))
        leave_out(g, 'G', 640);
    if (code == 0 && of[SYSTEM] != GCODE_NONE)
        code = gcode_use_system(g,
                                of[SYSTEM] < 591 ? (of[SYSTEM] - 530) / 10 : 6 + of[SYSTEM] - 590);
    if (code == 0 && of[LATHE] == 70)
        code = wrong_code(g, 'G', 70, "diameters of a lathe are not known here", "give radii (G8)");
    if (of[DISTANCE] != GCODE_NONE)
        g->incremental = of[DISTANCE] == 910;
    if (of[CENTRE] != GCODE_NONE)
        g->centre_absolute = of[CENTRE] == 901;
    if (of[RETRACT] != GCODE_NONE)
        g->retract_to_r = of[RETRACT] == 990;
    return code;
}

/* G28, G92 and the like take the axis words for themselves. */
static int run_motion(gcode_program *g, const int of[GROUPS])
{
    const int once  = of[NONMODAL];
    const bool axes = has_axes(&g->b);
    int code        = 0;

    if (once != GCODE_NONE && once != 40 && once != 530 && (code = gcode_nonmodal(g, once)) != 0)
        return code;
    const bool taken = once == 100 || once == 280 || once == 300 || once == 520 || once == 920;
    if (of[MOTION] != GCODE_NONE && taken && axes && of[MOTION] != 800)
        return wrong_code(g, 'G', once, "takes the axes that the motion wants", "split the line");
    if (of[MOTION] != GCODE_NONE)
        g->motion = of[MOTION];
    if (once == 530 && g->motion != 0 && g->motion != 10)
        return wrong_code(g, 'G', 530, "is for straight motions", "give G0 or G1 with it");
    if (taken || (!axes && of[MOTION] == GCODE_NONE && g->poles == 0))
        return 0;
    return gcode_move(g);
}

static int run_block(gcode_program *g)
{
    int of[GROUPS], code = sort_codes(g, of);

    if (g->printer && gcode_has(&g->b, 'E'))
        leave_out(g, 'E', -1);
    if (code == 0)
        code = check_words(g);
    if (code == 0)
        code = set_feed(g, of[FEED_MODE]);
    if (code == 0)
        code = run_tool_change(g);
    if (code == 0)
        code = run_outputs(g);
    if (code == 0 && of[NONMODAL] == 40)
        code = run_wait(g);
    if (code == 0)
        code = set_modes(g, of);
    if (code == 0)
        code = run_motion(g, of);
    return code == 0 ? run_stops(g) : code;
}


// Lines
// -----

gcode_program *gcode_open(const char *file, enum gcode_dialect d, gcode_sink *sink, void *context)
{
    gcode_program *g = tool_grow(NULL, sizeof *g);

    memset(g, 0, sizeof *g);
    g->file    = file;
    g->dialect = d;
    g->printer = d == GCODE_MARLIN;
    g->sink    = sink;
    g->context = context;
    g->b = (gcode_block){ .file = file, .printer = g->printer, .at = &g->all };
    g->frame.unit = 1;
    g->motion     = d == GCODE_LINUXCNC || d == GCODE_ANY ? GCODE_CANCEL : 0;
    g->plane      = 2;
    g->feed_mode  = 940;
    g->system     = 1;
    g->all.number[5220] = 1;
    g->loose = 7;
    gcode_use_offsets(g);
    return g;
}

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

    g->b.line++;
    if (g->ended)
        return 0;
    if (is_command(text, length)) {
        leave_out(g, '$', 0);
        return 0;
    }
    code = gcode_block_read(&g->b, text, length);
    if (code == 0 && g->b.percent)
        return run_percent(g);
    if (code == 0 && g->b.say != NULL)
        code = give_simple(g, GCODE_SAY);
    g->begun = g->begun || g->b.has != 0 || g->b.gs + g->b.ms > 0;
    return code == 0 && (g->b.has & ~GCODE_BIT('N')) + g->b.gs + g->b.ms > 0 ? run_block(g) : code;
}

bool gcode_parse_dialect(const char *text, void *out)
{
    static const char *const names[] = { "linuxcnc", "grbl", "fluidnc", "marlin" };
    int *dialect = out;

    for (int i = 0; i < 4; i++)
        if (strcmp(text, names[i]) == 0) {
            *dialect = GCODE_LINUXCNC + i;
            return true;
        }
    (void)tool_error(EX_USAGE, "--dialect %s: give linuxcnc, grbl, fluidnc or marlin", text);
    return false;
}

bool gcode_ended(const gcode_program *g) { return g->ended; }

static const char *reason_of(char letter, int code)
{
    const int m = code / 10;

    if (letter == 'E')
        return "there is no extruder: its words are left out";
    if (letter == 'G' && code == 640)
        return "the path stays within --tol everywhere: give the tolerance there";
    if (letter == '$')
        return "commands of a controller are left out: give them to it yourself";
    if (letter == 'M' && m >= 3 && m <= 5)
        return "no spindle or laser follows it yet: switch it by hand";
    if (letter == 'M' && m >= 7 && m <= 9)
        return "there is no coolant: it is left out";
    return "has no meaning for this machine: it is left out";
}

int gcode_finish(gcode_program *g)
{
    if (g->poles > 0)
        return tool_error(EX_DATAERR, "%s:%u: G5.2 without G5.3: end the NURBS", g->file,
                          g->pole_line);
    for (unsigned i = 0; i < g->lefts; i++) {
        char word[16] = "", times[32] = "";
        if (g->left[i].letter == '$' || g->left[i].letter == 'E')
            snprintf(word, sizeof word, "%c", g->left[i].letter);
        else
            snprintf(word, sizeof word, "%c%g", g->left[i].letter, g->left[i].code / 10.0);
        if (g->left[i].count > 1)
            snprintf(times, sizeof times, " (%u times)", g->left[i].count);
        (void)tool_error(EX_OK, "%s:%u: %s%s: %s", g->file, g->left[i].line, word, times,
                         reason_of(g->left[i].letter, g->left[i].code));
    }
    g->lefts = 0;
    return 0;
}

void gcode_close(gcode_program *g) { free(g); }

int gcode_read(gcode_program *g, const char *text, size_t size)
{
    const char *end = text + size;
    int code        = 0;

    if (size >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0)
        text += 3;
    while (text < end && code == 0 && !g->ended) {
        const char *stop = memchr(text, '\n', (size_t)(end - text));
        stop = stop ? stop : end;
        code = gcode_line(g, text, (size_t)(stop - text));
        text = stop + 1;
    }
    return code == 0 ? gcode_finish(g) : code;
}
