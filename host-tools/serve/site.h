/* host-tools/serve/site.h -- the page: files of the program, or of a folder
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_SITE_H
#define LOFT_SITE_H

#include <stdbool.h>
#include <stddef.h>

/* Made by `make page`, then `make tools` (page/embed.sh); ends with { NULL }. */
typedef struct {
    const char *name;
    const unsigned char *byte;  /* packed by gzip */
    size_t size;
} site_file;
extern const site_file site_files[];

/* What is answered. */
typedef struct {
    const char *type;           /* NULL: there is no such file */
    const unsigned char *byte;
    size_t size;
    unsigned char *own;         /* to be freed, or NULL */
} site_answer;

/* The file of a path, "/" is index.html; `folder` NULL: of the program. */
site_answer site_find(const char *folder, const char *path);

#endif
