/* tests/e2e/e2e_pty.c -- the pseudo terminals of the whole-job tests
 * SPDX-License-Identifier: MIT
 *
 *     e2e_pty noise LINK                  a machine that talks nonsense: random bytes, for ever
 *     e2e_pty mute LINK                   a machine that never answers
 *     e2e_pty relay SOCKET LINK           a Unix socket in front of the pty LINK, which may go away
 *                                         and come back:
 *                                         a serial line whose machine is switched off and on
 *     e2e_pty type LOG PID SCRIPT CMD..   CMD on a terminal, where keys are typed, each after an
 *                                         event; LOG and PID are of the machine
 *     e2e_pty until FILE EXPRESSION       wait until FILE has a line of this extended expression
 *
 * SCRIPT is a row of events and keys with spaces between:
 *     @TEXT@KEY       when CMD has printed TEXT since the key before
 *     #TEXT#KEY       when LOG says TEXT, behind the last place where it said what was awaited
 *     *TEXT*KEY       KEY is held, so it comes again and again, until LOG says TEXT
 *     ~TEXT~KEY       the same, until CMD has printed TEXT since the key before
 *     _KEY            when a terminal would repeat no key that was held any more
 * KEY is a character, or
 *     ^C ^\\ ^[       a control character
 *     >               no key: time goes on in the machine (SIGUSR2)
 *     !               no key: the machine is gone (SIGKILL)
 *     .               no key
 *
 * LINK becomes a symbolic link to the pty. `type` gives the exit code of CMD; what CMD prints is
 * passed on.
 */
#include <fcntl.h>
#include <poll.h>
#include <regex.h>
#include <signal.h>
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
#define RELEASED 0.25   /* s: a key that comes later is no repetition */
#define PATIENCE 600.0  /* s that a busy computer may take for what is awaited */

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

/* The line has an owner while the relay is there: a simulated machine does not take it for gone. */
static int reopen_pty(const char *link)
{
    struct termios mode;
    struct flock first = { .l_type = F_WRLCK, .l_whence = SEEK_SET, .l_len = 1 };
    const int fd = open(link, O_RDWR | O_NOCTTY | O_NONBLOCK);

    if (fd >= 0 && tcgetattr(fd, &mode) == 0) {
        cfmakeraw(&mode);
        tcsetattr(fd, TCSANOW, &mode);
        fcntl(fd, F_OFD_SETLK, &first);
    }
    return fd;
}

/* Carry bytes from one end to the other; bytes that cannot be delivered are lost, as on a wire.
 * Returns 0 or less when `from` is gone. */
static ssize_t carry_bytes(int from, int to)
{
    unsigned char bytes[FIFO];
    const ssize_t got = read(from, bytes, sizeof bytes);

    if (got > 0 && to >= 0 && write(to, bytes, (size_t)got) < 0) {
    }
    return got;
}

static void pass_bytes(int *from, int to, short ready)
{
    if (!ready || carry_bytes(*from, to) > 0)
        return;
    close(*from);
    *from = -1;
}

static void relay_line(const char *path, const char *link)
{
    const int server = server_of(path);

    for (int client = -1, machine = -1;;) {
        if (client < 0)
            client = accept(server, NULL, NULL);
        if (machine < 0)
            machine = reopen_pty(link);
        struct pollfd p[2] = { { .fd = client, .events = POLLIN },
                               { .fd = machine, .events = POLLIN } };
        poll(p, 2, 20);
        pass_bytes(&client, machine, p[0].revents);
        pass_bytes(&machine, client, p[1].revents);
    }
}

/* An event and the key that follows it. */
typedef struct {
    char kind;              /* one of "@#*~_"; 0: no more */
    char text[80];
    const char *key;
} event;

static int is_control(const char *key) { return key[0] == '^' && key[1] > ' '; }

static event next_event(const char **script)
{
    event e         = { .kind = 0 };
    const char *at = *script + strspn(*script, " \n"), *end;

    if (*at == '\0')
        return e;
    e.kind = *at;
    end    = *at == '_' ? at : strchr("@#*~", *at) ? strchr(at + 1, *at) : NULL;
    if (end == NULL || end[1] == '\0') {
        fprintf(stderr, "e2e_pty: no event and key: %s\n", at);
        exit(64);
    }
    if (end > at)
        snprintf(e.text, sizeof e.text, "%.*s", (int)(end - at - 1), at + 1);
    e.key   = end + 1;
    *script = e.key + (is_control(e.key) ? 2 : 1);
    return e;
}

/* Does the file say `text` behind *from? Then *from is behind that. */
static int says(const char *file, const char *text, long *from)
{
    static char all[1 << 20];
    FILE *f = fopen(file, "r");

    if (f == NULL)
        return 0;
    all[fread(all, 1, sizeof all - 1, f)] = '\0';
    fclose(f);
    const char *at = (size_t)*from <= strlen(all) ? strstr(all + *from, text) : NULL;
    if (at == NULL)
        return 0;
    *from = at - all + (long)strlen(text);
    return 1;
}

static int until_line(const char *file, const char *expression)
{
    regex_t want;
    char line[4096];

    if (regcomp(&want, expression, REG_EXTENDED | REG_NEWLINE | REG_NOSUB) != 0)
        return 64;
    for (const double start = now_seconds(); now_seconds() - start < PATIENCE; usleep(10000)) {
        FILE *f = fopen(file, "r");
        while (f != NULL && fgets(line, sizeof line, f) != NULL)
            if (regexec(&want, line, 0, NULL, 0) == 0)
                return 0;
        if (f != NULL)
            fclose(f);
    }
    return 1;
}

static pid_t start_on_terminal(int *master, char **command)
{
    char name[128];
    *master = master_of(name, sizeof name);
    const pid_t child = fork();

    if (child != 0)
        return child;
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

/* What a command has printed since the last key. */
static struct {
    char text[1 << 16];
    size_t count;
} seen;

static ssize_t pass_output(int master)
{
    char bytes[4096];
    const ssize_t got = read(master, bytes, sizeof bytes);

    if (got <= 0)
        return got;
    fwrite(bytes, 1, (size_t)got, stdout);
    fflush(stdout);
    if (seen.count + (size_t)got >= sizeof seen.text)
        seen.count = 0;
    for (ssize_t i = 0; i < got; i++)       /* a NUL would end the text */
        seen.text[seen.count++] = bytes[i] ? bytes[i] : ' ';
    seen.text[seen.count] = '\0';
    return got;
}

static void press(int master, pid_t machine, const char *key)
{
    const char byte = is_control(key) ? (char)(key[1] & 0x1f) : key[0];

    if (*key == '>' || *key == '!')
        kill(machine, *key == '>' ? SIGUSR2 : SIGKILL);
    else if (*key != '.' && write(master, &byte, 1) != 1)
        exit(die("key"));
}

static int is_due(const event *e, const char *log, long *from, double typed)
{
    switch (e->kind) {
    case '@':
    case '~': return strstr(seen.text, e->text) != NULL;
    case '#':
    case '*': return says(log, e->text, from);
    case '_': return now_seconds() - typed > RELEASED;
    default:  return 0;
    }
}

static int type_keys(const char *log, pid_t machine, const char *script, char **command)
{
    int master, status;
    long from = 0;
    const pid_t child = start_on_terminal(&master, command);
    event e = next_event(&script);
    double typed = 0;

    while (waitpid(child, &status, WNOHANG) == 0) {
        struct pollfd p = { .fd = master, .events = POLLIN };
        if (poll(&p, 1, 10) > 0 && pass_output(master) <= 0)
            usleep(10000);
        const int held = e.kind == '*' || e.kind == '~', due = is_due(&e, log, &from, typed);
        if (!due && held)
            press(master, machine, e.key);
        if (!due)
            continue;
        if (!held)
            press(master, machine, e.key);
        typed = now_seconds();
        seen.text[seen.count = 0] = '\0';
        e = next_event(&script);
    }
    fcntl(master, F_SETFL, O_NONBLOCK);
    while (pass_output(master) > 0) {
    }
    if (e.kind != 0)
        printf("\ne2e_pty: the command ended before %c%s%c\n", e.kind, e.text, e.kind);
    return e.kind != 0 ? 70 : WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

int main(int argc, char **argv)
{
    if (argc == 3 && (strcmp(argv[1], "noise") == 0 || strcmp(argv[1], "mute") == 0))
        return serve_machine(argv[2], strcmp(argv[1], "noise") == 0);
    if (argc == 4 && strcmp(argv[1], "relay") == 0)
        relay_line(argv[2], argv[3]);
    if (argc > 5 && strcmp(argv[1], "type") == 0)
        return type_keys(argv[2], atoi(argv[3]), argv[4], argv + 5);
    if (argc == 4 && strcmp(argv[1], "until") == 0)
        return until_line(argv[2], argv[3]);
    fprintf(stderr, "usage: e2e_pty noise|mute LINK, e2e_pty relay SOCKET LINK, e2e_pty until FILE "
                    "EXPRESSION, or e2e_pty type LOG PID SCRIPT CMD ..\n");
    return 64;
}
