/* host-tools/cmd/describe.c -- descriptions of commands: help, man page, completions of shells
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include <string.h>

#include "cmd/describe.h"
#include "cmd/describe_json.h"

enum { LONGEST = 80 };      /* of a name, its value, and an option's column in the help */

/* The named rows of a table, in order. */
typedef struct {
    option_at all[OPTIONS_MOST];
    size_t count;
} named;

static named named_rows(const option rows[])
{
    named n            = { .count = 0 };
    const size_t count = option_all(rows, n.all);

    for (size_t i = 0; i < count; i++)
        if (option_is_named(n.all[i].row))
            n.all[n.count++] = n.all[i];
    return n;
}

/* The heading above named row i, if it is another one than above the row before; or NULL. */
static const char *heading_at(const option rows[], const named *n, size_t i)
{
    option_at all[OPTIONS_MOST];
    const size_t count  = option_all(rows, all);
    const char *heading = NULL;

    for (size_t k = 0; k < count && all[k].row != n->all[i].row; k++)
        if (all[k].row->kind == OPTION_IS_HEADING)
            heading = all[k].row->help;
        else if (option_is_named(all[k].row))
            heading = NULL;
    return heading;
}

/* The words of "q16|f32|f64", separated by spaces. */
static const char *words_of(const option *o, char words[LONGEST])
{
    snprintf(words, LONGEST, "%s", o->choices);
    for (char *c = words; *c; c++)
        if (*c == '|')
            *c = ' ';
    return words;
}

/* Print text with a backslash before each character of `special`. */
static void put_escaped(const char *text, const char *special)
{
    for (; *text; text++) {
        if (strchr(special, *text) != NULL)
            putchar('\\');
        putchar(*text);
    }
}

static void put_without(const char *text, const char *special)
{
    for (; *text; text++)
        if (strchr(special, *text) == NULL)
            putchar(*text);
}

/* Print text between the single quotes of a shell. */
static void put_quoted(const char *text)
{
    for (; *text; text++)
        if (*text == '\'')
            fputs("'\\''", stdout);
        else
            putchar(*text);
}

static void print_help(const command *self, const option rows[])
{
    printf("loft %s -- %s\n\nusage: loft %s %s\n", self->name, self->summary, self->name,
           self->arguments);
    if (self->detail)
        printf("\n%s", self->detail);
    printf("\noptions:\n");
    const named n = named_rows(rows);
    for (size_t i = 0; i < n.count; i++) {
        const option *o = n.all[i].row;
        const bool maybe = o->kind == OPTION_IS_MAYBE;
        char both[2 * LONGEST], value[80], help[400];
        const char *heading = heading_at(rows, &n, i);
        if (heading != NULL)
            printf("\n%s:\n", heading);
        (void)option_value(o, value);
        snprintf(both, sizeof both, "--%s%s%s%s", o->name,
                 maybe    ? " ["
                 : *value ? " "
                          : "",
                 value, maybe ? "]" : "");
        printf("  %-20s %s\n", both, option_help(o, help));
    }
    printf("  %-20s %s\n", "--help", "this text");
}


// Man pages
// ---------

/* Print a line of roff: backslashes and minus signs are escaped, and a control character does not
 * begin the line. */
static void put_roff(const char *text, size_t length)
{
    if (length > 0 && (*text == '.' || *text == '\''))
        fputs("\\&", stdout);
    for (size_t i = 0; i < length; i++)
        if (text[i] == '\\')
            fputs("\\e", stdout);
        else if (text[i] == '-')
            fputs("\\-", stdout);
        else
            putchar(text[i]);
}

static void put_man(const char *text) { put_roff(text, strlen(text)); }

/* Print paragraphs. Indented lines stay as they are. */
static void put_paragraphs(const char *text)
{
    bool kept = false;

    while (*text) {
        const size_t length = strcspn(text, "\n");
        const bool indented = *text == ' ';
        if (indented != kept)
            puts(indented ? ".nf" : ".fi");
        kept = indented;
        if (length == 0)
            fputs(".PP", stdout);
        else
            put_roff(text, length);
        putchar('\n');
        text += length + (text[length] == '\n');
    }
    if (kept)
        puts(".fi");
}

static void man_head(const char *name, const char *summary)
{
    printf(".TH loft%s%s 1 \"\" \"loft %s\" \"loft\"\n.SH NAME\nloft%s%s \\- ", *name ? "\\-" : "",
           name, tool_version, *name ? "\\-" : "", name);
    put_man(summary);
    printf("\n.SH SYNOPSIS\n.B loft%s%s\n", *name ? " " : "", name);
}

static void man_command(const command *self, const option rows[])
{
    man_head(self->name, self->summary);
    put_man(self->arguments);
    if (self->detail) {
        puts("\n.SH DESCRIPTION");
        put_paragraphs(self->detail);
    } else {
        putchar('\n');
    }
    puts(".SH OPTIONS");
    const named n = named_rows(rows);
    for (size_t i = 0; i < n.count; i++) {
        const option *o = n.all[i].row;
        char value[80], help[400];
        const char *heading = heading_at(rows, &n, i);
        if (heading != NULL)
            printf(".SS %s\n", heading);
        printf(".TP\n\\fB\\-\\-");
        put_man(o->name);
        printf("\\fR");
        if (*option_value(o, value)) {
            printf(o->kind == OPTION_IS_MAYBE ? " [\\fI" : " \\fI");
            put_man(value);
            printf(o->kind == OPTION_IS_MAYBE ? "\\fR]" : "\\fR");
        }
        putchar('\n');
        put_man(option_help(o, help));
        putchar('\n');
    }
    puts(".TP\n\\fB\\-\\-help\\fR\nPrint a summary of these options.\n"
         ".SH \"EXIT STATUS\"\n"
         "0, or a code of\n.IR sysexits.h :\n"
         "64 usage, 65 data, 66 no such file, 68 no such host, 69 no machine, 70 a fault of loft,\n"
         "71 no memory or files left, 73 a file cannot be written, or is a symbolic link,\n"
         "74 reading or writing failed, 75 try again, 76 the machine does not understand,\n"
         "77 not permitted, 78 the machine refuses.\n"
         ".SH \"SEE ALSO\"\n.BR loft (1)");
}

static void man_all(const command *const commands[], size_t count)
{
    man_head("", "curves from the drawing to the step pulse");
    puts("COMMAND [options] [FILE|\\-]\n"
         ".SH DESCRIPTION\n"
         "Reads drawings and curves, plans how a machine moves along them, and streams that to "
         "it.\n"
         "Coordinates are in mm. Commands read a file or standard input and pipe into each other.\n"
         ".SH COMMANDS");
    for (size_t i = 0; i < count; i++) {
        printf(".TP\n\\fB%s\\fR\n", commands[i]->name);
        put_man(commands[i]->summary);
        putchar('\n');
    }
    puts(".SH OPTIONS\n"
         ".TP\n\\fB\\-\\-help\\fR\nPrint the list of commands. loft COMMAND \\-\\-help tells "
         "more.\n"
         ".TP\n\\fB\\-\\-version\\fR\nPrint the version.\n"
         ".TP\n\\fB\\-\\-help\\fR=\\fIman\\fR|\\fIbash\\fR|\\fIzsh\\fR|\\fIfish\\fR\n"
         "Print this page, or completions for a shell.");
    printf(".SH \"SEE ALSO\"\n");
    for (size_t i = 0; i < count; i++)
        printf(".BR loft\\-%s (1)%s\n", commands[i]->name, i + 1 < count ? "," : "");
}


// Completions
// -----------

static void bash_command(const command *self, const option rows[])
{
    const named n = named_rows(rows);
    char words[LONGEST];

    printf("    %s)\n        case $before in\n", self->name);
    for (size_t i = 0; i < n.count; i++) {
        const option *o = n.all[i].row;
        if (o->kind == OPTION_IS_FILE)
            printf("        --%s) kind=file ;;\n", o->name);
        else if (o->kind == OPTION_IS_FOLDER)
            printf("        --%s) kind=folder ;;\n", o->name);
        else if (o->choices != NULL)
            printf("        --%s) kind=word words='%s' ;;\n", o->name, words_of(o, words));
        else if (o->kind != OPTION_IS_FLAG)
            printf("        --%s) kind=none ;;\n", o->name);
    }
    printf("        esac\n        options='");
    for (size_t i = 0; i < n.count; i++)
        printf("--%s ", n.all[i].row->name);
    printf("--help'\n        ;;\n");
}

/* Print the help of an option within brackets and quotes. */
static void put_zsh(const option *o)
{
    char help[400];

    for (const char *c = option_help(o, help); *c; c++) {
        char one[2] = { *c, '\0' };
        if (strchr("[]\\:", *c))
            putchar('\\');
        put_quoted(one);
    }
}

static void zsh_command(const command *self, const option rows[])
{
    const named n = named_rows(rows);
    char words[LONGEST], value[80];

    printf("    %s)\n        _arguments \\\n", self->name);
    for (size_t i = 0; i < n.count; i++) {
        const option *o = n.all[i].row;
        printf("            '%s--%s[", o->kind == OPTION_IS_LIST ? "*" : "", o->name);
        put_zsh(o);
        putchar(']');
        if (o->kind != OPTION_IS_FLAG) {
            printf(":%s", o->kind == OPTION_IS_MAYBE ? ":" : "");
            put_without(o->choices ? o->name : option_value(o, value), ":[]'");
            putchar(':');
        }
        if (o->kind == OPTION_IS_FILE)
            printf("_files");
        else if (o->kind == OPTION_IS_FOLDER)
            printf("_files -/");
        else if (o->choices != NULL)
            printf("(%s)", words_of(o, words));
        printf("' \\\n");
    }
    printf("            '--help[print a summary]' \\\n            '*:file:_files'\n        ;;\n");
}

static void fish_command(const command *self, const option rows[])
{
    const named n = named_rows(rows);
    char words[LONGEST], help[400];

    printf("complete -c loft -n __fish_use_subcommand -f -a %s -d '", self->name);
    put_escaped(self->summary, "\\'");
    printf("'\n");
    for (size_t i = 0; i < n.count; i++) {
        const option *o = n.all[i].row;
        printf("complete -c loft -n '__fish_seen_subcommand_from %s' -l %s", self->name, o->name);
        if (o->kind == OPTION_IS_FILE)
            printf(" -r -F");
        else if (o->kind == OPTION_IS_FOLDER)
            printf(" -x -a '(__fish_complete_directories)'");
        else if (o->choices != NULL)
            printf(" -x -a '%s'", words_of(o, words));
        else if (o->kind != OPTION_IS_FLAG && o->kind != OPTION_IS_MAYBE)
            printf(" -x");
        printf(" -d '");
        put_escaped(option_help(o, help), "\\'");
        printf("'\n");
    }
}

/* What a shell's completions have before and after the list of commands. */
static const struct shell {
    const char *name;
    void (*describe)(const command *self, const option rows[]);
    const char *head, *foot;
} shells[] = {
    { "bash", bash_command,
      "    local now=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}\n"
      "    local kind=file words='' options=''\n"
      "    COMPREPLY=()\n"
      "    if [ \"$COMP_CWORD\" = 1 ]; then\n"
      "        mapfile -t COMPREPLY < <(compgen -W \"$commands help --help --version\" -- "
      "\"$now\")\n"
      "        return\n"
      "    fi\n"
      "    case ${COMP_WORDS[1]} in\n"
      "    help) kind=word words=$commands ;;\n",
      "    esac\n"
      "    case $kind:$now in\n"
      "    file:-*) mapfile -t COMPREPLY < <(compgen -W \"$options\" -- \"$now\") ;;\n"
      "    file:*)  compopt -o filenames 2>/dev/null\n"
      "             mapfile -t COMPREPLY < <(compgen -f -- \"$now\") ;;\n"
      "    folder:*) compopt -o filenames 2>/dev/null\n"
      "             mapfile -t COMPREPLY < <(compgen -d -- \"$now\") ;;\n"
      "    word:*)  mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$now\") ;;\n"
      "    esac\n"
      "}\n"
      "complete -F _loft loft\n" },
    { "zsh", zsh_command, "", "    *) _files ;;\n    esac\n}\n_loft \"$@\"\n" },
    { "fish", fish_command,
      "complete -c loft -n __fish_use_subcommand -f -a help "
      "-d 'tell more about a command'\n",
      "" },
};

static const struct shell *shell_of(const char *form)
{
    for (size_t i = 0; i < sizeof shells / sizeof shells[0]; i++)
        if (strcmp(form, shells[i].name) == 0)
            return &shells[i];
    return NULL;
}

static int refuse_form(const char *form)
{
    return tool_error(EX_USAGE, "--help=%s: give man, bash, zsh, fish or json, or --help alone",
                      form);
}

int describe_command(const char *form, const command *self, const option rows[])
{
    const struct shell *shell = form ? shell_of(form) : NULL;

    if (shell != NULL)
        shell->describe(self, rows);
    else if (form == NULL)
        print_help(self, rows);
    else if (strcmp(form, "man") == 0)
        man_command(self, rows);
    else if (strcmp(form, "json") == 0)
        describe_json(self, rows);
    else
        return refuse_form(form);
    return EX_OK;
}

static void shell_head(const struct shell *shell, const command *const commands[], size_t count)
{
    printf("%s loft %s -- completions, made by `loft --help=%s`\n",
           strcmp(shell->name, "zsh") == 0 ? "#compdef loft\n#" : "#", tool_version, shell->name);
    if (strcmp(shell->name, "bash") == 0) {
        printf("_loft()\n{\n    local commands='");
        for (size_t i = 0; i < count; i++)
            printf("%s%s", i > 0 ? " " : "", commands[i]->name);
        puts("'");
    }
    if (strcmp(shell->name, "zsh") == 0) {
        puts("_loft()\n{\n    local -a commands=(");
        for (size_t i = 0; i < count; i++) {
            printf("        '%s:", commands[i]->name);
            put_quoted(commands[i]->summary);
            puts("'");
        }
        puts("        'help:tell more about a command'\n    )\n"
             "    if (( CURRENT == 2 )); then\n"
             "        _describe 'command of loft' commands\n        return\n    fi\n"
             "    local command=$words[2]\n"
             "    shift words\n    (( CURRENT-- ))\n"
             "    case $command in\n"
             "    help) _describe 'command of loft' commands ;;");
    }
    fputs(shell->head, stdout);
}

static void describe_one(const struct shell *shell, const command *self)
{
    option whole[3];

    command_options(self, whole);
    if (shell != NULL)
        shell->describe(self, whole);
    else
        describe_json(self, whole);
}

int describe_all(const char *form, const command *const commands[], size_t count)
{
    const struct shell *shell = shell_of(form);
    const bool json           = strcmp(form, "json") == 0;

    if (strcmp(form, "man") == 0) {
        man_all(commands, count);
        return EX_OK;
    }
    if (shell == NULL && !json)
        return refuse_form(form);
    if (json)
        printf("{\"version\": \"%s\", \"commands\": [\n", tool_version);
    else
        shell_head(shell, commands, count);
    for (size_t i = 0; i < count; i++) {
        fputs(json && i > 0 ? ",\n" : "", stdout);
        describe_one(shell, commands[i]);
    }
    fputs(json ? "\n]}\n" : shell->foot, stdout);
    return EX_OK;
}
