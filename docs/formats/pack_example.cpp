// Reads a pack and prints what a physics engine needs: c++ -std=c++17 pack_example.cpp -o pack_example
#include "rubble_pack.hpp"

#include <iostream>

namespace {

/// Prints a body and, indented, its fragments.
void print(const rubble_pack::Pack& pack, const rubble_pack::Body& body, std::uint32_t index, int depth) {
    std::size_t vertices = 0;
    for (const rubble_pack::Hull& hull : body.hulls) vertices += hull.vertices.size();
    std::cout << std::string(2 * static_cast<std::size_t>(depth), ' ') << body.name << ": " << body.mass << " kg at ("
              << body.offset.x << ", " << body.offset.y << ", " << body.offset.z << "), hulls " << body.hulls.size()
              << ", vertices " << vertices << ", neighbours " << body.neighbours.size() << '\n';
    for (const std::uint32_t fragment : pack.fragmentsOf(index))
        print(pack, pack.fragments[fragment], fragment, depth + 1);
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 2) {
        std::cerr << "usage: pack_example pack.json\n";
        return 2;
    }
    rubble_pack::Pack pack;
    std::string fault;
    if (!rubble_pack::load(arguments[1], pack, fault)) {
        std::cerr << fault << '\n';
        return 1;
    }
    std::cout << pack.name << ", made of " << pack.material.name << ", breaks at " << pack.threshold << " N·s\n";
    print(pack, pack.whole, rubble_pack::kNone, 0);
    return 0;
}
