/* tests/tools/test_gcode.c -- the reader of G-code: motions, coordinates, feeds, drilling, messages
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tools/gcode_moves.h"
#include "plan/toolpath.h"
#include "gcode/gcode.h"
#include "gcode/gcode_draw.h"

static int read_text(drawing *d, const char *text)
{
    *d = (drawing){ 0 };
    hear();
    return drawing_read_gcode(&heard, d, "part.nc", text, strlen(text));
}

static void lines_and_modes(arb *a)
{
    (void)a;
    MOVES("G21 G90\nG0 X1 Y2 Z3\nG1 X4 F60\nY5\n", "R 1 2 3 L 4 2 3 L 4 5 3");
    MOVES("%\nN10 G91 g1 x1 (a comment) f9 ; and one more\n\tX 1 . 5\n%\nG1 X9\n",
          "L 1 0 0 L 2.5 0 0");
    MOVES("G0 X1\r\n/G0 X2\r\nM2\r\nG0 X3\r\n", "R 1 0 0 R 2 0 0");
    MOVES("G20 G1 X1 F1\nG21 X1\n", "L 1 0 0 L 1 0 0");
    MOVES("G1 X-.5Y+1.25F1", "L -0.5 1.25 0");
    MOVES("G0 X1 Y1\nG53 G0 X0\nG4 P0.25\nM0\n", "R 1 1 0 R 0 1 0 W 0.25 S");
    MOVES("#1 = 2 #<half> = 0.5\nG0 X[#1 + 3 * 2 ** 2] Y#<half> Z-[10 MOD 4]\n", "R 14 0.5 -2");
    MOVES("G0 X[ATAN[1]/[1]] Y[SQRT[16] LT 5] Z[FIX[-1.5] + FUP[1.2] + ROUND[-0.5]]\n",
          "R 45 1 -1");
    MOVES("#3=1\n#3=5 G0 X#3\nX#3\n", "R 1 0 0 R 5 0 0");
}

static void arcs_as_written(arb *a)
{
    (void)a;
    MOVES("G0 X10\nG2 X0 Y-10 I-10 F1\n", "R 10 0 0 A 0 -10 0 0 -1 0");
    MOVES("G0 X10\nG3 I-10 F1 P3 Z2\n", "R 10 0 0 A 10 0 0 0 3 2");
    MOVES("G18 G2 X2 Z0 I1 F1\nG19 G3 Y2 K0 J1\n", "A 0 2 0 1 -1 0 A 2 0 1 0 1 2");
    MOVES("G90.1 G0 X10\nG3 X-10 I0 J0 F1\n", "R 10 0 0 A -10 0 0 0 1 0");
    MOVES("G3 X10 Y10 R10 F1\n", "A 10 10 0 10 1 0");
    MOVES("G3 X10 Y10 R-10 F1\n", "A 10 10 10 0 1 0");
    MOVES("G2 X10 Y10 R10 F1\n", "A 10 10 10 0 -1 0");
    MOVES("G3 X10 R5 F1\n", "A 10 0 5 0 1 0");
}

static void cubics_and_nurbs(arb *a)
{
    (void)a;
    MOVES("G5 I1 J2 P-1 Q2 X10 F1\nG5 P0 Q3 X20\n", "C 1 2 9 2 10 0 C 11 -2 20 3 20 0");
    MOVES("G5.1 I5 J10 X10 F1\n", "Q 5 10 5 10 10 0");
    MOVES("F1\nG5.2 P2\nG5.2 X1 Y1 P3 L3\nX2 Y0\nX3 Y1 P1\nG5.3\n", "N 0 0 2 1 1 3 2 0 1 3 1 1");
}

/* As rs274 2.9 does, with its extra moves. */
static void holes(arb *a)
{
    (void)a;
    MOVES("G0 Z10\nG98 G81 X1 Y2 Z-1 R3 F9\nX2\nG80\n",
          "R 0 0 10 R 1 2 10 R 1 2 3 L 1 2 -1 R 1 2 10 R 2 2 10 R 2 2 3 L 2 2 -1 R 2 2 10");
    MOVES("G0 Z10\nG99 G82 X1 Z-1 R3 P0.5 F9\n",
          "R 0 0 10 R 1 0 10 R 1 0 3 L 1 0 -1 W 0.5 R 1 0 3");
    MOVES("G0 Z10\nG99 G83 X1 Z-1 R3 Q3 F9\n",
          "R 0 0 10 R 1 0 10 R 1 0 3 L 1 0 0 R 1 0 3 R 1 0 0.254 L 1 0 -1 R 1 0 3");
    MOVES("G0 Z10\nG91 G99 G81 X1 Z-2 R-7 L2 F9\n",
          "R 0 0 10 R 1 0 10 R 1 0 3 L 1 0 1 R 1 0 3 R 2 0 3 L 2 0 1 R 2 0 3");
    FAILS("G81 X1 F9\n", "gcode.drilling-no-depth", 1);
    FAILS("G83 X1 Z-1 R1 F9\n", "gcode.drilling-peck", 1);
}

/* A tap turns back at the bottom; a bore is left with the spindle off. */
static void the_spindle_turns_with_the_cycle(arb *a)
{
    (void)a;
    MOVES("M3 S100\nG0 Z10\nG99 G84 X1 Z-1 R3 F9\n",
          "P 3 100 R 0 0 10 R 1 0 10 R 1 0 3 L 1 0 -1 P 4 100 L 1 0 3 P 3 100");
    MOVES("M4 S100\nG0 Z10\nG98 G74 X1 Z-1 R3 P2 F9\n",
          "P 4 100 R 0 0 10 R 1 0 10 R 1 0 3 L 1 0 -1 P 3 100 W 2 L 1 0 10 P 4 100");
    MOVES("M3 S100\nG0 Z10\nG99 G86 X1 Z-1 R3 P2 F9\n",
          "P 3 100 R 0 0 10 R 1 0 10 R 1 0 3 L 1 0 -1 W 2 P 0 100 R 1 0 3 P 3 100");
    MOVES("G0 Z10\nG99 G84 X1 Z-1 R3 F9\n", "R 0 0 10 R 1 0 10 R 1 0 3 L 1 0 -1 L 1 0 3");
    MOVES("M3 S9\nG0 Z10\nG99 G87 X1 Y2 Z-5 R3 I1 J2 K-1 F9\n",
          "P 3 9 R 0 0 10 R 1 2 10 R 1 2 3 R 2 4 3 P 0 9 ! S R 2 4 -5 R 1 2 -5 P 3 9 L 1 2 -1 "
          "L 1 2 -5 P 0 9 ! S R 2 4 -5 R 2 4 3 R 1 2 3 P 3 9");
    FAILS("G87 X1 Z-5 R3 I1 J2 F9\n", "gcode.bore-offset", 1);
}

/* G28.1 and G30.1 store a place of the machine; M70 to M72 the modes, but not G0, G1 .. */
static void places_and_modes_are_stored(arb *a)
{
    (void)a;
    ENDS_AT("G55 G0 X1 Y2 Z3\nG28.1\nG10 L2 P2 X5\nG0 X9\nG28\n", 1, 2, 3, 0);
    ENDS_AT("G20 G0 X1\nG30.1\nG21 G0 X9 Y1\nG30 X0\n", 25.4, 1, 0, 0);
    ENDS_AT("G0 X1\nG91 G20 F10\nM70\nG90 G21 G94 F5\nM72\nG1 X1\n", 26.4, 0, 0, 10);
    ENDS_AT("G10 L2 P2 X5\nF9\nM70\nG55 G18 G52 X3\nG43.1 Z4\nM72\nG1 X1 Z1\n", 1, 0, 1, 9);
    MOVES("M3 S5\nM70\nM5\nM8\nM72\n", "P 3 5 P 0 5 O 1 P 3 5 O 0");
    FAILS("M72\n", "gcode.modes-not-saved", 1);
    FAILS("M70\nM71\nM72\n", "gcode.modes-not-saved", 3);
}

/* LinuxCNC's @ and ^; also in drilling, where L adds them again. */
static void polar_coordinates_are_understood(arb *a)
{
    (void)a;
    MOVES("G0 @10 ^0\nG1 ^90 F1\n@5\nG91 @5 ^90\n", "R 10 0 0 L 0 10 0 L 0 5 0 L -10 0 0");
    MOVES("G0 X2 Z5\nG91 G99 G81 ^90 R-4 Z-2 L2 F9\n",
          "R 2 0 5 R 0 2 5 R 0 2 1 L 0 2 -1 R 0 2 1 R -2 0 1 L -2 0 -1 R -2 0 1");
    FAILS("G0 @1 X2\n", "gcode.polar-and-axes", 1);
    FAILS("G0 @1\n", "gcode.polar-no-angle", 1);
    FAILS("G18 G0 @1 ^2\n", "gcode.polar-plane", 1);
    FAILS_OF("G28 @1 ^2\n", "gcode.polar-code", 1, "G28: ");
    FAILS("G0 @1 ^2 ^3\n", "gcode.letter-twice", 1);
}

/* The numbers of LinuxCNC: arcs may be spirals by so much. G53 in a system that is turned. */
static void tolerances_and_places_of_the_reference(arb *a)
{
    (void)a;
    ENDS_AT("G2 X50 I24.986 F1\n", 50, 0, 0, 1);
    ENDS_AT("G2 X2000 I999.5 F1\n", 2000, 0, 0, 1);
    ENDS_AT("G20 G2 X5 I2.4986 F1\n", 127, 0, 0, 1);
    FAILS_OF("G2 X50 I24.985 F1\n", "gcode.arc-centre", 1,
             "an arc that starts 24.985 and ends 25.015 from");
    ENDS_AT("G10 L2 P1 R90 X3\nG0 X1 Y2 Z3\nG53 X4 Z0\n", 4, 1, 0, 0);
    ENDS_AT("G43 H0 G0 Z5\n", 0, 0, 5, 0);
    MOVES("G41 D0 G1 X5 F1\nX9\nG40 X12\n", "L 5 0 0 L 9 0 0 L 12 0 0");
    MOVES("#2=99999\n#<a>=1\nG0 X EXISTS[#1] Y EXISTS[##2] Z EXISTS[#<a>]\n", "R 1 0 1");
    FAILS("G0 X EXISTS[#]\n", "gcode.number-missing", 1);
    FAILS("G0 X EXISTS[#<a>+1]\n", "gcode.exists", 1);
}

/* The distance of a point of the plane from the spiral of an arc, at its angle in the arc. */
static double off_spiral(const gcode_event *e, const double at[3], double *turned)
{
    const int a = (e->plane + 1) % 3, b = (e->plane + 2) % 3, way = e->turns > 0 ? 1 : -1;
    const double x[2] = { e->from[a] - e->centre[a], e->from[b] - e->centre[b] },
                 y[2] = { e->to[a] - e->centre[a], e->to[b] - e->centre[b] },
                 p[2] = { at[a] - e->centre[a], at[b] - e->centre[b] }, turn = 2 * acos(-1);
    double whole = way * atan2(x[0] * y[1] - x[1] * y[0], x[0] * y[0] + x[1] * y[1]),
           here  = way * atan2(x[0] * p[1] - x[1] * p[0], x[0] * p[0] + x[1] * p[1]);

    whole += whole < 1e-6 ? turn : 0;
    whole += turn * (abs(e->turns) - 1);
    while (here < *turned - 1e-3)
        here += turn;
    *turned = here;
    const double r = hypot(x[0], x[1]) + (hypot(y[0], y[1]) - hypot(x[0], x[1])) * here / whole;
    return fabs(hypot(p[0], p[1]) - r) +
           fabs(at[e->plane] - e->from[e->plane] -
                (e->to[e->plane] - e->from[e->plane]) * here / whole) *
               (here <= whole + 1e-3);
}

typedef struct {
    const gcode_event *e;
    double off, turned, last[3];
    unsigned count;
} followed;

static int follow(void *context, double p[4][3])
{
    followed *f = context;

    CHECK(memcmp(f->last, p[0], sizeof f->last) == 0);
    for (int k = 0; k <= 16; k++) {
        const double t = k / 16.0, u = 1 - t;
        double at[3];
        for (int i = 0; i < 3; i++)
            at[i] = u * u * u * p[0][i] + 3 * u * t * (u * p[1][i] + t * p[2][i]) +
                    t * t * t * p[3][i];
        f->off = fmax(f->off, off_spiral(f->e, at, &f->turned));
    }
    memcpy(f->last, p[3], sizeof f->last);
    f->count++;
    return 0;
}

/* An arc rounded to some decimals is read, and its cubics keep to the spiral of its ends. */
static void rounded_arcs_are_spirals(arb *a)
{
    static const double tens[] = { 1, 10, 100, 1000, 10000 };
    const int decimals = 2 + (int)arb_below(a, 3);
    const double ten = tens[decimals], least = decimals == 2 ? 0.05 : 0.005,
                 r = least + arb_below(a, 10001) / 1e4 * (arb_below(a, 2) ? 50 : 0.3),
                 from = arb_below(a, 62832) / 1e4, sweep = 0.2 + arb_below(a, 60001) / 1e4;
    const int way = arb_below(a, 2) ? 1 : -1;
    gcode_event e = { .kind = GCODE_ARC,
                      .plane = (int)arb_below(a, 3),
                      .turns = way * (int)(1 + arb_below(a, 3)) };
    const int x = (e.plane + 1) % 3, y = (e.plane + 2) % 3;
    char text[200];
    seen s;

    e.from[x] = floor(ten * r * cos(from) + 0.5) / ten;
    e.from[y] = floor(ten * r * sin(from) + 0.5) / ten;
    e.to[x]   = floor(ten * r * cos(from + way * sweep) + 0.5) / ten;
    e.to[y]   = floor(ten * r * sin(from + way * sweep) + 0.5) / ten;
    e.to[e.plane] = arb_below(a, 1001) / ten;
    snprintf(text, sizeof text,
             "G%d G0 %c%.*f %c%.*f\nG%d %c%.*f %c%.*f %c%.*f %c%.*f %c%.*f P%d F9\n", 19 - e.plane,
             'X' + x, decimals, e.from[x], 'X' + y, decimals, e.from[y], way > 0 ? 3 : 2, 'X' + x,
             decimals, e.to[x], 'X' + y, decimals, e.to[y], 'X' + e.plane, decimals, e.to[e.plane],
             'I' + x, decimals, -e.from[x], 'I' + y, decimals, -e.from[y], abs(e.turns));
    CHECK(run(&s, GCODE_ANY, text) == 0);
    followed f = { .e = &e };
    memcpy(f.last, e.from, sizeof f.last);
    CHECK(gcode_arc_cubics(&e, 1e-4, follow, &f) == 0 && memcmp(f.last, e.to, sizeof f.last) == 0);
    CHECK(f.off <= 1e-4 + 1e-9);
    drawing d;
    CHECK(read_text(&d, text) == 0 && d.count > f.count);
    drawing_free(&d);
}

static void places_on_the_machine(arb *a)
{
    (void)a;
    ENDS_AT("G20\nG1 X1 Y2 Z-1 F10\n", 25.4, 50.8, -25.4, 254);
    ENDS_AT("G20 G1 X1 F10\n", 25.4, 0, 0, 10);    /* F is read before G20 */
    ENDS_AT("F10 G20\nG21 G1 X1\n", 1, 0, 0, 10);
    ENDS_AT("G10 L2 P2 X10 Y20 Z30\nG55 G1 X1 Y1 Z1 F5\n", 11, 21, 31, 5);
    ENDS_AT("G0 X5 Y5\nG10 L20 P1 X0 Y0\nG1 X1 F5\n", 6, 5, 0, 5);
    ENDS_AT("G10 L2 P1 R90\nG0 X5 Y0\nG10 L20 P1 Y7\nG1 Y8 F5\n", -1, 5, 0, 5);
    /* a system that is not in force, and turned otherwise: its own other coordinate stays */
    ENDS_AT("G10 L2 P1 R90\nG55\nG0 Y5\nG10 L20 P1 Y7\nG54\nG1 X0 Y0 F5\n", 7, 0, 0, 5);
    ENDS_AT("G0 X5\nG92 X0\nG1 X1 F5\n", 6, 0, 0, 5);
    ENDS_AT("G0 X5\nG92 X0\nG92.1 G1 X1 F5\n", 1, 0, 0, 5);
    ENDS_AT("G52 X2\nG1 X1 F5\n", 3, 0, 0, 5);
    ENDS_AT("G10 L2 P1 R90\nG1 X1 Y2 Z3 F5\n", -2, 1, 3, 5);
    ENDS_AT("G43.1 Z5\nG1 Z1 F5\nG49 G1 X1 Z1\n", 1, 0, 1, 5);
    ENDS_AT("G93 G1 X10 F2\n", 10, 0, 0, 20);
    ENDS_AT("G93 G3 X20 I10 F1\n", 20, 0, 0, 10 * acos(-1));
    ENDS_AT("S100 G95 G1 X10 F0.1\n", 10, 0, 0, 10);
}

/* Numbers of programs, as many post-processors write them; outputs of LinuxCNC with an E. */
static void names_of_programs_are_skipped(arb *a)
{
    (void)a;
    ENDS_AT("%\nO1234 (part)\nG1 X10 F60\nM30\nO2\nG1 X20\nM99\n%\n", 10, 0, 0, 60);
    ENDS_AT("N1 o 12 34\nG1 X10 F60 ; c\n", 10, 0, 0, 60);
    ENDS_AT("M67 E0 Q50\nG1 X10 F60\n", 10, 0, 0, 60);
}

/* As rs274 2.9 runs them. */
static void loops_and_branches_are_run(arb *a)
{
    (void)a;
    MOVES("#1=0\no1 while [#1 lt 2]\nG0 X#1\n#1=[#1+1]\no1 endwhile\no2 do\nG0 Y#1\n#1=[#1-1]\n"
          "o2 while [#1 gt 0]\no3 repeat [2]\nG91 G0 X1\no3 endrepeat\n",
          "R 0 0 0 R 1 0 0 R 1 2 0 R 1 1 0 R 2 1 0 R 3 1 0");
    MOVES("G0\no4 if [0]\nX99\no4 elseif [1]\nX98\no4 else\nX97\no4 endif\nX1\n",
          "R 0 0 0 R 98 0 0 R 1 0 0");
    MOVES("G0\n#5=2\no4 if [#5 eq 1]\nX9\no4 else\nX7 (a word)\n N5 o 4 endif (c) ; d\n",
          "R 0 0 0 R 7 0 0");
    MOVES("G0\no1 while [1]\no1 break\nX1\no1 endwhile\nX2\n#2=0\no5 while [#2 lt 3]\n#2=[#2+1]\n"
          "o6 if [#2 eq 2]\no5 continue\no6 endif\nX#2\no5 endwhile\n",
          "R 0 0 0 R 2 0 0 R 1 0 0 R 3 0 0");
    MOVES("G91 G0\no1 repeat [2.6]\nX1\no1 endrepeat\no2 repeat [-1]\nX9\no2 endrepeat\n",
          "R 0 0 0 R 1 0 0 R 2 0 0 R 3 0 0");
    MOVES("G0\n#1=0\no1 do\n#1=[#1+1]\no2 if [#1 eq 2]\no1 continue\no2 endif\nX#1\n"
          "o3 if [#1 gt 3]\no1 break\no3 endif\no1 while [#1 lt 9]\nX0\n",
          "R 0 0 0 R 1 0 0 R 3 0 0 R 4 0 0 R 0 0 0");
    MOVES("G0\no1 if [0]\nXbad (\no1 endif\nX1\nM2\no1 nonsense\n", "R 0 0 0 R 1 0 0");
    MOVES("G0\no1 while [#<_x> lt 2]\no2 repeat [2]\nG91 X1\no2 endrepeat\no1 endwhile\nY1\n",
          "R 0 0 0 R 1 0 0 R 2 0 0 R 2 1 0");
    FAILS_OF("G0\no1 if [0]\nX1\n", "gcode.flow-no-end", 2, "O1 IF: ");
    FAILS_OF("o1 while [0]\n", "gcode.flow-no-end", 1, "O1 WHILE: ");
    FAILS_OF("o1 endif\n", "gcode.no-if", 1, "O1 ENDIF: ");
    FAILS_OF("o1 endwhile\n", "gcode.no-loop", 1, "O1 ENDWHILE: ");
    FAILS_OF("\no1 break\n", "gcode.no-loop-around", 2, "O1 BREAK: ");
    FAILS("o1 if [1] G1 X1\no1 endif\n", "gcode.label-line", 1);
    FAILS("o1 if\no1 endif\n", "gcode.condition-missing", 1);
    FAILS("o1 if [1]\nX\no1 endif\n", "gcode.number-missing", 2);
    FAILS("o1 while [1]\no1 endwhile\n", "gcode.loop-endless", 1);
}

static void subroutines_are_called(arb *a)
{
    (void)a;
    MOVES("G0 #1=5\no20 sub\n#1=[#1+1]\nX[#1]\no20 endsub\no20 call [7]\nX#1\no20 call\n",
          "R 0 0 0 R 8 0 0 R 5 0 0 R 1 0 0");
    MOVES("G0\no20 call [7] [8]\nM2\no20 sub\nX[#1] Y#2\no20 endsub\n", "R 0 0 0 R 7 8 0");
    MOVES("G0\no1 sub\no2 if [#1 gt 3]\no1 return [7]\no2 endif\nX#1\no1 endsub [8]\no1 call [2]\n"
          "Y#<_value>\no1 call [5]\nY#<_value> Z#<_value_returned>\n",
          "R 0 0 0 R 2 0 0 R 2 8 0 R 2 7 1");
    MOVES(
        "G0\no<a b> sub\n#<x>=3\n#<_g>=4\nX#<x> Z#<_call_level>\no<ab> endsub\n#<x>=1\no<AB> call\n"
        "X#<_g> Y#<x> Z#<_call_level>\n",
        "R 0 0 0 R 3 0 1 R 4 1 0");
    MOVES("G0 #7=20\nM98 P20 L2\nX1\nM30\nO20\n#1=[#1+1]\nX[#1]\nM99\n",
          "R 0 0 0 R 1 0 0 R 2 0 0 R 1 0 0");
    MOVES("G0\no1 sub\no1 endsub [8]\nO2 sub\nX#<_value>\no2 endsub\no1 call\no2 call\nX#<_value>\n"
          "o1 call\nM98 P9\nX#<_value>\nM2\nO9\nX#<_value>\nM99\n",
          "R 0 0 0 R 8 0 0 R 0 0 0 R 8 0 0 R 0 0 0");
    MOVES("O1 (main)\nG0 X1\nM99\nX5\n", "R 1 0 0");
    MOVES("G0 #31=7\no[#31 + 1] call [1]\nM2\no8 sub\nX#1\no8 endsub\n", "R 0 0 0 R 1 0 0");
    MOVES("G0\no1 sub\no2 if [#1 gt 0]\nX#1\no1 call [#1 - 1]\no2 endif\no1 endsub\no1 call [3]\n",
          "R 0 0 0 R 3 0 0 R 2 0 0 R 1 0 0");
    FAILS_OF("o1 sub\no1 call\no1 endsub\no1 call\n", "gcode.calls-nested", 2, "O1 CALL: ");
    FAILS_OF("G0\no9 call\n", "gcode.subroutine-missing", 2, "O9 CALL: ");
    FAILS_OF("o<../x> call\n", "gcode.subroutine-missing", 1, "O<../X> CALL: ");
    FAILS_OF("M98 P9\n", "gcode.subroutine-missing", 1, "O9: ");
    FAILS("M98\n", "gcode.call-no-number", 1);
    FAILS("M98 P2 X1\nO2\nM99\n", "gcode.call-line", 1);
    FAILS_OF("o1 endsub\n", "gcode.subroutine-end", 1, "O1 ENDSUB: ");
    FAILS_OF("M98 P1\nM2\no1 sub\no1 endsub\n", "gcode.subroutine-kind", 1, "O1: ");
    FAILS_OF("o1 call\nM2\nO1\nM99\n", "gcode.subroutine-kind", 1, "O1 CALL: ");
    FAILS("o1 sub\n#<x>=1\no1 endsub\no1 call\nG0 X#<x>\n", "gcode.parameter-unset", 5);
    FAILS("#<_x>=1\n", "gcode.parameter-read-only", 1);
}

/* What is read in one part or in many is the same. */
static void a_program_in_parts_is_the_whole(arb *a)
{
    static const char text[] =
        "O7 (x)\nG0 X1\n#3=2\nX#3\no1 if [1]\nX3\no1 endif\nM98 P8 L2\nM2\nO8\nY9\nM99\n";
    const size_t size = sizeof text - 1;
    seen s = { .feed = 0 };

    (void)a;
    for (size_t cut = 1; cut < size; cut++) {
        if (text[cut - 1] != '\n')
            continue;
        gcode_program *g = gcode_open(&heard, "part.nc", GCODE_ANY, see, &s);
        s.text[0] = '\0';
        CHECK(gcode_lines(g, text, cut) == 0 && gcode_lines(g, text + cut, size - cut) == 0 &&
              gcode_finish(g) == 0);
        CHECK(strcmp(s.text, "R 1 0 0 R 2 0 0 R 3 0 0 R 3 9 0 R 3 9 0") == 0);
        gcode_close(g);
    }
}

/* Files beside the program; a motion is told at the line that called for it. */
static void files_beside_the_program_are_called(arb *a)
{
    char folder[] = "/tmp/loft-gcode-XXXXXX", main[64], file[64];
    static const char text[] = "G0 X1\no<in file> call [4]\no33 call\nM98 P44\nM2\n";
    drawing d = { 0 };
    FILE *out;
    (void)a;

    CHECK(mkdtemp(folder) != NULL);
    static const char *const files[][2] = {
        { "infile", "(about)\no<infile> sub\nG0 X#1\no33 call\no<infile> endsub\nM2\n" },
        { "33", "%\no33 sub\nG0 Y33\no33 endsub\n%\n" },
        { "o44", "O44\nG0 Z44\nM99\n" },
    };
    for (int i = 0; i < 3; i++) {
        snprintf(file, sizeof file, "%s/%s.ngc", folder, files[i][0]);
        out = fopen(file, "w");
        fputs(files[i][1], out);
        fclose(out);
    }
    snprintf(main, sizeof main, "%s/main.ngc", folder);
    CHECK(drawing_read_gcode(&heard, &d, main, text, sizeof text - 1) == 0 && d.count == 4);
    CHECK(d.count == 4 && d.curve[1].line == 2 && d.curve[2].line == 2 && d.curve[3].line == 4);
    drawing_free(&d);
    out = fopen(file, "w");
    fputs("O44\nG0 Z\nM99\n", out);
    fclose(out);
    d = (drawing){ 0 };
    caught[0] = '\0';
    CHECK(drawing_read_gcode(&heard, &d, main, text, sizeof text - 1) == EX_DATAERR &&
          heard_it("gcode.number-missing", 2) && strstr(caught, "/o44.ngc:2: ") != NULL);
    drawing_free(&d);
    for (int i = 0; i < 3; i++) {
        snprintf(file, sizeof file, "%s/%s.ngc", folder, files[i][0]);
        remove(file);
    }
    remove(folder);
}

static void what_is_wrong_has_its_line(arb *a)
{
    (void)a;
    FAILS("G0 X1\nX\n", "gcode.number-missing", 2);
    FAILS("G0 X1 X2\n", "gcode.letter-twice", 1);
    FAILS("\n\nhello\n", "gcode.number-missing", 3);
    FAILS("G0 X1 (open\n", "gcode.comment-open", 1);
    FAILS("X1\n", "gcode.no-motion", 1);
    FAILS_OF("G0 G1 X1\n", "gcode.group-twice", 1, "G1: ");
    FAILS_OF("G0 X1\nG38.2 Z-9 F1\n", "gcode.probe", 2, "G38.2: ");
    FAILS_OF("G38.5 X1 F1\n", "gcode.probe", 1, "G38.5: ");
    FAILS_OF("G37 X1\n", "gcode.g-unknown", 1, "G37: ");
    FAILS_OF("M111\nM300\n", "gcode.m-unknown", 2, "M300: ");
    FAILS("G0 A90\n", "gcode.axis-unknown", 1);
    FAILS_OF("O100 sub\n", "gcode.flow-no-end", 1, "O100 SUB: ");
    FAILS_OF("O100 G21\n", "gcode.label-word", 1, "O100: ");
    FAILS("G21 O100\n", "gcode.label-misplaced", 1);
    FAILS("O\n", "gcode.label-missing", 1);
    FAILS("N1 G1 X1 F10*86\n", "gcode.checksum", 1);
    FAILS("M3 E0 G1 X1 F10\n", "gcode.extruder", 1);
    FAILS("G2 X10 F1\n", "gcode.arc-no-centre", 1);
    FAILS_OF("G2 X10 I4 F1\n", "gcode.arc-centre", 1,
             "an arc that starts 4 and ends 6 from its centre: ");
    FAILS_OF("G2 X10 R4 F1\n", "gcode.arc-radius-short", 1, "R4 is too small for ends 10 apart: ");
    FAILS("G5 X1 P1 Q1 F1\n", "gcode.cubic-first-control", 1);
    FAILS("G5.2 X1 L3 F1\nX2\n", "gcode.nurbs-open", 1);
    FAILS("G0 X[1/0]\n", "gcode.number-not-finite", 1);
    FAILS("G0 X#<none>\n", "gcode.parameter-unset", 1);
    FAILS("G0 X#9999\n", "gcode.parameter-number", 1);
    FAILS("G0 X1e\n", "gcode.number-missing", 1);
    FAILS("G0 X\001\n", "gcode.number-missing", 1);
    FAILS("G0 \001\n", "gcode.not-a-word", 1);
    FAILS("G4\n", "gcode.wait-no-time", 1);
    FAILS("G93 F1 G1 X1\nX2\n", "gcode.inverse-time-no-feed", 2);
}

/* Bounded work for any line: deep brackets, long numbers, long lines, many words. */
static void hostile_lines_end(arb *a)
{
    static char text[70000];
    (void)a;
    memset(text, '[', sizeof text - 1);
    memcpy(text, "G0X", 3);
    FAILS(text, "gcode.line-too-long", 1);
    text[60000] = '\0';
    FAILS(text, "gcode.expression-deep", 1);
    memset(text + 3, '-', 50000);
    FAILS(text, "gcode.expression-deep", 1);
    memset(text + 3, '1', 50000);
    FAILS(text, "gcode.number-long", 1);
    for (int i = 0; i < 20; i++)
        memcpy(text + 3 * i, "M08", 4);
    FAILS(text, "gcode.words-in-line", 1);
    FAILS("G91 G81 X1 Z-1 R1 L100001 F1\n", "gcode.drilling-count", 1);
    FAILS("G91 G81 X1 Z-1 R1 L0 F1\n", "gcode.drilling-count", 1);
    FAILS("G82 X1 Z-1 R1 F1\n", "gcode.drilling-no-wait", 1);
    FAILS("G82 X1 Z-1 R1 P1 F1\nG89 X2 Z-1 R1\n", "gcode.drilling-no-wait", 2);
    FAILS("G82 X1 Z-1 R1 P-2 F1\n", "gcode.drilling-wait", 1);
    FAILS("G10 L2 X5\n", "gcode.system-unknown", 1);
    FAILS("G10 L20 X5\n", "gcode.system-unknown", 1);
    FAILS("G95 G1 X1 F.1\n", "gcode.feed-no-speed", 1);
    FAILS("G83 X1 Z-1e9 R1 Q1 F1\n", "gcode.extruder", 1);
    FAILS("G83 X1 Z-900000 R1 Q1 F1\n", "gcode.drilling-peck", 1);
    FAILS("G91 G83 X1 Z-50 R1 Q1 L50000 F1\n", "gcode.drilling-peck", 1);
}

static void other_words_of_printers_are_left_out(arb *a)
{
    seen s;
    (void)a;
    CHECK(run(&s, GCODE_MARLIN, "G60\nG42 I3 J2\nG1 X5 F60\nG61\nG90.1\nG2 X9 I2\n") == 0);
    CHECK(strcmp(s.text, "L 5 0 0 A 9 0 7 0 -1 0") == 0);
}

/* Each word of a line has a use in it, or the line is refused, as by LinuxCNC. */
static void words_without_a_use_are_refused(arb *a)
{
    static const char *const idle[] = { "G54 P7\n",
                                        "G1 X20 R3 F9\n",
                                        "G1 X1 P1 F9\n",
                                        "G0 X1 I1\n",
                                        "G0 X1 H1\n",
                                        "G0 X1 Q2\n",
                                        "G2 X5 I2.5 R3 F9\n",
                                        "G3 X5 I2.5 K1 F9\n",
                                        "G80 X1\n",
                                        "D1\n",
                                        "L3\n",
                                        "G49 H1\n",
                                        "G40 D1\n",
                                        "G81 X1 Z-1 R1 P2 F9\n",
                                        "G82 X1 Z-1 R1 P2 Q1 F9\n",
                                        "G5.1 X1 I1 P1 F9\n",
                                        "G64 R1\n",
                                        "M3 P1\n",
                                        "G4 P1 L2\n",
                                        "G1 X1 F9 J1\n",
                                        "G17 K2\n",
                                        "G28 P1\n" };
    static const char *const twice[] = { "M3 M5\n",     "M3 M3\n",   "M7 M8\n",   "M0 M2\n",
                                         "M6 M61 Q1\n", "M48 M50\n", "M62 M64\n", "M70 M5\n" };
    (void)a;
    for (size_t i = 0; i < sizeof idle / sizeof idle[0]; i++)
        FAILS(idle[i], "gcode.word-unused", 1);
    for (size_t i = 0; i < sizeof twice / sizeof twice[0]; i++)
        FAILS(twice[i], "gcode.group-twice", 1);
    FAILS("G1 X1 F0\n", "gcode.feed-zero", 1);
    FAILS("F0\nG0 X1\nG2 X2 I0.5\n", "gcode.feed-zero", 3);
    MOVES("F0\nG0 X1\n", "R 1 0 0");
    MOVES("M62 P1\nM66 P0 L3 Q2\nM68 E1 Q2\nM110 P1 Q2\nG64 P0.1 Q0.2\nG0 X1\n", "R 1 0 0");
    MOVES("M3 M8 S5 G0 X1\n", "P 3 5 O 1 R 1 0 0");
}

/* Text for the display is no code: it ends a line of a printer, and may hold anything. */
static void texts_of_printers_are_no_words(arb *a)
{
    seen s;
    (void)a;
    CHECK(
        run(&s, GCODE_MARLIN,
            "M862.3 P \"MK3S\" ; model\nM117 100% done (\nM118 E1 hello O1 sub\nM0 Click to go on\n"
            "M1 P2500 Wait (a\nM486 A\"part: 1*2\"\nG1 X1 (a (b) c) Y2 F0\n"
            "START_PRINT BED=60\nnonsense %\nG4 S1.5\nG92 E0\nG1 X2*71\n_USER_PAUSE X=1\n") == 0);
    CHECK(strcmp(s.text, "! S ! W 2.5 L 1 2 0 W 1.5 L 2 2 0") == 0);
    CHECK(heard_it("gcode.left-word", 8) && strstr(caught, ":8: START_PRINT: ") != NULL &&
          heard_it("gcode.left-word", 9) && strstr(caught, ":9: nonsense: ") != NULL &&
          heard_it("gcode.left-word", 1) && strstr(caught, ":1: M862.3: ") != NULL);
    CHECK(run(&s, GCODE_MARLIN, "G4 P-1\n") == EX_DATAERR && heard_it("gcode.wait-negative", 1));
    CHECK(gcode_is_printer("M117 Hello\nG28\n") && gcode_is_printer("G28\ng1 x1 e0.5\n") &&
          gcode_is_printer("M862.3 P \"MK3S\"\n") && gcode_is_printer("G21\rM106 S255\rG1 X1\r"));
    CHECK(!gcode_is_printer("M67 E0 Q1\nM100 P1\n(M117)\n") && !gcode_is_printer("G1 X1 (E1)\n"));
}

/* LF, CR LF and CR end a line. */
static void lines_end_in_three_ways(arb *a)
{
    (void)a;
    MOVES("G0 X1\rX2\r\nX3\n\rX4\r", "R 1 0 0 R 2 0 0 R 3 0 0 R 4 0 0");
    FAILS("G0 X1\rX2\r\nX3\n\rX\r", "gcode.number-missing", 5);
    FAILS("G0 X1 (a (b) c)\n", "gcode.comment-nested", 1);
    FAILS("G4 P-1\n", "gcode.wait-negative", 1);
}

/* A printer's file: heaters and extruder are left out, once told; G28 goes to 0; G0 has a feed. */
static void printers_are_understood(arb *a)
{
    seen s;
    (void)a;
    CHECK(run(&s, GCODE_MARLIN,
              "M104 S200\nG28 X\nG1 X10 E1 F600\nG0 Y5 E2 *12\nM117 hello (\n"
              "G92 E0\n") == 0);
    CHECK(strcmp(s.text, "R 0 0 0 L 10 0 0 R 10 5 0") == 0);
    CHECK_NEAR(s.feed, 600, 1e-9);
    CHECK(heard_it("gcode.left-word", 1) && heard_it("gcode.left-extruder", 3) &&
          strstr(caught, "E (3 times)") != NULL && heard_it("gcode.left-word", 5) &&
          caught_lines == 3);
    CHECK(gcode_is_printer("; x\nM109 S200\n") && !gcode_is_printer("M3 S1000\nG1 X1\n"));
}

/* All curves follow each other; arcs keep their radius; feeds and rapids are those of the file. */
static void a_program_is_a_drawing(arb *a)
{
    drawing d;
    (void)a;
    CHECK(read_text(&d, "G0 X10 Z5\nG1 Z-1 F120\nG3 X-10 I-10 Z1 F600\nG0 Z5\n") == 0 &&
          d.program && d.count > 4 && caught_lines == 0);
    CHECK(d.curve[0].feed < 0 && d.curve[0].line == 1 && fabs(d.curve[1].feed - 2) < 1e-12 &&
          fabs(d.curve[2].feed - 10) < 1e-12 && d.curve[2].line == 3 &&
          d.curve[d.count - 1].feed < 0);
    for (size_t i = 0; i + 1 < d.count; i++)
        CHECK(d.curve[i].path == 0 && d.curve[i].z[3] == d.curve[i + 1].z[0]);
    for (size_t i = 2; i + 1 < d.count; i++)
        for (int k = 0; k <= 8; k++) {
            double at[2];
            drawing_eval(&d.curve[i], k / 8.0, at);
            CHECK_NEAR(hypot(at[0], at[1]), 10, DRAWING_TOL);
        }
    CHECK_NEAR(d.curve[d.count - 2].p[3][0], -10, 1e-9);
    CHECK_NEAR(d.curve[d.count - 2].z[3], 1, 1e-9);
    drawing_free(&d);
    CHECK(read_text(&d, "G1 X1000000000 F1\n") == EX_DATAERR && heard_it("drawing.too-far", 1));
    drawing_free(&d);
    drawing_free(&d);
}

/* Events stand before the curve that follows them, which begins a path. */
static void what_a_program_does_between_motions_is_kept(arb *a)
{
    drawing d = { 0 };
    (void)a;

    CHECK(read_text(&d, "M3 S9\nG1 X1 F1\nG4 P2.5\nX2\n(MSG, turn it)\nM0\nX3\nM8\nM5\n") == 0);
    CHECK(caught_lines == 0 && d.count == 3 && d.events == 5);
    static const struct {
        enum drawing_doing doing;
        size_t before;
        unsigned line;
    } want[5] = { { DRAWING_SPINS, 0, 1 },
                  { DRAWING_WAITS, 1, 3 },
                  { DRAWING_PAUSES, 2, 6 },
                  { DRAWING_COOLS, 3, 8 },
                  { DRAWING_SPINS, 3, 9 } };
    for (size_t i = 0; i < 5 && d.events == 5; i++)
        CHECK(d.event[i].doing == want[i].doing && d.event[i].before == want[i].before &&
              d.event[i].line == want[i].line);
    CHECK_NEAR(d.event[0].amount, 9, 0);
    CHECK_NEAR(d.event[1].amount, 2.5, 0);
    CHECK(strcmp(d.event[2].text, "turn it") == 0 && d.event[4].way == 0);
    CHECK(d.curve[1].path == 1 && d.curve[2].path == 2);
    drawing_free(&d);
    static const char later[] = "M3 S9\nG1 X1 F1\nG4 P2.5\nM5\nM4 S8\nX2\nM0\n";
    d = (drawing){ .from_line = 6 };
    CHECK(drawing_read_gcode(&heard, &d, "part.nc", later, strlen(later)) == 0 && d.events == 4);
    drawing_free(&d);
    MOVES("M3 S5\nG1 X1 F1 S7\nX2 S7\nM5\nS9\nM4\n",
          "P 3 5 P 3 7 L 1 0 0 P 3 7 L 2 0 0 P 0 7 P 4 9");
    MOVES("M3 M8\nM9\n", "P 3 -1 O 1 O 0");
}

/* How the path is kept: the smallest tolerance, and stops if any motion wants them. */
static void it_says_how_the_path_is_kept(arb *a)
{
    drawing d;
    (void)a;
    CHECK(read_text(&d, "G64 P0.05\nG1 X1 F9\nX2\n") == 0 && !d.exact && caught_lines == 0);
    CHECK_NEAR(d.within, 0.05, 1e-12);
    drawing_free(&d);
    CHECK(read_text(&d, "G20\nG64 P0.002\nG1 X1 F9\nG64 P0.001\nX2\nG64\nX3\n") == 0);
    CHECK_NEAR(d.within, 0.0254, 1e-12);
    drawing_free(&d);
    CHECK(read_text(&d, "G61\nG1 X1 F9\nG61.1\nX2\nG64 P1\nG0 X3\n") == 0 && d.exact &&
          !(d.within > 0) && caught_lines == 0);
    drawing_free(&d);
    CHECK(read_text(&d, "G61\nG1 X1 F9\nG64\nX2\n") == 0 && d.exact && caught_lines == 1 &&
          heard_it("gcode.exact-stop-everywhere", 0));
    drawing_free(&d);
    FAILS("G64 P-1\n", "gcode.blend-negative", 1);
}

/* From a line on: the modes of the lines before, the way there above all of the program. */
static void it_begins_at_a_line(arb *a)
{
    static const char text[] = "G21 G0 Z8\nG0 X1\nG1 Z-1 F60\nX2\nX3\nG0 Z8\n";
    const toolpath_options o = { .feed = 9, .travel = 5, .rapid = 100, .start = { 0, 0, 1 } };
    static const double ends[][3] = {
        { 0, 0, 8 }, { 2, 0, 8 }, { 2, 0, -1 }, { 3, 0, -1 }, { 3, 0, 8 }
    };
    drawing d = { .from_line = 5 };
    toolpath t;

    (void)a;
    CHECK(drawing_read_gcode(&heard, &d, "part.nc", text, strlen(text)) == 0 && d.count == 2);
    toolpath_make(&t, &d, &o);
    CHECK(t.count == 5);
    for (size_t n = 0; n < t.count && n < 5; n++)
        for (int i = 0; i < 3; i++)
            CHECK_NEAR(t.move[n].p[3][i], ends[n][i], 1e-9);
    CHECK(t.count == 5 && t.move[2].feed == 1 && t.move[3].feed == 1 && t.move[4].feed == 100);
    toolpath_free(&t);
    drawing_free(&d);
}

static void make_path(toolpath *t, const char *text)
{
    const toolpath_options o = { .feed = 1, .travel = 1, .rapid = 1, .start = { 7, 8, 9 } };
    drawing d;

    CHECK(read_text(&d, text) == 0);
    toolpath_make(t, &d, &o);
    drawing_free(&d);
}

/* What a program does not say is where the machine stands: at 7, 8, 9. */
static void it_goes_on_from_the_machine(arb *a)
{
    static const struct {
        const char *text;
        double end[3];
        size_t moves;
    } each[] = {
        { "G1 X1 F9\n", { 1, 8, 9 }, 1 },
        { "G91 G1 X1 F9\nG3 X2 I1\n", { 10, 8, 9 }, 0 },
        { "G0 Z5\nG0 X0 Y0\n", { 0, 0, 5 }, 2 },
        { "G92 X0 Y0\nG1 X1 Y1 F9\n", { 8, 9, 9 }, 1 },
        { "G10 L20 P0 Z0\nG1 X1 Z-1 F9\n", { 1, 8, 8 }, 1 },
        { "G92 X0\nG92.1\nG1 X1 F9\n", { 1, 8, 9 }, 1 },
        { "G91 G0 Z1\nG90 G28\nG1 X3 F9\n", { 3, 0, 0 }, 3 },
        { "G53 G0 Z0\nG91 G1 Y1 F9\n", { 7, 9, 0 }, 2 },
    };
    (void)a;
    for (size_t n = 0; n < sizeof each / sizeof each[0]; n++) {
        const double from[3] = { 7, 8, 9 };
        toolpath t;
        make_path(&t, each[n].text);
        CHECK(t.count > 0 && (each[n].moves == 0 || t.count == each[n].moves));
        for (int i = 0; i < 3 && t.count > 0; i++) {
            CHECK_NEAR(t.move[0].p[0][i], from[i], 1e-9);
            CHECK_NEAR(t.move[t.count - 1].p[3][i], each[n].end[i], 1e-9);
        }
        for (size_t k = 1; k < t.count; k++)
            for (int i = 0; i < 3; i++)
                CHECK_NEAR(t.move[k].p[0][i], t.move[k - 1].p[3][i], 1e-9);
        toolpath_free(&t);
    }
}

int main(void)
{
    PROPERTY(lines_and_modes, 1);
    PROPERTY(arcs_as_written, 1);
    PROPERTY(cubics_and_nurbs, 1);
    PROPERTY(holes, 1);
    PROPERTY(the_spindle_turns_with_the_cycle, 1);
    PROPERTY(places_and_modes_are_stored, 1);
    PROPERTY(polar_coordinates_are_understood, 1);
    PROPERTY(tolerances_and_places_of_the_reference, 1);
    PROPERTY(rounded_arcs_are_spirals, 2000);
    PROPERTY(places_on_the_machine, 1);
    PROPERTY(names_of_programs_are_skipped, 1);
    PROPERTY(what_is_wrong_has_its_line, 1);
    PROPERTY(hostile_lines_end, 1);
    PROPERTY(loops_and_branches_are_run, 1);
    PROPERTY(subroutines_are_called, 1);
    PROPERTY(a_program_in_parts_is_the_whole, 1);
    PROPERTY(files_beside_the_program_are_called, 1);
    PROPERTY(words_without_a_use_are_refused, 1);
    PROPERTY(lines_end_in_three_ways, 1);
    PROPERTY(texts_of_printers_are_no_words, 1);
    PROPERTY(printers_are_understood, 1);
    PROPERTY(other_words_of_printers_are_left_out, 1);
    PROPERTY(a_program_is_a_drawing, 1);
    PROPERTY(it_says_how_the_path_is_kept, 1);
    PROPERTY(it_begins_at_a_line, 1);
    PROPERTY(what_a_program_does_between_motions_is_kept, 1);
    PROPERTY(it_goes_on_from_the_machine, 1);
    return check_failures();
}
