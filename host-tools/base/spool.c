/* host-tools/base/spool.c -- arrays that may grow larger than memory
 * SPDX-License-Identifier: MIT
 *
 * The file is mapped, so its pages are not of the process alone: the system writes them to the disk
 * and takes them when it needs memory. Its bytes are allocated before they are mapped: a full disk
 * is reported here, not by SIGBUS at a write.
 */
#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "base/memory.h"    /* memory_grow */
#include "base/spool.h"

#define LONG 0x40000        /* bytes: below, an array stays in memory */

/* Before the elements. */
typedef struct head {
    size_t bytes;           /* with this */
    int file;               /* -1: in memory */
    struct head *before, *after;
} head;

_Static_assert(sizeof(head) % 16 == 0, "elements are aligned as malloc does it");

static head *newest;        /* the last one that began in a file */

/* An array has moved. */
static head *link_up(head *h)
{
    if (h->before != NULL)
        h->before->after = h;
    if (h->after != NULL)
        h->after->before = h;
    else
        newest = h;
    return h;
}

static void unlink_from(const head *h)
{
    if (h->before != NULL)
        h->before->after = h->after;
    if (h->after != NULL)
        h->after->before = h->before;
    else
        newest = h->before;
}

static int nameless_file(void)
{
    const char *folder = getenv("TMPDIR");
    char name[4096];

    if ((size_t)snprintf(name, sizeof name, "%s/loft-XXXXXX",
                         folder != NULL && *folder != '\0' ? folder : "/var/tmp") >= sizeof name)
        return -1;
    const int file = mkostemp(name, O_CLOEXEC);
    if (file >= 0)
        (void)unlink(name);
    return file;
}

static void release(head *h)
{
    const int file = h->file;

    if (file < 0) {
        free(h);
        return;
    }
    unlink_from(h);
    (void)munmap(h, h->bytes);
    (void)close(file);
}

/* An array in a file; NULL: there is none. */
static head *begin(size_t bytes)
{
    const int file = nameless_file();
    head *h        = MAP_FAILED;

    if (file >= 0 && posix_fallocate(file, 0, (off_t)bytes) == 0)
        h = mmap(NULL, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (h == MAP_FAILED) {
        if (file >= 0)
            (void)close(file);
        return NULL;
    }
    *h = (head){ .bytes = bytes, .file = file, .before = newest };
    return link_up(h);
}

static head *lengthen(head *h, size_t bytes)
{
    if (posix_fallocate(h->file, 0, (off_t)bytes) != 0)
        return NULL;
    head *now = mremap(h, h->bytes, bytes, MREMAP_MAYMOVE);
    return now == MAP_FAILED ? NULL : link_up(now);
}

static head *copied(head *to, head *from, size_t bytes)
{
    if (from == NULL)
        return to;
    memcpy(to + 1, from + 1, (from->bytes < bytes ? from->bytes : bytes) - sizeof *to);
    release(from);
    return to;
}

void *spool_grow(void *spool, size_t bytes)
{
    const size_t all = bytes + sizeof(head);
    head *h = spool == NULL ? NULL : (head *)spool - 1, *now = NULL;

    if (h != NULL && h->file >= 0)
        now = lengthen(h, all);
    else if (all >= LONG && (now = begin(all)) != NULL)
        now = copied(now, h, all);
    if (now == NULL) {
        const bool held = h != NULL && h->file < 0;
        now = memory_grow(held ? h : NULL, all);
        now->file = -1;
        if (!held)
            now = copied(now, h, all);
    }
    now->bytes = all;
    return now + 1;
}

void spool_free(void *spool)
{
    if (spool != NULL)
        release((head *)spool - 1);
}

void spool_rest(void)
{
    for (head *h = newest, *before; h != NULL; h = before) {
        before = h->before;
        (void)madvise(h, h->bytes, MADV_DONTNEED);
    }
}
