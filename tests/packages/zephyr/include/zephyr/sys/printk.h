/* tests/packages/zephyr/include/zephyr/sys/printk.h -- stands for Zephyr's
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#define printk printf
