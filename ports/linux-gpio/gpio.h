/* ports/linux-gpio/gpio.h -- lines of a GPIO chip, for both versions of libgpiod: gpio_v1.c,
 * gpio_v2.c SPDX-License-Identifier: MIT
 *
 * Values are those of the pins, 0 low and 1 high. A function that fails sets errno.
 */
#ifndef LOFT_GPIO_H
#define LOFT_GPIO_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define GPIO_TEXT  64           /* of labels and names, with the terminating 0 */
#define GPIO_LINES 32           /* in one request */

enum gpio_bias { GPIO_BIAS_KEEP, GPIO_BIAS_UP, GPIO_BIAS_DOWN };

typedef struct gpiod_chip gpio_chip;
typedef struct gpio_request gpio_request;

/* "1.6.3" */
const char *gpio_library(void);

/* `path` is "/dev/gpiochip0"; NULL if it cannot be opened. */
gpio_chip *gpio_chip_open(const char *path);
void       gpio_chip_close(gpio_chip *chip);
bool       gpio_chip_label(gpio_chip *chip, char label[GPIO_TEXT]);
unsigned   gpio_chip_lines(gpio_chip *chip);

/* The number of the line of that name; -1 if there is none. */
int        gpio_chip_find(gpio_chip *chip, const char *name);

/* True if the line is in use; then `owner` is the consumer ("?" if the kernel does not say). */
bool       gpio_chip_owner(gpio_chip *chip, unsigned offset, char owner[GPIO_TEXT]);

/* Take `count` lines as outputs at once. Bit i of `high` is the initial value of line offset[i]. */
gpio_request *gpio_outputs(gpio_chip *chip, const unsigned offset[], unsigned count, uint32_t high);

/* Set those lines of the request that `which` names (bit i: offset[i]) to the bits of `high`, all
 * with one system call. The others stay. */
bool          gpio_set(gpio_request *r, uint32_t which, uint32_t high);

/* Take a line as an input that reports edges, debounced if gpio_debounces. */
gpio_request *gpio_input(gpio_chip *chip, unsigned offset, enum gpio_bias bias,
                         unsigned debounce_us);
bool          gpio_debounces(void);
int           gpio_fd(const gpio_request *r);       /* readable when there are edges          */
bool          gpio_forget_edges(gpio_request *r);   /* remove waiting edges, without waiting   */
int           gpio_get(gpio_request *r);            /* 0, 1, or -1 if that failed              */

void          gpio_release(gpio_request *r);

#endif
