// host-tools/page/paths.js -- paths to plan: chains of cubics { p: [[x, y] * 4] }, in mm
// SPDX-License-Identifier: MIT

export const straight = (a, b) =>
    ({ p: [0, 1 / 3, 2 / 3, 1].map(t => a.map((x, k) => x + (b[k] - x) * t)) })
export const chain = points => points.slice(1).map((p, i) => straight(points[i], p))

const around = (count, radius, from = 0) => Array.from({ length: count + 1 }, (_, i) => {
    const a = from + 2 * Math.PI * (i % count) / count, r = radius(i % count)
    return [60 + r * Math.cos(a), 45 + r * Math.sin(a)]
})

// A closed curve through polar radii, as cubics that meet with their directions.
function smooth(radius, count) {
    const at = a => [60 + radius(a) * Math.cos(a), 45 + radius(a) * Math.sin(a)]
    const slope = a => at(a + 1e-5).map((x, k) => (x - at(a - 1e-5)[k]) / 2e-5)
    return Array.from({ length: count }, (_, i) => {
        const a = 2 * Math.PI * i / count, b = 2 * Math.PI * ((i + 1) % count) / count
        const third = 2 * Math.PI / count / 3
        return { p: [at(a), at(a).map((x, k) => x + slope(a)[k] * third),
            at(b).map((x, k) => x - slope(b)[k] * third), at(b)] }
    })
}

export const paths = {
    'A star': chain(around(10, i => i % 2 ? 14 : 36, Math.PI / 2)),
    'A circle of 192 chords': chain(around(192, () => 30)),
    'The same circle as cubics': smooth(() => 30, 12),
    'A flower': smooth(a => 28 + 9 * Math.cos(5 * a), 40),
    'A square': chain([[25, 15], [85, 15], [85, 75], [25, 75], [25, 15]]),
    'A zigzag': chain(Array.from({ length: 13 }, (_, i) => [12 + 8 * i, i % 2 ? 60 : 30])),
}

// Points of a chain within `tol`: chords.
export function chords(loft, path, tol) {
    return [path[0].p[0].slice(0, 2),
        ...path.flatMap(c => loft.bezier(c.p).flatten(tol).map(p => p.slice(0, 2)))]
}

// The joint at which the direction changes most.
export function sharpest(path) {
    let most = 0, place = path[0].p[0]
    path.slice(1).forEach((c, i) => {
        const [a, b] = [path[i].p, c.p], u = [a[3][0] - a[2][0], a[3][1] - a[2][1]],
            v = [b[1][0] - b[0][0], b[1][1] - b[0][1]]
        const turn = Math.abs(Math.atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1]))
        if (turn > most)
            [most, place] = [turn, b[0]]
    })
    return place
}
