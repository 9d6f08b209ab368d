#include "editor/workspace/PlayToolStore.h"

#include "core/asset/project/Ranges.h"
#include "editor/document/FilePath.h"
#include "editor/workspace/Workspace.h"

#include <array>

namespace rubble {

namespace {

constexpr std::array kKinds{"box", "ball", "plank"};  // as in ProjectileKind

QString groupOf(const QString& project) { return "play/tools/" + projectKey(project); }

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
    ToolNumber{"blastImpulse", ProjectNumber::BlastImpulse,
               [](PlayToolSettings& t) -> double& { return t.blast.impulse; }},
    ToolNumber{"blastRadius", ProjectNumber::BlastRadius,
               [](PlayToolSettings& t) -> double& { return t.blast.radius; }},
    ToolNumber{"grabForce", ProjectNumber::GrabForce, [](PlayToolSettings& t) -> double& { return t.grabForce; }}};

}  // namespace

PlayToolSettings readPlayTools(const QSettings& settings, const QString& project) {
    const auto keyOf = [group = groupOf(project)](const char* name) { return group + '/' + name; };
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

void writePlayTools(const PlayToolSettings& tools, const QString& project, QSettings& settings) {
    const auto keyOf = [group = groupOf(project)](const char* name) { return group + '/' + name; };
    const auto kind = static_cast<std::size_t>(tools.projectile.kind);
    if (project.isEmpty() || kind >= kKinds.size()) return;  // its size and mass are those of the asset
    PlayToolSettings written = tools;
    for (const ToolNumber& number : kNumbers) settings.setValue(keyOf(number.key), number.of(written));
    settings.setValue(keyOf("projectile"), kKinds[kind]);
    settings.setValue(keyOf("automaticSpeed"), tools.isSpeedAutomatic);
    settings.setValue(keyOf("automaticHammerRadius"), tools.isHammerRadiusAutomatic);
}

void keepPlayTools(Workspace& workspace) {
    const auto read = [&workspace] {
        const QString path = workspace.file().path();
        const QSettings settings;
        if (settings.contains(groupOf(path) + "/projectile"))
            workspace.play().setToolSettings(readPlayTools(settings, path));
    };
    QObject::connect(&workspace.file(), &DocumentFile::pathChanged, &workspace, read);
    QObject::connect(&workspace.play(), &PlayController::toolSettingsChanged, &workspace, [&workspace] {
        if (workspace.play().hasDefaultTools()) return;
        QSettings settings;
        writePlayTools(workspace.play().toolSettings(), workspace.file().path(), settings);
    });
    read();
}

}  // namespace rubble
