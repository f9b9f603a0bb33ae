/* host-tools/engine/engine_sided_patch.h -- what engine_sided.c and engine_sided_nets.c hold
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_ENGINE_SIDED_PATCH_H
#define LOFT_HOST_ENGINE_SIDED_PATCH_H

#include "polygon/basepoint.h"      /* loft_basepoint */
#include "polygon/disk.h"           /* loft_disk */
#include "polygon/gb.h"             /* loft_gb */
#include "polygon/spatch.h"         /* loft_spatch */
#include "polygon/toric.h"          /* loft_toric */
#include "polygon/zheng_ball.h"     /* loft_zheng_ball */

#include "engine/engine_harmonic.h"     /* engine_harmonic */
#include "engine/engine_sheet.h"        /* loft_sector */

/* One of the library's patches; s->kind says which. */
struct engine_sided {
    const surface *s;
    loft_vec *p;
    loft_real *w, *c;
    loft_spot v[SURFACE_SIDES_MAX];
    loft_domain domain;
    engine_harmonic *harmonic;
    loft_lattice_polygon lattice;
    loft_disk round;                    /* for sheets */
    loft_sector sector[SURFACE_SIDES_MAX];
    union {
        loft_spatch spatch;
        loft_toric toric;
        loft_basepoint basepoint;
        loft_zheng_ball zheng_ball;
        loft_gb gb;
    } as;
};

#endif
