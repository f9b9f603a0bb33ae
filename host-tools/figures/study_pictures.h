/* host-tools/figures/study_pictures.h -- the pictures of `loft study gb`
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_STUDY_PICTURES_H
#define LOFT_HOST_STUDY_PICTURES_H

#include "figures/chapter.h"
#include "engine/engine.h"

/* Draw into a folder, which is created if necessary, for each pentagon: NAME-movement.png,
 * NAME-weight.png, NAME-contours.png and NAME-curvature.png; prints their names. Points are in the
 * number type of `e`. Returns 0, or an exit code after printing one line. */
int study_pictures(const engine *e, const char *folder);

#endif
