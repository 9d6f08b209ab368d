#pragma once

#include <string>

namespace rubble {

/// Returns a binary glTF 2.0 file of its two chunks, each filled up to a multiple of four bytes.
std::string glbContainer(std::string json, std::string binary);

}  // namespace rubble
