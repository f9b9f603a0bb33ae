/* tests/model/session.pml -- the session of lib/wire as a model for spin: WIRE.md part 5 to 7,
 * one item per frame
 * SPDX-License-Identifier: MIT
 *
 * These may happen at any moment; frames on the line stay there:
 *
 *     FAULTS    times a frame is lost (damaged ones are: the CRC finds them) or doubled
 *     DEATHS    times the host program dies and is started again
 *     REBOOTS   times the machine restarts
 *     LIMITS    times a limit switch closes, which ends the job or prevents one, and opens again
 *     GUARDS    times the guard of the job comes true, which ends it
 *     PLACES    1: a host with a new job first says where the machine stands; 2: any host does,
 *               whatever the machine is doing
 *     SETS      1: a host first writes settings, in two parts and a check, and greets again; 2: it
 *               sends its JOB without greeting again. A restart of the machine is a power cut
 *     PAUSES    1: item 0 and the last one are pauses, until the user resumes
 *
 * With -DFREE timeouts may also come at any moment (a busy host), otherwise only when nothing else
 * can happen. These properties hold:
 *
 *     safety    every item is accepted once, in order, and never more than the queue holds; the
 *               report comes when all of them are executed; after a restart during a job nothing is
 *               accepted until the user says so; no job begins whose host has ended; the machine is
 *               placed between jobs alone, and a job whose host has placed it begins there;
 *               settings are whole after any power cut, the old or the new ones, and no job begins
 *               that was planned with others; a pause ends when the user has resumed it, once
 *     liveness  the job ends, as done, aborted, refused or lost (ltl ends, weak fairness)
 *
 * Numbers on the wire count modulo M (65536 on the real one). `item` in a message is the item
 * itself; the protocol never looks at it. BUG=1..8 plants a mistake that must be found: see
 * tests/model/model.sh.
 */
#ifndef K
#define K 3             /* items of the job */
#endif
#ifndef W
#define W 2             /* window in frames */
#endif
#ifndef Q
#define Q 2             /* queue of the machine */
#endif
#ifndef M
#define M 4             /* numbers on the wire */
#endif
#ifndef CH
#define CH 3            /* frames that the line holds in each direction */
#endif
#ifndef FAULTS
#define FAULTS 2
#endif
#ifndef DEATHS
#define DEATHS 0
#endif
#ifndef REBOOTS
#define REBOOTS 0
#endif
#ifndef LIMITS
#define LIMITS 0
#endif
#ifndef GUARDS
#define GUARDS 0
#endif
#ifndef PLACES
#define PLACES 0
#endif
#ifndef SETS
#define SETS 0
#endif
#ifndef PAUSES
#define PAUSES 0
#endif
#ifndef BUG
#define BUG 0           /* 1: END is taken whatever it counts
                         * 2: an item ahead of `next` is taken
                         * 3: credit is counted
                         * 4: a JOB that was refused may begin later in its session
                         * 5: a place is obeyed in any state, each time it arrives
                         * 6: a job may begin in the session that changed the settings
                         * 7: settings are written to the copy in force
                         * 8: a RESUME is obeyed each time it arrives */
#endif

#define IDLE 0          /* of the machine */
#define RUNNING 1
#define DONE 2
#define ABORTED 3

#define GREETING 0      /* of the host */
#define OPENING 1
#define STREAMING 2
#define CLOSING 3
#define FINISHED 4
#define LOST 5
#define PLACING 6
#define SETTING 7

mtype = { HELLO, JOB, ITEM, END, POLL, CLOSE, PLACE, SET, RESUME, WELCOME, ACK, REPORT, KEPT };

/* session, number or nonce, item */
chan to_machine = [CH] of { mtype, byte, byte, byte };
/* session, nonce, next, limit, boot; next + 32: held, + 64: placed; limit + 16 * state, + 64:
 * refused, + 128: opened; boot + 8: the last RESUME obeyed, + 64: gearing. Of KEPT `next` is the
 * part */
chan to_host    = [CH] of { mtype, byte, byte, byte, byte, byte };
byte guards = GUARDS;
byte faults = FAULTS, deaths = DEATHS, reboots = REBOOTS, limits = LIMITS;
byte nonces = 0;                /* each HELLO of a new connection has another nonce */

/* the machine */
byte m_state = IDLE, m_session = 0, m_sessions = 0, m_nonce = 0, m_boot = 0;
byte m_next = 0, m_executed = 0;
bool m_placed = false;          /* the number of the PLACE of this session was obeyed or refused */
bool m_opened = false, m_ended = false, m_closed = false, m_refused = false;
bool due_welcome = false, due_ack = false, due_report = false, due_kept = false;
byte m_part = 0;                /* of settings, to be answered */
byte m_control = 0;             /* the last RESUME obeyed in this session */
bool m_held = false;
/* two copies of the settings: their parts and their check, the number of the writing; 0: nothing */
byte m_copy[6] = 1;
bit m_which = 0;                /* the one in force */
#define part_of(which, k)    m_copy[3 * (which) + (k)]
#define sound(which)    (part_of(which, 2) != 0 && part_of(which, 0) == part_of(which, 2) && \
                         part_of(which, 1) == part_of(which, 2))
#define gearing         part_of(m_which, 0)

/* the host */
byte h_phase = GREETING, h_session = 0, h_nonce = 0, h_boot = 0;
byte h_base = 0, h_send = 0, h_limit = 0;
bool h_sent = false, h_opened = false, h_end_sent = false;
bool h_asked = false, h_silent = false, h_doubt = false;
bool h_kept = false;            /* its settings are written */
byte h_part = 0, h_gear = 0, h_control = 0;
bool h_wish = false, h_due = false; /* a RESUME is not obeyed yet; is to be sent */

/* the subject of the proofs */
bool placed = false;            /* the machine was told where it stands */
byte writing = 1;               /* the number of the settings that a host writes or has written */
byte in_force = 1;              /* that were in force last */
byte wishes = 0, lifted = 0;    /* pauses that the user has resumed; that have ended */
bool in_job = false;            /* JOB was taken and not yet closed                        */
bool distrusted = false;        /* the machine restarted in mid-job, a host alive all the time */

#define over (h_phase == FINISHED || h_phase == LOST)

#define room    (m_state == ABORTED -> 0 : Q - (m_next - m_executed))
#define word    ((m_next + room) + 16 * m_state + 64 * m_refused + 128 * m_opened)

/* A frame on the line arrives, or is lost, or arrives twice. */
inline give(line, what, a, b, c)
{
    if
    :: line!what, a, b, c
    :: faults > 0 -> faults--
    :: faults > 0 && len(line) < CH - 1 -> faults--; line!what, a, b, c; line!what, a, b, c
    fi
}
#define counts  (m_next + 32 * m_held + 64 * m_placed)
#define boots   (m_boot + 8 * m_control + 64 * gearing)
inline answer(what)
{
    if
    :: to_host!what, m_session, m_nonce, (what == KEPT -> m_part : counts), word, boots
    :: faults > 0 -> faults--
    :: faults > 0 && len(to_host) < CH - 1 ->
        faults--
        to_host!what, m_session, m_nonce, (what == KEPT -> m_part : counts), word, boots;
        to_host!what, m_session, m_nonce, (what == KEPT -> m_part : counts), word, boots
    fi
}

inline machine_hello(nonce)
{
    if
    :: m_session == 0 || nonce != m_nonce ->
        m_sessions++;
        m_session = m_sessions;
        m_opened  = (m_state == RUNNING);
        m_refused = false;
        m_placed  = false;
        m_control = 0
    :: else
    fi
    m_nonce     = nonce;
    due_welcome = true;
    due_ack     = false;
    due_kept    = false
}

/* The settings in force after a start or a write: those of the newer sound copy. */
inline choose_copy()
{
    if
    :: sound(0) && (!sound(1) || part_of(0, 2) > part_of(1, 2)) -> m_which = 0
    :: sound(1) && (!sound(0) || part_of(1, 2) > part_of(0, 2)) -> m_which = 1
    :: else
    fi
    assert(sound(m_which));                             /* never a mixture, */
    assert(gearing >= in_force && gearing <= writing);  /* the old ones or newer ones */
    in_force = gearing
}

/* Parts 0 and 1, then 2, the check. They go to the copy that is not in force. */
inline machine_set(piece, value)
{
    if
    :: m_state != RUNNING ->
        if
        :: BUG == 7 -> part_of(m_which, piece) = value
        :: BUG != 7 -> part_of(1 - m_which, piece) = value
        fi
        if
        :: piece == 2 && gearing != value ->
            choose_copy();
            if :: gearing == value && BUG != 6 -> m_refused = true :: else fi
        :: else
        fi
    :: else
    fi
    m_part = piece; due_kept = true
}

inline machine_resume(value)
{
    if
    :: (value != m_control || BUG == 8) && m_state == RUNNING ->
        if :: m_held -> lifted++; assert(lifted <= wishes) :: else fi       /* as the user said */
        m_held = false;
        m_control = value
    :: else
    fi
    due_ack = true
}

inline machine_job(nonce, gear)
{
    if
    :: nonce != m_nonce
    :: nonce == m_nonce && (m_opened || m_state == DONE) -> due_ack = true
    :: nonce == m_nonce && !m_opened && (m_state == IDLE || m_state == ABORTED) &&
       (m_closed || (m_refused && BUG != 4)) ->
        m_refused = true; due_ack = true
    :: nonce == m_nonce && !m_opened && (m_state == IDLE || m_state == ABORTED) &&
       !m_closed && (!m_refused || BUG == 4) ->
        assert(!over);                                  /* somebody is there */
        assert(!in_job);                                /* never a job within a job */
        assert(!PLACES || placed);
        assert(!SETS || gear == gearing);               /* planned with what is in force */
        assert(!distrusted);
        in_job   = true;
        m_state  = RUNNING;
        m_next   = 0;
        m_executed = 0;
        m_held   = false;
        m_opened = true;
        m_ended  = false;
        due_ack  = true
    fi
}

inline machine_item(number, item)
{
    if
    :: m_state == RUNNING && !m_ended && room > 0 &&
       (number == m_next % M || (BUG == 2 && number == (m_next + 1) % M)) ->
        assert(item == m_next);                         /* exactly once, in order */
        assert(!distrusted);
        m_next++
    :: else
    fi
    due_ack = true
}

/* Its number makes it exactly once: each session has at most one here. A job that is over is
 * forgotten. */
inline machine_place()
{
    if
    :: m_placed && BUG != 5
    :: (!m_placed && m_state != RUNNING) || BUG == 5 ->
        assert(m_state != RUNNING && !distrusted);
        m_state = IDLE; in_job = false; due_report = false;
        m_placed = true;
        placed = true
    :: !m_placed && m_state == RUNNING && BUG != 5 -> m_placed = true; m_refused = true
    fi
    due_ack = true
}

active proctype machine()
{
    mtype what;
    byte session, number, item;

    m_copy[5] = 0;                      /* one copy is sound */
end:
    do
    :: atomic { to_machine?what, session, number, item ->
        if
        :: what == HELLO -> machine_hello(number)
        :: what != HELLO && m_session != 0 && session == m_session ->
            if
            :: what == JOB   -> machine_job(number, item)
            :: what == SET   -> machine_set(number, item)
            :: what == RESUME -> machine_resume(number)
            :: what == ITEM  -> machine_item(number, item)
            :: what == END   ->
                if
                :: m_state == RUNNING && (number == m_next || BUG == 1) -> m_ended = true
                :: else
                fi
                due_ack = true
            :: what == PLACE -> machine_place()
            :: what == POLL  ->
                due_ack = true;
                if :: m_state == DONE || m_state == ABORTED -> due_report = true :: else fi
            :: what == CLOSE ->
                if
                :: m_state == DONE || m_state == ABORTED ->
                    m_state = IDLE; in_job = false; due_report = false
                :: else
                fi
                due_ack = true
            fi
        :: else
        fi;
        what = HELLO; session = 0; number = 0; item = 0 }

    :: atomic { due_welcome && nfull(to_host) -> due_welcome = false; answer(WELCOME) }
    :: atomic { !due_welcome && due_report && m_session != 0 && nfull(to_host) ->
        due_report = false; answer(REPORT) }
    :: atomic { !due_welcome && !due_report && due_ack && nfull(to_host) ->
        due_ack = false; answer(ACK) }
    :: atomic { !due_welcome && due_kept && nfull(to_host) -> due_kept = false; answer(KEPT) }

    :: atomic { m_executed < m_next && m_state == RUNNING && !m_held ->
        if :: PAUSES && (m_executed == 0 || m_executed == K - 1) -> m_held = true :: else fi;
        m_executed++;
        assert(m_next - m_executed < Q);
        if :: m_session != 0 -> due_ack = true :: else fi }     /* room is told unasked */
    :: atomic { m_state == RUNNING && m_ended && m_executed == m_next && !m_held ->
        assert(m_executed == K);
        assert(!PAUSES || lifted == (K > 1 -> 2 : 1) || REBOOTS);   /* each pause, once */
        m_state = DONE;
        if :: m_session != 0 -> due_report = true :: else fi }

    :: atomic { limits > 0 && !m_closed ->
        limits--;
        m_closed = true;
        if
        :: m_state == RUNNING ->
            m_state = ABORTED; in_job = false;
            if :: m_session != 0 -> due_report = true; due_ack = true :: else fi
        :: else
        fi }
    :: atomic { m_closed -> m_closed = false }

    :: atomic { guards > 0 && m_state == RUNNING ->
        guards--;
        m_state = ABORTED; in_job = false;
        if :: m_session != 0 -> due_report = true; due_ack = true :: else fi }

    :: atomic { reboots > 0 ->
        reboots--;
        if :: in_job && h_opened -> distrusted = true :: else fi;
        m_boot++;
        m_state = IDLE; m_session = 0; m_sessions = m_boot; m_nonce = 0; m_next = 0; m_executed = 0;
        m_opened = false; m_ended = false; m_refused = false; in_job = false; m_placed = false;
        m_held = false; m_control = 0; m_part = 0; due_kept = false;
        if :: SETS -> choose_copy() :: else fi;
        due_welcome = false; due_ack = false; due_report = false }
    od
}

/* The machine is known: our running job continues, our finished job is collected. */
inline host_join(state, next, limit, boot, opened)
{
    h_sent = false;
    if
    :: h_opened && (state == IDLE || boot != h_boot) -> h_phase = LOST
    :: else ->
        if
        :: SETS && !h_kept && !h_asked && state != RUNNING && state != DONE -> h_phase = SETTING
        :: PLACES && !h_asked && (state == IDLE || state == ABORTED || PLACES == 2) ->
            h_phase = PLACING
        :: (!PLACES || h_asked) && (!SETS || h_kept || h_asked) &&
           (state == IDLE || (state == ABORTED && !h_asked)) ->
            h_phase = OPENING
        :: else ->
            h_phase = STREAMING; h_opened = true;
            h_base = next; h_send = next; h_limit = limit; h_end_sent = false
        fi
    fi
    h_boot = boot
}

inline host_ack(state, next, limit, opened, refused, obeyed)
{
    if
    :: h_phase == PLACING && h_sent && obeyed ->
        h_sent = false; h_silent = false;
        if :: refused -> h_phase = FINISHED :: else -> h_phase = OPENING fi
    :: h_phase == OPENING && h_sent && !opened && refused -> h_phase = FINISHED
    :: h_phase == OPENING && h_sent && opened ->
        h_phase = STREAMING; h_opened = true;
        h_base = next; h_send = next; h_limit = limit; h_end_sent = false
    :: h_phase == STREAMING && next >= h_base ->
        if
        :: h_doubt && next == h_base ->         /* asked, and still missing: lost */
            h_send = h_base; h_end_sent = false
        :: else
        fi
        h_doubt = false;
        h_base = next;
        if :: h_send < next -> h_send = next :: else fi
        if
        :: BUG == 3 -> h_limit++
        :: BUG != 3 && limit > h_limit -> h_limit = limit
        :: else
        fi
    :: h_phase == CLOSING && state == IDLE -> h_phase = FINISHED
    :: else
    fi
}

/* The answer to a part. After the check the host greets again, and learns the new gearing. */
inline host_kept(piece)
{
    if
    :: h_phase == SETTING && h_sent && piece == h_part ->
        h_sent = false; h_silent = false; h_part++;
        if
        :: h_part == 3 && SETS == 1 -> h_kept = true; host_greet()
        :: h_part == 3 && SETS == 2 -> h_kept = true; h_phase = OPENING
        :: else
        fi
    :: else
    fi
}

inline host_greet()
{
    h_phase = GREETING; h_session = 0; h_part = 0; h_control = 0; h_wish = false; h_due = false;
    h_sent = false; h_end_sent = false; h_silent = false; h_doubt = false;
    nonces++;
    h_nonce = nonces
}

#ifdef FREE
#define quiet true
#define MOST 4          /* connections: the search must end */
#else
#define quiet timeout
#define MOST 200
#endif

active proctype host()
{
    mtype what;
    byte session, nonce, next, state, boot;
    bool opened, refused, obeyed, held;
    byte gear, control;

    atomic { if :: SETS -> writing = 2 :: else fi; host_greet() }
    do
    :: atomic { to_host?what, session, nonce, next, state, boot ->
        opened = state >= 128;
        refused = (state % 128) >= 64;
        state  = state % 64;
        obeyed = next >= 64;
        held   = (next % 64) >= 32;
        next   = next % 32;
        gear    = boot / 64;
        control = (boot % 64) / 8;
        boot    = boot % 8;
        if :: session == h_session -> h_silent = false :: else fi;
        if
        :: what == WELCOME && h_phase == GREETING && nonce == h_nonce ->
            h_session = session;
            h_gear = gear;
            host_join(state / 16, next, state % 16, boot, opened)
        :: what == ACK && h_phase != GREETING && session == h_session ->
            host_ack(state / 16, next, state % 16, opened, refused, obeyed);
            if
            :: h_wish && control == h_control -> h_wish = false
            :: else
            fi;
            if
            :: PAUSES && h_phase == STREAMING && held && !h_wish && state / 16 == RUNNING ->
                h_wish = true; h_due = true; h_control++; wishes++
            :: else
            fi
        :: what == KEPT && session == h_session -> host_kept(next)
        :: what == REPORT && h_phase == STREAMING && session == h_session ->
            h_phase = CLOSING; h_sent = false
        :: else
        fi;
        what = HELLO; session = 0; nonce = 0; next = 0; state = 0; boot = 0;
        opened = false; refused = false; obeyed = false; held = false; gear = 0; control = 0 }

    :: atomic { h_phase == GREETING && !h_sent && nfull(to_machine) ->
        h_sent = true; give(to_machine, HELLO, 0, h_nonce, 0) }
    :: atomic { h_phase == PLACING && !h_sent && nfull(to_machine) ->
        h_sent = true; give(to_machine, PLACE, h_session, 0, 0) }
    :: atomic { h_phase == SETTING && !h_sent && nfull(to_machine) ->
        h_sent = true; give(to_machine, SET, h_session, h_part, writing) }
    :: atomic { h_phase == OPENING && !h_sent && nfull(to_machine) ->
        h_sent = true; h_asked = true; give(to_machine, JOB, h_session, h_nonce, h_gear) }
    :: atomic { h_phase == CLOSING && !h_sent && nfull(to_machine) ->
        h_sent = true; give(to_machine, CLOSE, h_session, 0, 0) }
    :: atomic { h_phase == STREAMING && h_send < K && h_send < h_limit && h_send < h_base + W &&
                nfull(to_machine) ->
        /* never more than fits */
        assert(m_boot != h_boot || h_send < m_executed + Q);
        give(to_machine, ITEM, h_session, h_send % M, h_send); h_send++ }
    :: atomic { h_phase == STREAMING && h_send == K && !h_end_sent && nfull(to_machine) ->
        h_end_sent = true; give(to_machine, END, h_session, K, 0) }

    /* silence: a question, or the same message again, once; then start with the greeting */
    :: atomic { quiet && h_phase == GREETING && h_sent -> h_sent = false }
    :: atomic { h_due && nfull(to_machine) ->
        h_due = false; give(to_machine, RESUME, h_session, h_control, 0) }
    :: atomic { quiet && (h_phase == OPENING || h_phase == CLOSING || h_phase == PLACING ||
                          h_phase == SETTING) &&
                h_sent && !h_silent ->
        h_silent = true; h_sent = false }
    :: atomic { quiet && h_phase == CLOSING && h_sent && h_silent -> h_phase = FINISHED }
    :: atomic { quiet && h_phase == STREAMING && !h_silent && nfull(to_machine) ->
        h_silent = true; h_doubt = true; h_due = h_wish; give(to_machine, POLL, h_session, 0, 0) }
    :: atomic { quiet && (h_phase == OPENING || h_phase == STREAMING || h_phase == PLACING ||
                          h_phase == SETTING) &&
                h_silent && nonces < MOST ->
        host_greet() }

    /* the program dies and is started again: it knows only its job */
    :: atomic { deaths > 0 && (h_phase < CLOSING || h_phase >= PLACING) && !distrusted ->
        deaths--; h_opened = false; h_asked = false; h_kept = false;
        if :: SETS -> writing++ :: else fi;
        h_base = 0; h_send = 0; h_limit = 0; h_boot = 0; host_greet() }
    :: over -> break
    od
}

ltl ends { <> over }
