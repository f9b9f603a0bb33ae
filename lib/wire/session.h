/* lib/wire/session.h -- a session: how a job reaches a machine exactly once, whatever the line does
 * SPDX-License-Identifier: MIT
 *
 * The two halves know nothing of each other's state but what the messages say:
 *
 *   receiver.h   the machine: bytes in, items in order, answers out; small, no clock
 *   sender.h     the host: asking, resuming, the report; its parts are window.h, the items on their
 *                way, and rto.h, the time to wait for an answer
 *
 * Rules, with their reasons in WIRE.md:
 *   - a HELLO begins a session; every other frame carries its number and is dropped in another
 *   session
 *   - a session has at most one JOB; a job may live through many sessions
 *   - the number of an item is its sequence number; the machine takes item `next` and no other
 *   - the machine says up to which item it has room, as an absolute number: nothing leaks when an
 *   answer is lost
 *   - the host starts again at `next` after a NAK, and when an answer that it asked for still
 *   misses something; silence alone
 *     makes it ask; the machine drops what it has already
 *   - another boot id in mid-job: the job is lost and nothing moves until the user knows where the
 *   machine stands
 */
#ifndef LOFT_WIRE_SESSION_H
#define LOFT_WIRE_SESSION_H

#include "wire/receiver.h"
#include "wire/sender.h"

#endif
