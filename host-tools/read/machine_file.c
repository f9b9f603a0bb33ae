/* host-tools/read/machine_file.c -- reads machines: `key = value` lines, and grbl's `$` numbers;
 * MACHINE.md lists them
 * SPDX-License-Identifier: MIT
 */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "read/machine_file.h"
#include "base/near.h"         /* near_try */
#include "base/scan.h"           /* scan_number, scan_space */
#include "base/source.h"         /* source_read */
#include "base/host.h"

/* A key, its range, and the field that it sets. Keys of axes have the prefix x, y or z, or none for
 * all axes. */
typedef struct {
    const char *key, *unit;
    size_t at;
    bool   axes, whole, limits;
    double least, most;
    const char *of;             /* the kinematics that have it, as "delta or polar"; NULL: all */
    const char *word[2];        /* the value is one of these, as 0 and 1 */
} row;

#define AT(field) offsetof(machine_file, field)
#define HOME_SEARCH 1.1     /* times travel */

static const row rows[] = {
    { "steps_per_mm", "steps/mm", AT(steps_per_mm), true, false, false, 0.01, 30000, NULL, { 0 } },
    { "max_speed", "mm/s", AT(max_speed), true, false, true, 1 / 64.0, 16383, NULL, { 0 } },
    { "max_accel", "mm/s^2", AT(max_accel), true, false, true, 1, 16383, NULL, { 0 } },
    { "max_jerk", "mm/s^3", AT(max_jerk), true, false, true, 0, 1e7, NULL, { 0 } },
    { "corner", "mm", AT(corner), false, false, false, 0, 1, NULL, { 0 } },
    { "tolerance", "mm", AT(tol), false, false, false, 1 / 1024.0, 1, NULL, { 0 } },
    { "travel", "mm", AT(travel), true, false, false, 0, 16383, NULL, { 0 } },
    { "min", "mm", AT(min), true, false, false, -16383, 16383, NULL, { 0 } },
    { "zero", "mm", AT(zero), true, false, false, -16383, 16383, NULL, { 0 } },
    { "home_order", "", AT(home_order), true, true, false, 0, 3, NULL, { 0 } },
    { "home_end", "", AT(home_end), true, true, false, 0, 1, NULL, { "low", "high" } },
    { "home_at", "mm", AT(home_at), true, false, false, -16383, 16383, NULL, { 0 } },
    { "home_seek", "mm/s", AT(home_seek), true, false, false, 1 / 64.0, 1000, NULL, { 0 } },
    { "home_touch", "mm/s", AT(home_touch), true, false, false, 1 / 64.0, 1000, NULL, { 0 } },
    { "home_back", "mm", AT(home_back), true, false, false, 0.01, 100, NULL, { 0 } },
    { "home_search", "mm", AT(home_search), true, false, false, 0, 16383, NULL, { 0 } },
    { "square", "", AT(square), true, true, false, 0, 1, NULL, { "no", "yes" } },
    { "limit_stop", "", AT(hard_stop), false, true, false, 0, 1, NULL, { "ramp", "hard" } },
    { "park", "mm", AT(park), true, false, false, -16383, 16383, NULL, { 0 } },
    { "reversed", "", AT(reversed), true, true, false, 0, 1, NULL, { "no", "yes" } },
    { "limit", "", AT(limit_opens), true, true, false, 0, 1, NULL, { "closes", "opens" } },
    { "probe", "", AT(probe_opens), false, true, false, 0, 1, NULL, { "closes", "opens" } },
    { "buttons", "", AT(buttons_open), false, true, false, 0, 1, NULL, { "closes", "opens" } },
    { "drive", "", AT(drive), true, true, false, 0, 1, NULL, { "step", "servo" } },
    { "servo_zero", "us", AT(servo_zero), false, true, false, 10, 2550, NULL, { 0 } },
    { "idle", "s", AT(idle), false, true, false, 0, 254, NULL, { 0 } },
    { "pulse", "us", AT(pulse), false, true, false, 1, 254, NULL, { 0 } },
    { "pen_up", "mm", AT(pen_up), false, false, false, -16383, 16383, NULL, { 0 } },
    { "pen_down", "mm", AT(pen_down), false, false, false, -16383, 16383, NULL, { 0 } },
    { "s_max", "of S", AT(s_max), false, false, false, 1, 1e6, NULL, { 0 } },
    { "spin_up", "s", AT(spin_up), false, false, false, 0, 600, NULL, { 0 } },
    { "laser", "", AT(laser), false, true, false, 0, 1, NULL, { "no", "yes" } },
    { "tick_hz", "ticks/s", AT(tick_hz), false, true, false, 50, 50000, NULL, { 0 } },
    { "slots", "per tick", AT(slots), false, true, false, 1, 4096, NULL, { 0 } },
    { "ramp", "ticks", AT(ramp), false, true, false, 1, 32767, NULL, { 0 } },
    { "queue", "items", AT(queue), false, true, false, 2, 32768, NULL, { 0 } },
    { "curves", "curves", AT(curves), false, true, false, 0, 4096, NULL, { 0 } },
    { "center", "mm", AT(k.center), true, false, false, -8191, 8191, "delta or polar", { 0 } },
    { "arm_length", "mm", AT(k.arm_length), false, false, false, 1, 8191, "delta", { 0 } },
    { "delta_radius", "mm", AT(k.delta_radius), false, false, false, 1, 8191, "delta", { 0 } },
    { "tower_angle", "degrees", AT(k.tower_angle), true, false, false, -360, 360, "delta", { 0 } },
    { "turn", "per turn", AT(k.turn), false, false, false, 6, 8191, "polar", { 0 } },
    { "inside", "mm", AT(k.inside), false, false, false, 0.01, 1000, "polar", { 0 } },
};
#define ROWS (sizeof rows / sizeof rows[0])

/* grbl 1.1: `$100=250.000`. Rates are in mm/min. Numbers that do not affect a plan are skipped. */
static const struct {
    int number;
    const char *key;
    int axis;
    double unit;
} grbl[] = {
    { 11, "corner", -1, 1 },
    { 100, "steps_per_mm", 0, 1 },
    { 101, "steps_per_mm", 1, 1 },
    { 102, "steps_per_mm", 2, 1 },
    { 110, "max_speed", 0, 1 / 60.0 },
    { 111, "max_speed", 1, 1 / 60.0 },
    { 112, "max_speed", 2, 1 / 60.0 },
    { 120, "max_accel", 0, 1 },
    { 121, "max_accel", 1, 1 },
    { 122, "max_accel", 2, 1 },
    { 130, "travel", 0, 1 },
    { 131, "travel", 1, 1 },
    { 132, "travel", 2, 1 },
    { 24, "home_touch", -1, 1 / 60.0 },
    { 25, "home_seek", -1, 1 / 60.0 },
    { 27, "home_back", -1, 1 },
    { 30, "s_max", -1, 1 },
    { 32, "laser", -1, 1 },
};

typedef struct {
    host *host;
    machine_file *m;
    const char *file;
    unsigned line, named;                   /* the line that gave the kinematics; 0: none */
    unsigned said[ROWS][1 + ENGINE_AXES];   /* the line of each key: for all axes, for x, y, z */
} reading;

machine_file machine_usual(void)
{
    machine_file m = { .tol = 0.005,
                       .pen_up = 1,
                       .idle = -1,
                       .pulse = -1,
                       .drive = { -1, -1, -1 },
                       .servo_zero = -1,
                       .s_max = 1000,
                       .tick_hz = 1000,
                       .slots = 40,
                       .ramp = 100,
                       .queue = 256,
                       .curves = 64,
                       .k = kinematics_usual() };

    for (int i = 0; i < ENGINE_AXES; i++) {
        m.steps_per_mm[i] = 80;
        m.max_speed[i] = 500;
        m.max_accel[i] = 2000;
        m.max_jerk[i] = -1;
        m.home_at[i] = NAN;
        m.home_seek[i] = 20;
        m.home_touch[i] = 2;
        m.home_back[i] = 3;
    }
    return m;
}

static const row *find_row(const char *key, size_t length)
{
    for (size_t i = 0; i < ROWS; i++)
        if (strlen(rows[i].key) == length && strncmp(rows[i].key, key, length) == 0)
            return &rows[i];
    return NULL;
}

/* A key may be given once. The key for all axes comes before those for one axis. */
static int check_given_once(reading *r, const row *k, int axis)
{
    unsigned *said = r->said[k - rows], *mine = &said[1 + axis];

    for (int i = 0; i <= ENGINE_AXES; i++)
        if (said[i] > 0 && (i == 1 + axis || (axis < 0 && k->axes)))
            return host_error(r->host, EX_DATAERR, "machine.key-twice",
                              (host_place){ r->file, r->line },
                              i == 1 + axis ? "remove one" : "put what holds for all axes first",
                              "%s is given in line %u already", k->key, said[i]);
    *mine = r->line;
    return 0;
}

static int set_value(reading *r, const row *k, int axis, double value)
{
    double *to = (double *)((char *)r->m + k->at);

    if (!(value >= k->least && value <= k->most) || (k->whole && value != floor(value)))
        return host_error(
            r->host, EX_DATAERR, "machine.value-range", (host_place){ r->file, r->line },
            HOST_REMEDY("give %s from %.10g to %.10g %s", k->whole ? "a whole number" : "a number",
                        k->least, k->most, k->unit),
            "%s is %.10g", k->key, value);
    for (int i = 0; i < (k->axes ? ENGINE_AXES : 1); i++)
        if (axis < 0 || axis == i)
            to[i] = value;
    r->m->limited = r->m->limited || k->limits;
    return check_given_once(r, k, axis);
}

/* After a number there may be nothing, a comment, or the remark in parentheses that grbl prints. */
static bool number_ends(const char *s)
{
    s += strspn(s, " \t\r");
    return *s == '\0' || *s == '\n' || *s == '#' || *s == '(';
}

static int read_grbl(reading *r, const char *s)
{
    double number, value;

    s++;
    if (!scan_number(&s, &number) || *s++ != '=' || !scan_number(&s, &value) || !number_ends(s))
        return host_error(r->host, EX_DATAERR, "machine.grbl-setting",
                          (host_place){ r->file, r->line }, "give lines such as $100=250.000",
                          "not a setting of grbl");
    for (size_t i = 0; i < sizeof grbl / sizeof grbl[0]; i++)
        if (grbl[i].number == number)
            return set_value(r, find_row(grbl[i].key, strlen(grbl[i].key)), grbl[i].axis,
                             value * grbl[i].unit);
    return 0;
}

static int unknown_key(const reading *r, const char *s, size_t length)
{
    const char *dot = memchr(s, '.', length), *key = dot != NULL && dot == s + 1 ? dot + 1 : s;
    near_words near = { .word = key, .length = length - (size_t)(key - s) };
    char meant[160];

    near_try(&near, "kinematics");
    for (size_t i = 0; i < ROWS; i++)
        near_try(&near, rows[i].key);
    return host_error(r->host, EX_DATAERR, "machine.key-unknown", (host_place){ r->file, r->line },
                      "host-tools/MACHINE.md has all", "unknown key \"%.*s\"%s",
                      (int)(length < 30 ? length : 30), s, near_text(&near, "", meant));
}

static int unknown_kinematics(const reading *r)
{
    char names[KINEMATICS_NAMES];

    kinematics_names(names);
    return host_error(r->host, EX_DATAERR, "machine.kinematics", (host_place){ r->file, r->line },
                      NULL, "write kinematics = %s", names);
}

/* `s` is after the key. */
static int read_kinematics(reading *r, const char *s)
{
    s += strspn(s, " \t");
    const char *word = *s == '=' ? s + 1 + strspn(s + 1, " \t") : s;
    const size_t length = strcspn(word, " \t\r\n#");

    if (r->named > 0)
        return host_error(r->host, EX_DATAERR, "machine.kinematics-twice",
                          (host_place){ r->file, r->line }, "remove one",
                          "kinematics is given in line %u already", r->named);
    if (word == s || !number_ends(word + length) || !kinematics_find(&r->m->k, word, length))
        return unknown_kinematics(r);
    r->named = r->line;
    return 0;
}

/* Axis 0 to 2 of `x.` or, by its motor, `a.`; -1: neither. */
static int axis_of(const char *s, size_t length)
{
    const char *at = length > 2 && s[1] == '.' ? strchr("xyzabc", tolower((unsigned char)s[0]))
                                               : NULL;

    return at ? (int)(strchr("xyzabc", *at) - "xyzabc") % ENGINE_AXES : -1;
}

/* The value of a key that is a word. `s` is after `=`. */
static int read_word(reading *r, const row *k, int axis, const char *s)
{
    const size_t length = strcspn(s, " \t\r\n#");

    for (int i = 0; i < 2; i++)
        if (strlen(k->word[i]) == length && strncmp(s, k->word[i], length) == 0 &&
            number_ends(s + length))
            return set_value(r, k, axis, i);
    return host_error(r->host, EX_DATAERR, "machine.word", (host_place){ r->file, r->line }, NULL,
                      "write %s = %s, or %s", k->key, k->word[0], k->word[1]);
}

static int read_key(reading *r, const char *s)
{
    const size_t length = strcspn(s, " \t\r\n=#");
    const int axis      = axis_of(s, length);
    const bool named    = axis >= 0;
    const row *k        = find_row(named ? s + 2 : s, named ? length - 2 : length);
    double value;

    if (strncmp(s, "tool.", 5) == 0)
        return machine_tools_line(r->host, &r->m->tools, r->file, r->line, s);
    if (length == 10 && strncmp(s, "kinematics", 10) == 0)
        return read_kinematics(r, s + length);
    if (k == NULL || (named && !k->axes))
        return unknown_key(r, s, length);
    s += length;
    s += strspn(s, " \t");
    if (*s != '=')
        return host_error(r->host, EX_DATAERR, "machine.no-equals",
                          (host_place){ r->file, r->line },
                          HOST_REMEDY("write %s = %g", k->key, k->least > 1 ? k->least : 1),
                          "no `=` behind %s", k->key);
    s++;
    s += strspn(s, " \t");
    if (k->word[0])
        return read_word(r, k, axis, s);
    if (!scan_number(&s, &value) || !number_ends(s))
        return host_error(r->host, EX_DATAERR, "machine.not-a-number",
                          (host_place){ r->file, r->line }, HOST_REMEDY("give one in %s", k->unit),
                          "%s is not a number", k->key);
    return set_value(r, k, axis, value);
}



// What must fit together
// ----------------------

/* The line that gave a key; 0: it was not given. */
static unsigned line_of(const reading *r, size_t key)
{
    unsigned line = 0;

    for (int i = 0; i <= ENGINE_AXES; i++)
        line = r->said[key][i] > line ? r->said[key][i] : line;
    return line;
}

/* True if a machine of these kinematics has the key. No name is a part of another. */
static bool has_key(const kinematics *k, const row *key)
{
    return key->of == NULL || strstr(key->of, kinematics_name(k)) != NULL;
}

/* Refuse keys of other kinematics: they would have no effect. */
static int check_keys(const reading *r)
{
    for (size_t i = 0; i < ROWS; i++)
        if (line_of(r, i) > 0 && !has_key(&r->m->k, &rows[i]))
            return host_error(r->host, EX_DATAERR, "machine.key-of-other",
                              (host_place){ r->file, line_of(r, i) }, "remove one of them",
                              "%s is for kinematics = %s, and this machine is %s", rows[i].key,
                              rows[i].of, kinematics_name(&r->m->k));
    return 0;
}

/* Refuse the low end of a table without a size: it would have no effect. */
static int check_table(const reading *r)
{
    const unsigned line = line_of(r, (size_t)(find_row("min", 3) - rows));
    const double *min   = r->m->min;

    for (int i = 0; i < ENGINE_AXES; i++)
        if (min[i] != 0 && !(r->m->travel[i] > 0))
            return host_error(r->host, EX_DATAERR, "machine.table-no-size",
                              (host_place){ r->file, line },
                              HOST_REMEDY("give %c.travel in mm", "xyz"[i]),
                              "%c.min is %g, but the table has no size there", "xyz"[i], min[i]);
    return 0;
}

/* A machine has pins for one servo. */
static int check_drive(const reading *r)
{
    for (int i = 0; i < 2; i++)
        if (r->m->drive[i] > 0)
            return host_error(
                r->host, EX_DATAERR, "machine.servo-axis",
                (host_place){ r->file, line_of(r, (size_t)(find_row("drive", 5) - rows)) },
                "write z.drive = servo", "%c.drive = servo: only z can be one", "xy"[i]);
    return 0;
}

static int check_geometry(const reading *r)
{
    kinematics_fault why;

    if (!kinematics_faulty(&r->m->k, &why))
        return 0;
    const unsigned line = why.key ? line_of(r, (size_t)(find_row(why.key, strlen(why.key)) - rows))
                                  : 0;
    return host_error(r->host, EX_DATAERR, "machine.geometry",
                      (host_place){ r->file, line > 0 ? line : r->named }, NULL, "%s", why.text);
}

/* Both motors of a CoreXY move x and y, so both have one limit, the smaller one. It holds for
 * the motors, and for the tool along x and along y, whichever was meant
 * (lib/kinematics/kinematics.h). */
static void share_limits(machine_file *m)
{
    double *const of[] = { m->max_speed, m->max_accel }, *jerk = m->max_jerk;

    for (size_t i = 0; i < sizeof of / sizeof of[0]; i++)
        of[i][0] = of[i][1] = fmin(of[i][0], of[i][1]);
    jerk[0] = jerk[1] = (jerk[0] > 0) != (jerk[1] > 0) ? fmax(jerk[0], jerk[1])
                                                       : fmin(jerk[0], jerk[1]);
}

static int check_machine(const reading *r)
{
    int code = check_keys(r);

    if (code == 0)
        code = check_table(r);
    if (code == 0)
        code = check_drive(r);
    if (code == 0)
        code = check_geometry(r);
    if (code == 0 && r->m->k.kind->paired)
        share_limits(r->m);
    kinematics_ready(&r->m->k);
    return code;
}

int machine_line(host *h, machine_file *m, const char *file, unsigned line, const char *text)
{
    reading r = { .host = h, .m = m, .file = file, .line = line };

    return read_key(&r, text);
}

int machine_text(host *h, machine_file *m, const char *name, const char *text)
{
    reading r = { .host = h, .m = m, .file = name, .line = 1 };
    int code  = 0;

    for (const char *s = text; *s != '\0' && code == 0; r.line++) {
        const char *first = s + strspn(s, " \t\r");
        if (*first == '$')
            code = read_grbl(&r, first);
        else if (*first != '#' && *first != '\n' && *first != '\0')
            code = read_key(&r, first);
        s += strcspn(s, "\n");
        s += *s == '\n';
    }
    return code ? code : check_machine(&r);
}

int machine_read(host *h, machine_file *m, const char *file)
{
    size_t size;
    int code   = 0;
    char *text = source_read(h, file, &size, &code);

    if (text == NULL)
        return code;
    if (source_is_xml(text)) {
        free(text);
        return host_error(h, EX_DATAERR, "machine.not-text", (host_place){ source_name(file), 0 },
                          "--machine takes lines `key = value`, see host-tools/MACHINE.md",
                          "is a drawing or a page");
    }
    code = strlen(text) == size
               ? machine_text(h, m, source_name(file), text)
               : host_error(h, EX_DATAERR, "machine.not-text", (host_place){ source_name(file), 0 },
                            "lines `key = value` are expected, see host-tools/MACHINE.md",
                            "is not text");
    free(text);
    return code;
}


// Who keeps what
// --------------

static enum machine_keeper keeper_of(const row *k)
{
    static const struct {
        const char *key;
        enum machine_keeper of;
    } others[] = {
        { "steps_per_mm", MACHINE_OBEYS }, { "max_speed", MACHINE_OBEYS },
        { "max_accel", MACHINE_OBEYS },    { "max_jerk", MACHINE_OBEYS },
        { "reversed", MACHINE_OBEYS },     { "limit", MACHINE_OBEYS },
        { "probe", MACHINE_OBEYS },        { "buttons", MACHINE_OBEYS },
        { "idle", MACHINE_OBEYS },         { "pulse", MACHINE_OBEYS },
        { "drive", MACHINE_OBEYS },        { "servo_zero", MACHINE_OBEYS },
        { "tick_hz", MACHINE_FIRMWARE },   { "slots", MACHINE_FIRMWARE },
        { "ramp", MACHINE_FIRMWARE },      { "queue", MACHINE_FIRMWARE },
        { "curves", MACHINE_FIRMWARE },    { "corner", MACHINE_PLAN },
        { "tolerance", MACHINE_PLAN },
    };

    for (size_t i = 0; i < sizeof others / sizeof others[0]; i++)
        if (strcmp(others[i].key, k->key) == 0)
            return others[i].of;
    return MACHINE_TEXT;
}

static const double *values_of(const machine_file *m, const row *k)
{
    return (const double *)((const char *)m + k->at);
}

/* The shortest number that is read as this one again. */
static void print_value(const row *k, double value, FILE *out)
{
    char text[40];

    if (k->word[0]) {
        fprintf(out, "%s\n", k->word[value > 0]);
        return;
    }
    for (int digits = 9; digits <= 17; digits++) {
        snprintf(text, sizeof text, "%.*g", digits, value);
        if (strtod(text, NULL) == value)
            break;
    }
    fprintf(out, "%s\n", text);
}

/* Neither NAN nor, where that is not a value, below the range: it was given. */
static bool value_given(const row *k, double value) { return value >= k->least; }

static bool same_value(double a, double b) { return a == b || (isnan(a) && isnan(b)); }

static void print_row(const row *k, const double *value, const double *usual, FILE *out)
{
    const bool alike = !k->axes ||
                       (same_value(value[0], value[1]) && same_value(value[0], value[2]));

    for (int i = 0; i < (alike ? 1 : ENGINE_AXES); i++)
        if (value_given(k, value[i]) && (usual == NULL || !same_value(value[i], usual[i]))) {
            if (!alike)
                fprintf(out, "%c.", "xyz"[i]);
            fprintf(out, "%s = ", k->key);
            print_value(k, value[i], out);
        }
}

void machine_print(const machine_file *m, enum machine_keeper of, FILE *out)
{
    const machine_file usual = machine_usual();

    if (of == MACHINE_TEXT && m->k.kind != usual.k.kind)
        fprintf(out, "kinematics = %s\n", kinematics_name(&m->k));
    for (size_t i = 0; i < ROWS; i++)
        if (keeper_of(&rows[i]) == of && has_key(&m->k, &rows[i]))
            print_row(&rows[i], values_of(m, &rows[i]),
                      of == MACHINE_TEXT ? values_of(&usual, &rows[i]) : NULL, out);
}

const char *machine_differs(const machine_file *a, const machine_file *b, enum machine_keeper of)
{
    for (size_t i = 0; i < ROWS; i++)
        for (int k = 0; k < (rows[i].axes ? ENGINE_AXES : 1); k++)
            if (keeper_of(&rows[i]) == of &&
                !same_value(values_of(a, &rows[i])[k], values_of(b, &rows[i])[k]))
                return rows[i].key;
    return NULL;
}

double machine_home_at(const machine_file *m, int axis)
{
    const double out = m->home_back[axis];
    const double end = m->home_end[axis] > 0 ? m->min[axis] + m->travel[axis] + out
                                             : m->min[axis] - out;

    return (isnan(m->home_at[axis]) ? end : m->home_at[axis]) - m->zero[axis];
}

double machine_home_search(const machine_file *m, int axis)
{
    if (m->home_search[axis] > 0 || !(m->travel[axis] > 0))
        return m->home_search[axis];
    return HOME_SEARCH * m->travel[axis] + 2 * m->home_back[axis];
}

void machine_limit(const machine_file *m, engine_limits *limits)
{
    for (int i = 0; i < ENGINE_AXES; i++) {
        limits->max_speed[i] = fmin(limits->max_speed[i], m->max_speed[i]);
        limits->max_accel[i] = fmin(limits->max_accel[i], m->max_accel[i]);
    }
}
