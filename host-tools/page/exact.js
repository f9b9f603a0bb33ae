// host-tools/page/exact.js -- points of a Bezier curve as exact fractions, and walks that round
// SPDX-License-Identifier: MIT

export const raw = x => BigInt(Math.round(x * 65536))

const binomial = (n, k) => k === 0 ? 1n : binomial(n, k - 1) * BigInt(n - k + 1) / BigInt(k)

// Numerators of the points j / n, j = 1..count, in units of 2^-16; the denominator is n^degree.
export function exactPoints(control, n, count = n) {
    const degree = control.length - 1, out = [], N = BigInt(n)
    const weighted = control.map((p, k) => raw(p) * binomial(degree, k))
    for (let j = 1n; j <= count; j++) {
        let sum = 0n
        for (let k = 0; k <= degree; k++)
            sum += weighted[k] * j ** BigInt(k) * (N - j) ** BigInt(degree - k)
        out.push(sum)
    }
    return out
}

// What a value, given in units of 2^-16 with 20 further bits, is off an exact one: in units.
export function off(value, numerator, denominator) {
    const fine = BigInt(Math.round(value * 2 ** 20))
    return Number((fine * denominator - (numerator << 20n)) * 1000n / denominator) / 1000 / 2 ** 20
}

// The exact forward differences at 0 for n steps: numbers, in units of 2^-16.
function differences(control, n) {
    const degree = control.length - 1, N = BigInt(n) ** BigInt(degree)
    const value = [raw(control[0]) * N, ...exactPoints(control, n, degree)], out = []
    for (let row = value; row.length; row = row.slice(1).map((v, i) => v - row[i]))
        out.push(Number(row[0] * 2n ** 30n / N) / 2 ** 30)
    return out
}

// A walk whose differences are rounded at the start and after each addition.
function roundedWalk(control, n, round) {
    const d = differences(control, n).map(round), out = []
    for (let j = 0; j < n; j++) {
        for (let k = 0; k + 1 < d.length; k++)
            d[k] = round(d[k] + d[k + 1])
        out.push(d[0])
    }
    return out
}

export const naiveFixed = (control, n) => roundedWalk(control, n, Math.round)
export const naiveFloat = (control, n) =>
    roundedWalk(control, n, x => Math.fround(x / 65536) * 65536)
