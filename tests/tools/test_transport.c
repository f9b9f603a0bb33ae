/* tests/tools/test_transport.c -- lines are opened without waiting
 * SPDX-License-Identifier: MIT
 */
#include <arpa/inet.h>
#include <errno.h>
#include <netinet/in.h>
#include <poll.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

#include "check.h"
#include "send/transport.h"
#include "support/heard.h"

#define MOST 64                 /* connections that nobody takes */

/* A socket at a free port of this computer. */
static int listen_at(unsigned *port, int backlog)
{
    struct sockaddr_in at = { .sin_family = AF_INET, .sin_addr.s_addr = htonl(INADDR_LOOPBACK) };
    socklen_t size        = sizeof at;
    const int fd          = socket(AF_INET, SOCK_STREAM, 0);

    CHECK(bind(fd, (const struct sockaddr *)&at, sizeof at) == 0 && listen(fd, backlog) == 0);
    CHECK(getsockname(fd, (struct sockaddr *)&at, &size) == 0);
    *port = ntohs(at.sin_port);
    return fd;
}

static int step(transport *t)
{
    task_wants w = { .in = -1, .out = -1, .until = HUGE_VAL };

    return transport_step(t, 1, &w);
}

/* Step as a loop does: when the socket is writable, or when the name may be known. */
static int open_all(transport *t, const char *name)
{
    int code = transport_open(t, &heard, name, 0);

    while (code == 0 && t->opening != NULL) {
        task_wants w = { .in = -1, .out = -1, .until = HUGE_VAL };
        code         = transport_step(t, 1, &w);
        CHECK(code != TASK_GOES || w.out >= 0 || w.until < HUGE_VAL);
        if (code == TASK_GOES) {
            (void)poll(&(struct pollfd){ w.out, POLLOUT, 0 }, 1, w.out >= 0 ? -1 : 20);
            code = 0;
        }
    }
    return code;
}

/* By number and by name; bytes pass both ways. */
static void a_server_is_reached(arb *a)
{
    static const char *const hosts[] = { "127.0.0.1", "localhost" };
    unsigned port;
    char name[80], byte = 'x';
    transport t;
    const int server = listen_at(&port, 5);

    hear();
    snprintf(name, sizeof name, "tcp:%s:%u", hosts[arb_below(a, 2)], port);
    CHECK(open_all(&t, name) == 0 && strcmp(t.text, name) == 0 && caught_lines == 0);
    const int peer = accept(server, NULL, NULL);
    CHECK(t.kind->read(&t, &byte, 1) == 0 && t.kind->write(&t, "y", 1) == 1);
    CHECK(read(peer, &byte, 1) == 1 && byte == 'y');
    close(peer);
    (void)poll(&(struct pollfd){ t.in, POLLIN, 0 }, 1, -1);
    CHECK(t.kind->read(&t, &byte, 1) == -1 && errno == EPIPE);
    t.kind->close(&t);
    close(server);
}

/* One that takes nobody in lets the caller go on, and leave. */
static void who_does_not_answer_stops_nobody(arb *a)
{
    transport t[MOST];
    unsigned port, count = 0;
    char name[80];
    bool waits       = false;
    const int server = listen_at(&port, 0);

    (void)a;
    snprintf(name, sizeof name, "tcp:127.0.0.1:%u", port);
    while (count < MOST && !waits) {
        CHECK(transport_open(&t[count], &heard, name, 0) == 0);
        waits = step(&t[count++]) == TASK_GOES;
    }
    CHECK(waits);                       /* its queue is full: the kernel asks it again and again */
    for (int k = 0; k < 100; k++)
        CHECK(step(&t[count - 1]) == TASK_GOES);
    while (count > 0) {
        count--;
        t[count].kind->close(&t[count]);
    }
    close(server);
}

static void a_closed_door_is_told(arb *a)
{
    unsigned port;
    char name[80];
    transport t;

    (void)a;
    close(listen_at(&port, 1));
    hear();
    snprintf(name, sizeof name, "tcp:127.0.0.1:%u", port);
    CHECK(open_all(&t, name) == EX_UNAVAILABLE && caught_lines == 1);
    CHECK(heard_it("port.no-server", 0));
    t.kind->close(&t);
    CHECK(open_all(&t, "tcp:127.0.0.1:no-service-of-this-name") == EX_NOHOST);
    CHECK(heard_it("port.no-host", 0));
    if (t.kind != NULL)
        t.kind->close(&t);
}

int main(void)
{
    PROPERTY(a_server_is_reached, 4);
    PROPERTY(who_does_not_answer_stops_nobody, 1);
    PROPERTY(a_closed_door_is_told, 1);
    return check_failures();
}
