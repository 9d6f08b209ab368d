#include "viewport/scene/play/DebrisMaterial.h"

#include <glm/common.hpp>

namespace rubble {
namespace {

constexpr double kTough = 5e6;             // Pa·√m: above, as metals are, materials tear and make hardly any dust
constexpr double kLightest = 800.0;        // kg/m³: below, as wood is, materials make no dust
constexpr double kIcy = 1500.0;            // kg/m³: below, what is transparent breaks like ice, above like glass
constexpr double kWeak = 2e5;              // Pa·√m: below, as plaster is, minerals are ground to powder
constexpr Colour kPale{0.90, 0.88, 0.85};  // most of any dust's colour
constexpr Colour kSoil{0.50, 0.46, 0.40};  // of the ground, which has no material

}  // namespace

DebrisKind debrisKindOf(const Material& material) {
    if (material.opacity < 1.0) return material.density < kIcy ? DebrisKind::Ice : DebrisKind::Glass;
    const double toughness = material.fractureToughness.value_or(0.5 * kTough);
    if (toughness > kTough) return DebrisKind::Metal;
    if (material.density < kLightest) return DebrisKind::Wood;
    return toughness < kWeak ? DebrisKind::Powder : DebrisKind::Mineral;
}

std::optional<DebrisMaterial> debrisMaterialOf(const Project& project, Id material, bool isGround) {
    if (const Material* found = findMaterial(project, material)) {
        return DebrisMaterial{debrisKindOf(*found), found->inside, found->outside};
    }
    if (isGround) return DebrisMaterial{DebrisKind::Mineral, kSoil, kSoil};
    return std::nullopt;
}

glm::vec3 paleColour(const Colour& colour, double pale) {
    return glm::vec3(
        glm::mix(Vec3(colour.red, colour.green, colour.blue), Vec3(kPale.red, kPale.green, kPale.blue), pale));
}

}  // namespace rubble
