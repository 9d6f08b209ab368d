#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace rubble {

/// The name with ASCII letters in lower case: names that differ in nothing else would share a folder on some systems.
std::string caseFolded(std::string name);

/// True where an element has the name, whatever the case of its letters.
template <class Element>
bool isNameTaken(const std::vector<Element>& elements, const std::string& name) {
    return std::ranges::any_of(
        elements, [folded = caseFolded(name)](const Element& element) { return caseFolded(element.name) == folded; });
}

/// The name, or the first of "name 2", "name 3", ... that is free.
template <class Element>
std::string freeName(const std::vector<Element>& elements, const std::string& name) {
    std::string result = name;
    for (int number = 2; isNameTaken(elements, result); ++number) result = name + " " + std::to_string(number);
    return result;
}

}  // namespace rubble
