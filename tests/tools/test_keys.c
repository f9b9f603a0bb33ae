/* tests/tools/test_keys.c -- ^C around a long computation: it is never lost
 * SPDX-License-Identifier: MIT
 */
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <sysexits.h>
#include <unistd.h>

#include "cmd/keys.h"
#include "check.h"

enum { LEFT_ALONE = 99 };

/* How a process ends that gets ^C `before` it computes, while it does, or when it has. */
static int ends_with(bool before, bool during, bool after)
{
    const pid_t child = fork();
    int status        = 0;

    if (child == 0) {
        (void)dup2(open("/dev/null", O_WRONLY), STDERR_FILENO);
        keys_start(false);
        if (before)
            (void)raise(SIGINT);
        keys_hasty(true);
        if (during)
            (void)raise(SIGINT);
        keys_hasty(false);
        if (after)
            (void)raise(SIGINT);
        _exit(keys_interrupted() ? EXIT_SUCCESS : LEFT_ALONE);
    }
    (void)waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

static void interrupts_are_never_lost(arb *a)
{
    (void)a;
    CHECK(ends_with(false, false, false) == LEFT_ALONE);
    CHECK(ends_with(true, false, false) == EX_TEMPFAIL);
    CHECK(ends_with(false, true, false) == EX_TEMPFAIL);
    CHECK(ends_with(false, false, true) == EXIT_SUCCESS);
}

int main(void)
{
    PROPERTY(interrupts_are_never_lost, 1);
    return check_failures();
}
