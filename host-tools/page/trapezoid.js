// host-tools/page/trapezoid.js -- what is compared: trapezoids of speed over chords
// SPDX-License-Identifier: MIT
//
// Each chord is a motion of its own, with constant acceleration up and down, as in firmware without
// a limit of jerk. At a joint the speed is that of a circle which leaves the corner by `corner`.

const length = v => Math.hypot(...v)
const minus = (a, b) => a.map((x, i) => x - b[i])

// The largest speed at the joint of two directions.
function jointSpeed(before, behind, accel, corner) {
    const cosine = -(before[0] * behind[0] + before[1] * behind[1])     // of the angle inside
    const half = Math.sqrt(Math.max(0, (1 - cosine) / 2))
    return half > 0.999999 ? Infinity : Math.sqrt(accel * corner * half / (1 - half))
}

// points: the chain of chords. Returns { time, samples: [[seconds, mm/s], ..] }.
export function trapezoid(points, { speed, accel, corner, feed }) {
    const chords = points.slice(1).map((p, i) => minus(p, points[i]))
        .filter(c => length(c) > 1e-9)
    const most = Math.min(feed, speed), count = chords.length
    const way = chords.map(c => c.map(x => x / length(c)))
    const along = way.map(u => accel / Math.max(...u.map(Math.abs)))
    const joint = Array(count + 1).fill(0)
    for (let i = 1; i < count; i++)
        joint[i] = Math.min(most, jointSpeed(way[i - 1], way[i], accel, corner))
    for (let i = count - 1; i > 0; i--)
        joint[i] = Math.min(joint[i],
            Math.sqrt(joint[i + 1] ** 2 + 2 * along[i] * length(chords[i])))
    for (let i = 1; i <= count; i++)
        joint[i] = Math.min(joint[i],
            Math.sqrt(joint[i - 1] ** 2 + 2 * along[i - 1] * length(chords[i - 1])))
    const samples = [[0, 0]]
    let time = 0
    const until = (seconds, v) => samples.push([time += seconds, v])
    chords.forEach((c, i) => {
        const a = along[i], s = length(c), from = joint[i], to = joint[i + 1]
        const top = Math.min(most, Math.sqrt((from ** 2 + to ** 2) / 2 + a * s))
        const even = s - (2 * top ** 2 - from ** 2 - to ** 2) / (2 * a)
        until((top - from) / a, top)
        until(Math.max(0, even) / top, top)
        until((top - to) / a, to)
    })
    return { time, samples }
}
