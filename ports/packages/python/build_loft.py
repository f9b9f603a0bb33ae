# ports/packages/python/build_loft.py -- what of loft.h Python sees; the compiler fills `...`
# SPDX-License-Identifier: MIT
from cffi import FFI

builder = FFI()
builder.cdef('''
    typedef struct { double axis[3]; } loft_vec;
    typedef struct { loft_vec p[4]; } loft_cubic;
    typedef struct { ...; } loft_bezier;
    typedef struct { ...; } loft_forward;
    typedef struct { ...; } loft_flatten;
    typedef struct { ...; } loft_plan;
    typedef struct { ...; } loft_knot;
    typedef struct { ...; } loft_span;
    typedef struct { loft_cubic curve; double feed; ...; } loft_move;
    typedef struct {
        double max_speed[3], max_accel[3];
        double corner, tol;
        ...;
    } loft_limits;
    int loft_bezier_init(loft_bezier *, const loft_vec *, unsigned);
    loft_vec loft_bezier_eval(const loft_bezier *, double);
    int loft_bezier_deriv(const loft_bezier *, unsigned, double, loft_vec *);
    int loft_forward_init(loft_forward *, const loft_bezier *, uint32_t);
    uint32_t loft_forward_run(loft_forward *, loft_vec *, uint32_t);
    double loft_cubic_arclen(const loft_cubic *, double);
    int loft_flatten_init(loft_flatten *, const loft_cubic *, double);
    bool loft_flatten_next(loft_flatten *, loft_vec *);
    int loft_plan_init(loft_plan *, const loft_limits *, loft_move *, uint16_t,
                       loft_knot *, uint16_t);
    int loft_plan_push(loft_plan *, const loft_move *);
    void loft_plan_end(loft_plan *);
    int loft_plan_next(loft_plan *, loft_span *);
    int loft_span_walk(loft_forward *, const loft_span *);
    uint16_t py_left(const loft_plan *);
    void py_limits(loft_limits *, const double *speed, const double *accel, const double *jerk,
                   double tol, double corner, unsigned tick_hz);
    #define LOFT_OK ...
    #define LOFT_ERR_ARG ...
    #define LOFT_ERR_RANGE ...
    #define LOFT_ERR_SPACE ...
    #define LOFT_PLAN_SPAN ...
    #define LOFT_PLAN_REST ...
''')
builder.set_source('loft._loft', r'''
    #include "loft.h"
    static void py_limits(loft_limits *to, const double *speed, const double *accel,
                          const double *jerk, double tol, double corner, unsigned tick_hz)
    {
        loft_limits l = { .corner = corner, .tol = tol, .tick_hz = tick_hz };
        for (int i = 0; i < LOFT_AXES; i++) {
            l.max_speed[i] = speed[i];
            l.max_accel[i] = accel[i];
            l.max_jerk[i] = (__typeof__(l.max_jerk[0]))jerk[i];
        }
        *to = l;
    }
    static uint16_t py_left(const loft_plan *p) { return loft_plan_room(p); }
''', sources=['made/loft.c'], include_dirs=['made'],
    define_macros=[('LOFT_NUM', 'LOFT_F64'), ('LOFT_AXES', '3')],
    extra_compile_args=['-std=gnu99', '-O2'])
