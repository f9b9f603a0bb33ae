/* host-tools/send/change.h -- asks for another tool, and waits until it is in
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_CHANGE_H
#define LOFT_CHANGE_H

#include "read/machine_tools.h"

/* Print the pause of a tool, and wait for Enter or for an empty line on standard input, then for
 * its delay. `asks`: standard input is free for that. Returns 0, or EX_TEMPFAIL after one line: q,
 * ^C, the end of standard input. */
int change_tool(const machine_tool *tool, bool asks);

#endif
