/* host-tools/send/grbl_talk.h -- bytes and lines to and from a controller of grbl's kind
 * SPDX-License-Identifier: MIT
 *
 * Private to grbl*.c. A controller takes ? ! ~ and bytes from 0x80 on out of the stream at once.
 */
#ifndef LOFT_GRBL_TALK_H
#define LOFT_GRBL_TALK_H

#include "send/grbl.h"
#include "send/grbl_settings.h"
#include "send/grbl_words.h"    /* grbl_state */
#include "send/transport.h"     /* transport */

#define GRBL_BUFFER     128     /* bytes of grbl's own buffer: taken where it tells none */
#define GRBL_BUFFER_LEAST 16    /* bytes that are believed */
#define GRBL_BUFFER_MOST  65536
#define GRBL_FAR        1e6     /* mm, mm/min: what is beyond has no meaning */
#define GRBL_ASK        0.2     /* s between two status queries */
#define GRBL_DEAF       10.0    /* s of silence until we give up */
#define GRBL_WAITING    512     /* lines in flight at most */
#define GRBL_QUESTIONS  2       /* $I: the size of its buffer; $$: its settings */

#define GRBL_SAID       80      /* bytes of what it said, as it is repeated */
#define GRBL_OUT        2048    /* bytes that wait for the line */

enum grbl_stop { GRBL_STOPS_WRONG, GRBL_STOPS_AFTER, GRBL_STOPS_ABORTED };

struct grbl {
    host *host;                         /* hears of what is wrong */
    const char *port;
    transport line;
    double now;                         /* the time of the last step */
    bool stop;                          /* whoever owns it asks for the end, */
    bool abort;                         /* or a key does */
    bool over;                          /* see grbl_over */
    int (*stage)(struct grbl *g, double now, task_wants *w);
    double wait, until;                 /* s for an answer; it comes then, or never */
    char out[GRBL_OUT];                 /* bytes that wait for the line */
    size_t out_size;
    double put;                         /* the time when it last took some */
    char text[512];                     /* a line that is being received: the first bytes of it */
    size_t size;
    char name[64];                      /* its greeting                          */
    unsigned buffer;
    unsigned long received;             /* bytes                                 */
    unsigned warned;                    /* messages, before this controller */
    bool answered;                      /* a word of grbl's arrived */
    unsigned inquired;                  /* how many of its questions were sent */
    bool asking;                        /* an answer is awaited */
    grbl_settings settings;
    const grbl_state *state;            /* NULL: not told since the last question of ours */
    char word[24];                      /* the state, as it says it */
    char unread[GRBL_SAID];             /* the first status that has no meaning since the last that
                                         * has one */
    unsigned idles;                     /* "Idle" so often since the last answer */
    double machine[ENGINE_AXES], offset[ENGINE_AXES], place[ENGINE_AXES];
    bool placed, machined, offsetted;   /* known: WPos, or MPos and WCO; MPos; WCO */
    double unit;                        /* mm: of what it reports, 1 or 25.4 ($13) */
    double feed;                        /* mm/min                                */
    unsigned rate;                      /* override in percent                   */
    double heard, asked, moved;         /* times: a line; a question; a place or an answer */
    double read;                        /* the time of the last status that has a meaning */
    const gcode *code;                  /* that is sent; NULL: none */
    const gcode *lines;                 /* of the job, also when it is not sent any more, and */
    const toolpath *path;               /* what they draw */
    send_teller to;
    double began;                       /* the job, then the stop */
    enum grbl_stop why;                 /* it is to stop, */
    char what[GRBL_SAID + 64];          /* since this is wrong */
    bool rests;                         /* it said that it stopped */
    size_t sent, done, wrong;           /* lines; wrong: the line that the error is about */
    size_t behind;                      /* moves of the path, drawn by now */
    unsigned size_of[GRBL_WAITING], under_way;   /* bytes                             */
    char error[GRBL_SAID], alarm[GRBL_SAID];     /* what follows the colon; "": none */
    bool failed, alarmed, restarted;
    bool surplus;                       /* an answer that belongs to no line */
};

/* Bytes are put behind those that wait for the line, if there is room for them. */
size_t grbl_room(const grbl *g);
void grbl_put(grbl *g, const char *bytes, size_t count);
void grbl_put_byte(grbl *g, int byte);

/* Give the line what it takes. Returns whether the port is still there. */
bool grbl_flush(grbl *g);

/* Ask for the status where it is time to, move the bytes that are there, and take all lines that
 * are complete. Returns whether the port is still there. */
bool grbl_step(grbl *g, double now, task_wants *w);

/* The exit code after one message: the port is not there any more. */
int grbl_report_vanished(const grbl *g);

#endif
