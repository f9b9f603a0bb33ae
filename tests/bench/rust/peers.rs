// tests/bench/rust/peers.rs -- kurbo and lyon_geom, callable from C, for bench_peers.c
// SPDX-License-Identifier: MIT
use kurbo::{CubicBez, ParamCurveNearest, PathEl, Point};
use lyon_geom::CubicBezierSegment;

type Curve = [[f64; 2]; 4];
const MOST: usize = 4096;

fn lyon(p: &Curve) -> CubicBezierSegment<f64> {
    let at = |k: usize| lyon_geom::euclid::point2(p[k][0], p[k][1]);
    CubicBezierSegment { from: at(0), ctrl1: at(1), ctrl2: at(2), to: at(3) }
}

fn point(p: &[f64; 2]) -> Point {
    Point::new(p[0], p[1])
}

#[no_mangle]
pub unsafe extern "C" fn bench_lyon_flat(p: &Curve, tol: f64, out: *mut [f64; 4]) -> u32 {
    let mut n = 0;
    lyon(p).for_each_flattened(tol, &mut |q| {
        if n < MOST {
            *out.add(n) = [q.x, q.y, 0.0, 0.0];
            n += 1;
        }
    });
    n as u32
}

#[no_mangle]
pub unsafe extern "C" fn bench_lyon_cross(a: &Curve, b: &Curve, out: *mut [f64; 4]) -> u32 {
    let found = lyon(a).cubic_intersections_t(&lyon(b));
    for (n, (s, t)) in found.iter().enumerate() {
        *out.add(n) = [*s, *t, 0.0, 0.0];
    }
    found.len() as u32
}

#[no_mangle]
pub unsafe extern "C" fn bench_kurbo_flat(p: &Curve, tol: f64, out: *mut [f64; 4]) -> u32 {
    let path = [
        PathEl::MoveTo(point(&p[0])),
        PathEl::CurveTo(point(&p[1]), point(&p[2]), point(&p[3])),
    ];
    let mut n = 0;
    kurbo::flatten(path.iter().copied(), tol, |element| {
        if let PathEl::LineTo(q) = element {
            if n < MOST {
                *out.add(n) = [q.x, q.y, 0.0, 0.0];
                n += 1;
            }
        }
    });
    n as u32
}

#[no_mangle]
pub unsafe extern "C" fn bench_kurbo_near(
    p: &Curve, from: &[f64; 2], tol: f64, out: *mut [f64; 4],
) -> u32 {
    let curve = CubicBez::new(point(&p[0]), point(&p[1]), point(&p[2]), point(&p[3]));
    let (t, _) = curve.nearest(point(from), tol);
    *out = [t, 0.0, 0.0, 0.0];
    1
}
