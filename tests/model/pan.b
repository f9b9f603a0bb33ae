	switch (t->back) {
	default: Uerror("bad return move");
	case  0: goto R999; /* nothing to undo */

		 /* CLAIM ends */
;
		;
		
	case 4: // STATE 6
		;
		p_restor(II);
		;
		;
		goto R999;

		 /* PROC host */

	case 5: // STATE 6
		;
		now.h_nonce = trpt->bup.ovals[5];
		now.nonces = trpt->bup.ovals[4];
		now.h_end_sent = trpt->bup.ovals[3];
		now.h_sent = trpt->bup.ovals[2];
		now.h_session = trpt->bup.ovals[1];
		now.h_phase = trpt->bup.ovals[0];
		;
		ungrab_ints(trpt->bup.ovals, 6);
		goto R999;

	case 6: // STATE 11
		;
		((P1 *)_this)->state = trpt->bup.ovals[7];
		((P1 *)_this)->opened = trpt->bup.ovals[6];
		XX = 1;
		unrecv(now.to_host, XX-1, 0, ((P1 *)_this)->what, 1);
		unrecv(now.to_host, XX-1, 1, ((int)((P1 *)_this)->session), 0);
		unrecv(now.to_host, XX-1, 2, ((int)((P1 *)_this)->nonce), 0);
		unrecv(now.to_host, XX-1, 3, ((int)((P1 *)_this)->next), 0);
		unrecv(now.to_host, XX-1, 4, ((int)((P1 *)_this)->state), 0);
		unrecv(now.to_host, XX-1, 5, ((int)((P1 *)_this)->boot), 0);
		((P1 *)_this)->what = trpt->bup.ovals[0];
		((P1 *)_this)->session = trpt->bup.ovals[1];
		((P1 *)_this)->nonce = trpt->bup.ovals[2];
		((P1 *)_this)->next = trpt->bup.ovals[3];
		((P1 *)_this)->state = trpt->bup.ovals[4];
		((P1 *)_this)->boot = trpt->bup.ovals[5];
		;
		;
		ungrab_ints(trpt->bup.ovals, 8);
		goto R999;

	case 7: // STATE 13
		;
		now.h_session = trpt->bup.ovals[2];
	/* 1 */	((P1 *)_this)->nonce = trpt->bup.ovals[1];
	/* 0 */	((P1 *)_this)->what = trpt->bup.ovals[0];
		;
		;
		ungrab_ints(trpt->bup.ovals, 3);
		goto R999;

	case 8: // STATE 14
		;
		now.h_sent = trpt->bup.oval;
		;
		goto R999;

	case 9: // STATE 73
		;
		((P1 *)_this)->opened = trpt->bup.ovals[9];
		((P1 *)_this)->boot = trpt->bup.ovals[8];
		((P1 *)_this)->state = trpt->bup.ovals[7];
		((P1 *)_this)->next = trpt->bup.ovals[6];
		((P1 *)_this)->nonce = trpt->bup.ovals[5];
		((P1 *)_this)->session = trpt->bup.ovals[4];
		((P1 *)_this)->what = trpt->bup.ovals[3];
		now.h_boot = trpt->bup.ovals[2];
		now.h_phase = trpt->bup.ovals[1];
	/* 0 */	((P1 *)_this)->state = trpt->bup.ovals[0];
		;
		;
		ungrab_ints(trpt->bup.ovals, 11);
		goto R999;

	case 10: // STATE 73
		;
		((P1 *)_this)->opened = trpt->bup.ovals[9];
		((P1 *)_this)->boot = trpt->bup.ovals[8];
		((P1 *)_this)->state = trpt->bup.ovals[7];
		((P1 *)_this)->next = trpt->bup.ovals[6];
		((P1 *)_this)->nonce = trpt->bup.ovals[5];
		((P1 *)_this)->session = trpt->bup.ovals[4];
		((P1 *)_this)->what = trpt->bup.ovals[3];
		now.h_boot = trpt->bup.ovals[2];
		now.h_phase = trpt->bup.ovals[1];
	/* 0 */	((P1 *)_this)->state = trpt->bup.ovals[0];
		;
		;
		ungrab_ints(trpt->bup.ovals, 11);
		goto R999;

	case 11: // STATE 73
		;
		((P1 *)_this)->opened = trpt->bup.ovals[13];
		((P1 *)_this)->boot = trpt->bup.ovals[12];
		((P1 *)_this)->state = trpt->bup.ovals[11];
		((P1 *)_this)->next = trpt->bup.ovals[10];
		((P1 *)_this)->nonce = trpt->bup.ovals[9];
		((P1 *)_this)->session = trpt->bup.ovals[8];
		((P1 *)_this)->what = trpt->bup.ovals[7];
		now.h_boot = trpt->bup.ovals[6];
		now.h_end_sent = trpt->bup.ovals[5];
		now.h_limit = trpt->bup.ovals[4];
		now.h_send = trpt->bup.ovals[3];
		now.h_base = trpt->bup.ovals[2];
		now.h_opened = trpt->bup.ovals[1];
		now.h_phase = trpt->bup.ovals[0];
		;
		ungrab_ints(trpt->bup.ovals, 15);
		goto R999;

	case 12: // STATE 73
		;
		((P1 *)_this)->opened = trpt->bup.ovals[7];
		((P1 *)_this)->boot = trpt->bup.ovals[6];
		((P1 *)_this)->state = trpt->bup.ovals[5];
		((P1 *)_this)->next = trpt->bup.ovals[4];
		((P1 *)_this)->nonce = trpt->bup.ovals[3];
		((P1 *)_this)->session = trpt->bup.ovals[2];
		((P1 *)_this)->what = trpt->bup.ovals[1];
		now.h_boot = trpt->bup.ovals[0];
		;
		ungrab_ints(trpt->bup.ovals, 9);
		goto R999;

	case 13: // STATE 33
		;
	/* 1 */	((P1 *)_this)->session = trpt->bup.ovals[1];
	/* 0 */	((P1 *)_this)->what = trpt->bup.ovals[0];
		;
		;
		ungrab_ints(trpt->bup.ovals, 2);
		goto R999;

	case 14: // STATE 73
		;
		((P1 *)_this)->opened = trpt->bup.ovals[13];
		((P1 *)_this)->boot = trpt->bup.ovals[12];
		((P1 *)_this)->state = trpt->bup.ovals[11];
		((P1 *)_this)->next = trpt->bup.ovals[10];
		((P1 *)_this)->nonce = trpt->bup.ovals[9];
		((P1 *)_this)->session = trpt->bup.ovals[8];
		((P1 *)_this)->what = trpt->bup.ovals[7];
		now.h_end_sent = trpt->bup.ovals[6];
		now.h_limit = trpt->bup.ovals[5];
		now.h_send = trpt->bup.ovals[4];
		now.h_base = trpt->bup.ovals[3];
		now.h_opened = trpt->bup.ovals[2];
		now.h_phase = trpt->bup.ovals[1];
	/* 0 */	((P1 *)_this)->opened = trpt->bup.ovals[0];
		;
		;
		ungrab_ints(trpt->bup.ovals, 15);
		goto R999;

	case 15: // STATE 42
		;
		now.h_base = trpt->bup.oval;
		;
		goto R999;

	case 16: // STATE 44
		;
		now.h_send = trpt->bup.oval;
		;
		goto R999;

	case 17: // STATE 73
		;
		((P1 *)_this)->opened = trpt->bup.ovals[7];
		((P1 *)_this)->boot = trpt->bup.ovals[6];
		((P1 *)_this)->state = trpt->bup.ovals[5];
		((P1 *)_this)->next = trpt->bup.ovals[4];
		((P1 *)_this)->nonce = trpt->bup.ovals[3];
		((P1 *)_this)->session = trpt->bup.ovals[2];
		((P1 *)_this)->what = trpt->bup.ovals[1];
		now.h_limit = trpt->bup.ovals[0];
		;
		ungrab_ints(trpt->bup.ovals, 9);
		goto R999;

	case 18: // STATE 73
		;
		((P1 *)_this)->opened = trpt->bup.ovals[7];
		((P1 *)_this)->boot = trpt->bup.ovals[6];
		((P1 *)_this)->state = trpt->bup.ovals[5];
		((P1 *)_this)->next = trpt->bup.ovals[4];
		((P1 *)_this)->nonce = trpt->bup.ovals[3];
		((P1 *)_this)->session = trpt->bup.ovals[2];
		((P1 *)_this)->what = trpt->bup.ovals[1];
		now.h_limit = trpt->bup.ovals[0];
		;
		ungrab_ints(trpt->bup.ovals, 9);
		goto R999;

	case 19: // STATE 73
		;
		((P1 *)_this)->opened = trpt->bup.ovals[8];
		((P1 *)_this)->boot = trpt->bup.ovals[7];
		((P1 *)_this)->state = trpt->bup.ovals[6];
		((P1 *)_this)->next = trpt->bup.ovals[5];
		((P1 *)_this)->nonce = trpt->bup.ovals[4];
		((P1 *)_this)->session = trpt->bup.ovals[3];
		((P1 *)_this)->what = trpt->bup.ovals[2];
		now.h_phase = trpt->bup.ovals[1];
	/* 0 */	((P1 *)_this)->state = trpt->bup.ovals[0];
		;
		;
		ungrab_ints(trpt->bup.ovals, 10);
		goto R999;

	case 20: // STATE 73
		;
		((P1 *)_this)->opened = trpt->bup.ovals[10];
		((P1 *)_this)->boot = trpt->bup.ovals[9];
		((P1 *)_this)->state = trpt->bup.ovals[8];
		((P1 *)_this)->next = trpt->bup.ovals[7];
		((P1 *)_this)->nonce = trpt->bup.ovals[6];
		((P1 *)_this)->session = trpt->bup.ovals[5];
		((P1 *)_this)->what = trpt->bup.ovals[4];
		now.h_sent = trpt->bup.ovals[3];
		now.h_phase = trpt->bup.ovals[2];
	/* 1 */	((P1 *)_this)->session = trpt->bup.ovals[1];
	/* 0 */	((P1 *)_this)->what = trpt->bup.ovals[0];
		;
		;
		ungrab_ints(trpt->bup.ovals, 12);
		goto R999;

	case 21: // STATE 73
		;
		((P1 *)_this)->opened = trpt->bup.ovals[6];
		((P1 *)_this)->boot = trpt->bup.ovals[5];
		((P1 *)_this)->state = trpt->bup.ovals[4];
		((P1 *)_this)->next = trpt->bup.ovals[3];
		((P1 *)_this)->nonce = trpt->bup.ovals[2];
		((P1 *)_this)->session = trpt->bup.ovals[1];
		((P1 *)_this)->what = trpt->bup.ovals[0];
		;
		ungrab_ints(trpt->bup.ovals, 8);
		goto R999;

	case 22: // STATE 76
		;
		now.h_sent = trpt->bup.oval;
		;
		goto R999;

	case 23: // STATE 77
		;
		_m = unsend(now.to_machine);
		;
		goto R999;
;
		
	case 24: // STATE 85
		goto R999;

	case 25: // STATE 79
		;
		now.faults = trpt->bup.oval;
		;
		goto R999;

	case 26: // STATE 81
		;
		now.faults = trpt->bup.oval;
		;
		goto R999;

	case 27: // STATE 82
		;
		_m = unsend(now.to_machine);
		;
		goto R999;

	case 28: // STATE 83
		;
		_m = unsend(now.to_machine);
		;
		goto R999;

	case 29: // STATE 90
		;
		h_asked = trpt->bup.ovals[1];
		now.h_sent = trpt->bup.ovals[0];
		;
		ungrab_ints(trpt->bup.ovals, 2);
		goto R999;

	case 30: // STATE 91
		;
		_m = unsend(now.to_machine);
		;
		goto R999;
;
		
	case 31: // STATE 99
		goto R999;

	case 32: // STATE 93
		;
		now.faults = trpt->bup.oval;
		;
		goto R999;

	case 33: // STATE 95
		;
		now.faults = trpt->bup.oval;
		;
		goto R999;

	case 34: // STATE 96
		;
		_m = unsend(now.to_machine);
		;
		goto R999;

	case 35: // STATE 97
		;
		_m = unsend(now.to_machine);
		;
		goto R999;

	case 36: // STATE 103
		;
		now.h_sent = trpt->bup.oval;
		;
		goto R999;

	case 37: // STATE 104
		;
		_m = unsend(now.to_machine);
		;
		goto R999;
;
		
	case 38: // STATE 112
		goto R999;

	case 39: // STATE 106
		;
		now.faults = trpt->bup.oval;
		;
		goto R999;

	case 40: // STATE 108
		;
		now.faults = trpt->bup.oval;
		;
		goto R999;

	case 41: // STATE 109
		;
		_m = unsend(now.to_machine);
		;
		goto R999;

	case 42: // STATE 110
		;
		_m = unsend(now.to_machine);
		;
		goto R999;
;
		;
		
	case 44: // STATE 126
		;
		now.h_send = trpt->bup.oval;
		_m = unsend(now.to_machine);
		;
		goto R999;

	case 45: // STATE 126
		;
		now.h_send = trpt->bup.oval;
		;
		goto R999;

	case 46: // STATE 126
		;
		now.h_send = trpt->bup.ovals[1];
		now.faults = trpt->bup.ovals[0];
		;
		ungrab_ints(trpt->bup.ovals, 2);
		goto R999;

	case 47: // STATE 120
		;
		now.faults = trpt->bup.oval;
		;
		goto R999;

	case 48: // STATE 121
		;
		_m = unsend(now.to_machine);
		;
		goto R999;

	case 49: // STATE 126
		;
		now.h_send = trpt->bup.oval;
		_m = unsend(now.to_machine);
		;
		goto R999;

	case 50: // STATE 129
		;
		now.h_end_sent = trpt->bup.oval;
		;
		goto R999;

	case 51: // STATE 130
		;
		_m = unsend(now.to_machine);
		;
		goto R999;
;
		
	case 52: // STATE 138
		goto R999;

	case 53: // STATE 132
		;
		now.faults = trpt->bup.oval;
		;
		goto R999;

	case 54: // STATE 134
		;
		now.faults = trpt->bup.oval;
		;
		goto R999;

	case 55: // STATE 135
		;
		_m = unsend(now.to_machine);
		;
		goto R999;

	case 56: // STATE 136
		;
		_m = unsend(now.to_machine);
		;
		goto R999;

	case 57: // STATE 142
		;
		now.h_sent = trpt->bup.oval;
		;
		goto R999;

	case 58: // STATE 146
		;
		now.h_end_sent = trpt->bup.ovals[1];
		now.h_send = trpt->bup.ovals[0];
		;
		ungrab_ints(trpt->bup.ovals, 2);
		goto R999;

	case 59: // STATE 147
		;
		_m = unsend(now.to_machine);
		;
		goto R999;
;
		
	case 60: // STATE 155
		goto R999;

	case 61: // STATE 149
		;
		now.faults = trpt->bup.oval;
		;
		goto R999;

	case 62: // STATE 151
		;
		now.faults = trpt->bup.oval;
		;
		goto R999;

	case 63: // STATE 152
		;
		_m = unsend(now.to_machine);
		;
		goto R999;

	case 64: // STATE 153
		;
		_m = unsend(now.to_machine);
		;
		goto R999;
;
		;
		
	case 66: // STATE 164
		;
		now.h_nonce = trpt->bup.ovals[5];
		now.nonces = trpt->bup.ovals[4];
		now.h_end_sent = trpt->bup.ovals[3];
		now.h_sent = trpt->bup.ovals[2];
		now.h_session = trpt->bup.ovals[1];
		now.h_phase = trpt->bup.ovals[0];
		;
		ungrab_ints(trpt->bup.ovals, 6);
		goto R999;

	case 67: // STATE 174
		;
		now.h_boot = trpt->bup.ovals[6];
		now.h_limit = trpt->bup.ovals[5];
		now.h_send = trpt->bup.ovals[4];
		now.h_base = trpt->bup.ovals[3];
		h_asked = trpt->bup.ovals[2];
		now.h_opened = trpt->bup.ovals[1];
		now.deaths = trpt->bup.ovals[0];
		;
		ungrab_ints(trpt->bup.ovals, 7);
		goto R999;

	case 68: // STATE 180
		;
		now.h_nonce = trpt->bup.ovals[5];
		now.nonces = trpt->bup.ovals[4];
		now.h_end_sent = trpt->bup.ovals[3];
		now.h_sent = trpt->bup.ovals[2];
		now.h_session = trpt->bup.ovals[1];
		now.h_phase = trpt->bup.ovals[0];
		;
		ungrab_ints(trpt->bup.ovals, 6);
		goto R999;
;
		;
		
	case 70: // STATE 188
		;
		p_restor(II);
		;
		;
		goto R999;

		 /* PROC machine */

	case 71: // STATE 1
		;
		XX = 1;
		unrecv(now.to_machine, XX-1, 0, ((P0 *)_this)->what, 1);
		unrecv(now.to_machine, XX-1, 1, ((int)((P0 *)_this)->session), 0);
		unrecv(now.to_machine, XX-1, 2, ((int)((P0 *)_this)->number), 0);
		unrecv(now.to_machine, XX-1, 3, ((int)((P0 *)_this)->item), 0);
		((P0 *)_this)->what = trpt->bup.ovals[0];
		((P0 *)_this)->session = trpt->bup.ovals[1];
		((P0 *)_this)->number = trpt->bup.ovals[2];
		((P0 *)_this)->item = trpt->bup.ovals[3];
		;
		;
		ungrab_ints(trpt->bup.ovals, 4);
		goto R999;

	case 72: // STATE 2
		;
	/* 0 */	((P0 *)_this)->what = trpt->bup.oval;
		;
		;
		goto R999;

	case 73: // STATE 73
		;
		((P0 *)_this)->item = trpt->bup.ovals[9];
		((P0 *)_this)->number = trpt->bup.ovals[8];
		((P0 *)_this)->session = trpt->bup.ovals[7];
		((P0 *)_this)->what = trpt->bup.ovals[6];
		now.due_ack = trpt->bup.ovals[5];
		now.due_welcome = trpt->bup.ovals[4];
		now.m_nonce = trpt->bup.ovals[3];
		now.m_opened = trpt->bup.ovals[2];
		now.m_session = trpt->bup.ovals[1];
		now.m_sessions = trpt->bup.ovals[0];
		;
		ungrab_ints(trpt->bup.ovals, 11);
		goto R999;

	case 74: // STATE 73
		;
		((P0 *)_this)->item = trpt->bup.ovals[6];
		((P0 *)_this)->number = trpt->bup.ovals[5];
		((P0 *)_this)->session = trpt->bup.ovals[4];
		((P0 *)_this)->what = trpt->bup.ovals[3];
		now.due_ack = trpt->bup.ovals[2];
		now.due_welcome = trpt->bup.ovals[1];
		now.m_nonce = trpt->bup.ovals[0];
		;
		ungrab_ints(trpt->bup.ovals, 8);
		goto R999;

	case 75: // STATE 14
		;
	/* 0 */	((P0 *)_this)->session = trpt->bup.oval;
		;
		;
		goto R999;

	case 76: // STATE 15
		;
	/* 0 */	((P0 *)_this)->what = trpt->bup.oval;
		;
		;
		goto R999;

	case 77: // STATE 73
		;
		((P0 *)_this)->item = trpt->bup.ovals[4];
		((P0 *)_this)->number = trpt->bup.ovals[3];
		((P0 *)_this)->session = trpt->bup.ovals[2];
		((P0 *)_this)->what = trpt->bup.ovals[1];
	/* 0 */	((P0 *)_this)->number = trpt->bup.ovals[0];
		;
		;
		ungrab_ints(trpt->bup.ovals, 6);
		goto R999;

	case 78: // STATE 73
		;
		((P0 *)_this)->item = trpt->bup.ovals[5];
		((P0 *)_this)->number = trpt->bup.ovals[4];
		((P0 *)_this)->session = trpt->bup.ovals[3];
		((P0 *)_this)->what = trpt->bup.ovals[2];
		now.due_ack = trpt->bup.ovals[1];
	/* 0 */	((P0 *)_this)->number = trpt->bup.ovals[0];
		;
		;
		ungrab_ints(trpt->bup.ovals, 7);
		goto R999;

	case 79: // STATE 73
		;
		((P0 *)_this)->item = trpt->bup.ovals[11];
		((P0 *)_this)->number = trpt->bup.ovals[10];
		((P0 *)_this)->session = trpt->bup.ovals[9];
		((P0 *)_this)->what = trpt->bup.ovals[8];
		now.due_ack = trpt->bup.ovals[7];
		now.m_ended = trpt->bup.ovals[6];
		now.m_opened = trpt->bup.ovals[5];
		now.m_executed = trpt->bup.ovals[4];
		now.m_next = trpt->bup.ovals[3];
		now.m_state = trpt->bup.ovals[2];
		now.in_job = trpt->bup.ovals[1];
	/* 0 */	((P0 *)_this)->number = trpt->bup.ovals[0];
		;
		;
		ungrab_ints(trpt->bup.ovals, 13);
		goto R999;

	case 80: // STATE 32
		;
	/* 0 */	((P0 *)_this)->what = trpt->bup.oval;
		;
		;
		goto R999;

	case 81: // STATE 73
		;
		((P0 *)_this)->item = trpt->bup.ovals[6];
		((P0 *)_this)->number = trpt->bup.ovals[5];
		((P0 *)_this)->session = trpt->bup.ovals[4];
		((P0 *)_this)->what = trpt->bup.ovals[3];
		now.due_ack = trpt->bup.ovals[2];
		now.m_next = trpt->bup.ovals[1];
	/* 0 */	((P0 *)_this)->number = trpt->bup.ovals[0];
		;
		;
		ungrab_ints(trpt->bup.ovals, 8);
		goto R999;

	case 82: // STATE 73
		;
		((P0 *)_this)->item = trpt->bup.ovals[4];
		((P0 *)_this)->number = trpt->bup.ovals[3];
		((P0 *)_this)->session = trpt->bup.ovals[2];
		((P0 *)_this)->what = trpt->bup.ovals[1];
		now.due_ack = trpt->bup.ovals[0];
		;
		ungrab_ints(trpt->bup.ovals, 6);
		goto R999;

	case 83: // STATE 42
		;
	/* 0 */	((P0 *)_this)->what = trpt->bup.oval;
		;
		;
		goto R999;

	case 84: // STATE 73
		;
		((P0 *)_this)->item = trpt->bup.ovals[6];
		((P0 *)_this)->number = trpt->bup.ovals[5];
		((P0 *)_this)->session = trpt->bup.ovals[4];
		((P0 *)_this)->what = trpt->bup.ovals[3];
		now.due_ack = trpt->bup.ovals[2];
		now.m_ended = trpt->bup.ovals[1];
	/* 0 */	((P0 *)_this)->number = trpt->bup.ovals[0];
		;
		;
		ungrab_ints(trpt->bup.ovals, 8);
		goto R999;

	case 85: // STATE 73
		;
		((P0 *)_this)->item = trpt->bup.ovals[4];
		((P0 *)_this)->number = trpt->bup.ovals[3];
		((P0 *)_this)->session = trpt->bup.ovals[2];
		((P0 *)_this)->what = trpt->bup.ovals[1];
		now.due_ack = trpt->bup.ovals[0];
		;
		ungrab_ints(trpt->bup.ovals, 6);
		goto R999;

	case 86: // STATE 50
		;
		now.due_ack = trpt->bup.ovals[1];
	/* 0 */	((P0 *)_this)->what = trpt->bup.ovals[0];
		;
		;
		ungrab_ints(trpt->bup.ovals, 2);
		goto R999;

	case 87: // STATE 73
		;
		((P0 *)_this)->item = trpt->bup.ovals[4];
		((P0 *)_this)->number = trpt->bup.ovals[3];
		((P0 *)_this)->session = trpt->bup.ovals[2];
		((P0 *)_this)->what = trpt->bup.ovals[1];
		now.due_report = trpt->bup.ovals[0];
		;
		ungrab_ints(trpt->bup.ovals, 6);
		goto R999;

	case 88: // STATE 56
		;
	/* 0 */	((P0 *)_this)->what = trpt->bup.oval;
		;
		;
		goto R999;

	case 89: // STATE 73
		;
		((P0 *)_this)->item = trpt->bup.ovals[7];
		((P0 *)_this)->number = trpt->bup.ovals[6];
		((P0 *)_this)->session = trpt->bup.ovals[5];
		((P0 *)_this)->what = trpt->bup.ovals[4];
		now.due_ack = trpt->bup.ovals[3];
		now.due_report = trpt->bup.ovals[2];
		now.in_job = trpt->bup.ovals[1];
		now.m_state = trpt->bup.ovals[0];
		;
		ungrab_ints(trpt->bup.ovals, 9);
		goto R999;

	case 90: // STATE 73
		;
		((P0 *)_this)->item = trpt->bup.ovals[4];
		((P0 *)_this)->number = trpt->bup.ovals[3];
		((P0 *)_this)->session = trpt->bup.ovals[2];
		((P0 *)_this)->what = trpt->bup.ovals[1];
		now.due_ack = trpt->bup.ovals[0];
		;
		ungrab_ints(trpt->bup.ovals, 6);
		goto R999;

	case 91: // STATE 73
		;
		((P0 *)_this)->item = trpt->bup.ovals[3];
		((P0 *)_this)->number = trpt->bup.ovals[2];
		((P0 *)_this)->session = trpt->bup.ovals[1];
		((P0 *)_this)->what = trpt->bup.ovals[0];
		;
		ungrab_ints(trpt->bup.ovals, 5);
		goto R999;

	case 92: // STATE 76
		;
		now.due_welcome = trpt->bup.oval;
		;
		goto R999;

	case 93: // STATE 77
		;
		_m = unsend(now.to_host);
		;
		goto R999;
;
		
	case 94: // STATE 85
		goto R999;

	case 95: // STATE 79
		;
		now.faults = trpt->bup.oval;
		;
		goto R999;

	case 96: // STATE 81
		;
		now.faults = trpt->bup.oval;
		;
		goto R999;

	case 97: // STATE 82
		;
		_m = unsend(now.to_host);
		;
		goto R999;

	case 98: // STATE 83
		;
		_m = unsend(now.to_host);
		;
		goto R999;

	case 99: // STATE 89
		;
		now.due_report = trpt->bup.oval;
		;
		goto R999;

	case 100: // STATE 90
		;
		_m = unsend(now.to_host);
		;
		goto R999;
;
		
	case 101: // STATE 98
		goto R999;

	case 102: // STATE 92
		;
		now.faults = trpt->bup.oval;
		;
		goto R999;

	case 103: // STATE 94
		;
		now.faults = trpt->bup.oval;
		;
		goto R999;

	case 104: // STATE 95
		;
		_m = unsend(now.to_host);
		;
		goto R999;

	case 105: // STATE 96
		;
		_m = unsend(now.to_host);
		;
		goto R999;

	case 106: // STATE 102
		;
		now.due_ack = trpt->bup.oval;
		;
		goto R999;

	case 107: // STATE 103
		;
		_m = unsend(now.to_host);
		;
		goto R999;
;
		
	case 108: // STATE 111
		goto R999;

	case 109: // STATE 105
		;
		now.faults = trpt->bup.oval;
		;
		goto R999;

	case 110: // STATE 107
		;
		now.faults = trpt->bup.oval;
		;
		goto R999;

	case 111: // STATE 108
		;
		_m = unsend(now.to_host);
		;
		goto R999;

	case 112: // STATE 109
		;
		_m = unsend(now.to_host);
		;
		goto R999;

	case 113: // STATE 115
		;
		now.m_executed = trpt->bup.oval;
		;
		goto R999;

	case 114: // STATE 118
		;
		now.due_ack = trpt->bup.oval;
		;
		goto R999;
;
		
	case 115: // STATE 121
		goto R999;

	case 116: // STATE 125
		;
		now.m_state = trpt->bup.oval;
		;
		goto R999;

	case 117: // STATE 127
		;
		now.due_report = trpt->bup.oval;
		;
		goto R999;
;
		
	case 118: // STATE 130
		goto R999;

	case 119: // STATE 133
		;
		now.reboots = trpt->bup.oval;
		;
		goto R999;

	case 120: // STATE 151
		;
		now.due_report = trpt->bup.ovals[13];
		now.due_ack = trpt->bup.ovals[12];
		now.due_welcome = trpt->bup.ovals[11];
		now.in_job = trpt->bup.ovals[10];
		now.m_ended = trpt->bup.ovals[9];
		now.m_opened = trpt->bup.ovals[8];
		now.m_executed = trpt->bup.ovals[7];
		now.m_next = trpt->bup.ovals[6];
		now.m_nonce = trpt->bup.ovals[5];
		now.m_sessions = trpt->bup.ovals[4];
		now.m_session = trpt->bup.ovals[3];
		now.m_state = trpt->bup.ovals[2];
		now.m_boot = trpt->bup.ovals[1];
		now.distrusted = trpt->bup.ovals[0];
		;
		ungrab_ints(trpt->bup.ovals, 14);
		goto R999;

	case 121: // STATE 151
		;
		now.due_report = trpt->bup.ovals[12];
		now.due_ack = trpt->bup.ovals[11];
		now.due_welcome = trpt->bup.ovals[10];
		now.in_job = trpt->bup.ovals[9];
		now.m_ended = trpt->bup.ovals[8];
		now.m_opened = trpt->bup.ovals[7];
		now.m_executed = trpt->bup.ovals[6];
		now.m_next = trpt->bup.ovals[5];
		now.m_nonce = trpt->bup.ovals[4];
		now.m_sessions = trpt->bup.ovals[3];
		now.m_session = trpt->bup.ovals[2];
		now.m_state = trpt->bup.ovals[1];
		now.m_boot = trpt->bup.ovals[0];
		;
		ungrab_ints(trpt->bup.ovals, 13);
		goto R999;

	case 122: // STATE 156
		;
		p_restor(II);
		;
		;
		goto R999;
	}

