/* host-tools/send/grbl_talk.h -- bytes and lines to and from a controller of grbl's kind
 * SPDX-License-Identifier: MIT
 *
 * Private to grbl*.c. A controller takes ? ! ~ and bytes from 0x80 on out of the stream at once.
 */
#ifndef LOFT_GRBL_TALK_H
#define LOFT_GRBL_TALK_H

#include "send/grbl.h"
#include "send/grbl_settings.h"
#include "send/transport.h"     /* transport */

#define GRBL_BUFFER     128     /* bytes that every such controller accepts */
#define GRBL_DEAF       10.0    /* s of silence until we give up */
#define GRBL_WAITING    512     /* lines in flight at most */
#define GRBL_QUESTIONS  2       /* $I: the size of its buffer; $$: its settings */

enum grbl_state { GRBL_UNKNOWN, GRBL_IDLE, GRBL_RUN, GRBL_HOLD, GRBL_HELD, GRBL_ALARM, GRBL_OTHER };

struct grbl {
    const char *port;
    transport line;
    char text[256];                     /* a line that is being received */
    size_t size;
    char name[64];                      /* its greeting                          */
    unsigned buffer;
    unsigned long received;             /* bytes                                 */
    bool answered;                      /* a word of grbl's arrived */
    unsigned inquired;                  /* how many of its questions were sent */
    bool asking;                        /* an answer is awaited */
    grbl_settings settings;
    enum grbl_state state;
    double machine[ENGINE_AXES], offset[ENGINE_AXES], place[ENGINE_AXES];
    bool placed, machined, offsetted;   /* known: WPos, or MPos and WCO; MPos; WCO */
    double unit;                        /* mm: of what it reports, 1 or 25.4 ($13) */
    double feed;                        /* mm/min                                */
    unsigned rate;                      /* override in percent                   */
    double heard, asked, moved;         /* clocks                                */
    const gcode *code;
    size_t sent, done, wrong;           /* lines; wrong: the line that the error is about */
    size_t behind;                      /* moves of the path, drawn by now */
    unsigned size_of[GRBL_WAITING], under_way;   /* bytes                             */
    int error, alarm;
    bool restarted;
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
