/* tests/tools/test_gcode_radius.c -- tools of G-code: radius compensation, lengths, changes
 * SPDX-License-Identifier: MIT
 *
 * The tool 2 of the tests has a radius of 1, tool 1 one of 3.
 */
#include "tools/gcode_moves.h"

/* Left of a square, counterclockwise, the tool is inside of it; clockwise, outside. */
static void corners(arb *a)
{
    (void)a;
    MOVES("G0 X-5 Y0\nG41 D2\nG1 X0 F9\nX10\nY10\nX0\nG40 X-5 Y5\n",
          "R -5 0 0 L 0 1 0 L 9 1 0 L 9 9 0 L 0 9 0 L -5 5 0");
    MOVES("G0 X0 Y-5\nG41 D2\nG1 Y0 F9\nY10\nX10\nY0\nG40 X20\n",
          "R 0 -5 0 L -1 0 0 L -1 10 0 A 0 11 0 10 -1 0 L 10 11 0 A 11 10 10 10 -1 0 L 11 0 0 "
          "L 20 0 0");
    MOVES("G0 X0 Y-5\nG42.1 D2\nG1 Y0 F9\nY10\nX-10\nG40 X-20 Y20\n",
          "R 0 -5 0 L 1 0 0 L 1 10 0 A 0 11 0 10 1 0 L -10 11 0 L -20 20 0");
    MOVES("G0 X0 Y-5\nG41 D2\nY0\nY10\nX10\nG40 X20\n",      /* rapids have no arcs */
          "R 0 -5 0 R -1 0 0 R -1 10 0 R 0 11 0 R 10 11 0 R 20 10 0");
    MOVES("G0 X-5 Y0\nG41 D2\nG1 X0 F9\nX10\nX0\nG40 X-5\n",  /* around the end of a line */
          "R -5 0 0 L 0 1 0 L 10 1 0 A 10 -1 10 0 -1 0 L 0 -1 0 L -5 0 0");
}

static void arcs_beside_arcs(arb *a)
{
    (void)a;
    MOVES("G0 X-5 Y0\nG41 D2\nG1 X0 F9\nG3 X5 Y5 J5\nG1 Y9\nG40 Y20\n",
          "R -5 0 0 L 0 1 0 A 4 5 0 5 1 0 L 4 9 0 L 5 20 0");
    MOVES("G0 X-5 Y0\nG42 D2\nG1 X0 F9\nG3 X5 Y5 J5\nG1 Y9\nG40 Y20\n",
          "R -5 0 0 L 0 -1 0 A 6 5 0 5 1 0 L 6 9 0 L 5 20 0");
    MOVES("G0 X-10 Y0\nG41 D2\nG1 X0 F9\nG2 X10 I5\nG1 X20\nG40 Y20\n",   /* an n */
          "R -10 0 0 L -0.916 1 0 A 10.916 1 5 0 -1 0 L 20 1 0 L 20 20 0");
    MOVES("G0 X0 Y-10\nG42 D2\nG1 Y0 F9\nG3 J5\nG1 X-20\nG40 Y20\n",      /* a whole turn */
          "R 0 -10 0 L 1 -0.916 0 A -4.472 1 0 5 1 0 L -20 1 0 L -20 20 0");
}

/* Heights and waits go with the end that the corner moved. */
static void across_the_plane(arb *a)
{
    (void)a;
    MOVES("G0 X-5 Y0 Z5\nG41 D2\nG1 X0 F9\nX10\nZ-1\nG4 P2\nY10\nG40 Y20\n",
          "R -5 0 5 L 0 1 5 L 9 1 5 L 9 1 -1 W 2 L 9 10 -1 L 10 20 -1");
    MOVES("G0 X-5 Y0 Z5\nG41 D2\nZ0\nG1 X0 F9\nG40 X9\n", "R -5 0 5 R -5 0 0 L 0 1 0 L 9 0 0");
    MOVES("G18 G0 Z-5 X0\nG41 D2\nG1 Z0 F9\nZ10\nX10\nG40 X20\n",
          "R 0 0 -5 L 1 0 0 L 1 0 9 L 10 0 9 L 20 0 10");
    MOVES("G0 X-5 Y0\nG41 D2\nG1 X0 F9\nX10\nM2\n", "R -5 0 0 L 0 1 0 L 10 1 0");
}

static void what_does_not_fit(arb *a)
{
    (void)a;
    FAILS_OF("G0 X-5 Y0\nG41 D1\nG1 X0 F9\nX10\nY2\nX0\nG40 X-9\n", "gcode.compensation-corner", 6,
             "the tool of radius 3 does not fit into the corner at line 5: ");
    FAILS("G0 X-9 Y0\nG41 D1\nG1 X0 F9\nG3 Y4 J2\nG40 X-9\n", "gcode.compensation-arc", 4);
    FAILS("G0 X-2 Y0\nG41 D1\nG1 X0 F9\n", "gcode.compensation-first", 3);
    FAILS("G1 X-5 F9\nG41 D2\nX5\n", "gcode.compensation-unplaced", 3);
    FAILS("G0 X0 Y0\nG41 D2 G5 X9 I1 J1 P1 Q1 F9\n", "gcode.compensation-motion", 2);
    FAILS("G0 X0 Y0\nG41 D2\nG81 X5 Z-1 R1 F9\n", "gcode.compensation-motion", 3);
    FAILS("G0 X0 Y0\nG41 D2\nG41 D2\n", "gcode.compensation-twice", 3);
    FAILS_OF("G0 X0 Y0\nG41 D2\nG20\n", "gcode.compensation-code", 3, "G20: ");
    FAILS_OF("G0 X0 Y0\nG41 D2\nG55\n", "gcode.compensation-code", 3, "G55: ");
    FAILS_OF("G0 X0 Y0\nG41 D2\nG28\n", "gcode.compensation-code", 3, "G28: ");
    FAILS("G0 X0 Y0\nG41 D2\nT2 M6\n", "gcode.compensation-tool-change", 3);
    FAILS("G19 G0 Z0 Y0\nG41 D2\n", "gcode.compensation-plane", 2);
    FAILS("G0 X0 Y0\nG41 D2\nX9\nG40\nG2 X5 I5 F9\n", "gcode.compensation-leave", 5);
    FAILS("G0 X0 Y0\nG41 D2\nX9\nG40\nG41 D2\n", "gcode.compensation-again", 5);
}

/* As many lines as a hostile program has: no more wait than there is room for. */
static void what_waits_is_bounded(arb *a)
{
    char text[2048] = "G0 X-5 Y0\nG41 D2\nG1 X0 F9\n";
    (void)a;
    for (int n = 0; n < 70; n++)
        strcat(text, n % 2 ? "Z1\n" : "Z2\n");
    FAILS(text, "gcode.compensation-waits", 67);
}

static void tools_of_the_machine(arb *a)
{
    (void)a;
    MOVES("T2 M6\nG0 X-5 Y0\nG41\nG1 X0 F9\nG40 X9\n", "T 2 R -5 0 0 L 0 1 0 L 9 0 0");
    MOVES("M61 Q2\nG0 X-5 Y0\nG41 D0\nG1 X0 F9\n", "R -5 0 0 L 0 1 0");
    MOVES("M6\n", "S");
    ENDS_AT("G43 H1 G0 X1 Z2\nG1 F5 X2\n", 2, 0, 14.5, 5);
    ENDS_AT("T1 M6\nG43\nG43.2 H3\nG0 Z2\nG1 F5 X2\n", 2, 0, 21.5, 5);
    ENDS_AT("T1 M6\nG43\nG43 H3\nG0 Z2\nG1 F5 X2\n", 2, 0, 9, 5);
    ENDS_AT("G20 G43 H1\nG0 Z1\nG1 F5 X2\nG49 G1 Z1\n", 50.8, 0, 25.4, 127);
    ENDS_AT("G43.1 Z10\nG53 G0 Z3\nG1 X1 F5\n", 1, 0, 3, 5);
    FAILS("G41\n", "gcode.tool-none", 1);
    FAILS("G43\n", "gcode.tool-none", 1);
    FAILS("G41 D9\n", "gcode.tool-no-value", 1);
    FAILS("G43 H2\n", "gcode.tool-no-value", 1);
    FAILS("G42 D3\n", "gcode.tool-no-value", 1);
    FAILS("G41.1\n", "gcode.compensation-no-diameter", 1);
    FAILS("T1.5\n", "gcode.tool-number", 1);
    FAILS("M61\n", "gcode.tool-loaded-number", 1);
}

int main(void)
{
    PROPERTY(corners, 1);
    PROPERTY(arcs_beside_arcs, 1);
    PROPERTY(across_the_plane, 1);
    PROPERTY(what_does_not_fit, 1);
    PROPERTY(what_waits_is_bounded, 1);
    PROPERTY(tools_of_the_machine, 1);
    return check_failures();
}
