/* tests/target/libc/math.h -- the part of <math.h> that tests use, if there is no library
 * SPDX-License-Identifier: MIT
 *
 *   error   sqrt, floor, ceil, round, ldexp, frexp, fmod, nextafter: none; sqrtl: 2^-62; the rest:
 *           2^-58 of the result, 2^-58 for sines and cosines
 */
#ifndef LOFT_TARGET_MATH_H
#define LOFT_TARGET_MATH_H

#define INFINITY    (__builtin_inff())
#define HUGE_VAL    (__builtin_inf())
#define HUGE_VALL   (__builtin_infl())
#define NAN         (__builtin_nanf(""))
#define isnan(x)    ((x) != (x))
#define isfinite(x) ((x) - (x) == 0)

static inline float       fabsf(float x)                         { return __builtin_fabsf(x); }
static inline double      fabs(double x)                         { return __builtin_fabs(x); }
static inline long double fabsl(long double x)                   { return __builtin_fabsl(x); }
static inline double      fmax(double x, double y)               { return x < y || x != x ? y : x; }
static inline double      fmin(double x, double y)               { return x > y || x != x ? y : x; }
static inline long double fmaxl(long double x, long double y)    { return x < y || x != x ? y : x; }
static inline long double fminl(long double x, long double y)    { return x > y || x != x ? y : x; }

long double sqrtl(long double x);
long double hypotl(long double x, long double y);
long double ldexpl(long double x, int n);
long double frexpl(long double x, int *n);
long double floorl(long double x);
long double ceill(long double x);
long double roundl(long double x);
long double truncl(long double x);
long double fmodl(long double x, long double y);
long double remainderl(long double x, long double y);
long double powl(long double x, long double y);
long double expl(long double x);
long double exp2l(long double x);
long double logl(long double x);
long double log2l(long double x);
long double sinl(long double x);
long double cosl(long double x);
long double tanl(long double x);
long double asinl(long double x);
long double acosl(long double x);
long double atan2l(long double y, long double x);

double sqrt(double x);
double nextafter(double x, double toward);
float  nextafterf(float x, float toward);

static inline double hypot(double x, double y)       { return (double)hypotl(x, y); }
static inline double ldexp(double x, int n)          { return (double)ldexpl(x, n); }
static inline double floor(double x)                 { return (double)floorl(x); }
static inline double ceil(double x)                  { return (double)ceill(x); }
static inline double round(double x)                 { return (double)roundl(x); }
static inline double fmod(double x, double y)        { return (double)fmodl(x, y); }
static inline double pow(double x, double y)         { return (double)powl(x, y); }
static inline double cbrt(double x)
{
    return (double)(x < 0 ? -powl(-x, 1 / 3.0L) : x > 0 ? powl(x, 1 / 3.0L) : 0);
}
static inline double exp(double x)                   { return (double)expl(x); }
static inline double log(double x)                   { return (double)logl(x); }
static inline double sin(double x)                   { return (double)sinl(x); }
static inline double cos(double x)                   { return (double)cosl(x); }
static inline double tan(double x)                   { return (double)tanl(x); }
static inline double acos(double x)                  { return (double)acosl(x); }
static inline double atan2(double y, double x)       { return (double)atan2l(y, x); }
static inline long lround(double x)                  { return (long)roundl(x); }
static inline long lroundl(long double x)            { return (long)roundl(x); }
static inline long long llround(double x)            { return (long long)roundl(x); }
static inline long long llroundl(long double x)      { return (long long)roundl(x); }

#endif
