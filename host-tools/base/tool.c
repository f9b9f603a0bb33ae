/* host-tools/base/tool.c -- the version of the program
 * SPDX-License-Identifier: MIT
 */
#include "base/tool.h"
#include "loft.h"            /* LOFT_VERSION */

const char tool_version[] = LOFT_VERSION;
