/* host-tools/read/foreign.c -- recognizes files of other programs by their first bytes
 * SPDX-License-Identifier: MIT
 */
#include <string.h>

#include "base/tool.h"       /* tool_error, sysexits */
#include "read/foreign.h"

/* What an unreadable file is, and what to do with it. */
typedef struct {
    const char *start;
    size_t length;
    const char *name, *remedy;
} foreign;

#define CONVERT "convert it, as with `inkscape FILE --export-filename=drawing.svg`"
#define TRACE   "trace it to paths, as with `potrace --svg` or in inkscape"
#define GERBER  "convert it, as with `gerbv -x svg`, or to G-code with pcb2gcode"
#define UNPACK  "unpack it first"
#define KIND(start, name, remedy) { start, sizeof start - 1, name, remedy }

static const foreign kinds[] = {
    KIND("%PDF-", "PDF", CONVERT),
    KIND("%!PS", "PostScript", "convert it, as with `pstoedit -f plot-svg`"),
    KIND("\xC5\xD0\xD3\xC6", "PostScript", CONVERT),
    KIND("AutoCAD Binary DXF", "DXF", CONVERT),
    KIND("AC10", "DWG", "save it as SVG in the program that drew it"),
    KIND("ISO-10303-21", "STEP", "save the outline as SVG in the program that drew it"),
    KIND("%FS", "Gerber", GERBER),
    KIND("\x89PNG", "a PNG picture", TRACE),
    KIND("\xFF\xD8\xFF", "a JPEG picture", TRACE),
    KIND("GIF8", "a GIF picture", TRACE),
    KIND("RIFF", "a WebP picture or other RIFF file", TRACE),
    KIND("II*\0", "a TIFF picture", TRACE),
    KIND("MM\0*", "a TIFF picture", TRACE),
    KIND("PK\3\4", "a ZIP archive or a document in one, as .odg",
         "unpack it, or export SVG from its program"),
    KIND("\xFD"
         "7zXZ",
         "compressed with xz", UNPACK),
    KIND("BZh", "compressed with bzip2", UNPACK),
    KIND("\x28\xB5\x2F\xFD", "compressed with zstd", UNPACK)
};

/* DXF in text: pairs of lines, a code and a value. After comments (999) it begins with 0,
 * SECTION. */
static bool is_dxf(const char *text)
{
    for (int pair = 0; pair < 100; pair++) {
        text += strspn(text, " \t\r\n");
        const bool comment = strncmp(text, "999", 3) == 0;
        const size_t code = comment ? 3 : 1;
        if ((!comment && *text != '0') || strchr("\r\n", text[code]) == NULL)
            return false;
        text += code;
        text += strspn(text, " \t\r\n");
        if (!comment)
            return strncmp(text, "SECTION", 7) == 0;
        text += strcspn(text, "\n");
    }
    return false;
}

/* HP-GL: commands of two letters with numbers; the first is one of those that a plot begins
 * with. */
static bool is_hpgl(const char *text)
{
    static const char first[][3] = { "IN", "DF", "SP", "PU", "PA", "PD", "PR",
                                     "IP", "SC", "RO", "VS", "PS", "BP" };

    text += strspn(text, " \t\r\n");
    if (strncmp(text, "\x1B%", 2) == 0 || strncmp(text, "\x1B.", 2) == 0)
        return true;
    for (size_t i = 0; i < sizeof first / sizeof first[0]; i++)
        if (strncmp(text, first[i], 2) == 0)
            return text[2 + strspn(text + 2, " 0123456789,.+-")] == ';' ||
                   strspn(text + 2, " 0123456789,.+-") > 0;
    return false;
}

/* A word at the start of one of the first lines, behind comments and blank ones. */
static bool has_line(const char *text, const char *word)
{
    for (int line = 0; line < 20 && *text != '\0'; line++) {
        if (strncmp(text, word, strlen(word)) == 0)
            return true;
        text += strcspn(text, "\n");
        text += *text == '\n';
    }
    return false;
}

/* Files of boards and solids in text: Gerber and Excellon look like G-code. */
static const foreign *workshop_kind(const char *text)
{
    static const foreign gerber   = { "", 0, "Gerber", GERBER },
                         excellon = { "", 0, "Excellon, holes of a board",
                                      "convert it, as with `pcb2gcode` or `gerbv -x svg`" },
                         stl      = { "", 0, "STL, a solid",
                                      "cut it to outlines in a slicer, and save those as SVG" };

    if (has_line(text, "%FS") || has_line(text, "%MO") || has_line(text, "%ADD"))
        return &gerber;
    /* M48 alone is a command of LinuxCNC */
    if (has_line(text, "M48") &&
        (has_line(text, "METRIC") || has_line(text, "INCH") || has_line(text, "FMAT")))
        return &excellon;
    return strncmp(text, "solid", 5) == 0 && strstr(text, "facet") != NULL ? &stl : NULL;
}

static const foreign *foreign_kind(const char *text, size_t size)
{
    static const foreign dxf = { "", 0, "DXF", CONVERT }, hpgl = { "", 0, "HP-GL", CONVERT };

    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++)
        if (size >= kinds[i].length && memcmp(text, kinds[i].start, kinds[i].length) == 0)
            return &kinds[i];
    return is_dxf(text) ? &dxf : is_hpgl(text) ? &hpgl : workshop_kind(text);
}

int foreign_refuse(const char *file, const char *text, size_t size)
{
    const foreign *kind = foreign_kind(text, size);

    return kind ? tool_error(EX_DATAERR, "%s: is %s: %s", file, kind->name, kind->remedy) : 0;
}
