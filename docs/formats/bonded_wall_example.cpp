// Hits a bonded wall and prints what comes off: c++ -std=c++17 bonded_wall_example.cpp -o bonded_wall_example
#include "rubble_pack.hpp"

#include <cstdio>
#include <cstdlib>

namespace {

using Fragments = std::vector<std::uint32_t>;

/// The wall of a pack in play.
struct Wall {
    rubble_pack::Pack pack;
    rubble_pack::Structure structure;
    std::vector<rubble_pack::Damage> damage;  // of each bond
    Fragments standing;                       // ascending
};

double massOf(const Wall& wall, const Fragments& fragments) {
    double mass = 0.0;
    for (const std::uint32_t fragment : fragments) mass += wall.pack.fragments[fragment].mass;
    return mass;
}

void print(const char* what, const Wall& wall, const Fragments& fragments) {
    std::printf("  %s %.1f kg:", what, massOf(wall, fragments));
    for (const std::uint32_t fragment : fragments) std::printf(" %s", wall.pack.fragments[fragment].name.c_str());
    std::printf("\n");
}

/// Prints an island that comes off: a body of an engine, or one for each fragment if it is too small.
void comeOff(const Wall& wall, const char* why, const Fragments& island) {
    if (island.size() >= wall.pack.bonding->minimumIsland) return print(why, wall, island);
    for (const std::uint32_t fragment : island) print(why, wall, {fragment});
}

/// Lets come off what no longer hangs together with what is anchored.
void split(Wall& wall, const char* why) {
    Fragments standing;
    for (const rubble_pack::Island& island : rubble_pack::islandsOf(wall.structure, wall.damage, wall.standing)) {
        if (island.isAnchored) {
            standing.insert(standing.end(), island.fragments.begin(), island.fragments.end());
        } else {
            comeOff(wall, why, island.fragments);
        }
    }
    std::sort(standing.begin(), standing.end());
    wall.standing = std::move(standing);
}

void hit(Wall& wall, double x, double y, double impulse) {
    const rubble_pack::Bonding& bonding = *wall.pack.bonding;
    const rubble_pack::Hit hit{{{x, y, 0.0}}, impulse};
    const rubble_pack::HitOutcome outcome =
        rubble_pack::applyHit(wall.structure, bonding, hit, wall.standing, wall.damage);
    std::printf("A hit of %g N·s at (%g, %g) m: %zu bonds break and %zu are damaged by %.1f N·s\n", impulse, x, y,
                outcome.broken.size(), outcome.damaged.size(), outcome.taken);
    split(wall, "comes off:");
    // An engine does this after bonding.collapseDelay. It turns up, the y axis, into the frame of the asset.
    const Fragments unsupported =
        rubble_pack::unsupported(wall.structure, wall.damage, wall.standing, bonding.span, {0.0, 1.0, 0.0});
    rubble_pack::breakOff(wall.structure, unsupported, wall.damage,
                          rubble_pack::breakingLevel(wall.structure, wall.damage, wall.standing));
    split(wall, "collapses:");
    std::printf("  stands: %zu fragments of %.1f kg\n", wall.standing.size(), massOf(wall, wall.standing));
}

}  // namespace

int main(int count, char** arguments) {
    if (count < 5 || count % 2 == 0) {
        std::fprintf(stderr, "usage: bonded_wall_example pack.json N·s x y [x y]...\n");
        return 2;
    }
    Wall wall;
    std::string fault;
    if (!rubble_pack::load(arguments[1], wall.pack, fault)) {
        std::fprintf(stderr, "%s\n", fault.c_str());
        return 1;
    }
    if (!wall.pack.bonding || wall.pack.bonding->fractures.empty()) {
        std::fprintf(stderr, "%s has no bonds.\n", wall.pack.name.c_str());
        return 1;
    }
    wall.structure = rubble_pack::structureOf(wall.pack, 0);
    wall.damage.resize(wall.structure.bonds.size());
    wall.standing = wall.structure.fragments;
    std::printf("%s: %zu fragments of %.1f kg, %zu bonds\n", wall.pack.name.c_str(), wall.standing.size(),
                massOf(wall, wall.standing), wall.structure.bonds.size());
    for (int k = 3; k + 1 < count; k += 2)
        hit(wall, std::atof(arguments[k]), std::atof(arguments[k + 1]), std::atof(arguments[2]));
    const std::string bytes = rubble_pack::damageBytes(wall.pack.bonding->bake, {wall.damage});
    std::printf("The damage of the wall takes %zu bytes.\n", bytes.size());
    return 0;
}
