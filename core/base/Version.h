#pragma once

namespace rubble {

/// The version of this program, such as "0.4.0". Results may differ between versions.
const char* programVersion();

}  // namespace rubble
