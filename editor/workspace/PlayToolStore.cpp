#include "editor/workspace/PlayToolStore.h"

#include "core/asset/project/Ranges.h"

#include <array>

namespace rubble {

namespace {

constexpr std::array kKinds{"box", "ball", "plank"};  // as in ProjectileKind

QString keyOf(const char* name) { return QString("play/tools/") + name; }

/// A number of the tools, and its key.
struct ToolNumber {
    const char* key;
    ProjectNumber range;
    double& (*of)(PlayToolSettings&);
};

const std::array kNumbers{
    ToolNumber{"width", ProjectNumber::ProjectileSize,
               [](PlayToolSettings& t) -> double& { return t.projectile.size.x; }},
    ToolNumber{"height", ProjectNumber::ProjectileSize,
               [](PlayToolSettings& t) -> double& { return t.projectile.size.y; }},
    ToolNumber{"depth", ProjectNumber::ProjectileSize,
               [](PlayToolSettings& t) -> double& { return t.projectile.size.z; }},
    ToolNumber{"mass", ProjectNumber::Mass, [](PlayToolSettings& t) -> double& { return t.projectile.mass; }},
    ToolNumber{"speed", ProjectNumber::ProjectileSpeed,
               [](PlayToolSettings& t) -> double& { return t.projectile.speed; }},
    ToolNumber{"hammerImpulse", ProjectNumber::HammerBlow,
               [](PlayToolSettings& t) -> double& { return t.hammerImpulse; }},
    ToolNumber{"hammerRadius", ProjectNumber::HammerRadius,
               [](PlayToolSettings& t) -> double& { return t.hammerRadius; }},
    ToolNumber{"blastImpulse", ProjectNumber::ExplosionImpulse,
               [](PlayToolSettings& t) -> double& { return t.explosion.impulse; }},
    ToolNumber{"blastRadius", ProjectNumber::ExplosionRadius,
               [](PlayToolSettings& t) -> double& { return t.explosion.radius; }},
    ToolNumber{"grabForce", ProjectNumber::GrabForce, [](PlayToolSettings& t) -> double& { return t.grabForce; }}};

}  // namespace

PlayToolSettings readPlayTools(const QSettings& settings) {
    PlayToolSettings tools;
    for (const ToolNumber& number : kNumbers) {
        bool isNumber = false;
        const double value = settings.value(keyOf(number.key)).toDouble(&isNumber);
        if (isNumber && rangeOf(number.range).contains(value)) number.of(tools) = value;
    }
    const QString kind = settings.value(keyOf("projectile")).toString();
    for (std::size_t k = 0; k < kKinds.size(); ++k) {
        if (kind == kKinds[k]) tools.projectile.kind = static_cast<ProjectileKind>(k);
    }
    const PlayToolSettings defaults;
    tools.isSpeedAutomatic = settings.value(keyOf("automaticSpeed"), defaults.isSpeedAutomatic).toBool();
    tools.isHammerRadiusAutomatic =
        settings.value(keyOf("automaticHammerRadius"), defaults.isHammerRadiusAutomatic).toBool();
    return tools;
}

void writePlayTools(const PlayToolSettings& tools, QSettings& settings) {
    const auto kind = static_cast<std::size_t>(tools.projectile.kind);
    if (kind >= kKinds.size()) return;  // its size and mass are those of the asset
    PlayToolSettings written = tools;
    for (const ToolNumber& number : kNumbers) settings.setValue(keyOf(number.key), number.of(written));
    settings.setValue(keyOf("projectile"), kKinds[kind]);
    settings.setValue(keyOf("automaticSpeed"), tools.isSpeedAutomatic);
    settings.setValue(keyOf("automaticHammerRadius"), tools.isHammerRadiusAutomatic);
}

}  // namespace rubble
