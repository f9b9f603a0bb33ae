# tests/vectors/own/exact.py -- polynomials of fractions, their roots, and the rows of a CSV; no
# code of the library
# SPDX-License-Identifier: MIT
"""Polynomials are lists of Fractions, the constant first. Roots are isolated by Sturm's theorem and
halved to 2^-100, so that 20 digits are right."""
import math
from fractions import Fraction as F

ONE = 65536


def trim(p):
    while p and p[-1] == 0:
        p = p[:-1]
    return p


def add(p, q, by=1):
    n = max(len(p), len(q))
    at = lambda x, k: x[k] if k < len(x) else F(0)
    return trim([at(p, k) + by * at(q, k) for k in range(n)])


def sub(p, q):
    return add(p, q, -1)


def mul(p, q):
    out = [F(0)] * max(len(p) + len(q) - 1, 0)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            out[i + j] += a * b
    return trim(out)


def scale(p, c):
    return trim([c * x for x in p])


def deriv(p):
    return trim([k * p[k] for k in range(1, len(p))])


def value(p, t):
    sum_ = F(0)
    for c in reversed(p):
        sum_ = sum_ * t + c
    return sum_


def divide(p, q):
    p, quotient = list(p), [F(0)] * max(len(p) - len(q) + 1, 1)
    while len(p) >= len(q):
        c = p[-1] / q[-1]
        shift = len(p) - len(q)
        quotient[shift] = c
        for k, x in enumerate(q):
            p[k + shift] -= c * x
        p = trim(p[:-1])
    return trim(quotient), p


def gcd(p, q):
    while q:
        p, q = q, divide(p, q)[1]
        if q:
            q = scale(q, 1 / q[-1])
    return scale(p, 1 / p[-1])


def square_free(p):
    """Yun: the factors of multiplicity 1, 2, 3 .."""
    d = deriv(p)
    if not d:
        return []
    a = gcd(p, d)
    b, c = divide(p, a)[0], divide(d, a)[0]
    out = []
    while len(b) > 1:
        e = sub(c, deriv(b))
        a = gcd(b, e) if e else scale(b, 1 / b[-1])
        out.append(a)
        b = divide(b, a)[0]
        c = divide(e, a)[0] if e else []
    return out


def changes(chain, t):
    signs = [s for s in (value(p, t) for p in chain) if s != 0]
    return sum(1 for a, b in zip(signs, signs[1:]) if (a > 0) != (b > 0))


def simple_roots(p, low, high):
    """Of a polynomial without multiple ones, in low..high, ends included."""
    out = [t for t in (low, high) if value(p, t) == 0]
    for t in out:
        p = divide(p, [-t, F(1)])[0]
    chain = [p, deriv(p)]
    while chain[-1]:
        chain.append(scale(divide(chain[-2], chain[-1])[1], F(-1)))
    chain.pop()
    todo = [(low, high)]
    while todo:
        a, b = todo.pop()
        count = changes(chain, a) - changes(chain, b)
        if count == 0:
            continue
        if count > 1:
            m = (a + b) / 2
            while value(p, m) == 0:
                m = (a + 3 * m) / 4
            todo += [(a, m), (m, b)]
            continue
        while b - a > F(1, 1 << 100):
            m = (a + b) / 2
            if value(p, m) == 0:
                a = b = m
            elif (value(p, a) > 0) != (value(p, m) > 0):
                b = m
            else:
                a = m
        out.append((a + b) / 2)
    return sorted(out)


def roots(p, low=F(0), high=F(1)):
    """All roots in low..high with their multiplicities, sorted."""
    out = []
    for k, factor in enumerate(square_free(trim(p))):
        if len(factor) > 1:
            out += [(t, k + 1) for t in simple_roots(factor, low, high)]
    return sorted(out)


def power_of(b):
    """The power form of a polynomial with these Bernstein coefficients."""
    n, out, row = len(b) - 1, [], [F(x) for x in b]
    for k in range(n + 1):
        out.append(math.comb(n, k) * row[0])
        row = [y - x for x, y in zip(row, row[1:])]
    return trim(out)


def bernstein_of(p, n):
    return [sum(F(math.comb(k, i), math.comb(n, i)) * p[i] for i in range(min(k + 1, len(p))))
            for k in range(n + 1)]


def casteljau(points, t):
    points = [list(p) for p in points]
    while len(points) > 1:
        points = [[(1 - t) * a + t * b for a, b in zip(p, q)] for p, q in zip(points, points[1:])]
    return points[0]


def root(x, bits=160):
    """The square root of a Fraction, to `bits` bits."""
    x = F(x)
    shift = max(0, bits - (x.numerator.bit_length() - x.denominator.bit_length()) // 2)
    return F(math.isqrt((x.numerator << (2 * shift)) // x.denominator), 1 << shift)


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum((x * y for x, y in zip(a, b)), F(0))


# Rows

def raw(x):
    n = F(x) * ONE
    assert n.denominator == 1, x
    return str(n.numerator)


def digits(x):
    """20 significant digits."""
    x = F(x)
    if x == 0:
        return '0'
    sign, x = ('-' if x < 0 else ''), abs(x)
    places = 19 - (len(str(x.numerator // x.denominator)) - 1 if x >= 1 else
                   -len(str(x.denominator // x.numerator)))
    n = (x * F(10) ** places + F(1, 2)).__floor__()
    if places <= 0:
        return sign + str(n * 10 ** -places)
    text = str(n).rjust(places + 1, '0')
    return (sign + text[:-places] + '.' + text[-places:]).rstrip('0').rstrip('.')


def numbers(xs, how):
    return ' '.join(how(x) for x in xs) if xs else '-'


def points(ps, how):
    return ';'.join(' '.join(how(x) for x in p) for p in ps) if ps else '-'


def grid(x):
    """The nearest multiple of 2^-16."""
    return F((F(x) * ONE + F(1, 2)).__floor__(), ONE)


def write(folder, name, title, columns, rows, file=None):
    with open(f'{folder}/{file or name}.csv', 'w') as f:
        f.write(f'# {name}: {title} | *_q16 = raw integer (value*65536); other numbers real, 20 '
                f'significant digits; columns: {columns.replace(",", " ")}\n{columns}\n')
        for row in rows:
            assert len(row) == columns.count(',') + 1, row
            f.write(','.join(str(x) for x in row) + '\n')
    print(file or name, len(rows))
