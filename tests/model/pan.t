#ifdef PEG
struct T_SRC {
	char *fl; int ln;
} T_SRC[NTRANS];

void
tr_2_src(int m, char *file, int ln)
{	T_SRC[m].fl = file;
	T_SRC[m].ln = ln;
}

void
putpeg(int n, int m)
{	printf("%5d	trans %4d ", m, n);
	printf("%s:%d\n",
		T_SRC[n].fl, T_SRC[n].ln);
}
#endif

void
settable(void)
{	Trans *T;
	Trans *settr(int, int, int, int, int, char *, int, int, int);

	trans = (Trans ***) emalloc(4*sizeof(Trans **));

	/* proctype 2: ends */

	trans[2] = (Trans **) emalloc(7*sizeof(Trans *));

	trans[2][4]	= settr(347,0,3,1,0,".(goto)", 0, 2, 0);
	T = trans[2][3] = settr(346,0,0,0,0,"DO", 0, 2, 0);
	    T->nxt	= settr(346,0,1,0,0,"DO", 0, 2, 0);
	trans[2][1]	= settr(344,0,3,3,0,"(!(((h_phase==4)||(h_phase==5))))", 1, 2, 0);
	trans[2][2]	= settr(345,0,3,1,0,"goto T0_init", 0, 2, 0);
	trans[2][5]	= settr(348,0,6,1,0,"break", 0, 2, 0);
	trans[2][6]	= settr(349,0,0,4,4,"-end-", 0, 3500, 0);

	/* proctype 1: host */

	trans[1] = (Trans **) emalloc(189*sizeof(Trans *));

	T = trans[ 1][8] = settr(163,2,0,0,0,"ATOMIC", 1, 2, 0);
	T->nxt	= settr(163,2,7,0,0,"ATOMIC", 1, 2, 0);
	T = trans[ 1][7] = settr(162,0,0,0,0,"sub-sequence", 1, 2, 0);
	T->nxt	= settr(162,0,1,0,0,"sub-sequence", 1, 2, 0);
	trans[1][1]	= settr(156,0,185,5,5,"h_phase = 0", 1, 2, 0); /* m: 2 -> 0,185 */
	reached1[2] = 1;
	trans[1][2]	= settr(0,0,0,0,0,"h_session = 0",0,0,0);
	trans[1][3]	= settr(0,0,0,0,0,"h_sent = 0",0,0,0);
	trans[1][4]	= settr(0,0,0,0,0,"h_end_sent = 0",0,0,0);
	trans[1][5]	= settr(0,0,0,0,0,"nonces = (nonces+1)",0,0,0);
	trans[1][6]	= settr(0,0,0,0,0,"h_nonce = nonces",0,0,0);
	trans[1][186]	= settr(341,0,185,1,0,".(goto)", 0, 2, 0);
	T = trans[1][185] = settr(340,0,0,0,0,"DO", 0, 2, 0);
	T = T->nxt	= settr(340,0,74,0,0,"DO", 0, 2, 0);
	T = T->nxt	= settr(340,0,87,0,0,"DO", 0, 2, 0);
	T = T->nxt	= settr(340,0,101,0,0,"DO", 0, 2, 0);
	T = T->nxt	= settr(340,0,114,0,0,"DO", 0, 2, 0);
	T = T->nxt	= settr(340,0,127,0,0,"DO", 0, 2, 0);
	T = T->nxt	= settr(340,0,140,0,0,"DO", 0, 2, 0);
	T = T->nxt	= settr(340,0,143,0,0,"DO", 0, 2, 0);
	T = T->nxt	= settr(340,0,157,0,0,"DO", 0, 2, 0);
	T = T->nxt	= settr(340,0,166,0,0,"DO", 0, 2, 0);
	T = T->nxt	= settr(340,0,182,0,0,"DO", 0, 2, 0);
	    T->nxt	= settr(340,0,183,0,0,"DO", 0, 2, 0);
	T = trans[ 1][74] = settr(229,2,0,0,0,"ATOMIC", 1, 2, 0);
	T->nxt	= settr(229,2,9,0,0,"ATOMIC", 1, 504, 0);
	trans[1][9]	= settr(164,2,65,6,6,"to_host?what,session,nonce,next,state,boot", 1, 504, 0); /* m: 10 -> 65,0 */
	reached1[10] = 1;
	trans[1][10]	= settr(0,0,0,0,0,"opened = (state>=128)",0,0,0);
	trans[1][11]	= settr(0,0,0,0,0,"state = (state%128)",0,0,0);
	T = trans[1][65] = settr(220,2,0,0,0,"IF", 1, 504, 0);
	T = T->nxt	= settr(220,2,12,0,0,"IF", 1, 504, 0);
	T = T->nxt	= settr(220,2,33,0,0,"IF", 1, 504, 0);
	T = T->nxt	= settr(220,2,61,0,0,"IF", 1, 504, 0);
	    T->nxt	= settr(220,2,64,0,0,"IF", 1, 504, 0);
	trans[1][12]	= settr(167,2,32,7,7,"((((what==WELCOME)&&(h_phase==0))&&(nonce==h_nonce)))", 1, 504, 0); /* m: 13 -> 32,0 */
	reached1[13] = 1;
	trans[1][13]	= settr(0,0,0,0,0,"h_session = session",0,0,0);
	T = trans[ 1][32] = settr(187,0,0,0,0,"sub-sequence", 1, 504, 0);
	T->nxt	= settr(187,0,14,0,0,"sub-sequence", 1, 504, 0);
	trans[1][14]	= settr(169,2,29,8,8,"h_sent = 0", 1, 504, 0);
	T = trans[1][29] = settr(184,2,0,0,0,"IF", 1, 504, 0);
	T = T->nxt	= settr(184,2,15,0,0,"IF", 1, 504, 0);
	    T->nxt	= settr(184,2,17,0,0,"IF", 1, 504, 0);
	trans[1][15]	= settr(170,0,185,9,9,"((h_opened&&(((state/16)==0)||((boot!=h_boot)&&(0!=4)))))", 1, 504, 0); /* m: 16 -> 185,0 */
	reached1[16] = 1;
	trans[1][16]	= settr(0,0,0,0,0,"h_phase = 5",0,0,0);
	trans[1][30]	= settr(185,2,31,1,0,".(goto)", 1, 504, 0); /* m: 31 -> 0,185 */
	reached1[31] = 1;
	trans[1][17]	= settr(172,2,27,2,0,"else", 1, 504, 0);
	T = trans[1][27] = settr(182,2,0,0,0,"IF", 1, 504, 0);
	T = T->nxt	= settr(182,2,18,0,0,"IF", 1, 504, 0);
	    T->nxt	= settr(182,2,20,0,0,"IF", 1, 504, 0);
	trans[1][18]	= settr(173,0,185,10,10,"(((state/16)==0))", 1, 504, 0); /* m: 19 -> 185,0 */
	reached1[19] = 1;
	trans[1][19]	= settr(0,0,0,0,0,"h_phase = 1",0,0,0);
	trans[1][28]	= settr(183,2,31,1,0,".(goto)", 1, 504, 0); /* m: 31 -> 0,185 */
	reached1[31] = 1;
	trans[1][20]	= settr(175,2,21,2,0,"else", 1, 504, 0);
	trans[1][21]	= settr(176,0,185,11,11,"h_phase = 2", 1, 504, 0); /* m: 22 -> 0,185 */
	reached1[22] = 1;
	trans[1][22]	= settr(0,0,0,0,0,"h_opened = 1",0,0,0);
	trans[1][23]	= settr(0,0,0,0,0,"h_base = next",0,0,0);
	trans[1][24]	= settr(0,0,0,0,0,"h_send = next",0,0,0);
	trans[1][25]	= settr(0,0,0,0,0,"h_limit = (state%16)",0,0,0);
	trans[1][26]	= settr(0,0,0,0,0,"h_end_sent = 0",0,0,0);
	trans[1][31]	= settr(186,0,185,12,12,"h_boot = boot", 1, 504, 0); /* m: 67 -> 0,185 */
	reached1[67] = 1;
	trans[1][66]	= settr(221,2,67,1,0,".(goto)", 1, 504, 0); /* m: 67 -> 0,185 */
	reached1[67] = 1;
	trans[1][33]	= settr(188,2,60,13,13,"((((what==ACK)&&(h_phase!=0))&&((session==h_session)||(0==1))))", 1, 504, 0);
	T = trans[ 1][60] = settr(215,0,0,0,0,"sub-sequence", 1, 504, 0);
	T->nxt	= settr(215,0,58,0,0,"sub-sequence", 1, 504, 0);
	T = trans[1][58] = settr(213,2,0,0,0,"IF", 1, 504, 0);
	T = T->nxt	= settr(213,2,34,0,0,"IF", 1, 504, 0);
	T = T->nxt	= settr(213,2,41,0,0,"IF", 1, 504, 0);
	T = T->nxt	= settr(213,2,55,0,0,"IF", 1, 504, 0);
	    T->nxt	= settr(213,2,57,0,0,"IF", 1, 504, 0);
	trans[1][34]	= settr(189,0,185,14,14,"((((h_phase==1)&&h_sent)&&opened))", 1, 504, 0); /* m: 35 -> 185,0 */
	reached1[35] = 1;
	trans[1][35]	= settr(0,0,0,0,0,"h_phase = 2",0,0,0);
	trans[1][36]	= settr(0,0,0,0,0,"h_opened = 1",0,0,0);
	trans[1][37]	= settr(0,0,0,0,0,"h_base = next",0,0,0);
	trans[1][38]	= settr(0,0,0,0,0,"h_send = next",0,0,0);
	trans[1][39]	= settr(0,0,0,0,0,"h_limit = (state%16)",0,0,0);
	trans[1][40]	= settr(0,0,0,0,0,"h_end_sent = 0",0,0,0);
	trans[1][59]	= settr(214,2,67,1,0,".(goto)", 1, 504, 0); /* m: 67 -> 0,185 */
	reached1[67] = 1;
	trans[1][41]	= settr(196,2,46,15,15,"(((h_phase==2)&&(next>=h_base)))", 1, 504, 0); /* m: 42 -> 46,0 */
	reached1[42] = 1;
	trans[1][42]	= settr(0,0,0,0,0,"h_base = next",0,0,0);
	T = trans[1][46] = settr(201,2,0,0,0,"IF", 1, 504, 0);
	T = T->nxt	= settr(201,2,43,0,0,"IF", 1, 504, 0);
	    T->nxt	= settr(201,2,45,0,0,"IF", 1, 504, 0);
	trans[1][43]	= settr(198,2,53,16,16,"((h_send<next))", 1, 504, 0); /* m: 44 -> 53,0 */
	reached1[44] = 1;
	trans[1][44]	= settr(0,0,0,0,0,"h_send = next",0,0,0);
	trans[1][47]	= settr(202,2,53,1,0,".(goto)", 1, 504, 0);
	trans[1][45]	= settr(200,2,53,2,0,"else", 1, 504, 0);
	T = trans[1][53] = settr(208,2,0,0,0,"IF", 1, 504, 0);
	T = T->nxt	= settr(208,2,48,0,0,"IF", 1, 504, 0);
	T = T->nxt	= settr(208,2,50,0,0,"IF", 1, 504, 0);
	    T->nxt	= settr(208,2,52,0,0,"IF", 1, 504, 0);
	trans[1][48]	= settr(203,0,185,17,17,"((0==3))", 1, 504, 0); /* m: 49 -> 185,0 */
	reached1[49] = 1;
	trans[1][49]	= settr(0,0,0,0,0,"h_limit = (h_limit+1)",0,0,0);
	trans[1][54]	= settr(209,2,67,1,0,".(goto)", 1, 504, 0); /* m: 67 -> 0,185 */
	reached1[67] = 1;
	trans[1][50]	= settr(205,0,185,18,18,"(((0!=3)&&((state%16)>h_limit)))", 1, 504, 0); /* m: 51 -> 185,0 */
	reached1[51] = 1;
	trans[1][51]	= settr(0,0,0,0,0,"h_limit = (state%16)",0,0,0);
	trans[1][52]	= settr(207,2,67,2,0,"else", 1, 504, 0);
	trans[1][55]	= settr(210,0,185,19,19,"(((h_phase==3)&&((state/16)==0)))", 1, 504, 0); /* m: 56 -> 185,0 */
	reached1[56] = 1;
	trans[1][56]	= settr(0,0,0,0,0,"h_phase = 4",0,0,0);
	trans[1][57]	= settr(212,2,67,2,0,"else", 1, 504, 0);
	trans[1][61]	= settr(216,0,185,20,20,"((((what==REPORT)&&(h_phase==2))&&(session==h_session)))", 1, 504, 0); /* m: 62 -> 185,0 */
	reached1[62] = 1;
	trans[1][62]	= settr(0,0,0,0,0,"h_phase = 3",0,0,0);
	trans[1][63]	= settr(0,0,0,0,0,"h_sent = 0",0,0,0);
	trans[1][64]	= settr(219,2,67,2,0,"else", 1, 504, 0);
	trans[1][67]	= settr(222,0,185,21,21,"what = HELLO", 1, 504, 0); /* m: 68 -> 0,185 */
	reached1[68] = 1;
	trans[1][68]	= settr(0,0,0,0,0,"session = 0",0,0,0);
	trans[1][69]	= settr(0,0,0,0,0,"nonce = 0",0,0,0);
	trans[1][70]	= settr(0,0,0,0,0,"next = 0",0,0,0);
	trans[1][71]	= settr(0,0,0,0,0,"state = 0",0,0,0);
	trans[1][72]	= settr(0,0,0,0,0,"boot = 0",0,0,0);
	trans[1][73]	= settr(0,0,0,0,0,"opened = 0",0,0,0);
	T = trans[ 1][87] = settr(242,2,0,0,0,"ATOMIC", 1, 2, 0);
	T->nxt	= settr(242,2,75,0,0,"ATOMIC", 1, 3, 0);
	trans[1][75]	= settr(230,2,86,22,22,"((((h_phase==0)&&!(h_sent))&&nfull(to_machine)))", 1, 3, 0); /* m: 76 -> 86,0 */
	reached1[76] = 1;
	trans[1][76]	= settr(0,0,0,0,0,"h_sent = 1",0,0,0);
	T = trans[ 1][86] = settr(241,0,0,0,0,"sub-sequence", 1, 3, 0);
	T->nxt	= settr(241,0,84,0,0,"sub-sequence", 1, 3, 0);
	T = trans[1][84] = settr(239,2,0,0,0,"IF", 1, 3, 0);
	T = T->nxt	= settr(239,2,77,0,0,"IF", 1, 3, 0);
	T = T->nxt	= settr(239,2,78,0,0,"IF", 1, 3, 0);
	    T->nxt	= settr(239,2,80,0,0,"IF", 1, 3, 0);
	trans[1][77]	= settr(232,0,185,23,23,"to_machine!9,0,h_nonce,0", 1, 3, 0); /* m: 85 -> 185,0 */
	reached1[85] = 1;
	trans[1][85]	= settr(240,0,185,24,24,".(goto)", 1, 3, 0);
	trans[1][78]	= settr(233,0,185,25,25,"((faults>0))", 1, 3, 0); /* m: 79 -> 185,0 */
	reached1[79] = 1;
	trans[1][79]	= settr(0,0,0,0,0,"faults = (faults-1)",0,0,0);
	trans[1][80]	= settr(235,2,82,26,26,"(((faults>0)&&(len(to_machine)<(3-1))))", 1, 3, 0); /* m: 81 -> 82,0 */
	reached1[81] = 1;
	trans[1][81]	= settr(0,0,0,0,0,"faults = (faults-1)",0,0,0);
	trans[1][82]	= settr(237,2,83,27,27,"to_machine!9,0,h_nonce,0", 1, 3, 0);
	trans[1][83]	= settr(238,0,185,28,28,"to_machine!9,0,h_nonce,0", 1, 3, 0); /* m: 85 -> 185,0 */
	reached1[85] = 1;
	T = trans[ 1][101] = settr(256,2,0,0,0,"ATOMIC", 1, 2, 0);
	T->nxt	= settr(256,2,88,0,0,"ATOMIC", 1, 3, 0);
	trans[1][88]	= settr(243,2,100,29,29,"((((h_phase==1)&&!(h_sent))&&nfull(to_machine)))", 1, 3, 0); /* m: 89 -> 100,0 */
	reached1[89] = 1;
	trans[1][89]	= settr(0,0,0,0,0,"h_sent = 1",0,0,0);
	trans[1][90]	= settr(0,0,0,0,0,"h_asked = 1",0,0,0);
	T = trans[ 1][100] = settr(255,0,0,0,0,"sub-sequence", 1, 3, 0);
	T->nxt	= settr(255,0,98,0,0,"sub-sequence", 1, 3, 0);
	T = trans[1][98] = settr(253,2,0,0,0,"IF", 1, 3, 0);
	T = T->nxt	= settr(253,2,91,0,0,"IF", 1, 3, 0);
	T = T->nxt	= settr(253,2,92,0,0,"IF", 1, 3, 0);
	    T->nxt	= settr(253,2,94,0,0,"IF", 1, 3, 0);
	trans[1][91]	= settr(246,0,185,30,30,"to_machine!8,h_session,h_nonce,0", 1, 3, 0); /* m: 99 -> 185,0 */
	reached1[99] = 1;
	trans[1][99]	= settr(254,0,185,31,31,".(goto)", 1, 3, 0);
	trans[1][92]	= settr(247,0,185,32,32,"((faults>0))", 1, 3, 0); /* m: 93 -> 185,0 */
	reached1[93] = 1;
	trans[1][93]	= settr(0,0,0,0,0,"faults = (faults-1)",0,0,0);
	trans[1][94]	= settr(249,2,96,33,33,"(((faults>0)&&(len(to_machine)<(3-1))))", 1, 3, 0); /* m: 95 -> 96,0 */
	reached1[95] = 1;
	trans[1][95]	= settr(0,0,0,0,0,"faults = (faults-1)",0,0,0);
	trans[1][96]	= settr(251,2,97,34,34,"to_machine!8,h_session,h_nonce,0", 1, 3, 0);
	trans[1][97]	= settr(252,0,185,35,35,"to_machine!8,h_session,h_nonce,0", 1, 3, 0); /* m: 99 -> 185,0 */
	reached1[99] = 1;
	T = trans[ 1][114] = settr(269,2,0,0,0,"ATOMIC", 1, 2, 0);
	T->nxt	= settr(269,2,102,0,0,"ATOMIC", 1, 3, 0);
	trans[1][102]	= settr(257,2,113,36,36,"((((h_phase==3)&&!(h_sent))&&nfull(to_machine)))", 1, 3, 0); /* m: 103 -> 113,0 */
	reached1[103] = 1;
	trans[1][103]	= settr(0,0,0,0,0,"h_sent = 1",0,0,0);
	T = trans[ 1][113] = settr(268,0,0,0,0,"sub-sequence", 1, 3, 0);
	T->nxt	= settr(268,0,111,0,0,"sub-sequence", 1, 3, 0);
	T = trans[1][111] = settr(266,2,0,0,0,"IF", 1, 3, 0);
	T = T->nxt	= settr(266,2,104,0,0,"IF", 1, 3, 0);
	T = T->nxt	= settr(266,2,105,0,0,"IF", 1, 3, 0);
	    T->nxt	= settr(266,2,107,0,0,"IF", 1, 3, 0);
	trans[1][104]	= settr(259,0,185,37,37,"to_machine!4,h_session,0,0", 1, 3, 0); /* m: 112 -> 185,0 */
	reached1[112] = 1;
	trans[1][112]	= settr(267,0,185,38,38,".(goto)", 1, 3, 0);
	trans[1][105]	= settr(260,0,185,39,39,"((faults>0))", 1, 3, 0); /* m: 106 -> 185,0 */
	reached1[106] = 1;
	trans[1][106]	= settr(0,0,0,0,0,"faults = (faults-1)",0,0,0);
	trans[1][107]	= settr(262,2,109,40,40,"(((faults>0)&&(len(to_machine)<(3-1))))", 1, 3, 0); /* m: 108 -> 109,0 */
	reached1[108] = 1;
	trans[1][108]	= settr(0,0,0,0,0,"faults = (faults-1)",0,0,0);
	trans[1][109]	= settr(264,2,110,41,41,"to_machine!4,h_session,0,0", 1, 3, 0);
	trans[1][110]	= settr(265,0,185,42,42,"to_machine!4,h_session,0,0", 1, 3, 0); /* m: 112 -> 185,0 */
	reached1[112] = 1;
	T = trans[ 1][127] = settr(282,2,0,0,0,"ATOMIC", 1, 2, 0);
	T->nxt	= settr(282,2,115,0,0,"ATOMIC", 1, 3, 0);
	trans[1][115]	= settr(270,2,125,43,0,"((((((h_phase==2)&&(h_send<2))&&(h_send<h_limit))&&(h_send<(h_base+2)))&&nfull(to_machine)))", 1, 3, 0);
	T = trans[ 1][125] = settr(280,0,0,0,0,"sub-sequence", 1, 3, 0);
	T->nxt	= settr(280,0,123,0,0,"sub-sequence", 1, 3, 0);
	T = trans[1][123] = settr(278,2,0,0,0,"IF", 1, 3, 0);
	T = T->nxt	= settr(278,2,116,0,0,"IF", 1, 3, 0);
	T = T->nxt	= settr(278,2,117,0,0,"IF", 1, 3, 0);
	    T->nxt	= settr(278,2,119,0,0,"IF", 1, 3, 0);
	trans[1][116]	= settr(271,0,185,44,44,"to_machine!7,h_session,(h_send%4),h_send", 1, 3, 0); /* m: 124 -> 185,0 */
	reached1[124] = 1;
	trans[1][124]	= settr(279,0,185,45,45,".(goto)", 1, 3, 0); /* m: 126 -> 0,185 */
	reached1[126] = 1;
	trans[1][117]	= settr(272,0,185,46,46,"((faults>0))", 1, 3, 0); /* m: 118 -> 185,0 */
	reached1[118] = 1;
	trans[1][118]	= settr(0,0,0,0,0,"faults = (faults-1)",0,0,0);
	trans[1][119]	= settr(274,2,121,47,47,"(((faults>0)&&(len(to_machine)<(3-1))))", 1, 3, 0); /* m: 120 -> 121,0 */
	reached1[120] = 1;
	trans[1][120]	= settr(0,0,0,0,0,"faults = (faults-1)",0,0,0);
	trans[1][121]	= settr(276,2,122,48,48,"to_machine!7,h_session,(h_send%4),h_send", 1, 3, 0);
	trans[1][122]	= settr(277,0,185,49,49,"to_machine!7,h_session,(h_send%4),h_send", 1, 3, 0); /* m: 124 -> 185,0 */
	reached1[124] = 1;
	trans[1][126]	= settr(0,0,0,0,0,"h_send = (h_send+1)",0,0,0);
	T = trans[ 1][140] = settr(295,2,0,0,0,"ATOMIC", 1, 2, 0);
	T->nxt	= settr(295,2,128,0,0,"ATOMIC", 1, 3, 0);
	trans[1][128]	= settr(283,2,139,50,50,"((((((h_phase==2)&&(h_send==2))&&(h_base==2))&&!(h_end_sent))&&nfull(to_machine)))", 1, 3, 0); /* m: 129 -> 139,0 */
	reached1[129] = 1;
	trans[1][129]	= settr(0,0,0,0,0,"h_end_sent = 1",0,0,0);
	T = trans[ 1][139] = settr(294,0,0,0,0,"sub-sequence", 1, 3, 0);
	T->nxt	= settr(294,0,137,0,0,"sub-sequence", 1, 3, 0);
	T = trans[1][137] = settr(292,2,0,0,0,"IF", 1, 3, 0);
	T = T->nxt	= settr(292,2,130,0,0,"IF", 1, 3, 0);
	T = T->nxt	= settr(292,2,131,0,0,"IF", 1, 3, 0);
	    T->nxt	= settr(292,2,133,0,0,"IF", 1, 3, 0);
	trans[1][130]	= settr(285,0,185,51,51,"to_machine!6,h_session,2,0", 1, 3, 0); /* m: 138 -> 185,0 */
	reached1[138] = 1;
	trans[1][138]	= settr(293,0,185,52,52,".(goto)", 1, 3, 0);
	trans[1][131]	= settr(286,0,185,53,53,"((faults>0))", 1, 3, 0); /* m: 132 -> 185,0 */
	reached1[132] = 1;
	trans[1][132]	= settr(0,0,0,0,0,"faults = (faults-1)",0,0,0);
	trans[1][133]	= settr(288,2,135,54,54,"(((faults>0)&&(len(to_machine)<(3-1))))", 1, 3, 0); /* m: 134 -> 135,0 */
	reached1[134] = 1;
	trans[1][134]	= settr(0,0,0,0,0,"faults = (faults-1)",0,0,0);
	trans[1][135]	= settr(290,2,136,55,55,"to_machine!6,h_session,2,0", 1, 3, 0);
	trans[1][136]	= settr(291,0,185,56,56,"to_machine!6,h_session,2,0", 1, 3, 0); /* m: 138 -> 185,0 */
	reached1[138] = 1;
	T = trans[ 1][143] = settr(298,2,0,0,0,"ATOMIC", 1, 2, 0);
	T->nxt	= settr(298,2,141,0,0,"ATOMIC", 1, 3000, 0);
	trans[1][141]	= settr(296,0,185,57,57,"((((timeout&&!(((h_phase==4)||(h_phase==5))))&&(((h_phase==0)||(h_phase==1))||(h_phase==3)))&&h_sent))", 1, 3000, 0); /* m: 142 -> 185,0 */
	reached1[142] = 1;
	trans[1][142]	= settr(0,0,0,0,0,"h_sent = 0",0,0,0);
	T = trans[ 1][157] = settr(312,2,0,0,0,"ATOMIC", 1, 2, 0);
	T->nxt	= settr(312,2,144,0,0,"ATOMIC", 1, 3000, 3);
	trans[1][144]	= settr(299,2,156,58,58,"(((timeout&&(h_phase==2))&&nfull(to_machine)))", 1, 3000, 3); /* m: 145 -> 156,0 */
	reached1[145] = 1;
	trans[1][145]	= settr(0,0,0,0,0,"h_send = h_base",0,0,0);
	trans[1][146]	= settr(0,0,0,0,0,"h_end_sent = 0",0,0,0);
	T = trans[ 1][156] = settr(311,0,0,0,0,"sub-sequence", 1, 3000, 3);
	T->nxt	= settr(311,0,154,0,0,"sub-sequence", 1, 3000, 3);
	T = trans[1][154] = settr(309,2,0,0,0,"IF", 1, 3000, 3);
	T = T->nxt	= settr(309,2,147,0,0,"IF", 1, 3000, 3);
	T = T->nxt	= settr(309,2,148,0,0,"IF", 1, 3000, 3);
	    T->nxt	= settr(309,2,150,0,0,"IF", 1, 3000, 3);
	trans[1][147]	= settr(302,0,185,59,59,"to_machine!5,h_session,0,0", 1, 3000, 3); /* m: 155 -> 185,0 */
	reached1[155] = 1;
	trans[1][155]	= settr(310,0,185,60,60,".(goto)", 1, 3000, 3);
	trans[1][148]	= settr(303,0,185,61,61,"((faults>0))", 1, 3000, 3); /* m: 149 -> 185,0 */
	reached1[149] = 1;
	trans[1][149]	= settr(0,0,0,0,0,"faults = (faults-1)",0,0,0);
	trans[1][150]	= settr(305,2,152,62,62,"(((faults>0)&&(len(to_machine)<(3-1))))", 1, 3000, 3); /* m: 151 -> 152,0 */
	reached1[151] = 1;
	trans[1][151]	= settr(0,0,0,0,0,"faults = (faults-1)",0,0,0);
	trans[1][152]	= settr(307,2,153,63,63,"to_machine!5,h_session,0,0", 1, 3000, 3);
	trans[1][153]	= settr(308,0,185,64,64,"to_machine!5,h_session,0,0", 1, 3000, 3); /* m: 155 -> 185,0 */
	reached1[155] = 1;
	T = trans[ 1][166] = settr(321,2,0,0,0,"ATOMIC", 1, 2, 0);
	T->nxt	= settr(321,2,158,0,0,"ATOMIC", 1, 3000, 0);
	trans[1][158]	= settr(313,2,165,65,0,"(((timeout&&((h_phase==1)||(h_phase==2)))&&(nonces<6)))", 1, 3000, 0);
	T = trans[ 1][165] = settr(320,0,0,0,0,"sub-sequence", 1, 3000, 0);
	T->nxt	= settr(320,0,159,0,0,"sub-sequence", 1, 3000, 0);
	trans[1][159]	= settr(314,0,185,66,66,"h_phase = 0", 1, 3000, 0); /* m: 160 -> 0,185 */
	reached1[160] = 1;
	trans[1][160]	= settr(0,0,0,0,0,"h_session = 0",0,0,0);
	trans[1][161]	= settr(0,0,0,0,0,"h_sent = 0",0,0,0);
	trans[1][162]	= settr(0,0,0,0,0,"h_end_sent = 0",0,0,0);
	trans[1][163]	= settr(0,0,0,0,0,"nonces = (nonces+1)",0,0,0);
	trans[1][164]	= settr(0,0,0,0,0,"h_nonce = nonces",0,0,0);
	T = trans[ 1][182] = settr(337,2,0,0,0,"ATOMIC", 1, 2, 0);
	T->nxt	= settr(337,2,167,0,0,"ATOMIC", 1, 2, 0);
	trans[1][167]	= settr(322,2,181,67,67,"((((deaths>0)&&(h_phase<3))&&!(distrusted)))", 1, 2, 0); /* m: 168 -> 181,0 */
	reached1[168] = 1;
	trans[1][168]	= settr(0,0,0,0,0,"deaths = (deaths-1)",0,0,0);
	trans[1][169]	= settr(0,0,0,0,0,"h_opened = 0",0,0,0);
	trans[1][170]	= settr(0,0,0,0,0,"h_asked = 0",0,0,0);
	trans[1][171]	= settr(0,0,0,0,0,"h_base = 0",0,0,0);
	trans[1][172]	= settr(0,0,0,0,0,"h_send = 0",0,0,0);
	trans[1][173]	= settr(0,0,0,0,0,"h_limit = 0",0,0,0);
	trans[1][174]	= settr(0,0,0,0,0,"h_boot = 0",0,0,0);
	T = trans[ 1][181] = settr(336,0,0,0,0,"sub-sequence", 1, 2, 0);
	T->nxt	= settr(336,0,175,0,0,"sub-sequence", 1, 2, 0);
	trans[1][175]	= settr(330,0,185,68,68,"h_phase = 0", 1, 2, 0); /* m: 176 -> 0,185 */
	reached1[176] = 1;
	trans[1][176]	= settr(0,0,0,0,0,"h_session = 0",0,0,0);
	trans[1][177]	= settr(0,0,0,0,0,"h_sent = 0",0,0,0);
	trans[1][178]	= settr(0,0,0,0,0,"h_end_sent = 0",0,0,0);
	trans[1][179]	= settr(0,0,0,0,0,"nonces = (nonces+1)",0,0,0);
	trans[1][180]	= settr(0,0,0,0,0,"h_nonce = nonces",0,0,0);
	trans[1][183]	= settr(338,0,188,69,0,"(((h_phase==4)||(h_phase==5)))", 1, 2, 0);
	trans[1][184]	= settr(339,0,188,1,0,"goto :b1", 0, 2, 0);
	trans[1][187]	= settr(342,0,188,1,0,"break", 0, 2, 0);
	trans[1][188]	= settr(343,0,0,70,70,"-end-", 0, 3500, 0);

	/* proctype 0: machine */

	trans[0] = (Trans **) emalloc(157*sizeof(Trans *));

	trans[0][154]	= settr(153,0,153,1,0,".(goto)", 0, 2, 0);
	T = trans[0][153] = settr(152,0,0,0,0,"DO", 0, 2, 0);
	T = T->nxt	= settr(152,0,74,0,0,"DO", 0, 2, 0);
	T = T->nxt	= settr(152,0,87,0,0,"DO", 0, 2, 0);
	T = T->nxt	= settr(152,0,100,0,0,"DO", 0, 2, 0);
	T = T->nxt	= settr(152,0,113,0,0,"DO", 0, 2, 0);
	T = T->nxt	= settr(152,0,122,0,0,"DO", 0, 2, 0);
	T = T->nxt	= settr(152,0,131,0,0,"DO", 0, 2, 0);
	    T->nxt	= settr(152,0,152,0,0,"DO", 0, 2, 0);
	T = trans[ 0][74] = settr(73,2,0,0,0,"ATOMIC", 1, 2, 0);
	T->nxt	= settr(73,2,1,0,0,"ATOMIC", 1, 503, 0);
	trans[0][1]	= settr(0,2,68,71,71,"to_machine?what,session,number,item", 1, 503, 0);
	T = trans[0][68] = settr(67,2,0,0,0,"IF", 1, 503, 0);
	T = T->nxt	= settr(67,2,2,0,0,"IF", 1, 503, 0);
	T = T->nxt	= settr(67,2,14,0,0,"IF", 1, 503, 0);
	    T->nxt	= settr(67,2,67,0,0,"IF", 1, 503, 0);
	trans[0][2]	= settr(1,2,13,72,72,"((what==HELLO))", 1, 503, 0);
	T = trans[ 0][13] = settr(12,0,0,0,0,"sub-sequence", 1, 503, 0);
	T->nxt	= settr(12,0,8,0,0,"sub-sequence", 1, 503, 0);
	T = trans[0][8] = settr(7,2,0,0,0,"IF", 1, 503, 0);
	T = T->nxt	= settr(7,2,3,0,0,"IF", 1, 503, 0);
	    T->nxt	= settr(7,2,7,0,0,"IF", 1, 503, 0);
	trans[0][3]	= settr(2,0,153,73,73,"(((m_session==0)||(number!=m_nonce)))", 1, 503, 0); /* m: 4 -> 153,0 */
	reached0[4] = 1;
	trans[0][4]	= settr(0,0,0,0,0,"m_sessions = (m_sessions+1)",0,0,0);
	trans[0][5]	= settr(0,0,0,0,0,"m_session = m_sessions",0,0,0);
	trans[0][6]	= settr(0,0,0,0,0,"m_opened = (m_state==1)",0,0,0);
	trans[0][9]	= settr(8,2,10,1,0,".(goto)", 1, 503, 0); /* m: 10 -> 0,153 */
	reached0[10] = 1;
	trans[0][7]	= settr(6,2,10,2,0,"else", 1, 503, 0);
	trans[0][10]	= settr(9,0,153,74,74,"m_nonce = number", 1, 503, 0); /* m: 11 -> 0,153 */
	reached0[11] = 1;
	trans[0][11]	= settr(0,0,0,0,0,"due_welcome = 1",0,0,0);
	trans[0][12]	= settr(0,0,0,0,0,"due_ack = 0",0,0,0);
	trans[0][69]	= settr(68,2,70,1,0,".(goto)", 1, 503, 0); /* m: 70 -> 0,153 */
	reached0[70] = 1;
	trans[0][14]	= settr(13,2,65,75,75,"((((what!=HELLO)&&(m_session!=0))&&((session==m_session)||((0==1)&&(what==ITEM)))))", 1, 503, 0);
	T = trans[0][65] = settr(64,2,0,0,0,"IF", 1, 503, 0);
	T = T->nxt	= settr(64,2,15,0,0,"IF", 1, 503, 0);
	T = T->nxt	= settr(64,2,32,0,0,"IF", 1, 503, 0);
	T = T->nxt	= settr(64,2,42,0,0,"IF", 1, 503, 0);
	T = T->nxt	= settr(64,2,49,0,0,"IF", 1, 503, 0);
	    T->nxt	= settr(64,2,56,0,0,"IF", 1, 503, 0);
	trans[0][15]	= settr(14,2,31,76,76,"((what==JOB))", 1, 503, 0);
	T = trans[ 0][31] = settr(30,0,0,0,0,"sub-sequence", 1, 503, 0);
	T->nxt	= settr(30,0,29,0,0,"sub-sequence", 1, 503, 0);
	T = trans[0][29] = settr(28,2,0,0,0,"IF", 1, 503, 0);
	T = T->nxt	= settr(28,2,16,0,0,"IF", 1, 503, 0);
	T = T->nxt	= settr(28,2,17,0,0,"IF", 1, 503, 0);
	    T->nxt	= settr(28,2,19,0,0,"IF", 1, 503, 0);
	trans[0][16]	= settr(15,0,153,77,77,"((number!=m_nonce))", 1, 503, 0); /* m: 70 -> 153,0 */
	reached0[70] = 1;
	trans[0][30]	= settr(29,2,70,1,0,".(goto)", 1, 503, 0); /* m: 70 -> 0,153 */
	reached0[70] = 1;
	trans[0][17]	= settr(16,0,153,78,78,"(((number==m_nonce)&&(m_opened||(m_state==2))))", 1, 503, 0); /* m: 18 -> 153,0 */
	reached0[18] = 1;
	trans[0][18]	= settr(0,0,0,0,0,"due_ack = 1",0,0,0);
	trans[0][19]	= settr(18,0,153,79,79,"((((number==m_nonce)&&!(m_opened))&&(m_state==0)))", 1, 503, 0); /* m: 20 -> 153,0 */
	reached0[20] = 1;
	trans[0][20]	= settr(0,0,0,0,0,"assert(!(in_job))",0,0,0);
	trans[0][21]	= settr(0,0,0,0,0,"assert(!(distrusted))",0,0,0);
	trans[0][22]	= settr(0,0,0,0,0,"in_job = 1",0,0,0);
	trans[0][23]	= settr(0,0,0,0,0,"m_state = 1",0,0,0);
	trans[0][24]	= settr(0,0,0,0,0,"m_next = 0",0,0,0);
	trans[0][25]	= settr(0,0,0,0,0,"m_executed = 0",0,0,0);
	trans[0][26]	= settr(0,0,0,0,0,"m_opened = 1",0,0,0);
	trans[0][27]	= settr(0,0,0,0,0,"m_ended = 0",0,0,0);
	trans[0][28]	= settr(0,0,0,0,0,"due_ack = 1",0,0,0);
	trans[0][66]	= settr(65,2,70,1,0,".(goto)", 1, 503, 0); /* m: 70 -> 0,153 */
	reached0[70] = 1;
	trans[0][32]	= settr(31,2,41,80,80,"((what==ITEM))", 1, 503, 0);
	T = trans[ 0][41] = settr(40,0,0,0,0,"sub-sequence", 1, 503, 0);
	T->nxt	= settr(40,0,38,0,0,"sub-sequence", 1, 503, 0);
	T = trans[0][38] = settr(37,2,0,0,0,"IF", 1, 503, 0);
	T = T->nxt	= settr(37,2,33,0,0,"IF", 1, 503, 0);
	    T->nxt	= settr(37,2,37,0,0,"IF", 1, 503, 0);
	trans[0][33]	= settr(32,0,153,81,81,"(((((m_state==1)&&!(m_ended))&&((number==(m_next%4))||((0==2)&&(number==((m_next+1)%4)))))&&((2-(m_next-m_executed))>0)))", 1, 503, 0); /* m: 34 -> 153,0 */
	reached0[34] = 1;
	trans[0][34]	= settr(0,0,0,0,0,"assert((item==m_next))",0,0,0);
	trans[0][35]	= settr(0,0,0,0,0,"assert(!(distrusted))",0,0,0);
	trans[0][36]	= settr(0,0,0,0,0,"m_next = (m_next+1)",0,0,0);
	trans[0][39]	= settr(38,2,40,1,0,".(goto)", 1, 503, 0); /* m: 40 -> 0,153 */
	reached0[40] = 1;
	trans[0][37]	= settr(36,2,40,2,0,"else", 1, 503, 0);
	trans[0][40]	= settr(39,0,153,82,82,"due_ack = 1", 1, 503, 0); /* m: 70 -> 0,153 */
	reached0[70] = 1;
	trans[0][42]	= settr(41,2,46,83,83,"((what==END))", 1, 503, 0);
	T = trans[0][46] = settr(45,2,0,0,0,"IF", 1, 503, 0);
	T = T->nxt	= settr(45,2,43,0,0,"IF", 1, 503, 0);
	    T->nxt	= settr(45,2,45,0,0,"IF", 1, 503, 0);
	trans[0][43]	= settr(42,0,153,84,84,"(((m_state==1)&&(number==m_next)))", 1, 503, 0); /* m: 44 -> 153,0 */
	reached0[44] = 1;
	trans[0][44]	= settr(0,0,0,0,0,"m_ended = 1",0,0,0);
	trans[0][47]	= settr(46,2,48,1,0,".(goto)", 1, 503, 0); /* m: 48 -> 0,153 */
	reached0[48] = 1;
	trans[0][45]	= settr(44,2,48,2,0,"else", 1, 503, 0);
	trans[0][48]	= settr(47,0,153,85,85,"due_ack = 1", 1, 503, 0); /* m: 70 -> 0,153 */
	reached0[70] = 1;
	trans[0][49]	= settr(48,2,54,86,86,"((what==POLL))", 1, 503, 0); /* m: 50 -> 54,0 */
	reached0[50] = 1;
	trans[0][50]	= settr(0,0,0,0,0,"due_ack = 1",0,0,0);
	T = trans[0][54] = settr(53,2,0,0,0,"IF", 1, 503, 0);
	T = T->nxt	= settr(53,2,51,0,0,"IF", 1, 503, 0);
	    T->nxt	= settr(53,2,53,0,0,"IF", 1, 503, 0);
	trans[0][51]	= settr(50,0,153,87,87,"((m_state==2))", 1, 503, 0); /* m: 52 -> 153,0 */
	reached0[52] = 1;
	trans[0][52]	= settr(0,0,0,0,0,"due_report = 1",0,0,0);
	trans[0][55]	= settr(54,2,70,1,0,".(goto)", 1, 503, 0); /* m: 70 -> 0,153 */
	reached0[70] = 1;
	trans[0][53]	= settr(52,2,70,2,0,"else", 1, 503, 0);
	trans[0][56]	= settr(55,2,62,88,88,"((what==CLOSE))", 1, 503, 0);
	T = trans[0][62] = settr(61,2,0,0,0,"IF", 1, 503, 0);
	T = T->nxt	= settr(61,2,57,0,0,"IF", 1, 503, 0);
	    T->nxt	= settr(61,2,61,0,0,"IF", 1, 503, 0);
	trans[0][57]	= settr(56,0,153,89,89,"((m_state==2))", 1, 503, 0); /* m: 58 -> 153,0 */
	reached0[58] = 1;
	trans[0][58]	= settr(0,0,0,0,0,"m_state = 0",0,0,0);
	trans[0][59]	= settr(0,0,0,0,0,"in_job = 0",0,0,0);
	trans[0][60]	= settr(0,0,0,0,0,"due_report = 0",0,0,0);
	trans[0][63]	= settr(62,2,64,1,0,".(goto)", 1, 503, 0); /* m: 64 -> 0,153 */
	reached0[64] = 1;
	trans[0][61]	= settr(60,2,64,2,0,"else", 1, 503, 0);
	trans[0][64]	= settr(63,0,153,90,90,"due_ack = 1", 1, 503, 0); /* m: 70 -> 0,153 */
	reached0[70] = 1;
	trans[0][67]	= settr(66,2,70,2,0,"else", 1, 503, 0);
	trans[0][70]	= settr(69,0,153,91,91,"what = HELLO", 1, 503, 0); /* m: 71 -> 0,153 */
	reached0[71] = 1;
	trans[0][71]	= settr(0,0,0,0,0,"session = 0",0,0,0);
	trans[0][72]	= settr(0,0,0,0,0,"number = 0",0,0,0);
	trans[0][73]	= settr(0,0,0,0,0,"item = 0",0,0,0);
	T = trans[ 0][87] = settr(86,2,0,0,0,"ATOMIC", 1, 2, 0);
	T->nxt	= settr(86,2,75,0,0,"ATOMIC", 1, 4, 0);
	trans[0][75]	= settr(74,2,86,92,92,"((due_welcome&&nfull(to_host)))", 1, 4, 0); /* m: 76 -> 86,0 */
	reached0[76] = 1;
	trans[0][76]	= settr(0,0,0,0,0,"due_welcome = 0",0,0,0);
	T = trans[ 0][86] = settr(85,0,0,0,0,"sub-sequence", 1, 4, 0);
	T->nxt	= settr(85,0,84,0,0,"sub-sequence", 1, 4, 0);
	T = trans[0][84] = settr(83,2,0,0,0,"IF", 1, 4, 0);
	T = T->nxt	= settr(83,2,77,0,0,"IF", 1, 4, 0);
	T = T->nxt	= settr(83,2,78,0,0,"IF", 1, 4, 0);
	    T->nxt	= settr(83,2,80,0,0,"IF", 1, 4, 0);
	trans[0][77]	= settr(76,0,153,93,93,"to_host!3,m_session,m_nonce,m_next,(((m_next+(2-(m_next-m_executed)))+(16*m_state))+(128*m_opened)),m_boot", 1, 4, 0); /* m: 85 -> 153,0 */
	reached0[85] = 1;
	trans[0][85]	= settr(84,0,153,94,94,".(goto)", 1, 4, 0);
	trans[0][78]	= settr(77,0,153,95,95,"((faults>0))", 1, 4, 0); /* m: 79 -> 153,0 */
	reached0[79] = 1;
	trans[0][79]	= settr(0,0,0,0,0,"faults = (faults-1)",0,0,0);
	trans[0][80]	= settr(79,2,82,96,96,"(((faults>0)&&(len(to_host)<(3-1))))", 1, 4, 0); /* m: 81 -> 82,0 */
	reached0[81] = 1;
	trans[0][81]	= settr(0,0,0,0,0,"faults = (faults-1)",0,0,0);
	trans[0][82]	= settr(81,2,83,97,97,"to_host!3,m_session,m_nonce,m_next,(((m_next+(2-(m_next-m_executed)))+(16*m_state))+(128*m_opened)),m_boot", 1, 4, 0);
	trans[0][83]	= settr(82,0,153,98,98,"to_host!3,m_session,m_nonce,m_next,(((m_next+(2-(m_next-m_executed)))+(16*m_state))+(128*m_opened)),m_boot", 1, 4, 0); /* m: 85 -> 153,0 */
	reached0[85] = 1;
	T = trans[ 0][100] = settr(99,2,0,0,0,"ATOMIC", 1, 2, 0);
	T->nxt	= settr(99,2,88,0,0,"ATOMIC", 1, 4, 0);
	trans[0][88]	= settr(87,2,99,99,99,"((((!(due_welcome)&&due_report)&&(m_session!=0))&&nfull(to_host)))", 1, 4, 0); /* m: 89 -> 99,0 */
	reached0[89] = 1;
	trans[0][89]	= settr(0,0,0,0,0,"due_report = 0",0,0,0);
	T = trans[ 0][99] = settr(98,0,0,0,0,"sub-sequence", 1, 4, 0);
	T->nxt	= settr(98,0,97,0,0,"sub-sequence", 1, 4, 0);
	T = trans[0][97] = settr(96,2,0,0,0,"IF", 1, 4, 0);
	T = T->nxt	= settr(96,2,90,0,0,"IF", 1, 4, 0);
	T = T->nxt	= settr(96,2,91,0,0,"IF", 1, 4, 0);
	    T->nxt	= settr(96,2,93,0,0,"IF", 1, 4, 0);
	trans[0][90]	= settr(89,0,153,100,100,"to_host!1,m_session,m_nonce,m_next,(((m_next+(2-(m_next-m_executed)))+(16*m_state))+(128*m_opened)),m_boot", 1, 4, 0); /* m: 98 -> 153,0 */
	reached0[98] = 1;
	trans[0][98]	= settr(97,0,153,101,101,".(goto)", 1, 4, 0);
	trans[0][91]	= settr(90,0,153,102,102,"((faults>0))", 1, 4, 0); /* m: 92 -> 153,0 */
	reached0[92] = 1;
	trans[0][92]	= settr(0,0,0,0,0,"faults = (faults-1)",0,0,0);
	trans[0][93]	= settr(92,2,95,103,103,"(((faults>0)&&(len(to_host)<(3-1))))", 1, 4, 0); /* m: 94 -> 95,0 */
	reached0[94] = 1;
	trans[0][94]	= settr(0,0,0,0,0,"faults = (faults-1)",0,0,0);
	trans[0][95]	= settr(94,2,96,104,104,"to_host!1,m_session,m_nonce,m_next,(((m_next+(2-(m_next-m_executed)))+(16*m_state))+(128*m_opened)),m_boot", 1, 4, 0);
	trans[0][96]	= settr(95,0,153,105,105,"to_host!1,m_session,m_nonce,m_next,(((m_next+(2-(m_next-m_executed)))+(16*m_state))+(128*m_opened)),m_boot", 1, 4, 0); /* m: 98 -> 153,0 */
	reached0[98] = 1;
	T = trans[ 0][113] = settr(112,2,0,0,0,"ATOMIC", 1, 2, 0);
	T->nxt	= settr(112,2,101,0,0,"ATOMIC", 1, 4, 0);
	trans[0][101]	= settr(100,2,112,106,106,"((((!(due_welcome)&&!(due_report))&&due_ack)&&nfull(to_host)))", 1, 4, 0); /* m: 102 -> 112,0 */
	reached0[102] = 1;
	trans[0][102]	= settr(0,0,0,0,0,"due_ack = 0",0,0,0);
	T = trans[ 0][112] = settr(111,0,0,0,0,"sub-sequence", 1, 4, 0);
	T->nxt	= settr(111,0,110,0,0,"sub-sequence", 1, 4, 0);
	T = trans[0][110] = settr(109,2,0,0,0,"IF", 1, 4, 0);
	T = T->nxt	= settr(109,2,103,0,0,"IF", 1, 4, 0);
	T = T->nxt	= settr(109,2,104,0,0,"IF", 1, 4, 0);
	    T->nxt	= settr(109,2,106,0,0,"IF", 1, 4, 0);
	trans[0][103]	= settr(102,0,153,107,107,"to_host!2,m_session,m_nonce,m_next,(((m_next+(2-(m_next-m_executed)))+(16*m_state))+(128*m_opened)),m_boot", 1, 4, 0); /* m: 111 -> 153,0 */
	reached0[111] = 1;
	trans[0][111]	= settr(110,0,153,108,108,".(goto)", 1, 4, 0);
	trans[0][104]	= settr(103,0,153,109,109,"((faults>0))", 1, 4, 0); /* m: 105 -> 153,0 */
	reached0[105] = 1;
	trans[0][105]	= settr(0,0,0,0,0,"faults = (faults-1)",0,0,0);
	trans[0][106]	= settr(105,2,108,110,110,"(((faults>0)&&(len(to_host)<(3-1))))", 1, 4, 0); /* m: 107 -> 108,0 */
	reached0[107] = 1;
	trans[0][107]	= settr(0,0,0,0,0,"faults = (faults-1)",0,0,0);
	trans[0][108]	= settr(107,2,109,111,111,"to_host!2,m_session,m_nonce,m_next,(((m_next+(2-(m_next-m_executed)))+(16*m_state))+(128*m_opened)),m_boot", 1, 4, 0);
	trans[0][109]	= settr(108,0,153,112,112,"to_host!2,m_session,m_nonce,m_next,(((m_next+(2-(m_next-m_executed)))+(16*m_state))+(128*m_opened)),m_boot", 1, 4, 0); /* m: 111 -> 153,0 */
	reached0[111] = 1;
	T = trans[ 0][122] = settr(121,2,0,0,0,"ATOMIC", 1, 2, 0);
	T->nxt	= settr(121,2,114,0,0,"ATOMIC", 1, 2, 0);
	trans[0][114]	= settr(113,2,120,113,113,"((m_executed<m_next))", 1, 2, 0); /* m: 115 -> 120,0 */
	reached0[115] = 1;
	trans[0][115]	= settr(0,0,0,0,0,"m_executed = (m_executed+1)",0,0,0);
	trans[0][116]	= settr(0,0,0,0,0,"assert(((m_next-m_executed)<2))",0,0,0);
	T = trans[0][120] = settr(119,2,0,0,0,"IF", 1, 2, 0);
	T = T->nxt	= settr(119,2,117,0,0,"IF", 1, 2, 0);
	    T->nxt	= settr(119,2,119,0,0,"IF", 1, 2, 0);
	trans[0][117]	= settr(116,0,153,114,114,"((m_session!=0))", 1, 2, 0); /* m: 118 -> 153,0 */
	reached0[118] = 1;
	trans[0][118]	= settr(0,0,0,0,0,"due_ack = 1",0,0,0);
	trans[0][121]	= settr(120,0,153,115,115,".(goto)", 1, 2, 0);
	trans[0][119]	= settr(118,2,121,2,0,"else", 1, 2, 0);
	T = trans[ 0][131] = settr(130,2,0,0,0,"ATOMIC", 1, 2, 0);
	T->nxt	= settr(130,2,123,0,0,"ATOMIC", 1, 2, 0);
	trans[0][123]	= settr(122,2,129,116,116,"((((m_state==1)&&m_ended)&&(m_executed==m_next)))", 1, 2, 0); /* m: 124 -> 129,0 */
	reached0[124] = 1;
	trans[0][124]	= settr(0,0,0,0,0,"assert((m_executed==2))",0,0,0);
	trans[0][125]	= settr(0,0,0,0,0,"m_state = 2",0,0,0);
	T = trans[0][129] = settr(128,2,0,0,0,"IF", 1, 2, 0);
	T = T->nxt	= settr(128,2,126,0,0,"IF", 1, 2, 0);
	    T->nxt	= settr(128,2,128,0,0,"IF", 1, 2, 0);
	trans[0][126]	= settr(125,0,153,117,117,"((m_session!=0))", 1, 2, 0); /* m: 127 -> 153,0 */
	reached0[127] = 1;
	trans[0][127]	= settr(0,0,0,0,0,"due_report = 1",0,0,0);
	trans[0][130]	= settr(129,0,153,118,118,".(goto)", 1, 2, 0);
	trans[0][128]	= settr(127,2,130,2,0,"else", 1, 2, 0);
	T = trans[ 0][152] = settr(151,2,0,0,0,"ATOMIC", 1, 2, 0);
	T->nxt	= settr(151,2,132,0,0,"ATOMIC", 1, 2, 0);
	trans[0][132]	= settr(131,2,137,119,119,"((reboots>0))", 1, 2, 0); /* m: 133 -> 137,0 */
	reached0[133] = 1;
	trans[0][133]	= settr(0,0,0,0,0,"reboots = (reboots-1)",0,0,0);
	T = trans[0][137] = settr(136,2,0,0,0,"IF", 1, 2, 0);
	T = T->nxt	= settr(136,2,134,0,0,"IF", 1, 2, 0);
	    T->nxt	= settr(136,2,136,0,0,"IF", 1, 2, 0);
	trans[0][134]	= settr(133,0,153,120,120,"((in_job&&h_opened))", 1, 2, 0); /* m: 135 -> 153,0 */
	reached0[135] = 1;
	trans[0][135]	= settr(0,0,0,0,0,"distrusted = 1",0,0,0);
	trans[0][138]	= settr(137,2,139,1,0,".(goto)", 1, 2, 0); /* m: 139 -> 0,153 */
	reached0[139] = 1;
	trans[0][136]	= settr(135,2,139,2,0,"else", 1, 2, 0);
	trans[0][139]	= settr(138,0,153,121,121,"m_boot = (m_boot+1)", 1, 2, 0); /* m: 140 -> 0,153 */
	reached0[140] = 1;
	trans[0][140]	= settr(0,0,0,0,0,"m_state = 0",0,0,0);
	trans[0][141]	= settr(0,0,0,0,0,"m_session = 0",0,0,0);
	trans[0][142]	= settr(0,0,0,0,0,"m_sessions = m_boot",0,0,0);
	trans[0][143]	= settr(0,0,0,0,0,"m_nonce = 0",0,0,0);
	trans[0][144]	= settr(0,0,0,0,0,"m_next = 0",0,0,0);
	trans[0][145]	= settr(0,0,0,0,0,"m_executed = 0",0,0,0);
	trans[0][146]	= settr(0,0,0,0,0,"m_opened = 0",0,0,0);
	trans[0][147]	= settr(0,0,0,0,0,"m_ended = 0",0,0,0);
	trans[0][148]	= settr(0,0,0,0,0,"in_job = 0",0,0,0);
	trans[0][149]	= settr(0,0,0,0,0,"due_welcome = 0",0,0,0);
	trans[0][150]	= settr(0,0,0,0,0,"due_ack = 0",0,0,0);
	trans[0][151]	= settr(0,0,0,0,0,"due_report = 0",0,0,0);
	trans[0][155]	= settr(154,0,156,1,0,"break", 0, 2, 0);
	trans[0][156]	= settr(155,0,0,122,122,"-end-", 0, 3500, 0);
	/* np_ demon: */
	trans[_NP_] = (Trans **) emalloc(3*sizeof(Trans *));
	T = trans[_NP_][0] = settr(9997,0,1,_T5,0,"(np_)", 1,2,0);
	    T->nxt	  = settr(9998,0,0,_T2,0,"(1)",   0,2,0);
	T = trans[_NP_][1] = settr(9999,0,1,_T5,0,"(np_)", 1,2,0);
}

Trans *
settr(	int t_id, int a, int b, int c, int d,
	char *t, int g, int tpe0, int tpe1)
{	Trans *tmp = (Trans *) emalloc(sizeof(Trans));

	tmp->atom  = a&(6|32);	/* only (2|8|32) have meaning */
	if (!g) tmp->atom |= 8;	/* no global references */
	tmp->st    = b;
	tmp->tpe[0] = tpe0;
	tmp->tpe[1] = tpe1;
	tmp->tp    = t;
	tmp->t_id  = t_id;
	tmp->forw  = c;
	tmp->back  = d;
	return tmp;
}

Trans *
cpytr(Trans *a)
{	Trans *tmp = (Trans *) emalloc(sizeof(Trans));

	int i;
	tmp->atom  = a->atom;
	tmp->st    = a->st;
#ifdef HAS_UNLESS
	tmp->e_trans = a->e_trans;
	for (i = 0; i < HAS_UNLESS; i++)
		tmp->escp[i] = a->escp[i];
#endif
	tmp->tpe[0] = a->tpe[0];
	tmp->tpe[1] = a->tpe[1];
	for (i = 0; i < 6; i++)
	{	tmp->qu[i] = a->qu[i];
		tmp->ty[i] = a->ty[i];
	}
	tmp->tp    = (char *) emalloc(strlen(a->tp)+1);
	strcpy(tmp->tp, a->tp);
	tmp->t_id  = a->t_id;
	tmp->forw  = a->forw;
	tmp->back  = a->back;
	return tmp;
}

#ifndef NOREDUCE
int
srinc_set(int n)
{	if (n <= 2) return LOCAL;
	if (n <= 2+  DELTA) return Q_FULL_F; /* 's' or nfull  */
	if (n <= 2+2*DELTA) return Q_EMPT_F; /* 'r' or nempty */
	if (n <= 2+3*DELTA) return Q_EMPT_T; /* empty */
	if (n <= 2+4*DELTA) return Q_FULL_T; /* full  */
	if (n ==   5*DELTA) return GLOBAL;
	if (n ==   6*DELTA) return TIMEOUT_F;
	if (n ==   7*DELTA) return ALPHA_F;
	Uerror("cannot happen srinc_class");
	return BAD;
}
int
srunc(int n, int m)
{	switch(m) {
	case Q_FULL_F: return n-2;
	case Q_EMPT_F: return n-2-DELTA;
	case Q_EMPT_T: return n-2-2*DELTA;
	case Q_FULL_T: return n-2-3*DELTA;
	case ALPHA_F:
	case TIMEOUT_F: return 257; /* non-zero, and > MAXQ */
	}
	Uerror("cannot happen srunc");
	return 0;
}
#endif
int cnt;
#ifdef HAS_UNLESS
int
isthere(Trans *a, int b)
{	Trans *t;
	for (t = a; t; t = t->nxt)
		if (t->t_id == b)
			return 1;
	return 0;
}
#endif
#ifndef NOREDUCE
int
mark_safety(Trans *t) /* for conditional safety */
{	int g = 0, i, j, k;

	if (!t) return 0;
	if (t->qu[0])
		return (t->qu[1])?2:1;	/* marked */

	for (i = 0; i < 2; i++)
	{	j = srinc_set(t->tpe[i]);
		if (j >= GLOBAL && j != ALPHA_F)
			return -1;
		if (j != LOCAL)
		{	k = srunc(t->tpe[i], j);
			if (g == 0
			||  t->qu[0] != k
			||  t->ty[0] != j)
			{	t->qu[g] = k;
				t->ty[g] = j;
				g++;
	}	}	}
	return g;
}
#endif
void
retrans(int n, int m, int is, short srcln[], uchar reach[], uchar lpstate[])
	/* process n, with m states, is=initial state */
{	Trans *T0, *T1, *T2, *T3;
	Trans *T4, *T5; /* t_reverse or has_unless */
	int i;
#if defined(HAS_UNLESS) || !defined(NOREDUCE)
	int k;
#endif
#ifndef NOREDUCE
	int g, h, j, aa;
#endif
#ifdef HAS_UNLESS
	int p;
#endif
	if (state_tables >= 4)
	{	printf("STEP 1 %s\n", 
			procname[n]);
		for (i = 1; i < m; i++)
		for (T0 = trans[n][i]; T0; T0 = T0->nxt)
			crack(n, i, T0, srcln);
		return;
	}
	do {
		for (i = 1, cnt = 0; i < m; i++)
		{	T2 = trans[n][i];
			T1 = T2?T2->nxt:(Trans *)0;
/* prescan: */		for (T0 = T1; T0; T0 = T0->nxt)
/* choice in choice */	{	if (T0->st && trans[n][T0->st]
				&&  trans[n][T0->st]->nxt)
					break;
			}
#if 0
		if (T0)
		printf("\tstate %d / %d: choice in choice\n",
		i, T0->st);
#endif
			if (T0)
			for (T0 = T1; T0; T0 = T0->nxt)
			{	T3 = trans[n][T0->st];
				if (!T3->nxt)
				{	T2->nxt = cpytr(T0);
					T2 = T2->nxt;
					imed(T2, T0->st, n, i);
					continue;
				}
				do {	T3 = T3->nxt;
					T2->nxt = cpytr(T3);
					T2 = T2->nxt;
					imed(T2, T0->st, n, i);
				} while (T3->nxt);
				cnt++;
			}
		}
	} while (cnt);
	if (state_tables >= 3)
	{	printf("STEP 2 %s\n", 
			procname[n]);
		for (i = 1; i < m; i++)
		for (T0 = trans[n][i]; T0; T0 = T0->nxt)
			crack(n, i, T0, srcln);
		return;
	}
	for (i = 1; i < m; i++)
	{	if (trans[n][i] && trans[n][i]->nxt) /* optimize */
		{	T1 = trans[n][i]->nxt;
#if 0
			printf("\t\tpull %d (%d) to %d\n",
			T1->st, T1->forw, i);
#endif
			srcln[i] = srcln[T1->st];	/* Oyvind Teig, 5.2.0 */

			if (!trans[n][T1->st]) continue;
			T0 = cpytr(trans[n][T1->st]);
			trans[n][i] = T0;
			reach[T1->st] = 1;
			imed(T0, T1->st, n, i);
			for (T1 = T1->nxt; T1; T1 = T1->nxt)
			{
#if 0
			printf("\t\tpull %d (%d) to %d\n",
				T1->st, T1->forw, i);
#endif
		/*		srcln[i] = srcln[T1->st];  gh: not useful */
				if (!trans[n][T1->st]) continue;
				T0->nxt = cpytr(trans[n][T1->st]);
				T0 = T0->nxt;
				reach[T1->st] = 1;
				imed(T0, T1->st, n, i);
	}	}	}
	if (state_tables >= 2)
	{	printf("STEP 3 %s\n", 
			procname[n]);
		for (i = 1; i < m; i++)
		for (T0 = trans[n][i]; T0; T0 = T0->nxt)
			crack(n, i, T0, srcln);
		return;
	}
#ifdef HAS_UNLESS
	for (i = 1; i < m; i++)
	{	if (!trans[n][i]) continue;
		/* check for each state i if an
		 * escape to some state p is defined
		 * if so, copy and mark p's transitions
		 * and prepend them to the transition-
		 * list of state i
		 */
	 if (!like_java) /* the default */
	 {	for (T0 = trans[n][i]; T0; T0 = T0->nxt)
		for (k = HAS_UNLESS-1; k >= 0; k--)
		{	if (p = T0->escp[k])
			for (T1 = trans[n][p]; T1; T1 = T1->nxt)
			{	if (isthere(trans[n][i], T1->t_id))
					continue;
				T2 = cpytr(T1);
				T2->e_trans = p;
				T2->nxt = trans[n][i];
				trans[n][i] = T2;
		}	}
	 } else /* outermost unless checked first */
	 {	T4 = T3 = (Trans *) 0;
		for (T0 = trans[n][i]; T0; T0 = T0->nxt)
		for (k = HAS_UNLESS-1; k >= 0; k--)
		{	if (p = T0->escp[k])
			for (T1 = trans[n][p]; T1; T1 = T1->nxt)
			{	if (isthere(trans[n][i], T1->t_id))
					continue;
				T2 = cpytr(T1);
				T2->nxt = (Trans *) 0;
				T2->e_trans = p;
				if (T3)	T3->nxt = T2;
				else	T4 = T2;
				T3 = T2;
		}	}
		if (T4)
		{	T3->nxt = trans[n][i];
			trans[n][i] = T4;
		}
	 }
	}
#endif
#ifndef NOREDUCE
	for (i = 1; i < m; i++)
	{	if (a_cycles)
		{ /* moves through these states are visible */
	#if PROG_LAB>0 && defined(HAS_NP)
			if (progstate[n][i])
				goto degrade;
			for (T1 = trans[n][i]; T1; T1 = T1->nxt)
				if (progstate[n][T1->st])
					goto degrade;
	#endif
			if (accpstate[n][i] || visstate[n][i])
				goto degrade;
			for (T1 = trans[n][i]; T1; T1 = T1->nxt)
				if (accpstate[n][T1->st])
					goto degrade;
		}
		T1 = trans[n][i];
		if (!T1) continue;
		g = mark_safety(T1);	/* V3.3.1 */
		if (g < 0) goto degrade; /* global */
		/* check if mixing of guards preserves reduction */
		if (T1->nxt)
		{	k = 0;
			for (T0 = T1; T0; T0 = T0->nxt)
			{	if (!(T0->atom&8))
					goto degrade;
				for (aa = 0; aa < 2; aa++)
				{	j = srinc_set(T0->tpe[aa]);
					if (j >= GLOBAL && j != ALPHA_F)
						goto degrade;
					if (T0->tpe[aa]
					&&  T0->tpe[aa]
					!=  T1->tpe[0])
						k = 1;
			}	}
			/* g = 0;	V3.3.1 */
			if (k)	/* non-uniform selection */
			for (T0 = T1; T0; T0 = T0->nxt)
			for (aa = 0; aa < 2; aa++)
			{	j = srinc_set(T0->tpe[aa]);
				if (j != LOCAL)
				{	k = srunc(T0->tpe[aa], j);
					for (h = 0; h < 6; h++)
						if (T1->qu[h] == k
						&&  T1->ty[h] == j)
							break;
					if (h >= 6)
					{	T1->qu[g%6] = k;
						T1->ty[g%6] = j;
						g++;
			}	}	}
			if (g > 6)
			{	T1->qu[0] = 0;	/* turn it off */
				printf("pan: warning, line %d, ",
					srcln[i]);
			 	printf("too many stmnt types (%d)",
					g);
			  	printf(" in selection\n");
			  goto degrade;
			}
		}
		/* mark all options global if >=1 is global */
		for (T1 = trans[n][i]; T1; T1 = T1->nxt)
			if (!(T1->atom&8)) break;
		if (T1)
degrade:	for (T1 = trans[n][i]; T1; T1 = T1->nxt)
			T1->atom &= ~8;	/* mark as unsafe */
		/* can only mix 'r's or 's's if on same chan */
		/* and not mixed with other local operations */
		T1 = trans[n][i];
		if (!T1 || T1->qu[0]) continue;
		j = T1->tpe[0];
		if (T1->nxt && T1->atom&8)
		{ if (j == 5*DELTA)
		  {	printf("warning: line %d ", srcln[i]);
			printf("mixed condition ");
			printf("(defeats reduction)\n");
			goto degrade;
		  }
		  for (T0 = T1; T0; T0 = T0->nxt)
		  for (aa = 0; aa < 2; aa++)
		  if  (T0->tpe[aa] && T0->tpe[aa] != j)
		  {	printf("warning: line %d ", srcln[i]);
			printf("[%d-%d] mixed %stion ",
				T0->tpe[aa], j, 
				(j==5*DELTA)?"condi":"selec");
			printf("(defeats reduction)\n");
			printf("	'%s' <-> '%s'\n",
				T1->tp, T0->tp);
			goto degrade;
		} }
	}
#endif
	for (i = 1; i < m; i++)
	{	T2 = trans[n][i];
		if (!T2
		||  T2->nxt
		||  strncmp(T2->tp, ".(goto)", 7)
		||  !stopstate[n][i])
			continue;
		stopstate[n][T2->st] = 1;
	}
	if (state_tables && !verbose)
	{	if (dodot)
		{	char buf[256], *q = buf, *p = procname[n];
			while (*p != '\0')
			{	if (*p != ':')
				{	*q++ = *p;
				}
				p++;
			}
			*q = '\0';
			printf("digraph ");
			switch (Btypes[n]) {
			case I_PROC:  printf("init {\n"); break;
			case N_CLAIM: printf("claim_%s {\n", buf); break;
			case E_TRACE: printf("notrace {\n"); break;
			case N_TRACE: printf("trace {\n"); break;
			default:      printf("p_%s {\n", buf); break;
			}
			printf("size=\"8,10\";\n");
			printf("  GT [shape=box,style=dotted,label=\"%s\"];\n", buf);
			printf("  GT -> S%d;\n", is);
		} else
		{	switch (Btypes[n]) {
			case I_PROC:  printf("init\n"); break;
			case N_CLAIM: printf("claim %s\n", procname[n]); break;
			case E_TRACE: printf("notrace assertion\n"); break;
			case N_TRACE: printf("trace assertion\n"); break;
			default:      printf("proctype %s\n", procname[n]); break;
		}	}
		for (i = 1; i < m; i++)
		{	reach[i] = 1;
		}
		tagtable(n, m, is, srcln, reach);
		if (dodot) printf("}\n");
	} else
	for (i = 1; i < m; i++)
	{	int nrelse;
		if (Btypes[n] != N_CLAIM)
		{	for (T0 = trans[n][i]; T0; T0 = T0->nxt)
			{	if (T0->st == i
				&& strcmp(T0->tp, "(1)") == 0)
				{	printf("error: proctype '%s' ",
						procname[n]);
		  			printf("line %d, state %d: has un",
						srcln[i], i);
					printf("conditional self-loop\n");
					pan_exit(1);
		}	}	}
		nrelse = 0;
		for (T0 = trans[n][i]; T0; T0 = T0->nxt)
		{	if (strcmp(T0->tp, "else") == 0)
				nrelse++;
		}
		if (nrelse > 1)
		{	printf("error: proctype '%s' state",
				procname[n]);
		  	printf(" %d, inherits %d", i, nrelse);
		  	printf(" 'else' stmnts\n");
			pan_exit(1);
	}	}
#if !defined(LOOPSTATE) && !defined(BFS_PAR)
	if (state_tables)
#endif
	do_dfs(n, m, is, srcln, reach, lpstate);

	if (!t_reverse)
	{	return;
	}
	/* process n, with m states, is=initial state -- reverse list */
	if (!state_tables && Btypes[n] != N_CLAIM)
	{	for (i = 1; i < m; i++)
		{	Trans *Tx = (Trans *) 0; /* list of escapes */
			Trans *Ty = (Trans *) 0; /* its tail element */
			T1 = (Trans *) 0; /* reversed list */
			T2 = (Trans *) 0; /* its tail */
			T3 = (Trans *) 0; /* remembers possible 'else' */

			/* find unless-escapes, they should go first */
			T4 = T5 = T0 = trans[n][i];
	#ifdef HAS_UNLESS
			while (T4 && T4->e_trans) /* escapes are first in orig list */
			{	T5 = T4;	  /* remember predecessor */
				T4 = T4->nxt;
			}
	#endif
			/* T4 points to first non-escape, T5 to its parent, T0 to original list */
			if (T4 != T0)		 /* there was at least one escape */
			{	T3 = T5->nxt;		 /* start of non-escapes */
				T5->nxt = (Trans *) 0;	 /* separate */
				Tx = T0;		 /* start of the escapes */
				Ty = T5;		 /* its tail */
				T0 = T3;		 /* the rest, to be reversed */
			}
			/* T0 points to first non-escape, Tx to the list of escapes, Ty to its tail */

			/* first tail-add non-escape transitions, reversed */
			T3 = (Trans *) 0;
			for (T5 = T0; T5; T5 = T4)
			{	T4 = T5->nxt;
	#ifdef HAS_UNLESS
				if (T5->e_trans)
				{	printf("error: cannot happen!\n");
					continue;
				}
	#endif
				if (strcmp(T5->tp, "else") == 0)
				{	T3 = T5;
					T5->nxt = (Trans *) 0;
				} else
				{	T5->nxt = T1;
					if (!T1) { T2 = T5; }
					T1 = T5;
			}	}
			/* T3 points to a possible else, which is removed from the list */
			/* T1 points to the reversed list so far (without escapes) */
			/* T2 points to the tail element -- where the else should go */
			if (T2 && T3)
			{	T2->nxt = T3;	/* add else */
			} else
			{	if (T3) /* there was an else, but there's no tail */
				{	if (!T1)	/* and no reversed list */
					{	T1 = T3; /* odd, but possible */
					} else		/* even stranger */
					{	T1->nxt = T3;
			}	}	}

			/* add in the escapes, to that they appear at the front */
			if (Tx && Ty) { Ty->nxt = T1; T1 = Tx; }

			trans[n][i] = T1;
			/* reversed, with escapes first and else last */
	}	}
	if (state_tables && verbose)
	{	printf("FINAL proctype %s\n", 
			procname[n]);
		for (i = 1; i < m; i++)
		for (T0 = trans[n][i]; T0; T0 = T0->nxt)
			crack(n, i, T0, srcln);
	}
}
void
imed(Trans *T, int v, int n, int j)	/* set intermediate state */
{	progstate[n][T->st] |= progstate[n][v];
	accpstate[n][T->st] |= accpstate[n][v];
	stopstate[n][T->st] |= stopstate[n][v];
	mapstate[n][j] = T->st;
}
void
tagtable(int n, int m, int is, short srcln[], uchar reach[])
{	Trans *z;

	if (is >= m || !trans[n][is]
	||  is <= 0 || reach[is] == 0)
		return;
	reach[is] = 0;
	if (state_tables)
	for (z = trans[n][is]; z; z = z->nxt)
	{	if (dodot)
			dot_crack(n, is, z);
		else
			crack(n, is, z, srcln);
	}

	for (z = trans[n][is]; z; z = z->nxt)
	{
#ifdef HAS_UNLESS
		int i, j;
#endif
		tagtable(n, m, z->st, srcln, reach);
#ifdef HAS_UNLESS
		for (i = 0; i < HAS_UNLESS; i++)
		{	j = trans[n][is]->escp[i];
			if (!j) break;
			tagtable(n, m, j, srcln, reach);
		}
#endif
	}
}

extern Trans *t_id_lkup[];

void
dfs_table(int n, int m, int is, short srcln[], uchar reach[], uchar lpstate[])
{	Trans *z;

	if (is >= m || is <= 0 || !trans[n][is])
		return;
	if ((reach[is] & (4|8|16)) != 0)
	{	if ((reach[is] & (8|16)) == 16)	/* on stack, not yet recorded */
		{	lpstate[is] = 1;
			reach[is] |= 8; /* recorded */
			if (state_tables && verbose)
			{	printf("state %d line %d is a loopstate\n", is, srcln[is]);
		}	}
		return;
	}
	reach[is] |= (4|16);	/* visited | onstack */
	for (z = trans[n][is]; z; z = z->nxt)
	{	t_id_lkup[z->t_id] = z;
#ifdef HAS_UNLESS
		int i, j;
#endif
		dfs_table(n, m, z->st, srcln, reach, lpstate);
#ifdef HAS_UNLESS
		for (i = 0; i < HAS_UNLESS; i++)
		{	j = trans[n][is]->escp[i];
			if (!j) break;
			dfs_table(n, m, j, srcln, reach, lpstate);
		}
#endif
	}
	reach[is] &= ~16; /* no longer on stack */
}
void
do_dfs(int n, int m, int is, short srcln[], uchar reach[], uchar lpstate[])
{	int i;
	dfs_table(n, m, is, srcln, reach, lpstate);
	for (i = 0; i < m; i++)
		reach[i] &= ~(4|8|16);
}
void
crack(int n, int j, Trans *z, short srcln[])
{	int i;

	if (!z) return;
	printf("	state %3d -(tr %3d)-> state %3d  ",
		j, z->forw, z->st);
	printf("[id %3d tp %3d", z->t_id, z->tpe[0]);
	if (z->tpe[1]) printf(",%d", z->tpe[1]);
#ifdef HAS_UNLESS
	if (z->e_trans)
		printf(" org %3d", z->e_trans);
	else if (state_tables >= 2)
	for (i = 0; i < HAS_UNLESS; i++)
	{	if (!z->escp[i]) break;
		printf(" esc %d", z->escp[i]);
	}
#endif
	printf("]");
	printf(" [%s%s%s%s%s] %s:%d => ",
		z->atom&6?"A":z->atom&32?"D":"-",
		accpstate[n][j]?"a" :"-",
		stopstate[n][j]?"e" : "-",
		progstate[n][j]?"p" : "-",
		z->atom & 8 ?"L":"G",
		PanSource, srcln[j]);
	for (i = 0; z->tp[i]; i++)
		if (z->tp[i] == '\n')
			printf("\\n");
		else
			putchar(z->tp[i]);
	if (verbose && z->qu[0])
	{	printf("\t[");
		for (i = 0; i < 6; i++)
			if (z->qu[i])
				printf("(%d,%d)",
				z->qu[i], z->ty[i]);
		printf("]");
	}
	printf("\n");
	fflush(stdout);
}
/* spin -a m.pml; cc -o pan pan.c; ./pan -D | dot -Tps > foo.ps; ps2pdf foo.ps */
void
dot_crack(int n, int j, Trans *z)
{	int i;

	if (!z) return;
	printf("	S%d -> S%d  [color=black", j, z->st);

	if (z->atom&6) printf(",style=dashed");
	else if (z->atom&32) printf(",style=dotted");
	else if (z->atom&8) printf(",style=solid");
	else printf(",style=bold");

	printf(",label=\"");
	for (i = 0; z->tp[i]; i++)
	{	if (z->tp[i] == '\\'
		&&  z->tp[i+1] == 'n')
		{	i++; printf(" ");
		} else
		{	putchar(z->tp[i]);
	}	}
	printf("\"];\n");
	if (accpstate[n][j]) printf("  S%d [color=red,style=bold];\n", j);
	else if (progstate[n][j]) printf("  S%d [color=green,style=bold];\n", j);
	if (stopstate[n][j]) printf("  S%d [color=blue,style=bold,shape=box];\n", j);
}

#ifdef VAR_RANGES
#define BYTESIZE	32	/* 2^8 : 2^3 = 256:8 = 32 */

typedef struct Vr_Ptr {
	char	*nm;
	uchar	vals[BYTESIZE];
	struct Vr_Ptr *nxt;
} Vr_Ptr;
Vr_Ptr *ranges = (Vr_Ptr *) 0;

void
logval(char *s, int v)
{	Vr_Ptr *tmp;

	if (v<0 || v > 255) return;
	for (tmp = ranges; tmp; tmp = tmp->nxt)
		if (!strcmp(tmp->nm, s))
			goto found;
	tmp = (Vr_Ptr *) emalloc(sizeof(Vr_Ptr));
	tmp->nxt = ranges;
	ranges = tmp;
	tmp->nm = s;
found:
	tmp->vals[(v)/8] |= 1<<((v)%8);
}

void
dumpval(uchar X[], int range)
{	int w, x, i, j = -1;

	for (w = i = 0; w < range; w++)
	for (x = 0; x < 8; x++, i++)
	{
from:		if ((X[w] & (1<<x)))
		{	printf("%d", i);
			j = i;
			goto upto;
	}	}
	return;
	for (w = 0; w < range; w++)
	for (x = 0; x < 8; x++, i++)
	{
upto:		if (!(X[w] & (1<<x)))
		{	if (i-1 == j)
				printf(", ");
			else
				printf("-%d, ", i-1);
			goto from;
	}	}
	if (j >= 0 && j != 255)
		printf("-255");
}

void
dumpranges(void)
{	Vr_Ptr *tmp;
	printf("\nValues assigned within ");
	printf("interval [0..255]:\n");
	for (tmp = ranges; tmp; tmp = tmp->nxt)
	{	printf("\t%s\t: ", tmp->nm);
		dumpval(tmp->vals, BYTESIZE);
		printf("\n");
	}
}
#endif
