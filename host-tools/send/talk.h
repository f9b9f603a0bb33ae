/* host-tools/send/talk.h -- a session with a machine over a transport: bytes and clock for
 * lib/wire/sender.h
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TALK_H
#define LOFT_TALK_H

#include "wire/sender.h"    /* loft_sender */

#include "base/host.h"           /* host */
#include "base/option.h"         /* option */
#include "send/task.h"           /* task, task_wants */
#include "send/transport.h"      /* transport */
#include "send/wire_text.h"      /* wire_text */

typedef struct {
    host *host;                         /* hears of what is wrong */
    const char *port;
    transport line;
    loft_sender sender;
    uint64_t written, received;         /* bytes                          */
    uint8_t out[LOFT_FRAME_MAX + 1];    /* a frame that is being sent, from out_at on */
    size_t out_size, out_at;
    FILE *log;                          /* everything that passes, in words, or NULL */
    wire_text down, up;
    double now, began;                  /* the time of the last step, and of the opening */
    bool stop;                          /* whoever owns it asks for the end */
    bool greeting;                      /* it has begun, and */
    double until, wait;                 /* ends, s later */
    uint32_t job;                       /* to be noted when it begins (unfinished.h); 0: none */
    const char *job_file;
    bool noted;
} talk;

/* Where the machine is. */
typedef struct {
    const char *port;
    unsigned baud;
    double wait;                /* s */
    const char *log;            /* a file for the traffic on the line, in words (wire_text.h); NULL:
                                 * none */
} talk_options;
extern const option talk_rows[];        /* all but `log`, which the command names */

/* Open the port. Next the machine is to be greeted. Returns 0, or an exit code after one
 * message; call talk_close in any case. */
int  talk_open(talk *t, host *h, const talk_options *o, double now);
void talk_close(talk *t);

/* The same with a line that is open already, which is closed with the session. */
int  talk_take(talk *t, host *h, const talk_options *o, const transport *line, double now);

/* Greet the machine, for so long at most: another session begins, since a session has one job.
 * talk_greet is to be stepped then: TASK_GOES, 0 when it has answered, or an exit code after
 * one message; the line is still open. */
void talk_again(talk *t, double seconds);
int  talk_greet(talk *t, double now, task_wants *w);
task talk_greets(talk *t);

/* Move the bytes that are there, both ways. Returns false if the port has vanished (errno says
 * why). */
bool talk_step(talk *t, double now, task_wants *w);

/* When to step it again, after something was asked of the sender. */
void talk_wants(const talk *t, task_wants *w);

/* Tell that the port has vanished, and `where` the job is; one that had begun goes on only if the
 * machine kept its power. Returns the exit code. */
int  talk_vanished(const talk *t, const char *where);

/* Refuse to draw, or to go to a place, while the position is in doubt: after an emergency stop, or
 * after a restart of the machine in a job. Returns 0, or an exit code
 * after one message. */
int talk_certain(const talk *t);

/* Job `id` of `file`, which stays, is about to begin: when the machine has taken it, and before any
 * item is sent, that is noted. The job is over, as the sender's phase tells. The place of these
 * axes is known again. */
void talk_begins(talk *t, uint32_t id, const char *file);
void talk_over(talk *t);
void talk_placed(const talk *t, unsigned axes);

/* "the limit switch of x at its low end, the emergency stop": the inputs that end a job. */
const char *talk_inputs(uint16_t inputs, char text[256]);

/* The time since the machine's last frame, in seconds, but not more than since `began`: before
 * that, nothing was asked of it. */
double talk_silence(const talk *t, double began);

#endif
