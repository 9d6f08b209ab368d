#pragma once

#include <string>
#include <string_view>

namespace rubble {

/// Escapes text for an element or an attribute of XML; control characters become spaces.
std::string escapedXml(std::string_view text);

}  // namespace rubble
