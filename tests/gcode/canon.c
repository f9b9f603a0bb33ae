/* tests/gcode/canon.c -- prints the motions of a G-code program as LinuxCNC's rs274 does
 * SPDX-License-Identifier: MIT
 *
 * canon FILE [MACHINE]: one line for each motion: the line of the file, the canonical function with
 * the numbers that rs274 prints, then `|`, the end in mm of the machine, and the feed in mm/min.
 * tests/gcode/peer.py compares them.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/host.h"
#include "base/source.h"
#include "base/tool.h"
#include "gcode/gcode.h"
#include "read/machine_file.h"

static void print(void *context, const host_message *m)
{
    (void)context;
    host_put_line(stderr, m, "", "");
}

static int print_event(void *context, const gcode_event *e)
{
    const int a = (e->plane + 1) % 3, b = (e->plane + 2) % 3;
    double mm[3];

    (void)context;
    gcode_place(e->frame, e->to, mm);
    if (e->kind == GCODE_SPINDLE || e->kind == GCODE_COOLANT)
        return 0;                       /* motion and stops are compared */
    printf("%u ", e->line);
    switch (e->kind) {
    case GCODE_RAPID:
    case GCODE_LINE:
        printf("%s(%.4f, %.4f, %.4f)",
               e->kind == GCODE_RAPID ? "STRAIGHT_TRAVERSE" : "STRAIGHT_FEED", e->to[0], e->to[1],
               e->to[2]);
        break;
    case GCODE_ARC:
        printf("ARC_FEED(%.4f, %.4f, %.4f, %.4f, %d, %.4f)", e->to[a], e->to[b], e->centre[a],
               e->centre[b], e->turns, e->to[e->plane]);
        break;
    case GCODE_CUBIC:     printf("NURBS_FEED(4)"); break;
    case GCODE_QUADRATIC: printf("NURBS_FEED(3)"); break;
    case GCODE_NURBS:     printf("NURBS_FEED(%u)", e->count); break;
    case GCODE_WAIT:      printf("DWELL(%.4f)", e->seconds); break;
    case GCODE_SPINDLE:
    case GCODE_COOLANT:   break;
    case GCODE_STOP:      printf("STOP()"); break;
    case GCODE_TOOL:      printf("CHANGE_TOOL(%ld)", e->tool); break;
    case GCODE_SAY:       printf("MESSAGE(\"%.*s\")", (int)e->length, e->text); break;
    }
    printf(" | %.4f %.4f %.4f %.4f\n", mm[0], mm[1], mm[2], e->feed * 60);
    return 0;
}

int main(int argc, char **argv)
{
    machine_file machine = machine_usual();
    host h      = { .message = print };
    size_t size = 0;
    int code    = 0;

    tool_use(&h);
    if (argc > 2 && (code = machine_read(&h, &machine, argv[2])) != 0)
        return code;
    char *text  = source_read(&h, argc > 1 ? argv[1] : "-", &size, &code);

    if (text == NULL)
        return code;
    gcode_program *g = gcode_open(&h, argc > 1 ? argv[1] : "-", GCODE_ANY, print_event, NULL);
    gcode_set_tools(g, &machine.tools);
    code     = gcode_read(g, text, size);
    gcode_close(g);
    free(text);
    return code;
}
