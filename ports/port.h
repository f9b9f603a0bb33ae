/* ports/port.h -- what a board must give to loft. Start from template/port.c.
 * SPDX-License-Identifier: MIT
 *
 * A port is one file with these functions; there is one board per firmware, so they are found at link time.
 */
#ifndef LOFT_PORT_H
#define LOFT_PORT_H

#include <stddef.h>
#include <stdint.h>

void     loft_port_init(void);
void     loft_port_start(uint32_t slot_hz);                     /* then call loft_port_slot() at that rate  */
void     loft_port_pins(uint8_t step_bits, uint8_t dir_bits);   /* bit i = axis i; the port keeps the pulse width */
size_t   loft_port_read(uint8_t *bytes, size_t max);            /* non-blocking, gives the count            */
size_t   loft_port_write(const uint8_t *bytes, size_t count);   /* non-blocking, gives the count            */
uint32_t loft_port_lock(void);                                  /* interrupts off; gives the state before   */
void     loft_port_unlock(uint32_t state);

void     loft_port_slot(void);                                  /* CALLBACK: defined by the application     */

#endif
