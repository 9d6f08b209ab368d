// Part of programs that draw, where LeakSanitizer watches them: libraries stay loaded until the end. What a graphics
// driver allocates once and points to from data of its own would count as leaked when the driver is unloaded, and its
// name would not be known any more.
#include <dlfcn.h>

int dlclose(void*) noexcept { return 0; }
