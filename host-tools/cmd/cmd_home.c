/* host-tools/cmd/cmd_home.c -- loft home, loft unlock: finds the switches of the axes, and leaves
 * them
 * SPDX-License-Identifier: MIT
 */
#include "cmd/commands.h"
#include "cmd/run.h"            /* run_until */
#include "cmd/run_drawing.h"    /* run_teller */
#include "cmd/run_move.h"       /* run_mover */
#include "send/home.h"

#define WAYS "x-|x+|y-|y+|z-|z+"

typedef struct {
    mover_options move;
    const char *axes;           /* NULL: those with a place in the order */
    unsigned touches;
} home_options;

static const option home_rows[] = { { "axes", OPTION_WORD(home_options, axes), .value = "AXES",
      .remedy = "name the axes in one word, as xy" },
    OPTION_GROUP(home_options, move, mover_rows),
                                    { "touches", OPTION_INTEGER(home_options, touches), .least = 1,
                                      .most = 20, .value = "N", .standard = "2",
                                      .help = "how often each switch is touched slowly" },
                                    { 0 } };

static int run_home(void *options)
{
    const home_options *o  = options;
    bool axis[ENGINE_AXES] = { false };
    const send_teller to   = run_teller();
    mover v                = { .at = { 0 } };
    home h;
    int code = o->axes ? mover_axes(tool_host(), o->axes, axis) : 0;

    if (code == 0)
        code = run_mover(&v, &o->move, false);
    if (code == 0) {
        home_begin(&h, &v, o->axes ? axis : NULL, o->touches, &to);
        code = run_until(home_task(&h));
    }
    mover_close(&v);
    return code;
}

const command command_home = {
    .name = "home",
    .arguments = "[AXES] --port PORT",
    .summary = "find the switches of the axes, and know where the tool is",
    .detail = "AXES are letters, as xy or z; without them those with a home_order in the machine "
              "file, in\n"
              "this order. Each axis seeks its switch, backs off, touches it slowly, and is then "
              "home_back\n"
        "before it. Guard the first run with a hand at the power switch.\n",
    .options = home_rows,
    .size = sizeof(home_options),
    .run = run_home,
    .talks = true,
};


// Unlock
// ------

typedef struct {
    mover_options move;
    const char *way;            /* "x+", or NULL */
} unlock_options;

static const option unlock_rows[] = { { "way", OPTION_WORD(unlock_options, way), .value = "AXIS+",
                                        .choices = WAYS,
      .remedy = "name one way out, as x+ or y-" },
    OPTION_GROUP(unlock_options, move, mover_rows),
                                      { 0 } };

static int run_unlock(void *options)
{
    const unlock_options *o = options;
    const send_teller to    = run_teller();
    mover v                 = { .at = { 0 } };
    home h;
    int code = run_mover(&v, &o->move, false);

    if (code == 0) {
        home_unlock(&h, &v, o->way ? o->way[0] - 'x' : -1, o->way && o->way[1] == '-' ? -1 : 1,
                    &to);
        code = run_until(home_task(&h));
    }
    mover_close(&v);
    return code;
}

const command command_unlock = {
    .name = "unlock",
    .arguments = "[AXIS+|AXIS-] --port PORT",
    .summary = "lead the tool away from a closed limit switch",
    .detail = "Where one switch serves both ends of its axis, name the way out, as x+. It moves "
              "slowly, at\n"
        "most four times home_back, and ends where the switch has opened.\n",
    .options = unlock_rows,
    .size = sizeof(unlock_options),
    .run = run_unlock,
    .talks = true,
};
