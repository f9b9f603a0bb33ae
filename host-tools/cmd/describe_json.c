/* host-tools/cmd/describe_json.c -- a command as JSON: all that its help and its table say
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>

#include "cmd/describe_json.h"

void describe_json(const command *self, const option rows[])
{
    printf("{\"name\": \"%s\"", self->name);
    option_put_member(stdout, "arguments", self->arguments);
    option_put_member(stdout, "summary", self->summary);
    option_put_member(stdout, "detail", self->detail);
    fputs(", \"options\": [", stdout);
    option_put_json(stdout, rows, false);
    fputs("], \"rules\": [", stdout);
    option_put_json(stdout, rows, true);
    fputs("]}", stdout);
}
