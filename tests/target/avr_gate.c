/* tests/target/avr_gate.c
 * SPDX-License-Identifier: MIT
 */
#include "avr_gate.h"

void gate_init(struct gate *g)
{
    *g = (struct gate){ .step = 1 };
    loft_frame_init(&g->from_host);
    loft_frame_init(&g->from_machine);
}

/* Frames that have been answered, and those that are sent again, are in flight no more. */
static void take_frame(struct gate *g, uint32_t first, uint32_t count)
{
    uint32_t gone = 0, kept = 0;

    while (gone < g->flights && (int32_t)(g->flight[gone] - g->ack.next) <= 0)
        gone++;
    for (; gone < g->flights && (int32_t)(g->flight[gone] - first) <= 0; gone++)
        g->flight[kept++] = g->flight[gone];
    if (kept < LOFT_WINDOW_FRAMES)
        g->flight[kept++] = first + count;
    g->flights = kept;
    g->sent    = first + count;
}

/* The seal of a frame of items is not checked: this line damages no byte. The number of its first
 * item has 16 bits, and is near `next`. */
static void take_items(struct gate *g)
{
    loft_unpacker u;
    uint16_t first;

    if (loft_data_first(&g->from_host, &first) == LOFT_OK &&
        loft_data_decode(&g->from_host, &u) == LOFT_OK)
        take_frame(
            g,
            (uint32_t)((int64_t)g->ack.next + (int16_t)(uint16_t)(first - (g->ack.next & 0xFFFFu))),
            u.count);
}

void gate_host(struct gate *g, uint8_t byte)
{
    loft_control control;
    uint32_t total;
    loft_job job;

    if (loft_frame_push(&g->from_host, byte) == LOFT_MORE || g->from_host.count == 0)
        return;
    if (loft_data_carried(&g->from_host)) {
        take_items(g);
    } else if (loft_message_type(&g->from_host) == LOFT_JOB) {
        g->sent = g->flights = 0;
        g->ended = false;
        if (loft_job_decode(&g->from_host, &job) == LOFT_OK) {
            const uint16_t most = job.kind == LOFT_POINTS ? g->points : g->queue;
            g->step = most < 4 ? 1 : most / 4u;
        }
    } else if (loft_message_type(&g->from_host) == LOFT_HELLO) {
        g->ended = true;                        /* another sender owes nothing */
    } else if (loft_message_type(&g->from_host) == LOFT_END) {
        g->ended = loft_end_decode(&g->from_host, &total) == LOFT_OK;
    } else if (loft_message_type(&g->from_host) == LOFT_CONTROL) {
        g->ended |= loft_control_decode(&g->from_host, &control) == LOFT_OK &&
                    control.verb == LOFT_ABORT;
    }
}

static void take(struct gate *g, const loft_ack *ack)
{
    if (loft_state_busy(g->ack.state) == false && ack->state == LOFT_STATE_IDLE &&
        g->ack.state >= LOFT_STATE_DONE)
        g->jobs++;
    if (ack->flags & LOFT_FLAG_NAK) {
        g->sent    = ack->next;
        g->flights = 0;
        g->naks++;
    }
    g->ack = *ack;
}

void gate_machine(struct gate *g, uint8_t byte)
{
    loft_machine_status status;
    loft_welcome welcome;
    loft_report report;
    loft_ack ack;

    if (loft_frame_push(&g->from_machine, byte) != LOFT_OK)
        return;
    g->frames++;
    switch (loft_message_type(&g->from_machine)) {
    case LOFT_WELCOME:
        if (loft_welcome_decode(&g->from_machine, &welcome) != LOFT_OK)
            break;
        take(g, &welcome.ack);
        g->queue  = welcome.queue;
        g->points = welcome.points;
        break;
    case LOFT_ACK:
        if (loft_ack_decode(&g->from_machine, &ack) == LOFT_OK)
            take(g, &ack);
        break;
    case LOFT_STATUS:
        if (loft_machine_status_decode(&g->from_machine, &status) == LOFT_OK)
            take(g, &status.ack);
        break;
    case LOFT_REPORT:
        if (loft_report_decode(&g->from_machine, &report) == LOFT_OK)
            g->ack.state = report.state;
        break;
    default: break;
    }
}
