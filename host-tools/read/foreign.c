/* host-tools/read/foreign.c -- files of other programs, by their first bytes
 * SPDX-License-Identifier: MIT
 */
#include <string.h>

#include "read/foreign.h"

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

/* Boards: Gerber looks like G-code. */
static bool is_gerber(const char *text)
{
    return has_line(text, "%FS") || has_line(text, "%MO") || has_line(text, "%ADD");
}

/* Holes of boards; M48 alone is a command of LinuxCNC. */
static bool is_excellon(const char *text)
{
    return has_line(text, "M48") &&
           (has_line(text, "METRIC") || has_line(text, "INCH") || has_line(text, "FMAT"));
}

static bool is_stl(const char *text)
{
    return strncmp(text, "solid", 5) == 0 && strstr(text, "facet") != NULL;
}

#define BY_SIGNS(kind)                                                                           \
    static int probe_##kind(const reader *r, const char *file, const char *text, size_t size)    \
    {                                                                                            \
        (void)r, (void)file, (void)size;                                                         \
        return is_##kind(text) ? READER_SIGNS : READER_NOT;                                      \
    }
BY_SIGNS(dxf)
BY_SIGNS(hpgl)
BY_SIGNS(gerber)
BY_SIGNS(excellon)
BY_SIGNS(stl)

#define CONVERT "convert it, as with `inkscape FILE --export-filename=drawing.svg`"
#define TRACE   "trace it to paths, as with `potrace --svg` or in inkscape"
#define UNPACK  "unpack it first"
#define MAGIC(start, name, remedy) \
    { name, reader_by_magic, NULL, NULL, READER_BYTES, remedy, start, sizeof start - 1 }
#define SIGNS(kind, name, remedy) { name, probe_##kind, NULL, NULL, READER_BYTES, remedy, NULL, 0 }

const reader foreign_readers[FOREIGN_KINDS] = {
    MAGIC("%PDF-", "PDF", CONVERT),
    MAGIC("%!PS", "PostScript", "convert it, as with `pstoedit -f plot-svg`"),
    MAGIC("\xC5\xD0\xD3\xC6", "PostScript", CONVERT),
    MAGIC("AutoCAD Binary DXF", "DXF", CONVERT),
    MAGIC("AC10", "DWG", "save it as SVG in the program that drew it"),
    MAGIC("ISO-10303-21", "STEP", "save the outline as SVG in the program that drew it"),
    MAGIC("\x89PNG", "a PNG picture", TRACE),
    MAGIC("\xFF\xD8\xFF", "a JPEG picture", TRACE),
    MAGIC("GIF8", "a GIF picture", TRACE),
    MAGIC("RIFF", "a WebP picture or other RIFF file", TRACE),
    MAGIC("II*\0", "a TIFF picture", TRACE),
    MAGIC("MM\0*", "a TIFF picture", TRACE),
    MAGIC("PK\3\4", "a ZIP archive or a document in one, as .odg",
          "unpack it, or export SVG from its program"),
    MAGIC("\xFD"
          "7zXZ",
          "compressed with xz", UNPACK),
    MAGIC("BZh", "compressed with bzip2", UNPACK),
    MAGIC("\x28\xB5\x2F\xFD", "compressed with zstd", UNPACK),
    SIGNS(dxf, "DXF", CONVERT),
    SIGNS(hpgl, "HP-GL", CONVERT),
    SIGNS(gerber, "Gerber", "convert it, as with `gerbv -x svg`, or to G-code with pcb2gcode"),
    SIGNS(excellon, "Excellon, holes of a board",
          "convert it, as with `pcb2gcode` or `gerbv -x svg`"),
    SIGNS(stl, "STL, a solid", "cut it to outlines in a slicer, and save those as SVG")
};
