/* host-tools/serve/store.c
 * SPDX-License-Identifier: MIT
 */
#include <ctype.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/memory.h"
#include "serve/store.h"

/* The last part of a name, of letters that mean nothing to a shell, a page or a file system. Its
 * ending stays. */
static void clean_name(const char *name, char out[STORE_NAME])
{
    const char *last = strrchr(name, '/');
    size_t used      = 0;

    name = last != NULL ? last + 1 : name;
    const size_t size = strlen(name);
    if (size >= STORE_NAME)
        name += size - STORE_NAME + 1;
    for (; *name != '\0'; name++) {
        const unsigned char c = (unsigned char)*name;
        if (isalnum(c) || (c != '\0' && strchr("-_.,+() ", c) != NULL && used > 0))
            out[used++] = (char)c;
        else
            out[used++] = '_';
    }
    out[used] = '\0';
    if (used == 0)
        strcpy(out, "drawing");
}

static void path_of(const store *s, const char *kind, const char *name, char out[PATH_MAX])
{
    if (snprintf(out, PATH_MAX, "%s/%s%s", s->folder, kind, name) >= PATH_MAX)
        out[0] = '\0';
}

static void upload_path(const store *s, int upload, char out[PATH_MAX])
{
    char number[16];

    snprintf(number, sizeof number, "%d", upload);
    path_of(s, "upload-", number, out);
}


// Options
// -------

/* No option of a page names a file of the server. */
static bool names_file(const planning *p, option_fault *fault)
{
    option_at all[OPTIONS_MOST];
    const size_t count = option_all(planning_rows, all);

    for (size_t i = 0; i < count; i++) {
        const option *o  = all[i].row;
        const void *from = (const char *)p + all[i].offset;
        if ((o->kind != OPTION_IS_FILE && o->kind != OPTION_IS_FOLDER) ||
            *(const char *const *)from == NULL)
            continue;
        *fault = (option_fault){ .name = "option.unknown" };
        snprintf(fault->text, sizeof fault->text,
                 "--%s names a file of the server: begin `loft serve` with it", o->name);
        return true;
    }
    return false;
}

int store_options(store *s, const char *given, option_fault *fault)
{
    char *text        = NULL;
    const char **word = NULL;
    planning p;

    if (strlen(given) >= sizeof s->given) {
        *fault = (option_fault){ .name = "option.words", .text = "the options: give fewer words" };
        return EX_USAGE;
    }
    memset(&p, 0, sizeof p);
    text = strcpy(memory_grow(NULL, strlen(given) + 1), given);
    word = memory_grow(NULL, OPTION_JSON_WORDS * sizeof *word);
    if (options_read_json(planning_rows, text, word, &p, fault) != 0 || names_file(&p, fault)) {
        free(text);
        free(word);
        return EX_USAGE;
    }
    p.file = s->machine;
    (void)planning_start(s->host, &p);
    free(s->text);
    free(s->word);
    s->text = text;
    s->word = word;
    s->how  = p;
    snprintf(s->given, sizeof s->given, "%s", given);
    return 0;
}


// What is kept
// ------------

/* Line 1: the name of the drawing, line 2: its options. */
void store_keep(const store *s)
{
    char path[PATH_MAX], fresh[PATH_MAX];

    path_of(s, "", "kept", path);
    path_of(s, "", "kept-new", fresh);
    FILE *out = fopen(fresh, "w");
    if (out == NULL)
        return;
    fprintf(out, "%s\n%s\n", s->name, s->given);
    if (fclose(out) == 0)
        (void)rename(fresh, path);
}

static void find_kept(store *s)
{
    char path[PATH_MAX], name[STORE_NAME + 2], given[STORE_TEXT + 2];
    option_fault fault;

    path_of(s, "", "kept", path);
    FILE *in = fopen(path, "r");
    if (in == NULL)
        return;
    if (fgets(name, sizeof name, in) != NULL && fgets(given, sizeof given, in) != NULL) {
        name[strcspn(name, "\n")]   = '\0';
        given[strcspn(given, "\n")] = '\0';
        clean_name(name, s->name);
        path_of(s, "drawing-", s->name, s->file);
        if (access(s->file, R_OK) != 0)
            s->file[0] = '\0';
        (void)store_options(s, given, &fault);
    }
    fclose(in);
}

void store_begin(store *s, host *h, const char *folder, const char *machine, size_t most)
{
    option_fault fault;

    *s = (store){ .host = h, .folder = folder, .machine = machine, .most = most };
    (void)store_options(s, "{}", &fault);
    find_kept(s);
}

void store_end(store *s)
{
    for (int i = 0; i < STORE_UPLOADS; i++)
        (void)store_whole(s, i, false);
    free(s->text);
    free(s->word);
}


// Files that come
// ---------------

int store_upload(store *s, const char *name)
{
    char path[PATH_MAX];
    int i = 0;

    while (i < STORE_UPLOADS && (s->upload[i].out != NULL || s->upload[i].whole))
        i++;
    if (i == STORE_UPLOADS)
        return -1;
    upload_path(s, i, path);
    s->upload[i].out = fopen(path, "w");
    if (s->upload[i].out == NULL)
        return -1;
    clean_name(name, s->upload[i].name);
    s->upload[i].size  = 0;
    s->upload[i].whole = false;
    return i;
}

bool store_more(store *s, int upload, const void *bytes, size_t count)
{
    if (upload < 0 || s->upload[upload].out == NULL || count > s->most - s->upload[upload].size)
        return false;
    s->upload[upload].size += count;
    return fwrite(bytes, 1, count, s->upload[upload].out) == count;
}

bool store_whole(store *s, int upload, bool whole)
{
    char path[PATH_MAX];

    if (upload < 0 || (s->upload[upload].out == NULL && !s->upload[upload].whole))
        return false;
    if (s->upload[upload].out != NULL)
        whole = fclose(s->upload[upload].out) == 0 && whole;
    s->upload[upload].out   = NULL;
    s->upload[upload].whole = whole;
    upload_path(s, upload, path);
    if (!whole)
        (void)unlink(path);
    return whole;
}

int store_take(store *s, int upload)
{
    char path[PATH_MAX];

    if (upload < 0 || upload >= STORE_UPLOADS || !s->upload[upload].whole)
        return host_error(s->host, EX_NOINPUT, "serve.upload", (host_place){ NULL, 0 },
                          "send the file first", "no such upload");
    store_drop(s);
    upload_path(s, upload, path);
    snprintf(s->name, sizeof s->name, "%s", s->upload[upload].name);
    path_of(s, "drawing-", s->name, s->file);
    s->upload[upload].whole = false;
    if (rename(path, s->file) != 0) {
        s->file[0] = '\0';
        return host_error(s->host, EX_IOERR, "serve.keep", (host_place){ s->folder, 0 },
                          "give it room", "a drawing cannot be kept: %s", strerror(errno));
    }
    store_keep(s);
    return 0;
}

void store_drop(store *s)
{
    if (s->file[0] != '\0')
        (void)unlink(s->file);
    s->file[0] = s->name[0] = '\0';
    store_keep(s);
}

void store_plain(const store *s, const char *text, char *out, size_t room)
{
    char before[PATH_MAX];
    size_t used = 0;

    path_of(s, "", "drawing-", before);
    const size_t size = strlen(before);
    for (; *text != '\0' && used + 1 < room; text++) {
        if (strncmp(text, before, size) == 0)
            text += size;
        out[used++] = *text;
        if (*text == '\0')
            break;
    }
    out[used < room ? used : room - 1] = '\0';
}
