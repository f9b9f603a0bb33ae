/* tests/target/sums.c -- check sums of the arithmetic, which must be equal bit for bit on every
 * core in q16
 * SPDX-License-Identifier: MIT
 *
 * Each line is a name and a sum over many results, including extremes. tests/target/target.sh runs
 * this program on the host and on emulated chips and compares the lines. On AVR they go to the
 * serial port, on Cortex-M0 to the debugger (microbit.c). The four parts are separate programs
 * (-DPART=1 operations, 2 points and walking, 3 measures, 4 grids over patches): together they
 * exceed the flash of an ATmega328P. Lines that begin with # are times.
 */
#include "num/accs.h"
#include "curve/forward.h"
#include "curve/measure.h"
#include "surface/tensor/grid.h"

#include "say.h"    /* say_line */

#if defined(__AVR__)
#  include "avr_say.h"
static void start(void) { serial_start(); }
#elif defined(__ARM_ARCH_6M__)
void debugger_put(char c);
static void put(char c) { debugger_put(c); }
static void start(void) {}
static void stop(void)  {}
#else
#  include <stdio.h>
static void put(char c) { putchar(c); }
static void start(void) {}
static void stop(void)  {}
#endif

static uint32_t sum;
static uint64_t state;

static void add_number(int64_t x)
{
    for (int i = 0; i < 2; i++, x /= 4294967296)
        sum = (sum ^ (uint32_t)(x & 0xffffffff)) * 16777619u;
}

static void say_sum(const char *name)
{
    say_words(put, name);
    put(' ');
    for (int i = 28; i >= 0; i -= 4)
        put("0123456789abcdef"[sum >> i & 15]);
    put('\n');
    sum = 2166136261u;
}

/* One in four is next to a power of two; |x| < 2^bits. */
static int64_t random_number(unsigned bits)
{
    state = state * 6364136223846793005u + 1442695040888963407u;
    const uint32_t r = (uint32_t)(state >> 32);
    const unsigned size = 1 + (unsigned)(r % bits);
    int64_t x = (int64_t)(state & (((uint64_t)1 << size) - 1));

    state += r;
    if ((r >> 16 & 3) == 0)
        x = ((int64_t)1 << (size - 1)) - (r >> 18 & 1);
    return r >> 20 & 1 ? -x : x;
}

#if PART == 1
static int32_t random_coordinate(void) { return (int32_t)random_number(31); }
#endif
static loft_unit random_fraction(void)
{
    return (loft_unit)((uint32_t)random_number(31) & 0xffffff);
}

#if PART == 2 || PART == 3
static loft_cubic random_cubic(unsigned bits)
{
    loft_cubic c;
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            c.p[k].axis[i] = (loft_real)random_number(bits);
    return c;
}
#endif

#if PART == 1

static void print_sums(int rounds)
{
    for (int n = 0; n < rounds; n++) {
        const loft_acc x = random_number(47);
        if (loft_acc_valid(x))
            add_number(loft_acc_round(x));
    }
    say_sum("acc_round");
    for (int n = 0; n < rounds; n++) {
        const loft_acc x = loft_prod(random_coordinate(), random_coordinate());
        if (loft_acc_valid(x))
            add_number(loft_acc_round(x));
    }
    say_sum("mul");
    for (int n = 0; n < rounds; n++)
        add_number(loft_acc_int(random_number(62)));
    say_sum("acc_int");
    for (int n = 0; n < rounds; n++) {
        const int32_t a = (int32_t)random_number(31), b = (int32_t)random_number(31);
        add_number(loft_prod_int(a, b & INT32_MAX));
    }
    say_sum("prod_int");
    for (int n = 0; n < rounds; n++) {
        const int32_t a = (int32_t)random_number(24), b = (int32_t)random_number(31);
        if (b / 256 != 0)
            add_number(loft_div(a, b));
    }
    say_sum("div");
    for (int n = 0; n < rounds; n++) {
        const int32_t a = random_coordinate(), b = random_coordinate();
        add_number(loft_lerp(a, b, random_fraction()));
    }
    say_sum("lerp");
    for (int n = 0; n < rounds; n++) {
        const loft_acc x = random_number(55);
        add_number(loft_acc_scale(x, (loft_unit)random_number(30)));
    }
    say_sum("acc_scale");
    for (int n = 0; n < rounds; n++) {
        const loft_acc x = random_number(62), y = random_number(62);
        add_number(loft_acc_lerp(x, y, random_fraction()));
    }
    say_sum("acc_lerp");
    for (int n = 0; n < rounds; n++) {
        const loft_acc x = random_number(46);
        add_number(loft_acc_mul(x, (loft_real)random_number(31)));
    }
    say_sum("acc_mul");
    for (int n = 0; n < rounds; n++) {
        const loft_acc x = random_number(46);
        const int32_t a = random_coordinate();
        if (a)
            add_number(loft_acc_div(x, a));
    }
    say_sum("acc_div");
    for (int n = 0; n < rounds; n++) {
        const loft_acc x = random_number(63);
        add_number(loft_acc_ratio(x, 1 + ((int32_t)random_number(31) & 0x3fffffff)));
    }
    say_sum("acc_ratio");
    for (int n = 0; n < rounds; n++)
        add_number(loft_acc_sqrt(random_number(63)));
    say_sum("acc_sqrt");
    for (int k = 0; k < rounds; k++)
        add_number(loft_root((uint64_t)random_number(63)));
    say_sum("root");
    for (int n = 0; n < rounds; n++) {
        const loft_acc x[3] = { random_number(61), random_number(61), random_number(50) };
        add_number(loft_acc_hypot(x, 3));
    }
    say_sum("acc_hypot");
    for (int n = 0; n < rounds; n++) {
        const int64_t y = 1 + ((random_number(62) & INT64_MAX) >> 1), x = random_number(62) % y;
        add_number(loft_unit_ratio(x, y));
    }
    say_sum("unit_ratio");
    for (int n = 0; n < rounds; n++) {
        const uint32_t k = 1 + ((uint32_t)random_number(31) & 0x7fffffff),
                       j = (uint32_t)random_number(31) % k;
        add_number(loft_unit_of(j, k));
    }
    say_sum("unit_of");
    for (int n = 0; n < rounds; n++) {
        const uint32_t k = UINT32_MAX - ((uint32_t)random_number(31) & 0x7fffffff),
                       j = k - ((uint32_t)random_number(31) & 0x7fffffff);
        add_number(loft_unit_of(j, k));
    }
    say_sum("unit_of_more");
    for (int n = 0; n < rounds; n++)
        add_number(loft_real_floor(random_coordinate()));
    say_sum("real_floor");
    for (int n = 0; n < rounds; n++) {
        const loft_acc x = random_number(62), y = n % 8 ? random_number(62) : x;
        add_number(loft_acc_abs(x) ^ loft_acc_min(x, y));
        add_number(loft_acc_max(x, y));
    }
    say_sum("acc_order");
    for (int n = 0; n < rounds; n++) {
        loft_acc x[LOFT_AXES], y[LOFT_AXES];
        for (int i = 0; i < LOFT_AXES; i++) {
            x[i] = random_number(60);
            y[i] = random_number(60);
        }
        loft_accs_add(x, y);
        add_number(x[0]);
        loft_accs_copy(y, x);
        loft_accs_triple(y);
        loft_accs_sub(x, y);
        for (int i = 0; i < LOFT_AXES; i++)
            add_number(x[i]);
    }
    say_sum("accs");
}

#elif PART == 2

/* x / n for random x and n, of which half are below 2^10 */
static void divide_limbs(int rounds)
{
    uint32_t x[4];

    for (int n = 0; n < rounds; n++) {
        for (int i = 0; i < 4; i++)
            x[i] = (uint32_t)random_number(32);
        const uint32_t by = 1 + ((uint32_t)random_number(n % 4 == 0   ? 31
                                                         : n % 4 == 1 ? 16
                                                                      : 10) &
                                 0x7fffffff);
        loft_limbs_divide(x, 4, n % 8 ? by : by >> 16 | 1);
        for (int i = 0; i < 4; i++)
            add_number(x[i]);
    }
    say_sum("limbs_divide");
}

/* The differences of random polynomials, for random numbers of steps. */
static void start_walks(int rounds)
{
    static const uint32_t most[] = { 0xffff8000u, 92000, 2900, 560, 210 };
    loft_real p[LOFT_WALK_DEGREE_MAX + 1];

    for (int k = 0; k < 4 * rounds; k++) {
        const unsigned degree = 1 + (unsigned)k % LOFT_WALK_DEGREE_MAX;
        const uint32_t n = 1 + ((uint32_t)random_number(31) & 0x7fffffff) % most[degree - 1];
        loft_powers powers;
        loft_powers3 powers3;
        loft_walk w;
        loft_walk3 w3;

        for (int i = 0; i <= LOFT_WALK_DEGREE_MAX; i++)
            p[i] = (loft_real)random_number(k % 3 ? 31 : 16);
        loft_powers_init(&powers, degree, n);
        loft_walk_init(&w, p, degree, &powers);
        for (unsigned i = 0; i <= degree; i++)
            add_number((int64_t)w.d[i]);
        loft_powers3_init(&powers3, (uint16_t)(1 + n % 2900));
        loft_walk3_init(&w3, p, &powers3);
        for (int i = 0; i < 4; i++)
            add_number((int64_t)w3.d[i]);
    }
    say_sum("walk_init");
}

static void print_sums(int rounds)
{
    loft_vec p;

    divide_limbs(4 * rounds);
    start_walks(rounds);

    for (int n = 0; n < rounds; n++) {
        const loft_cubic c = random_cubic(31);
        loft_bezier b;
        loft_forward w;
        if (loft_bezier_init(&b, c.p, 3) == LOFT_OK &&
            loft_forward_init(&w, &b, n % 2 ? 64 : 100) == LOFT_OK)
            while (loft_forward_next(&w, &p))
                for (int i = 0; i < LOFT_AXES; i++)
                    add_number(p.axis[i]);
        p = loft_cubic_eval(&c, random_fraction());
        add_number(p.axis[0]);
    }
    say_sum("forward");
}

#elif PART == 4

#define STEPS 16

static loft_vec net[16];
static loft_state memory[LOFT_GRID_STATES(3, 3)];
static loft_grid grid;

#if defined(__AVR__)

/* Timer 1 counts 64 cycles. */
static void start_timer(void)
{
    TCCR1A = 0;
    TCCR1B = (1 << CS11) | (1 << CS10);
    TCNT1 = 0;
}
static uint32_t cycles(void)  { return (uint32_t)TCNT1 * 64; }
static void say_time(const char *name, uint32_t n)      { say_line(put, name, n); }

#else
static void start_timer(void)                           {}
static uint32_t cycles(void)                            { return 0; }
static void say_time(const char *name, uint32_t n)
{
    (void)name;
    (void)n;
}
#endif

static void random_net(unsigned bits)
{
    for (int k = 0; k < 16; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            net[k].axis[i] = (loft_real)random_number(bits);
}

static uint32_t walk_grid(void)
{
    uint32_t points = 0;
    loft_vec p;

    for (; loft_grid_next(&grid, &p); points++)
        for (int i = 0; i < LOFT_AXES; i++)
            add_number(p.axis[i]);
    return points;
}

/* Without the sums, to measure the time. */
static void time_grid(const loft_tensor *s)
{
    uint32_t points = 0;
    loft_vec p;

    start_timer();
    if (loft_grid_init(&grid, s, STEPS, STEPS, memory, LOFT_GRID_STATES(3, 3)) != LOFT_OK)
        return;
    say_time("# cycles of loft_grid_init, 16 x 16 bicubic:", cycles());
    start_timer();
    while (loft_grid_next(&grid, &p))
        points++;
    say_time("# cycles of a point of it:", cycles() / points);
}

static void print_sums(int rounds)
{
    loft_triangle t;
    loft_tensor s;

    for (int n = 0; n < rounds; n++) {
        random_net(n == 0 ? 22 : 31);
        if (loft_tensor_init(&s, net, 3, 3) != LOFT_OK)
            return;
        if (n == 0)
            time_grid(&s);
        if (loft_grid_init(&grid, &s, STEPS, STEPS, memory, LOFT_GRID_STATES(3, 3)) == LOFT_OK)
            walk_grid();
    }
    say_sum("grid");
    if (loft_grid_init(&grid, &s, 11, 13, memory, LOFT_GRID_STATES(3, 3)) == LOFT_OK)
        walk_grid();
    say_sum("grid_any");
    if (loft_triangle_init(&t, net, 3) == LOFT_OK &&
        loft_grid_triangle_init(&grid, &t, STEPS, memory, LOFT_GRID_TRIANGLE_STATES(3)) == LOFT_OK)
        walk_grid();
    say_sum("grid_triangle");
    for (int n = 0; n < rounds; n++) {
        const loft_unit u = random_fraction(), v = random_fraction();
        const loft_vec p = loft_tensor_eval(&s, u, v);
        for (int i = 0; i < LOFT_AXES; i++)
            add_number(p.axis[i]);
    }
    say_sum("tensor");
}

#else

static void print_sums(int rounds)
{
    loft_vec p;

    for (int n = 0; n < rounds; n++) {
        const loft_cubic c = random_cubic(22);
        loft_flatten f;
        if (loft_flatten_init(&f, &c, LOFT_REAL(1)) == LOFT_OK)
            while (loft_flatten_next(&f, &p))
                for (int i = 0; i < LOFT_AXES; i++)
                    add_number(p.axis[i]);
    }
    say_sum("flatten");
    for (int n = 0; n < rounds; n++) {
        const loft_cubic c = random_cubic(22);
        const loft_acc length = loft_cubic_arclen(&c, LOFT_REAL(0.125));
        add_number(length);
        add_number(loft_cubic_inv_arclen(&c, length / 3, LOFT_REAL(0.125)));
    }
    say_sum("length");
}

#endif

int main(void)
{
    start();
    sum = 2166136261u;
    print_sums(PART == 1 ? 500 : 4);
    stop();
    return 0;
}
