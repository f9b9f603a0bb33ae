/* host-tools/base/c_name.h -- a name in C for what goes to a file
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_C_NAME_H
#define LOFT_C_NAME_H

/* The file's name without folder and ending, with _ for what C does not take. */
void c_name_of(const char *file, char name[64]);

#endif
