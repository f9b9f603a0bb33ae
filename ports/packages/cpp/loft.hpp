/* ports/packages/cpp/loft.hpp -- loft for C++17: operators, walks in loops; all of it inline
 * SPDX-License-Identifier: MIT
 *
 *     const loft::point p[] = { {0, 0}, {10, 40}, {30, 40}, {40, 0} };
 *     const loft::bezier curve(p);
 *     if (curve)
 *         for (const loft::vec &at : curve.walk(64))
 *             move_to(at);
 *
 * Each function is one call of C, and each type holds the C one and nothing else: the loop above
 * has 128 bytes on a Cortex-M0+, 124 by the calls of C (make check-packages-cpp). No exceptions, no
 * allocation: what can fail is false.
 */
#ifndef LOFT_HPP
#define LOFT_HPP

#include <cstddef>

#include "loft.h"

namespace loft {

/* A coordinate from a number that the compiler knows. */
constexpr loft_real real(double x)
{
#if LOFT_NUM == LOFT_Q16
    return static_cast<loft_real>(x * 65536.0 + (x < 0 ? -0.5 : 0.5));
#else
    return static_cast<loft_real>(x);
#endif
}

/* A parameter, 0..1. */
constexpr loft_unit unit(double t)
{
#if LOFT_NUM == LOFT_Q16
    return static_cast<loft_unit>(t * 16777216.0 + (t < 0 ? -0.5 : 0.5));
#else
    return static_cast<loft_unit>(t);
#endif
}

/* A point or a difference of two. It is a loft_vec, and goes wherever one is asked for. */
struct vec : loft_vec {
    vec() = default;            /* not set, as in C */
    constexpr vec(const loft_vec &v) : loft_vec(v) {}
    constexpr vec(double x, double y = 0, double z = 0) : loft_vec{}
    {
        const double given[] = { x, y, z };
        for (int i = 0; i < LOFT_AXES && i < 3; i++)
            axis[i] = real(given[i]);
    }
    constexpr loft_real operator[](int i) const { return axis[i]; }
    constexpr loft_real &operator[](int i) { return axis[i]; }
};
using point = vec;

inline vec operator+(const vec &a, const vec &b) { return loft_vec_add(a, b); }
inline vec operator-(const vec &a, const vec &b) { return loft_vec_sub(a, b); }
inline bool operator==(const vec &a, const vec &b) { return loft_vec_equal(a, b); }
inline bool operator!=(const vec &a, const vec &b) { return !loft_vec_equal(a, b); }
inline vec lerp(const vec &a, const vec &b, loft_unit t) { return loft_vec_lerp(a, b, t); }

/* Points of a caller: an array, or a place and a count. */
class points {
    const loft_vec *first;
    std::size_t count;

public:
    constexpr points(const loft_vec *p, std::size_t n) : first(p), count(n) {}
    template <std::size_t n> constexpr points(const loft_vec (&p)[n]) : first(p), count(n) {}
    template <std::size_t n> constexpr points(const vec (&p)[n]) : first(p), count(n) {}
    constexpr const loft_vec *data() const { return first; }
    constexpr std::size_t size() const { return count; }
};

/* A walk that a `for` runs through, by additions; none where forward.h refuses it. */
class walk {
    loft_forward state;
    vec at;

public:
    walk(const loft_bezier &b, uint32_t n)
    {
        state.left = 0;             /* stays where it is refused */
        (void)(loft_forward_init(&state, &b, n) == LOFT_OK);
    }
    explicit operator bool() const { return state.left > 0; }

    struct end_of_walk {};
    class iterator {
        walk *w;
        bool more;

    public:
        explicit iterator(walk *of) : w(of), more(of->next()) {}
        const vec &operator*() const { return w->at; }
        iterator &operator++()
        {
            more = w->next();
            return *this;
        }
        bool operator!=(end_of_walk) const { return more; }
    };
    iterator begin() { return iterator(this); }
    end_of_walk end() const { return {}; }
    bool next() { return loft_forward_next(&state, &at); }
    const vec &operator*() const { return at; }
};

/* A curve over control points, which stay where they are; false where bezier.h refuses them. */
class bezier {
    loft_bezier c;

public:
    explicit bezier(points p)
    {
        if (loft_bezier_init(&c, p.data(), unsigned(p.size() - 1)) != LOFT_OK)
            c.p = nullptr;
    }
    explicit operator bool() const { return c.p != nullptr; }
    vec operator()(loft_unit t) const { return loft_bezier_eval(&c, t); }
    loft::walk walk(uint32_t n) const { return { c, n }; }
    const loft_bezier *get() const { return &c; }
};

}

#endif
