/* tests/e2e/e2e_pty.c -- the pseudo terminals of the whole-job tests
 * SPDX-License-Identifier: MIT
 *
 *     e2e_pty noise LINK                  a machine that talks nonsense: random bytes, for ever
 *     e2e_pty mute LINK                   a machine that never answers
 *     e2e_pty relay SOCKET LINK [BAUD]    a Unix socket in front of the pty LINK, which may go away
 *                                         and come back:
 *                                         a serial line whose machine is switched off and on
 *     e2e_pty type LOG "SECONDS:KEY .." CMD   CMD on a terminal, with keys typed at those times
 *                                             ("0.5:h 2:^C") after the
 *                                         machine's LOG has said that a job has begun; "@TEXT@KEY":
 *                                         when CMD has printed TEXT since the key before
 *
 * LINK becomes a symbolic link to the pty. `type` gives the exit code of CMD; what CMD prints is
 * passed on.
 */
#include <fcntl.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

#define FIFO 512        /* bytes that a line takes at once, like a USB adapter */

static int die(const char *what)
{
    perror(what);
    return 71;
}

static int master_of(char *name, size_t size)
{
    const int master = posix_openpt(O_RDWR | O_NOCTTY);

    if (master < 0 || grantpt(master) != 0 || unlockpt(master) != 0 ||
        ptsname_r(master, name, size) != 0)
        exit(die("pty"));
    return master;
}

static double now_seconds(void)
{
    struct timespec t;

    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Talk or stay silent behind `link` until killed. The slave stays open, so a client may come and
 * go. */
static int serve_machine(const char *link, int noisy)
{
    char name[128];
    unsigned char bytes[64];
    unsigned seed = 1;
    struct termios mode;
    const int master = master_of(name, sizeof name), slave = open(name, O_RDWR | O_NOCTTY);

    if (slave < 0 || tcgetattr(slave, &mode) != 0)
        return die(name);
    cfmakeraw(&mode);
    tcsetattr(slave, TCSANOW, &mode);
    fcntl(master, F_SETFL, O_NONBLOCK);
    unlink(link);
    if (symlink(name, link) != 0)
        return die(link);
    for (;;) {
        struct pollfd p = { .fd = master, .events = POLLIN };
        poll(&p, 1, 5);
        while (read(master, bytes, sizeof bytes) > 0) {
        }
        for (size_t i = 0; i < sizeof bytes; i++) {
            seed     = seed * 1103515245u + 12345u;
            bytes[i] = (unsigned char)(seed >> 16);
        }
        if (noisy && write(master, bytes, sizeof bytes) < 0) {
        }
    }
}

static int server_of(const char *path)
{
    struct sockaddr_un address = { .sun_family = AF_UNIX };
    const int server = socket(AF_UNIX, SOCK_STREAM, 0);

    snprintf(address.sun_path, sizeof address.sun_path, "%s", path);
    unlink(path);
    if (server < 0 || bind(server, (struct sockaddr *)&address, sizeof address) != 0 ||
        listen(server, 1) != 0)
        exit(die(path));
    return server;
}

static int reopen_pty(const char *link)
{
    struct termios mode;
    const int fd = open(link, O_RDWR | O_NOCTTY | O_NONBLOCK);

    if (fd >= 0 && tcgetattr(fd, &mode) == 0) {
        cfmakeraw(&mode);
        tcsetattr(fd, TCSANOW, &mode);
    }
    return fd;
}

/* Carry bytes from one end to the other; bytes that cannot be delivered are lost, as on a wire.
 * Returns 0 or less when `from` is gone. */
static ssize_t carry_bytes(int from, int to, size_t most)
{
    unsigned char bytes[FIFO];
    const ssize_t got = read(from, bytes, most < sizeof bytes ? most : sizeof bytes);

    if (got > 0 && to >= 0 && write(to, bytes, (size_t)got) < 0) {
    }
    return got;
}

/* `left` bytes may pass now. Unread bytes stay where they are, so a sender feels a slow line. */
static void pass_bytes(int *from, int to, short ready, double *left)
{
    if (!ready || *left < 1)
        return;
    const ssize_t got = carry_bytes(*from, to, (size_t)*left);
    if (got > 0) {
        *left -= (double)got;
        return;
    }
    close(*from);
    *from = -1;
}

static void relay_line(const char *path, const char *link, double baud)
{
    const int server = server_of(path);
    double left[2] = { 0, 0 }, then = now_seconds();

    for (int client = -1, machine = -1;;) {
        if (client < 0)
            client = accept(server, NULL, NULL);
        if (machine < 0)
            machine = reopen_pty(link);
        struct pollfd p[2] = { { .fd = client, .events = POLLIN },
                               { .fd = machine, .events = POLLIN } };
        poll(p, 2, 20);
        const double now = now_seconds();
        for (int i = 0; i < 2; i++) {
            left[i] += (now - then) * baud / 10;
            if (left[i] > FIFO && p[i].revents == 0)    /* an idle line saves nothing up; a line
                                                         * that was not scheduled was not idle */
                left[i] = FIFO;
        }
        then = now;
        pass_bytes(&client, machine, p[0].revents, &left[0]);
        pass_bytes(&machine, client, p[1].revents, &left[1]);
        if (left[0] < 1 || left[1] < 1)
            usleep(1000);
    }
}

/* Read the next "SECONDS:KEY" or "@TEXT@KEY" of the script; text is empty or TEXT. */
static int next_key(char **script, double *at, char text[64], char *key)
{
    char *end;

    *script += strspn(*script, " ");
    text[0] = '\0';
    if (**script == '@') {
        end = strchr(*script + 1, '@');
        if (end == NULL)
            return 0;
        snprintf(text, 64, "%.*s", (int)(end - *script - 1), *script + 1);
        *at = 0;
    } else {
        *at = strtod(*script, &end);
        if (end == *script || *end != ':')
            return 0;
    }
    if (end[1] == '\0')
        return 0;
    *key    = end[1] == '^' ? (char)(end[2] & 0x1f) : end[1];
    *script = end + (end[1] == '^' ? 3 : 2);
    return 1;
}

/* Has the machine begun a job? Its log says so in its first lines. */
static int has_begun(const char *log)
{
    char text[512];
    FILE *f = fopen(log, "r");

    if (f == NULL)
        return 0;
    text[fread(text, 1, sizeof text - 1, f)] = '\0';
    fclose(f);
    return strstr(text, " begun") != NULL;
}

static int type_keys(const char *log, char *script, char **command)
{
    char name[128], key = 0, bytes[4096], want[64], seen[1 << 16] = "";
    size_t shown = 0;
    double at = 0;
    int status, more;
    const int master = master_of(name, sizeof name);
    const pid_t child = fork();

    if (child == 0) {
        setsid();
        const int slave = open(name, O_RDWR);
        const struct winsize size = { .ws_row = 24, .ws_col = 100 };
        ioctl(slave, TIOCSCTTY, 0);
        ioctl(slave, TIOCSWINSZ, &size);
        for (int fd = 0; fd < 3; fd++)
            dup2(slave, fd);
        setenv("TERM", "xterm", 1);
        execvp(command[0], command);
        _exit(die(command[0]) + 1);
    }
    double start = 0;
    more = next_key(&script, &at, want, &key);
    while (waitpid(child, &status, WNOHANG) == 0) {
        struct pollfd p = { .fd = master, .events = POLLIN };
        if (poll(&p, 1, 20) > 0) {
            const ssize_t got = read(master, bytes, sizeof bytes);
            if (got > 0) {
                fwrite(bytes, 1, (size_t)got, stdout);
                if (shown + (size_t)got >= sizeof seen)
                    shown = 0;
                memcpy(seen + shown, bytes, (size_t)got);
                seen[shown += (size_t)got] = '\0';
            } else {
                usleep(10000);
            }
        }
        if (start <= 0 && has_begun(log))
            start = now_seconds();
        if (more && start > 0 && now_seconds() - start >= at && strstr(seen, want) != NULL) {
            if (write(master, &key, 1) != 1)
                return die("key");
            seen[shown = 0] = '\0';
            more = next_key(&script, &at, want, &key);
        }
    }
    fcntl(master, F_SETFL, O_NONBLOCK);
    for (ssize_t got; (got = read(master, bytes, sizeof bytes)) > 0;)
        fwrite(bytes, 1, (size_t)got, stdout);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

int main(int argc, char **argv)
{
    if (argc == 3 && (strcmp(argv[1], "noise") == 0 || strcmp(argv[1], "mute") == 0))
        return serve_machine(argv[2], strcmp(argv[1], "noise") == 0);
    if ((argc == 4 || argc == 5) && strcmp(argv[1], "relay") == 0)
        relay_line(argv[2], argv[3], argc == 5 ? atof(argv[4]) : 1e9);
    if (argc > 4 && strcmp(argv[1], "type") == 0)
        return type_keys(argv[2], argv[3], argv + 4);
    fprintf(stderr, "usage: e2e_pty noise|mute LINK, e2e_pty relay SOCKET LINK [BAUD], or e2e_pty "
                    "type \"SECONDS:KEY ..\" CMD ..\n");
    return 64;
}
