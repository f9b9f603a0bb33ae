/* lib/num/status.h -- what a function reports: each code names whose fault it is and the remedy
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_NUM_STATUS_H
#define LOFT_NUM_STATUS_H

enum loft_status {
    LOFT_SINGULAR  =  2,    /* an answer: none exists here (no direction, two points in one)     */
    LOFT_MORE      =  1,    /* not finished: give more input, or take more output                */
    LOFT_OK        =  0,
    LOFT_ERR_ARG   = -1,    /* a mistake of the caller: a count of 0, degree or t out of range   */
    LOFT_ERR_RANGE = -2,    /* the numbers do not fit: scale the part or take fewer steps        */
    LOFT_ERR_SPACE = -3,    /* the caller's buffer is too small: give a larger one               */
    LOFT_ERR_DATA  = -4     /* the other side sent nonsense: bad CRC, unknown message            */
};

/* Marks a result that must not be ignored. */
#if defined(__GNUC__)
#  define LOFT_CHECKED __attribute__((warn_unused_result))
#else
#  define LOFT_CHECKED
#endif

#endif
