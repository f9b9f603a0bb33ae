/* host-tools/send/transport_tcp.c -- sockets to another computer: looked up and connected in steps
 * SPDX-License-Identifier: MIT
 *
 * A name is looked up by a thread of the C library (getaddrinfo_a), since nothing else asks a
 * resolver without waiting for it. An address in numbers needs none.
 */
#include <errno.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

#include "base/memory.h"         /* memory_grow */
#include "send/transport_kind.h"

#define LOOK 0.02               /* s between two looks whether a name is known */

struct transport_opening {
    host *host;
    char name[300], site[256], service[40];     /* "tcp:SITE:SERVICE" */
    struct addrinfo hints, *all, *next;
    struct gaicb asked;
    bool looks;                 /* it is looked up */
    int fd;                     /* that is being connected; -1: none */
    int error;                  /* errno of the last address */
};

/* A look-up that cannot be cancelled writes into its memory yet: that stays. */
static void opening_close(transport *t)
{
    struct transport_opening *o = t->opening;

    t->opening = NULL;
    if (o->fd >= 0)
        close(o->fd);
    if (o->looks && gai_cancel(&o->asked) == EAI_NOTCANCELED)
        return;
    if (o->looks)
        o->all = o->asked.ar_result;
    if (o->all != NULL)
        freeaddrinfo(o->all);
    free(o);
}

static long opening_read(transport *t, void *bytes, size_t max)
{
    (void)t;
    (void)bytes;
    (void)max;
    return 0;
}

static long opening_write(transport *t, const void *bytes, size_t count)
{
    (void)t;
    (void)bytes;
    (void)count;
    return 0;
}

static int report_unknown(const struct transport_opening *o, int failed)
{
    return host_error(o->host, EX_NOHOST, "port.no-host", (host_place){ .file = o->name },
                      "look at the name of the host and the port", "%s", gai_strerror(failed));
}

/* An address in numbers is known at once. */
static int begin_look(struct transport_opening *o)
{
    struct gaicb *list[] = { &o->asked };

    o->hints   = (struct addrinfo){ .ai_family   = AF_UNSPEC,
                                  .ai_socktype = SOCK_STREAM,
                                  .ai_flags    = AI_NUMERICHOST };
    int failed = getaddrinfo(o->site, o->service, &o->hints, &o->all);
    if (failed == EAI_NONAME) {
        o->hints.ai_flags = 0;
        o->asked =
            (struct gaicb){ .ar_name = o->site, .ar_service = o->service, .ar_request = &o->hints };
        failed   = getaddrinfo_a(GAI_NOWAIT, list, 1, NULL);
        o->looks = failed == 0;
    }
    o->next = o->all;
    return failed == 0 ? 0 : report_unknown(o, failed);
}

int transport_open_tcp(transport *t, host *h, const char *name)
{
    static const transport_kind kind = { opening_read, opening_write, opening_close };
    const char *colon                = strrchr(name, ':');
    const size_t length = (size_t)(colon - name) - 3;   /* the text between "tcp" and the last
                                                         * colon */
    struct transport_opening *o;

    if (colon == name + 3 || length > sizeof o->site || colon[1] == '\0' ||
        strlen(colon) > sizeof o->service)
        return host_error(h, EX_USAGE, "port.not-a-socket", (host_place){ .file = NULL },
                          "give tcp:HOST:PORT", "%s", name);
    const bool bracketed = name[4] == '[' && colon[-1] == ']';      /* an IPv6 address */
    o  = memory_grow(NULL, sizeof *o);
    *o = (struct transport_opening){ .host = h, .fd = -1, .error = EHOSTUNREACH };
    snprintf(o->name, sizeof o->name, "%s", name);
    snprintf(o->site, sizeof o->site, "%.*s", (int)length - 1 - 2 * bracketed,
             name + 4 + bracketed);
    snprintf(o->service, sizeof o->service, "%s", colon + 1);
    t->kind    = &kind;
    t->opening = o;
    snprintf(t->text, sizeof t->text, "%.120s", name);
    const int code = begin_look(o);
    if (code != 0) {
        opening_close(t);
        t->kind = NULL;
    }
    return code;
}

/* TASK_GOES until the addresses are known. */
static int look(struct transport_opening *o, double now, task_wants *w)
{
    const int failed = o->looks ? gai_error(&o->asked) : 0;

    if (failed == EAI_INPROGRESS) {
        task_wake(w, now + LOOK);
        snprintf(w->awaits, sizeof w->awaits, "the host of %.120s is looked up", o->name);
        return TASK_GOES;
    }
    if (o->looks)
        o->all = o->next = o->asked.ar_result;
    o->looks = false;
    return failed == 0 ? 0 : report_unknown(o, failed);
}

static void leave_address(struct transport_opening *o, int error)
{
    o->error = error;
    if (o->fd >= 0)
        close(o->fd);
    o->fd   = -1;
    o->next = o->next->ai_next;
}

/* Begin with the next address. Returns whether it may be connected some time. */
static bool begin_connect(struct transport_opening *o)
{
    const struct addrinfo *a = o->next;

    o->fd = socket(a->ai_family, a->ai_socktype | SOCK_CLOEXEC | SOCK_NONBLOCK, a->ai_protocol);
    if (o->fd >= 0 && (connect(o->fd, a->ai_addr, a->ai_addrlen) == 0 || errno == EINPROGRESS))
        return true;
    leave_address(o, errno);
    return false;
}

/* Is the socket connected? Otherwise, *waits: it may be later. */
static bool is_connected(struct transport_opening *o, bool *waits)
{
    struct pollfd p = { .fd = o->fd, .events = POLLOUT };
    int error       = 0;
    socklen_t size  = sizeof error;

    *waits = poll(&p, 1, 0) == 0;
    if (*waits)
        return false;
    if (getsockopt(o->fd, SOL_SOCKET, SO_ERROR, &error, &size) != 0)
        error = errno;
    if (error != 0)
        leave_address(o, error);
    return error == 0;
}

static int connect_on(transport *t, task_wants *w)
{
    struct transport_opening *o = t->opening;
    const int one               = 1;
    bool waits;

    while (o->next != NULL) {
        if (o->fd < 0 && !begin_connect(o))
            continue;
        if (is_connected(o, &waits)) {
            const int fd = o->fd;
            char name[sizeof o->name];
            (void)setsockopt(fd, IPPROTO_TCP, TCP_NODELAY, &one, sizeof one);
            memcpy(name, o->name, sizeof name);
            o->fd = -1;
            opening_close(t);
            return transport_take(t, fd, fd, name);
        }
        if (waits) {
            w->out = o->fd;
            snprintf(w->awaits, sizeof w->awaits, "%.120s does not answer yet", o->name);
            return TASK_GOES;
        }
    }
    return transport_refused(o->host, o->name, o->error);
}

int transport_step_tcp(transport *t, double now, task_wants *w)
{
    const int code = look(t->opening, now, w);
    return code == 0 ? connect_on(t, w) : code;
}
