/* ports/linux-gpio/gpio.h -- lines of a GPIO chip, whichever libgpiod there is: gpio_v1.c or
 * gpio_v2.c
 * SPDX-License-Identifier: MIT
 *
 * Values are those of the pins, 0 low and 1 high. What fails leaves its reason in errno.
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

/* The number of the line of that name; -1: there is none. */
int        gpio_chip_find(gpio_chip *chip, const char *name);

/* Is the line in use? Then `owner` says by whom ("?" if the kernel does not). */
bool       gpio_chip_owner(gpio_chip *chip, unsigned offset, char owner[GPIO_TEXT]);

/* Take `count` lines as outputs at once; bit i of `high` is what line offset[i] begins with. */
gpio_request *gpio_outputs(gpio_chip *chip, const unsigned offset[], unsigned count, uint32_t high);

/* Those lines of the request that `which` names (bit i: offset[i]) become what `high` says, all
 * with one call of the kernel; the others stay. Cost: one system call. */
bool          gpio_set(gpio_request *r, uint32_t which, uint32_t high);

/* Take a line as an input whose edges are told, debounced if gpio_debounces. */
gpio_request *gpio_input(gpio_chip *chip, unsigned offset, enum gpio_bias bias,
                         unsigned debounce_us);
bool          gpio_debounces(void);
int           gpio_fd(const gpio_request *r);       /* readable when there are edges          */
bool          gpio_forget_edges(gpio_request *r);   /* take what is there off, without waiting */
int           gpio_get(gpio_request *r);            /* 0, 1, or -1 if that failed              */

void          gpio_release(gpio_request *r);

#endif
