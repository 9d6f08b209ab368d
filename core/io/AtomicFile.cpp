#include "core/io/AtomicFile.h"
