/* ports/linux-gpio/machine_lines.c
 * SPDX-License-Identifier: MIT
 */
#include "linux-gpio/machine_lines.h"

#include <ctype.h>
#include <errno.h>
#include <glob.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sysexits.h>

static int refuse_line(const struct line_wanted *w, int code, const char *trouble, const char *more)
{
    fprintf(stderr, "loft-gpio: %s: %s%s%s: %s%s\n", w->key, w->chip, w->chip[0] ? ":" : "",
            w->line, trouble, more);
    return code;
}

/* Print the remedy for errno. */
static int refuse_by_errno(const struct line_wanted *w, const char *path)
{
    const int error = errno;
    char text[160];

    snprintf(text, sizeof text, "%s: %s%s", path, strerror(error),
             error == EACCES || error == EPERM
                 ? ": join the group that owns it (often gpio), or be root"
             : error == ENOTTY || error == ENODEV
                 ? ": this kernel does not serve this version of libgpiod"
                 : "");
    return refuse_line(w, EX_NOPERM, text, "");
}


// Finding
// -------

/* The chip at a path, opened once; -1 after one line on standard error. */
static int chip_at(struct lines *l, const struct line_wanted *w, const char *path)
{
    for (unsigned i = 0; i < l->chips; i++)
        if (strcmp(l->path[i], path) == 0)
            return (int)i;
    if (l->chips == LINES_CHIPS) {
        refuse_line(w, 0, "the lines are on too many chips", "");
        return -1;
    }
    l->chip[l->chips] = gpio_chip_open(path);
    if (!l->chip[l->chips]) {
        refuse_by_errno(w, path);
        return -1;
    }
    snprintf(l->path[l->chips], sizeof l->path[0], "%.39s", path);
    return (int)l->chips++;
}

/* A second name of a chip is not a second chip. */
static bool is_link(const char *path)
{
    struct stat info;
    return lstat(path, &info) == 0 && S_ISLNK(info.st_mode);
}

static bool has_label(gpio_chip *chip, const char *label)
{
    char is[GPIO_TEXT];
    return gpio_chip_label(chip, is) && strcmp(is, label) == 0;
}

/* Search all chips for a label or, with `line`, for the name of a line. More than one match is as
 * bad as none. */
static bool search_chips(const struct line_wanted *w, const char *label, const char *line,
                         char path[40])
{
    unsigned found = 0, barred = 0;
    glob_t all;

    if (glob("/dev/gpiochip*", 0, NULL, &all) == 0) {
        for (size_t i = 0; i < all.gl_pathc; i++) {
            gpio_chip *chip = is_link(all.gl_pathv[i]) ? NULL : gpio_chip_open(all.gl_pathv[i]);
            barred += !chip && !is_link(all.gl_pathv[i]) && (errno == EACCES || errno == EPERM);
            if (!chip)
                continue;
            if (line ? gpio_chip_find(chip, line) >= 0 : has_label(chip, label)) {
                found++;
                snprintf(path, 40, "%.39s", all.gl_pathv[i]);
            }
            gpio_chip_close(chip);
        }
        globfree(&all);
    }
    if (found == 1)
        return true;
    refuse_line(w, 0,
                found    ? "there are several"
                : barred ? "not among the chips that may be opened: join the group that owns "
                           "/dev/gpiochip* (often gpio), or be root"
                : line   ? "no chip has a line of this name"
                         : "no chip has this label",
                found    ? ": name the chip, as in gpiochip0:LINE"
                : barred ? ""
                         : ": see gpioinfo");
    return false;
}

static bool is_number(const char *text)
{
    return *text && text[strspn(text, "0123456789")] == 0 && strlen(text) < 6;
}

/* Find the chip (its number in `l`) and the line on it. -1 after one line on standard error if
 * there is none. */
static int find_line(struct lines *l, const struct settings *s, const struct line_wanted *w,
                     unsigned *offset)
{
    const char *label = w->chip[0] || !is_number(w->line) ? w->chip : s->chip;
    char path[40];
    int chip, line;

    if (strncmp(label, "/dev/", 5) == 0)
        snprintf(path, sizeof path, "%.39s", label);
    else if (strncmp(label, "gpiochip", 8) == 0 && is_number(label + 8))
        snprintf(path, sizeof path, "/dev/%.30s", label);
    else if (label[0] || !is_number(w->line)) {
        if (!search_chips(w, label, label[0] ? NULL : w->line, path))
            return -1;
    } else {
        refuse_line(w, 0, "a number, but of which chip? Give CHIP:NUMBER, or chip = CHIP", "");
        return -1;
    }
    if ((chip = chip_at(l, w, path)) < 0)
        return -1;
    line = is_number(w->line) ? atoi(w->line) : gpio_chip_find(l->chip[chip], w->line);
    if (line < 0 || (unsigned)line >= gpio_chip_lines(l->chip[chip])) {
        refuse_line(w, 0, path, " has no such line: see gpioinfo");
        return -1;
    }
    *offset = (unsigned)line;
    return chip;
}


// Taking
// ------

/* Refuse a line that is in use. This is checked first, because a request of many lines does not say
 * which is refused. */
static int check_free(struct lines *l, const struct line_wanted *w, int chip, unsigned offset)
{
    char owner[GPIO_TEXT], text[200];

    if (!gpio_chip_owner(l->chip[chip], offset, owner))
        return 0;
    snprintf(text, sizeof text, "%s line %u is in use by \"%s\"", l->path[chip], offset, owner);
    return refuse_line(w, EX_UNAVAILABLE, text, "");
}

static void print_line(struct lines *l, const struct line_wanted *w, int chip, unsigned offset)
{
    char owner[GPIO_TEXT], label[GPIO_TEXT] = "?";

    gpio_chip_label(l->chip[chip], label);
    const bool used = gpio_chip_owner(l->chip[chip], offset, owner);
    printf("%-10s %s line %u of \"%s\"%s, %s%s\n", w->key, l->path[chip], offset, label,
           w->low ? ", active low" : "", used ? "in use by " : "free", used ? owner : "");
}

static int place_line(struct lines *l, const struct settings *s, const struct line_wanted *w,
                      bool look, int *chip, unsigned *offset)
{
    *chip = find_line(l, s, w, offset);
    if (*chip < 0)
        return EX_CONFIG;
    if (look)
        print_line(l, w, *chip, *offset);
    return look ? 0 : check_free(l, w, *chip, *offset);
}

static int place_output(struct lines *l, const struct settings *s, unsigned number, bool look)
{
    const struct line_wanted *w = &s->output[number];
    unsigned offset;
    int chip, code = place_line(l, s, w, look, &chip, &offset);

    if (code)
        return code;
    struct lines_part *p = &l->part[chip];
    for (unsigned i = 0; i < p->count; i++)
        if (p->offset[i] == offset)
            return refuse_line(w, EX_CONFIG, "is the same line as ", s->output[p->bit[i]].key);
    p->offset[p->count] = offset;
    p->bit[p->count++] = (uint8_t)number;
    p->all |= 1u << number;
    if (w->low)
        l->low |= 1u << number;
    return 0;
}

/* Map bits of outputs to bits of the request's lines. */
static uint32_t part_bits(const struct lines_part *p, uint32_t bits)
{
    uint32_t out = 0;

    for (unsigned i = 0; i < p->count; i++)
        out |= (bits >> p->bit[i] & 1) << i;
    return out;
}

static int take_outputs(struct lines *l, const struct settings *s)
{
    for (unsigned i = 0; i < l->chips; i++) {
        struct lines_part *p = &l->part[i];
        if (p->count &&
            !(p->request = gpio_outputs(l->chip[i], p->offset, p->count, part_bits(p, l->low))))
            return refuse_by_errno(&s->output[p->bit[0]], l->path[i]);
    }
    return 0;
}

static int take_input(struct lines *l, const struct settings *s, unsigned number, bool look)
{
    const struct line_wanted *w = &s->input[number];
    unsigned offset;
    int chip, code = place_line(l, s, w, look, &chip, &offset);

    if (code || look)
        return code;
    l->input_low[number] = w->low;
    l->input[number] = gpio_input(l->chip[chip], offset, w->bias, s->debounce_us);
    return l->input[number] ? 0 : refuse_by_errno(w, l->path[chip]);
}

int lines_open(struct lines *l, const struct settings *s, bool look)
{
    int code = 0;

    memset(l, 0, sizeof *l);
    for (unsigned i = 0; code == 0 && i < LINE_OUTPUTS; i++)
        if (s->output[i].key[0])
            code = place_output(l, s, i, look);
    if (code == 0 && !look)
        code = take_outputs(l, s);
    for (unsigned i = 0; code == 0 && i < LINE_INPUTS; i++)
        if (s->input[i].key[0])
            code = take_input(l, s, i, look);
    return code;
}

bool lines_set(struct lines *l, uint32_t which, uint32_t on)
{
    bool good = true;

    for (unsigned i = 0; i < l->chips; i++) {
        struct lines_part *p = &l->part[i];
        if (p->request && p->all & which)
            good &= gpio_set(p->request, part_bits(p, which), part_bits(p, on ^ l->low));
    }
    return good;
}

void lines_close(struct lines *l)
{
    lines_set(l, UINT32_MAX, 0);
    for (unsigned i = 0; i < LINE_INPUTS; i++)
        if (l->input[i])
            gpio_release(l->input[i]);
    for (unsigned i = 0; i < l->chips; i++) {
        if (l->part[i].request)
            gpio_release(l->part[i].request);
        gpio_chip_close(l->chip[i]);
    }
    memset(l, 0, sizeof *l);
}
