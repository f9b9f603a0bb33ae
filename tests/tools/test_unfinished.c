/* tests/tools/test_unfinished.c -- a machine that was restarted in a job is not drawn on before it
 * was placed
 * SPDX-License-Identifier: MIT
 */
#include <dirent.h>
#include <stdlib.h>
#include <string.h>
#include <sysexits.h>
#include <unistd.h>

#include "send/unfinished.h"
#include "tools/drawn.h"

#define PORTS 3
#define ALL   7u

static char folder[] = "/tmp/loft-unfinished-XXXXXX";
static char notes[sizeof folder + 8];   /* a folder in it */

/* What is true of a machine. */
typedef struct {
    uint32_t boot;
    bool in_job;
    unsigned doubt;             /* axes that were not placed since it was restarted in a job */
} truth;

static void spell_port(arb *a, unsigned n, char port[100])
{
    static const char *const kinds[] = { "%s/m%u", "%s/../tmp/m%u", "%s/./m%u" };
    char place[60];

    snprintf(place, sizeof place, "%s", n == 0 ? "/tmp" : folder);
    if (n == 2)
        snprintf(port, 100, "tcp:localhost:%u", n);
    else
        snprintf(port, 100, kinds[n == 0 ? arb_below(a, 3) : 2 * arb_below(a, 2)], place, n);
}

static void restart(truth *t)
{
    t->boot++;
    if (t->in_job || t->doubt)
        t->doubt = ALL;
    t->in_job = false;
}

/* Also a job that is under way, after a sender was killed. */
static void want_check(const unfinished_machine *m, truth *t)
{
    const unsigned lines = caught_lines;
    const int code       = unfinished_check(m);

    CHECK(code == (t->doubt ? EX_UNAVAILABLE : 0));
    CHECK(caught_lines == lines + (t->doubt != 0));
    if (t->doubt)
        CHECK(strstr(caught, "position may be lost: home it, or `loft zero") != NULL);
    caught[0] = '\0';
}

static void a_restart_in_a_job_is_not_forgotten(arb *a)
{
    truth all[PORTS];
    char port[100];

    for (unsigned n = 0; n < PORTS; n++) {
        all[n] = (truth){ .boot = arb_below(a, 1000) };
        spell_port(a, n, port);
        unfinished_end(&heard, port);
    }
    for (int k = 0; k < 60; k++) {
        const unsigned n = arb_below(a, PORTS), axes = 1 + arb_below(a, ALL);
        truth *t = &all[n];
        spell_port(a, n, port);
        const unfinished_machine m = { port, t->boot, t->in_job, &heard };
        want_check(&m, t);
        switch (arb_below(a, 4)) {
        case 0:
            if (!t->doubt) {
                unfinished_begin(&m, 1 + arb_below(a, 99), "a\nb.svg");
                t->in_job = true;
            }
            break;
        case 1:
            if (t->in_job && arb_below(a, 2))
                unfinished_end(&heard, port);
            t->in_job = false;          /* or it ended while nobody looked */
            want_check(&(unfinished_machine){ port, t->boot, t->in_job, &heard }, t);
            break;
        case 2:
            if (!t->in_job) {
                unfinished_placed(&m, axes);
                t->doubt &= ~axes;
            }
            break;
        default: restart(t); break;
        }
    }
}

static void a_damaged_record_is_a_doubt(arb *a)
{
    char port[100], name[400], text[200];
    struct dirent *e;
    const unfinished_machine m = { port, 5, false, &heard };

    spell_port(a, 1, port);
    unfinished_begin(&m, 9, "x.svg");
    snprintf(name, sizeof name, "%s/loft", folder);
    DIR *d = opendir(name);
    while (d != NULL && (e = readdir(d)) != NULL) {
        snprintf(name, sizeof name, "%s/loft/%s", folder, e->d_name);
        FILE *f = e->d_name[0] != '.' ? fopen(name, "r+") : NULL;
        if (f == NULL)
            continue;
        const size_t size = fread(text, 1, sizeof text, f), cut = arb_below(a, 60);
        CHECK(size > 60);
        CHECK(ftruncate(fileno(f), (off_t)cut) == 0);
        fclose(f);
    }
    closedir(d);
    truth t = { .boot = 5, .doubt = ALL };
    want_check(&m, &t);
    unfinished_placed(&m, ALL);
    t.doubt = 0;
    want_check(&m, &t);
}

static void without_a_folder_it_says_so(arb *a)
{
    (void)a;
    const unfinished_machine m = { "/tmp/m", 5, false, &heard }, none = { "-", 5, false, &heard };

    heard.state = "/dev/null/loft";
    CHECK(unfinished_check(&m) == 0 && strstr(caught, "set XDG_STATE_HOME") != NULL);
    caught[0] = '\0';
    unfinished_begin(&m, 1, "x");
    unfinished_end(&heard, "/tmp/m");
    CHECK(unfinished_check(&none) == 0 && caught[0] == '\0');
    heard.state = notes;
}

static void remove_folder(void)
{
    char name[400];
    struct dirent *e;

    snprintf(name, sizeof name, "%s/loft", folder);
    DIR *d = opendir(name);
    while (d != NULL && (e = readdir(d)) != NULL) {
        snprintf(name, sizeof name, "%s/loft/%s", folder, e->d_name);
        (void)unlink(name);
    }
    if (d != NULL)
        closedir(d);
    snprintf(name, sizeof name, "%s/loft", folder);
    (void)rmdir(name);
    (void)rmdir(folder);
}

int main(void)
{
    if (mkdtemp(folder) == NULL)
        return EX_OSERR;
    snprintf(notes, sizeof notes, "%s/loft", folder);
    heard.state = notes;
    PROPERTY(a_restart_in_a_job_is_not_forgotten, 20);
    PROPERTY(a_damaged_record_is_a_doubt, 10);
    PROPERTY(without_a_folder_it_says_so, 1);
    remove_folder();
    return check_failures();
}
