/* host-tools/send/grbl_words.h -- explains the numbers of grbl's errors and alarms, with remedies
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_GRBL_WORDS_H
#define LOFT_GRBL_WORDS_H

const char *grbl_error_text(int number);
const char *grbl_alarm_text(int number);

#endif
