#include "core/base/Version.h"

namespace rubble {

const char* programVersion() { return RUBBLE_VERSION; }

}  // namespace rubble
