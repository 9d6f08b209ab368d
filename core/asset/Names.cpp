#include "core/asset/Names.h"

namespace rubble {

std::string caseFolded(std::string name) {
    for (char& letter : name) {
        if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    }
    return name;
}

}  // namespace rubble
