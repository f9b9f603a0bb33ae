/* host-tools/serve/door.h -- who may come in: the names of this computer, the origin of its page
 * SPDX-License-Identifier: MIT
 *
 * A browser that shows a foreign page can reach this server. It tells where the page is from
 * (Origin), and the name that it asked for (Host): a foreign name that leads here is not ours.
 */
#ifndef LOFT_DOOR_H
#define LOFT_DOOR_H

#include <stdbool.h>

/* True if only this computer can reach what listens there. */
bool door_is_local(const char *listens);

/* Is this Host a name of the server that listens there, or an address? */
bool door_host(const char *listens, const char *host);

/* Is this Origin that of its page? "": no browser asks. */
bool door_origin(const char *host, const char *origin);

#endif
