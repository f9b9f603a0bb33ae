/* lib/wire/session.h -- a session: a job reaches a machine exactly once, whatever the line does
 * SPDX-License-Identifier: MIT
 *
 * The two halves know each other's state only from the messages:
 *
 *   receiver.h   the machine: bytes in, items in order, answers out; small, no clock
 *   sender.h     the host: requests, resuming, the report; window.h has the items in flight, rto.h
 *                the time to wait for an answer
 *
 * Rules; WIRE.md has the reasons:
 *   - A HELLO begins a session. Every other frame carries its number and is dropped in another
 *     session.
 *   - A session has at most one JOB. A job may last for many sessions.
 *   - The number of an item is its sequence number. The machine takes only item `next`.
 *   - The machine reports the room up to an absolute item number. So a lost answer loses no credit.
 *   - The host starts again at `next` after a NAK, and when a requested answer still lacks
 *   something.
 *     Silence alone makes it ask. The machine drops what it has already.
 *   - Another boot id in mid-job: the job is lost, and nothing moves until the user knows the
 *     machine's position.
 */
#ifndef LOFT_WIRE_SESSION_H
#define LOFT_WIRE_SESSION_H

#include "wire/receiver.h"
#include "wire/sender.h"

#endif
