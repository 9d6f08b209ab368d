#pragma once

namespace rubble {

/// The version of the program that this is a part of: "0.4.0". Another version may come to other bits.
const char* programVersion();

}  // namespace rubble
