#include "core/io/project/ProjectFile.h"
#include "editor/background/MortarWatch.h"
#include "editor/panels/docks/ProjectTree.h"
#include "editor/panels/docks/StrengthPanel.h"
#include "editor/panels/inspector/Inspector.h"
#include "editor/widgets/ColourScheme.h"

#include <QApplication>
#include <QDir>
#include <QTreeView>

// Saves pictures of the docks that show a project, for inspection by a person:
//   panel_pictures <project> <folder> [light|dark]

using namespace rubble;

namespace {

void save(QWidget& widget, QSize size, const QString& path) {
    widget.resize(size);
    widget.show();
    for (int k = 0; k < 5; ++k) QCoreApplication::processEvents();
    widget.grab().save(path);
}

/// Requirements of the first asset, one of each kind.
void saveStrength(Document& document, BreakAs breakAs, const QString& path) {
    Asset asset = document.project().assets[0];
    asset.breakAs = breakAs;
    asset.requirements = {{RequirementOutcome::Survives, HitRequirement{.mass = 0.43, .speed = 20.0}},
                          {RequirementOutcome::Breaks, DropRequirement{.height = 1.0}},
                          {RequirementOutcome::Breaks, ImpulseRequirement{.impulse = 800.0}}};
    if (breakAs == BreakAs::Bonded)
        asset.requirements.push_back({RequirementOutcome::HoleAtMost, HitRequirement{.mass = 20.0, .speed = 10.0}});
    document.push({.text = "Require", .replacements = {Replacement<Asset>{asset.id, asset}}});
    Bakes bakes;
    if (const Result<Bake> made = bake(asset)) {
        bakes.set(asset.id, std::make_shared<const BakedAsset>(BakedAsset{
                                std::make_shared<const Asset>(asset), std::make_shared<const Bake>(*made), {}}));
    }
    Selection selection;
    selection.setAsset(asset.id);
    SwapAuditRunner audits(document, bakes);
    StrengthPanel panel(document, selection, bakes, audits);
    save(panel, {300, 620}, path);
}

}  // namespace

int main(int argc, char* argv[]) {
    QApplication app(argc, argv);
    if (argc < 3) return 2;
    const QString theme = argc > 3 ? argv[3] : "light";
    applyTheme(theme == "dark" ? ColourScheme::Dark : ColourScheme::Light);
    Result<Project> project = loadProject(argv[1]);
    if (!project) return 1;
    Document document(std::move(*project));
    Selection selection;
    selection.prune(document.project());
    ProjectTree tree(document, selection);
    const Bakes noBakes;
    const MortarWatch mortars(document, noBakes);
    Inspector inspector(document, selection, noBakes, mortars);
    const QString folder = QDir(argv[2]).absolutePath() + '/';
    const auto path = [&](const QString& name) { return folder + name + '-' + theme + ".png"; };
    const Project& shown = document.project();
    save(tree, {260, 420}, path("tree"));
    save(inspector, {300, 1000}, path("asset"));
    selection.setMaterial(shown.materials[0].id);
    save(inspector, {300, 320}, path("material"));
    selection.setInstances(shown, {shown.instances[0].id});
    save(inspector, {300, 480}, path("instance"));
    selection.setInstances(shown, {shown.instances[0].id, shown.instances[1].id, shown.instances[60].id});
    save(inspector, {300, 480}, path("instances"));
    selection.setSubject(Part::Scene);
    save(inspector, {300, 480}, path("scene"));
    saveStrength(document, BreakAs::Whole, path("strength"));
    saveStrength(document, BreakAs::Bonded, path("strength-bonded"));
    return 0;
}
