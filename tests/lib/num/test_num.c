/* tests/lib/num/test_num.c -- every scalar function of lib/num keeps the bound in its docstring,
 * also at the extremes
 * SPDX-License-Identifier: MIT
 */
#include "num/num.h"

#if LOFT_NUM == LOFT_Q16
#  include "support/num_q16.h"      /* test_num: against exact integers */
#else
#  include "support/num_floats.h"   /* test_num: against long double    */
#endif

int main(void) { return test_num(); }
