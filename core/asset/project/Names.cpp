#include "core/asset/project/Names.h"

#include "core/base/MessageText.h"

namespace rubble {

std::string ownerText(const char* kind, std::uint32_t id, const std::string& name) {
    return std::string(kind) + " " + std::to_string(id) + (name.empty() ? "" : " " + quotedName(name));
}

std::string caseFolded(std::string name) {
    for (char& letter : name) {
        if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    }
    return name;
}

}  // namespace rubble
