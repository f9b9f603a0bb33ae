/* host-tools/cmd/dispatch.c -- a command line: options, struct, one call
 * SPDX-License-Identifier: MIT
 */
#include <stdlib.h>
#include <string.h>

#include "cmd/describe.h"       /* describe_command */
#include "cmd/dispatch.h"

int dispatch(const command *c, int argc, char **argv)
{
    const size_t size = command_size(c);
    void *o           = memset(tool_grow(NULL, size), 0, size);
    option_fault fault;
    option whole[3];

    command_options(c, whole);
    int code = options_read(whole, argc, argv, o, &fault);
    if (code == OPTIONS_HELP) {
        code = describe_command(fault.text[0] ? fault.text : NULL, c, whole);
    } else if (code != 0) {
        (void)tool_error(code, "%s", fault.text);
    } else {
        tool_host()->strict = command_is_strict(c, o);
        code = c->run(o);
    }
    free(o);
    return code;
}
