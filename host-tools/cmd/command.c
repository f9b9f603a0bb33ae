/* host-tools/cmd/command.c -- the options that all commands have
 * SPDX-License-Identifier: MIT
 */
#include "cmd/command.h"

typedef struct {
    bool strict;
} common_options;

static const option common_rows[] = { OPTION_HEADING("of each command"),
                                      { "strict", OPTION_FLAG(common_options, strict),
      .help = "a warning is an error: the command ends with it" },
                                      { 0 } };

/* Where the common ones begin, behind those of the command. */
static size_t common_offset(const command *c) { return (c->size + 15) / 16 * 16; }

void command_options(const command *c, option whole[3])
{
    whole[0] = (option){ c->name, OPTION_IS_GROUP, 0, .group = c->options };
    whole[1] = (option){ "common", OPTION_IS_GROUP, common_offset(c), .group = common_rows };
    whole[2] = (option){ .kind = OPTION_END };
}

bool command_is_strict(const command *c, const void *o)
{
    const common_options *common = (const void *)((const char *)o + common_offset(c));

    return common->strict;
}

size_t command_size(const command *c) { return common_offset(c) + sizeof(common_options); }
