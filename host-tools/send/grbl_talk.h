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
#define GRBL_DEAF       10.0    /* s of silence until we give up */
#define GRBL_WAITING    512     /* lines in flight at most */
#define GRBL_QUESTIONS  2       /* $I: the size of its buffer; $$: its settings */

#define GRBL_SAID       80      /* bytes of what it said, as it is repeated */

struct grbl {
    const char *port;
    transport line;
    char text[512];                     /* a line that is being received: the first bytes of it */
    size_t size;
    char name[64];                      /* its greeting                          */
    unsigned buffer;
    unsigned long received;             /* bytes                                 */
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
    double heard, asked, moved;         /* clocks: a line; a question; a place or an answer */
    double read;                        /* the clock of the last status that has a meaning */
    const gcode *code;
    size_t sent, done, wrong;           /* lines; wrong: the line that the error is about */
    size_t behind;                      /* moves of the path, drawn by now */
    unsigned size_of[GRBL_WAITING], under_way;   /* bytes                             */
    char error[GRBL_SAID], alarm[GRBL_SAID];     /* what follows the colon; "": none */
    bool failed, alarmed, restarted;
    bool surplus;                       /* an answer that belongs to no line */
};

/* Both return whether the port is still there. */
bool grbl_put(grbl *g, const char *bytes, size_t count);
bool grbl_put_byte(grbl *g, int byte);

/* Ask for the status where it is time to, wait at most so long for bytes, and take all lines that
 * are complete. Returns whether the port is still there. */
bool grbl_pump(grbl *g, int most_ms);

/* The exit code after printing one line: the port is not there any more. */
int grbl_report_vanished(const grbl *g);

#endif
