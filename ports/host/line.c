/* ports/host/line.c
 * SPDX-License-Identifier: MIT
 */
#include "host/line.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sysexits.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

#include "host/baud.h"      /* host_baud */

#define AWAY_MS 200             /* between two attempts to open a vanished port */

static int report_error(const char *what, const char *name)
{
    fprintf(stderr, "loft: %s: %s: %s\n", name, what, strerror(errno));
    return EX_OSERR;
}

/* A machine holds a lock on the slave of its pseudo terminal, at the byte with the inode number of
 * its link. The slave of an abandoned link may belong to another machine by now. flock, and the
 * lock of byte 0, are for the programs that talk to the machine. */
static struct flock lock_of(const struct stat *link)
{
    struct flock lock;

    memset(&lock, 0, sizeof lock);
    lock.l_type   = F_WRLCK;
    lock.l_whence = SEEK_SET;
    lock.l_start  = (off_t)(link->st_ino & INT64_MAX);
    lock.l_len    = 1;
    return lock;
}

static bool is_alive(const char *name, const struct stat *link)
{
    struct flock lock = lock_of(link);
    const int fd = open(name, O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);

    if (fd < 0)
        return false;
    const bool held = fcntl(fd, F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
    close(fd);
    return held;
}

/* NULL: nothing is there, or it was the link of a machine that is gone, which is removed. Otherwise
 * what is there. */
static const char *clear_link(const char *link)
{
    struct stat info;
    char target[64];

    if (lstat(link, &info) != 0)
        return NULL;
    const ssize_t length = S_ISLNK(info.st_mode) ? readlink(link, target, sizeof target - 1) : -1;
    if (length < 0)
        return "is a file, not a link: give another --link";
    target[length] = '\0';
    if (strncmp(target, "/dev/pts/", 9) != 0)
        return "is a link to something other than a simulated machine: remove it, or give another "
               "--link";
    if (is_alive(target, &info))
        return "another simulated machine has this link: end it, or give another --link";
    unlink(link);
    return NULL;
}

static int make_link(const char *link, const char *name, int slave)
{
    const char *there = clear_link(link);
    struct stat info;

    if (!there && symlink(name, link) == 0 && lstat(link, &info) == 0) {
        struct flock lock = lock_of(&info);
        if (fcntl(slave, F_OFD_SETLK, &lock) == 0)
            return 0;
    }
    fprintf(stderr, "loft: %s: %s%s%s\n", link,
            there ? there : "cannot make this link: ", there ? "" : strerror(errno),
            there ? "" : ": name a place in a folder that exists");
    return EX_CANTCREAT;
}

int host_line_open(struct host_line *l, const char *link, double noise)
{
    struct termios t;
    struct timespec now;

    l->link = l->port = NULL;
    l->slave = -1;
    l->master = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (l->master < 0 || grantpt(l->master) != 0 || unlockpt(l->master) != 0 ||
        ptsname_r(l->master, l->name, sizeof l->name) != 0)
        return report_error("cannot open a pseudo terminal", "/dev/ptmx");
    l->slave = open(l->name, O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (l->slave < 0 || tcgetattr(l->slave, &t) != 0)
        return report_error("cannot open", l->name);
    cfmakeraw(&t);
    if (tcsetattr(l->slave, TCSANOW, &t) != 0 || fcntl(l->master, F_SETFL, O_NONBLOCK) != 0)
        return report_error("cannot be made raw", l->name);
    if (link) {
        const int code = make_link(link, l->name, l->slave);
        if (code)
            return code;
        l->link = link;
    }
    clock_gettime(CLOCK_MONOTONIC, &now);
    l->random = (uint64_t)now.tv_nsec;
    l->flip = (uint32_t)(noise * 1e-6 * 4294967295.0);
    return 0;
}



// A serial port
// -------------

/* Returns NULL, or what failed. */
static const char *open_serial(struct host_line *l)
{
    struct termios t;
    speed_t speed;

    l->master = open(l->port, O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (l->master < 0)
        return "cannot open";
    if (flock(l->master, LOCK_EX | LOCK_NB) != 0)
        return "another program has it";
    if (!host_baud(l->baud, &speed) || tcgetattr(l->master, &t) != 0)
        return "is not a serial port of this speed";
    cfmakeraw(&t);
    cfsetispeed(&t, speed);
    cfsetospeed(&t, speed);
    t.c_cflag |= CLOCAL | CREAD;
    t.c_cflag &= ~(tcflag_t)(HUPCL | CRTSCTS);
    if (tcsetattr(l->master, TCSANOW, &t) != 0)
        return "cannot be made raw";
    return NULL;
}

int host_line_serial(struct host_line *l, const char *port, unsigned baud)
{
    memset(l, 0, sizeof *l);
    l->slave = -1;
    l->port = port;
    l->baud = baud;
    snprintf(l->name, sizeof l->name, "%.63s", port);
    const char *trouble = open_serial(l);
    return trouble ? report_error(trouble, port) : 0;
}

/* A port that hung up is closed, and opened again when it is back. */
static void renew_serial(struct host_line *l, bool gone)
{
    if (gone && l->master >= 0) {
        close(l->master);
        l->master = -1;
    } else if (l->master < 0 && open_serial(l) && l->master >= 0) {
        close(l->master);
        l->master = -1;
    }
}

void host_line_close(struct host_line *l)
{
    char target[sizeof l->name];

    if (l->link) {
        const ssize_t length = readlink(l->link, target, sizeof target);
        if (length == (ssize_t)strlen(l->name) && memcmp(target, l->name, (size_t)length) == 0)
            unlink(l->link);            /* not if somebody made another link of it */
    }
    if (l->slave >= 0)
        close(l->slave);
    if (l->master >= 0)
        close(l->master);
}

static uint32_t random_32(struct host_line *l)          /* splitmix64 (Steele, Lea, Flood 2014) */
{
    uint64_t z = (l->random += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return (uint32_t)(z >> 32);
}

static uint8_t disturbed_byte(struct host_line *l, uint8_t byte)
{
    for (int bit = 0; l->flip && bit < 8; bit++)
        if (random_32(l) < l->flip)
            byte ^= (uint8_t)(1 << bit);
    return byte;
}

size_t host_line_read(struct host_line *l, uint8_t *byte, size_t max)
{
    const ssize_t count = read(l->master, byte, max);

    for (ssize_t i = 0; i < count; i++)
        byte[i] = disturbed_byte(l, byte[i]);
    return count > 0 ? (size_t)count : 0;
}

size_t host_line_write(struct host_line *l, const uint8_t *byte, size_t count)
{
    uint8_t out[256];

    if (count > sizeof out)
        count = sizeof out;
    for (size_t i = 0; i < count; i++)
        out[i] = disturbed_byte(l, byte[i]);
    const ssize_t written = write(l->master, out, count);
    return written > 0 ? (size_t)written : 0;
}

void host_line_poll(struct host_line *l, bool write, int ms, const sigset_t *during,
                    struct pollfd *other, unsigned count)
{
    struct pollfd fd[1 + HOST_LINE_OTHERS] = {
        { .fd = l->master, .events = (short)(POLLIN | (write ? POLLOUT : 0)) }
    };

    if (l->master < 0 && (ms < 0 || ms > AWAY_MS))
        ms = AWAY_MS;
    const struct timespec time = { .tv_sec = ms / 1000, .tv_nsec = ms % 1000 * 1000000L };
    for (unsigned i = 0; i < count && i < HOST_LINE_OTHERS; i++)
        fd[1 + i] = other[i];
    ppoll(fd, 1 + count, ms < 0 ? NULL : &time, during);
    for (unsigned i = 0; i < count && i < HOST_LINE_OTHERS; i++)
        other[i].revents = fd[1 + i].revents;
    if (l->port)
        renew_serial(l, (fd[0].revents & (POLLHUP | POLLERR | POLLNVAL)) != 0);
}

bool host_line_drained(const struct host_line *l)
{
    int left = 0;
    return ioctl(l->slave, FIONREAD, &left) != 0 || left == 0;
}

bool host_line_waits(const struct host_line *l)
{
    int left = 0;
    return ioctl(l->master, FIONREAD, &left) == 0 && left > 0;
}

bool host_line_owned(const struct host_line *l)
{
    struct flock lock = { .l_type = F_WRLCK, .l_whence = SEEK_SET, .l_len = 1 };

    return l->slave >= 0 && fcntl(l->slave, F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
}
