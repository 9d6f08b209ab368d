#pragma once

#include <string>

namespace rubble {

/// A random Project::identity, which no other project has.
std::string newIdentity();

}  // namespace rubble
