// ports/packages/rust/loft-sys/src/lib.rs -- loft in q16 with three axes, without std
// SPDX-License-Identifier: MIT
//! Names are those of the headers, with `_q16x3` behind functions. Inline functions of the headers
//! and macros with arguments have no symbol: [`real`] and [`unit`] take the place of `LOFT_REAL`
//! and `LOFT_UNIT`.
#![no_std]
#![allow(non_camel_case_types, non_snake_case, non_upper_case_globals)]

#[allow(dead_code)]
mod cty {
    // core::ffi has them from Rust 1.64 on
    pub type c_schar = i8;
    pub type c_char = i8;
    pub type c_uchar = u8;
    pub type c_short = i16;
    pub type c_ushort = u16;
    #[cfg(target_pointer_width = "64")]
    pub type c_long = i64;
    #[cfg(target_pointer_width = "64")]
    pub type c_ulong = u64;
    #[cfg(not(target_pointer_width = "64"))]
    pub type c_long = i32;
    #[cfg(not(target_pointer_width = "64"))]
    pub type c_ulong = u32;
    pub type c_longlong = i64;
    pub type c_ulonglong = u64;
    pub type c_int = i32;
    pub type c_uint = u32;
    pub use core::ffi::c_void;
}

include!(concat!(env!("OUT_DIR"), "/bindings.rs"));

/// A coordinate as Q16.16, to the nearest.
pub fn real(x: f64) -> loft_real {
    (x * 65536.0 + if x < 0.0 { -0.5 } else { 0.5 }) as loft_real
}

/// A parameter as Q8.24, to the nearest.
pub fn unit(x: f64) -> loft_unit {
    (x * 16777216.0 + if x < 0.0 { -0.5 } else { 0.5 }) as loft_unit
}

#[cfg(test)]
mod tests {
    use super::*;

    fn vec(x: f64, y: f64) -> loft_vec {
        loft_vec { axis: [real(x), real(y), 0] }
    }

    #[test]
    fn a_walk_ends_on_the_last_point() {
        let p = [vec(0.0, 0.0), vec(1.0, 2.0), vec(3.0, 2.0), vec(4.0, -1.0)];
        unsafe {
            let mut curve = core::mem::zeroed::<loft_bezier>();
            let mut walk = core::mem::zeroed::<loft_forward>();
            let mut at = vec(0.0, 0.0);
            let mut points = 0;
            assert_eq!(loft_bezier_init_q16x3(&mut curve, p.as_ptr(), 3), LOFT_OK);
            assert_eq!(loft_forward_init_q16x3(&mut walk, &curve, 64), LOFT_OK);
            while loft_forward_next_q16x3(&mut walk, &mut at) {
                points += 1;
            }
            assert_eq!((points, at.axis), (64, [real(4.0), real(-1.0), 0]));
            let middle = loft_bezier_eval_q16x3(&curve, unit(0.5));
            assert_eq!(middle.axis, [real(2.0), real(1.375), 0]);
        }
    }
}
