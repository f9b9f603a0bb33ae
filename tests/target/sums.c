/* tests/target/sums.c -- check sums of the arithmetic, to be equal bit for bit on every core in q16
 * SPDX-License-Identifier: MIT
 *
 * Each line is a name and a sum over many results, extremes included. tests/target/target.sh runs
 * this program here and on emulated chips and compares. On AVR the lines leave through the serial
 * port, on Cortex-M0 through the debugger (microbit.c), and the four parts (-DPART=1 operations, 2
 * points and walking, 3 measures, 4 grids over patches) are programs of their own: together they
 * exceed the flash of an ATmega328P. Its lines that begin with # are times.
 */
#include "num/accs.h"
#include "curve/forward.h"
#include "curve/measure.h"
#include "surface/tensor/grid.h"

#include "say.h"    /* say_line */

#if defined(__AVR__)
#  include <avr/interrupt.h>
#  include <avr/io.h>
#  include <avr/sleep.h>
static void put(char c)
{
    while (!(UCSR0A & (1 << UDRE0))) {
    }
    UDR0 = (uint8_t)c;
}
static void start(void)
{
    UBRR0 = 0;
    UCSR0A = 1 << U2X0;
    UCSR0B = 1 << TXEN0;
}
static void stop(void)
{
    put('\n');
    cli();
    sleep_enable();
    sleep_cpu();
}
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

static void add(int64_t x)
{
    for (int i = 0; i < 2; i++, x /= 4294967296)
        sum = (sum ^ (uint32_t)(x & 0xffffffff)) * 16777619u;
}

static void say(const char *name)
{
    say_words(put, name);
    put(' ');
    for (int i = 28; i >= 0; i -= 4)
        put("0123456789abcdef"[sum >> i & 15]);
    put('\n');
    sum = 2166136261u;
}

/* One in four is next to a power of two; |x| < 2^bits. */
static int64_t some(unsigned bits)
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
static int32_t coordinate(void) { return (int32_t)some(31); }
#endif
static loft_unit fraction(void)  { return (loft_unit)((uint32_t)some(31) & 0xffffff); }

#if PART == 2 || PART == 3
static loft_cubic some_cubic(unsigned bits)
{
    loft_cubic c;
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            c.p[k].axis[i] = (loft_real)some(bits);
    return c;
}
#endif

#if PART == 1

static void sums(int rounds)
{
    for (int n = 0; n < rounds; n++) {
        const loft_acc x = some(47);
        if (loft_acc_valid(x))
            add(loft_acc_round(x));
    }
    say("acc_round");
    for (int n = 0; n < rounds; n++) {
        const loft_acc x = loft_prod(coordinate(), coordinate());
        if (loft_acc_valid(x))
            add(loft_acc_round(x));
    }
    say("mul");
    for (int n = 0; n < rounds; n++)
        add(loft_acc_int(some(62)));
    say("acc_int");
    for (int n = 0; n < rounds; n++) {
        const int32_t a = (int32_t)some(24), b = (int32_t)some(31);
        if (b / 256 != 0)
            add(loft_div(a, b));
    }
    say("div");
    for (int n = 0; n < rounds; n++) {
        const int32_t a = coordinate(), b = coordinate();
        add(loft_lerp(a, b, fraction()));
    }
    say("lerp");
    for (int n = 0; n < rounds; n++) {
        const loft_acc x = some(55);
        add(loft_acc_scale(x, (loft_unit)some(30)));
    }
    say("acc_scale");
    for (int n = 0; n < rounds; n++) {
        const loft_acc x = some(62), y = some(62);
        add(loft_acc_lerp(x, y, fraction()));
    }
    say("acc_lerp");
    for (int n = 0; n < rounds; n++) {
        const loft_acc x = some(46);
        add(loft_acc_mul(x, (loft_real)some(31)));
    }
    say("acc_mul");
    for (int n = 0; n < rounds; n++) {
        const loft_acc x = some(46);
        const int32_t a = coordinate();
        if (a)
            add(loft_acc_div(x, a));
    }
    say("acc_div");
    for (int n = 0; n < rounds; n++) {
        const loft_acc x = some(63);
        add(loft_acc_ratio(x, 1 + ((int32_t)some(31) & 0x3fffffff)));
    }
    say("acc_ratio");
    for (int n = 0; n < rounds; n++)
        add(loft_acc_sqrt(some(63)));
    say("acc_sqrt");
    for (int n = 0; n < rounds; n++) {
        const loft_acc x[3] = { some(61), some(61), some(50) };
        add(loft_acc_hypot(x, 3));
    }
    say("acc_hypot");
    for (int n = 0; n < rounds; n++) {
        const int64_t y = 1 + ((some(62) & INT64_MAX) >> 1), x = some(62) % y;
        add(loft_unit_ratio(x, y));
    }
    say("unit_ratio");
    for (int n = 0; n < rounds; n++) {
        const uint32_t k = 1 + ((uint32_t)some(31) & 0x7fffffff), j = (uint32_t)some(31) % k;
        add(loft_unit_of(j, k));
    }
    say("unit_of");
    for (int n = 0; n < rounds; n++) {
        const uint32_t k = UINT32_MAX - ((uint32_t)some(31) & 0x7fffffff),
                       j = k - ((uint32_t)some(31) & 0x7fffffff);
        add(loft_unit_of(j, k));
    }
    say("unit_of_more");
    for (int n = 0; n < rounds; n++)
        add(loft_real_floor(coordinate()));
    say("real_floor");
    for (int n = 0; n < rounds; n++) {
        const loft_acc x = some(62), y = n % 8 ? some(62) : x;
        add(loft_acc_abs(x) ^ loft_acc_min(x, y));
        add(loft_acc_max(x, y));
    }
    say("acc_order");
    for (int n = 0; n < rounds; n++) {
        loft_acc x[LOFT_AXES], y[LOFT_AXES];
        for (int i = 0; i < LOFT_AXES; i++) {
            x[i] = some(60);
            y[i] = some(60);
        }
        loft_accs_add(x, y);
        add(x[0]);
        loft_accs_copy(y, x);
        loft_accs_triple(y);
        loft_accs_sub(x, y);
        for (int i = 0; i < LOFT_AXES; i++)
            add(x[i]);
    }
    say("accs");
}

#elif PART == 2

static void sums(int rounds)
{
    loft_vec p;

    for (int n = 0; n < rounds; n++) {
        const loft_cubic c = some_cubic(31);
        loft_bezier b;
        loft_forward w;
        if (loft_bezier_init(&b, c.p, 3) == LOFT_OK &&
            loft_forward_init(&w, &b, n % 2 ? 64 : 100) == LOFT_OK)
            while (loft_forward_next(&w, &p))
                for (int i = 0; i < LOFT_AXES; i++)
                    add(p.axis[i]);
        p = loft_cubic_eval(&c, fraction());
        add(p.axis[0]);
    }
    say("forward");
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

static void some_net(unsigned bits)
{
    for (int k = 0; k < 16; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            net[k].axis[i] = (loft_real)some(bits);
}

static uint32_t walk(void)
{
    uint32_t points = 0;
    loft_vec p;

    for (; loft_grid_next(&grid, &p); points++)
        for (int i = 0; i < LOFT_AXES; i++)
            add(p.axis[i]);
    return points;
}

/* Without the sums, for its time. */
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

static void sums(int rounds)
{
    loft_triangle t;
    loft_tensor s;

    for (int n = 0; n < rounds; n++) {
        some_net(n == 0 ? 22 : 31);
        if (loft_tensor_init(&s, net, 3, 3) != LOFT_OK)
            return;
        if (n == 0)
            time_grid(&s);
        if (loft_grid_init(&grid, &s, STEPS, STEPS, memory, LOFT_GRID_STATES(3, 3)) == LOFT_OK)
            walk();
    }
    say("grid");
    if (loft_grid_init(&grid, &s, 11, 13, memory, LOFT_GRID_STATES(3, 3)) == LOFT_OK)
        walk();
    say("grid_any");
    if (loft_triangle_init(&t, net, 3) == LOFT_OK &&
        loft_grid_triangle_init(&grid, &t, STEPS, memory, LOFT_GRID_TRIANGLE_STATES(3)) == LOFT_OK)
        walk();
    say("grid_triangle");
    for (int n = 0; n < rounds; n++) {
        const loft_unit u = fraction(), v = fraction();
        const loft_vec p = loft_tensor_eval(&s, u, v);
        for (int i = 0; i < LOFT_AXES; i++)
            add(p.axis[i]);
    }
    say("tensor");
}

#else

static void sums(int rounds)
{
    loft_vec p;

    for (int n = 0; n < rounds; n++) {
        const loft_cubic c = some_cubic(22);
        loft_flatten f;
        if (loft_flatten_init(&f, &c, LOFT_REAL(1)) == LOFT_OK)
            while (loft_flatten_next(&f, &p))
                for (int i = 0; i < LOFT_AXES; i++)
                    add(p.axis[i]);
    }
    say("flatten");
    for (int n = 0; n < rounds; n++) {
        const loft_cubic c = some_cubic(22);
        const loft_acc length = loft_cubic_arclen(&c, LOFT_REAL(0.125));
        add(length);
        add(loft_cubic_inv_arclen(&c, length / 3, LOFT_REAL(0.125)));
    }
    say("length");
}

#endif

int main(void)
{
    start();
    sum = 2166136261u;
    sums(PART == 1 ? 500 : 4);
    stop();
    return 0;
}
