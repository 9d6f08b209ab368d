#include "core/io/ProjectFile.h"
#include "editor/panels/Inspector.h"
#include "editor/panels/ProjectTree.h"

#include <QApplication>
#include <QDir>
#include <QPalette>
#include <QStyle>
#include <QTreeView>

// Shows each dock with a project and saves pictures, for a person to look at:
//   panel_pictures <project> <folder> [light|dark]

using namespace rubble;

namespace {

QPalette darkPalette() {
    QPalette palette(QColor(0x35, 0x37, 0x3a), QColor(0x2b, 0x2d, 0x30));
    palette.setColor(QPalette::Base, QColor(0x1e, 0x1f, 0x22));
    palette.setColor(QPalette::Highlight, QColor(0x2f, 0x65, 0xca));
    palette.setColor(QPalette::PlaceholderText, QColor(0x90, 0x90, 0x90));
    return palette;
}

void save(QWidget& widget, QSize size, const QString& path) {
    widget.resize(size);
    widget.show();
    for (int k = 0; k < 5; ++k) QCoreApplication::processEvents();
    widget.grab().save(path);
}

}  // namespace

int main(int argc, char* argv[]) {
    QApplication app(argc, argv);
    QApplication::setStyle("Fusion");
    if (argc < 3) return 2;
    const QString theme = argc > 3 ? argv[3] : "light";
    QApplication::setPalette(theme == "dark" ? darkPalette() : QApplication::style()->standardPalette());
    Result<Project> project = loadProject(argv[1]);
    if (!project) return 1;
    Document document(std::move(*project));
    Selection selection;
    selection.prune(document.project());
    ProjectTree tree(document, selection);
    Inspector inspector(document, selection);
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
    return 0;
}
