/* host-tools/cmd/cmd_serve.c -- loft serve: a page for this computer's drawings and its machine
 * SPDX-License-Identifier: MIT
 */
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>
#ifdef __linux__
#  include <sys/prctl.h>
#endif

#include "base/say.h"
#include "cmd/commands.h"
#include "cmd/keys.h"           /* keys_interrupted */
#include "serve/serve.h"

#define TOKEN_BYTES 16

typedef struct {
    talk_options line;
    const char *machine, *listen, *page;
} loft_serve_options;

static const option serve_rows[] = {
    OPTION_HEADING("the machine and its line"),
    OPTION_GROUP(loft_serve_options, line, talk_rows),
    { "machine", OPTION_FILE(loft_serve_options, machine), .value = "FILE",
      .help = "a machine as text, see host-tools/MACHINE.md: it is planned for" },
    OPTION_HEADING("the page"),
    { "listen", OPTION_TEXT(loft_serve_options, listen), .value = "HOST:PORT",
      .standard = "127.0.0.1:8420",
      .help = "where it can be opened: by this computer alone, or 0.0.0.0:8420, by others with a "
              "token; port 0: any" },
    { "page", OPTION_FOLDER(loft_serve_options, page), .value = "DIR",
      .help = "serve the files of this folder, and not those of the program" },
    { "log", OPTION_FILE(loft_serve_options, line.log), .value = "FILE",
      .help = "write what passes on the line, in words" },
    OPTION_NO_WORDS("drawings are chosen in the page"),
    OPTION_EXCLUDES("port=-", "", "standard input is no machine here: name its port"),
    { 0 }
};

/* Split HOST:PORT. */
static int take_listen(const char *text, char host_name[128], unsigned *port)
{
    const char *colon = strrchr(text, ':');
    char *end         = NULL;
    const long number = colon ? strtol(colon + 1, &end, 10) : -1;

    if (colon == NULL || colon == text || colon - text >= 128 || *end != '\0' || end == colon + 1 ||
        number < 0 || number > 65535)
        return tool_error(EX_USAGE, "--listen %s: give an address and a port, as 127.0.0.1:8420",
                          text);
    snprintf(host_name, 128, "%.*s", (int)(colon - text), text);
    *port = (unsigned)number;
    return 0;
}

/* A folder of this user for the drawing of this port. */
static int find_folder(const char *port, char folder[PATH_MAX])
{
    const char *state = getenv("XDG_STATE_HOME"), *at = getenv("HOME");
    size_t used;

    if (state != NULL && *state == '/')
        used = (size_t)snprintf(folder, PATH_MAX, "%s/loft/serve/", state);
    else
        used = (size_t)snprintf(folder, PATH_MAX, "%s/.local/state/loft/serve/",
                                at != NULL && *at == '/' ? at : "/tmp");
    if (used >= PATH_MAX - 80)
        return tool_error(EX_CANTCREAT, "XDG_STATE_HOME: give a shorter path");
    for (const char *s = port ? port : "none"; *s != '\0' && used < PATH_MAX - 2; s++)
        folder[used++] = strchr("/: ", *s) ? '_' : *s;
    folder[used] = '\0';
    for (char *s = folder + 1; *s != '\0'; s++)
        if (*s == '/') {
            *s = '\0';
            (void)mkdir(folder, 0700);
            *s = '/';
        }
    if (mkdir(folder, 0700) != 0 && errno != EEXIST)
        return tool_error(EX_CANTCREAT, "%s: %s: give XDG_STATE_HOME a folder that can be written",
                          folder, strerror(errno));
    return 0;
}

/* The work ends with this program, and leaves the processor to the job. */
static void run_work(void (*work)(void *given, FILE *out), void *given, const int ends[2])
{
    FILE *out = fdopen(ends[1], "w");

    close(ends[0]);
#ifdef __linux__
    (void)prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
    (void)signal(SIGINT, SIG_IGN);
    (void)signal(SIGPIPE, SIG_DFL);
    (void)nice(10);
    if (out != NULL) {
        work(given, out);
        (void)fclose(out);
    }
    _exit(0);
}

static pid_t beside(void (*work)(void *given, FILE *out), void *given, int *fd)
{
    int ends[2];

    if (pipe2(ends, O_CLOEXEC) != 0)
        return -1;
    fflush(NULL);
    const pid_t child = fork();
    if (child == 0)
        run_work(work, given, ends);
    close(ends[1]);
    (void)fcntl(ends[0], F_SETFL, O_NONBLOCK);
    if (child < 0)
        close(ends[0]);
    *fd = ends[0];
    return child;
}

/* Hexadecimal letters that nobody guesses. */
static int make_token(char token[2 * TOKEN_BYTES + 1])
{
    unsigned char byte[TOKEN_BYTES];

    if (getrandom(byte, sizeof byte, 0) != (ssize_t)sizeof byte)
        return tool_error(EX_OSERR, "no random numbers: %s", strerror(errno));
    for (int i = 0; i < TOKEN_BYTES; i++)
        snprintf(token + 2 * i, 3, "%02x", byte[i]);
    return 0;
}

static void tell_address(const char *host_name, unsigned port, const char *token)
{
    (void)say(stdout, "page: http://%s:%u/%s%s\n", host_name, port, token ? "#token=" : "",
              token ? token : "");
    fflush(stdout);
}

static int run_serve(void *options)
{
    const loft_serve_options *o = options;
    char folder[PATH_MAX], token[2 * TOKEN_BYTES + 1], host_name[128];
    unsigned port = 0;
    int code = take_listen(o->listen, host_name, &port);

    if (code == 0)
        code = find_folder(o->line.port, folder);
    if (code == 0)
        code = make_token(token);
    if (code != 0)
        return code;
    const serve_options how = { .line    = o->line,
                                .machine = o->machine,
                                .folder  = folder,
                                .token   = serve_is_local(host_name) ? NULL : token,
                                .beside  = beside };
    const serve_place at    = { .host  = host_name,
                                .port  = port,
                                .page  = o->page,
                                .ends  = keys_interrupted,
                                .ready = tell_address };
    (void)signal(SIGPIPE, SIG_IGN);
    keys_start(false);
    return serve_run(tool_host(), &how, &at);
}

const command command_serve = {
    .name = "serve",
    .arguments = "[--port PORT]",
    .summary = "a page in the browser: drawing, plan, machine and job",
    .detail =
        "It prints the address of its page: drop a drawing there, look at its plan, jog, home and\n"
        "zero the machine, start, hold and resume the job. Any number of pages may watch; one of\n"
        "them controls, and each of them can hold. ^C holds the job on its path and ends; the "
        "same\n"
        "command goes on with it, also after the program was killed. Other computers reach it "
        "with\n"
        "--listen and a token. host-tools/SERVE.md has its messages, for other programs.\n\n"
        "  loft serve --port /dev/ttyUSB0\n"
        "  loft serve --machine plotter.txt                     plan, without a machine\n",
    .options = serve_rows,
    .size = sizeof(loft_serve_options),
    .run = run_serve,
    .talks = true,
};
