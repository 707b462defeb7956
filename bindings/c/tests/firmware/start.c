// The vectors, and the unit for floating point before the C library's start. QEMU loads data where it belongs.

#include <stdint.h>

extern char __stack[];
void _start(void);

__attribute__((noreturn)) void reset(void) {
#ifdef __ARM_FP
  *(volatile uint32_t *)0xE000ED88 |= 0xF << 20;
  __asm volatile("dsb\nisb");
#endif
  _start();
  __builtin_unreachable();
}

static void fault(void) { __asm volatile("bkpt 1"); }

__attribute__((section(".vectors"), used)) static void *const vectors[] = {__stack, reset, fault, fault};
