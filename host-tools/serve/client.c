/* host-tools/serve/client.c
 * SPDX-License-Identifier: MIT
 */
#include <stdlib.h>

#include "serve/client.h"

void client_put(client *c, char *text)
{
    if (c->count == CLIENT_ANSWERS) {
        c->late = true;
        free(text);
        return;
    }
    c->answer[(c->first + c->count++) % CLIENT_ANSWERS] = text;
}

void client_say(client *c, char *text)
{
    free(c->said);
    c->said = text;
}

const char *client_take(client *c)
{
    if (c->count == 0)
        return NULL;
    client_say(c, c->answer[c->first]);
    c->first = (c->first + 1) % CLIENT_ANSWERS;
    c->count--;
    return c->said;
}

void client_free(client *c)
{
    while (client_take(c) != NULL)
        ;
    free(c->said);
    *c = (client){ .here = false };
}
