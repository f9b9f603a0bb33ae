/* ports/bare/no_outputs.c -- of a board that drives neither a laser nor a spindle
 * SPDX-License-Identifier: MIT
 */
#include "port.h"       /* loft_port_output */

void loft_port_output(int output, uint16_t level)
{
    (void)output;
    (void)level;
}
