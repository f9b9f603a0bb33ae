/* host-tools/serve/site.c
 * SPDX-License-Identifier: MIT
 */
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "serve/site.h"

#define MOST ((size_t)16 << 20) /* bytes of a file of a folder */

static const char *type_of(const char *name)
{
    static const char *const types[][2] = { { ".html", "text/html; charset=utf-8" },
                                            { ".css", "text/css; charset=utf-8" },
                                            { ".js", "text/javascript; charset=utf-8" },
                                            { ".mjs", "text/javascript; charset=utf-8" },
                                            { ".wasm", "application/wasm" },
                                            { ".svg", "image/svg+xml" },
                                            { ".png", "image/png" } };
    const char *ending = strrchr(name, '.');

    for (size_t i = 0; ending != NULL && i < sizeof types / sizeof types[0]; i++)
        if (strcmp(ending, types[i][0]) == 0)
            return types[i][1];
    return NULL;
}

/* A plain name: it leads to no other folder. */
static bool is_plain(const char *name)
{
    static const char letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                  "0123456789-_.";

    return *name != '\0' && *name != '.' && strspn(name, letters) == strlen(name);
}

static site_answer read_file(const char *folder, const char *name)
{
    site_answer a = { .type = NULL };
    char path[PATH_MAX];

    if (snprintf(path, sizeof path, "%s/%s", folder, name) >= (int)sizeof path)
        return a;
    FILE *in = fopen(path, "rb");
    if (in == NULL)
        return a;
    if (fseek(in, 0, SEEK_END) == 0 && ftell(in) >= 0 && (size_t)ftell(in) <= MOST) {
        a.size = (size_t)ftell(in);
        a.byte = a.own = memory_grow(NULL, a.size);
        rewind(in);
        a.type = fread(a.own, 1, a.size, in) == a.size ? type_of(name) : NULL;
    }
    fclose(in);
    return a;
}

site_answer site_find(const char *folder, const char *path)
{
    const char *name = path + (*path == '/');

    if (*name == '\0')
        name = "index.html";
    if (!is_plain(name) || type_of(name) == NULL)
        return (site_answer){ .type = NULL };
    if (folder != NULL)
        return read_file(folder, name);
    for (const site_file *f = site_files; f->name != NULL; f++)
        if (strcmp(f->name, name) == 0)
            return (site_answer){ .type = type_of(name), .byte = f->byte, .size = f->size };
    return (site_answer){ .type = NULL };
}
