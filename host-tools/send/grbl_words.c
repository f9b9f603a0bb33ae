/* host-tools/send/grbl_words.c
 * SPDX-License-Identifier: MIT
 *
 * The numbers are those of grbl 1.1 (its wiki, "Interface", and the csv files beside its source);
 * grblHAL adds to them.
 */
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "send/grbl_words.h"

typedef struct {
    int number;
    const char *text;
} meaning;

static const meaning errors[] = {
    { 1, ": a word without a letter: bytes were bent or lost on the line" },
    { 2, ": a number that cannot be read: bytes were bent or lost on the line" },
    { 3, ": an unknown $ command" },
    { 4, ": a negative number where none may be" },
    { 5, ": homing is switched off ($22)" },
    { 8, ": a command that needs the machine idle" },
    { 9, ": it is locked: home ($H) or unlock it ($X)" },
    { 11, ": the line is too long for it" },
    { 14, ": the line is too long for it" },
    { 15, ": the place lies beyond its travel ($130 to $132): move the drawing or the work zero" },
    { 20, ": a command that it does not know: run without --g5" },
    { 21, ": two commands of one group in a line" },
    { 22, ": no feed was given" },
    { 23, ": a whole number was wanted" },
    { 26, ": an axis word is missing" },
    { 33, ": an arc that does not end on its circle: bytes were bent on the line" },
    { 35, ": an arc without a centre" },
    { 36, ": words that the command does not use: bytes were bent on the line" }
};

static const meaning alarms[] = {
    { 1, ": a limit switch was hit and the position may be lost: free the machine, home it" },
    { 2,
      ": the place lies beyond its travel ($130 to $132): the position is kept; unlock with $X" },
    { 3, ": reset while it moved: the position is lost; home it" },
    { 4, ": the probe was not in its first state" },
    { 5, ": the probe touched nothing" },
    { 6, ": homing was reset" },
    { 7, ": the door was opened while homing" },
    { 8, ": homing did not leave the switch" },
    { 9, ": homing did not find the switch" }
};

/* A state without a colon stands for those with one that are not listed. */
static const grbl_state states[] = {
    { "Idle", GRBL_IDLE, "" },
    { "Run", GRBL_RUNS, "" },
    { "Jog", GRBL_RUNS, "" },
    { "Hold:0", GRBL_STANDS, "" },
    { "Hold", GRBL_SLOWS, "" },
    { "Door:0", GRBL_AWAITS, "its door was open and is closed again: its button, or r, goes on" },
    { "Door:1", GRBL_AWAITS, "its door is open: close it, then its button, or r, goes on" },
    { "Door", GRBL_SLOWS, "its door is or was open: it stops, or is about to go on" },
    { "Home", GRBL_AWAITS, "it homes itself" },
    { "Tool", GRBL_AWAITS, "it awaits another tool: put it in, then its button, or r, goes on" },
    { "Alarm", GRBL_ENDS, "it is locked after an alarm: home it ($H) or unlock it ($X)" },
    { "Sleep", GRBL_ENDS, "it sleeps, with its motors off: reset it, then home it" },
    { "Check", GRBL_ENDS, "it reads lines and does not draw them: $C ends that" },
};

static const grbl_state unknown = { "", GRBL_AWAITS,
                                    "this state is not known here: look at the controller" };

const grbl_state *grbl_state_of(const char *report)
{
    const size_t whole = strcspn(report, "|>"), name = strcspn(report, ":|>");

    for (size_t i = 0; i < sizeof states / sizeof *states; i++) {
        const size_t size = strlen(states[i].word);
        if ((size == whole || size == name) && strncmp(report, states[i].word, size) == 0)
            return &states[i];
    }
    return &unknown;
}

/* `said` is a whole number, or words that explain themselves. */
static const char *find(const meaning *list, size_t count, const char *said)
{
    char number[16];

    if (said[0] == '\0' || said[strspn(said, "0123456789")] != '\0')
        return "";
    for (size_t i = 0; i < count; i++) {
        snprintf(number, sizeof number, "%d", list[i].number);
        if (strcmp(number, said) == 0)
            return list[i].text;
    }
    return ": see the controller's documentation";
}

const char *grbl_error_text(const char *said)
{
    return find(errors, sizeof errors / sizeof *errors, said);
}

const char *grbl_alarm_text(const char *said)
{
    return find(alarms, sizeof alarms / sizeof *alarms, said);
}
