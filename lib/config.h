/* lib/config.h -- every option of loft: meaning, default, range, cost
 * SPDX-License-Identifier: MIT
 *
 * Set an option on the compiler's command line (-DLOFT_NUM=LOFT_F32) or change it here. All files
 * of one program that share a loft object must agree on LOFT_NUM and LOFT_AXES; names.h turns a
 * disagreement into a link error that names both.
 */
#ifndef LOFT_CONFIG_H
#define LOFT_CONFIG_H

#define LOFT_Q16 1      /* Q16.16 fixed point: -32768 .. 32767.99998 in steps of 2^-16  */
#define LOFT_F32 2      /* float, with double sums                                      */
#define LOFT_F64 3      /* double                                                       */

/* The number type of coordinates. */
#ifndef LOFT_NUM
#  define LOFT_NUM LOFT_Q16
#endif

/* Coordinates per point, 1..6; must be a bare literal (it becomes part of every symbol).
 * Cost: memory and time are proportional to it. */
#ifndef LOFT_AXES
#  define LOFT_AXES 3
#endif
#if LOFT_AXES < 1 || LOFT_AXES > 6
#  error "LOFT_AXES must be 1..6"
#endif

/* Items (spans or points) that a machine keeps in its queue; a power of two, 2..32768.
 * Cost: about 12 * LOFT_AXES + 4 bytes of RAM each in q16. */
#ifndef LOFT_MACHINE_QUEUE
#  define LOFT_MACHINE_QUEUE 64
#endif
#if LOFT_MACHINE_QUEUE < 2 || LOFT_MACHINE_QUEUE > 32768 ||                                        \
    (LOFT_MACHINE_QUEUE & (LOFT_MACHINE_QUEUE - 1))
#  error "LOFT_MACHINE_QUEUE must be a power of two, 2..32768"
#endif

/* What the tick does with a span that the main loop has not prepared in time. 1: prepares it
 * itself, which takes longer than a tick on a slow part. 0: waits for it and counts that among the
 * slowed ticks, which needs less stack. */
#ifndef LOFT_MACHINE_TICK_PREPARES
#  define LOFT_MACHINE_TICK_PREPARES 1
#endif

/* 1: the slot obeys a hard stop. 0: the port calls loft_step_halt, as it drops slots that it has
 * made ahead. */
#ifndef LOFT_MACHINE_SLOT_HALTS
#  define LOFT_MACHINE_SLOT_HALTS 1
#endif

/* 1: axes may have two motors that are squared: see LOFT_GUARD_SQUARE. */
#ifndef LOFT_MACHINE_SQUARES
#  define LOFT_MACHINE_SQUARES 1
#endif

/* When the override limit of a span is computed, by which an override above 100 percent keeps to
 * the limits of the axes.
 *   1: always when the span is queued: 6,000 cycles on an AVR with two axes that move
 *   0: only while the override is above 100; what is in the queue when it is given passes as
 *      planned */
#ifndef LOFT_MACHINE_OVERRIDE_LIMITS
#  define LOFT_MACHINE_OVERRIDE_LIMITS 1
#endif

/* Outputs of a machine beside its motors (laser, spindle, relays) that actions among its spans set,
 * 0..15; with 0 it takes no actions, so no pauses either.
 * Cost: 2.1 kB of flash on an AVR; 9 bytes of RAM each, and 24. */
#ifndef LOFT_MACHINE_OUTPUTS
#  define LOFT_MACHINE_OUTPUTS 2
#endif
#if LOFT_MACHINE_OUTPUTS < 0 || LOFT_MACHINE_OUTPUTS > 15
#  error "LOFT_MACHINE_OUTPUTS must be 0..15"
#endif

/* How much work the planner does.
 *   1: places are not guessed twice, paces are raised less, and a call of loft_plan_part does a
 *      part of the work: for small chips (Cortex-M, 32-bit RISC-V and Xtensa, AVR)
 *   2: all of it, as soon as a span is asked for */
#ifndef LOFT_PLAN_EFFORT
#  if (defined(__ARM_ARCH_PROFILE) && __ARM_ARCH_PROFILE == 'M') || defined(__AVR__) ||            \
      (defined(__riscv_xlen) && __riscv_xlen == 32) || defined(__XTENSA__)
#    define LOFT_PLAN_EFFORT 1
#  else
#    define LOFT_PLAN_EFFORT 2
#  endif
#endif
#if LOFT_PLAN_EFFORT < 1 || LOFT_PLAN_EFFORT > 2
#  error "LOFT_PLAN_EFFORT must be 1 or 2"
#endif

/* A machine plans by itself, so that curves can be sent to it. 1: if it is given memory for it
 * (lib/machine/planner.h). Cost: the code of lib/motion/plan in the firmware, whether
 * memory is given or not. */
#ifndef LOFT_MACHINE_PLANS
#  if defined(__AVR__)
#    define LOFT_MACHINE_PLANS 0
#  else
#    define LOFT_MACHINE_PLANS 1
#  endif
#endif

/* The longest frame on the wire in bytes, delimiter included, 64..254 (one COBS block). Cost: that
 * much RAM for receiving and again for sending. The machine announces its own; the host keeps to
 * the smaller of both. */
#ifndef LOFT_FRAME_MAX
#  define LOFT_FRAME_MAX 128
#endif
#if LOFT_FRAME_MAX < 64 || LOFT_FRAME_MAX > 254
#  error "LOFT_FRAME_MAX must be 64..254"
#endif

/* C++ calls the functions that a C compiler made: each header declares them between these two. */
#ifdef __cplusplus
#  define LOFT_BEGIN_C extern "C" {
#  define LOFT_END_C   }
#else
#  define LOFT_BEGIN_C
#  define LOFT_END_C
#endif

#include "names.h"

#endif
