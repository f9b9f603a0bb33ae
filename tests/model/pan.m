#define rand	pan_rand
#define pthread_equal(a,b)	((a)==(b))
#if defined(HAS_CODE) && defined(VERBOSE)
	#ifdef BFS_PAR
		bfs_printf("Pr: %d Tr: %d\n", II, t->forw);
	#else
		cpu_printf("Pr: %d Tr: %d\n", II, t->forw);
	#endif
#endif
	switch (t->forw) {
	default: Uerror("bad forward move");
	case 0:	/* if without executable clauses */
		continue;
	case 1: /* generic 'goto' or 'skip' */
		IfNotBlocked
		_m = 3; goto P999;
	case 2: /* generic 'else' */
		IfNotBlocked
		if (trpt->o_pm&1) continue;
		_m = 3; goto P999;

		 /* CLAIM ends */
	case 3: // STATE 1 - _spin_nvr.tmp:4 - [(!(((h_phase==4)||(h_phase==5))))] (0:0:0 - 1)
		
#if defined(VERI) && !defined(NP)
#if NCLAIMS>1
		{	static int reported1 = 0;
			if (verbose && !reported1)
			{	int nn = (int) ((Pclaim *)pptr(0))->_n;
				printf("depth %ld: Claim %s (%d), state %d (line %d)\n",
					depth, procname[spin_c_typ[nn]], nn, (int) ((Pclaim *)pptr(0))->_p, src_claim[ (int) ((Pclaim *)pptr(0))->_p ]);
				reported1 = 1;
				fflush(stdout);
		}	}
#else
		{	static int reported1 = 0;
			if (verbose && !reported1)
			{	printf("depth %d: Claim, state %d (line %d)\n",
					(int) depth, (int) ((Pclaim *)pptr(0))->_p, src_claim[ (int) ((Pclaim *)pptr(0))->_p ]);
				reported1 = 1;
				fflush(stdout);
		}	}
#endif
#endif
		reached[2][1] = 1;
		if (!( !(((((int)now.h_phase)==4)||(((int)now.h_phase)==5)))))
			continue;
		_m = 3; goto P999; /* 0 */
	case 4: // STATE 6 - _spin_nvr.tmp:6 - [-end-] (0:0:0 - 1)
		
#if defined(VERI) && !defined(NP)
#if NCLAIMS>1
		{	static int reported6 = 0;
			if (verbose && !reported6)
			{	int nn = (int) ((Pclaim *)pptr(0))->_n;
				printf("depth %ld: Claim %s (%d), state %d (line %d)\n",
					depth, procname[spin_c_typ[nn]], nn, (int) ((Pclaim *)pptr(0))->_p, src_claim[ (int) ((Pclaim *)pptr(0))->_p ]);
				reported6 = 1;
				fflush(stdout);
		}	}
#else
		{	static int reported6 = 0;
			if (verbose && !reported6)
			{	printf("depth %d: Claim, state %d (line %d)\n",
					(int) depth, (int) ((Pclaim *)pptr(0))->_p, src_claim[ (int) ((Pclaim *)pptr(0))->_p ]);
				reported6 = 1;
				fflush(stdout);
		}	}
#endif
#endif
		reached[2][6] = 1;
		if (!delproc(1, II)) continue;
		_m = 3; goto P999; /* 0 */

		 /* PROC host */
	case 5: // STATE 1 - session.pml:237 - [h_phase = 0] (0:185:6 - 1)
		IfNotBlocked
		reached[1][1] = 1;
		(trpt+1)->bup.ovals = grab_ints(6);
		(trpt+1)->bup.ovals[0] = ((int)now.h_phase);
		now.h_phase = 0;
#ifdef VAR_RANGES
		logval("h_phase", ((int)now.h_phase));
#endif
		;
		/* merge: h_session = 0(185, 2, 185) */
		reached[1][2] = 1;
		(trpt+1)->bup.ovals[1] = ((int)now.h_session);
		now.h_session = 0;
#ifdef VAR_RANGES
		logval("h_session", ((int)now.h_session));
#endif
		;
		/* merge: h_sent = 0(185, 3, 185) */
		reached[1][3] = 1;
		(trpt+1)->bup.ovals[2] = ((int)now.h_sent);
		now.h_sent = 0;
#ifdef VAR_RANGES
		logval("h_sent", ((int)now.h_sent));
#endif
		;
		/* merge: h_end_sent = 0(185, 4, 185) */
		reached[1][4] = 1;
		(trpt+1)->bup.ovals[3] = ((int)now.h_end_sent);
		now.h_end_sent = 0;
#ifdef VAR_RANGES
		logval("h_end_sent", ((int)now.h_end_sent));
#endif
		;
		/* merge: nonces = (nonces+1)(185, 5, 185) */
		reached[1][5] = 1;
		(trpt+1)->bup.ovals[4] = ((int)now.nonces);
		now.nonces = (((int)now.nonces)+1);
#ifdef VAR_RANGES
		logval("nonces", ((int)now.nonces));
#endif
		;
		/* merge: h_nonce = nonces(185, 6, 185) */
		reached[1][6] = 1;
		(trpt+1)->bup.ovals[5] = ((int)now.h_nonce);
		now.h_nonce = ((int)now.nonces);
#ifdef VAR_RANGES
		logval("h_nonce", ((int)now.h_nonce));
#endif
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 3; goto P999; /* 6 */
	case 6: // STATE 9 - session.pml:256 - [to_host?what,session,nonce,next,state,boot] (65:0:8 - 1)
		reached[1][9] = 1;
		if (q_len(now.to_host) == 0) continue;

		XX=1;
		(trpt+1)->bup.ovals = grab_ints(8);
		(trpt+1)->bup.ovals[0] = ((P1 *)_this)->what;
		(trpt+1)->bup.ovals[1] = ((int)((P1 *)_this)->session);
		(trpt+1)->bup.ovals[2] = ((int)((P1 *)_this)->nonce);
		(trpt+1)->bup.ovals[3] = ((int)((P1 *)_this)->next);
		(trpt+1)->bup.ovals[4] = ((int)((P1 *)_this)->state);
		(trpt+1)->bup.ovals[5] = ((int)((P1 *)_this)->boot);
		;
		((P1 *)_this)->what = qrecv(now.to_host, XX-1, 0, 0);
#ifdef VAR_RANGES
		logval("host:what", ((P1 *)_this)->what);
#endif
		;
		((P1 *)_this)->session = qrecv(now.to_host, XX-1, 1, 0);
#ifdef VAR_RANGES
		logval("host:session", ((int)((P1 *)_this)->session));
#endif
		;
		((P1 *)_this)->nonce = qrecv(now.to_host, XX-1, 2, 0);
#ifdef VAR_RANGES
		logval("host:nonce", ((int)((P1 *)_this)->nonce));
#endif
		;
		((P1 *)_this)->next = qrecv(now.to_host, XX-1, 3, 0);
#ifdef VAR_RANGES
		logval("host:next", ((int)((P1 *)_this)->next));
#endif
		;
		((P1 *)_this)->state = qrecv(now.to_host, XX-1, 4, 0);
#ifdef VAR_RANGES
		logval("host:state", ((int)((P1 *)_this)->state));
#endif
		;
		((P1 *)_this)->boot = qrecv(now.to_host, XX-1, 5, 1);
#ifdef VAR_RANGES
		logval("host:boot", ((int)((P1 *)_this)->boot));
#endif
		;
		
#ifdef HAS_CODE
		if (readtrail && gui) {
			char simtmp[32];
			sprintf(simvals, "%d?", now.to_host);
		sprintf(simtmp, "%d", ((P1 *)_this)->what); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)((P1 *)_this)->session)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)((P1 *)_this)->nonce)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)((P1 *)_this)->next)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)((P1 *)_this)->state)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)((P1 *)_this)->boot)); strcat(simvals, simtmp);		}
#endif
		;
		/* merge: opened = (state>=128)(65, 10, 65) */
		reached[1][10] = 1;
		(trpt+1)->bup.ovals[6] = ((int)((P1 *)_this)->opened);
		((P1 *)_this)->opened = (((int)((P1 *)_this)->state)>=128);
#ifdef VAR_RANGES
		logval("host:opened", ((int)((P1 *)_this)->opened));
#endif
		;
		/* merge: state = (state%128)(65, 11, 65) */
		reached[1][11] = 1;
		(trpt+1)->bup.ovals[7] = ((int)((P1 *)_this)->state);
		((P1 *)_this)->state = (((int)((P1 *)_this)->state)%128);
#ifdef VAR_RANGES
		logval("host:state", ((int)((P1 *)_this)->state));
#endif
		;
		_m = 4; goto P999; /* 2 */
	case 7: // STATE 12 - session.pml:260 - [((((what==WELCOME)&&(h_phase==0))&&(nonce==h_nonce)))] (32:0:3 - 1)
		IfNotBlocked
		reached[1][12] = 1;
		if (!((((((P1 *)_this)->what==3)&&(((int)now.h_phase)==0))&&(((int)((P1 *)_this)->nonce)==((int)now.h_nonce)))))
			continue;
		if (TstOnly) return 1; /* TT */
		/* dead 1: what */  (trpt+1)->bup.ovals = grab_ints(3);
		(trpt+1)->bup.ovals[0] = ((P1 *)_this)->what;
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P1 *)_this)->what = 0;
		if (TstOnly) return 1; /* TT */
		/* dead 1: nonce */  (trpt+1)->bup.ovals[1] = ((P1 *)_this)->nonce;
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P1 *)_this)->nonce = 0;
		/* merge: h_session = session(0, 13, 32) */
		reached[1][13] = 1;
		(trpt+1)->bup.ovals[2] = ((int)now.h_session);
		now.h_session = ((int)((P1 *)_this)->session);
#ifdef VAR_RANGES
		logval("h_session", ((int)now.h_session));
#endif
		;
		_m = 3; goto P999; /* 1 */
	case 8: // STATE 14 - session.pml:204 - [h_sent = 0] (0:0:1 - 1)
		IfNotBlocked
		reached[1][14] = 1;
		(trpt+1)->bup.oval = ((int)now.h_sent);
		now.h_sent = 0;
#ifdef VAR_RANGES
		logval("h_sent", ((int)now.h_sent));
#endif
		;
		_m = 3; goto P999; /* 0 */
	case 9: // STATE 15 - session.pml:206 - [((h_opened&&(((state/16)==0)||((boot!=h_boot)&&(0!=4)))))] (185:0:11 - 1)
		IfNotBlocked
		reached[1][15] = 1;
		if (!((((int)now.h_opened)&&(((((int)((P1 *)_this)->state)/16)==0)||((((int)((P1 *)_this)->boot)!=((int)now.h_boot))&&(0!=4))))))
			continue;
		if (TstOnly) return 1; /* TT */
		/* dead 1: state */  (trpt+1)->bup.ovals = grab_ints(11);
		(trpt+1)->bup.ovals[0] = ((P1 *)_this)->state;
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P1 *)_this)->state = 0;
		/* merge: h_phase = 5(185, 16, 185) */
		reached[1][16] = 1;
		(trpt+1)->bup.ovals[1] = ((int)now.h_phase);
		now.h_phase = 5;
#ifdef VAR_RANGES
		logval("h_phase", ((int)now.h_phase));
#endif
		;
		/* merge: .(goto)(185, 30, 185) */
		reached[1][30] = 1;
		;
		/* merge: h_boot = boot(185, 31, 185) */
		reached[1][31] = 1;
		(trpt+1)->bup.ovals[2] = ((int)now.h_boot);
		now.h_boot = ((int)((P1 *)_this)->boot);
#ifdef VAR_RANGES
		logval("h_boot", ((int)now.h_boot));
#endif
		;
		/* merge: .(goto)(185, 66, 185) */
		reached[1][66] = 1;
		;
		/* merge: what = HELLO(185, 67, 185) */
		reached[1][67] = 1;
		(trpt+1)->bup.ovals[3] = ((P1 *)_this)->what;
		((P1 *)_this)->what = 9;
#ifdef VAR_RANGES
		logval("host:what", ((P1 *)_this)->what);
#endif
		;
		if (TstOnly) return 1; /* TT */
		/* dead 2: what */  
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P1 *)_this)->what = 0;
		/* merge: session = 0(185, 68, 185) */
		reached[1][68] = 1;
		(trpt+1)->bup.ovals[4] = ((int)((P1 *)_this)->session);
		((P1 *)_this)->session = 0;
#ifdef VAR_RANGES
		logval("host:session", ((int)((P1 *)_this)->session));
#endif
		;
		/* merge: nonce = 0(185, 69, 185) */
		reached[1][69] = 1;
		(trpt+1)->bup.ovals[5] = ((int)((P1 *)_this)->nonce);
		((P1 *)_this)->nonce = 0;
#ifdef VAR_RANGES
		logval("host:nonce", ((int)((P1 *)_this)->nonce));
#endif
		;
		/* merge: next = 0(185, 70, 185) */
		reached[1][70] = 1;
		(trpt+1)->bup.ovals[6] = ((int)((P1 *)_this)->next);
		((P1 *)_this)->next = 0;
#ifdef VAR_RANGES
		logval("host:next", ((int)((P1 *)_this)->next));
#endif
		;
		/* merge: state = 0(185, 71, 185) */
		reached[1][71] = 1;
		(trpt+1)->bup.ovals[7] = ((int)((P1 *)_this)->state);
		((P1 *)_this)->state = 0;
#ifdef VAR_RANGES
		logval("host:state", ((int)((P1 *)_this)->state));
#endif
		;
		/* merge: boot = 0(185, 72, 185) */
		reached[1][72] = 1;
		(trpt+1)->bup.ovals[8] = ((int)((P1 *)_this)->boot);
		((P1 *)_this)->boot = 0;
#ifdef VAR_RANGES
		logval("host:boot", ((int)((P1 *)_this)->boot));
#endif
		;
		/* merge: opened = 0(185, 73, 185) */
		reached[1][73] = 1;
		(trpt+1)->bup.ovals[9] = ((int)((P1 *)_this)->opened);
		((P1 *)_this)->opened = 0;
#ifdef VAR_RANGES
		logval("host:opened", ((int)((P1 *)_this)->opened));
#endif
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 3; goto P999; /* 12 */
	case 10: // STATE 18 - session.pml:209 - [(((state/16)==0))] (185:0:11 - 1)
		IfNotBlocked
		reached[1][18] = 1;
		if (!(((((int)((P1 *)_this)->state)/16)==0)))
			continue;
		if (TstOnly) return 1; /* TT */
		/* dead 1: state */  (trpt+1)->bup.ovals = grab_ints(11);
		(trpt+1)->bup.ovals[0] = ((P1 *)_this)->state;
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P1 *)_this)->state = 0;
		/* merge: h_phase = 1(185, 19, 185) */
		reached[1][19] = 1;
		(trpt+1)->bup.ovals[1] = ((int)now.h_phase);
		now.h_phase = 1;
#ifdef VAR_RANGES
		logval("h_phase", ((int)now.h_phase));
#endif
		;
		/* merge: .(goto)(185, 28, 185) */
		reached[1][28] = 1;
		;
		/* merge: .(goto)(185, 30, 185) */
		reached[1][30] = 1;
		;
		/* merge: h_boot = boot(185, 31, 185) */
		reached[1][31] = 1;
		(trpt+1)->bup.ovals[2] = ((int)now.h_boot);
		now.h_boot = ((int)((P1 *)_this)->boot);
#ifdef VAR_RANGES
		logval("h_boot", ((int)now.h_boot));
#endif
		;
		/* merge: .(goto)(185, 66, 185) */
		reached[1][66] = 1;
		;
		/* merge: what = HELLO(185, 67, 185) */
		reached[1][67] = 1;
		(trpt+1)->bup.ovals[3] = ((P1 *)_this)->what;
		((P1 *)_this)->what = 9;
#ifdef VAR_RANGES
		logval("host:what", ((P1 *)_this)->what);
#endif
		;
		if (TstOnly) return 1; /* TT */
		/* dead 2: what */  
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P1 *)_this)->what = 0;
		/* merge: session = 0(185, 68, 185) */
		reached[1][68] = 1;
		(trpt+1)->bup.ovals[4] = ((int)((P1 *)_this)->session);
		((P1 *)_this)->session = 0;
#ifdef VAR_RANGES
		logval("host:session", ((int)((P1 *)_this)->session));
#endif
		;
		/* merge: nonce = 0(185, 69, 185) */
		reached[1][69] = 1;
		(trpt+1)->bup.ovals[5] = ((int)((P1 *)_this)->nonce);
		((P1 *)_this)->nonce = 0;
#ifdef VAR_RANGES
		logval("host:nonce", ((int)((P1 *)_this)->nonce));
#endif
		;
		/* merge: next = 0(185, 70, 185) */
		reached[1][70] = 1;
		(trpt+1)->bup.ovals[6] = ((int)((P1 *)_this)->next);
		((P1 *)_this)->next = 0;
#ifdef VAR_RANGES
		logval("host:next", ((int)((P1 *)_this)->next));
#endif
		;
		/* merge: state = 0(185, 71, 185) */
		reached[1][71] = 1;
		(trpt+1)->bup.ovals[7] = ((int)((P1 *)_this)->state);
		((P1 *)_this)->state = 0;
#ifdef VAR_RANGES
		logval("host:state", ((int)((P1 *)_this)->state));
#endif
		;
		/* merge: boot = 0(185, 72, 185) */
		reached[1][72] = 1;
		(trpt+1)->bup.ovals[8] = ((int)((P1 *)_this)->boot);
		((P1 *)_this)->boot = 0;
#ifdef VAR_RANGES
		logval("host:boot", ((int)((P1 *)_this)->boot));
#endif
		;
		/* merge: opened = 0(185, 73, 185) */
		reached[1][73] = 1;
		(trpt+1)->bup.ovals[9] = ((int)((P1 *)_this)->opened);
		((P1 *)_this)->opened = 0;
#ifdef VAR_RANGES
		logval("host:opened", ((int)((P1 *)_this)->opened));
#endif
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 3; goto P999; /* 13 */
	case 11: // STATE 21 - session.pml:211 - [h_phase = 2] (0:185:15 - 1)
		IfNotBlocked
		reached[1][21] = 1;
		(trpt+1)->bup.ovals = grab_ints(15);
		(trpt+1)->bup.ovals[0] = ((int)now.h_phase);
		now.h_phase = 2;
#ifdef VAR_RANGES
		logval("h_phase", ((int)now.h_phase));
#endif
		;
		/* merge: h_opened = 1(185, 22, 185) */
		reached[1][22] = 1;
		(trpt+1)->bup.ovals[1] = ((int)now.h_opened);
		now.h_opened = 1;
#ifdef VAR_RANGES
		logval("h_opened", ((int)now.h_opened));
#endif
		;
		/* merge: h_base = next(185, 23, 185) */
		reached[1][23] = 1;
		(trpt+1)->bup.ovals[2] = ((int)now.h_base);
		now.h_base = ((int)((P1 *)_this)->next);
#ifdef VAR_RANGES
		logval("h_base", ((int)now.h_base));
#endif
		;
		/* merge: h_send = next(185, 24, 185) */
		reached[1][24] = 1;
		(trpt+1)->bup.ovals[3] = ((int)now.h_send);
		now.h_send = ((int)((P1 *)_this)->next);
#ifdef VAR_RANGES
		logval("h_send", ((int)now.h_send));
#endif
		;
		/* merge: h_limit = (state%16)(185, 25, 185) */
		reached[1][25] = 1;
		(trpt+1)->bup.ovals[4] = ((int)now.h_limit);
		now.h_limit = (((int)((P1 *)_this)->state)%16);
#ifdef VAR_RANGES
		logval("h_limit", ((int)now.h_limit));
#endif
		;
		/* merge: h_end_sent = 0(185, 26, 185) */
		reached[1][26] = 1;
		(trpt+1)->bup.ovals[5] = ((int)now.h_end_sent);
		now.h_end_sent = 0;
#ifdef VAR_RANGES
		logval("h_end_sent", ((int)now.h_end_sent));
#endif
		;
		/* merge: .(goto)(185, 28, 185) */
		reached[1][28] = 1;
		;
		/* merge: .(goto)(185, 30, 185) */
		reached[1][30] = 1;
		;
		/* merge: h_boot = boot(185, 31, 185) */
		reached[1][31] = 1;
		(trpt+1)->bup.ovals[6] = ((int)now.h_boot);
		now.h_boot = ((int)((P1 *)_this)->boot);
#ifdef VAR_RANGES
		logval("h_boot", ((int)now.h_boot));
#endif
		;
		/* merge: .(goto)(185, 66, 185) */
		reached[1][66] = 1;
		;
		/* merge: what = HELLO(185, 67, 185) */
		reached[1][67] = 1;
		(trpt+1)->bup.ovals[7] = ((P1 *)_this)->what;
		((P1 *)_this)->what = 9;
#ifdef VAR_RANGES
		logval("host:what", ((P1 *)_this)->what);
#endif
		;
		if (TstOnly) return 1; /* TT */
		/* dead 2: what */  
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P1 *)_this)->what = 0;
		/* merge: session = 0(185, 68, 185) */
		reached[1][68] = 1;
		(trpt+1)->bup.ovals[8] = ((int)((P1 *)_this)->session);
		((P1 *)_this)->session = 0;
#ifdef VAR_RANGES
		logval("host:session", ((int)((P1 *)_this)->session));
#endif
		;
		/* merge: nonce = 0(185, 69, 185) */
		reached[1][69] = 1;
		(trpt+1)->bup.ovals[9] = ((int)((P1 *)_this)->nonce);
		((P1 *)_this)->nonce = 0;
#ifdef VAR_RANGES
		logval("host:nonce", ((int)((P1 *)_this)->nonce));
#endif
		;
		/* merge: next = 0(185, 70, 185) */
		reached[1][70] = 1;
		(trpt+1)->bup.ovals[10] = ((int)((P1 *)_this)->next);
		((P1 *)_this)->next = 0;
#ifdef VAR_RANGES
		logval("host:next", ((int)((P1 *)_this)->next));
#endif
		;
		/* merge: state = 0(185, 71, 185) */
		reached[1][71] = 1;
		(trpt+1)->bup.ovals[11] = ((int)((P1 *)_this)->state);
		((P1 *)_this)->state = 0;
#ifdef VAR_RANGES
		logval("host:state", ((int)((P1 *)_this)->state));
#endif
		;
		/* merge: boot = 0(185, 72, 185) */
		reached[1][72] = 1;
		(trpt+1)->bup.ovals[12] = ((int)((P1 *)_this)->boot);
		((P1 *)_this)->boot = 0;
#ifdef VAR_RANGES
		logval("host:boot", ((int)((P1 *)_this)->boot));
#endif
		;
		/* merge: opened = 0(185, 73, 185) */
		reached[1][73] = 1;
		(trpt+1)->bup.ovals[13] = ((int)((P1 *)_this)->opened);
		((P1 *)_this)->opened = 0;
#ifdef VAR_RANGES
		logval("host:opened", ((int)((P1 *)_this)->opened));
#endif
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 3; goto P999; /* 17 */
	case 12: // STATE 31 - session.pml:214 - [h_boot = boot] (0:185:9 - 5)
		IfNotBlocked
		reached[1][31] = 1;
		(trpt+1)->bup.ovals = grab_ints(9);
		(trpt+1)->bup.ovals[0] = ((int)now.h_boot);
		now.h_boot = ((int)((P1 *)_this)->boot);
#ifdef VAR_RANGES
		logval("h_boot", ((int)now.h_boot));
#endif
		;
		/* merge: .(goto)(185, 66, 185) */
		reached[1][66] = 1;
		;
		/* merge: what = HELLO(185, 67, 185) */
		reached[1][67] = 1;
		(trpt+1)->bup.ovals[1] = ((P1 *)_this)->what;
		((P1 *)_this)->what = 9;
#ifdef VAR_RANGES
		logval("host:what", ((P1 *)_this)->what);
#endif
		;
		if (TstOnly) return 1; /* TT */
		/* dead 2: what */  
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P1 *)_this)->what = 0;
		/* merge: session = 0(185, 68, 185) */
		reached[1][68] = 1;
		(trpt+1)->bup.ovals[2] = ((int)((P1 *)_this)->session);
		((P1 *)_this)->session = 0;
#ifdef VAR_RANGES
		logval("host:session", ((int)((P1 *)_this)->session));
#endif
		;
		/* merge: nonce = 0(185, 69, 185) */
		reached[1][69] = 1;
		(trpt+1)->bup.ovals[3] = ((int)((P1 *)_this)->nonce);
		((P1 *)_this)->nonce = 0;
#ifdef VAR_RANGES
		logval("host:nonce", ((int)((P1 *)_this)->nonce));
#endif
		;
		/* merge: next = 0(185, 70, 185) */
		reached[1][70] = 1;
		(trpt+1)->bup.ovals[4] = ((int)((P1 *)_this)->next);
		((P1 *)_this)->next = 0;
#ifdef VAR_RANGES
		logval("host:next", ((int)((P1 *)_this)->next));
#endif
		;
		/* merge: state = 0(185, 71, 185) */
		reached[1][71] = 1;
		(trpt+1)->bup.ovals[5] = ((int)((P1 *)_this)->state);
		((P1 *)_this)->state = 0;
#ifdef VAR_RANGES
		logval("host:state", ((int)((P1 *)_this)->state));
#endif
		;
		/* merge: boot = 0(185, 72, 185) */
		reached[1][72] = 1;
		(trpt+1)->bup.ovals[6] = ((int)((P1 *)_this)->boot);
		((P1 *)_this)->boot = 0;
#ifdef VAR_RANGES
		logval("host:boot", ((int)((P1 *)_this)->boot));
#endif
		;
		/* merge: opened = 0(185, 73, 185) */
		reached[1][73] = 1;
		(trpt+1)->bup.ovals[7] = ((int)((P1 *)_this)->opened);
		((P1 *)_this)->opened = 0;
#ifdef VAR_RANGES
		logval("host:opened", ((int)((P1 *)_this)->opened));
#endif
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 3; goto P999; /* 9 */
	case 13: // STATE 33 - session.pml:263 - [((((what==ACK)&&(h_phase!=0))&&((session==h_session)||(0==1))))] (0:0:2 - 1)
		IfNotBlocked
		reached[1][33] = 1;
		if (!((((((P1 *)_this)->what==2)&&(((int)now.h_phase)!=0))&&((((int)((P1 *)_this)->session)==((int)now.h_session))||(0==1)))))
			continue;
		if (TstOnly) return 1; /* TT */
		/* dead 1: what */  (trpt+1)->bup.ovals = grab_ints(2);
		(trpt+1)->bup.ovals[0] = ((P1 *)_this)->what;
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P1 *)_this)->what = 0;
		if (TstOnly) return 1; /* TT */
		/* dead 1: session */  (trpt+1)->bup.ovals[1] = ((P1 *)_this)->session;
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P1 *)_this)->session = 0;
		_m = 3; goto P999; /* 0 */
	case 14: // STATE 34 - session.pml:220 - [((((h_phase==1)&&h_sent)&&opened))] (185:0:15 - 1)
		IfNotBlocked
		reached[1][34] = 1;
		if (!((((((int)now.h_phase)==1)&&((int)now.h_sent))&&((int)((P1 *)_this)->opened))))
			continue;
		if (TstOnly) return 1; /* TT */
		/* dead 1: opened */  (trpt+1)->bup.ovals = grab_ints(15);
		(trpt+1)->bup.ovals[0] = ((P1 *)_this)->opened;
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P1 *)_this)->opened = 0;
		/* merge: h_phase = 2(185, 35, 185) */
		reached[1][35] = 1;
		(trpt+1)->bup.ovals[1] = ((int)now.h_phase);
		now.h_phase = 2;
#ifdef VAR_RANGES
		logval("h_phase", ((int)now.h_phase));
#endif
		;
		/* merge: h_opened = 1(185, 36, 185) */
		reached[1][36] = 1;
		(trpt+1)->bup.ovals[2] = ((int)now.h_opened);
		now.h_opened = 1;
#ifdef VAR_RANGES
		logval("h_opened", ((int)now.h_opened));
#endif
		;
		/* merge: h_base = next(185, 37, 185) */
		reached[1][37] = 1;
		(trpt+1)->bup.ovals[3] = ((int)now.h_base);
		now.h_base = ((int)((P1 *)_this)->next);
#ifdef VAR_RANGES
		logval("h_base", ((int)now.h_base));
#endif
		;
		/* merge: h_send = next(185, 38, 185) */
		reached[1][38] = 1;
		(trpt+1)->bup.ovals[4] = ((int)now.h_send);
		now.h_send = ((int)((P1 *)_this)->next);
#ifdef VAR_RANGES
		logval("h_send", ((int)now.h_send));
#endif
		;
		/* merge: h_limit = (state%16)(185, 39, 185) */
		reached[1][39] = 1;
		(trpt+1)->bup.ovals[5] = ((int)now.h_limit);
		now.h_limit = (((int)((P1 *)_this)->state)%16);
#ifdef VAR_RANGES
		logval("h_limit", ((int)now.h_limit));
#endif
		;
		/* merge: h_end_sent = 0(185, 40, 185) */
		reached[1][40] = 1;
		(trpt+1)->bup.ovals[6] = ((int)now.h_end_sent);
		now.h_end_sent = 0;
#ifdef VAR_RANGES
		logval("h_end_sent", ((int)now.h_end_sent));
#endif
		;
		/* merge: .(goto)(185, 59, 185) */
		reached[1][59] = 1;
		;
		/* merge: .(goto)(185, 66, 185) */
		reached[1][66] = 1;
		;
		/* merge: what = HELLO(185, 67, 185) */
		reached[1][67] = 1;
		(trpt+1)->bup.ovals[7] = ((P1 *)_this)->what;
		((P1 *)_this)->what = 9;
#ifdef VAR_RANGES
		logval("host:what", ((P1 *)_this)->what);
#endif
		;
		if (TstOnly) return 1; /* TT */
		/* dead 2: what */  
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P1 *)_this)->what = 0;
		/* merge: session = 0(185, 68, 185) */
		reached[1][68] = 1;
		(trpt+1)->bup.ovals[8] = ((int)((P1 *)_this)->session);
		((P1 *)_this)->session = 0;
#ifdef VAR_RANGES
		logval("host:session", ((int)((P1 *)_this)->session));
#endif
		;
		/* merge: nonce = 0(185, 69, 185) */
		reached[1][69] = 1;
		(trpt+1)->bup.ovals[9] = ((int)((P1 *)_this)->nonce);
		((P1 *)_this)->nonce = 0;
#ifdef VAR_RANGES
		logval("host:nonce", ((int)((P1 *)_this)->nonce));
#endif
		;
		/* merge: next = 0(185, 70, 185) */
		reached[1][70] = 1;
		(trpt+1)->bup.ovals[10] = ((int)((P1 *)_this)->next);
		((P1 *)_this)->next = 0;
#ifdef VAR_RANGES
		logval("host:next", ((int)((P1 *)_this)->next));
#endif
		;
		/* merge: state = 0(185, 71, 185) */
		reached[1][71] = 1;
		(trpt+1)->bup.ovals[11] = ((int)((P1 *)_this)->state);
		((P1 *)_this)->state = 0;
#ifdef VAR_RANGES
		logval("host:state", ((int)((P1 *)_this)->state));
#endif
		;
		/* merge: boot = 0(185, 72, 185) */
		reached[1][72] = 1;
		(trpt+1)->bup.ovals[12] = ((int)((P1 *)_this)->boot);
		((P1 *)_this)->boot = 0;
#ifdef VAR_RANGES
		logval("host:boot", ((int)((P1 *)_this)->boot));
#endif
		;
		/* merge: opened = 0(185, 73, 185) */
		reached[1][73] = 1;
		(trpt+1)->bup.ovals[13] = ((int)((P1 *)_this)->opened);
		((P1 *)_this)->opened = 0;
#ifdef VAR_RANGES
		logval("host:opened", ((int)((P1 *)_this)->opened));
#endif
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 3; goto P999; /* 16 */
	case 15: // STATE 41 - session.pml:222 - [(((h_phase==2)&&(next>=h_base)))] (46:0:1 - 1)
		IfNotBlocked
		reached[1][41] = 1;
		if (!(((((int)now.h_phase)==2)&&(((int)((P1 *)_this)->next)>=((int)now.h_base)))))
			continue;
		/* merge: h_base = next(0, 42, 46) */
		reached[1][42] = 1;
		(trpt+1)->bup.oval = ((int)now.h_base);
		now.h_base = ((int)((P1 *)_this)->next);
#ifdef VAR_RANGES
		logval("h_base", ((int)now.h_base));
#endif
		;
		_m = 3; goto P999; /* 1 */
	case 16: // STATE 43 - session.pml:224 - [((h_send<next))] (53:0:1 - 1)
		IfNotBlocked
		reached[1][43] = 1;
		if (!((((int)now.h_send)<((int)((P1 *)_this)->next))))
			continue;
		/* merge: h_send = next(0, 44, 53) */
		reached[1][44] = 1;
		(trpt+1)->bup.oval = ((int)now.h_send);
		now.h_send = ((int)((P1 *)_this)->next);
#ifdef VAR_RANGES
		logval("h_send", ((int)now.h_send));
#endif
		;
		/* merge: .(goto)(0, 47, 53) */
		reached[1][47] = 1;
		;
		_m = 3; goto P999; /* 2 */
	case 17: // STATE 48 - session.pml:226 - [((0==3))] (185:0:9 - 1)
		IfNotBlocked
		reached[1][48] = 1;
		if (!((0==3)))
			continue;
		/* merge: h_limit = (h_limit+1)(185, 49, 185) */
		reached[1][49] = 1;
		(trpt+1)->bup.ovals = grab_ints(9);
		(trpt+1)->bup.ovals[0] = ((int)now.h_limit);
		now.h_limit = (((int)now.h_limit)+1);
#ifdef VAR_RANGES
		logval("h_limit", ((int)now.h_limit));
#endif
		;
		/* merge: .(goto)(185, 54, 185) */
		reached[1][54] = 1;
		;
		/* merge: .(goto)(185, 59, 185) */
		reached[1][59] = 1;
		;
		/* merge: .(goto)(185, 66, 185) */
		reached[1][66] = 1;
		;
		/* merge: what = HELLO(185, 67, 185) */
		reached[1][67] = 1;
		(trpt+1)->bup.ovals[1] = ((P1 *)_this)->what;
		((P1 *)_this)->what = 9;
#ifdef VAR_RANGES
		logval("host:what", ((P1 *)_this)->what);
#endif
		;
		if (TstOnly) return 1; /* TT */
		/* dead 2: what */  
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P1 *)_this)->what = 0;
		/* merge: session = 0(185, 68, 185) */
		reached[1][68] = 1;
		(trpt+1)->bup.ovals[2] = ((int)((P1 *)_this)->session);
		((P1 *)_this)->session = 0;
#ifdef VAR_RANGES
		logval("host:session", ((int)((P1 *)_this)->session));
#endif
		;
		/* merge: nonce = 0(185, 69, 185) */
		reached[1][69] = 1;
		(trpt+1)->bup.ovals[3] = ((int)((P1 *)_this)->nonce);
		((P1 *)_this)->nonce = 0;
#ifdef VAR_RANGES
		logval("host:nonce", ((int)((P1 *)_this)->nonce));
#endif
		;
		/* merge: next = 0(185, 70, 185) */
		reached[1][70] = 1;
		(trpt+1)->bup.ovals[4] = ((int)((P1 *)_this)->next);
		((P1 *)_this)->next = 0;
#ifdef VAR_RANGES
		logval("host:next", ((int)((P1 *)_this)->next));
#endif
		;
		/* merge: state = 0(185, 71, 185) */
		reached[1][71] = 1;
		(trpt+1)->bup.ovals[5] = ((int)((P1 *)_this)->state);
		((P1 *)_this)->state = 0;
#ifdef VAR_RANGES
		logval("host:state", ((int)((P1 *)_this)->state));
#endif
		;
		/* merge: boot = 0(185, 72, 185) */
		reached[1][72] = 1;
		(trpt+1)->bup.ovals[6] = ((int)((P1 *)_this)->boot);
		((P1 *)_this)->boot = 0;
#ifdef VAR_RANGES
		logval("host:boot", ((int)((P1 *)_this)->boot));
#endif
		;
		/* merge: opened = 0(185, 73, 185) */
		reached[1][73] = 1;
		(trpt+1)->bup.ovals[7] = ((int)((P1 *)_this)->opened);
		((P1 *)_this)->opened = 0;
#ifdef VAR_RANGES
		logval("host:opened", ((int)((P1 *)_this)->opened));
#endif
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 3; goto P999; /* 12 */
	case 18: // STATE 50 - session.pml:227 - [(((0!=3)&&((state%16)>h_limit)))] (185:0:9 - 1)
		IfNotBlocked
		reached[1][50] = 1;
		if (!(((0!=3)&&((((int)((P1 *)_this)->state)%16)>((int)now.h_limit)))))
			continue;
		/* merge: h_limit = (state%16)(185, 51, 185) */
		reached[1][51] = 1;
		(trpt+1)->bup.ovals = grab_ints(9);
		(trpt+1)->bup.ovals[0] = ((int)now.h_limit);
		now.h_limit = (((int)((P1 *)_this)->state)%16);
#ifdef VAR_RANGES
		logval("h_limit", ((int)now.h_limit));
#endif
		;
		/* merge: .(goto)(185, 54, 185) */
		reached[1][54] = 1;
		;
		/* merge: .(goto)(185, 59, 185) */
		reached[1][59] = 1;
		;
		/* merge: .(goto)(185, 66, 185) */
		reached[1][66] = 1;
		;
		/* merge: what = HELLO(185, 67, 185) */
		reached[1][67] = 1;
		(trpt+1)->bup.ovals[1] = ((P1 *)_this)->what;
		((P1 *)_this)->what = 9;
#ifdef VAR_RANGES
		logval("host:what", ((P1 *)_this)->what);
#endif
		;
		if (TstOnly) return 1; /* TT */
		/* dead 2: what */  
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P1 *)_this)->what = 0;
		/* merge: session = 0(185, 68, 185) */
		reached[1][68] = 1;
		(trpt+1)->bup.ovals[2] = ((int)((P1 *)_this)->session);
		((P1 *)_this)->session = 0;
#ifdef VAR_RANGES
		logval("host:session", ((int)((P1 *)_this)->session));
#endif
		;
		/* merge: nonce = 0(185, 69, 185) */
		reached[1][69] = 1;
		(trpt+1)->bup.ovals[3] = ((int)((P1 *)_this)->nonce);
		((P1 *)_this)->nonce = 0;
#ifdef VAR_RANGES
		logval("host:nonce", ((int)((P1 *)_this)->nonce));
#endif
		;
		/* merge: next = 0(185, 70, 185) */
		reached[1][70] = 1;
		(trpt+1)->bup.ovals[4] = ((int)((P1 *)_this)->next);
		((P1 *)_this)->next = 0;
#ifdef VAR_RANGES
		logval("host:next", ((int)((P1 *)_this)->next));
#endif
		;
		/* merge: state = 0(185, 71, 185) */
		reached[1][71] = 1;
		(trpt+1)->bup.ovals[5] = ((int)((P1 *)_this)->state);
		((P1 *)_this)->state = 0;
#ifdef VAR_RANGES
		logval("host:state", ((int)((P1 *)_this)->state));
#endif
		;
		/* merge: boot = 0(185, 72, 185) */
		reached[1][72] = 1;
		(trpt+1)->bup.ovals[6] = ((int)((P1 *)_this)->boot);
		((P1 *)_this)->boot = 0;
#ifdef VAR_RANGES
		logval("host:boot", ((int)((P1 *)_this)->boot));
#endif
		;
		/* merge: opened = 0(185, 73, 185) */
		reached[1][73] = 1;
		(trpt+1)->bup.ovals[7] = ((int)((P1 *)_this)->opened);
		((P1 *)_this)->opened = 0;
#ifdef VAR_RANGES
		logval("host:opened", ((int)((P1 *)_this)->opened));
#endif
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 3; goto P999; /* 12 */
	case 19: // STATE 55 - session.pml:230 - [(((h_phase==3)&&((state/16)==0)))] (185:0:10 - 1)
		IfNotBlocked
		reached[1][55] = 1;
		if (!(((((int)now.h_phase)==3)&&((((int)((P1 *)_this)->state)/16)==0))))
			continue;
		if (TstOnly) return 1; /* TT */
		/* dead 1: state */  (trpt+1)->bup.ovals = grab_ints(10);
		(trpt+1)->bup.ovals[0] = ((P1 *)_this)->state;
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P1 *)_this)->state = 0;
		/* merge: h_phase = 4(185, 56, 185) */
		reached[1][56] = 1;
		(trpt+1)->bup.ovals[1] = ((int)now.h_phase);
		now.h_phase = 4;
#ifdef VAR_RANGES
		logval("h_phase", ((int)now.h_phase));
#endif
		;
		/* merge: .(goto)(185, 59, 185) */
		reached[1][59] = 1;
		;
		/* merge: .(goto)(185, 66, 185) */
		reached[1][66] = 1;
		;
		/* merge: what = HELLO(185, 67, 185) */
		reached[1][67] = 1;
		(trpt+1)->bup.ovals[2] = ((P1 *)_this)->what;
		((P1 *)_this)->what = 9;
#ifdef VAR_RANGES
		logval("host:what", ((P1 *)_this)->what);
#endif
		;
		if (TstOnly) return 1; /* TT */
		/* dead 2: what */  
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P1 *)_this)->what = 0;
		/* merge: session = 0(185, 68, 185) */
		reached[1][68] = 1;
		(trpt+1)->bup.ovals[3] = ((int)((P1 *)_this)->session);
		((P1 *)_this)->session = 0;
#ifdef VAR_RANGES
		logval("host:session", ((int)((P1 *)_this)->session));
#endif
		;
		/* merge: nonce = 0(185, 69, 185) */
		reached[1][69] = 1;
		(trpt+1)->bup.ovals[4] = ((int)((P1 *)_this)->nonce);
		((P1 *)_this)->nonce = 0;
#ifdef VAR_RANGES
		logval("host:nonce", ((int)((P1 *)_this)->nonce));
#endif
		;
		/* merge: next = 0(185, 70, 185) */
		reached[1][70] = 1;
		(trpt+1)->bup.ovals[5] = ((int)((P1 *)_this)->next);
		((P1 *)_this)->next = 0;
#ifdef VAR_RANGES
		logval("host:next", ((int)((P1 *)_this)->next));
#endif
		;
		/* merge: state = 0(185, 71, 185) */
		reached[1][71] = 1;
		(trpt+1)->bup.ovals[6] = ((int)((P1 *)_this)->state);
		((P1 *)_this)->state = 0;
#ifdef VAR_RANGES
		logval("host:state", ((int)((P1 *)_this)->state));
#endif
		;
		/* merge: boot = 0(185, 72, 185) */
		reached[1][72] = 1;
		(trpt+1)->bup.ovals[7] = ((int)((P1 *)_this)->boot);
		((P1 *)_this)->boot = 0;
#ifdef VAR_RANGES
		logval("host:boot", ((int)((P1 *)_this)->boot));
#endif
		;
		/* merge: opened = 0(185, 73, 185) */
		reached[1][73] = 1;
		(trpt+1)->bup.ovals[8] = ((int)((P1 *)_this)->opened);
		((P1 *)_this)->opened = 0;
#ifdef VAR_RANGES
		logval("host:opened", ((int)((P1 *)_this)->opened));
#endif
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 3; goto P999; /* 11 */
	case 20: // STATE 61 - session.pml:265 - [((((what==REPORT)&&(h_phase==2))&&(session==h_session)))] (185:0:12 - 1)
		IfNotBlocked
		reached[1][61] = 1;
		if (!((((((P1 *)_this)->what==1)&&(((int)now.h_phase)==2))&&(((int)((P1 *)_this)->session)==((int)now.h_session)))))
			continue;
		if (TstOnly) return 1; /* TT */
		/* dead 1: what */  (trpt+1)->bup.ovals = grab_ints(12);
		(trpt+1)->bup.ovals[0] = ((P1 *)_this)->what;
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P1 *)_this)->what = 0;
		if (TstOnly) return 1; /* TT */
		/* dead 1: session */  (trpt+1)->bup.ovals[1] = ((P1 *)_this)->session;
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P1 *)_this)->session = 0;
		/* merge: h_phase = 3(185, 62, 185) */
		reached[1][62] = 1;
		(trpt+1)->bup.ovals[2] = ((int)now.h_phase);
		now.h_phase = 3;
#ifdef VAR_RANGES
		logval("h_phase", ((int)now.h_phase));
#endif
		;
		/* merge: h_sent = 0(185, 63, 185) */
		reached[1][63] = 1;
		(trpt+1)->bup.ovals[3] = ((int)now.h_sent);
		now.h_sent = 0;
#ifdef VAR_RANGES
		logval("h_sent", ((int)now.h_sent));
#endif
		;
		/* merge: .(goto)(185, 66, 185) */
		reached[1][66] = 1;
		;
		/* merge: what = HELLO(185, 67, 185) */
		reached[1][67] = 1;
		(trpt+1)->bup.ovals[4] = ((P1 *)_this)->what;
		((P1 *)_this)->what = 9;
#ifdef VAR_RANGES
		logval("host:what", ((P1 *)_this)->what);
#endif
		;
		if (TstOnly) return 1; /* TT */
		/* dead 2: what */  
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P1 *)_this)->what = 0;
		/* merge: session = 0(185, 68, 185) */
		reached[1][68] = 1;
		(trpt+1)->bup.ovals[5] = ((int)((P1 *)_this)->session);
		((P1 *)_this)->session = 0;
#ifdef VAR_RANGES
		logval("host:session", ((int)((P1 *)_this)->session));
#endif
		;
		/* merge: nonce = 0(185, 69, 185) */
		reached[1][69] = 1;
		(trpt+1)->bup.ovals[6] = ((int)((P1 *)_this)->nonce);
		((P1 *)_this)->nonce = 0;
#ifdef VAR_RANGES
		logval("host:nonce", ((int)((P1 *)_this)->nonce));
#endif
		;
		/* merge: next = 0(185, 70, 185) */
		reached[1][70] = 1;
		(trpt+1)->bup.ovals[7] = ((int)((P1 *)_this)->next);
		((P1 *)_this)->next = 0;
#ifdef VAR_RANGES
		logval("host:next", ((int)((P1 *)_this)->next));
#endif
		;
		/* merge: state = 0(185, 71, 185) */
		reached[1][71] = 1;
		(trpt+1)->bup.ovals[8] = ((int)((P1 *)_this)->state);
		((P1 *)_this)->state = 0;
#ifdef VAR_RANGES
		logval("host:state", ((int)((P1 *)_this)->state));
#endif
		;
		/* merge: boot = 0(185, 72, 185) */
		reached[1][72] = 1;
		(trpt+1)->bup.ovals[9] = ((int)((P1 *)_this)->boot);
		((P1 *)_this)->boot = 0;
#ifdef VAR_RANGES
		logval("host:boot", ((int)((P1 *)_this)->boot));
#endif
		;
		/* merge: opened = 0(185, 73, 185) */
		reached[1][73] = 1;
		(trpt+1)->bup.ovals[10] = ((int)((P1 *)_this)->opened);
		((P1 *)_this)->opened = 0;
#ifdef VAR_RANGES
		logval("host:opened", ((int)((P1 *)_this)->opened));
#endif
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 3; goto P999; /* 11 */
	case 21: // STATE 67 - session.pml:269 - [what = HELLO] (0:185:8 - 12)
		IfNotBlocked
		reached[1][67] = 1;
		(trpt+1)->bup.ovals = grab_ints(8);
		(trpt+1)->bup.ovals[0] = ((P1 *)_this)->what;
		((P1 *)_this)->what = 9;
#ifdef VAR_RANGES
		logval("host:what", ((P1 *)_this)->what);
#endif
		;
		if (TstOnly) return 1; /* TT */
		/* dead 2: what */  
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P1 *)_this)->what = 0;
		/* merge: session = 0(185, 68, 185) */
		reached[1][68] = 1;
		(trpt+1)->bup.ovals[1] = ((int)((P1 *)_this)->session);
		((P1 *)_this)->session = 0;
#ifdef VAR_RANGES
		logval("host:session", ((int)((P1 *)_this)->session));
#endif
		;
		/* merge: nonce = 0(185, 69, 185) */
		reached[1][69] = 1;
		(trpt+1)->bup.ovals[2] = ((int)((P1 *)_this)->nonce);
		((P1 *)_this)->nonce = 0;
#ifdef VAR_RANGES
		logval("host:nonce", ((int)((P1 *)_this)->nonce));
#endif
		;
		/* merge: next = 0(185, 70, 185) */
		reached[1][70] = 1;
		(trpt+1)->bup.ovals[3] = ((int)((P1 *)_this)->next);
		((P1 *)_this)->next = 0;
#ifdef VAR_RANGES
		logval("host:next", ((int)((P1 *)_this)->next));
#endif
		;
		/* merge: state = 0(185, 71, 185) */
		reached[1][71] = 1;
		(trpt+1)->bup.ovals[4] = ((int)((P1 *)_this)->state);
		((P1 *)_this)->state = 0;
#ifdef VAR_RANGES
		logval("host:state", ((int)((P1 *)_this)->state));
#endif
		;
		/* merge: boot = 0(185, 72, 185) */
		reached[1][72] = 1;
		(trpt+1)->bup.ovals[5] = ((int)((P1 *)_this)->boot);
		((P1 *)_this)->boot = 0;
#ifdef VAR_RANGES
		logval("host:boot", ((int)((P1 *)_this)->boot));
#endif
		;
		/* merge: opened = 0(185, 73, 185) */
		reached[1][73] = 1;
		(trpt+1)->bup.ovals[6] = ((int)((P1 *)_this)->opened);
		((P1 *)_this)->opened = 0;
#ifdef VAR_RANGES
		logval("host:opened", ((int)((P1 *)_this)->opened));
#endif
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 3; goto P999; /* 7 */
	case 22: // STATE 75 - session.pml:271 - [((((h_phase==0)&&!(h_sent))&&nfull(to_machine)))] (86:0:1 - 1)
		IfNotBlocked
		reached[1][75] = 1;
		if (!((((((int)now.h_phase)==0)&& !(((int)now.h_sent)))&&(!q_full(now.to_machine)))))
			continue;
		/* merge: h_sent = 1(0, 76, 86) */
		reached[1][76] = 1;
		(trpt+1)->bup.oval = ((int)now.h_sent);
		now.h_sent = 1;
#ifdef VAR_RANGES
		logval("h_sent", ((int)now.h_sent));
#endif
		;
		_m = 3; goto P999; /* 1 */
	case 23: // STATE 77 - session.pml:86 - [to_machine!9,0,h_nonce,0] (185:0:0 - 1)
		IfNotBlocked
		reached[1][77] = 1;
		if (q_full(now.to_machine))
			continue;
#ifdef HAS_CODE
		if (readtrail && gui) {
			char simtmp[64];
			sprintf(simvals, "%d!", now.to_machine);
		sprintf(simtmp, "%d", 9); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", 0); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.h_nonce)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", 0); strcat(simvals, simtmp);		}
#endif
		
		qsend(now.to_machine, 0, 9, 0, ((int)now.h_nonce), 0, 0, 0, 4);
		/* merge: .(goto)(185, 85, 185) */
		reached[1][85] = 1;
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 2; goto P999; /* 2 */
	case 24: // STATE 85 - session.pml:90 - [.(goto)] (0:185:0 - 3)
		IfNotBlocked
		reached[1][85] = 1;
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 3; goto P999; /* 1 */
	case 25: // STATE 78 - session.pml:87 - [((faults>0))] (185:0:1 - 1)
		IfNotBlocked
		reached[1][78] = 1;
		if (!((((int)now.faults)>0)))
			continue;
		/* merge: faults = (faults-1)(185, 79, 185) */
		reached[1][79] = 1;
		(trpt+1)->bup.oval = ((int)now.faults);
		now.faults = (((int)now.faults)-1);
#ifdef VAR_RANGES
		logval("faults", ((int)now.faults));
#endif
		;
		/* merge: .(goto)(185, 85, 185) */
		reached[1][85] = 1;
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 3; goto P999; /* 3 */
	case 26: // STATE 80 - session.pml:88 - [(((faults>0)&&(len(to_machine)<(3-1))))] (82:0:1 - 1)
		IfNotBlocked
		reached[1][80] = 1;
		if (!(((((int)now.faults)>0)&&(q_len(now.to_machine)<(3-1)))))
			continue;
		/* merge: faults = (faults-1)(0, 81, 82) */
		reached[1][81] = 1;
		(trpt+1)->bup.oval = ((int)now.faults);
		now.faults = (((int)now.faults)-1);
#ifdef VAR_RANGES
		logval("faults", ((int)now.faults));
#endif
		;
		_m = 3; goto P999; /* 1 */
	case 27: // STATE 82 - session.pml:88 - [to_machine!9,0,h_nonce,0] (0:0:0 - 1)
		IfNotBlocked
		reached[1][82] = 1;
		if (q_full(now.to_machine))
			continue;
#ifdef HAS_CODE
		if (readtrail && gui) {
			char simtmp[64];
			sprintf(simvals, "%d!", now.to_machine);
		sprintf(simtmp, "%d", 9); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", 0); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.h_nonce)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", 0); strcat(simvals, simtmp);		}
#endif
		
		qsend(now.to_machine, 0, 9, 0, ((int)now.h_nonce), 0, 0, 0, 4);
		_m = 2; goto P999; /* 0 */
	case 28: // STATE 83 - session.pml:88 - [to_machine!9,0,h_nonce,0] (185:0:0 - 1)
		IfNotBlocked
		reached[1][83] = 1;
		if (q_full(now.to_machine))
			continue;
#ifdef HAS_CODE
		if (readtrail && gui) {
			char simtmp[64];
			sprintf(simvals, "%d!", now.to_machine);
		sprintf(simtmp, "%d", 9); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", 0); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.h_nonce)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", 0); strcat(simvals, simtmp);		}
#endif
		
		qsend(now.to_machine, 0, 9, 0, ((int)now.h_nonce), 0, 0, 0, 4);
		/* merge: .(goto)(185, 85, 185) */
		reached[1][85] = 1;
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 2; goto P999; /* 2 */
	case 29: // STATE 88 - session.pml:272 - [((((h_phase==1)&&!(h_sent))&&nfull(to_machine)))] (100:0:2 - 1)
		IfNotBlocked
		reached[1][88] = 1;
		if (!((((((int)now.h_phase)==1)&& !(((int)now.h_sent)))&&(!q_full(now.to_machine)))))
			continue;
		/* merge: h_sent = 1(100, 89, 100) */
		reached[1][89] = 1;
		(trpt+1)->bup.ovals = grab_ints(2);
		(trpt+1)->bup.ovals[0] = ((int)now.h_sent);
		now.h_sent = 1;
#ifdef VAR_RANGES
		logval("h_sent", ((int)now.h_sent));
#endif
		;
		/* merge: h_asked = 1(100, 90, 100) */
		reached[1][90] = 1;
		(trpt+1)->bup.ovals[1] = ((int)h_asked);
		h_asked = 1;
#ifdef VAR_RANGES
		logval("h_asked", ((int)h_asked));
#endif
		;
		_m = 3; goto P999; /* 2 */
	case 30: // STATE 91 - session.pml:86 - [to_machine!8,h_session,h_nonce,0] (185:0:0 - 1)
		IfNotBlocked
		reached[1][91] = 1;
		if (q_full(now.to_machine))
			continue;
#ifdef HAS_CODE
		if (readtrail && gui) {
			char simtmp[64];
			sprintf(simvals, "%d!", now.to_machine);
		sprintf(simtmp, "%d", 8); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.h_session)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.h_nonce)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", 0); strcat(simvals, simtmp);		}
#endif
		
		qsend(now.to_machine, 0, 8, ((int)now.h_session), ((int)now.h_nonce), 0, 0, 0, 4);
		/* merge: .(goto)(185, 99, 185) */
		reached[1][99] = 1;
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 2; goto P999; /* 2 */
	case 31: // STATE 99 - session.pml:90 - [.(goto)] (0:185:0 - 3)
		IfNotBlocked
		reached[1][99] = 1;
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 3; goto P999; /* 1 */
	case 32: // STATE 92 - session.pml:87 - [((faults>0))] (185:0:1 - 1)
		IfNotBlocked
		reached[1][92] = 1;
		if (!((((int)now.faults)>0)))
			continue;
		/* merge: faults = (faults-1)(185, 93, 185) */
		reached[1][93] = 1;
		(trpt+1)->bup.oval = ((int)now.faults);
		now.faults = (((int)now.faults)-1);
#ifdef VAR_RANGES
		logval("faults", ((int)now.faults));
#endif
		;
		/* merge: .(goto)(185, 99, 185) */
		reached[1][99] = 1;
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 3; goto P999; /* 3 */
	case 33: // STATE 94 - session.pml:88 - [(((faults>0)&&(len(to_machine)<(3-1))))] (96:0:1 - 1)
		IfNotBlocked
		reached[1][94] = 1;
		if (!(((((int)now.faults)>0)&&(q_len(now.to_machine)<(3-1)))))
			continue;
		/* merge: faults = (faults-1)(0, 95, 96) */
		reached[1][95] = 1;
		(trpt+1)->bup.oval = ((int)now.faults);
		now.faults = (((int)now.faults)-1);
#ifdef VAR_RANGES
		logval("faults", ((int)now.faults));
#endif
		;
		_m = 3; goto P999; /* 1 */
	case 34: // STATE 96 - session.pml:88 - [to_machine!8,h_session,h_nonce,0] (0:0:0 - 1)
		IfNotBlocked
		reached[1][96] = 1;
		if (q_full(now.to_machine))
			continue;
#ifdef HAS_CODE
		if (readtrail && gui) {
			char simtmp[64];
			sprintf(simvals, "%d!", now.to_machine);
		sprintf(simtmp, "%d", 8); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.h_session)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.h_nonce)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", 0); strcat(simvals, simtmp);		}
#endif
		
		qsend(now.to_machine, 0, 8, ((int)now.h_session), ((int)now.h_nonce), 0, 0, 0, 4);
		_m = 2; goto P999; /* 0 */
	case 35: // STATE 97 - session.pml:88 - [to_machine!8,h_session,h_nonce,0] (185:0:0 - 1)
		IfNotBlocked
		reached[1][97] = 1;
		if (q_full(now.to_machine))
			continue;
#ifdef HAS_CODE
		if (readtrail && gui) {
			char simtmp[64];
			sprintf(simvals, "%d!", now.to_machine);
		sprintf(simtmp, "%d", 8); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.h_session)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.h_nonce)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", 0); strcat(simvals, simtmp);		}
#endif
		
		qsend(now.to_machine, 0, 8, ((int)now.h_session), ((int)now.h_nonce), 0, 0, 0, 4);
		/* merge: .(goto)(185, 99, 185) */
		reached[1][99] = 1;
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 2; goto P999; /* 2 */
	case 36: // STATE 102 - session.pml:274 - [((((h_phase==3)&&!(h_sent))&&nfull(to_machine)))] (113:0:1 - 1)
		IfNotBlocked
		reached[1][102] = 1;
		if (!((((((int)now.h_phase)==3)&& !(((int)now.h_sent)))&&(!q_full(now.to_machine)))))
			continue;
		/* merge: h_sent = 1(0, 103, 113) */
		reached[1][103] = 1;
		(trpt+1)->bup.oval = ((int)now.h_sent);
		now.h_sent = 1;
#ifdef VAR_RANGES
		logval("h_sent", ((int)now.h_sent));
#endif
		;
		_m = 3; goto P999; /* 1 */
	case 37: // STATE 104 - session.pml:86 - [to_machine!4,h_session,0,0] (185:0:0 - 1)
		IfNotBlocked
		reached[1][104] = 1;
		if (q_full(now.to_machine))
			continue;
#ifdef HAS_CODE
		if (readtrail && gui) {
			char simtmp[64];
			sprintf(simvals, "%d!", now.to_machine);
		sprintf(simtmp, "%d", 4); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.h_session)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", 0); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", 0); strcat(simvals, simtmp);		}
#endif
		
		qsend(now.to_machine, 0, 4, ((int)now.h_session), 0, 0, 0, 0, 4);
		/* merge: .(goto)(185, 112, 185) */
		reached[1][112] = 1;
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 2; goto P999; /* 2 */
	case 38: // STATE 112 - session.pml:90 - [.(goto)] (0:185:0 - 3)
		IfNotBlocked
		reached[1][112] = 1;
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 3; goto P999; /* 1 */
	case 39: // STATE 105 - session.pml:87 - [((faults>0))] (185:0:1 - 1)
		IfNotBlocked
		reached[1][105] = 1;
		if (!((((int)now.faults)>0)))
			continue;
		/* merge: faults = (faults-1)(185, 106, 185) */
		reached[1][106] = 1;
		(trpt+1)->bup.oval = ((int)now.faults);
		now.faults = (((int)now.faults)-1);
#ifdef VAR_RANGES
		logval("faults", ((int)now.faults));
#endif
		;
		/* merge: .(goto)(185, 112, 185) */
		reached[1][112] = 1;
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 3; goto P999; /* 3 */
	case 40: // STATE 107 - session.pml:88 - [(((faults>0)&&(len(to_machine)<(3-1))))] (109:0:1 - 1)
		IfNotBlocked
		reached[1][107] = 1;
		if (!(((((int)now.faults)>0)&&(q_len(now.to_machine)<(3-1)))))
			continue;
		/* merge: faults = (faults-1)(0, 108, 109) */
		reached[1][108] = 1;
		(trpt+1)->bup.oval = ((int)now.faults);
		now.faults = (((int)now.faults)-1);
#ifdef VAR_RANGES
		logval("faults", ((int)now.faults));
#endif
		;
		_m = 3; goto P999; /* 1 */
	case 41: // STATE 109 - session.pml:88 - [to_machine!4,h_session,0,0] (0:0:0 - 1)
		IfNotBlocked
		reached[1][109] = 1;
		if (q_full(now.to_machine))
			continue;
#ifdef HAS_CODE
		if (readtrail && gui) {
			char simtmp[64];
			sprintf(simvals, "%d!", now.to_machine);
		sprintf(simtmp, "%d", 4); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.h_session)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", 0); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", 0); strcat(simvals, simtmp);		}
#endif
		
		qsend(now.to_machine, 0, 4, ((int)now.h_session), 0, 0, 0, 0, 4);
		_m = 2; goto P999; /* 0 */
	case 42: // STATE 110 - session.pml:88 - [to_machine!4,h_session,0,0] (185:0:0 - 1)
		IfNotBlocked
		reached[1][110] = 1;
		if (q_full(now.to_machine))
			continue;
#ifdef HAS_CODE
		if (readtrail && gui) {
			char simtmp[64];
			sprintf(simvals, "%d!", now.to_machine);
		sprintf(simtmp, "%d", 4); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.h_session)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", 0); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", 0); strcat(simvals, simtmp);		}
#endif
		
		qsend(now.to_machine, 0, 4, ((int)now.h_session), 0, 0, 0, 0, 4);
		/* merge: .(goto)(185, 112, 185) */
		reached[1][112] = 1;
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 2; goto P999; /* 2 */
	case 43: // STATE 115 - session.pml:275 - [((((((h_phase==2)&&(h_send<2))&&(h_send<h_limit))&&(h_send<(h_base+2)))&&nfull(to_machine)))] (0:0:0 - 1)
		IfNotBlocked
		reached[1][115] = 1;
		if (!((((((((int)now.h_phase)==2)&&(((int)now.h_send)<2))&&(((int)now.h_send)<((int)now.h_limit)))&&(((int)now.h_send)<(((int)now.h_base)+2)))&&(!q_full(now.to_machine)))))
			continue;
		_m = 3; goto P999; /* 0 */
	case 44: // STATE 116 - session.pml:86 - [to_machine!7,h_session,(h_send%4),h_send] (185:0:1 - 1)
		IfNotBlocked
		reached[1][116] = 1;
		if (q_full(now.to_machine))
			continue;
#ifdef HAS_CODE
		if (readtrail && gui) {
			char simtmp[64];
			sprintf(simvals, "%d!", now.to_machine);
		sprintf(simtmp, "%d", 7); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.h_session)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", (((int)now.h_send)%4)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.h_send)); strcat(simvals, simtmp);		}
#endif
		
		qsend(now.to_machine, 0, 7, ((int)now.h_session), (((int)now.h_send)%4), ((int)now.h_send), 0, 0, 4);
		/* merge: .(goto)(185, 124, 185) */
		reached[1][124] = 1;
		;
		/* merge: h_send = (h_send+1)(185, 126, 185) */
		reached[1][126] = 1;
		(trpt+1)->bup.oval = ((int)now.h_send);
		now.h_send = (((int)now.h_send)+1);
#ifdef VAR_RANGES
		logval("h_send", ((int)now.h_send));
#endif
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 2; goto P999; /* 3 */
	case 45: // STATE 124 - session.pml:90 - [.(goto)] (0:185:1 - 3)
		IfNotBlocked
		reached[1][124] = 1;
		;
		/* merge: h_send = (h_send+1)(185, 126, 185) */
		reached[1][126] = 1;
		(trpt+1)->bup.oval = ((int)now.h_send);
		now.h_send = (((int)now.h_send)+1);
#ifdef VAR_RANGES
		logval("h_send", ((int)now.h_send));
#endif
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 3; goto P999; /* 2 */
	case 46: // STATE 117 - session.pml:87 - [((faults>0))] (185:0:2 - 1)
		IfNotBlocked
		reached[1][117] = 1;
		if (!((((int)now.faults)>0)))
			continue;
		/* merge: faults = (faults-1)(185, 118, 185) */
		reached[1][118] = 1;
		(trpt+1)->bup.ovals = grab_ints(2);
		(trpt+1)->bup.ovals[0] = ((int)now.faults);
		now.faults = (((int)now.faults)-1);
#ifdef VAR_RANGES
		logval("faults", ((int)now.faults));
#endif
		;
		/* merge: .(goto)(185, 124, 185) */
		reached[1][124] = 1;
		;
		/* merge: h_send = (h_send+1)(185, 126, 185) */
		reached[1][126] = 1;
		(trpt+1)->bup.ovals[1] = ((int)now.h_send);
		now.h_send = (((int)now.h_send)+1);
#ifdef VAR_RANGES
		logval("h_send", ((int)now.h_send));
#endif
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 3; goto P999; /* 4 */
	case 47: // STATE 119 - session.pml:88 - [(((faults>0)&&(len(to_machine)<(3-1))))] (121:0:1 - 1)
		IfNotBlocked
		reached[1][119] = 1;
		if (!(((((int)now.faults)>0)&&(q_len(now.to_machine)<(3-1)))))
			continue;
		/* merge: faults = (faults-1)(0, 120, 121) */
		reached[1][120] = 1;
		(trpt+1)->bup.oval = ((int)now.faults);
		now.faults = (((int)now.faults)-1);
#ifdef VAR_RANGES
		logval("faults", ((int)now.faults));
#endif
		;
		_m = 3; goto P999; /* 1 */
	case 48: // STATE 121 - session.pml:88 - [to_machine!7,h_session,(h_send%4),h_send] (0:0:0 - 1)
		IfNotBlocked
		reached[1][121] = 1;
		if (q_full(now.to_machine))
			continue;
#ifdef HAS_CODE
		if (readtrail && gui) {
			char simtmp[64];
			sprintf(simvals, "%d!", now.to_machine);
		sprintf(simtmp, "%d", 7); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.h_session)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", (((int)now.h_send)%4)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.h_send)); strcat(simvals, simtmp);		}
#endif
		
		qsend(now.to_machine, 0, 7, ((int)now.h_session), (((int)now.h_send)%4), ((int)now.h_send), 0, 0, 4);
		_m = 2; goto P999; /* 0 */
	case 49: // STATE 122 - session.pml:88 - [to_machine!7,h_session,(h_send%4),h_send] (185:0:1 - 1)
		IfNotBlocked
		reached[1][122] = 1;
		if (q_full(now.to_machine))
			continue;
#ifdef HAS_CODE
		if (readtrail && gui) {
			char simtmp[64];
			sprintf(simvals, "%d!", now.to_machine);
		sprintf(simtmp, "%d", 7); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.h_session)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", (((int)now.h_send)%4)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.h_send)); strcat(simvals, simtmp);		}
#endif
		
		qsend(now.to_machine, 0, 7, ((int)now.h_session), (((int)now.h_send)%4), ((int)now.h_send), 0, 0, 4);
		/* merge: .(goto)(185, 124, 185) */
		reached[1][124] = 1;
		;
		/* merge: h_send = (h_send+1)(185, 126, 185) */
		reached[1][126] = 1;
		(trpt+1)->bup.oval = ((int)now.h_send);
		now.h_send = (((int)now.h_send)+1);
#ifdef VAR_RANGES
		logval("h_send", ((int)now.h_send));
#endif
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 2; goto P999; /* 3 */
	case 50: // STATE 128 - session.pml:277 - [((((((h_phase==2)&&(h_send==2))&&(h_base==2))&&!(h_end_sent))&&nfull(to_machine)))] (139:0:1 - 1)
		IfNotBlocked
		reached[1][128] = 1;
		if (!((((((((int)now.h_phase)==2)&&(((int)now.h_send)==2))&&(((int)now.h_base)==2))&& !(((int)now.h_end_sent)))&&(!q_full(now.to_machine)))))
			continue;
		/* merge: h_end_sent = 1(0, 129, 139) */
		reached[1][129] = 1;
		(trpt+1)->bup.oval = ((int)now.h_end_sent);
		now.h_end_sent = 1;
#ifdef VAR_RANGES
		logval("h_end_sent", ((int)now.h_end_sent));
#endif
		;
		_m = 3; goto P999; /* 1 */
	case 51: // STATE 130 - session.pml:86 - [to_machine!6,h_session,2,0] (185:0:0 - 1)
		IfNotBlocked
		reached[1][130] = 1;
		if (q_full(now.to_machine))
			continue;
#ifdef HAS_CODE
		if (readtrail && gui) {
			char simtmp[64];
			sprintf(simvals, "%d!", now.to_machine);
		sprintf(simtmp, "%d", 6); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.h_session)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", 2); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", 0); strcat(simvals, simtmp);		}
#endif
		
		qsend(now.to_machine, 0, 6, ((int)now.h_session), 2, 0, 0, 0, 4);
		/* merge: .(goto)(185, 138, 185) */
		reached[1][138] = 1;
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 2; goto P999; /* 2 */
	case 52: // STATE 138 - session.pml:90 - [.(goto)] (0:185:0 - 3)
		IfNotBlocked
		reached[1][138] = 1;
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 3; goto P999; /* 1 */
	case 53: // STATE 131 - session.pml:87 - [((faults>0))] (185:0:1 - 1)
		IfNotBlocked
		reached[1][131] = 1;
		if (!((((int)now.faults)>0)))
			continue;
		/* merge: faults = (faults-1)(185, 132, 185) */
		reached[1][132] = 1;
		(trpt+1)->bup.oval = ((int)now.faults);
		now.faults = (((int)now.faults)-1);
#ifdef VAR_RANGES
		logval("faults", ((int)now.faults));
#endif
		;
		/* merge: .(goto)(185, 138, 185) */
		reached[1][138] = 1;
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 3; goto P999; /* 3 */
	case 54: // STATE 133 - session.pml:88 - [(((faults>0)&&(len(to_machine)<(3-1))))] (135:0:1 - 1)
		IfNotBlocked
		reached[1][133] = 1;
		if (!(((((int)now.faults)>0)&&(q_len(now.to_machine)<(3-1)))))
			continue;
		/* merge: faults = (faults-1)(0, 134, 135) */
		reached[1][134] = 1;
		(trpt+1)->bup.oval = ((int)now.faults);
		now.faults = (((int)now.faults)-1);
#ifdef VAR_RANGES
		logval("faults", ((int)now.faults));
#endif
		;
		_m = 3; goto P999; /* 1 */
	case 55: // STATE 135 - session.pml:88 - [to_machine!6,h_session,2,0] (0:0:0 - 1)
		IfNotBlocked
		reached[1][135] = 1;
		if (q_full(now.to_machine))
			continue;
#ifdef HAS_CODE
		if (readtrail && gui) {
			char simtmp[64];
			sprintf(simvals, "%d!", now.to_machine);
		sprintf(simtmp, "%d", 6); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.h_session)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", 2); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", 0); strcat(simvals, simtmp);		}
#endif
		
		qsend(now.to_machine, 0, 6, ((int)now.h_session), 2, 0, 0, 0, 4);
		_m = 2; goto P999; /* 0 */
	case 56: // STATE 136 - session.pml:88 - [to_machine!6,h_session,2,0] (185:0:0 - 1)
		IfNotBlocked
		reached[1][136] = 1;
		if (q_full(now.to_machine))
			continue;
#ifdef HAS_CODE
		if (readtrail && gui) {
			char simtmp[64];
			sprintf(simvals, "%d!", now.to_machine);
		sprintf(simtmp, "%d", 6); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.h_session)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", 2); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", 0); strcat(simvals, simtmp);		}
#endif
		
		qsend(now.to_machine, 0, 6, ((int)now.h_session), 2, 0, 0, 0, 4);
		/* merge: .(goto)(185, 138, 185) */
		reached[1][138] = 1;
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 2; goto P999; /* 2 */
	case 57: // STATE 141 - session.pml:281 - [((((timeout&&!(((h_phase==4)||(h_phase==5))))&&(((h_phase==0)||(h_phase==1))||(h_phase==3)))&&h_sent))] (185:0:1 - 1)
		IfNotBlocked
		reached[1][141] = 1;
		if (!((((((trpt->tau)&1)&& !(((((int)now.h_phase)==4)||(((int)now.h_phase)==5))))&&(((((int)now.h_phase)==0)||(((int)now.h_phase)==1))||(((int)now.h_phase)==3)))&&((int)now.h_sent))))
			continue;
		/* merge: h_sent = 0(0, 142, 185) */
		reached[1][142] = 1;
		(trpt+1)->bup.oval = ((int)now.h_sent);
		now.h_sent = 0;
#ifdef VAR_RANGES
		logval("h_sent", ((int)now.h_sent));
#endif
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 1; goto P999; /* 2 */
	case 58: // STATE 144 - session.pml:282 - [(((timeout&&(h_phase==2))&&nfull(to_machine)))] (156:0:2 - 1)
		IfNotBlocked
		reached[1][144] = 1;
		if (!(((((trpt->tau)&1)&&(((int)now.h_phase)==2))&&(!q_full(now.to_machine)))))
			continue;
		/* merge: h_send = h_base(156, 145, 156) */
		reached[1][145] = 1;
		(trpt+1)->bup.ovals = grab_ints(2);
		(trpt+1)->bup.ovals[0] = ((int)now.h_send);
		now.h_send = ((int)now.h_base);
#ifdef VAR_RANGES
		logval("h_send", ((int)now.h_send));
#endif
		;
		/* merge: h_end_sent = 0(156, 146, 156) */
		reached[1][146] = 1;
		(trpt+1)->bup.ovals[1] = ((int)now.h_end_sent);
		now.h_end_sent = 0;
#ifdef VAR_RANGES
		logval("h_end_sent", ((int)now.h_end_sent));
#endif
		;
		_m = 1; goto P999; /* 2 */
	case 59: // STATE 147 - session.pml:86 - [to_machine!5,h_session,0,0] (185:0:0 - 1)
		IfNotBlocked
		reached[1][147] = 1;
		if (q_full(now.to_machine))
			continue;
#ifdef HAS_CODE
		if (readtrail && gui) {
			char simtmp[64];
			sprintf(simvals, "%d!", now.to_machine);
		sprintf(simtmp, "%d", 5); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.h_session)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", 0); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", 0); strcat(simvals, simtmp);		}
#endif
		
		qsend(now.to_machine, 0, 5, ((int)now.h_session), 0, 0, 0, 0, 4);
		/* merge: .(goto)(185, 155, 185) */
		reached[1][155] = 1;
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 2; goto P999; /* 2 */
	case 60: // STATE 155 - session.pml:90 - [.(goto)] (0:185:0 - 3)
		IfNotBlocked
		reached[1][155] = 1;
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 3; goto P999; /* 1 */
	case 61: // STATE 148 - session.pml:87 - [((faults>0))] (185:0:1 - 1)
		IfNotBlocked
		reached[1][148] = 1;
		if (!((((int)now.faults)>0)))
			continue;
		/* merge: faults = (faults-1)(185, 149, 185) */
		reached[1][149] = 1;
		(trpt+1)->bup.oval = ((int)now.faults);
		now.faults = (((int)now.faults)-1);
#ifdef VAR_RANGES
		logval("faults", ((int)now.faults));
#endif
		;
		/* merge: .(goto)(185, 155, 185) */
		reached[1][155] = 1;
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 3; goto P999; /* 3 */
	case 62: // STATE 150 - session.pml:88 - [(((faults>0)&&(len(to_machine)<(3-1))))] (152:0:1 - 1)
		IfNotBlocked
		reached[1][150] = 1;
		if (!(((((int)now.faults)>0)&&(q_len(now.to_machine)<(3-1)))))
			continue;
		/* merge: faults = (faults-1)(0, 151, 152) */
		reached[1][151] = 1;
		(trpt+1)->bup.oval = ((int)now.faults);
		now.faults = (((int)now.faults)-1);
#ifdef VAR_RANGES
		logval("faults", ((int)now.faults));
#endif
		;
		_m = 3; goto P999; /* 1 */
	case 63: // STATE 152 - session.pml:88 - [to_machine!5,h_session,0,0] (0:0:0 - 1)
		IfNotBlocked
		reached[1][152] = 1;
		if (q_full(now.to_machine))
			continue;
#ifdef HAS_CODE
		if (readtrail && gui) {
			char simtmp[64];
			sprintf(simvals, "%d!", now.to_machine);
		sprintf(simtmp, "%d", 5); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.h_session)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", 0); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", 0); strcat(simvals, simtmp);		}
#endif
		
		qsend(now.to_machine, 0, 5, ((int)now.h_session), 0, 0, 0, 0, 4);
		_m = 2; goto P999; /* 0 */
	case 64: // STATE 153 - session.pml:88 - [to_machine!5,h_session,0,0] (185:0:0 - 1)
		IfNotBlocked
		reached[1][153] = 1;
		if (q_full(now.to_machine))
			continue;
#ifdef HAS_CODE
		if (readtrail && gui) {
			char simtmp[64];
			sprintf(simvals, "%d!", now.to_machine);
		sprintf(simtmp, "%d", 5); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.h_session)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", 0); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", 0); strcat(simvals, simtmp);		}
#endif
		
		qsend(now.to_machine, 0, 5, ((int)now.h_session), 0, 0, 0, 0, 4);
		/* merge: .(goto)(185, 155, 185) */
		reached[1][155] = 1;
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 2; goto P999; /* 2 */
	case 65: // STATE 158 - session.pml:284 - [(((timeout&&((h_phase==1)||(h_phase==2)))&&(nonces<6)))] (0:0:0 - 1)
		IfNotBlocked
		reached[1][158] = 1;
		if (!(((((trpt->tau)&1)&&((((int)now.h_phase)==1)||(((int)now.h_phase)==2)))&&(((int)now.nonces)<6))))
			continue;
		_m = 1; goto P999; /* 0 */
	case 66: // STATE 159 - session.pml:237 - [h_phase = 0] (0:185:6 - 1)
		IfNotBlocked
		reached[1][159] = 1;
		(trpt+1)->bup.ovals = grab_ints(6);
		(trpt+1)->bup.ovals[0] = ((int)now.h_phase);
		now.h_phase = 0;
#ifdef VAR_RANGES
		logval("h_phase", ((int)now.h_phase));
#endif
		;
		/* merge: h_session = 0(185, 160, 185) */
		reached[1][160] = 1;
		(trpt+1)->bup.ovals[1] = ((int)now.h_session);
		now.h_session = 0;
#ifdef VAR_RANGES
		logval("h_session", ((int)now.h_session));
#endif
		;
		/* merge: h_sent = 0(185, 161, 185) */
		reached[1][161] = 1;
		(trpt+1)->bup.ovals[2] = ((int)now.h_sent);
		now.h_sent = 0;
#ifdef VAR_RANGES
		logval("h_sent", ((int)now.h_sent));
#endif
		;
		/* merge: h_end_sent = 0(185, 162, 185) */
		reached[1][162] = 1;
		(trpt+1)->bup.ovals[3] = ((int)now.h_end_sent);
		now.h_end_sent = 0;
#ifdef VAR_RANGES
		logval("h_end_sent", ((int)now.h_end_sent));
#endif
		;
		/* merge: nonces = (nonces+1)(185, 163, 185) */
		reached[1][163] = 1;
		(trpt+1)->bup.ovals[4] = ((int)now.nonces);
		now.nonces = (((int)now.nonces)+1);
#ifdef VAR_RANGES
		logval("nonces", ((int)now.nonces));
#endif
		;
		/* merge: h_nonce = nonces(185, 164, 185) */
		reached[1][164] = 1;
		(trpt+1)->bup.ovals[5] = ((int)now.h_nonce);
		now.h_nonce = ((int)now.nonces);
#ifdef VAR_RANGES
		logval("h_nonce", ((int)now.h_nonce));
#endif
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 3; goto P999; /* 6 */
	case 67: // STATE 167 - session.pml:287 - [((((deaths>0)&&(h_phase<3))&&!(distrusted)))] (181:0:7 - 1)
		IfNotBlocked
		reached[1][167] = 1;
		if (!((((((int)now.deaths)>0)&&(((int)now.h_phase)<3))&& !(((int)now.distrusted)))))
			continue;
		/* merge: deaths = (deaths-1)(181, 168, 181) */
		reached[1][168] = 1;
		(trpt+1)->bup.ovals = grab_ints(7);
		(trpt+1)->bup.ovals[0] = ((int)now.deaths);
		now.deaths = (((int)now.deaths)-1);
#ifdef VAR_RANGES
		logval("deaths", ((int)now.deaths));
#endif
		;
		/* merge: h_opened = 0(181, 169, 181) */
		reached[1][169] = 1;
		(trpt+1)->bup.ovals[1] = ((int)now.h_opened);
		now.h_opened = 0;
#ifdef VAR_RANGES
		logval("h_opened", ((int)now.h_opened));
#endif
		;
		/* merge: h_asked = 0(181, 170, 181) */
		reached[1][170] = 1;
		(trpt+1)->bup.ovals[2] = ((int)h_asked);
		h_asked = 0;
#ifdef VAR_RANGES
		logval("h_asked", ((int)h_asked));
#endif
		;
		/* merge: h_base = 0(181, 171, 181) */
		reached[1][171] = 1;
		(trpt+1)->bup.ovals[3] = ((int)now.h_base);
		now.h_base = 0;
#ifdef VAR_RANGES
		logval("h_base", ((int)now.h_base));
#endif
		;
		/* merge: h_send = 0(181, 172, 181) */
		reached[1][172] = 1;
		(trpt+1)->bup.ovals[4] = ((int)now.h_send);
		now.h_send = 0;
#ifdef VAR_RANGES
		logval("h_send", ((int)now.h_send));
#endif
		;
		/* merge: h_limit = 0(181, 173, 181) */
		reached[1][173] = 1;
		(trpt+1)->bup.ovals[5] = ((int)now.h_limit);
		now.h_limit = 0;
#ifdef VAR_RANGES
		logval("h_limit", ((int)now.h_limit));
#endif
		;
		/* merge: h_boot = 0(181, 174, 181) */
		reached[1][174] = 1;
		(trpt+1)->bup.ovals[6] = ((int)now.h_boot);
		now.h_boot = 0;
#ifdef VAR_RANGES
		logval("h_boot", ((int)now.h_boot));
#endif
		;
		_m = 3; goto P999; /* 7 */
	case 68: // STATE 175 - session.pml:237 - [h_phase = 0] (0:185:6 - 1)
		IfNotBlocked
		reached[1][175] = 1;
		(trpt+1)->bup.ovals = grab_ints(6);
		(trpt+1)->bup.ovals[0] = ((int)now.h_phase);
		now.h_phase = 0;
#ifdef VAR_RANGES
		logval("h_phase", ((int)now.h_phase));
#endif
		;
		/* merge: h_session = 0(185, 176, 185) */
		reached[1][176] = 1;
		(trpt+1)->bup.ovals[1] = ((int)now.h_session);
		now.h_session = 0;
#ifdef VAR_RANGES
		logval("h_session", ((int)now.h_session));
#endif
		;
		/* merge: h_sent = 0(185, 177, 185) */
		reached[1][177] = 1;
		(trpt+1)->bup.ovals[2] = ((int)now.h_sent);
		now.h_sent = 0;
#ifdef VAR_RANGES
		logval("h_sent", ((int)now.h_sent));
#endif
		;
		/* merge: h_end_sent = 0(185, 178, 185) */
		reached[1][178] = 1;
		(trpt+1)->bup.ovals[3] = ((int)now.h_end_sent);
		now.h_end_sent = 0;
#ifdef VAR_RANGES
		logval("h_end_sent", ((int)now.h_end_sent));
#endif
		;
		/* merge: nonces = (nonces+1)(185, 179, 185) */
		reached[1][179] = 1;
		(trpt+1)->bup.ovals[4] = ((int)now.nonces);
		now.nonces = (((int)now.nonces)+1);
#ifdef VAR_RANGES
		logval("nonces", ((int)now.nonces));
#endif
		;
		/* merge: h_nonce = nonces(185, 180, 185) */
		reached[1][180] = 1;
		(trpt+1)->bup.ovals[5] = ((int)now.h_nonce);
		now.h_nonce = ((int)now.nonces);
#ifdef VAR_RANGES
		logval("h_nonce", ((int)now.h_nonce));
#endif
		;
		/* merge: .(goto)(0, 186, 185) */
		reached[1][186] = 1;
		;
		_m = 3; goto P999; /* 6 */
	case 69: // STATE 183 - session.pml:289 - [(((h_phase==4)||(h_phase==5)))] (0:0:0 - 1)
		IfNotBlocked
		reached[1][183] = 1;
		if (!(((((int)now.h_phase)==4)||(((int)now.h_phase)==5))))
			continue;
		_m = 3; goto P999; /* 0 */
	case 70: // STATE 188 - session.pml:291 - [-end-] (0:0:0 - 3)
		IfNotBlocked
		reached[1][188] = 1;
		if (!delproc(1, II)) continue;
		_m = 3; goto P999; /* 0 */

		 /* PROC machine */
	case 71: // STATE 1 - session.pml:154 - [to_machine?what,session,number,item] (0:0:4 - 1)
		reached[0][1] = 1;
		if (q_len(now.to_machine) == 0) continue;

		XX=1;
		(trpt+1)->bup.ovals = grab_ints(4);
		(trpt+1)->bup.ovals[0] = ((P0 *)_this)->what;
		(trpt+1)->bup.ovals[1] = ((int)((P0 *)_this)->session);
		(trpt+1)->bup.ovals[2] = ((int)((P0 *)_this)->number);
		(trpt+1)->bup.ovals[3] = ((int)((P0 *)_this)->item);
		;
		((P0 *)_this)->what = qrecv(now.to_machine, XX-1, 0, 0);
#ifdef VAR_RANGES
		logval("machine:what", ((P0 *)_this)->what);
#endif
		;
		((P0 *)_this)->session = qrecv(now.to_machine, XX-1, 1, 0);
#ifdef VAR_RANGES
		logval("machine:session", ((int)((P0 *)_this)->session));
#endif
		;
		((P0 *)_this)->number = qrecv(now.to_machine, XX-1, 2, 0);
#ifdef VAR_RANGES
		logval("machine:number", ((int)((P0 *)_this)->number));
#endif
		;
		((P0 *)_this)->item = qrecv(now.to_machine, XX-1, 3, 1);
#ifdef VAR_RANGES
		logval("machine:item", ((int)((P0 *)_this)->item));
#endif
		;
		
#ifdef HAS_CODE
		if (readtrail && gui) {
			char simtmp[32];
			sprintf(simvals, "%d?", now.to_machine);
		sprintf(simtmp, "%d", ((P0 *)_this)->what); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)((P0 *)_this)->session)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)((P0 *)_this)->number)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)((P0 *)_this)->item)); strcat(simvals, simtmp);		}
#endif
		;
		_m = 4; goto P999; /* 0 */
	case 72: // STATE 2 - session.pml:156 - [((what==HELLO))] (0:0:1 - 1)
		IfNotBlocked
		reached[0][2] = 1;
		if (!((((P0 *)_this)->what==9)))
			continue;
		if (TstOnly) return 1; /* TT */
		/* dead 1: what */  (trpt+1)->bup.oval = ((P0 *)_this)->what;
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P0 *)_this)->what = 0;
		_m = 3; goto P999; /* 0 */
	case 73: // STATE 3 - session.pml:106 - [(((m_session==0)||(number!=m_nonce)))] (153:0:11 - 1)
		IfNotBlocked
		reached[0][3] = 1;
		if (!(((((int)now.m_session)==0)||(((int)((P0 *)_this)->number)!=((int)now.m_nonce)))))
			continue;
		/* merge: m_sessions = (m_sessions+1)(153, 4, 153) */
		reached[0][4] = 1;
		(trpt+1)->bup.ovals = grab_ints(11);
		(trpt+1)->bup.ovals[0] = ((int)now.m_sessions);
		now.m_sessions = (((int)now.m_sessions)+1);
#ifdef VAR_RANGES
		logval("m_sessions", ((int)now.m_sessions));
#endif
		;
		/* merge: m_session = m_sessions(153, 5, 153) */
		reached[0][5] = 1;
		(trpt+1)->bup.ovals[1] = ((int)now.m_session);
		now.m_session = ((int)now.m_sessions);
#ifdef VAR_RANGES
		logval("m_session", ((int)now.m_session));
#endif
		;
		/* merge: m_opened = (m_state==1)(153, 6, 153) */
		reached[0][6] = 1;
		(trpt+1)->bup.ovals[2] = ((int)now.m_opened);
		now.m_opened = (((int)now.m_state)==1);
#ifdef VAR_RANGES
		logval("m_opened", ((int)now.m_opened));
#endif
		;
		/* merge: .(goto)(153, 9, 153) */
		reached[0][9] = 1;
		;
		/* merge: m_nonce = number(153, 10, 153) */
		reached[0][10] = 1;
		(trpt+1)->bup.ovals[3] = ((int)now.m_nonce);
		now.m_nonce = ((int)((P0 *)_this)->number);
#ifdef VAR_RANGES
		logval("m_nonce", ((int)now.m_nonce));
#endif
		;
		/* merge: due_welcome = 1(153, 11, 153) */
		reached[0][11] = 1;
		(trpt+1)->bup.ovals[4] = ((int)now.due_welcome);
		now.due_welcome = 1;
#ifdef VAR_RANGES
		logval("due_welcome", ((int)now.due_welcome));
#endif
		;
		/* merge: due_ack = 0(153, 12, 153) */
		reached[0][12] = 1;
		(trpt+1)->bup.ovals[5] = ((int)now.due_ack);
		now.due_ack = 0;
#ifdef VAR_RANGES
		logval("due_ack", ((int)now.due_ack));
#endif
		;
		/* merge: .(goto)(153, 69, 153) */
		reached[0][69] = 1;
		;
		/* merge: what = HELLO(153, 70, 153) */
		reached[0][70] = 1;
		(trpt+1)->bup.ovals[6] = ((P0 *)_this)->what;
		((P0 *)_this)->what = 9;
#ifdef VAR_RANGES
		logval("machine:what", ((P0 *)_this)->what);
#endif
		;
		if (TstOnly) return 1; /* TT */
		/* dead 2: what */  
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P0 *)_this)->what = 0;
		/* merge: session = 0(153, 71, 153) */
		reached[0][71] = 1;
		(trpt+1)->bup.ovals[7] = ((int)((P0 *)_this)->session);
		((P0 *)_this)->session = 0;
#ifdef VAR_RANGES
		logval("machine:session", ((int)((P0 *)_this)->session));
#endif
		;
		/* merge: number = 0(153, 72, 153) */
		reached[0][72] = 1;
		(trpt+1)->bup.ovals[8] = ((int)((P0 *)_this)->number);
		((P0 *)_this)->number = 0;
#ifdef VAR_RANGES
		logval("machine:number", ((int)((P0 *)_this)->number));
#endif
		;
		/* merge: item = 0(153, 73, 153) */
		reached[0][73] = 1;
		(trpt+1)->bup.ovals[9] = ((int)((P0 *)_this)->item);
		((P0 *)_this)->item = 0;
#ifdef VAR_RANGES
		logval("machine:item", ((int)((P0 *)_this)->item));
#endif
		;
		/* merge: .(goto)(0, 154, 153) */
		reached[0][154] = 1;
		;
		_m = 3; goto P999; /* 13 */
	case 74: // STATE 10 - session.pml:112 - [m_nonce = number] (0:153:8 - 3)
		IfNotBlocked
		reached[0][10] = 1;
		(trpt+1)->bup.ovals = grab_ints(8);
		(trpt+1)->bup.ovals[0] = ((int)now.m_nonce);
		now.m_nonce = ((int)((P0 *)_this)->number);
#ifdef VAR_RANGES
		logval("m_nonce", ((int)now.m_nonce));
#endif
		;
		/* merge: due_welcome = 1(153, 11, 153) */
		reached[0][11] = 1;
		(trpt+1)->bup.ovals[1] = ((int)now.due_welcome);
		now.due_welcome = 1;
#ifdef VAR_RANGES
		logval("due_welcome", ((int)now.due_welcome));
#endif
		;
		/* merge: due_ack = 0(153, 12, 153) */
		reached[0][12] = 1;
		(trpt+1)->bup.ovals[2] = ((int)now.due_ack);
		now.due_ack = 0;
#ifdef VAR_RANGES
		logval("due_ack", ((int)now.due_ack));
#endif
		;
		/* merge: .(goto)(153, 69, 153) */
		reached[0][69] = 1;
		;
		/* merge: what = HELLO(153, 70, 153) */
		reached[0][70] = 1;
		(trpt+1)->bup.ovals[3] = ((P0 *)_this)->what;
		((P0 *)_this)->what = 9;
#ifdef VAR_RANGES
		logval("machine:what", ((P0 *)_this)->what);
#endif
		;
		if (TstOnly) return 1; /* TT */
		/* dead 2: what */  
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P0 *)_this)->what = 0;
		/* merge: session = 0(153, 71, 153) */
		reached[0][71] = 1;
		(trpt+1)->bup.ovals[4] = ((int)((P0 *)_this)->session);
		((P0 *)_this)->session = 0;
#ifdef VAR_RANGES
		logval("machine:session", ((int)((P0 *)_this)->session));
#endif
		;
		/* merge: number = 0(153, 72, 153) */
		reached[0][72] = 1;
		(trpt+1)->bup.ovals[5] = ((int)((P0 *)_this)->number);
		((P0 *)_this)->number = 0;
#ifdef VAR_RANGES
		logval("machine:number", ((int)((P0 *)_this)->number));
#endif
		;
		/* merge: item = 0(153, 73, 153) */
		reached[0][73] = 1;
		(trpt+1)->bup.ovals[6] = ((int)((P0 *)_this)->item);
		((P0 *)_this)->item = 0;
#ifdef VAR_RANGES
		logval("machine:item", ((int)((P0 *)_this)->item));
#endif
		;
		/* merge: .(goto)(0, 154, 153) */
		reached[0][154] = 1;
		;
		_m = 3; goto P999; /* 8 */
	case 75: // STATE 14 - session.pml:157 - [((((what!=HELLO)&&(m_session!=0))&&((session==m_session)||((0==1)&&(what==ITEM)))))] (0:0:1 - 1)
		IfNotBlocked
		reached[0][14] = 1;
		if (!((((((P0 *)_this)->what!=9)&&(((int)now.m_session)!=0))&&((((int)((P0 *)_this)->session)==((int)now.m_session))||((0==1)&&(((P0 *)_this)->what==7))))))
			continue;
		if (TstOnly) return 1; /* TT */
		/* dead 1: session */  (trpt+1)->bup.oval = ((P0 *)_this)->session;
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P0 *)_this)->session = 0;
		_m = 3; goto P999; /* 0 */
	case 76: // STATE 15 - session.pml:159 - [((what==JOB))] (0:0:1 - 1)
		IfNotBlocked
		reached[0][15] = 1;
		if (!((((P0 *)_this)->what==8)))
			continue;
		if (TstOnly) return 1; /* TT */
		/* dead 1: what */  (trpt+1)->bup.oval = ((P0 *)_this)->what;
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P0 *)_this)->what = 0;
		_m = 3; goto P999; /* 0 */
	case 77: // STATE 16 - session.pml:120 - [((number!=m_nonce))] (153:0:6 - 1)
		IfNotBlocked
		reached[0][16] = 1;
		if (!((((int)((P0 *)_this)->number)!=((int)now.m_nonce))))
			continue;
		if (TstOnly) return 1; /* TT */
		/* dead 1: number */  (trpt+1)->bup.ovals = grab_ints(6);
		(trpt+1)->bup.ovals[0] = ((P0 *)_this)->number;
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P0 *)_this)->number = 0;
		/* merge: .(goto)(153, 30, 153) */
		reached[0][30] = 1;
		;
		/* merge: .(goto)(153, 66, 153) */
		reached[0][66] = 1;
		;
		/* merge: .(goto)(153, 69, 153) */
		reached[0][69] = 1;
		;
		/* merge: what = HELLO(153, 70, 153) */
		reached[0][70] = 1;
		(trpt+1)->bup.ovals[1] = ((P0 *)_this)->what;
		((P0 *)_this)->what = 9;
#ifdef VAR_RANGES
		logval("machine:what", ((P0 *)_this)->what);
#endif
		;
		if (TstOnly) return 1; /* TT */
		/* dead 2: what */  
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P0 *)_this)->what = 0;
		/* merge: session = 0(153, 71, 153) */
		reached[0][71] = 1;
		(trpt+1)->bup.ovals[2] = ((int)((P0 *)_this)->session);
		((P0 *)_this)->session = 0;
#ifdef VAR_RANGES
		logval("machine:session", ((int)((P0 *)_this)->session));
#endif
		;
		/* merge: number = 0(153, 72, 153) */
		reached[0][72] = 1;
		(trpt+1)->bup.ovals[3] = ((int)((P0 *)_this)->number);
		((P0 *)_this)->number = 0;
#ifdef VAR_RANGES
		logval("machine:number", ((int)((P0 *)_this)->number));
#endif
		;
		/* merge: item = 0(153, 73, 153) */
		reached[0][73] = 1;
		(trpt+1)->bup.ovals[4] = ((int)((P0 *)_this)->item);
		((P0 *)_this)->item = 0;
#ifdef VAR_RANGES
		logval("machine:item", ((int)((P0 *)_this)->item));
#endif
		;
		/* merge: .(goto)(0, 154, 153) */
		reached[0][154] = 1;
		;
		_m = 3; goto P999; /* 8 */
	case 78: // STATE 17 - session.pml:121 - [(((number==m_nonce)&&(m_opened||(m_state==2))))] (153:0:7 - 1)
		IfNotBlocked
		reached[0][17] = 1;
		if (!(((((int)((P0 *)_this)->number)==((int)now.m_nonce))&&(((int)now.m_opened)||(((int)now.m_state)==2)))))
			continue;
		if (TstOnly) return 1; /* TT */
		/* dead 1: number */  (trpt+1)->bup.ovals = grab_ints(7);
		(trpt+1)->bup.ovals[0] = ((P0 *)_this)->number;
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P0 *)_this)->number = 0;
		/* merge: due_ack = 1(153, 18, 153) */
		reached[0][18] = 1;
		(trpt+1)->bup.ovals[1] = ((int)now.due_ack);
		now.due_ack = 1;
#ifdef VAR_RANGES
		logval("due_ack", ((int)now.due_ack));
#endif
		;
		/* merge: .(goto)(153, 30, 153) */
		reached[0][30] = 1;
		;
		/* merge: .(goto)(153, 66, 153) */
		reached[0][66] = 1;
		;
		/* merge: .(goto)(153, 69, 153) */
		reached[0][69] = 1;
		;
		/* merge: what = HELLO(153, 70, 153) */
		reached[0][70] = 1;
		(trpt+1)->bup.ovals[2] = ((P0 *)_this)->what;
		((P0 *)_this)->what = 9;
#ifdef VAR_RANGES
		logval("machine:what", ((P0 *)_this)->what);
#endif
		;
		if (TstOnly) return 1; /* TT */
		/* dead 2: what */  
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P0 *)_this)->what = 0;
		/* merge: session = 0(153, 71, 153) */
		reached[0][71] = 1;
		(trpt+1)->bup.ovals[3] = ((int)((P0 *)_this)->session);
		((P0 *)_this)->session = 0;
#ifdef VAR_RANGES
		logval("machine:session", ((int)((P0 *)_this)->session));
#endif
		;
		/* merge: number = 0(153, 72, 153) */
		reached[0][72] = 1;
		(trpt+1)->bup.ovals[4] = ((int)((P0 *)_this)->number);
		((P0 *)_this)->number = 0;
#ifdef VAR_RANGES
		logval("machine:number", ((int)((P0 *)_this)->number));
#endif
		;
		/* merge: item = 0(153, 73, 153) */
		reached[0][73] = 1;
		(trpt+1)->bup.ovals[5] = ((int)((P0 *)_this)->item);
		((P0 *)_this)->item = 0;
#ifdef VAR_RANGES
		logval("machine:item", ((int)((P0 *)_this)->item));
#endif
		;
		/* merge: .(goto)(0, 154, 153) */
		reached[0][154] = 1;
		;
		_m = 3; goto P999; /* 9 */
	case 79: // STATE 19 - session.pml:122 - [((((number==m_nonce)&&!(m_opened))&&(m_state==0)))] (153:0:13 - 1)
		IfNotBlocked
		reached[0][19] = 1;
		if (!((((((int)((P0 *)_this)->number)==((int)now.m_nonce))&& !(((int)now.m_opened)))&&(((int)now.m_state)==0))))
			continue;
		if (TstOnly) return 1; /* TT */
		/* dead 1: number */  (trpt+1)->bup.ovals = grab_ints(13);
		(trpt+1)->bup.ovals[0] = ((P0 *)_this)->number;
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P0 *)_this)->number = 0;
		/* merge: assert(!(in_job))(153, 20, 153) */
		reached[0][20] = 1;
		spin_assert( !(((int)now.in_job)), " !(in_job)", II, tt, t);
		/* merge: assert(!(distrusted))(153, 21, 153) */
		reached[0][21] = 1;
		spin_assert( !(((int)now.distrusted)), " !(distrusted)", II, tt, t);
		/* merge: in_job = 1(153, 22, 153) */
		reached[0][22] = 1;
		(trpt+1)->bup.ovals[1] = ((int)now.in_job);
		now.in_job = 1;
#ifdef VAR_RANGES
		logval("in_job", ((int)now.in_job));
#endif
		;
		/* merge: m_state = 1(153, 23, 153) */
		reached[0][23] = 1;
		(trpt+1)->bup.ovals[2] = ((int)now.m_state);
		now.m_state = 1;
#ifdef VAR_RANGES
		logval("m_state", ((int)now.m_state));
#endif
		;
		/* merge: m_next = 0(153, 24, 153) */
		reached[0][24] = 1;
		(trpt+1)->bup.ovals[3] = ((int)now.m_next);
		now.m_next = 0;
#ifdef VAR_RANGES
		logval("m_next", ((int)now.m_next));
#endif
		;
		/* merge: m_executed = 0(153, 25, 153) */
		reached[0][25] = 1;
		(trpt+1)->bup.ovals[4] = ((int)now.m_executed);
		now.m_executed = 0;
#ifdef VAR_RANGES
		logval("m_executed", ((int)now.m_executed));
#endif
		;
		/* merge: m_opened = 1(153, 26, 153) */
		reached[0][26] = 1;
		(trpt+1)->bup.ovals[5] = ((int)now.m_opened);
		now.m_opened = 1;
#ifdef VAR_RANGES
		logval("m_opened", ((int)now.m_opened));
#endif
		;
		/* merge: m_ended = 0(153, 27, 153) */
		reached[0][27] = 1;
		(trpt+1)->bup.ovals[6] = ((int)now.m_ended);
		now.m_ended = 0;
#ifdef VAR_RANGES
		logval("m_ended", ((int)now.m_ended));
#endif
		;
		/* merge: due_ack = 1(153, 28, 153) */
		reached[0][28] = 1;
		(trpt+1)->bup.ovals[7] = ((int)now.due_ack);
		now.due_ack = 1;
#ifdef VAR_RANGES
		logval("due_ack", ((int)now.due_ack));
#endif
		;
		/* merge: .(goto)(153, 30, 153) */
		reached[0][30] = 1;
		;
		/* merge: .(goto)(153, 66, 153) */
		reached[0][66] = 1;
		;
		/* merge: .(goto)(153, 69, 153) */
		reached[0][69] = 1;
		;
		/* merge: what = HELLO(153, 70, 153) */
		reached[0][70] = 1;
		(trpt+1)->bup.ovals[8] = ((P0 *)_this)->what;
		((P0 *)_this)->what = 9;
#ifdef VAR_RANGES
		logval("machine:what", ((P0 *)_this)->what);
#endif
		;
		if (TstOnly) return 1; /* TT */
		/* dead 2: what */  
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P0 *)_this)->what = 0;
		/* merge: session = 0(153, 71, 153) */
		reached[0][71] = 1;
		(trpt+1)->bup.ovals[9] = ((int)((P0 *)_this)->session);
		((P0 *)_this)->session = 0;
#ifdef VAR_RANGES
		logval("machine:session", ((int)((P0 *)_this)->session));
#endif
		;
		/* merge: number = 0(153, 72, 153) */
		reached[0][72] = 1;
		(trpt+1)->bup.ovals[10] = ((int)((P0 *)_this)->number);
		((P0 *)_this)->number = 0;
#ifdef VAR_RANGES
		logval("machine:number", ((int)((P0 *)_this)->number));
#endif
		;
		/* merge: item = 0(153, 73, 153) */
		reached[0][73] = 1;
		(trpt+1)->bup.ovals[11] = ((int)((P0 *)_this)->item);
		((P0 *)_this)->item = 0;
#ifdef VAR_RANGES
		logval("machine:item", ((int)((P0 *)_this)->item));
#endif
		;
		/* merge: .(goto)(0, 154, 153) */
		reached[0][154] = 1;
		;
		_m = 3; goto P999; /* 17 */
	case 80: // STATE 32 - session.pml:160 - [((what==ITEM))] (0:0:1 - 1)
		IfNotBlocked
		reached[0][32] = 1;
		if (!((((P0 *)_this)->what==7)))
			continue;
		if (TstOnly) return 1; /* TT */
		/* dead 1: what */  (trpt+1)->bup.oval = ((P0 *)_this)->what;
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P0 *)_this)->what = 0;
		_m = 3; goto P999; /* 0 */
	case 81: // STATE 33 - session.pml:138 - [(((((m_state==1)&&!(m_ended))&&((number==(m_next%4))||((0==2)&&(number==((m_next+1)%4)))))&&((2-(m_next-m_executed))>0)))] (153:0:8 - 1)
		IfNotBlocked
		reached[0][33] = 1;
		if (!(((((((int)now.m_state)==1)&& !(((int)now.m_ended)))&&((((int)((P0 *)_this)->number)==(((int)now.m_next)%4))||((0==2)&&(((int)((P0 *)_this)->number)==((((int)now.m_next)+1)%4)))))&&((2-(((int)now.m_next)-((int)now.m_executed)))>0))))
			continue;
		if (TstOnly) return 1; /* TT */
		/* dead 1: number */  (trpt+1)->bup.ovals = grab_ints(8);
		(trpt+1)->bup.ovals[0] = ((P0 *)_this)->number;
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P0 *)_this)->number = 0;
		/* merge: assert((item==m_next))(153, 34, 153) */
		reached[0][34] = 1;
		spin_assert((((int)((P0 *)_this)->item)==((int)now.m_next)), "(item==m_next)", II, tt, t);
		/* merge: assert(!(distrusted))(153, 35, 153) */
		reached[0][35] = 1;
		spin_assert( !(((int)now.distrusted)), " !(distrusted)", II, tt, t);
		/* merge: m_next = (m_next+1)(153, 36, 153) */
		reached[0][36] = 1;
		(trpt+1)->bup.ovals[1] = ((int)now.m_next);
		now.m_next = (((int)now.m_next)+1);
#ifdef VAR_RANGES
		logval("m_next", ((int)now.m_next));
#endif
		;
		/* merge: .(goto)(153, 39, 153) */
		reached[0][39] = 1;
		;
		/* merge: due_ack = 1(153, 40, 153) */
		reached[0][40] = 1;
		(trpt+1)->bup.ovals[2] = ((int)now.due_ack);
		now.due_ack = 1;
#ifdef VAR_RANGES
		logval("due_ack", ((int)now.due_ack));
#endif
		;
		/* merge: .(goto)(153, 66, 153) */
		reached[0][66] = 1;
		;
		/* merge: .(goto)(153, 69, 153) */
		reached[0][69] = 1;
		;
		/* merge: what = HELLO(153, 70, 153) */
		reached[0][70] = 1;
		(trpt+1)->bup.ovals[3] = ((P0 *)_this)->what;
		((P0 *)_this)->what = 9;
#ifdef VAR_RANGES
		logval("machine:what", ((P0 *)_this)->what);
#endif
		;
		if (TstOnly) return 1; /* TT */
		/* dead 2: what */  
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P0 *)_this)->what = 0;
		/* merge: session = 0(153, 71, 153) */
		reached[0][71] = 1;
		(trpt+1)->bup.ovals[4] = ((int)((P0 *)_this)->session);
		((P0 *)_this)->session = 0;
#ifdef VAR_RANGES
		logval("machine:session", ((int)((P0 *)_this)->session));
#endif
		;
		/* merge: number = 0(153, 72, 153) */
		reached[0][72] = 1;
		(trpt+1)->bup.ovals[5] = ((int)((P0 *)_this)->number);
		((P0 *)_this)->number = 0;
#ifdef VAR_RANGES
		logval("machine:number", ((int)((P0 *)_this)->number));
#endif
		;
		/* merge: item = 0(153, 73, 153) */
		reached[0][73] = 1;
		(trpt+1)->bup.ovals[6] = ((int)((P0 *)_this)->item);
		((P0 *)_this)->item = 0;
#ifdef VAR_RANGES
		logval("machine:item", ((int)((P0 *)_this)->item));
#endif
		;
		/* merge: .(goto)(0, 154, 153) */
		reached[0][154] = 1;
		;
		_m = 3; goto P999; /* 12 */
	case 82: // STATE 40 - session.pml:144 - [due_ack = 1] (0:153:6 - 3)
		IfNotBlocked
		reached[0][40] = 1;
		(trpt+1)->bup.ovals = grab_ints(6);
		(trpt+1)->bup.ovals[0] = ((int)now.due_ack);
		now.due_ack = 1;
#ifdef VAR_RANGES
		logval("due_ack", ((int)now.due_ack));
#endif
		;
		/* merge: .(goto)(153, 66, 153) */
		reached[0][66] = 1;
		;
		/* merge: .(goto)(153, 69, 153) */
		reached[0][69] = 1;
		;
		/* merge: what = HELLO(153, 70, 153) */
		reached[0][70] = 1;
		(trpt+1)->bup.ovals[1] = ((P0 *)_this)->what;
		((P0 *)_this)->what = 9;
#ifdef VAR_RANGES
		logval("machine:what", ((P0 *)_this)->what);
#endif
		;
		if (TstOnly) return 1; /* TT */
		/* dead 2: what */  
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P0 *)_this)->what = 0;
		/* merge: session = 0(153, 71, 153) */
		reached[0][71] = 1;
		(trpt+1)->bup.ovals[2] = ((int)((P0 *)_this)->session);
		((P0 *)_this)->session = 0;
#ifdef VAR_RANGES
		logval("machine:session", ((int)((P0 *)_this)->session));
#endif
		;
		/* merge: number = 0(153, 72, 153) */
		reached[0][72] = 1;
		(trpt+1)->bup.ovals[3] = ((int)((P0 *)_this)->number);
		((P0 *)_this)->number = 0;
#ifdef VAR_RANGES
		logval("machine:number", ((int)((P0 *)_this)->number));
#endif
		;
		/* merge: item = 0(153, 73, 153) */
		reached[0][73] = 1;
		(trpt+1)->bup.ovals[4] = ((int)((P0 *)_this)->item);
		((P0 *)_this)->item = 0;
#ifdef VAR_RANGES
		logval("machine:item", ((int)((P0 *)_this)->item));
#endif
		;
		/* merge: .(goto)(0, 154, 153) */
		reached[0][154] = 1;
		;
		_m = 3; goto P999; /* 7 */
	case 83: // STATE 42 - session.pml:161 - [((what==END))] (0:0:1 - 1)
		IfNotBlocked
		reached[0][42] = 1;
		if (!((((P0 *)_this)->what==6)))
			continue;
		if (TstOnly) return 1; /* TT */
		/* dead 1: what */  (trpt+1)->bup.oval = ((P0 *)_this)->what;
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P0 *)_this)->what = 0;
		_m = 3; goto P999; /* 0 */
	case 84: // STATE 43 - session.pml:163 - [(((m_state==1)&&(number==m_next)))] (153:0:8 - 1)
		IfNotBlocked
		reached[0][43] = 1;
		if (!(((((int)now.m_state)==1)&&(((int)((P0 *)_this)->number)==((int)now.m_next)))))
			continue;
		if (TstOnly) return 1; /* TT */
		/* dead 1: number */  (trpt+1)->bup.ovals = grab_ints(8);
		(trpt+1)->bup.ovals[0] = ((P0 *)_this)->number;
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P0 *)_this)->number = 0;
		/* merge: m_ended = 1(153, 44, 153) */
		reached[0][44] = 1;
		(trpt+1)->bup.ovals[1] = ((int)now.m_ended);
		now.m_ended = 1;
#ifdef VAR_RANGES
		logval("m_ended", ((int)now.m_ended));
#endif
		;
		/* merge: .(goto)(153, 47, 153) */
		reached[0][47] = 1;
		;
		/* merge: due_ack = 1(153, 48, 153) */
		reached[0][48] = 1;
		(trpt+1)->bup.ovals[2] = ((int)now.due_ack);
		now.due_ack = 1;
#ifdef VAR_RANGES
		logval("due_ack", ((int)now.due_ack));
#endif
		;
		/* merge: .(goto)(153, 66, 153) */
		reached[0][66] = 1;
		;
		/* merge: .(goto)(153, 69, 153) */
		reached[0][69] = 1;
		;
		/* merge: what = HELLO(153, 70, 153) */
		reached[0][70] = 1;
		(trpt+1)->bup.ovals[3] = ((P0 *)_this)->what;
		((P0 *)_this)->what = 9;
#ifdef VAR_RANGES
		logval("machine:what", ((P0 *)_this)->what);
#endif
		;
		if (TstOnly) return 1; /* TT */
		/* dead 2: what */  
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P0 *)_this)->what = 0;
		/* merge: session = 0(153, 71, 153) */
		reached[0][71] = 1;
		(trpt+1)->bup.ovals[4] = ((int)((P0 *)_this)->session);
		((P0 *)_this)->session = 0;
#ifdef VAR_RANGES
		logval("machine:session", ((int)((P0 *)_this)->session));
#endif
		;
		/* merge: number = 0(153, 72, 153) */
		reached[0][72] = 1;
		(trpt+1)->bup.ovals[5] = ((int)((P0 *)_this)->number);
		((P0 *)_this)->number = 0;
#ifdef VAR_RANGES
		logval("machine:number", ((int)((P0 *)_this)->number));
#endif
		;
		/* merge: item = 0(153, 73, 153) */
		reached[0][73] = 1;
		(trpt+1)->bup.ovals[6] = ((int)((P0 *)_this)->item);
		((P0 *)_this)->item = 0;
#ifdef VAR_RANGES
		logval("machine:item", ((int)((P0 *)_this)->item));
#endif
		;
		/* merge: .(goto)(0, 154, 153) */
		reached[0][154] = 1;
		;
		_m = 3; goto P999; /* 10 */
	case 85: // STATE 48 - session.pml:166 - [due_ack = 1] (0:153:6 - 3)
		IfNotBlocked
		reached[0][48] = 1;
		(trpt+1)->bup.ovals = grab_ints(6);
		(trpt+1)->bup.ovals[0] = ((int)now.due_ack);
		now.due_ack = 1;
#ifdef VAR_RANGES
		logval("due_ack", ((int)now.due_ack));
#endif
		;
		/* merge: .(goto)(153, 66, 153) */
		reached[0][66] = 1;
		;
		/* merge: .(goto)(153, 69, 153) */
		reached[0][69] = 1;
		;
		/* merge: what = HELLO(153, 70, 153) */
		reached[0][70] = 1;
		(trpt+1)->bup.ovals[1] = ((P0 *)_this)->what;
		((P0 *)_this)->what = 9;
#ifdef VAR_RANGES
		logval("machine:what", ((P0 *)_this)->what);
#endif
		;
		if (TstOnly) return 1; /* TT */
		/* dead 2: what */  
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P0 *)_this)->what = 0;
		/* merge: session = 0(153, 71, 153) */
		reached[0][71] = 1;
		(trpt+1)->bup.ovals[2] = ((int)((P0 *)_this)->session);
		((P0 *)_this)->session = 0;
#ifdef VAR_RANGES
		logval("machine:session", ((int)((P0 *)_this)->session));
#endif
		;
		/* merge: number = 0(153, 72, 153) */
		reached[0][72] = 1;
		(trpt+1)->bup.ovals[3] = ((int)((P0 *)_this)->number);
		((P0 *)_this)->number = 0;
#ifdef VAR_RANGES
		logval("machine:number", ((int)((P0 *)_this)->number));
#endif
		;
		/* merge: item = 0(153, 73, 153) */
		reached[0][73] = 1;
		(trpt+1)->bup.ovals[4] = ((int)((P0 *)_this)->item);
		((P0 *)_this)->item = 0;
#ifdef VAR_RANGES
		logval("machine:item", ((int)((P0 *)_this)->item));
#endif
		;
		/* merge: .(goto)(0, 154, 153) */
		reached[0][154] = 1;
		;
		_m = 3; goto P999; /* 7 */
	case 86: // STATE 49 - session.pml:167 - [((what==POLL))] (54:0:2 - 1)
		IfNotBlocked
		reached[0][49] = 1;
		if (!((((P0 *)_this)->what==5)))
			continue;
		if (TstOnly) return 1; /* TT */
		/* dead 1: what */  (trpt+1)->bup.ovals = grab_ints(2);
		(trpt+1)->bup.ovals[0] = ((P0 *)_this)->what;
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P0 *)_this)->what = 0;
		/* merge: due_ack = 1(0, 50, 54) */
		reached[0][50] = 1;
		(trpt+1)->bup.ovals[1] = ((int)now.due_ack);
		now.due_ack = 1;
#ifdef VAR_RANGES
		logval("due_ack", ((int)now.due_ack));
#endif
		;
		_m = 3; goto P999; /* 1 */
	case 87: // STATE 51 - session.pml:169 - [((m_state==2))] (153:0:6 - 1)
		IfNotBlocked
		reached[0][51] = 1;
		if (!((((int)now.m_state)==2)))
			continue;
		/* merge: due_report = 1(153, 52, 153) */
		reached[0][52] = 1;
		(trpt+1)->bup.ovals = grab_ints(6);
		(trpt+1)->bup.ovals[0] = ((int)now.due_report);
		now.due_report = 1;
#ifdef VAR_RANGES
		logval("due_report", ((int)now.due_report));
#endif
		;
		/* merge: .(goto)(153, 55, 153) */
		reached[0][55] = 1;
		;
		/* merge: .(goto)(153, 66, 153) */
		reached[0][66] = 1;
		;
		/* merge: .(goto)(153, 69, 153) */
		reached[0][69] = 1;
		;
		/* merge: what = HELLO(153, 70, 153) */
		reached[0][70] = 1;
		(trpt+1)->bup.ovals[1] = ((P0 *)_this)->what;
		((P0 *)_this)->what = 9;
#ifdef VAR_RANGES
		logval("machine:what", ((P0 *)_this)->what);
#endif
		;
		if (TstOnly) return 1; /* TT */
		/* dead 2: what */  
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P0 *)_this)->what = 0;
		/* merge: session = 0(153, 71, 153) */
		reached[0][71] = 1;
		(trpt+1)->bup.ovals[2] = ((int)((P0 *)_this)->session);
		((P0 *)_this)->session = 0;
#ifdef VAR_RANGES
		logval("machine:session", ((int)((P0 *)_this)->session));
#endif
		;
		/* merge: number = 0(153, 72, 153) */
		reached[0][72] = 1;
		(trpt+1)->bup.ovals[3] = ((int)((P0 *)_this)->number);
		((P0 *)_this)->number = 0;
#ifdef VAR_RANGES
		logval("machine:number", ((int)((P0 *)_this)->number));
#endif
		;
		/* merge: item = 0(153, 73, 153) */
		reached[0][73] = 1;
		(trpt+1)->bup.ovals[4] = ((int)((P0 *)_this)->item);
		((P0 *)_this)->item = 0;
#ifdef VAR_RANGES
		logval("machine:item", ((int)((P0 *)_this)->item));
#endif
		;
		/* merge: .(goto)(0, 154, 153) */
		reached[0][154] = 1;
		;
		_m = 3; goto P999; /* 9 */
	case 88: // STATE 56 - session.pml:170 - [((what==CLOSE))] (0:0:1 - 1)
		IfNotBlocked
		reached[0][56] = 1;
		if (!((((P0 *)_this)->what==4)))
			continue;
		if (TstOnly) return 1; /* TT */
		/* dead 1: what */  (trpt+1)->bup.oval = ((P0 *)_this)->what;
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P0 *)_this)->what = 0;
		_m = 3; goto P999; /* 0 */
	case 89: // STATE 57 - session.pml:171 - [((m_state==2))] (153:0:9 - 1)
		IfNotBlocked
		reached[0][57] = 1;
		if (!((((int)now.m_state)==2)))
			continue;
		/* merge: m_state = 0(153, 58, 153) */
		reached[0][58] = 1;
		(trpt+1)->bup.ovals = grab_ints(9);
		(trpt+1)->bup.ovals[0] = ((int)now.m_state);
		now.m_state = 0;
#ifdef VAR_RANGES
		logval("m_state", ((int)now.m_state));
#endif
		;
		/* merge: in_job = 0(153, 59, 153) */
		reached[0][59] = 1;
		(trpt+1)->bup.ovals[1] = ((int)now.in_job);
		now.in_job = 0;
#ifdef VAR_RANGES
		logval("in_job", ((int)now.in_job));
#endif
		;
		/* merge: due_report = 0(153, 60, 153) */
		reached[0][60] = 1;
		(trpt+1)->bup.ovals[2] = ((int)now.due_report);
		now.due_report = 0;
#ifdef VAR_RANGES
		logval("due_report", ((int)now.due_report));
#endif
		;
		/* merge: .(goto)(153, 63, 153) */
		reached[0][63] = 1;
		;
		/* merge: due_ack = 1(153, 64, 153) */
		reached[0][64] = 1;
		(trpt+1)->bup.ovals[3] = ((int)now.due_ack);
		now.due_ack = 1;
#ifdef VAR_RANGES
		logval("due_ack", ((int)now.due_ack));
#endif
		;
		/* merge: .(goto)(153, 66, 153) */
		reached[0][66] = 1;
		;
		/* merge: .(goto)(153, 69, 153) */
		reached[0][69] = 1;
		;
		/* merge: what = HELLO(153, 70, 153) */
		reached[0][70] = 1;
		(trpt+1)->bup.ovals[4] = ((P0 *)_this)->what;
		((P0 *)_this)->what = 9;
#ifdef VAR_RANGES
		logval("machine:what", ((P0 *)_this)->what);
#endif
		;
		if (TstOnly) return 1; /* TT */
		/* dead 2: what */  
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P0 *)_this)->what = 0;
		/* merge: session = 0(153, 71, 153) */
		reached[0][71] = 1;
		(trpt+1)->bup.ovals[5] = ((int)((P0 *)_this)->session);
		((P0 *)_this)->session = 0;
#ifdef VAR_RANGES
		logval("machine:session", ((int)((P0 *)_this)->session));
#endif
		;
		/* merge: number = 0(153, 72, 153) */
		reached[0][72] = 1;
		(trpt+1)->bup.ovals[6] = ((int)((P0 *)_this)->number);
		((P0 *)_this)->number = 0;
#ifdef VAR_RANGES
		logval("machine:number", ((int)((P0 *)_this)->number));
#endif
		;
		/* merge: item = 0(153, 73, 153) */
		reached[0][73] = 1;
		(trpt+1)->bup.ovals[7] = ((int)((P0 *)_this)->item);
		((P0 *)_this)->item = 0;
#ifdef VAR_RANGES
		logval("machine:item", ((int)((P0 *)_this)->item));
#endif
		;
		/* merge: .(goto)(0, 154, 153) */
		reached[0][154] = 1;
		;
		_m = 3; goto P999; /* 12 */
	case 90: // STATE 64 - session.pml:172 - [due_ack = 1] (0:153:6 - 3)
		IfNotBlocked
		reached[0][64] = 1;
		(trpt+1)->bup.ovals = grab_ints(6);
		(trpt+1)->bup.ovals[0] = ((int)now.due_ack);
		now.due_ack = 1;
#ifdef VAR_RANGES
		logval("due_ack", ((int)now.due_ack));
#endif
		;
		/* merge: .(goto)(153, 66, 153) */
		reached[0][66] = 1;
		;
		/* merge: .(goto)(153, 69, 153) */
		reached[0][69] = 1;
		;
		/* merge: what = HELLO(153, 70, 153) */
		reached[0][70] = 1;
		(trpt+1)->bup.ovals[1] = ((P0 *)_this)->what;
		((P0 *)_this)->what = 9;
#ifdef VAR_RANGES
		logval("machine:what", ((P0 *)_this)->what);
#endif
		;
		if (TstOnly) return 1; /* TT */
		/* dead 2: what */  
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P0 *)_this)->what = 0;
		/* merge: session = 0(153, 71, 153) */
		reached[0][71] = 1;
		(trpt+1)->bup.ovals[2] = ((int)((P0 *)_this)->session);
		((P0 *)_this)->session = 0;
#ifdef VAR_RANGES
		logval("machine:session", ((int)((P0 *)_this)->session));
#endif
		;
		/* merge: number = 0(153, 72, 153) */
		reached[0][72] = 1;
		(trpt+1)->bup.ovals[3] = ((int)((P0 *)_this)->number);
		((P0 *)_this)->number = 0;
#ifdef VAR_RANGES
		logval("machine:number", ((int)((P0 *)_this)->number));
#endif
		;
		/* merge: item = 0(153, 73, 153) */
		reached[0][73] = 1;
		(trpt+1)->bup.ovals[4] = ((int)((P0 *)_this)->item);
		((P0 *)_this)->item = 0;
#ifdef VAR_RANGES
		logval("machine:item", ((int)((P0 *)_this)->item));
#endif
		;
		/* merge: .(goto)(0, 154, 153) */
		reached[0][154] = 1;
		;
		_m = 3; goto P999; /* 7 */
	case 91: // STATE 70 - session.pml:176 - [what = HELLO] (0:153:5 - 14)
		IfNotBlocked
		reached[0][70] = 1;
		(trpt+1)->bup.ovals = grab_ints(5);
		(trpt+1)->bup.ovals[0] = ((P0 *)_this)->what;
		((P0 *)_this)->what = 9;
#ifdef VAR_RANGES
		logval("machine:what", ((P0 *)_this)->what);
#endif
		;
		if (TstOnly) return 1; /* TT */
		/* dead 2: what */  
#ifdef HAS_CODE
		if (!readtrail)
#endif
			((P0 *)_this)->what = 0;
		/* merge: session = 0(153, 71, 153) */
		reached[0][71] = 1;
		(trpt+1)->bup.ovals[1] = ((int)((P0 *)_this)->session);
		((P0 *)_this)->session = 0;
#ifdef VAR_RANGES
		logval("machine:session", ((int)((P0 *)_this)->session));
#endif
		;
		/* merge: number = 0(153, 72, 153) */
		reached[0][72] = 1;
		(trpt+1)->bup.ovals[2] = ((int)((P0 *)_this)->number);
		((P0 *)_this)->number = 0;
#ifdef VAR_RANGES
		logval("machine:number", ((int)((P0 *)_this)->number));
#endif
		;
		/* merge: item = 0(153, 73, 153) */
		reached[0][73] = 1;
		(trpt+1)->bup.ovals[3] = ((int)((P0 *)_this)->item);
		((P0 *)_this)->item = 0;
#ifdef VAR_RANGES
		logval("machine:item", ((int)((P0 *)_this)->item));
#endif
		;
		/* merge: .(goto)(0, 154, 153) */
		reached[0][154] = 1;
		;
		_m = 3; goto P999; /* 4 */
	case 92: // STATE 75 - session.pml:178 - [((due_welcome&&nfull(to_host)))] (86:0:1 - 1)
		IfNotBlocked
		reached[0][75] = 1;
		if (!((((int)now.due_welcome)&&(!q_full(now.to_host)))))
			continue;
		/* merge: due_welcome = 0(0, 76, 86) */
		reached[0][76] = 1;
		(trpt+1)->bup.oval = ((int)now.due_welcome);
		now.due_welcome = 0;
#ifdef VAR_RANGES
		logval("due_welcome", ((int)now.due_welcome));
#endif
		;
		_m = 3; goto P999; /* 1 */
	case 93: // STATE 77 - session.pml:94 - [to_host!3,m_session,m_nonce,m_next,(((m_next+(2-(m_next-m_executed)))+(16*m_state))+(128*m_opened)),m_boot] (153:0:0 - 1)
		IfNotBlocked
		reached[0][77] = 1;
		if (q_full(now.to_host))
			continue;
#ifdef HAS_CODE
		if (readtrail && gui) {
			char simtmp[64];
			sprintf(simvals, "%d!", now.to_host);
		sprintf(simtmp, "%d", 3); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_session)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_nonce)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_next)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", (((((int)now.m_next)+(2-(((int)now.m_next)-((int)now.m_executed))))+(16*((int)now.m_state)))+(128*((int)now.m_opened)))); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_boot)); strcat(simvals, simtmp);		}
#endif
		
		qsend(now.to_host, 0, 3, ((int)now.m_session), ((int)now.m_nonce), ((int)now.m_next), (((((int)now.m_next)+(2-(((int)now.m_next)-((int)now.m_executed))))+(16*((int)now.m_state)))+(128*((int)now.m_opened))), ((int)now.m_boot), 6);
		/* merge: .(goto)(153, 85, 153) */
		reached[0][85] = 1;
		;
		/* merge: .(goto)(0, 154, 153) */
		reached[0][154] = 1;
		;
		_m = 2; goto P999; /* 2 */
	case 94: // STATE 85 - session.pml:101 - [.(goto)] (0:153:0 - 3)
		IfNotBlocked
		reached[0][85] = 1;
		;
		/* merge: .(goto)(0, 154, 153) */
		reached[0][154] = 1;
		;
		_m = 3; goto P999; /* 1 */
	case 95: // STATE 78 - session.pml:95 - [((faults>0))] (153:0:1 - 1)
		IfNotBlocked
		reached[0][78] = 1;
		if (!((((int)now.faults)>0)))
			continue;
		/* merge: faults = (faults-1)(153, 79, 153) */
		reached[0][79] = 1;
		(trpt+1)->bup.oval = ((int)now.faults);
		now.faults = (((int)now.faults)-1);
#ifdef VAR_RANGES
		logval("faults", ((int)now.faults));
#endif
		;
		/* merge: .(goto)(153, 85, 153) */
		reached[0][85] = 1;
		;
		/* merge: .(goto)(0, 154, 153) */
		reached[0][154] = 1;
		;
		_m = 3; goto P999; /* 3 */
	case 96: // STATE 80 - session.pml:96 - [(((faults>0)&&(len(to_host)<(3-1))))] (82:0:1 - 1)
		IfNotBlocked
		reached[0][80] = 1;
		if (!(((((int)now.faults)>0)&&(q_len(now.to_host)<(3-1)))))
			continue;
		/* merge: faults = (faults-1)(0, 81, 82) */
		reached[0][81] = 1;
		(trpt+1)->bup.oval = ((int)now.faults);
		now.faults = (((int)now.faults)-1);
#ifdef VAR_RANGES
		logval("faults", ((int)now.faults));
#endif
		;
		_m = 3; goto P999; /* 1 */
	case 97: // STATE 82 - session.pml:98 - [to_host!3,m_session,m_nonce,m_next,(((m_next+(2-(m_next-m_executed)))+(16*m_state))+(128*m_opened)),m_boot] (0:0:0 - 1)
		IfNotBlocked
		reached[0][82] = 1;
		if (q_full(now.to_host))
			continue;
#ifdef HAS_CODE
		if (readtrail && gui) {
			char simtmp[64];
			sprintf(simvals, "%d!", now.to_host);
		sprintf(simtmp, "%d", 3); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_session)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_nonce)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_next)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", (((((int)now.m_next)+(2-(((int)now.m_next)-((int)now.m_executed))))+(16*((int)now.m_state)))+(128*((int)now.m_opened)))); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_boot)); strcat(simvals, simtmp);		}
#endif
		
		qsend(now.to_host, 0, 3, ((int)now.m_session), ((int)now.m_nonce), ((int)now.m_next), (((((int)now.m_next)+(2-(((int)now.m_next)-((int)now.m_executed))))+(16*((int)now.m_state)))+(128*((int)now.m_opened))), ((int)now.m_boot), 6);
		_m = 2; goto P999; /* 0 */
	case 98: // STATE 83 - session.pml:99 - [to_host!3,m_session,m_nonce,m_next,(((m_next+(2-(m_next-m_executed)))+(16*m_state))+(128*m_opened)),m_boot] (153:0:0 - 1)
		IfNotBlocked
		reached[0][83] = 1;
		if (q_full(now.to_host))
			continue;
#ifdef HAS_CODE
		if (readtrail && gui) {
			char simtmp[64];
			sprintf(simvals, "%d!", now.to_host);
		sprintf(simtmp, "%d", 3); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_session)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_nonce)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_next)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", (((((int)now.m_next)+(2-(((int)now.m_next)-((int)now.m_executed))))+(16*((int)now.m_state)))+(128*((int)now.m_opened)))); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_boot)); strcat(simvals, simtmp);		}
#endif
		
		qsend(now.to_host, 0, 3, ((int)now.m_session), ((int)now.m_nonce), ((int)now.m_next), (((((int)now.m_next)+(2-(((int)now.m_next)-((int)now.m_executed))))+(16*((int)now.m_state)))+(128*((int)now.m_opened))), ((int)now.m_boot), 6);
		/* merge: .(goto)(153, 85, 153) */
		reached[0][85] = 1;
		;
		/* merge: .(goto)(0, 154, 153) */
		reached[0][154] = 1;
		;
		_m = 2; goto P999; /* 2 */
	case 99: // STATE 88 - session.pml:179 - [((((!(due_welcome)&&due_report)&&(m_session!=0))&&nfull(to_host)))] (99:0:1 - 1)
		IfNotBlocked
		reached[0][88] = 1;
		if (!(((( !(((int)now.due_welcome))&&((int)now.due_report))&&(((int)now.m_session)!=0))&&(!q_full(now.to_host)))))
			continue;
		/* merge: due_report = 0(0, 89, 99) */
		reached[0][89] = 1;
		(trpt+1)->bup.oval = ((int)now.due_report);
		now.due_report = 0;
#ifdef VAR_RANGES
		logval("due_report", ((int)now.due_report));
#endif
		;
		_m = 3; goto P999; /* 1 */
	case 100: // STATE 90 - session.pml:94 - [to_host!1,m_session,m_nonce,m_next,(((m_next+(2-(m_next-m_executed)))+(16*m_state))+(128*m_opened)),m_boot] (153:0:0 - 1)
		IfNotBlocked
		reached[0][90] = 1;
		if (q_full(now.to_host))
			continue;
#ifdef HAS_CODE
		if (readtrail && gui) {
			char simtmp[64];
			sprintf(simvals, "%d!", now.to_host);
		sprintf(simtmp, "%d", 1); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_session)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_nonce)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_next)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", (((((int)now.m_next)+(2-(((int)now.m_next)-((int)now.m_executed))))+(16*((int)now.m_state)))+(128*((int)now.m_opened)))); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_boot)); strcat(simvals, simtmp);		}
#endif
		
		qsend(now.to_host, 0, 1, ((int)now.m_session), ((int)now.m_nonce), ((int)now.m_next), (((((int)now.m_next)+(2-(((int)now.m_next)-((int)now.m_executed))))+(16*((int)now.m_state)))+(128*((int)now.m_opened))), ((int)now.m_boot), 6);
		/* merge: .(goto)(153, 98, 153) */
		reached[0][98] = 1;
		;
		/* merge: .(goto)(0, 154, 153) */
		reached[0][154] = 1;
		;
		_m = 2; goto P999; /* 2 */
	case 101: // STATE 98 - session.pml:101 - [.(goto)] (0:153:0 - 3)
		IfNotBlocked
		reached[0][98] = 1;
		;
		/* merge: .(goto)(0, 154, 153) */
		reached[0][154] = 1;
		;
		_m = 3; goto P999; /* 1 */
	case 102: // STATE 91 - session.pml:95 - [((faults>0))] (153:0:1 - 1)
		IfNotBlocked
		reached[0][91] = 1;
		if (!((((int)now.faults)>0)))
			continue;
		/* merge: faults = (faults-1)(153, 92, 153) */
		reached[0][92] = 1;
		(trpt+1)->bup.oval = ((int)now.faults);
		now.faults = (((int)now.faults)-1);
#ifdef VAR_RANGES
		logval("faults", ((int)now.faults));
#endif
		;
		/* merge: .(goto)(153, 98, 153) */
		reached[0][98] = 1;
		;
		/* merge: .(goto)(0, 154, 153) */
		reached[0][154] = 1;
		;
		_m = 3; goto P999; /* 3 */
	case 103: // STATE 93 - session.pml:96 - [(((faults>0)&&(len(to_host)<(3-1))))] (95:0:1 - 1)
		IfNotBlocked
		reached[0][93] = 1;
		if (!(((((int)now.faults)>0)&&(q_len(now.to_host)<(3-1)))))
			continue;
		/* merge: faults = (faults-1)(0, 94, 95) */
		reached[0][94] = 1;
		(trpt+1)->bup.oval = ((int)now.faults);
		now.faults = (((int)now.faults)-1);
#ifdef VAR_RANGES
		logval("faults", ((int)now.faults));
#endif
		;
		_m = 3; goto P999; /* 1 */
	case 104: // STATE 95 - session.pml:98 - [to_host!1,m_session,m_nonce,m_next,(((m_next+(2-(m_next-m_executed)))+(16*m_state))+(128*m_opened)),m_boot] (0:0:0 - 1)
		IfNotBlocked
		reached[0][95] = 1;
		if (q_full(now.to_host))
			continue;
#ifdef HAS_CODE
		if (readtrail && gui) {
			char simtmp[64];
			sprintf(simvals, "%d!", now.to_host);
		sprintf(simtmp, "%d", 1); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_session)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_nonce)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_next)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", (((((int)now.m_next)+(2-(((int)now.m_next)-((int)now.m_executed))))+(16*((int)now.m_state)))+(128*((int)now.m_opened)))); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_boot)); strcat(simvals, simtmp);		}
#endif
		
		qsend(now.to_host, 0, 1, ((int)now.m_session), ((int)now.m_nonce), ((int)now.m_next), (((((int)now.m_next)+(2-(((int)now.m_next)-((int)now.m_executed))))+(16*((int)now.m_state)))+(128*((int)now.m_opened))), ((int)now.m_boot), 6);
		_m = 2; goto P999; /* 0 */
	case 105: // STATE 96 - session.pml:99 - [to_host!1,m_session,m_nonce,m_next,(((m_next+(2-(m_next-m_executed)))+(16*m_state))+(128*m_opened)),m_boot] (153:0:0 - 1)
		IfNotBlocked
		reached[0][96] = 1;
		if (q_full(now.to_host))
			continue;
#ifdef HAS_CODE
		if (readtrail && gui) {
			char simtmp[64];
			sprintf(simvals, "%d!", now.to_host);
		sprintf(simtmp, "%d", 1); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_session)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_nonce)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_next)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", (((((int)now.m_next)+(2-(((int)now.m_next)-((int)now.m_executed))))+(16*((int)now.m_state)))+(128*((int)now.m_opened)))); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_boot)); strcat(simvals, simtmp);		}
#endif
		
		qsend(now.to_host, 0, 1, ((int)now.m_session), ((int)now.m_nonce), ((int)now.m_next), (((((int)now.m_next)+(2-(((int)now.m_next)-((int)now.m_executed))))+(16*((int)now.m_state)))+(128*((int)now.m_opened))), ((int)now.m_boot), 6);
		/* merge: .(goto)(153, 98, 153) */
		reached[0][98] = 1;
		;
		/* merge: .(goto)(0, 154, 153) */
		reached[0][154] = 1;
		;
		_m = 2; goto P999; /* 2 */
	case 106: // STATE 101 - session.pml:180 - [((((!(due_welcome)&&!(due_report))&&due_ack)&&nfull(to_host)))] (112:0:1 - 1)
		IfNotBlocked
		reached[0][101] = 1;
		if (!(((( !(((int)now.due_welcome))&& !(((int)now.due_report)))&&((int)now.due_ack))&&(!q_full(now.to_host)))))
			continue;
		/* merge: due_ack = 0(0, 102, 112) */
		reached[0][102] = 1;
		(trpt+1)->bup.oval = ((int)now.due_ack);
		now.due_ack = 0;
#ifdef VAR_RANGES
		logval("due_ack", ((int)now.due_ack));
#endif
		;
		_m = 3; goto P999; /* 1 */
	case 107: // STATE 103 - session.pml:94 - [to_host!2,m_session,m_nonce,m_next,(((m_next+(2-(m_next-m_executed)))+(16*m_state))+(128*m_opened)),m_boot] (153:0:0 - 1)
		IfNotBlocked
		reached[0][103] = 1;
		if (q_full(now.to_host))
			continue;
#ifdef HAS_CODE
		if (readtrail && gui) {
			char simtmp[64];
			sprintf(simvals, "%d!", now.to_host);
		sprintf(simtmp, "%d", 2); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_session)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_nonce)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_next)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", (((((int)now.m_next)+(2-(((int)now.m_next)-((int)now.m_executed))))+(16*((int)now.m_state)))+(128*((int)now.m_opened)))); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_boot)); strcat(simvals, simtmp);		}
#endif
		
		qsend(now.to_host, 0, 2, ((int)now.m_session), ((int)now.m_nonce), ((int)now.m_next), (((((int)now.m_next)+(2-(((int)now.m_next)-((int)now.m_executed))))+(16*((int)now.m_state)))+(128*((int)now.m_opened))), ((int)now.m_boot), 6);
		/* merge: .(goto)(153, 111, 153) */
		reached[0][111] = 1;
		;
		/* merge: .(goto)(0, 154, 153) */
		reached[0][154] = 1;
		;
		_m = 2; goto P999; /* 2 */
	case 108: // STATE 111 - session.pml:101 - [.(goto)] (0:153:0 - 3)
		IfNotBlocked
		reached[0][111] = 1;
		;
		/* merge: .(goto)(0, 154, 153) */
		reached[0][154] = 1;
		;
		_m = 3; goto P999; /* 1 */
	case 109: // STATE 104 - session.pml:95 - [((faults>0))] (153:0:1 - 1)
		IfNotBlocked
		reached[0][104] = 1;
		if (!((((int)now.faults)>0)))
			continue;
		/* merge: faults = (faults-1)(153, 105, 153) */
		reached[0][105] = 1;
		(trpt+1)->bup.oval = ((int)now.faults);
		now.faults = (((int)now.faults)-1);
#ifdef VAR_RANGES
		logval("faults", ((int)now.faults));
#endif
		;
		/* merge: .(goto)(153, 111, 153) */
		reached[0][111] = 1;
		;
		/* merge: .(goto)(0, 154, 153) */
		reached[0][154] = 1;
		;
		_m = 3; goto P999; /* 3 */
	case 110: // STATE 106 - session.pml:96 - [(((faults>0)&&(len(to_host)<(3-1))))] (108:0:1 - 1)
		IfNotBlocked
		reached[0][106] = 1;
		if (!(((((int)now.faults)>0)&&(q_len(now.to_host)<(3-1)))))
			continue;
		/* merge: faults = (faults-1)(0, 107, 108) */
		reached[0][107] = 1;
		(trpt+1)->bup.oval = ((int)now.faults);
		now.faults = (((int)now.faults)-1);
#ifdef VAR_RANGES
		logval("faults", ((int)now.faults));
#endif
		;
		_m = 3; goto P999; /* 1 */
	case 111: // STATE 108 - session.pml:98 - [to_host!2,m_session,m_nonce,m_next,(((m_next+(2-(m_next-m_executed)))+(16*m_state))+(128*m_opened)),m_boot] (0:0:0 - 1)
		IfNotBlocked
		reached[0][108] = 1;
		if (q_full(now.to_host))
			continue;
#ifdef HAS_CODE
		if (readtrail && gui) {
			char simtmp[64];
			sprintf(simvals, "%d!", now.to_host);
		sprintf(simtmp, "%d", 2); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_session)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_nonce)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_next)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", (((((int)now.m_next)+(2-(((int)now.m_next)-((int)now.m_executed))))+(16*((int)now.m_state)))+(128*((int)now.m_opened)))); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_boot)); strcat(simvals, simtmp);		}
#endif
		
		qsend(now.to_host, 0, 2, ((int)now.m_session), ((int)now.m_nonce), ((int)now.m_next), (((((int)now.m_next)+(2-(((int)now.m_next)-((int)now.m_executed))))+(16*((int)now.m_state)))+(128*((int)now.m_opened))), ((int)now.m_boot), 6);
		_m = 2; goto P999; /* 0 */
	case 112: // STATE 109 - session.pml:99 - [to_host!2,m_session,m_nonce,m_next,(((m_next+(2-(m_next-m_executed)))+(16*m_state))+(128*m_opened)),m_boot] (153:0:0 - 1)
		IfNotBlocked
		reached[0][109] = 1;
		if (q_full(now.to_host))
			continue;
#ifdef HAS_CODE
		if (readtrail && gui) {
			char simtmp[64];
			sprintf(simvals, "%d!", now.to_host);
		sprintf(simtmp, "%d", 2); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_session)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_nonce)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_next)); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", (((((int)now.m_next)+(2-(((int)now.m_next)-((int)now.m_executed))))+(16*((int)now.m_state)))+(128*((int)now.m_opened)))); strcat(simvals, simtmp);		strcat(simvals, ",");
		sprintf(simtmp, "%d", ((int)now.m_boot)); strcat(simvals, simtmp);		}
#endif
		
		qsend(now.to_host, 0, 2, ((int)now.m_session), ((int)now.m_nonce), ((int)now.m_next), (((((int)now.m_next)+(2-(((int)now.m_next)-((int)now.m_executed))))+(16*((int)now.m_state)))+(128*((int)now.m_opened))), ((int)now.m_boot), 6);
		/* merge: .(goto)(153, 111, 153) */
		reached[0][111] = 1;
		;
		/* merge: .(goto)(0, 154, 153) */
		reached[0][154] = 1;
		;
		_m = 2; goto P999; /* 2 */
	case 113: // STATE 114 - session.pml:182 - [((m_executed<m_next))] (120:0:1 - 1)
		IfNotBlocked
		reached[0][114] = 1;
		if (!((((int)now.m_executed)<((int)now.m_next))))
			continue;
		/* merge: m_executed = (m_executed+1)(120, 115, 120) */
		reached[0][115] = 1;
		(trpt+1)->bup.oval = ((int)now.m_executed);
		now.m_executed = (((int)now.m_executed)+1);
#ifdef VAR_RANGES
		logval("m_executed", ((int)now.m_executed));
#endif
		;
		/* merge: assert(((m_next-m_executed)<2))(120, 116, 120) */
		reached[0][116] = 1;
		spin_assert(((((int)now.m_next)-((int)now.m_executed))<2), "((m_next-m_executed)<2)", II, tt, t);
		_m = 3; goto P999; /* 2 */
	case 114: // STATE 117 - session.pml:185 - [((m_session!=0))] (153:0:1 - 1)
		IfNotBlocked
		reached[0][117] = 1;
		if (!((((int)now.m_session)!=0)))
			continue;
		/* merge: due_ack = 1(153, 118, 153) */
		reached[0][118] = 1;
		(trpt+1)->bup.oval = ((int)now.due_ack);
		now.due_ack = 1;
#ifdef VAR_RANGES
		logval("due_ack", ((int)now.due_ack));
#endif
		;
		/* merge: .(goto)(153, 121, 153) */
		reached[0][121] = 1;
		;
		/* merge: .(goto)(0, 154, 153) */
		reached[0][154] = 1;
		;
		_m = 3; goto P999; /* 3 */
	case 115: // STATE 121 - session.pml:185 - [.(goto)] (0:153:0 - 2)
		IfNotBlocked
		reached[0][121] = 1;
		;
		/* merge: .(goto)(0, 154, 153) */
		reached[0][154] = 1;
		;
		_m = 3; goto P999; /* 1 */
	case 116: // STATE 123 - session.pml:186 - [((((m_state==1)&&m_ended)&&(m_executed==m_next)))] (129:0:1 - 1)
		IfNotBlocked
		reached[0][123] = 1;
		if (!((((((int)now.m_state)==1)&&((int)now.m_ended))&&(((int)now.m_executed)==((int)now.m_next)))))
			continue;
		/* merge: assert((m_executed==2))(129, 124, 129) */
		reached[0][124] = 1;
		spin_assert((((int)now.m_executed)==2), "(m_executed==2)", II, tt, t);
		/* merge: m_state = 2(129, 125, 129) */
		reached[0][125] = 1;
		(trpt+1)->bup.oval = ((int)now.m_state);
		now.m_state = 2;
#ifdef VAR_RANGES
		logval("m_state", ((int)now.m_state));
#endif
		;
		_m = 3; goto P999; /* 2 */
	case 117: // STATE 126 - session.pml:189 - [((m_session!=0))] (153:0:1 - 1)
		IfNotBlocked
		reached[0][126] = 1;
		if (!((((int)now.m_session)!=0)))
			continue;
		/* merge: due_report = 1(153, 127, 153) */
		reached[0][127] = 1;
		(trpt+1)->bup.oval = ((int)now.due_report);
		now.due_report = 1;
#ifdef VAR_RANGES
		logval("due_report", ((int)now.due_report));
#endif
		;
		/* merge: .(goto)(153, 130, 153) */
		reached[0][130] = 1;
		;
		/* merge: .(goto)(0, 154, 153) */
		reached[0][154] = 1;
		;
		_m = 3; goto P999; /* 3 */
	case 118: // STATE 130 - session.pml:189 - [.(goto)] (0:153:0 - 2)
		IfNotBlocked
		reached[0][130] = 1;
		;
		/* merge: .(goto)(0, 154, 153) */
		reached[0][154] = 1;
		;
		_m = 3; goto P999; /* 1 */
	case 119: // STATE 132 - session.pml:191 - [((reboots>0))] (137:0:1 - 1)
		IfNotBlocked
		reached[0][132] = 1;
		if (!((((int)now.reboots)>0)))
			continue;
		/* merge: reboots = (reboots-1)(0, 133, 137) */
		reached[0][133] = 1;
		(trpt+1)->bup.oval = ((int)now.reboots);
		now.reboots = (((int)now.reboots)-1);
#ifdef VAR_RANGES
		logval("reboots", ((int)now.reboots));
#endif
		;
		_m = 3; goto P999; /* 1 */
	case 120: // STATE 134 - session.pml:193 - [((in_job&&h_opened))] (153:0:14 - 1)
		IfNotBlocked
		reached[0][134] = 1;
		if (!((((int)now.in_job)&&((int)now.h_opened))))
			continue;
		/* merge: distrusted = 1(153, 135, 153) */
		reached[0][135] = 1;
		(trpt+1)->bup.ovals = grab_ints(14);
		(trpt+1)->bup.ovals[0] = ((int)now.distrusted);
		now.distrusted = 1;
#ifdef VAR_RANGES
		logval("distrusted", ((int)now.distrusted));
#endif
		;
		/* merge: .(goto)(153, 138, 153) */
		reached[0][138] = 1;
		;
		/* merge: m_boot = (m_boot+1)(153, 139, 153) */
		reached[0][139] = 1;
		(trpt+1)->bup.ovals[1] = ((int)now.m_boot);
		now.m_boot = (((int)now.m_boot)+1);
#ifdef VAR_RANGES
		logval("m_boot", ((int)now.m_boot));
#endif
		;
		/* merge: m_state = 0(153, 140, 153) */
		reached[0][140] = 1;
		(trpt+1)->bup.ovals[2] = ((int)now.m_state);
		now.m_state = 0;
#ifdef VAR_RANGES
		logval("m_state", ((int)now.m_state));
#endif
		;
		/* merge: m_session = 0(153, 141, 153) */
		reached[0][141] = 1;
		(trpt+1)->bup.ovals[3] = ((int)now.m_session);
		now.m_session = 0;
#ifdef VAR_RANGES
		logval("m_session", ((int)now.m_session));
#endif
		;
		/* merge: m_sessions = m_boot(153, 142, 153) */
		reached[0][142] = 1;
		(trpt+1)->bup.ovals[4] = ((int)now.m_sessions);
		now.m_sessions = ((int)now.m_boot);
#ifdef VAR_RANGES
		logval("m_sessions", ((int)now.m_sessions));
#endif
		;
		/* merge: m_nonce = 0(153, 143, 153) */
		reached[0][143] = 1;
		(trpt+1)->bup.ovals[5] = ((int)now.m_nonce);
		now.m_nonce = 0;
#ifdef VAR_RANGES
		logval("m_nonce", ((int)now.m_nonce));
#endif
		;
		/* merge: m_next = 0(153, 144, 153) */
		reached[0][144] = 1;
		(trpt+1)->bup.ovals[6] = ((int)now.m_next);
		now.m_next = 0;
#ifdef VAR_RANGES
		logval("m_next", ((int)now.m_next));
#endif
		;
		/* merge: m_executed = 0(153, 145, 153) */
		reached[0][145] = 1;
		(trpt+1)->bup.ovals[7] = ((int)now.m_executed);
		now.m_executed = 0;
#ifdef VAR_RANGES
		logval("m_executed", ((int)now.m_executed));
#endif
		;
		/* merge: m_opened = 0(153, 146, 153) */
		reached[0][146] = 1;
		(trpt+1)->bup.ovals[8] = ((int)now.m_opened);
		now.m_opened = 0;
#ifdef VAR_RANGES
		logval("m_opened", ((int)now.m_opened));
#endif
		;
		/* merge: m_ended = 0(153, 147, 153) */
		reached[0][147] = 1;
		(trpt+1)->bup.ovals[9] = ((int)now.m_ended);
		now.m_ended = 0;
#ifdef VAR_RANGES
		logval("m_ended", ((int)now.m_ended));
#endif
		;
		/* merge: in_job = 0(153, 148, 153) */
		reached[0][148] = 1;
		(trpt+1)->bup.ovals[10] = ((int)now.in_job);
		now.in_job = 0;
#ifdef VAR_RANGES
		logval("in_job", ((int)now.in_job));
#endif
		;
		/* merge: due_welcome = 0(153, 149, 153) */
		reached[0][149] = 1;
		(trpt+1)->bup.ovals[11] = ((int)now.due_welcome);
		now.due_welcome = 0;
#ifdef VAR_RANGES
		logval("due_welcome", ((int)now.due_welcome));
#endif
		;
		/* merge: due_ack = 0(153, 150, 153) */
		reached[0][150] = 1;
		(trpt+1)->bup.ovals[12] = ((int)now.due_ack);
		now.due_ack = 0;
#ifdef VAR_RANGES
		logval("due_ack", ((int)now.due_ack));
#endif
		;
		/* merge: due_report = 0(153, 151, 153) */
		reached[0][151] = 1;
		(trpt+1)->bup.ovals[13] = ((int)now.due_report);
		now.due_report = 0;
#ifdef VAR_RANGES
		logval("due_report", ((int)now.due_report));
#endif
		;
		/* merge: .(goto)(0, 154, 153) */
		reached[0][154] = 1;
		;
		_m = 3; goto P999; /* 16 */
	case 121: // STATE 139 - session.pml:194 - [m_boot = (m_boot+1)] (0:153:13 - 3)
		IfNotBlocked
		reached[0][139] = 1;
		(trpt+1)->bup.ovals = grab_ints(13);
		(trpt+1)->bup.ovals[0] = ((int)now.m_boot);
		now.m_boot = (((int)now.m_boot)+1);
#ifdef VAR_RANGES
		logval("m_boot", ((int)now.m_boot));
#endif
		;
		/* merge: m_state = 0(153, 140, 153) */
		reached[0][140] = 1;
		(trpt+1)->bup.ovals[1] = ((int)now.m_state);
		now.m_state = 0;
#ifdef VAR_RANGES
		logval("m_state", ((int)now.m_state));
#endif
		;
		/* merge: m_session = 0(153, 141, 153) */
		reached[0][141] = 1;
		(trpt+1)->bup.ovals[2] = ((int)now.m_session);
		now.m_session = 0;
#ifdef VAR_RANGES
		logval("m_session", ((int)now.m_session));
#endif
		;
		/* merge: m_sessions = m_boot(153, 142, 153) */
		reached[0][142] = 1;
		(trpt+1)->bup.ovals[3] = ((int)now.m_sessions);
		now.m_sessions = ((int)now.m_boot);
#ifdef VAR_RANGES
		logval("m_sessions", ((int)now.m_sessions));
#endif
		;
		/* merge: m_nonce = 0(153, 143, 153) */
		reached[0][143] = 1;
		(trpt+1)->bup.ovals[4] = ((int)now.m_nonce);
		now.m_nonce = 0;
#ifdef VAR_RANGES
		logval("m_nonce", ((int)now.m_nonce));
#endif
		;
		/* merge: m_next = 0(153, 144, 153) */
		reached[0][144] = 1;
		(trpt+1)->bup.ovals[5] = ((int)now.m_next);
		now.m_next = 0;
#ifdef VAR_RANGES
		logval("m_next", ((int)now.m_next));
#endif
		;
		/* merge: m_executed = 0(153, 145, 153) */
		reached[0][145] = 1;
		(trpt+1)->bup.ovals[6] = ((int)now.m_executed);
		now.m_executed = 0;
#ifdef VAR_RANGES
		logval("m_executed", ((int)now.m_executed));
#endif
		;
		/* merge: m_opened = 0(153, 146, 153) */
		reached[0][146] = 1;
		(trpt+1)->bup.ovals[7] = ((int)now.m_opened);
		now.m_opened = 0;
#ifdef VAR_RANGES
		logval("m_opened", ((int)now.m_opened));
#endif
		;
		/* merge: m_ended = 0(153, 147, 153) */
		reached[0][147] = 1;
		(trpt+1)->bup.ovals[8] = ((int)now.m_ended);
		now.m_ended = 0;
#ifdef VAR_RANGES
		logval("m_ended", ((int)now.m_ended));
#endif
		;
		/* merge: in_job = 0(153, 148, 153) */
		reached[0][148] = 1;
		(trpt+1)->bup.ovals[9] = ((int)now.in_job);
		now.in_job = 0;
#ifdef VAR_RANGES
		logval("in_job", ((int)now.in_job));
#endif
		;
		/* merge: due_welcome = 0(153, 149, 153) */
		reached[0][149] = 1;
		(trpt+1)->bup.ovals[10] = ((int)now.due_welcome);
		now.due_welcome = 0;
#ifdef VAR_RANGES
		logval("due_welcome", ((int)now.due_welcome));
#endif
		;
		/* merge: due_ack = 0(153, 150, 153) */
		reached[0][150] = 1;
		(trpt+1)->bup.ovals[11] = ((int)now.due_ack);
		now.due_ack = 0;
#ifdef VAR_RANGES
		logval("due_ack", ((int)now.due_ack));
#endif
		;
		/* merge: due_report = 0(153, 151, 153) */
		reached[0][151] = 1;
		(trpt+1)->bup.ovals[12] = ((int)now.due_report);
		now.due_report = 0;
#ifdef VAR_RANGES
		logval("due_report", ((int)now.due_report));
#endif
		;
		/* merge: .(goto)(0, 154, 153) */
		reached[0][154] = 1;
		;
		_m = 3; goto P999; /* 13 */
	case 122: // STATE 156 - session.pml:199 - [-end-] (0:0:0 - 1)
		IfNotBlocked
		reached[0][156] = 1;
		if (!delproc(1, II)) continue;
		_m = 3; goto P999; /* 0 */
	case  _T5:	/* np_ */
		if (!((!(trpt->o_pm&4) && !(trpt->tau&128))))
			continue;
		/* else fall through */
	case  _T2:	/* true */
		_m = 3; goto P999;
#undef rand
	}

