/* host-tools/serve/without_websockets.c -- refuses to serve in a program without libwebsockets
 * SPDX-License-Identifier: MIT
 */
#include "serve/serve.h"

bool serve_is_local(const char *host_name)
{
    (void)host_name;
    return true;
}

int serve_run(host *h, const serve_options *o, const serve_place *at)
{
    (void)o;
    (void)at;
    return host_error(h, EX_UNAVAILABLE, "serve.without", (host_place){ NULL, 0 },
                      "build it with libwebsockets-dev and libjson-c-dev",
                      "this loft was built without libwebsockets");
}
