/* tests/tools/test_drawing.c -- detection of formats, curves as numbers, lengths and boxes; and the
 * drawing of the demo
 * SPDX-License-Identifier: MIT
 */
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include "tools/drawn.h"
#include "readers.h"
#include "read/drawing_curves.h"

static char folder[] = "/tmp/loft-drawing-XXXXXX";

/* Write `size` bytes to a file, read it as a drawing, remove it. */
static int read_bytes(drawing *d, const void *bytes, size_t size)
{
    char name[64];

    snprintf(name, sizeof name, "%s/f", folder);
    FILE *f = fopen(name, "wb");
    CHECK(f != NULL && fwrite(bytes, 1, size, f) == size && fclose(f) == 0);
    hear();
    *d = (drawing){ 0 };
    const int code = drawing_read(&heard, d, name);
    remove(name);
    return code;
}

static void check_refused(const char *bytes, size_t size, const char *words, int line)
{
    drawing d;
    const int code = read_bytes(&d, bytes, size);

    if (code != EX_DATAERR || caught_lines != 1 || strstr(caught, words) == NULL) {
        printf("line %d: code %d, %u lines: %s\n  wanted: %s\n", line, code, caught_lines, caught,
               words);
        check_bad = true;
    }
    drawing_free(&d);
}
#define REFUSES_FILE(bytes, words) check_refused(bytes, sizeof bytes - 1, words, __LINE__)

static void files_are_told_apart_by_content(arb *a)
{
    drawing d;
    (void)a;
    CHECK(read_bytes(&d, PAGE("<path d='M1 1h1'/>"), sizeof PAGE("<path d='M1 1h1'/>") - 1) == 0 &&
          d.count == 1 && d.width > 99.9);
    drawing_free(&d);
    CHECK(read_bytes(&d, "\xEF\xBB\xBF<?xml version='1.0'?>" PAGE("<path d='M1 1h1'/>"),
                     sizeof "\xEF\xBB\xBF<?xml version='1.0'?>" PAGE("<path d='M1 1h1'/>") - 1) ==
          0);
    drawing_free(&d);
    CHECK(read_bytes(&d, "0,0,1,1,2,1,3,0\n", 16) == 0 && d.count == 1 && d.width == 0);
    drawing_free(&d);
    REFUSES_FILE("", "is empty");
    REFUSES_FILE(" \n\t\n", "is empty");
    REFUSES_FILE("\xEF\xBB\xBF \n", "nothing to draw");
    REFUSES_FILE("1,2\0\1\2\3", "is not text");
    REFUSES_FILE("hello world\n", "neither SVG nor CSV");
    REFUSES_FILE("# only a comment\n", "nothing to draw");
    REFUSES_FILE(PAGE(""), "nothing to draw");
}

/* Files of other programs are named, with what to do; files that only look like them are read. */
static void files_of_other_programs_are_named(arb *a)
{
    drawing d;
    (void)a;
    REFUSES_FILE("  0\r\nSECTION\r\n  2\r\nHEADER\r\n", "is DXF: convert it, as with `inkscape");
    REFUSES_FILE("999\nmade by x\n0\nSECTION\n2\nENTITIES\n", "is DXF");
    REFUSES_FILE("AutoCAD Binary DXF\r\n\x1A\0", "is DXF");
    REFUSES_FILE("IN;SP1;PU0,0;PD100,100;", "is HP-GL: convert it");
    REFUSES_FILE("PU 0 0\nPD 100 100\n", "is HP-GL");
    REFUSES_FILE("\x1B%-1BIN;", "is HP-GL");
    REFUSES_FILE("%PDF-1.5\n", "is PDF: convert it");
    REFUSES_FILE("%!PS-Adobe-3.0 EPSF-3.0\n", "is PostScript: convert it, as with `pstoedit");
    REFUSES_FILE("AC1027\0\0", "is DWG");
    REFUSES_FILE("\x89PNG\r\n\x1A\n\0\0", "is a PNG picture: trace it");
    REFUSES_FILE("\xFF\xD8\xFF\xE0", "is a JPEG picture");
    REFUSES_FILE("II*\0\1", "is a TIFF picture");
    REFUSES_FILE("PK\3\4\0\0", "is a ZIP archive");
    REFUSES_FILE("BZh9", "compressed with bzip2: unpack it first");
    CHECK(read_bytes(&d, "0\n0,0,1,1,2,1,3,0\n", 18) != 0 && strstr(caught, "DXF") == NULL);
    drawing_free(&d);
    CHECK(read_bytes(&d, "0,0,1,1,2,1,3,0\n", 16) == 0);
    drawing_free(&d);
}

/* As for .svgz: every file that is packed with gzip is unpacked; half of a file is refused. */
static void packed_files_are_unpacked(arb *a)
{
    static const char text[] = PAGE("<path d='M1 1h1'/>");
    char name[64], packed[1000];
    drawing d;
    (void)a;
    snprintf(name, sizeof name, "%s/z", folder);
    gzFile z = gzopen(name, "wb");
    CHECK(z != NULL && gzwrite(z, text, sizeof text - 1) == (int)sizeof text - 1 &&
          gzclose(z) == Z_OK);
    FILE *f = fopen(name, "rb");
    const size_t size = fread(packed, 1, sizeof packed, f);
    fclose(f);
    remove(name);
    CHECK(size > 20 && memcmp(packed, "\x1F\x8B", 2) == 0);
    CHECK(read_bytes(&d, packed, size) == 0 && d.count == 1 && d.width > 99.9);
    drawing_free(&d);
    check_refused(packed, size - 20, "is compressed, and damaged or cut off", __LINE__);
    packed[size - 6] = (char)(packed[size - 6] ^ 1);        /* of the checksum */
    check_refused(packed, size, "is compressed, and damaged or cut off", __LINE__);
    REFUSES_FILE("\x1F\x8B\x08", "is compressed, and damaged or cut off");
}

/* A small file that unpacks to a large one is refused before all of it is in memory. */
static void what_unpacks_to_too_much_is_refused(arb *a)
{
    static const char text[] = "<svg xmlns='http://www.w3.org/2000/svg'>";
    static char packed[400000], blank[1 << 20];
    char name[64];
    (void)a;
    memset(blank, ' ', sizeof blank);
    snprintf(name, sizeof name, "%s/z", folder);
    gzFile z = gzopen(name, "wb");
    CHECK(z != NULL && gzwrite(z, text, sizeof text - 1) == (int)sizeof text - 1);
    for (int i = 0; i < 100; i++)
        CHECK(gzwrite(z, blank, sizeof blank) == (int)sizeof blank);
    CHECK(gzclose(z) == Z_OK);
    FILE *f = fopen(name, "rb");
    const size_t size = fread(packed, 1, sizeof packed, f);
    fclose(f);
    remove(name);
    check_refused(packed, size, "unpacks to more than 400 times its size", __LINE__);
}

static void files_that_cannot_be_read(arb *a)
{
    drawing d = { 0 };
    (void)a;
    caught[0] = '\0';
    CHECK(drawing_read(&heard, &d, "/tmp/loft/no/such/file") == EX_NOINPUT &&
          strstr(caught, "no such file") != NULL);
    caught[0] = '\0';
    CHECK(drawing_read(&heard, &d, folder) == EX_NOINPUT &&
          strstr(caught, "is a directory") != NULL);
    drawing_free(&d);
}

static void curves_as_numbers(arb *a)
{
    static const char text[] =
        "x0,y0,x1,y1,x2,y2,x3,y3\n# comment\n\n0,0,1,2,3,4,5,6\n5 6 5 7\t5 8;5 9 # on\r\n "
        ".5,-1e1,1,1,1,1,1,1\n7,7,7,7,7,7,7,7\n9,9,8,8,7,7,6,6";
    drawing d;
    (void)a;
    CHECK(read_bytes(&d, text, sizeof text - 1) == 0 && d.count == 4);
    if (d.count == 4) {
        CHECK(d.curve[0].path == 0 && d.curve[1].path == 0 && d.curve[2].path == 1 &&
              d.curve[3].path == 2);
        CHECK(d.curve[0].line == 4 && d.curve[1].line == 5 && d.curve[3].line == 8);
        CHECK_NEAR(d.curve[2].p[0][0], 0.5, 0);
        CHECK_NEAR(d.curve[2].p[0][1], -10, 0);
        CHECK_NEAR(d.curve[1].p[3][1], 9, 0);
    }
    drawing_free(&d);
    REFUSES_FILE("0,0,1,1,2,2,3,3\n1,2,3\n",               "f:2: 3 numbers");
    REFUSES_FILE("0,0,1,1,2,2,3,3,4\n",                    "f:1: more than eight");
    REFUSES_FILE("0,0,1,1,2,2,3,3\n0,0,1,x,2,2,3,3\n",     "f:2: \"x\" is not a number");
    REFUSES_FILE("0,0,1,1,2,2,3,0x10\n",                   "is not a number");
    REFUSES_FILE("0,0,1,1,2,2,3,1e9\n",                    "beyond +-16000 mm");
    REFUSES_FILE("0,0,1,1,2,2,3,nan\n",                    "\"nan\" is not a number");
}

static double curve_length(const double p[4][2])
{
    drawing d = { 0 };
    double q[4][2];

    memcpy(q, p, sizeof q);
    drawing_add(&d, q, true, 1);
    const double length = drawing_length(&d);
    drawing_free(&d);
    return length;
}

/* Curves whose length has a formula: a line, a parabola, and the cusp (t^3, t^2). */
static void lengths_are_true(arb *a)
{
    const double line[4][2] = { { 1, 2 }, { 2, 4 }, { 3, 6 }, { 4, 8 } };
    /* turns twice on its way */
    const double back[4][2] = { { 0, 0 }, { 9, 0 }, { -6, 0 }, { 3, 0 } };
    const double parabola[4][2] = {
        { -1, 1 }, { -1.0 / 3, -1.0 / 3 }, { 1.0 / 3, -1.0 / 3 }, { 1, 1 }
    };
    const double cusp[4][2] = { { -1, 1 }, { 1, -1.0 / 3 }, { -1, -1.0 / 3 }, { 1, 1 } };
    (void)a;
    CHECK_NEAR(curve_length(line), sqrt(45), 1e-12);
    CHECK_NEAR(curve_length(parabola), sqrt(5) + asinh(2) / 2, 1e-6 * 2.9);
    CHECK_NEAR(curve_length(cusp), 2 * (13 * sqrt(13) - 8) / 27, 1e-6 * 2.8);

    /* x = 27t - 72t^2 + 48t^3 goes up, down and up: sum of the distances between its extremes */
    const double r = sqrt(72.0 * 72 - 3 * 48 * 27), t0 = (72 - r) / 144, t1 = (72 + r) / 144;
    const double x0 = 27 * t0 - 72 * t0 * t0 + 48 * t0 * t0 * t0,
                 x1 = 27 * t1 - 72 * t1 * t1 + 48 * t1 * t1 * t1;
    CHECK_NEAR(curve_length(back), x0 + (x0 - x1) + (3 - x1), 1e-6 * 10);
}

/* No point leaves the box, and each of its four sides is touched. */
static void boxes_are_tight(arb *a)
{
    drawing d = { 0 };
    double p[4][2], box[2][2], seen[2][2] = { { HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, -HUGE_VAL } };

    for (int k = 0; k < 8; k++)
        p[k / 2][k % 2] = (double)arb_raw(a, 100 << 16) / 65536;
    if (arb_below(a, 4) == 0)
        for (int k = 0; k < 3; k++)
            p[k + 1][0] = p[0][0] + k;      /* straight in x */
    drawing_add(&d, p, true, 1);
    CHECK(drawing_box(&d, box));
    for (int i = 0; i <= 2000; i++) {
        double q[2];
        drawing_eval(&d.curve[0], i / 2000.0, q);
        for (int k = 0; k < 2; k++) {
            seen[0][k] = fmin(seen[0][k], q[k]);
            seen[1][k] = fmax(seen[1][k], q[k]);
        }
    }
    for (int k = 0; k < 2; k++) {
        CHECK(box[0][k] <= seen[0][k] + 1e-9 && box[1][k] >= seen[1][k] - 1e-9);
        CHECK_NEAR(box[0][k], seen[0][k], 1e-3);
        CHECK_NEAR(box[1][k], seen[1][k], 1e-3);
    }
    drawing_free(&d);
}

/* The demo's drawing is what the demo promises: enough curves, arcs among them, within its page. */
static void the_demo_drawing_is_whole(arb *a)
{
    drawing d = { 0 };
    double box[2][2];
    (void)a;
    caught_lines = 0;
    CHECK(drawing_read(&heard, &d, "tests/drawings/demo.svg") == 0 && caught_lines == 0);
    CHECK(d.count >= 200 && d.count <= 500);
    CHECK(drawing_box(&d, box) && box[0][0] > 0 && box[0][1] > 0 && box[1][0] < d.width &&
          box[1][1] < d.height);
    CHECK(drawing_length(&d) > 2000 && drawing_length(&d) < 4500);
    CHECK_NEAR(d.width, 180, 1e-9);
    CHECK_NEAR(d.height, 130, 1e-9);
    drawing_free(&d);
}

/* What has been taken out; the last curve stays, for the next one may be joined to it. */
static int take_all_but_one(void *context, drawing *d)
{
    drawing *all = context;

    for (size_t i = 0; i + 1 < d->count; i++)
        drawing_add_like(all, &d->curve[i],
                         i > 0 ? d->curve[i].path != d->curve[i - 1].path
                               : all->count > 0 &&
                                     d->curve[i].path != all->curve[all->count - 1].path);
    drawing_forget(d, d->count - 1);
    return 0;
}

static double random_unit(arb *a)      { return (double)(arb_next(a) >> 11) / 9007199254740992.0; }

static char *long_text(arb *a, bool gcode, unsigned lines, size_t *size)
{
    char *text = tool_grow(NULL, 100 * lines + 100);
    double x   = 0;

    *size = 0;
    for (unsigned n = 0; n < lines; n++) {
        const double y = 100 * random_unit(a) - 50, from = n % 7 ? x : x + 1;
        const char *end = n + 1 == lines ? "" : n % 3 ? "\n" : "\r\n";
        x = 100 * random_unit(a) - 50;
        if (gcode && n % 97 == 50)
            *size += (size_t)sprintf(text + *size, "G4 P0.5\n");
        *size += (size_t)(gcode ? sprintf(text + *size, "G%d X%.4f Y%.4f F900%s", n % 5 > 0, x, y,
                                          end)
                                : sprintf(text + *size, "%.4f,0,%.4f,%.4f,1,1,%.4f,0%s", from, from,
                                          y, x, end));
    }
    return text;
}

/* A file in parts is the same drawing as in one piece, and never much of it is there. */
static void long_files_are_read_in_parts(arb *a)
{
    static char line[3 << 20];
    char name[64];

    snprintf(name, sizeof name, "%s/long", folder);
    for (int gcode = 0; gcode < 2; gcode++) {
        drawing whole = { 0 }, all = { 0 }, d = { .taker = take_all_but_one, .context = &all };
        size_t size;
        char *text = long_text(a, gcode, 20000, &size);
        FILE *f    = fopen(name, "wb");
        CHECK(size > 500000 && fwrite(text, 1, size, f) == size && fclose(f) == 0);
        CHECK(drawing_read(&heard, &whole, name) == 0 && drawing_read(&heard, &d, name) == 0);
        CHECK(whole.count > 19000 && d.count < 8192 && d.room <= 8192);
        CHECK(d.count + d.taken == whole.count && d.program == gcode);
        take_all_but_one(&all, &d);
        CHECK(all.count == whole.count - 1);
        for (size_t i = 0; i < all.count && i < whole.count; i++)
            CHECK(memcmp(all.curve[i].p, whole.curve[i].p, sizeof all.curve[i].p) == 0 &&
                  all.curve[i].line == whole.curve[i].line &&
                  all.curve[i].path == whole.curve[i].path);
        CHECK(whole.events == (gcode ? 206 : 0) && d.events == whole.events);
        for (size_t k = 0; k < d.events && k < whole.events; k++) {
            const size_t before = d.event[k].before;
            CHECK(before == whole.event[k].before && before < whole.count &&
                  d.event[k].line + 1 == whole.curve[before].line);
        }
        drawing_free(&whole);
        drawing_free(&all);
        drawing_free(&d);

        d           = (drawing){ .taker = take_all_but_one, .context = &all };
        f           = fopen(name, "wb");
        text[size - 100000] = '\0';
        CHECK(fwrite(text, 1, size, f) == size && fclose(f) == 0);
        CHECK(drawing_read(&heard, &d, name) == EX_DATAERR &&
              strstr(caught, "is not text") != NULL);
        drawing_free(&d);
        drawing_free(&all);

        d = (drawing){ .taker = take_all_but_one, .context = &all };
        f = fopen(name, "wb");
        memset(line, gcode ? ' ' : ',', sizeof line);
        memcpy(line, "G1 X1\n", gcode ? 6 : 0);
        CHECK(fwrite(line, 1, sizeof line, f) == sizeof line && fclose(f) == 0);
        CHECK(drawing_read(&heard, &d, name) == EX_DATAERR);
        CHECK(strstr(caught, gcode ? ":2: a line of more than 1 MB" : ":1: a line of more") !=
              NULL);
        drawing_free(&d);
        drawing_free(&all);
        free(text);
    }
    remove(name);
}

/* Curves of each degree, some of whose numbers no drawing has. */
static void one_fault_has_one_line(arb *a)
{
    static const double scales[] = { 1, 100, 1e4, 1e5, 1e9, 1e38, 1e300 };
    const unsigned degree = 1 + arb_below(a, 15);
    char text[2000] = "bezier\n";
    drawing d       = { 0 };

    for (unsigned k = 0; k <= degree; k++) {
        const double scale = arb_below(a, 3) ? 1 : scales[arb_below(a, 7)];
        const size_t used  = strlen(text);
        snprintf(text + used, sizeof text - used, "%g %g\n",
                 scale * (double)arb_below(a, 1000) / 100,
                 scale * (double)arb_below(a, 1000) / 100);
    }
    hear();
    const int code = drawing_read_curves(&heard, &d, "x.loft", text);
    CHECK(caught_lines == (code != 0));
    drawing_free(&d);
}

int main(void)
{
    if (mkdtemp(folder) == NULL)
        return 1;
    PROPERTY(files_are_told_apart_by_content, 1);
    PROPERTY(files_of_other_programs_are_named, 1);
    PROPERTY(packed_files_are_unpacked, 1);
    PROPERTY(what_unpacks_to_too_much_is_refused, 1);
    PROPERTY(files_that_cannot_be_read, 1);
    PROPERTY(curves_as_numbers, 1);
    PROPERTY(one_fault_has_one_line, 300);
    PROPERTY(lengths_are_true, 1);
    PROPERTY(boxes_are_tight, 500);
    PROPERTY(the_demo_drawing_is_whole, 1);
    PROPERTY(long_files_are_read_in_parts, 1);
    rmdir(folder);
    return check_failures();
}
