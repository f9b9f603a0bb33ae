/* host-tools/cmd/cmd_go.c -- loft go, park, pen: straight moves to a place
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cmd/commands.h"
#include "cmd/run.h"            /* run_until */
#include "cmd/run_move.h"       /* run_mover, run_told */
#include "send/hand.h"
#include "base/scan.h"           /* scan_number */

#define FEED_ROW(s)                                                                                \
    { "feed", OPTION_NUMBER(s, feed), .least = 0.016, .most = 1000, .unit = "mm/s",                \
      .standard = "100", .help = "mm/s, or as 1200mm/min" }

/* `10,20`, `,,5`: an axis without a number stays. */
static int take_place(const char *text, double to[ENGINE_AXES])
{
    const char *s = text;

    to[0] = to[1] = to[2] = NAN;
    for (int i = 0; i < ENGINE_AXES; i++) {
        if (*s != ',' && *s != '\0' && (!scan_number(&s, &to[i]) || !(fabs(to[i]) <= 16383)))
            break;
        if (*s == '\0' && s != text)
            return 0;
        if (*s++ != ',')
            break;
    }
    return tool_error(EX_USAGE, "%s: give a place in mm as X,Y or X,Y,Z: ,,5 moves z alone", text);
}

typedef struct {
    mover_options move;
    const char *place;
    double feed;                /* mm/s */
    bool by;
} go_options;

static const option go_rows[] = { { "place", OPTION_WORD(go_options, place), .least = 1,
                                    .value = "X,Y[,Z]", .remedy = "name one place, as 10,20" },
    OPTION_GROUP(go_options, move, mover_rows),
    FEED_ROW(go_options),
                                  { "by", OPTION_FLAG(go_options, by),
                                    .help = "by that much, from where the tool is" },
                                  { 0 } };

static int go(void *options)
{
    const go_options *o = options;
    double to[ENGINE_AXES];
    mover v  = { .at = { 0 } };
    int code = take_place(o->place, to);
    hand m;

    if (code == 0)
        code = run_mover(&v, &o->move, false);
    if (code == 0) {
        hand_go(&m, &v, to, o->by, o->feed);
        code = run_told(&v, run_until(hand_task(&m)));
    }
    mover_close(&v);
    return code;
}

const command command_go = {
    .name = "go",
    .arguments = "X,Y[,Z] --port PORT",
    .summary = "move the tool straight to a place",
    .detail = "Places are in mm, as of the drawing; an axis without a number stays: ,,5 moves z "
              "alone. A\n"
              "place that begins with a minus comes first: loft go -5,3 --port PORT. Nothing lifts "
              "the pen:\n"
              "see `loft pen up`. A place beyond the table of the machine file is refused, and so "
              "is a move\n"
        "that does not lead away from a closed limit switch.\n",
    .options = go_rows,
    .size = sizeof(go_options),
    .run = go,
    .talks = true,
};


// Pen and park
// ------------

typedef struct {
    mover_options move;
    const char *way;            /* "up", "down" */
    double feed;                /* mm/s */
} pen_options;

static const option pen_rows[] = { { "way", OPTION_WORD(pen_options, way), .least = 1,
                                     .value = "up|down", .choices = "up|down",
      .remedy = "give up or down" },
    OPTION_GROUP(pen_options, move, mover_rows),
    FEED_ROW(pen_options),
                                   { 0 } };

static int run_pen(void *options)
{
    const pen_options *o = options;
    mover v              = { .at = { 0 } };
    int code             = run_mover(&v, &o->move, false);
    hand m;

    if (code == 0) {
        hand_pen(&m, &v, strcmp(o->way, "up") == 0, o->feed);
        code = run_told(&v, run_until(hand_task(&m)));
    }
    mover_close(&v);
    return code;
}

const command command_pen = {
    .name = "pen",
    .arguments = "up|down --port PORT",
    .summary = "lift the pen, or put it down",
    .detail = "It moves z to pen_up or pen_down of the machine file: 1 and 0 mm without one.\n",
    .options = pen_rows,
    .size = sizeof(pen_options),
    .run = run_pen,
    .talks = true,
};

typedef struct {
    mover_options move;
    double feed;                /* mm/s */
} park_options;

static const option park_rows[] = {
    OPTION_GROUP(park_options, move, mover_rows),
    FEED_ROW(park_options),
    OPTION_NO_WORDS("park takes no place: give x.park and y.park in the machine file"),
    { 0 }
};

static int run_park(void *options)
{
    const park_options *o = options;
    mover v               = { .at = { 0 } };
    int code              = run_mover(&v, &o->move, false);
    hand m;

    if (code == 0) {
        hand_park(&m, &v, o->feed);
        code = run_told(&v, run_until(hand_task(&m)));
    }
    mover_close(&v);
    return code;
}

const command command_park = {
    .name = "park",
    .arguments = "--port PORT",
    .summary = "lift the pen and go to the place for resting",
    .detail =
        "First z goes up to pen_up, if it is below; then x and y go to x.park and y.park of the\n"
        "machine file: 0,0 without one.\n",
    .options = park_rows,
    .size = sizeof(park_options),
    .run = run_park,
    .talks = true,
};
