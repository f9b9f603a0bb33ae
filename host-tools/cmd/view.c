/* host-tools/cmd/view.c -- a job on the whole terminal
 * SPDX-License-Identifier: MIT
 *
 * A cell of a terminal is about twice as high as wide. Cells that the drawing meets are dots; those
 * that are drawn are #; the tool is @ where it draws and + where it is lifted.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cmd/screen.h"         /* screen_put */
#include "base/tool.h"           /* tool_grow */
#include "send/near_move.h"      /* near_move */
#include "host/duration.h"      /* host_duration */
#include "cmd/view.h"

#define ABOVE 2         /* rows above the drawing, and */
#define BELOW 6         /* below it */
#define HIGH  2.0       /* of a cell, in widths */

/* The program has one terminal. */
static struct {
    const report_job *job;
    int rows, columns;          /* of the drawing */
    char *cell;                 /* rows x (columns + 1): each row is a text */
    double low[2], per[2];      /* mm: the lower left corner; per column and row */
    size_t moves;               /* that are drawn */
} shown;

static bool draws(size_t n) { return report_draws(shown.job, n); }

static char *cell_at(const double at[2])
{
    const int column = (int)floor((at[0] - shown.low[0]) / shown.per[0] + 0.5);
    const int row    = shown.rows - 1 - (int)floor((at[1] - shown.low[1]) / shown.per[1] + 0.5);

    if (column < 0 || column >= shown.columns || row < 0 || row >= shown.rows)
        return NULL;
    return &shown.cell[row * (shown.columns + 1) + column];
}

/* Mark the cells of a move up to its parameter `end`. */
static void mark_move(const engine_move *m, double end, char mark)
{
    double length = 0;

    for (int k = 0; k < 3; k++)
        length += hypot((m->p[k + 1][0] - m->p[k][0]) / shown.per[0],
                        (m->p[k + 1][1] - m->p[k][1]) / shown.per[1]);
    const int steps = (int)fmin(ceil(2 * length), 10000) + 1;
    for (int k = 0; k <= steps && k <= end * steps; k++) {
        double at[ENGINE_AXES];
        near_point(m, (double)k / steps, at);
        char *cell = cell_at(at);
        if (cell != NULL)
            *cell = mark;
    }
}

/* The box of control points holds the curves. */
static void find_scale(void)
{
    const toolpath *path = shown.job->path;
    double box[4]        = { HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL };

    for (size_t n = 0; n < path->count; n++)
        for (int k = 0; k < 4 && draws(n); k++)
            for (int i = 0; i < 2; i++) {
                box[i]     = fmin(box[i], path->move[n].p[k][i]);
                box[2 + i] = fmax(box[2 + i], path->move[n].p[k][i]);
            }
    const double wide = fmax(box[2] - box[0], 1e-3), high = fmax(box[3] - box[1], 1e-3);
    shown.per[0] = fmax(wide / fmax(shown.columns - 1, 1), high / fmax(shown.rows - 1, 1) / HIGH);
    shown.per[1] = HIGH * shown.per[0];
    shown.low[0] = (box[0] + box[2]) / 2 - shown.per[0] * (shown.columns - 1) / 2;
    shown.low[1] = (box[1] + box[3]) / 2 - shown.per[1] * (shown.rows - 1) / 2;
}

/* All cells of the drawing, before it is drawn. */
static void lay_out(const report_job *job, int rows, int columns)
{
    const size_t bytes = (size_t)rows * (size_t)(columns + 1);

    if (shown.job == job && shown.rows == rows && shown.columns == columns)
        return;
    shown.job     = job;
    shown.rows    = rows;
    shown.columns = columns;
    shown.moves   = 0;
    shown.cell    = tool_grow(shown.cell, bytes);
    memset(shown.cell, ' ', bytes);
    for (int row = 0; row < rows; row++)
        shown.cell[row * (columns + 1) + columns] = '\0';
    if (job->path == NULL)
        return;
    find_scale();
    for (size_t n = 0; n < job->path->count; n++)
        if (draws(n))
            mark_move(&job->path->move[n], 1, '.');
}

static void put_drawing(const send_facts *f)
{
    const toolpath *path = shown.job->path;

    if (path == NULL)
        return;
    for (; shown.moves < f->moves && shown.moves < path->count; shown.moves++)
        if (draws(shown.moves))
            mark_move(&path->move[shown.moves], 1, '#');
    const bool down = draws(shown.moves);
    double part;
    if (down) {
        (void)near_move(&path->move[shown.moves], f->at, &part);
        mark_move(&path->move[shown.moves], part, '#');
    }
    for (int row = 0; row < shown.rows; row++)
        screen_put(ABOVE + row, 0, &shown.cell[row * (shown.columns + 1)]);
    const char *cell = cell_at(f->at);
    if (cell != NULL)
        screen_put(ABOVE + (int)(cell - shown.cell) / (shown.columns + 1),
                   (int)(cell - shown.cell) % (shown.columns + 1), down ? "@" : "+");
}

static void put_bar(int row, int columns, const send_facts *f, double left)
{
    const double part = f->total > 0 ? fmin(f->done / f->total, 1) : 1;
    const int width   = columns > 60 ? columns - 40 : 20;
    char text[512], of[32] = "", time[HOST_DURATION];
    size_t used = 0;

    text[used++] = '[';
    for (int i = 0; i < width && used < 400; i++)
        text[used++] = part * width >= i + 1 ? '#' : '.';
    if (f->items > 0)
        snprintf(of, sizeof of, " of %u", f->items);
    snprintf(text + used, sizeof text - used, "] %3.0f %%  %s left  item %u%s", floor(100 * part),
             host_duration(time, left, 0), f->item, of);
    screen_put(row, 0, text);
}

static void put_numbers(int row, const report_job *job, const send_facts *f)
{
    char text[256];

    snprintf(text, sizeof text, "X %8.2f  Y %8.2f  Z %8.2f   pen %-4s%s%s", f->at[0], f->at[1],
             f->at[2], draws(f->moves) ? "down" : "up", job->tool ? "   tool " : "",
             job->tool ? job->tool : "");
    screen_put(row, 0, text);
    snprintf(text, sizeof text, "speed %6.1f mm/s   override %3u %%   queue %u", f->feed,
             f->override, f->queued);
    screen_put(row + 1, 0, text);
}

void view_show(const report_job *job, const send_facts *f, double left, const char *line)
{
    int rows, columns;
    char text[256];

    if (!screen_open())
        return;
    screen_size(&rows, &columns);
    lay_out(job, rows > ABOVE + BELOW ? rows - ABOVE - BELOW : 1, columns);
    snprintf(text, sizeof text, "%s  to %s: %s", job->file, job->port, f->state);
    screen_put(0, 0, text);
    put_drawing(f);
    put_bar(rows - 5, columns, f, left);
    put_numbers(rows - 4, job, f);
    screen_put(rows - 2, 0, line);
    screen_put(rows - 1, 0,
               "h hold  r resume  a abort  + - 0 override  s state  ^C hold and leave");
    screen_show();
}

void view_end(void)
{
    screen_close();
    shown.job = NULL;
}
