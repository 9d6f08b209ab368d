#pragma once

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace rubble {

/// The name of an element in messages: `Asset 3 "wall"`.
std::string ownerText(const char* kind, std::uint32_t id, const std::string& name);

/// The name with ASCII letters in lower case, since some file systems ignore case.
std::string caseFolded(std::string name);

/// True if an element has the name, ignoring case.
template <class Element>
bool isNameTaken(const std::vector<Element>& elements, const std::string& name) {
    return std::ranges::any_of(
        elements, [folded = caseFolded(name)](const Element& element) { return caseFolded(element.name) == folded; });
}

/// The name, or the first of "name 2", "name 3", ... that is neither taken nor reserved. `reserved` names are folded;
/// they forbid numbers only.
template <class Element>
std::string uniqueName(const std::vector<Element>& elements, const std::string& name,
                       const std::set<std::string>& reserved = {}) {
    if (!isNameTaken(elements, name)) return name;
    for (int number = 2;; ++number) {
        std::string result = name + " " + std::to_string(number);
        if (!reserved.contains(caseFolded(result)) && !isNameTaken(elements, result)) return result;
    }
}

}  // namespace rubble
