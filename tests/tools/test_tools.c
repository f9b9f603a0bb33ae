/* tests/tools/test_tools.c -- colours and layers have tools; a drawing is sorted by them
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <string.h>

#include "arrange/tools.h"
#include "plan/toolpath.h"
#include "tools/drawn.h"
#include "svg/svg_file.h"
#include "gcode/gcode.h"
#include "gcode/gcode_draw.h"

double tool_clock(void) { return 0; }

#define LAYER(name, inner)                                                                         \
    "<g xmlns:i='http://www.inkscape.org/namespaces/inkscape' i:groupmode='layer' i:label='" name  \
    "'>" inner "</g>"
#define STROKE(x, colour) "<path d='M" #x " 0V10' stroke='" colour "'/>"

/* Read lines of a machine file up to the first that is refused. */
static int read_lines(machine_tools *t, const char *const lines[])
{
    int code = 0;

    hear();
    *t           = (machine_tools){ .count = 0 };
    for (unsigned i = 0; lines[i] != NULL && code == 0; i++)
        code = machine_tools_line(&heard, t, "m", i + 1, lines[i]);
    return code;
}

static void the_lines_are_read(arb *a)
{
    const char *const lines[] = { "tool.1.colours = red, #00f ,lime  # three",
                                  "tool.1.feed=12.5 # mm/s",
                                  "tool.wide.layers = 2, My Ink",
                                  "tool.wide.pause = the wide pen, please",
                                  "tool.wide.pen_up = 4\r\n",
                                  "tool.wide.pen_down = -1",
                                  "tool.1.diameter = 6",
                                  NULL };
    machine_tools t;

    (void)a;
    CHECK(read_lines(&t, lines) == 0 && t.count == 2);
    CHECK(strcmp(t.tool[0].colours, "red,#00f,lime") == 0);
    CHECK(t.tool[0].feed > 12.4 && t.tool[0].feed < 12.6 && isnan(t.tool[0].pen_up));
    CHECK(t.tool[0].diameter > 5.9 && t.tool[0].diameter < 6.1);
    CHECK(strcmp(t.tool[1].layers, "2,My Ink") == 0);
    CHECK(strcmp(t.tool[1].pause, "the wide pen, please") == 0);
    CHECK(fabs(tools_lift(&t.tool[1], 1) - 5) < 1e-12 &&
          fabs(tools_lift(&t.tool[0], 1) - 1) < 1e-12);
    CHECK(fabs(tools_most_lift(&t, 1) - 5) < 1e-12);
    CHECK(machine_tools_find(&t, "wide") == &t.tool[1] && machine_tools_find(&t, "w") == NULL);
}

static void bad_lines_are_refused(arb *a)
{
    static const struct {
        const char *line, *words;
    } bad[] = { { "tool.a.colour = red", "write tool.NAME.KEY" },
                { "tool.feed = 3", "write tool.NAME.KEY" },
                { "tool.a.feed 3", "write tool.NAME.KEY" },
                { "tool..feed = 3", "1 to 23 letters" },
                { "tool.abcdefghijklmnopqrstuvwxyz.feed = 3", "1 to 23 letters" },
                { "tool.a.feed = 0", "feed: give a number from" },
                { "tool.a.feed = 3 4", "not a number" },
                { "tool.a.feed = nan", "give a number" },
                { "tool.a.pause = ", "is empty" },
                { "tool.a.pause = # no more", "is empty" } };
    machine_tools t;

    (void)a;
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        const char *const lines[] = { bad[i].line, NULL };
        CHECK(read_lines(&t, lines) == EX_DATAERR && caught_lines == 1);
        CHECK(strstr(caught, bad[i].words) != NULL && strncmp(caught, "m:1: ", 5) == 0);
    }
    const char *const twice[] = { "tool.a.feed = 3", "tool.a.feed = 4", NULL }, *const again[] = {
        "tool.a.layers = 3", "tool.a.layers = 4", NULL
    };
    CHECK(read_lines(&t, twice) == EX_DATAERR && strstr(caught, "m:2: feed of tool a"));
    CHECK(read_lines(&t, again) == EX_DATAERR && strstr(caught, "m:2: layers of tool a"));
    t = (machine_tools){ .count = 0 };
    for (unsigned i = 0; i <= MACHINE_TOOLS; i++) {
        char line[40];
        snprintf(line, sizeof line, "tool.t%u.delay = 1", i);
        CHECK((machine_tools_line(&heard, &t, "m", 1, line) == 0) == (i < MACHINE_TOOLS));
    }
}

/* Read an SVG with tools, and sort it. */
static int sorted(const machine_tools *t, const char *text, drawing *d)
{
    caught[0] = '\0';
    *d        = (drawing){ .tools = t };
    const int code = drawing_read_svg(&heard, d, "test.svg", text, strlen(text));
    return code ? code : tools_apply(&heard, t, d, "test.svg");
}

static void drawings_are_sorted(arb *a)
{
    const char *const lines[] = { "tool.blue.colours = #00f",    "tool.blue.feed = 7",
                                  "tool.ink.layers = 2,frame",   "tool.ink.pen_down = -1",
                                  "tool.rest.pause = any other", NULL };
    char got[2000];
    machine_tools t;
    drawing d;
    tools_part part[TOOLS_PARTS];

    (void)a;
    CHECK(read_lines(&t, lines) == 0);
    CHECK(sorted(&t,
                 PAGE(STROKE(1, "red") STROKE(2, "blue")
                          LAYER("2 inks", STROKE(3, "blue") LAYER("frame", STROKE(4, "red")) LAYER(
                                              "other", STROKE(5, "red"))) STROKE(6, "rgb(0,0,255)")
                              STROKE(7, "none") "<rect x='8' width='1' "
                                                "height='1' fill='blue'/>"),
                 &d) == 0);
    put_drawing(got, sizeof got, &d, 100);
    CHECK(strcmp(got, "M 2 0 L 2 10 M 6 0 L 6 10 M 8 0 L 9 0 L 9 1 L 8 1 L 8 0 M 3 0 L 3 10"
                      " M 4 0 L 4 10 M 5 0 L 5 10 M 1 0 L 1 10 M 7 0 L 7 10") == 0);
    CHECK(tools_split(&t, &d, &d, part) == 3);
    CHECK(part[0].d.count == 6 && part[1].d.count == 3 && part[2].smooth.count == 2);
    CHECK(part[1].tool == &t.tool[1] && part[1].d.curve == d.curve + 6);
    for (size_t i = 0; i < d.count; i++) {
        const drawing_curve *c = &d.curve[i];
        CHECK(c->feed > 6.9 ? i < 6 && c->feed < 7.1 : i >= 6 && !(c->feed > 0));
        CHECK(c->z[0] < -0.9 ? i >= 6 && i < 9 && c->z[3] < -0.9 : i < 6 || i >= 9);
    }
    drawing_free(&d);
}

static void the_order_stays_within_a_tool(arb *a)
{
    const char *const lines[] = { "tool.a.colours = red", "tool.b.colours = blue", NULL };
    const order_options best  = { .how = "best", .effort = 0.01, .join = 0.005 };
    const double zero[2]      = { 0, 100 };
    char got[2000];
    machine_tools t;
    drawing d;

    (void)a;
    CHECK(read_lines(&t, lines) == 0);
    CHECK(sorted(&t,
                 PAGE(STROKE(9, "red") STROKE(2, "blue") STROKE(1, "red") STROKE(8, "blue")
                          STROKE(1, "blue")),
                 &d) == 0);
    CHECK(tools_order(&heard, &best, &d, zero, false, "test.svg") == 0);
    put_drawing(got, sizeof got, &d, 100);
    CHECK(strcmp(got, "M 1 0 L 1 10 M 9 10 L 9 0 M 8 0 L 8 10 M 2 10 L 2 0 M 1 0 L 1 10") == 0);
    drawing_free(&d);
}

/* Copies bring the layers twice; a layer goes on behind the one in it. */
static void the_order_stays_within_a_layer(arb *a)
{
    static const char text[] = PAGE(
        LAYER("1", STROKE(9, "red") LAYER("2", STROKE(3, "red")) STROKE(1, "red")) STROKE(7, "red")
            LAYER("3", STROKE(2, "red") STROKE(5, "blue")));
    const order_options layer = { .how = "layer", .effort = 0.01, .join = 0.005 };
    const char *const none[] = { NULL }, *const lines[] = { "tool.a.colours = red",
                                                            "tool.b.colours = blue", NULL };
    const double zero[2] = { 0, 100 };
    char got[2000];
    machine_tools t;
    drawing d;

    (void)a;
    CHECK(read_lines(&t, none) == 0 && sorted(&t, text, &d) == 0);
    for (size_t i = 0, count = d.count; i < count; i++) {
        drawing_add_like(&d, &d.curve[i], true);
        for (int k = 0; k < 4; k++)
            d.curve[d.count - 1].p[k][1] += 20;
    }
    CHECK(tools_order(&heard, &layer, &d, zero, false, "test.svg") == 0 && caught[0] == '\0');
    put_drawing(got, sizeof got, &d, 100);
    CHECK(strcmp(got, "M 7 10 L 7 0 M 7 -10 L 7 -20 M 9 -20 L 9 -10 M 9 0 L 9 10 M 1 10 L 1 0"
                      " M 1 -10 L 1 -20 M 3 -20 L 3 -10 M 3 0 L 3 10 M 2 10 L 2 0 M 2 -10 L 2 -20"
                      " M 5 -20 L 5 -10 M 5 0 L 5 10") == 0);
    drawing_free(&d);

    CHECK(read_lines(&t, lines) == 0 && sorted(&t, text, &d) == 0);
    CHECK(tools_order(&heard, &layer, &d, zero, false, "test.svg") == 0);
    put_drawing(got, sizeof got, &d, 100);
    CHECK(strcmp(got, "M 7 0 L 7 10 M 9 10 L 9 0 M 1 0 L 1 10 M 3 10 L 3 0 M 2 0 L 2 10"
                      " M 5 10 L 5 0") == 0);
    CHECK(d.curve[5].tool == 2 && d.curve[4].tool == 1);
    drawing_free(&d);

    CHECK(sorted(&t, PAGE(STROKE(9, "red") STROKE(1, "red")), &d) == 0);
    CHECK(tools_order(&heard, &layer, &d, zero, false, "test.svg") == 0);
    CHECK(strstr(caught, "test.svg: it has no layers of Inkscape") != NULL);
    drawing_free(&d);
}

/* A line over a gap belongs to the tool, the layer and the heights of its path. */
static void a_gap_is_drawn_by_the_tool(arb *a)
{
    const char *const lines[] = { "tool.a.colours = red", "tool.a.feed = 9", "tool.a.pen_down = -1",
                                  NULL };
    const order_options best  = { .how = "best", .effort = 0.01, .join = 0.5 };
    const double zero[2]      = { 0, 100 };
    tools_part part[TOOLS_PARTS];
    machine_tools t;
    drawing d;

    (void)a;
    CHECK(read_lines(&t, lines) == 0);
    CHECK(sorted(&t, PAGE(LAYER("1", "<path d='M1 0V5M1 5.25V10' stroke='red'/>")), &d) == 0);
    CHECK(tools_order(&heard, &best, &d, zero, false, "test.svg") == 0 && d.count == 3);
    CHECK(tools_split(&t, &d, &d, part) == 1);
    for (size_t i = 0; i < d.count; i++) {
        CHECK(d.curve[i].tool == 1 && d.curve[i].layer == 1 && d.curve[i].path == 0);
        CHECK(d.curve[i].feed > 8.9 && d.curve[i].z[1] < -0.9);
    }
    drawing_free(&d);
}

static void without_tools_nothing_changes(arb *a)
{
    const machine_tools none = { .count = 0 };
    tools_part part[TOOLS_PARTS];
    drawing d;

    (void)a;
    CHECK(sorted(&none, PAGE(STROKE(9, "red") STROKE(2, "blue")), &d) == 0);
    CHECK(tools_split(&none, &d, &d, part) == 1 && part[0].tool == NULL && part[0].d.count == 2);
    CHECK(d.curve[0].p[0][0] > 8);
    drawing_free(&d);
}

static void a_pen_cannot_be_lifted_downwards(arb *a)
{
    const char *const lines[] = { "tool.a.pen_up = -2", "tool.a.pen_down = -1", NULL };
    machine_tools t;
    drawing d;

    (void)a;
    CHECK(read_lines(&t, lines) == 0);
    CHECK(sorted(&t, PAGE(STROKE(9, "red")), &d) == EX_DATAERR);
    CHECK(strstr(caught, "pen_up is -2 mm, below pen_down of -1 mm") != NULL);
    drawing_free(&d);
}

/* A program makes a job of what each tool does; an axis that it has not named goes on. */
static void a_program_changes_tools(arb *a)
{
    static const char text[] = "G91 G1 X1 F60\nT2 M6\nX2\nT9 M6\nX3\nX1\nT2 M6\nX4\n";
    const char *const lines[] = { "tool.2.diameter = 3", "tool.9.length = 5", NULL };
    static const double counted[] = { 0, 1, 3, 7 };
    machine_tools t;
    drawing d = { .tools = &t };
    tools_part part[TOOLS_PARTS];

    (void)a;
    CHECK(read_lines(&t, lines) == 0 && t.tool[1].length > 4);
    CHECK(drawing_read_gcode(&heard, &d, "part.nc", text, strlen(text)) == 0);
    CHECK(tools_apply(&heard, &t, &d, "part.nc") == 0 && d.count == 5);
    CHECK(tools_split(&t, &d, &d, part) == 4);
    CHECK(part[0].tool == NULL && part[1].tool == &t.tool[0] && part[2].tool == &t.tool[1] &&
          part[3].tool == &t.tool[0] && part[2].d.count == 2 && part[3].d.program);
    for (int k = 0; k < 4; k++) {
        toolpath_options o = { .feed = 1, .travel = 1, .rapid = 1, .start = { 20 + counted[k] } };
        toolpath path;
        tools_counted(&part[k].d, o.counted);
        CHECK_NEAR(o.counted[0], counted[k], 1e-12);
        toolpath_make(&path, &part[k].d, &o);
        CHECK_NEAR(path.move[path.count - 1].p[3][0], 20 + (k < 3 ? counted[k + 1] : 11), 1e-9);
        toolpath_free(&path);
    }
    drawing_free(&d);
}

/* More changes than there is room for are told, not left out. */
static void too_many_changes_are_told(arb *a)
{
    const char *const lines[] = { "tool.1.diameter = 3", "tool.2.length = 5", NULL };
    char text[16000] = "G1 X0 F60\n";
    machine_tools t;
    drawing d = { .tools = &t };
    tools_part part[TOOLS_PARTS];

    (void)a;
    CHECK(read_lines(&t, lines) == 0);
    for (int n = 0; n <= TOOLS_PARTS; n++)
        sprintf(text + strlen(text), "T%d M6\nX%d\n", 1 + n % 2, n + 1);
    CHECK(drawing_read_gcode(&heard, &d, "part.nc", text, strlen(text)) == 0);
    CHECK(tools_split(&t, &d, &d, part) == 0);
    drawing_free(&d);
}

int main(void)
{
    PROPERTY(the_lines_are_read, 1);
    PROPERTY(bad_lines_are_refused, 1);
    PROPERTY(drawings_are_sorted, 1);
    PROPERTY(the_order_stays_within_a_tool, 1);
    PROPERTY(the_order_stays_within_a_layer, 1);
    PROPERTY(a_gap_is_drawn_by_the_tool, 1);
    PROPERTY(without_tools_nothing_changes, 1);
    PROPERTY(a_pen_cannot_be_lifted_downwards, 1);
    PROPERTY(a_program_changes_tools, 1);
    PROPERTY(too_many_changes_are_told, 1);
    return check_failures();
}
