/* host-tools/serve/client.h -- pages that watch: what each has asked, and what it was told
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_CLIENT_H
#define LOFT_CLIENT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define CLIENT_ANSWERS 64       /* that wait, at most */

typedef struct {
    bool here, greeted;
    char *answer[CLIENT_ANSWERS];
    unsigned first, count;
    bool late;                  /* there was no room for one */
    uint64_t seq;               /* of the newest change that it was told */
    double told;                /* the time of that */
    char *said;                 /* the text that serve_says gave last */
} client;

/* Put a text, which becomes its own. */
void client_put(client *c, char *text);

/* Take the next one, which stays until the next call; NULL: there is none. */
const char *client_take(client *c);

void client_say(client *c, char *text);
void client_free(client *c);

#endif
