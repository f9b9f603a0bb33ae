/* tests/support/kept_fonts.h -- leaks that are none: fontconfig keeps its tables until the program
 * ends
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TESTS_KEPT_FONTS_H
#define LOFT_TESTS_KEPT_FONTS_H

const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void) { return "leak:libfontconfig"; }
const char *__lsan_default_options(void);
const char *__lsan_default_options(void) { return "print_suppressions=0"; }

#endif
